/* plane.h - points with small integer coordinates, and their exact signs.
 *
 * Checkers draw their points from the grid -4096 .. 4096. There 64-bit integers
 * compute every determinant of the notes as printed, without rounding: so a checker
 * needs nothing of section 3.4, and gives nothing of it away.
 */
#ifndef TOOLS_CHECKS_PLANE_H
#define TOOLS_CHECKS_PLANE_H

#include <stdbool.h>
#include <stdint.h>

enum { PLANE_REACH = 4096 }; /* no coordinate is larger */

typedef struct site {
    int32_t x, y;
} site;

/* Do two sites coincide? */
bool plane_same(site p, site q);

/* +1: c lies left of the line from a to b; -1: right; 0: on it. */
int plane_orient(site a, site b, site c);

/* For counterclockwise a, b, c: +1 when d lies strictly inside their circle, 0 on
 * it, -1 outside. For clockwise ones the signs are exchanged. */
int plane_incircle(site a, site b, site c, site d);

/* The square of the distance. */
int64_t plane_length2(site p, site q);

/* -1: a line that moves in direction d meets p before q; +1: after; 0: they
 * coincide. Points met together come in their order from right to left of d. */
int plane_along(site d, site p, site q);

/* The sign of (p-r).(q-r): -1 inside the circle with diameter pq, 0 on it. */
int plane_dot(site p, site r, site q);

#endif
