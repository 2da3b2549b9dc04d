/* angles.h - angles of triangles, compared without a rounding.
 *
 * Requires everywhere: coordinates are whole numbers up to 1000. Of two angles below
 * a half turn the larger has the smaller cotangent, dot product over cross product,
 * and both products are whole numbers below 2^22.
 */
#ifndef TESTS_ANGLES_H
#define TESTS_ANGLES_H

#include "lib/point.h"

typedef struct angle {
    double dot, cross; /* of the two sides; cross > 0 */
} angle;

/* The angle at q in the triangle p q r. */
angle angle_at(point2 q, point2 p, point2 r);

/* -1 when s is the smaller angle, 0, +1. */
int compare_angles(angle s, angle t);

#endif
