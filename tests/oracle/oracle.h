/* oracle.h - what the predicates should answer, by big integers.
 *
 * Needs: lib/point.h for the types. Nothing else is shared with lib/ and
 * chapters/: coordinates are read by frexp, scaled to integers by their common
 * unit, and each determinant is taken of the whole matrix, by cofactors,
 * without differences. Requires everywhere: finite coordinates.
 */
#ifndef TESTS_ORACLE_ORACLE_H
#define TESTS_ORACLE_ORACLE_H

#include "lib/point.h"

/* The sign of the determinant with rows (x, y, 1): +1 when a, b, c turn left.
 */
int oracle_orient2d(point2 a, point2 b, point2 c);

/* The sign of the determinant with rows (x, y, x^2+y^2, 1): +1 when d is inside
 * the circle of the counterclockwise a, b, c. */
int oracle_incircle(point2 a, point2 b, point2 c, point2 d);

/* The sign of the determinant with rows (x, y, z, 1). */
int oracle_orient3d(point3 a, point3 b, point3 c, point3 d);

/* The sign of (p-q) x (r-s). */
int oracle_cross(point2 p, point2 q, point2 r, point2 s);

/* The sign of |pq|^2 - |rs|^2: -1 when p and q are closer than r and s. */
int oracle_compare_distance(point2 p, point2 q, point2 r, point2 s);

/* The sign of x[0] + ... + x[n-1]. Requires: finite; n < 2^60. */
int oracle_sum(const double *x, int n);

/* The sign of a * b - (x[0] + ... + x[n-1]). */
int oracle_product_minus_sum(double a, double b, const double *x, int n);

#endif
