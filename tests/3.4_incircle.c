/* Section 3.4: incircle returns the sign of its determinant over the real
 * numbers; for counterclockwise a, b, c that says where d lies with respect to
 * their circle.
 *
 * Hypotheses: the coordinates are finite doubles; of the circle, that a, b and
 * c turn left.
 */
#include "chapters/3.4_primitives/determinants.h"
#include "tests/harness/harness.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/oracle.h"

#include <math.h>

/* ---- Every finite double. ---- */

/* All quadruples of neighbours in the circular sequence of the points. */
static void
signs_are_those_of_the_determinant(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 a = points[i], b = points[(i + 1) % n], c = points[(i + 2) % n];
        point2 d = points[(i + 3) % n];
        predicate_counts before = predicate_count;
        claim_sign(before, incircle(a, b, c, d), oracle_incircle(a, b, c, d));
    }
}

static void
swapping_two_points_turns_the_sign(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 a = points[i], b = points[(i + 1) % n], c = points[(i + 2) % n];
        point2 d = points[(i + 3) % n];
        int sign = incircle(a, b, c, d);
        int ab = incircle(b, a, c, d), bc = incircle(a, c, b, d);
        int cd = incircle(a, b, d, c);
        CLAIM("sec3.4.P2", ab == -sign, "bacd: %+d, abcd: %+d", ab, sign);
        CLAIM("sec3.4.P2", bc == -sign, "acbd: %+d, abcd: %+d", bc, sign);
        CLAIM("sec3.4.P2", cd == -sign, "abdc: %+d, abcd: %+d", cd, sign);
    }
}

/* Circles whose centre and corners are integers: the distances are, too. */
static void
positive_is_inside(void)
{
    random_source *source = test_random_source();
    for (int i = 0; i < 20000; i++) {
        static const point2 on_circle[12] = {
            {5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
            {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
        point2 centre, p[4];
        centre.x = random_below(source, 100);
        centre.y = random_below(source, 100);
        uint32_t place = random_below(source, 12),
                 step = 1 + random_below(source, 5);
        for (uint32_t k = 0; k < 3; k++) { /* together less than once round */
            point2 v = on_circle[(place + k * step) % 12];
            p[k] = (point2){centre.x + v.x, centre.y + v.y};
        }
        double dx = (double)random_below(source, 13) - 6;
        double dy = (double)random_below(source, 13) - 6;
        p[3] = (point2){centre.x + dx, centre.y + dy};
        double distance = dx * dx + dy * dy;
        int expected = distance < 25 ? +1 : distance > 25 ? -1 : 0;
        int sign = incircle(p[0], p[1], p[2], p[3]);
        CLAIM("sec3.4.P2", sign == expected,
              "%+d at the distance sqrt(%g) from the "
              "centre of a circle of radius 5",
              sign, distance);
    }
}

/* ---- What the tiers are for. ---- */

/* Random quadruples, and d moved off the circle by 2^-38 of its radius. */
static void
the_filter_decides(void)
{
    uint32_t decided = 0, trials = 20000;
    random_source *source = test_random_source();
    for (uint32_t i = 0; i < trials; i++) {
        point2 p[4];
        for (int k = 0; k < 4; k++) {
            double x = random_unit(source) - 0.5, y = random_unit(source) - 0.5;
            double length = sqrt(x * x + y * y), r = k == 3 ? 1 + 0x1p-38 : 1;
            if (i % 2 == 0 || length == 0)
                length = r = 1;
            p[k] = (point2){r * x / length, r * y / length};
        }
        predicate_counts before = predicate_count;
        (void)incircle(p[0], p[1], p[2], p[3]);
        decided += tier_since(before) == FILTER;
    }
    CLAIM("sec3.4.P12", decided >= trials / 100 * 99, "only %u of %u", decided,
          trials);
}

/* Unit squares away from the origin, whose corners are not quite cocircular
 * after rounding: the lift is rounded, too, and its error is larger than what
 * is sought. */
static void
the_lift_must_not_be_rounded(void)
{
    uint32_t wrong = 0;
    for (int i = 0; i < 100; i++)
        for (int j = 0; j < 100; j++) {
            double x = 1024.1 + i, y = 1024.3 + j;
            point2 a = {x, y}, b = {x + 1, y}, c = {x + 1, y + 1},
                   d = {x, y + 1};
            double rounded = incircle_lifted(a, b, c, d);
            int sign = oracle_incircle(a, b, c, d);
            CLAIM("E31", incircle(a, b, c, d) == sign, "square %d, %d", i, j);
            wrong += (rounded > 0) - (rounded < 0) != sign;
        }
    CLAIM("E31", wrong >= 1000, "only %u of 10000 squares got a wrong sign",
          wrong);
}

/* The same circle at every magnitude that there is. */
static void
scaling_keeps_the_sign(void)
{
    for (int e = -1074; e <= 1020; e++) {
        double s = ldexp(1, e);
        const point2 a = {4 * s, 3 * s}, b = {-3 * s, 4 * s}, c = {-5 * s, 0};
        const point2 on = {0, -5 * s}, in = {s, -4 * s}, out = {2 * s, -5 * s};
        predicate_counts before = predicate_count;
        claim_sign(before, incircle(a, b, c, on), 0);
        before = predicate_count;
        claim_sign(before, incircle(a, b, c, in), +1);
        before = predicate_count;
        claim_sign(before, incircle(a, b, c, out), -1);
    }
}

static void
small_circles_have_an_inside(void)
{
    const double s = 0x1p-1074;
    const point2 a = {0, 0}, b = {2 * s, 0}, c = {0, 2 * s}, in = {s, s};
    const point2 on = {2 * s, 2 * s}, out = {3 * s, s};
    CLAIM("sec3.4.P5", incircle(a, b, c, in) == +1, "%+d",
          incircle(a, b, c, in));
    CLAIM("sec3.4.P5", incircle(a, b, c, on) == 0, "%+d",
          incircle(a, b, c, on));
    CLAIM("sec3.4.P5", incircle(a, b, c, out) == -1, "%+d",
          incircle(a, b, c, out));
}

static void
large_circles_have_an_inside(void)
{
    const double m = 1.7976931348623157e308, less = 0x1.ffffffffffffep1023;
    const point2 a = {-m, -m}, b = {m, -m}, c = {m, m}, in = {-m, less},
                 on = {-m, m};
    CLAIM("sec3.4.P5", incircle(a, b, c, in) == +1, "%+d",
          incircle(a, b, c, in));
    CLAIM("sec3.4.P5", incircle(a, b, c, on) == 0, "%+d",
          incircle(a, b, c, on));
}

/* ---- Errata. ---- */

/* The three printed rows are the same for both places of p4. */
static void
e28_the_missing_row(void)
{
    const point2 a = {0, 0}, b = {2, 0}, c = {0, 2}, in = {1, 1}, out = {3, 3};
    CLAIM("E28", incircle(a, b, c, in) != incircle(a, b, c, out), "both %+d",
          incircle(a, b, c, in));
}

/* The determinant of the three vectors that leave the lifted a. */
static double
lifted_orientation(point2 a, point2 b, point2 c, point2 d)
{
    const point2 p[4] = {a, b, c, d};
    double v[3][3];
    for (int i = 0; i < 3; i++) {
        point2 q = p[i + 1];
        v[i][0] = q.x - a.x;
        v[i][1] = q.y - a.y;
        v[i][2] = q.x * q.x + q.y * q.y - a.x * a.x - a.y * a.y;
    }
    return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
           v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

static void
e29_minus_the_orientation(void)
{
    const point2 a = {0, 0}, b = {2, 0}, c = {0, 2}, in = {1, 1}, out = {3, 3};
    double det_in = incircle_lifted(a, b, c, in),
           det_out = incircle_lifted(a, b, c, out);
    CLAIM("E29", det_in == 8 && det_out == -24, "%g inside, %g outside", det_in,
          det_out);
    CLAIM("E29",
          incircle_rounded(a, b, c, in) == 8 &&
              incircle_rounded(a, b, c, out) == -24,
          "another value with d at the origin");
    CLAIM("E29",
          lifted_orientation(a, b, c, in) == -det_in &&
              lifted_orientation(a, b, c, out) == -det_out,
          "not minus the orientation");
    CLAIM("E29", incircle(a, b, c, in) == +1 && incircle(a, b, c, out) == -1,
          "%+d inside, %+d outside", incircle(a, b, c, in),
          incircle(a, b, c, out));
}

static void
e30_zero_without_a_circle(void)
{
    const point2 p[4] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, off = {7, 5},
                 other = {2, 9};
    CLAIM("E30", incircle(p[0], p[1], p[2], p[3]) == 0,
          "four points of a line");
    CLAIM("E30", incircle(p[0], p[0], off, other) == 0, "a repeated point");
    CLAIM("E30", incircle(p[0], p[1], p[2], off) != 0,
          "three of a line, one off it");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.4: incircle is the sign of its determinant");
    test_random("signs of the determinant", signs_are_those_of_the_determinant,
                3000, 60);
    test_near_degenerate("signs of the determinant, nearly degenerate",
                         signs_are_those_of_the_determinant, 4000, 60);
    test_random("swapping", swapping_two_points_turns_the_sign, 1000, 40);
    test_near_degenerate("swapping, nearly degenerate",
                         swapping_two_points_turns_the_sign, 1000, 40);
    test_run("positive is inside", positive_is_inside);
    test_run("the filter decides nearly always", the_filter_decides);
    test_run("rounded lifts", the_lift_must_not_be_rounded);
    test_run("every magnitude", scaling_keeps_the_sign);
    test_run("underflow", small_circles_have_an_inside);
    test_run("overflow", large_circles_have_an_inside);
    test_run("E28: a row is missing", e28_the_missing_row);
    test_run("E29: the sign of the orientation", e29_minus_the_orientation);
    test_run("E30: 0 is not cocircular", e30_zero_without_a_circle);
    /* Each tier has answered, beside the oracle, and all together often. */
    return test_end((test_minima){.trials = 9000,
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
