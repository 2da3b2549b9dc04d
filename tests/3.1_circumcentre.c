/* Section 3.1: the coordinates of a Voronoi vertex are the exact quotients,
 * rounded once to the nearest double.
 *
 * Hypotheses: the three sites are not collinear; nothing else.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "tests/harness/harness.h"
#include "tests/oracle/big.h"
#include "tests/oracle/oracle.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- The exact quotient x = N / 2O, beside a double. ---- */

static int
smaller_unit(double x, int unit)
{
    return x != 0 && big_unit(x) < unit ? big_unit(x) : unit;
}

/* (p.x^2 + p.y^2) (q.y - r.y) */
static big
lifted_difference(const big p[2], const big q[2], const big r[2])
{
    big xx = big_multiply(&p[0], &p[0]), yy = big_multiply(&p[1], &p[1]);
    big square = big_add(&xx, &yy), difference = big_subtract(&q[1], &r[1]);
    return big_multiply(&square, &difference);
}

static big
cross(const big p[2], const big q[2])
{
    big left = big_multiply(&p[0], &q[1]), right = big_multiply(&p[1], &q[0]);
    return big_subtract(&left, &right);
}

static big
sum3(big a, big b, big c)
{
    big sum = big_add(&a, &b);
    return big_add(&sum, &c);
}

/* The sign of x - (p+q)/2 for the x coordinate of the centre: that of (N -
 * (p+q) O) O, everything in a common unit. */
static int
centre_against(const point2 t[3], double p, double q)
{
    int unit = smaller_unit(p, smaller_unit(q, 1024));
    for (int i = 0; i < 3; i++)
        unit = smaller_unit(t[i].x, smaller_unit(t[i].y, unit));
    big at[3][2], bound_p = big_from_double(p, unit),
                  bound_q = big_from_double(q, unit);
    for (int i = 0; i < 3; i++) {
        at[i][0] = big_from_double(t[i].x, unit);
        at[i][1] = big_from_double(t[i].y, unit);
    }
    big N = sum3(lifted_difference(at[0], at[1], at[2]),
                 lifted_difference(at[1], at[2], at[0]),
                 lifted_difference(at[2], at[0], at[1]));
    big O = sum3(cross(at[0], at[1]), cross(at[1], at[2]), cross(at[2], at[0]));
    big sum = big_add(&bound_p, &bound_q), product = big_multiply(&sum, &O);
    return big_subtract(&N, &product).sign * O.sign;
}

/* Is the last bit of the double 0? */
static bool
is_even(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits % 2 == 0;
}

/* x is the nearest double: not beyond the middle to either neighbour, and in
 * the middle only if x is even. */
static void
check_nearest(const point2 t[3], double x)
{
    double below = nextafter(x, -INFINITY), above = nextafter(x, INFINITY);
    CLAIM("sec3.1.P13", isfinite(x), "%g", x);
    if (isfinite(below)) {
        int side = centre_against(t, below, x);
        CLAIM("sec3.1.P13", side > 0 || (side == 0 && is_even(x)),
              "%.17g is too large", x);
    }
    if (isfinite(above)) {
        int side = centre_against(t, x, above);
        CLAIM("sec3.1.P13", side < 0 || (side == 0 && is_even(x)),
              "%.17g is too small", x);
    }
}

/* Is the coordinate beyond the largest double, one way or the other? */
static bool
out_of_range(const point2 t[3])
{
    return centre_against(t, DBL_MAX, DBL_MAX) > 0 ||
           centre_against(t, -DBL_MAX, -DBL_MAX) < 0;
}

static void
centres_are_rounded_once(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i + 2 < n; i++) {
        const point2 *t = points + i;
        const point2 mirrored[3] = {
            {t[0].y, t[0].x}, {t[1].y, t[1].x}, {t[2].y, t[2].x}};
        point2 centre;
        if (oracle_orient2d(t[0], t[1], t[2]) == 0)
            continue;
        tri_status status = circumcentre(t[0], t[1], t[2], &centre);
        bool beyond = out_of_range(t) || out_of_range(mirrored);
        CLAIM("sec3.1.P13", status == (beyond ? TRI_OUT_OF_RANGE : TRI_OK),
              "%s", tri_status_text(status));
        if (status != TRI_OK) {
            CLAIM("sec3.1.P13", centre.x == 0 && centre.y == 0, "not zeroed");
            continue;
        }
        check_nearest(t, centre.x);
        check_nearest(mirrored, centre.y);
    }
}

/* The points are moved up or down by a power of two: as far as expansions go, and
 * beyond. */
static void
at_every_scale(const point2 *points, uint32_t n)
{
    point2 moved[8];
    uint32_t count = n < 8 ? n : 8;
    int exponent = (int)random_below(test_random_source(), 901) - 450;
    for (uint32_t i = 0; i < count; i++)
        moved[i] = (point2){ldexp(points[i].x, exponent), ldexp(points[i].y, exponent)};
    centres_are_rounded_once(moved, count);
}

static void
known_centres(void)
{
    static const struct {
        point2 site[3], centre;
    } known[] = {
        {{{0, 0}, {2, 0}, {0, 2}}, {1, 1}},
        {{{5, 0}, {3, 4}, {-4, 3}}, {0, 0}},
        {{{0, 0}, {1, 0}, {0, 3}}, {0.5, 1.5}},
        {{{0, 0}, {0x1p-1074, 0}, {0, 1}},
         {0, 0.5}}, /* a tie: half the least double */
        {{{0, 0}, {-0x1p-1074, 0}, {0, 1}},
         {0, 0.5}}, /* the same on the other side, and not -0 */
        {{{0, 0}, {0x1.8p-1073, 0}, {0, 1}},
         {0x1p-1073, 0.5}}, /* the same, rounded up */
        {{{0, 0}, {0x1.8p1023, 0}, {0, 0x1p1023}}, {0x1.8p1022, 0x1p1022}},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const point2 *s = known[i].site;
        point2 c;
        CLAIM("sec3.1.P13", circumcentre(s[0], s[1], s[2], &c) == TRI_OK,
              "no centre");
        CLAIM("sec3.1.P13",
              c.x == known[i].centre.x && c.y == known[i].centre.y &&
                  !signbit(c.x) == (c.x >= 0),
              "(%.17g,%.17g) for (%.17g,%.17g)", c.x, c.y, known[i].centre.x,
              known[i].centre.y);
    }
}

/* Three sites in line but for one step have their centre a long way off. */
static void
far_centres_are_refused(void)
{
    const point2 a = {-0x1p600, 0}, b = {0x1p600, 0}, c = {0, 0x1p-200};
    point2 centre = {1, 1};
    tri_status status = circumcentre(a, b, c, &centre);
    CLAIM("sec3.1.P13", status == TRI_OUT_OF_RANGE, "%s",
          tri_status_text(status));
    CLAIM("sec3.1.P13", centre.x == 0 && centre.y == 0, "not zeroed");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.1: the coordinates of a vertex are rounded once");
    test_random("rounded once", centres_are_rounded_once, 1500, 20);
    test_near_degenerate("rounded once", centres_are_rounded_once, 1500, 12);
    test_random("at every scale", at_every_scale, 2000, 8);
    test_run("known centres", known_centres);
    test_run("far centres", far_centres_are_refused);
    return test_end((test_minima){.trials = 3000, .largest_n = 15});
}
