/* determinants.h - the two determinants of the notes, in rounded arithmetic.
 *
 * Notes: section 3.4. Needs: lib/point.h.
 *
 * Here to be read beside the notes, and to be seen fail: no algorithm uses
 * them. Over the real numbers the signs are those of orient2d and incircle; in
 * doubles they are wrong, or 0, when the points are nearly collinear or
 * cocircular.
 */
#ifndef CHAPTERS_3_4_DETERMINANTS_H
#define CHAPTERS_3_4_DETERMINANTS_H

#include "lib/point.h"

/* Twice the signed area of the triangle a, b, c:
 *
 *     | a.x  a.y  1 |
 *     | b.x  b.y  1 |   with row 1 subtracted from the others.
 *     | c.x  c.y  1 |
 *
 * Source: notes 3.4; row 2 corrected: docs/errata.md, E27. */
double orient2d_rounded(point2 a, point2 b, point2 c);

/* The same with the row 2 that is printed: (b.x, c.y, 1). */
double orient2d_misprinted(point2 a, point2 b, point2 c);

/* Positive when d is inside the circle of the counterclockwise a, b, c:
 *
 *     | a.x  a.y  a.x^2 + a.y^2  1 |
 *     | b.x  b.y  b.x^2 + b.y^2  1 |
 *     | c.x  c.y  c.x^2 + c.y^2  1 |
 *     | d.x  d.y  d.x^2 + d.y^2  1 |
 *
 * computed as it stands: the points are lifted first, and the lift is rounded.
 * Source: notes 3.4; rows 2 and 4 corrected: docs/errata.md, E28. */
double incircle_lifted(point2 a, point2 b, point2 c, point2 d);

/* The same number, with d moved to the origin before anything is squared. Far
 * from the origin that loses much less. */
double incircle_rounded(point2 a, point2 b, point2 c, point2 d);

#endif
