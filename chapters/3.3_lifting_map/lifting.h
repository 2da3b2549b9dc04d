/* lifting.h - the lifting map, and Proposition 1: circles are planes.
 *
 * Notes: section 3.3, Figure 7, Proposition 1. Needs: 3.4 (which the notes put
 * after this section, and which only its tests are borrowed from), lib/point.h.
 * Exercise: 3.3-a.
 *
 * "Below" and "above" are along the z axis, which points up.
 */
#ifndef CHAPTERS_3_3_LIFTING_H
#define CHAPTERS_3_3_LIFTING_H

#include "chapters/3.4_primitives/predicates.h"

/* The point of the paraboloid z = x^2 + y^2 above p.
 *
 * ROUNDED: x^2 + y^2 is seldom a double. It is one when x and y are integers
 * below 2^26 in magnitude. So the result is for pictures, and for small
 * integers; algorithms ask orient3d_lifted.
 * Source: notes 3.3, the map f.
 */
point3 lift(point2 p);

/* Does the lifted d lie below the plane through the lifted a, b, c?
 *
 *   +1  below        0  in the plane        -1  above
 *
 * Requires: a, b, c are not collinear (else the plane is vertical:
 * docs/errata.md, E26). They may be in either order.
 * ROUNDED, as lift is: the answer is Proposition 1's for integers below 2^26,
 * and anything at all for others. No algorithm uses it.
 * Cost: 1 orient2d and 1 orient3d. Source: notes 3.3, Proposition 1.
 */
int below_plane_rounded(point2 a, point2 b, point2 c, point2 d);

/* Which side of the plane through the lifted a, b, c does the lifted d lie on?
 * The sign of orient3d for points that are lifted and not rounded:
 *
 *   +1  below        0  in the plane        -1  above
 *
 * for a, b, c in counterclockwise order. For clockwise order the signs are
 * exchanged, and for collinear points the plane is vertical and the signs tell
 * its two sides. Swapping two arguments flips the sign.
 *
 * Exact for every finite double, because the heights need not be computed: it
 * is the same determinant as incircle (page 3.3, prop1.P3).
 * Cost: 1 incircle test. Source: notes 3.3, Proposition 1.
 */
static inline int
orient3d_lifted(point2 a, point2 b, point2 c, point2 d)
{
    return incircle(a, b, c, d);
}

#endif
