/* flip_graphs.h - the nodes of a flip graph as meshes, for the tests of section 3.5.
 *
 * Each of these fails the trial when there is no memory.
 */
#ifndef TESTS_FLIP_GRAPHS_H
#define TESTS_FLIP_GRAPHS_H

#include "chapters/3.5_edge_flips/flip_graph.h"

/* The flip graph of all n points. */
flip_graph graph_of(const point2 *points, uint32_t n);

/* A node as a mesh; one without edges if it has no triangles. */
mesh mesh_of_node(const flip_graph *g, const point2 *points, uint32_t node);

/* Which node the triangulation is. */
uint32_t node_of(const flip_graph *g, const mesh *m);

#endif
