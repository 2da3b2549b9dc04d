/* predicates.h - the questions that every algorithm in these notes asks.
 *
 * Notes: section 3.4. Needs: lib/point.h. Exercises: 3.4-a, 3.4-b.
 *
 * The y axis points up and "left" means counterclockwise, as in the notes.
 * All tests are exact: the sign returned is the sign of the determinant over
 * the real numbers, for every finite double.
 *
 * Each test is tried here in rounded arithmetic. The answer stands when the
 * rounded determinant is further from zero than all roundings together can have
 * moved it; a NaN, an infinity or a zero never is, and falls through to
 * exact.c. The bounds are one 2^-53 more than the roundings that a product of
 * coordinates passes through (3, 4, 10 and 7), and a little for underflow
 * (page 3.4, P3 to P5).
 */
#ifndef CHAPTERS_3_4_PREDICATES_H
#define CHAPTERS_3_4_PREDICATES_H

#include "lib/point.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "exact signs need IEEE arithmetic: compile without -ffast-math, -Ofast"
#endif
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1 && FLT_EVAL_METHOD != 16
#error "exact signs need doubles rounded to double: add -msse2 -mfpmath=sse"
#endif

/* The counted build (build/counted/) counts questions here; the plain build
 * pays nothing. Programs that print or limit counts are linked with that build.
 * A determinant that none of signs, expansions, wide has counted was decided by
 * its filter. */
#ifdef TRI_COUNTED
typedef struct predicate_counts {
    /* Questions asked: */
    uint64_t orient2d, incircle, orient3d, compare_along, compare_distance, dot_sign;
    /* The determinants that the filter left to exact.c, by what answered: */
    uint64_t signs, expansions, wide; /* its Steps 1, 2 and 3 */
    uint64_t zeros;                   /* and how many of all these were 0 */
} predicate_counts;
extern _Thread_local predicate_counts predicate_count; /* of the thread that looks */
#define PREDICATE_COUNT(what) ((void)predicate_count.what++)
#else
#define PREDICATE_COUNT(what) ((void)0)
#endif

/* The exact answers, slow: exact.c. */
int cross_sign_exact(point2 p, point2 q, point2 r, point2 s);
int compare_distance_exact(point2 p, point2 q, point2 r, point2 s);
int incircle_exact(point2 a, point2 b, point2 c, point2 d);
int orient3d_exact(point3 a, point3 b, point3 c, point3 d);

/* The sign of the cross product (p-q) x (r-s): does turning from the vector qp
 * to the vector sr by the shorter way go left (+1), right (-1), or are they
 * parallel (0)? The one determinant behind orient2d and compare_along. */
static inline int
cross_sign(point2 p, point2 q, point2 r, point2 s)
{
    double left = (p.x - q.x) * (r.y - s.y);
    double right = (p.y - q.y) * (r.x - s.x);
    double det = left - right;
    double bound = 0x1p-51 * (fabs(left) + fabs(right)) + DBL_MIN;
    if (det > bound)
        return +1;
    if (-det > bound)
        return -1;
    return cross_sign_exact(p, q, r, s);
}

/* Which side of the line from a to b does c lie on?
 *
 *   +1  left:  a, b, c turn counterclockwise
 *   -1  right: a, b, c turn clockwise
 *    0  the three points are collinear (or two of them coincide)
 *
 * Swapping two arguments flips the sign; rotating all three keeps it.
 * Cost: 3 multiplications when the points are not nearly collinear.
 * Source: notes 3.4, first determinant (row 2 corrected: docs/errata.md, E27),
 * with row 3 subtracted from the others.
 */
static inline int
orient2d(point2 a, point2 b, point2 c)
{
    PREDICATE_COUNT(orient2d);
    return cross_sign(a, c, b, c);
}

/* Which of p and q does a line meet first that moves in direction d?
 *
 *   -1  p comes first        +1  q comes first        0  p and q coincide
 *
 * Points met at the same moment are ordered by their place on the line, so that
 * for d = (1,0) this is the lexicographic order. It is a total order.
 * Requires: d is not (0,0).
 * Cost: 3 multiplications when p and q are not nearly met together.
 * Source: notes 2.3, line 1 of Figure 3; ties: docs/errata.md, E12.
 */
static inline int
compare_along(point2 d, point2 p, point2 q)
{
    const point2 zero = {0, 0}, across = {-d.y, d.x};
    PREDICATE_COUNT(compare_along);
    int sign = cross_sign(p, q, across, zero); /* the sign of (p-q).d */
    return sign != 0 ? sign : cross_sign(d, zero, p, q);
}

/* Where does r lie with respect to the circle with diameter pq?
 *
 *   +1  outside: the angle p r q is acute
 *    0  on it: a right angle, or r is p or q
 *   -1  inside: the angle is obtuse
 *
 * The sign of the dot product (p-r).(q-r).
 * Cost: 3 multiplications when the angle is not nearly right.
 * Source: Thales; notes 3.1, the Gabriel graph.
 */
static inline int
dot_sign(point2 p, point2 r, point2 q)
{
    const point2 turned_q = {-q.y, q.x}, turned_r = {-r.y, r.x};
    PREDICATE_COUNT(dot_sign);
    return cross_sign(p, r, turned_q, turned_r);
}

/* Is the distance of p and q smaller than that of r and s?
 *
 *   -1  |pq| < |rs|        0  they are equal        +1  |pq| > |rs|
 *
 * The sign of |pq|^2 - |rs|^2. With q = s: which of p and r is nearer to q?
 * Cost: 5 multiplications when the distances are not nearly equal.
 * Source: notes 3.1, the half-plane H_pq.
 */
static inline int
compare_distance(point2 p, point2 q, point2 r, point2 s)
{
    PREDICATE_COUNT(compare_distance);
    double pqx = p.x - q.x, pqy = p.y - q.y;
    double rsx = r.x - s.x, rsy = r.y - s.y;
    double left = pqx * pqx + pqy * pqy;
    double right = rsx * rsx + rsy * rsy;
    double det = left - right;
    double bound = 0x1.4p-51 * (left + right) + DBL_MIN;
    if (det > bound)
        return +1;
    if (-det > bound)
        return -1;
    return compare_distance_exact(p, q, r, s);
}

/* Where does d lie with respect to the circle through a, b, c?
 *
 *   +1  strictly inside       0  on it       -1  strictly outside
 *
 * for a, b, c in counterclockwise order; for clockwise order the signs are
 * exchanged. For collinear a, b, c the answer is not about a circle.
 * Cost: 20 multiplications when d is not nearly on the circle.
 * Source: notes 3.4, second determinant (a fourth row is missing there, and the
 * sign is the opposite of an orientation: docs/errata.md, E28 and E29).
 */
static inline int
incircle(point2 a, point2 b, point2 c, point2 d)
{
    PREDICATE_COUNT(incircle);
    double adx = a.x - d.x, ady = a.y - d.y;
    double bdx = b.x - d.x, bdy = b.y - d.y;
    double cdx = c.x - d.x, cdy = c.y - d.y;

    double bc = bdx * cdy, cb = bdy * cdx;
    double ca = cdx * ady, ac = cdy * adx;
    double ab = adx * bdy, ba = ady * bdx;
    double alift = adx * adx + ady * ady;
    double blift = bdx * bdx + bdy * bdy;
    double clift = cdx * cdx + cdy * cdy;

    double det = alift * (bc - cb) + blift * (ca - ac) + clift * (ab - ba);
    double size = alift * (fabs(bc) + fabs(cb)) +
                  blift * (fabs(ca) + fabs(ac)) +
                  clift * (fabs(ab) + fabs(ba));
    double underflow = 0x1p-1000 * (1 + alift + blift + clift);
    double bound = 0x1.6p-50 * size + underflow;
    if (det > bound)
        return +1;
    if (-det > bound)
        return -1;
    return incircle_exact(a, b, c, d);
}

/* Which side of the plane through a, b, c does d lie on?
 *
 *   +1  below: seen from d, the points a, b, c turn clockwise
 *   -1  above: seen from d, they turn counterclockwise
 *    0  the four points lie in one plane
 *
 * where "above" is the side from which a, b, c turn counterclockwise.
 * Cost: 14 multiplications when d is not nearly in the plane.
 * Source: Shewchuk 1997; the sign is that of det(a-d, b-d, c-d).
 */
static inline int
orient3d(point3 a, point3 b, point3 c, point3 d)
{
    PREDICATE_COUNT(orient3d);
    double adx = a.x - d.x, ady = a.y - d.y, adz = a.z - d.z;
    double bdx = b.x - d.x, bdy = b.y - d.y, bdz = b.z - d.z;
    double cdx = c.x - d.x, cdy = c.y - d.y, cdz = c.z - d.z;

    double bc = bdx * cdy, cb = bdy * cdx;
    double ca = cdx * ady, ac = cdy * adx;
    double ab = adx * bdy, ba = ady * bdx;

    double det = adz * (bc - cb) + bdz * (ca - ac) + cdz * (ab - ba);
    double size = fabs(adz) * (fabs(bc) + fabs(cb)) +
                  fabs(bdz) * (fabs(ca) + fabs(ac)) +
                  fabs(cdz) * (fabs(ab) + fabs(ba));
    double underflow = 0x1p-1000 * (1 + fabs(adz) + fabs(bdz) + fabs(cdz));
    double bound = 0x1p-50 * size + underflow;
    if (det > bound)
        return +1;
    if (-det > bound)
        return -1;
    return orient3d_exact(a, b, c, d);
}

#endif
