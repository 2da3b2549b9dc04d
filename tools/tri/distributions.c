/* distributions.c - point sets that are the same everywhere, to the last bit.
 *
 * Only + - * / and sqrt are used, which IEEE arithmetic rounds in one way only:
 * the sin, cos and log of C libraries differ in their last bits.
 */
#include "tools/tri/tri.h"

#include <math.h>

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined __GNUC__
#pragma GCC optimize("fp-contract=off")
#endif

/* ---- Functions made of + - * /. ---- */

/* The point of the unit circle after so many turns, none or more. The nearest
 * quarter turn is taken out, which is exact; the rest is at most 1/8 of a turn
 * and small enough for a few terms of the two series. */
static point2
on_circle(double turns)
{
    double quarters = floor(4 * turns + 0.5);
    double t = 6.283185307179586476925287 * (turns - quarters / 4), t2 = t * t;
    double cosine = 1, sine = 1;
    for (int k = 20; k >= 2; k -= 2) { /* Horner: 1 - t2/2 (1 - t2/12 (... */
        cosine = 1 - t2 / (k * (k - 1)) * cosine;
        sine = 1 - t2 / (k * (k + 1)) * sine;
    }
    sine *= t;
    switch ((int)fmod(quarters, 4)) {
    case 0:
        return (point2){cosine, sine};
    case 1:
        return (point2){-sine, cosine};
    case 2:
        return (point2){-cosine, -sine};
    default:
        return (point2){sine, -cosine};
    }
}

/* The natural logarithm of x > 0: x is m 2^e with m about 1, and log m is twice
 * the artanh of z = (m-1)/(m+1), so |z| < 0.172 and the series is short. */
static double
logarithm(double x)
{
    int e;
    double m = frexp(x, &e);
    if (m < 0.7071067811865476) {
        m *= 2;
        e--;
    }
    double z = (m - 1) / (m + 1), z2 = z * z, sum = 0;
    for (int k = 25; k >= 1; k -= 2)
        sum = sum * z2 + 1.0 / k;
    return e * 0.693147180559945309417232 + 2 * z * sum;
}

/* Two independent standard normal numbers (Box and Muller 1958). */
static point2
normal_pair(random_source *source)
{
    double r = sqrt(-2 * logarithm(1 - random_unit(source)));
    point2 p = on_circle(random_unit(source));
    return (point2){r * p.x, r * p.y};
}

/* Fisher and Yates. */
void
shuffle_points(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_below(source, i);
        point2 p = points[i - 1];
        points[i - 1] = points[j];
        points[j] = p;
    }
}

/* ---- The distributions. ---- */

static void
fill_uniform(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = random_point(source);
}

static void
fill_normal(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = normal_pair(source);
}

static void
fill_clusters(point2 *points, uint32_t n, random_source *source)
{
    point2 centre[100];
    fill_uniform(centre, 100, source);
    for (uint32_t i = 0; i < n; i++) {
        point2 c = centre[random_below(source, 100)], p = normal_pair(source);
        points[i] = (point2){c.x + 1e-4 * p.x, c.y + 1e-4 * p.y};
    }
}

static void
fill_grid(point2 *points, uint32_t n, random_source *source)
{
    uint64_t side = 0;
    while (side * side < n)
        side++;
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){(double)(i % side), (double)(i / side)};
    shuffle_points(points, n, source);
}

static void
fill_circle(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = on_circle(random_unit(source));
}

static void
fill_kuzmin(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 p = on_circle(random_unit(source));
        double rest = 1 - random_unit(source);
        double r = sqrt(1 / (rest * rest) - 1);
        points[i] = (point2){r * p.x, r * p.y};
    }
}

static void
fill_near_line(point2 *points, uint32_t n, random_source *source)
{
    fill_uniform(points, n, source);
    for (uint32_t i = 0; i < n; i++)
        points[i].y *= 1e-6;
}

static void
fill_collinear(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){i, i};
    shuffle_points(points, n, source);
}

static void
fill_parabola(point2 *points, uint32_t n, random_source *source)
{
    (void)source;
    for (uint32_t i = 0; i < n; i++) {
        double x = (double)i - n / 2;
        points[i] = (point2){x, x * x};
    }
}

static void
fill_ladder(point2 *points, uint32_t n, random_source *source)
{
    (void)source;
    uint32_t bottom = n - n / 2;
    for (uint32_t i = 0; i < bottom; i++)
        points[i] = (point2){i, 0};
    for (uint32_t i = bottom; i < n; i++)
        points[i] = (point2){i - 1, 1}; /* m + (i - bottom), m = bottom - 1 */
}

static void
fill_spiral(point2 *points, uint32_t n, random_source *source)
{
    (void)source;
    for (uint32_t i = 0; i < n; i++) {
        double r = sqrt((double)i / n);
        point2 p = on_circle(10 * r);
        points[i] = (point2){r * p.x, r * p.y};
    }
}

const distribution distributions[] = {
    {"uniform", fill_uniform, "x and y uniform in [0,1)"},
    {"normal", fill_normal, "x and y independent, standard normal"},
    {"clusters", fill_clusters, "100 uniform centres, normal with sigma 1e-4"},
    {"grid", fill_grid, "the first N integer points of a square, shuffled"},
    {"circle", fill_circle, "uniform on the unit circle, rounded"},
    {"kuzmin", fill_kuzmin, "dense in the middle, far outliers"},
    {"near-line", fill_near_line, "x uniform in [0,1), y uniform in [0,1e-6)"},
    {"collinear", fill_collinear, "(i,i), shuffled"},
    {"parabola", fill_parabola, "(i,i^2), i from -N/2 on"},
    {"ladder", fill_ladder, "(i,0) and (m+i,1), i from 0 to m: N = 2m+2"},
    {"spiral", fill_spiral, "ten turns, the radius proportional to the angle"},
    {NULL, NULL, NULL},
};
