/* yardstick.h - what the algorithms are measured against: sorting the same points.
 *
 * Needs: lib/point.h.
 */
#ifndef TOOLS_BENCH_YARDSTICK_H
#define TOOLS_BENCH_YARDSTICK_H

#include "lib/point.h"

#include <stddef.h>

/* Sorts point[0..n) by x, equal ones by y.
 *
 * Requires: no coordinate is NaN.
 * Cost: O(n log n) comparisons on average over the pivots, whatever the points; the
 * comparison stands in the loop, and is no call. Source: Hoare 1961; pivots and
 * short pieces after Bentley and McIlroy 1993.
 */
void yardstick_sort(point2 *point, size_t n);

#endif
