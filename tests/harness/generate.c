/* generate.c - families of point sets: the ordinary, and the nearly degenerate.
 *
 * Only + - * / sqrt and scaling by powers of two: the points are the same on every
 * machine. About one set in ten has fewer than three points or lies on a line.
 */
#include "tests/harness/internal.h"

#include <float.h>
#include <math.h>

/* ---- Drawing numbers. ---- */

static bool
one_in(random_source *source, uint32_t n)
{
    return random_below(source, n) == 0;
}

/* An integer of -range .. range. */
static int
integer(random_source *source, int range)
{
    return (int)random_below(source, 2 * (uint32_t)range + 1) - range;
}

static point2
integer_point(random_source *source, int range)
{
    double x = integer(source, range), y = integer(source, range);
    return (point2){x, y};
}

static point2
unit_point(random_source *source)
{
    double x = random_unit(source), y = random_unit(source);
    return (point2){x, y};
}

/* A point of the unit circle, as nearly as doubles come: ((1-t^2)/(1+t^2),
 * 2t/(1+t^2)) runs over the right half for t in [-1,1]. */
static point2
circle_point(random_source *source)
{
    double t = 2 * random_unit(source) - 1;
    double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    return (point2){one_in(source, 2) ? x : -x, y};
}

/* A point of the grid of columns x rows integer points. */
static point2
grid_point(random_source *source, uint32_t columns, uint32_t rows)
{
    double x = random_below(source, columns), y = random_below(source, rows);
    return (point2){x, y};
}

/* An integer point exactly on the circle of this radius around the origin: there
 * are 12, 20, 36 and 60 for the radii 5, 25, 65 and 325. */
static point2
exact_circle_point(random_source *source, int radius)
{
    for (;;) {
        int x = integer(source, radius);
        double y = sqrt((double)(radius * radius - x * x));
        if (y == floor(y))
            return (point2){x, one_in(source, 2) ? y : -y};
    }
}

static int
exact_radius(random_source *source)
{
    static const int radius[4] = {5, 25, 65, 325};
    return radius[random_below(source, 4)];
}

/* A direction with small integer coordinates: along an axis, diagonal, or neither. */
static point2
direction(random_source *source)
{
    for (;;) {
        point2 d = integer_point(source, 3);
        if (d.x != 0 || d.y != 0)
            return d;
    }
}

void
generate_order(random_source *source, point2 *points, uint32_t n)
{
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_below(source, i);
        point2 chosen = points[j];
        points[j] = points[i - 1];
        points[i - 1] = chosen;
    }
}

uint32_t
generate_size(random_source *source, uint32_t most)
{
    if (most <= 4 || one_in(source, 16))
        return random_below(source, (most < 3 ? most : 3) + 1);
    uint32_t limit = most;
    while (limit > 8 && one_in(source, 2))
        limit /= 2;
    return 4 + random_below(source, limit - 3);
}

/* ---- The ordinary families. ---- */

static void
on_a_line(random_source *source, point2 *points, uint32_t n)
{
    point2 from = integer_point(source, 9), d = direction(source);
    for (uint32_t i = 0; i < n; i++) {
        double t = random_below(source, 2 * n);
        points[i] = (point2){from.x + t * d.x, from.y + t * d.y};
    }
}

static void
in_clusters(random_source *source, point2 *points, uint32_t n)
{
    point2 centre[4];
    for (int i = 0; i < 4; i++)
        centre[i] = unit_point(source);
    for (uint32_t i = 0; i < n; i++) {
        point2 c = centre[random_below(source, 4)], offset = unit_point(source);
        points[i] = (point2){c.x + 0x1p-10 * offset.x, c.y + 0x1p-10 * offset.y};
    }
}

/* Some points are copies of earlier ones. */
static void
with_duplicates(random_source *source, point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = i > 0 && one_in(source, 2) ? points[random_below(source, i)]
                                               : unit_point(source);
}

/* The n points (i, i*i) with the smallest |i|. */
static void
on_a_parabola(point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        double x = (double)i - (double)(n / 2);
        points[i] = (point2){x, x * x};
    }
}

void
generate_ordinary(random_source *source, point2 *points, uint32_t n)
{
    uint32_t family = random_below(source, 16);
    int side = 1 + (int)sqrt((double)n); /* of four grid points about one is met */
    int radius = exact_radius(source);
    uint32_t off_line = 1 + random_below(source, 3);

    if (family == 0)
        on_a_line(source, points, n);
    else if (family == 1)
        in_clusters(source, points, n);
    else if (family == 2)
        with_duplicates(source, points, n);
    else if (family == 3)
        on_a_parabola(points, n);
    else if (family == 4)
        on_a_line(source, points, n > off_line ? n - off_line : 0);
    for (uint32_t i = 0; i < n; i++) {
        if (family == 4 && i + off_line >= n)
            points[i] = integer_point(source, 9);
        else if (family == 5) /* two parallel lines */
            points[i] = grid_point(source, n, 2);
        else if (family == 6 || family == 7)
            points[i] = integer_point(source, side);
        else if (family == 8)
            points[i] = integer_point(source, 1 << 20);
        else if (family == 9)
            points[i] = circle_point(source);
        else if (family == 10 || family == 11)
            points[i] = exact_circle_point(source, radius);
        else if (family >= 12)
            points[i] = unit_point(source);
    }
    if (!one_in(source, 4))
        generate_order(source, points, n);
}

/* ---- The nearly degenerate: a shape, its magnitude, and a few ulps. ---- */

/* A coordinate of any sign and magnitude, mostly between 1e-300 and 1e300. */
static double
any_magnitude(random_source *source)
{
    return ldexp(2 * random_unit(source) - 1, integer(source, 1000));
}

static void
draw_shape(random_source *source, point2 *points, uint32_t n)
{
    uint32_t shape = random_below(source, 7);
    int radius = exact_radius(source), side = 1 + (int)sqrt((double)n);
    point2 from = unit_point(source), to = unit_point(source);
    for (uint32_t i = 0; i < n; i++) {
        double t = random_unit(source);
        point2 on_circle = circle_point(source);
        switch (shape) {
        case 0: /* between two points, rounded */
            points[i] = (point2){from.x + t * (to.x - from.x),
                                 from.y + t * (to.y - from.y)};
            break;
        case 1: /* the diagonal, and what lies a few ulps beside it (erratum E31) */
            points[i].x = one_in(source, 2) ? 0.5 : 12.0 * random_below(source, 3);
            points[i].y = points[i].x;
            break;
        case 2: /* a circle that is not around the origin, rounded */
            points[i] = (point2){from.x + on_circle.x, from.y + on_circle.y};
            break;
        case 3: /* integers exactly on a circle */
            points[i] = exact_circle_point(source, radius);
            break;
        case 4: /* a small grid: collinear, cocircular, repeated */
            points[i] = integer_point(source, side);
            break;
        case 5: /* a small grid where doubles are coarse */
            points[i] = grid_point(source, 4, 4);
            points[i].x += 0x1p52;
            points[i].y += 0x1p52;
            break;
        default: /* each coordinate of its own magnitude */
            points[i].x = any_magnitude(source);
            points[i].y = any_magnitude(source);
        }
    }
}

/* Scales by a power of two so that the largest coordinate is just below
 * 2^exponent; what becomes subnormal is rounded. */
static void
scale_to(point2 *points, uint32_t n, int exponent)
{
    double largest = 0;
    int now;
    for (uint32_t i = 0; i < n; i++)
        largest = fmax(largest, fmax(fabs(points[i].x), fabs(points[i].y)));
    (void)frexp(largest, &now);
    for (uint32_t i = 0; i < n; i++) {
        points[i].x = ldexp(points[i].x, exponent - now);
        points[i].y = ldexp(points[i].y, exponent - now);
    }
}

/* Up to two ulps up or down, but never to infinity. */
static double
step_ulps(random_source *source, double x)
{
    int steps = integer(source, 2);
    double toward = steps < 0 ? -DBL_MAX : DBL_MAX;
    for (int i = steps < 0 ? -steps : steps; i > 0; i--)
        x = nextafter(x, toward);
    return x;
}

void
generate_near_degenerate(random_source *source, point2 *points, uint32_t n)
{
    draw_shape(source, points, n);
    switch (random_below(source, 8)) {
    case 0: /* about the largest double, 1.8e308 */
        scale_to(points, n, 1024);
        break;
    case 1: /* subnormal: about 5e-324 and up */
        scale_to(points, n, -1074 + 3 + (int)random_below(source, 49));
        break;
    case 2: /* where products of two coordinates begin to underflow */
        scale_to(points, n, -537 + integer(source, 30));
        break;
    case 3:
        scale_to(points, n, integer(source, 1000));
        break;
    default:
        break;
    }
    if (!one_in(source, 3))
        for (uint32_t i = 0; i < n; i++) {
            points[i].x = step_ulps(source, points[i].x);
            points[i].y = step_ulps(source, points[i].y);
        }
    generate_order(source, points, n);
}
