/* euler.h - how many vertices, edges and faces: Theorem 1, and its proof executed.
 *
 * Notes: section 2.2, Theorem 1, Figure 2, equations (1) to (4). Needs:
 * plane_graph.h. Exercises: 2.2-a, 2.2-b.
 *
 * A function that allocates returns TRI_OUT_OF_MEMORY when it cannot; *out then says
 * nothing.
 */
#ifndef CHAPTERS_2_2_EULER_H
#define CHAPTERS_2_2_EULER_H

#include "chapters/2.2_eulers_formula/plane_graph.h"

/* ---- Words about graphs. ---- */

/* Does every edge have two distinct vertices, and do no two edges have the same
 * two? Cost: O(v+e). Source: notes 2.2. */
tri_status graph_is_simple(const plane_graph *g, bool *out);

/* Is there a path between every two vertices? The empty graph is connected.
 * Cost: O(v+e). Source: notes 2.2. */
tri_status graph_is_connected(const plane_graph *g, bool *out);

/* A path with the fewest edges: path[0] leaves `from`, each half-edge begins where
 * the one before it ends, and the last one enters `to`.
 *
 * *length is the number of edges: 0 when from == to, NONE when there is no path.
 * Requires: room for v half-edges. Cost: O(v+e).
 */
tri_status graph_path(const plane_graph *g, vertex_id from, vertex_id to,
                      halfedge_id *path, uint32_t *length);

/* ---- Theorem 1. ---- */

typedef struct euler_counts {
    uint32_t v, e;       /* vertices, edges */
    uint32_t f;          /* faces, the outer face among them */
    uint32_t h;          /* sides of the outer face; 0 when g->outside is NONE */
    uint32_t components; /* of which the graph consists */
} euler_counts;

/* Counts, and derives nothing: f comes from walking around all faces, the components
 * from a search, h from walking along the outer face. An edge with the outer face on
 * both of its sides counts twice for h.
 *
 * Theorem 1 says that v-e+f = 2 in a connected graph, and v-e+f = 1 + components in
 * every plane graph. In a graph that is not connected the outer face has more walks
 * than one, and h is the length of that of g->outside.
 * Cost: O(v+e). Source: notes 2.2, (1).
 */
tri_status euler_count(const plane_graph *g, euler_counts *out);

/* What the proof of Theorem 1 does with an edge. */
typedef enum edge_part {
    IN_NEITHER, /* its ends and its faces are joined already; never in the plane */
    IN_TREE,    /* belongs to T, the spanning tree of G */
    IN_COTREE   /* its dual edge belongs to the spanning tree of G* */
} edge_part;

/* The proof of Theorem 1, executed: a spanning tree T of G, then a tree of dual edges
 * in (G-T)* that reaches as many faces as can be reached.
 *
 * part[k] says where edge k went. In a connected plane graph v-1 edges are in the
 * tree, f-1 in the co-tree and none in neither; with more components, each has its
 * two trees. An order of half-edges around vertices that no drawing in the plane
 * has leaves edges over: two for each handle of the surface it belongs to.
 * Requires: room for e parts. Cost: O(v+e).
 * Source: notes 2.2, proof of Theorem 1, completed: docs/errata.md, E5.
 */
tri_status tree_and_cotree(const plane_graph *g, edge_part *part);

#endif
