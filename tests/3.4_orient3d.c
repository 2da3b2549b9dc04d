/* Section 3.4: orient3d returns the sign of its determinant over the real
 * numbers, and of four lifted points it is the incircle test (Proposition 1).
 *
 * Hypotheses: the coordinates are finite doubles; for the lift, small integers,
 * so that it is exact.
 */
#include "tests/harness/harness.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/oracle.h"

#include <math.h>

/* A point of space from two of the plane: a third coordinate of its own, or so
 * that all points lie nearly in one plane, or exactly. */
static point3
raise(point2 p, point2 other, int kind)
{
    double z = kind == 0 ? other.y : kind == 1 ? p.x + p.y : p.x;
    return (point3){p.x, p.y, isfinite(z) ? z : p.y};
}

/* All quadruples of neighbours in the circular sequence of the points. */
static void
signs_are_those_of_the_determinant(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < 3 * n; i++) {
        point3 p[4];
        for (uint32_t k = 0; k < 4; k++)
            p[k] = raise(points[(i / 3 + k) % n],
                         points[(i / 3 + 3 * k + 1) % n], (int)(i % 3));
        predicate_counts before = predicate_count;
        int sign = orient3d(p[0], p[1], p[2], p[3]);
        claim_sign(before, sign, oracle_orient3d(p[0], p[1], p[2], p[3]));
        int ab = orient3d(p[1], p[0], p[2], p[3]),
            bc = orient3d(p[0], p[2], p[1], p[3]);
        int cd = orient3d(p[0], p[1], p[3], p[2]);
        CLAIM("sec3.4.P1", ab == -sign && bc == -sign && cd == -sign,
              "abcd: %+d, bacd: %+d, acbd: %+d, abdc: %+d", sign, ab, bc, cd);
    }
}

/* Random quadruples, and d moved off the plane by 2^-42. */
static void
the_filter_decides(void)
{
    uint32_t decided = 0, trials = 20000;
    random_source *source = test_random_source();
    for (uint32_t i = 0; i < trials; i++) {
        point3 p[4];
        for (int k = 0; k < 4; k++) {
            p[k].x = random_unit(source);
            p[k].y = random_unit(source);
            p[k].z = random_unit(source);
            if (i % 2 == 1)
                p[k].z = p[k].x - p[k].y + (k == 3 ? 0x1p-38 : 0);
        }
        predicate_counts before = predicate_count;
        (void)orient3d(p[0], p[1], p[2], p[3]);
        decided += tier_since(before) == FILTER;
    }
    CLAIM("sec3.4.P12", decided >= trials / 100 * 99, "only %u of %u", decided,
          trials);
}

/* Below the plane of a, b, c, seen from above counterclockwise, is positive. */
static void
below_is_positive(void)
{
    const point3 a = {0, 0, 0}, b = {1, 0, 0}, c = {0, 1, 0};
    int below = orient3d(a, b, c, (point3){3, 4, -1});
    int above = orient3d(a, b, c, (point3){3, 4, 1}),
        in = orient3d(a, b, c, (point3){3, 4, 0});
    CLAIM("sec3.4.P1", below == +1 && above == -1 && in == 0,
          "below %+d, above %+d, in the plane %+d", below, above, in);
}

static point3
lift(point2 p)
{
    return (point3){p.x, p.y, p.x * p.x + p.y * p.y};
}

/* All quadruples of the 4 x 4 grid that begin at a corner. */
static void
incircle_is_orient3d_of_the_lift(void)
{
    for (int i = 0; i < 16 * 16 * 16; i++) {
        const point2 a = {0, 0}, b = {i % 4, i / 4 % 4},
                     c = {i / 16 % 4, i / 64 % 4};
        const point2 d = {i / 256 % 4, i / 1024};
        int flat = incircle(a, b, c, d);
        int solid = orient3d(lift(a), lift(b), lift(c), lift(d));
        CLAIM("sec3.4.P2", flat == solid, "number %d: %+d and %+d", i, flat,
              solid);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.4: orient3d is the sign of its determinant");
    test_random("signs of the determinant", signs_are_those_of_the_determinant,
                1000, 60);
    test_near_degenerate("signs of the determinant, nearly degenerate",
                         signs_are_those_of_the_determinant, 1600, 60);
    test_run("the filter decides nearly always", the_filter_decides);
    test_run("below is positive", below_is_positive);
    test_run("of lifted points it is incircle",
             incircle_is_orient3d_of_the_lift);
    /* Each tier has answered, beside the oracle, and all together often. */
    return test_end((test_minima){.trials = 2600,
                                  .largest_n = 50,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 10000,
                                  .made = {{"sec3.4.P4", 10000},
                                           {"sec3.4.P6", 10000},
                                           {"sec3.4.P10", 10000},
                                           {"sec3.4.P11", 10000},
                                           {"sec3.4.P4 sec3.4.P6 sec3.4.P10 sec3.4.P11",
                                            100000}}});
}
