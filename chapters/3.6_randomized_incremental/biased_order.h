/* biased_order.h - an order that is random enough, and short to walk along.
 *
 * Notes: section 3.6 (not in the notes: it is what makes a walk fast). Needs:
 * incremental.h, lib/random.h, lib/sort.h.
 */
#ifndef CHAPTERS_3_6_BIASED_ORDER_H
#define CHAPTERS_3_6_BIASED_ORDER_H

#include "chapters/3.6_randomized_incremental/incremental.h"

/* The distinct locations along a curve that stays in one place until it has been
 * everywhere there: their lowest indices are order[0 .. *locations-1].
 *
 * The points are cut in two across the longer side of their box, again and again;
 * the curve runs through one part and then through the other.
 *
 * Requires: room for n indices in order.
 * Cost: O(n log n) comparisons expected over the random cuts, whatever the points.
 * The same seed gives the same curve on every machine: no coordinate is rounded
 * but in the lengths of the two sides.
 * TRI_OUT_OF_MEMORY: *locations is 0.
 * Source: Bentley 1975, the k-d tree; Faloutsos 1988, the order of its leaves.
 */
tri_status along_curve(const point2 *points, uint32_t n, random_source *random,
                       vertex_id *order, uint32_t *locations);

/* The distinct locations in rounds: each is in the last round with probability 1/2,
 * else in the one before with probability 1/2, and so on, and each round follows the
 * curve. Their lowest indices are order[0 .. *locations-1].
 *
 * Requires: room for n indices in order. Cost: as above.
 * TRI_OUT_OF_MEMORY: *locations is 0.
 * Source: Amenta, Choi and Rote 2003.
 */
tri_status biased_order(const point2 *points, uint32_t n, random_source *random,
                        vertex_id *order, uint32_t *locations);

/* The Delaunay triangulation of the points, inserted in a biased order named by
 * options->seed, each found by a walk from the one before.
 *
 * Statuses and conventions: lib/options.h; options->order and ->locator are not used.
 * Cost: expected O(n log n) flips and structure. The walks have no bound better than
 * O(n) each; on every distribution of `tri generate` they visit a few triangles.
 */
tri_status biased_triangulate(const point2 *points, uint32_t n,
                              const tri_options *options, mesh *out);

#endif
