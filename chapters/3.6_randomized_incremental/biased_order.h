/* biased_order.h - an order that is random enough, and short to walk along.
 *
 * Notes: section 3.6 (not in the notes: it is what makes a walk fast). Needs:
 * incremental.h, lib/random.h, lib/sort.h.
 */
#ifndef CHAPTERS_3_6_BIASED_ORDER_H
#define CHAPTERS_3_6_BIASED_ORDER_H

#include "chapters/3.6_randomized_incremental/incremental.h"

/* The place of a cell along a space-filling curve: of the 2^32 cells that 0 <= x, y
 * < 2^16 have, neighbours along the curve are neighbours in the plane.
 * Source: Hilbert 1891. */
uint32_t curve_place(uint32_t x, uint32_t y);

/* Puts L[0 .. count-1] into rounds of 1, 1, 2, 4, 8, ... points: which points are
 * in a round is random, and each round follows the curve.
 *
 * Cost: O(count). Uses + - * / and comparisons of coordinates, and never fails on
 * finite ones: what it rounds changes the order, and nothing else.
 * TRI_OUT_OF_MEMORY: L is in another order.
 * Source: Amenta, Choi and Rote 2003.
 */
tri_status biased_order(const point2 *points, vertex_id *L, uint32_t count,
                        random_source *random);

/* The Delaunay triangulation of the points, inserted in a biased order named by
 * options->seed, each found by a walk from the one before.
 *
 * Statuses and conventions: lib/options.h; options->order and ->locator are not used.
 * Cost: expected O(n log n) flips and structure; for evenly spread points O(n).
 */
tri_status biased_triangulate(const point2 *points, uint32_t n,
                              const tri_options *options, mesh *out);

#endif
