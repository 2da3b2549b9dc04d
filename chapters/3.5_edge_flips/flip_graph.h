/* flip_graph.h - all triangulations of a few points, and the flips among them.
 *
 * Notes: section 3.5.4. Needs: flips.h, lib/edges.h. Exercises: 3.5-d.
 *
 * In the flip graph each triangulation of the points is a node, and an edge
 * joins two nodes when one flip leads from one triangulation to the other. The
 * number of nodes grows exponentially: more than about 15 points in general
 * position have more triangulations than fit into memory.
 */
#ifndef CHAPTERS_3_5_FLIP_GRAPH_H
#define CHAPTERS_3_5_FLIP_GRAPH_H

#include "chapters/3.5_edge_flips/flips.h"
#include "lib/edges.h"

#include <stddef.h>

/* ---- From one triangulation to another. ---- */

/* Is ab locally Delaunay when vertex i is lifted by eps^(i+1) more than to the
 * paraboloid, for an infinitely small eps > 0?
 *
 *   true   incircle says so; or it is 0, and the lowest of the four indices is
 *          that of an apex
 *   false  incircle says so; or it is 0, and the lowest is an end of ab
 *
 * So if the four points lie on one circle, exactly one of the two diagonals is
 * good (page 3.5, flipgraph.P3). Requires: ab is an edge, between two points.
 * Cost: at most 1 incircle test.
 * Source: symbolic perturbation, Edelsbrunner and Mücke 1990.
 */
bool is_locally_delaunay_perturbed(const mesh *m, const point2 *points,
                                   halfedge_id ab);

/* Figure 10 with this test in line 3: from every triangulation of the points it
 * leads to one and the same Delaunay triangulation.
 *
 * Requires: every edge that two triangles share is on the stack.
 * Cost: at most C(u,2) flips. */
void lawson_flip_perturbed(edge_stack *L, const point2 *points);

/* Which flips lead from one triangulation of the points to another?
 *
 * out->ends[k] are the ends of the edge to be flipped k-th. There are at most
 * u(u-1) of them, for u locations; seldom the fewest possible.
 * Requires: *from and *to triangulate the same points.
 * Cost: that of the flips. TRI_OUT_OF_MEMORY: *out is zeroed.
 * Source: notes 3.5.4; docs/errata.md, E37 and E38.
 */
tri_status flip_path(const point2 *points, const mesh *from, const mesh *to,
                     edge_list *out);

/* ---- All triangulations. ---- */

typedef struct flip_graph {
    uint32_t points;     /* n */
    uint32_t nodes;      /* triangulations found; node 0 is a Delaunay one */
    bool *is_delaunay;   /* node -> is it a Delaunay triangulation? */
    size_t *first;       /* node -> its first entry below; nodes + 1 of them */
    uint32_t *neighbour; /* node k has the entries first[k] .. first[k+1]-1 */

    /* A triangulation is known by its edges: a set with one bit for each pair
     * of points. A hash table finds the node of a set. */
    size_t words;    /* of 64 bits, for one set */
    uint64_t *edges; /* node k -> edges[k * words ..] */
    size_t slots;    /* a power of two */
    uint32_t *slot;  /* slot -> a node, or NONE */
    uint32_t room;   /* for nodes, in these arrays */
} flip_graph;

/* All triangulations of the points, found by flips.
 *
 * Each uses every location; duplicates are left out. Collinear points have one
 * triangulation, without triangles. An observer (options->trace) sees every
 * flip of the walk from triangulation to triangulation, and out->nodes grow; it
 * can stop the run, which might not end otherwise before memory does.
 * Statuses: lib/options.h; on any but TRI_OK *out is zeroed.
 * Cost: 4 flips and the lookup of C(n,2) bits for each neighbour of each node.
 * Source: notes 3.5.4.
 */
tri_status flip_graph_build(const point2 *points, uint32_t n,
                            const tri_options *options, flip_graph *out);

/* Frees the arrays and zeroes *g; a zeroed graph is accepted. */
void flip_graph_free(flip_graph *g);

/* How many edges the flip graph has. */
static inline size_t
flip_graph_flips(const flip_graph *g)
{
    return g->first[g->nodes] / 2;
}

/* The place of the pair {a, b} among all pairs: 01, 02, 12, 03, 13, ... */
static inline size_t
pair_number(vertex_id a, vertex_id b)
{
    return a < b ? (size_t)b * (b - 1) / 2 + a : (size_t)a * (a - 1) / 2 + b;
}

/* Is ab an edge of the triangulation? Requires: a != b. */
static inline bool
flip_graph_has_edge(const flip_graph *g, uint32_t node, vertex_id a,
                    vertex_id b)
{
    size_t pair = pair_number(a, b);
    return g->edges[node * g->words + pair / 64] >> pair % 64 & 1;
}

/* The node of the triangulation *m; NONE if it is none of these points.
 * TRI_OUT_OF_MEMORY: no result. */
tri_status flip_graph_find(const flip_graph *g, const mesh *m, uint32_t *node);

/* The triangles of a node, counterclockwise, in lexicographic order of their
 * corners. Cost: O(n^3), and O(n) for each triple whose sides are edges.
 * TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status flip_graph_triangles(const flip_graph *g, const point2 *points,
                                uint32_t node, triangle_list *out);

/* How many flips is each node away from `from`?
 *
 * order[0 .. nodes-1] are the nodes, nearest first.
 * Requires: room for all nodes in both arrays.
 * Cost: O(nodes + edges of the graph). Source: breadth-first search. */
void flip_graph_distances(const flip_graph *g, uint32_t from,
                          uint32_t *distance, uint32_t *order);

/* The largest number of flips that the nearest way between two nodes can need.
 *
 * Cost: at most `nodes` searches; fewer when the graph is much wider than it is
 * deep (page 3.5, flipgraph.P6). TRI_OUT_OF_MEMORY: *diameter is 0. */
tri_status flip_graph_diameter(const flip_graph *g, uint32_t *diameter);

#endif
