/* fast_questions.c - the bounds of a part, and what to do below them. There a question
 * is tried again, from cheap to certain:
 *
 *   Step 1  whole multiples of a unit, so few that no product was rounded (fast.P3):
 *           then the sign is right, and 0 is 0. So grids are no trouble.
 *   Step 2  the bound for these sites alone, not for the part
 *   Step 3  twice as many bits, and the bound for those (fast.P8)
 *   Step 4  exact.c of 3.4
 */
#include "chapters/3.7_divide_and_conquer/fast_questions.h"

#include "lib/expansion.h"

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

void
fast_bounds(fast_run *run, double width, double height, double unit)
{
    double most = 0x1.01p0 * (width * width + height * height); /* squared length */
    run->sure_turn = 0x1p-51 * most + DBL_MIN;
    /* In this order it is infinite if a product of fast_is_inside is. */
    run->sure_circle = 0x1.5p-49 * (most * most) + 0x1p-998 * (1 + most);
    run->whole_turn = 0x1p53 * unit * unit;
    run->whole_circle = 0x1p26 * unit * unit;
    run->twice_whole_circle = 0x1p50 * unit * unit;
}

/* ---- Step 3: a number is a sum high + low, of which low is the smaller part. ---- */

static exact_pair
plus(exact_pair a, exact_pair b)
{
    exact_pair sum = two_sum(a.high, b.high);
    sum.low += a.low + b.low;
    return sum;
}

static exact_pair
minus(exact_pair a, exact_pair b)
{
    return plus(a, (exact_pair){-b.high, -b.low});
}

static exact_pair
times(exact_pair a, exact_pair b)
{
    exact_pair product = two_product(a.high, b.high);
    product.low += a.high * b.low + a.low * b.high;
    return product;
}

/* A power of two that brings numbers up to `most` below 1, and as near as one can. */
static double
scale_for(double most)
{
    int exponent = 0;
    frexp(most, &exponent);
    return ldexp(1, exponent < -1000 ? 1000 : -exponent);
}

static exact_pair
scaled(exact_pair a, double scale)
{
    return (exact_pair){a.high * scale, a.low * scale};
}

/* fast_look with twice as many bits, each coordinate scaled by a power of two. All dot
 * products are scaled alike, and all cross products. */
typedef struct exact_view {
    exact_pair dot, turn;
} exact_view;

static exact_view
look(point2 eye, point2 a, point2 b, double x_scale, double y_scale)
{
    exact_pair ax = scaled(two_diff(a.x, eye.x), x_scale);
    exact_pair bx = scaled(two_diff(b.x, eye.x), x_scale);
    exact_pair ay = scaled(two_diff(a.y, eye.y), y_scale);
    exact_pair by = scaled(two_diff(b.y, eye.y), y_scale);
    double scale = x_scale < y_scale ? x_scale : y_scale;
    double x = scale / x_scale, y = scale / y_scale;
    exact_pair xs = scaled(times(ax, bx), x * x), ys = scaled(times(ay, by), y * y);
    return (exact_view){plus(xs, ys), minus(times(ax, by), times(ay, bx))};
}

/* ---- The questions. ---- */

static double
larger(double a, double b)
{
    return a > b ? a : b;
}

/* The largest distance from c to a and to b. */
static double
extent(double c, double a, double b)
{
    return larger(fabs(a - c), fabs(b - c));
}

/* What fast_look adds up, in absolute values. */
static fast_view
size_of(point2 eye, point2 a, point2 b)
{
    double ax = a.x - eye.x, ay = a.y - eye.y, bx = b.x - eye.x, by = b.y - eye.y;
    return (fast_view){fabs(ax * bx) + fabs(ay * by), fabs(ax * by) + fabs(ay * bx)};
}

int
fast_near_turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r, double det)
{
    point2 a = fast_at(run, p), b = fast_at(run, q), c = fast_at(run, r);
    double x = extent(c.x, a.x, b.x), y = extent(c.y, a.y, b.y);
    if (x == 0 || y == 0 || 4 * x * y < run->whole_turn) // Step 1
        return (det > 0) - (det < 0);

    double size = x * y; /* overflows if a product of the determinant does */
    if (fabs(det) > 0x1p-50 * size + DBL_MIN) // Step 2
        return det > 0 ? +1 : -1;

    exact_pair turn = look(c, a, b, scale_for(x), scale_for(y)).turn; // Step 3
    det = turn.high + turn.low;
    if (fabs(det) > 0x1p-101)
        return det > 0 ? +1 : -1;

    return cross_sign_exact(a, c, b, c); // Step 4
}

bool
fast_near_circle(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, uint32_t q,
                 double det)
{
    point2 a = fast_at(run, l), b = fast_at(run, r);
    point2 c = fast_at(run, p), d = fast_at(run, q);
    double x = larger(extent(c.x, a.x, b.x), extent(d.x, a.x, b.x));
    double y = larger(extent(c.y, a.y, b.y), extent(d.y, a.y, b.y));
    double most = x * x + y * y;
    if (most < run->whole_circle) // Step 1
        return det > 0;

    fast_view cs = size_of(c, a, b), ds = size_of(d, a, b); // Step 2
    double size = cs.dot * ds.turn + ds.dot * cs.turn;
    if (fabs(det) > 0x1.4p-50 * size + 0x1p-998 * (1 + most))
        return det > 0;

    double u = scale_for(x), v = scale_for(y); // Step 3
    exact_view cv = look(c, a, b, u, v), dv = look(d, a, b, u, v);
    exact_pair circle = minus(times(cv.dot, dv.turn), times(dv.dot, cv.turn));
    det = circle.high + circle.low;
    if (most < run->twice_whole_circle || fabs(det) > 0x1p-96)
        return det > 0;

    return incircle_exact(a, b, c, d) > 0; // Step 4
}
