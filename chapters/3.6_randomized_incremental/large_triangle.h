/* large_triangle.h - line 1 of Figure 12 as it is printed, to see it fail.
 *
 * Notes: section 3.6, Figure 12, lines 1 and 8. Needs: incremental.h.
 */
#ifndef CHAPTERS_3_6_LARGE_TRIANGLE_H
#define CHAPTERS_3_6_LARGE_TRIANGLE_H

#include "chapters/3.6_randomized_incremental/incremental.h"

/* x, y and z around the n points: k times the larger side of their bounding box away
 * from its centre, to the lower left, to the lower right, and straight up.
 *
 * Requires: n > 0, and coordinates that are small enough for this. */
void large_triangle(const point2 *points, uint32_t n, double k, point2 xyz[3]);

/* Figure 12 with this triangle: the triangles that are left when those at x, y or z
 * have been removed. The numbers of x, y and z are n, n+1 and n+2.
 *
 * What is left need not be a triangulation, however large k is (docs/errata.md, E40).
 * Requires: as above, and k so large that xyz contains all points.
 * TRI_OUT_OF_MEMORY and others: *out is zeroed.
 */
tri_status large_triangle_triangulate(const point2 *points, uint32_t n, double k,
                                      triangle_list *out);

#endif
