/* Section 3.4: orient2d and compare_along return the signs of their
 * determinants over the real numbers, and the determinant is twice the signed
 * area.
 *
 * Hypotheses: the coordinates are finite doubles; nothing else.
 */
#include "chapters/3.4_primitives/determinants.h"
#include "tests/harness/harness.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/oracle.h"

#include <math.h>

/* ---- Every finite double. ---- */

/* All triples and quadruples of neighbours in the circular sequence of the
 * points: of one point, the same point three times. */
static void
signs_are_those_of_the_determinants(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 a = points[i], b = points[(i + 1) % n], c = points[(i + 2) % n];
        point2 d = points[(i + 3) % n];
        predicate_counts before = predicate_count;
        claim_sign(before, orient2d(a, b, c), oracle_orient2d(a, b, c));
        before = predicate_count;
        claim_sign(before, cross_sign(a, b, c, d), oracle_cross(a, b, c, d));
    }
}

static void
orientation_follows_the_permutation(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 a = points[i], b = points[(i + 1) % n], c = points[(i + 2) % n];
        int sign = orient2d(a, b, c), turned = orient2d(b, c, a);
        int swapped = orient2d(b, a, c);
        CLAIM("sec3.4.P1", turned == sign, "bca: %+d, abc: %+d", turned, sign);
        CLAIM("sec3.4.P1", swapped == -sign, "bac: %+d, abc: %+d", swapped,
              sign);
    }
}

/* Along (1,0), (0,-1), and the direction from the first point to the origin. */
static void
the_sweep_order_is_total(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 1 && (points[0].x != 0 || points[0].y != 0));
    const point2 zero = {0, 0};
    const point2 direction[3] = {{1, 0}, {0, -1}, points[0]};
    for (uint32_t i = 0; i < 3 * n; i++) {
        point2 d = direction[i % 3], p = points[i / 3],
               q = points[(i / 3 + 1) % n];
        int expected = oracle_cross(p, q, (point2){-d.y, d.x}, zero);
        if (expected == 0)
            expected = oracle_cross(d, zero, p, q);
        int order = compare_along(d, p, q), back = compare_along(d, q, p);
        CLAIM("sec3.4.P1", order == expected, "%+d for %+d", order, expected);
        CLAIM("sec3.4.P1", back == -order, "pq: %+d, qp: %+d", order, back);
        CLAIM("sec3.4.P1", (order == 0) == (p.x == q.x && p.y == q.y),
              "%+d for two points that are%s equal", order,
              order == 0 ? " not" : "");
    }
}

/* Triangles of a small grid. By Pick's theorem twice the area is twice the
 * number of grid points inside, plus those on the boundary, less two. */
static void
the_determinant_is_twice_the_area(void)
{
    enum { SIDE = 6 };
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int j = 0; j < SIDE * SIDE; j++) {
            point2 a = {0, 0}, b = {i % SIDE, i / SIDE},
                   c = {j % SIDE, j / SIDE};
            if (oracle_orient2d(a, b, c) <= 0)
                continue;
            int inside = 0, boundary = 0;
            for (int k = 0; k < SIDE * SIDE; k++) {
                point2 p = {k % SIDE, k / SIDE};
                int ab = oracle_orient2d(a, b, p),
                    bc = oracle_orient2d(b, c, p);
                int ca = oracle_orient2d(c, a, p);
                if (ab > 0 && bc > 0 && ca > 0)
                    inside++;
                else if (ab >= 0 && bc >= 0 && ca >= 0)
                    boundary++;
            }
            double det = orient2d_rounded(a, b, c);
            CLAIM("sec3.4.P1", det == 2 * inside + boundary - 2,
                  "(0,0) (%g,%g) (%g,%g): %g", b.x, b.y, c.x, c.y, det);
        }
}

/* ---- What the tiers are for. ---- */

/* Random triples, and triples whose triangle is 2^45 times longer than high. */
static void
the_filter_decides(void)
{
    uint32_t decided = 0, trials = 20000;
    for (uint32_t i = 0; i < trials; i++) {
        random_source *source = test_random_source();
        point2 p[4];
        for (int k = 0; k < 4; k++) {
            p[k].x = random_unit(source);
            p[k].y = random_unit(source);
        }
        if (i % 2 == 1) { /* p[1] to the line from p[0] to p[2], nearly */
            double t = p[3].x, off = p[3].y < 0.5 ? -0x1p-45 : 0x1p-45;
            p[1].x = p[0].x + t * (p[2].x - p[0].x) - off * (p[2].y - p[0].y);
            p[1].y = p[0].y + t * (p[2].y - p[0].y) + off * (p[2].x - p[0].x);
        }
        predicate_counts before = predicate_count;
        (void)orient2d(p[0], p[1], p[2]);
        decided += tier_since(before) == FILTER;
    }
    CLAIM("sec3.4.P12", decided >= trials / 100 * 99, "only %u of %u", decided,
          trials);
}

static void
small_triangles_are_no_lines(void)
{
    const point2 a = {0, 0}, b = {1e-200, 0}, c = {0, 1e-200};
    const point2 e = {1e-200, 1e-200}, f = {3e-200, 2e-200};
    CLAIM("sec3.4.P5", orient2d_rounded(a, b, c) == 0,
          "the product did not underflow");
    CLAIM("sec3.4.P5", orient2d(a, b, c) == +1, "%+d", orient2d(a, b, c));
    CLAIM("sec3.4.P5", orient2d(a, e, f) == -1, "%+d", orient2d(a, e, f));

    /* Where products become subnormal and lose bits: without its last term the
     * filter would let -1 through here. */
    const point2 p = {0x1.8a9a964ef646p-515, 0x1.e90c96c78143bp-511};
    const point2 q = {0x1.fc4d0e8bb72dp-514, 0x1.b453d689233cp-517};
    const point2 r = {0x1.aca596a7d0625p-515, 0x1.cea7e6232b7f8p-511};
    int expected = oracle_orient2d(p, q, r);
    CLAIM("sec3.4.P5", orient2d(p, q, r) == expected, "not %+d", expected);
}

/* The same triples at every magnitude that there is. */
static void
scaling_keeps_the_sign(void)
{
    for (int e = -1074; e <= 1021; e++) {
        double s = ldexp(1, e);
        const point2 p = {s, s}, q = {2 * s, 3 * s};
        const point2 on = {3 * s, 5 * s}, right = {3 * s, 4 * s};
        predicate_counts before = predicate_count;
        claim_sign(before, orient2d(p, q, on), 0);
        before = predicate_count;
        claim_sign(before, orient2d(p, q, right), -1);
    }
}

/* Collinear along an axis, or two points in one place: no arithmetic is needed,
 * not even where expansions cannot reach. */
static void
frequent_zeros_are_cheap(void)
{
    const point2 p[3] = {{0.1, 0.7}, {1e300, 0.7}, {-5e-324, 0.7}},
                 off = {3, 1e-310};
    predicate_counts before = predicate_count;
    int along_x = orient2d(p[0], p[1], p[2]);
    int along_y =
        orient2d((point2){off.y, 1}, (point2){off.y, 2}, (point2){off.y, 7});
    int repeated = orient2d(p[1], off, p[1]);
    CLAIM("sec3.4.P6", along_x == 0 && along_y == 0 && repeated == 0,
          "%+d, %+d, %+d", along_x, along_y, repeated);
    CLAIM("sec3.4.P6", predicate_count.signs == before.signs + 3,
          "%u of 3 in step 1",
          (unsigned)(predicate_count.signs - before.signs));
}

static void
large_triangles_have_a_side(void)
{
    const double most = 1.7976931348623157e308;
    const point2 a = {-most, -most}, b = {most, most};
    const point2 c = {most, 0x1.ffffffffffffep1023};
    CLAIM("sec3.4.P5", orient2d(a, b, c) == -1, "%+d", orient2d(a, b, c));
    CLAIM("sec3.4.P5", orient2d(c, b, a) == +1, "%+d", orient2d(c, b, a));
}

/* ---- Errata. ---- */

static void
e27_the_printed_row(void)
{
    const point2 a = {0, 0}, b = {1, 0}, c = {2, 1};
    CLAIM("E27", orient2d(a, b, c) == +1, "%+d", orient2d(a, b, c));
    CLAIM("E27", orient2d_rounded(a, b, c) == +1, "%g",
          orient2d_rounded(a, b, c));
    CLAIM("E27", orient2d_misprinted(a, b, c) == -1, "%g",
          orient2d_misprinted(a, b, c));
}

static void
e31_rounding_turns_the_sign(void)
{
    const point2 a = {0.5 + 41 * 0x1p-53, 0.5 + 48 * 0x1p-53};
    const point2 b = {12, 12}, c = {24, 24};
    double rounded = orient2d_rounded(a, b, c);
    CLAIM("E31", oracle_orient2d(a, b, c) == +1, "a is not left of bc");
    CLAIM("E31", rounded < 0, "the rounded determinant is %g", rounded);
    CLAIM("E31", orient2d(a, b, c) == +1, "%+d", orient2d(a, b, c));
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.4: orient2d is the sign of its determinant");
    test_random("signs of the determinants",
                signs_are_those_of_the_determinants, 2500, 60);
    test_near_degenerate("signs of the determinants, nearly degenerate",
                         signs_are_those_of_the_determinants, 5000, 60);
    test_random("permutations", orientation_follows_the_permutation, 2000, 60);
    test_near_degenerate("permutations, nearly degenerate",
                         orientation_follows_the_permutation, 2000, 60);
    test_random("the order along a direction", the_sweep_order_is_total, 2000,
                40);
    test_near_degenerate("the order along a direction, nearly degenerate",
                         the_sweep_order_is_total, 2000, 40);
    test_run("twice the signed area", the_determinant_is_twice_the_area);
    test_run("the filter decides nearly always", the_filter_decides);
    test_run("frequent zeros", frequent_zeros_are_cheap);
    test_run("every magnitude", scaling_keeps_the_sign);
    test_run("underflow", small_triangles_are_no_lines);
    test_run("overflow", large_triangles_have_a_side);
    test_run("E27: row 2 as printed", e27_the_printed_row);
    test_run("E31: doubles near a line", e31_rounding_turns_the_sign);
    /* Each tier has answered, beside the oracle, and all together often: here for two
     * predicates. */
    return test_end((test_minima){.trials = 15000,
                                  .largest_n = 50,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 10000,
                                  .made = {{"sec3.4.P4", 10000},
                                           {"sec3.4.P6", 10000},
                                           {"sec3.4.P10", 10000},
                                           {"sec3.4.P11", 10000},
                                           {"sec3.4.P4 sec3.4.P6 sec3.4.P10 sec3.4.P11",
                                            200000}}});
}
