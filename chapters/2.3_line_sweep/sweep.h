/* sweep.h - a triangulation by sweeping a line over the points.
 *
 * Notes: section 2.3, Figure 3. Needs: 3.4 (the notes use "sees" here and define
 * it there), lib/mesh.h, lib/options.h. Exercises: 2.3-a to 2.3-d.
 */
#ifndef CHAPTERS_2_3_SWEEP_H
#define CHAPTERS_2_3_SWEEP_H

#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/steps.h"

/* Some consecutive hull edges: from `first` up to and without `end`, by
 * mesh_hull_next. None at all when the two are the same: then it is a place on
 * the hull, the vertex where `end` begins. */
typedef struct hull_chain {
    halfedge_id first, end;
} hull_chain;

/* In which order does a line moving in direction d meet the points?
 *
 * order[0 .. *locations-1] are the lowest indices at each location, in the order
 * of compare_along; duplicates are left out.
 * Requires: room for n indices in order; d is not (0,0).
 * Cost: at most 2 n ceil(log2 n) comparisons.
 * TRI_OUT_OF_MEMORY: *locations is 0.
 * Source: notes 2.3, line 1 of Figure 3; merge sort.
 */
tri_status sort_along(const point2 *points, uint32_t n, point2 d, vertex_id *order,
                      uint32_t *locations);

/* The hull edges that p sees.
 *
 * Requires: p comes after every vertex of *m in the order of the sweep, and
 * `last` is the hull edge that leaves the latest of them.
 * Cost: 2 orientation tests more than there are edges in the answer.
 * Source: notes 2.3, line 4 of Figure 3; both ways from the last vertex:
 * docs/errata.md, E13.
 */
hull_chain hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last,
                             vertex_id p);

/* The first edge, from a to b. Returns the hull edge that leaves b.
 * Cost: O(1). Source: notes 2.3, line 2 of Figure 3; an edge and not a triangle:
 * docs/errata.md, E11.
 */
halfedge_id start(mesh *m, vertex_id a, vertex_id b);

/* Joins p to each hull edge of q by a triangle, and to the hull by two edges; if
 * q is empty, by a single edge. Returns the new hull edge that leaves p.
 *
 * Requires: p sees exactly the edges of q.
 * Cost: O(edges in q). Source: notes 2.3, line 5 of Figure 3.
 */
halfedge_id attach(mesh *m, hull_chain q, vertex_id p);

/* A triangulation of the points, by Figure 3, along options->direction.
 *
 * Exactly 2u-2-h triangles, for u locations, h of them on the hull boundary and
 * not all collinear. Statuses and conventions: lib/options.h.
 * Cost: O(n log n); 2(u-2) orientation tests more than triangles.
 */
tri_status sweep_triangulate(const point2 *points, uint32_t n,
                             const tri_options *options, mesh *out);

/* The convex hull: the vertices on its boundary, counterclockwise, those inside
 * hull edges included, beginning with the lowest index.
 *
 * On a path its two ends bound the segment, and the inner vertices lie on it:
 * each vertex is listed once, from the end with the lower index to the other.
 * A single location is its own hull.
 * Requires: room for m->locations indices. Returns how many there are.
 * Cost: O(n). Source: notes 2.3, last paragraph.
 */
uint32_t hull_vertices(const mesh *m, vertex_id *hull);

/* Which line of Figure 3 is run in each step. */
extern const figure_steps sweep_steps;

#endif
