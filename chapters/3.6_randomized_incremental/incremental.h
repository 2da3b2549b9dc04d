/* incremental.h - Delaunay triangulations one point at a time, in random order.
 *
 * Notes: section 3.6, Figure 12. Needs: 2.3 (distinct points), 3.4, 3.5 (the flip
 * and the stack), locator.h, lib/mesh.h, lib/random.h. Exercises: 3.6-a, 3.6-c,
 * 3.6-d.
 *
 * GHOST, the vertex at infinity, plays the notes' "sufficiently large triangle
 * xyz", which no finite triangle can play (docs/errata.md, E40). A point outside
 * the hull lies in a ghost triangle, whose edges are split and flipped like all
 * others.
 */
#ifndef CHAPTERS_3_6_INCREMENTAL_H
#define CHAPTERS_3_6_INCREMENTAL_H

#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.6_randomized_incremental/locator.h"
#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/random.h"
#include "lib/steps.h"

/* Does q lie strictly inside the circle through a, b, c? The circle through two
 * points and GHOST is their line; its inside is the outer side of the hull edge.
 *
 * Requires: abc is counterclockwise, or a ghost triangle; q is a point.
 * Cost: 1 incircle test, or 1 orientation test.
 */
bool circle_contains(const point2 *points, vertex_id a, vertex_id b, vertex_id c,
                     vertex_id q);

/* Is ab locally Delaunay (Definition 9) when GHOST counts as a vertex?
 * Cost: at most 1 test. Source: notes 3.5; Guibas, Knuth, Sharir 1992. */
bool is_locally_delaunay_at_infinity(const mesh *m, const point2 *points,
                                     halfedge_id ab);

/* Line 4 of Figure 12: joins p to the corners around its place.
 *
 *   PLACE_TRIANGLE  abc, with e from a to b, becomes abp, bcp, cap; e leads from
 *                   a to b still
 *   PLACE_EDGE      abc and bad, with e from a to b, become apc, bpd, pbc, pad; e
 *                   leads from a to p, and its old twin from b to p
 *   PLACE_BEYOND    the path along which all vertices lie gets one more edge
 *
 * Half-edges that are not named here, on the outside of these triangles, stay
 * what they are, and so does the place in the mesh of the triangles named first.
 * Requires: p has this place and is no vertex. Cost: O(1), no test.
 * Source: notes 3.6, line 4; on an edge and on a path: docs/errata.md, E42.
 */
void split(mesh *m, place at, vertex_id p);

/* Puts L[0 .. count-1] into random order: each of the count! orders is equally
 * likely, if the source's numbers are. Cost: count-1 random numbers.
 * Source: Fisher and Yates 1938; Knuth, volume 2, algorithm 3.4.2P. */
void shuffle(vertex_id *L, uint32_t count, random_source *random);

/* Figure 12 in a given order: the Delaunay triangulation of the `count` points whose
 * indices are in order[], all at different locations.
 *
 * Uses options->locator and options->trace. Statuses: lib/options.h.
 * Cost: O(count^2) at worst, with each locator. In random order at most 3 flips
 * a point are expected, and with buckets or history O(log count) tests.
 */
tri_status insert_in_order(const point2 *points, uint32_t n, const vertex_id *order,
                           uint32_t count, const tri_options *options, mesh *out);

/* The Delaunay triangulation of the points, inserted in options->order; at random,
 * named by options->seed, if that is NULL. Of points at the same location only the
 * one with the lowest index is inserted.
 *
 * Statuses and conventions: lib/options.h; TRI_BAD_OPTION also if order is not a
 * permutation of 0 .. n-1.
 * Cost: as above, and O(n log n) comparisons to find the distinct locations.
 */
tri_status incremental_triangulate(const point2 *points, uint32_t n,
                                   const tri_options *options, mesh *out);

/* Which line of Figure 12 is run in each step. */
extern const figure_steps incremental_steps;

#endif
