/* Proposition 1: d lies inside the circle of a, b, c exactly when the lifted d
 * lies below the plane through the lifted a, b, c.
 *
 * Hypotheses: a, b, c are not collinear (E26). For the determinants: none.
 *
 * With small whole coordinates the circle, the plane and the gap between the
 * plane and the lifted d can be computed without rounding, each from its own
 * definition: that is done here. For other doubles the determinant of the
 * lifted points is known to the oracle of big integers.
 */
#include "chapters/3.3_lifting_map/lifting.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>

/* ---- In whole numbers. ---- */

typedef struct whole2 {
    int64_t x, y;
} whole2;

/* The vector from a to p. */
static whole2
vector(point2 a, point2 p)
{
    return (whole2){(int64_t)p.x - (int64_t)a.x, (int64_t)p.y - (int64_t)a.y};
}

static int64_t
cross(whole2 u, whole2 v)
{
    return u.x * v.y - u.y * v.x;
}

static int64_t
squared(whole2 u)
{
    return u.x * u.x + u.y * u.y;
}

static int64_t
height(point2 p)
{
    return squared(vector((point2){0, 0}, p));
}

static int
sign_of(int64_t x)
{
    return (x > 0) - (x < 0);
}

/* D times how much higher the lifted d is than the plane through the lifted a,
 * b, c, where D = cross(b-a, c-a). The plane rises by s.x / D along x and by
 * s.y / D along y (Cramer's rule). */
static int64_t
gap_times_D(point2 a, point2 b, point2 c, point2 d)
{
    whole2 u = vector(a, b), v = vector(a, c), w = vector(a, d);
    int64_t rise_b = height(b) - height(a), rise_c = height(c) - height(a);
    whole2 s = {rise_b * v.y - rise_c * u.y, u.x * rise_c - v.x * rise_b};
    return cross(u, v) * (height(d) - height(a)) - s.x * w.x - s.y * w.y;
}

/* 4 D^2 times |d-m|^2 - r^2, for the circle through a, b, c with centre m: the
 * point where the bisectors of ab and ac meet. */
static int64_t
power_times_4DD(point2 a, point2 b, point2 c, point2 d)
{
    whole2 u = vector(a, b), v = vector(a, c), w = vector(a, d);
    int64_t D = cross(u, v), uu = squared(u), vv = squared(v);
    whole2 m = {uu * v.y - vv * u.y, u.x * vv - v.x * uu}; /* 2D (centre - a) */
    whole2 from_centre = {2 * D * w.x - m.x, 2 * D * w.y - m.y};
    return squared(from_centre) - squared(m);
}

static void
check_four(point2 a, point2 b, point2 c, point2 d)
{
    int64_t D = cross(vector(a, b), vector(a, c));
    if (D == 0)
        return;
    int64_t gap = gap_times_D(a, b, c, d), power = power_times_4DD(a, b, c, d);
    CLAIM("prop1.P1", 4 * D * gap == power,
          "gap %lld / %lld, power %lld / (2 * %lld)^2", (long long)gap,
          (long long)D, (long long)power, (long long)D);
    int below = -sign_of(gap) * sign_of(D), inside = -sign_of(power);
    CLAIM("prop1.P2", below == inside, "below %+d, inside %+d", below, inside);
    int answer = below_plane_rounded(a, b, c, d);
    CLAIM("prop1.P2", answer == inside, "below_plane_rounded: %+d, inside %+d",
          answer, inside);
    answer = orient2d(a, b, c) * orient3d_lifted(a, b, c, d);
    CLAIM("prop1.P2", answer == below, "orient3d_lifted: %+d, below %+d",
          answer, below);
}

static void
inside_is_below(const point2 *points, uint32_t n)
{
    (void)points;
    point2 *p = whole_points(NULL, n, random_below(test_random_source(), 2) ? 4 : 90);
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = 0; b < n; b++)
            for (uint32_t c = 0; c < b; c++)
                for (uint32_t d = 0; d < n; d++)
                    check_four(p[a], p[b], p[c], p[d]);
    free(p);
}

/* P4: the cross product, in space, of the lifted vectors from a to b and c. */
static void
no_three_in_line(const point2 *points, uint32_t n)
{
    (void)points;
    point2 *p = whole_points(NULL, n, 6);
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = 0; b < a; b++)
            for (uint32_t c = 0; c < b; c++) {
                whole2 u = vector(p[a], p[b]), v = vector(p[a], p[c]);
                int64_t rise_b = height(p[b]) - height(p[a]);
                int64_t rise_c = height(p[c]) - height(p[a]);
                bool in_line = cross(u, v) == 0 &&
                               u.x * rise_c == v.x * rise_b &&
                               u.y * rise_c == v.y * rise_b;
                bool distinct = squared(u) != 0 && squared(v) != 0 &&
                                squared(vector(p[b], p[c])) != 0;
                CLAIM("prop1.P4", in_line == !distinct,
                      "lifted, %u, %u and %u are %s line", a, b, c,
                      in_line ? "in" : "not in");
            }
    free(p);
}

/* ---- The determinants. ---- */

/* Four of the points, repetitions allowed. */
static void
same_determinant(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    for (int i = 0; i < 20; i++) {
        point2 q[4];
        for (int k = 0; k < 4; k++)
            q[k] = points[random_below(test_random_source(), n)];
        int answer = orient3d_lifted(q[0], q[1], q[2], q[3]);
        int expected = oracle_incircle(q[0], q[1], q[2], q[3]);
        CLAIM("prop1.P3", answer == expected, "%+d for %+d", answer, expected);
        int swapped = orient3d_lifted(q[1], q[0], q[2], q[3]);
        CLAIM("prop1.P3", swapped == -answer, "%+d, and %+d swapped", answer,
              swapped);
    }
}

/* An integer of magnitude below 2^26, often a small one. */
static double
below_2_26(void)
{
    random_source *r = test_random_source();
    uint32_t most = random_below(r, 2) ? 3 : (1u << 26) - 1;
    return (double)random_below(r, 2 * most + 1) - most;
}

/* There the lift is not rounded, so the oracle of four points in space says
 * what orient3d_lifted must answer: for collinear points and repeated ones,
 * too. */
static void
same_as_orient3d(void)
{
    for (int i = 0; i < 20000; i++) {
        point2 p[4];
        for (int k = 0; k < 4; k++)
            p[k] = (point2){below_2_26(), i % 3 == 0 ? 1 : below_2_26()};
        int expected =
            oracle_orient3d(lift(p[0]), lift(p[1]), lift(p[2]), lift(p[3]));
        int answer = orient3d_lifted(p[0], p[1], p[2], p[3]);
        int rounded = orient3d(lift(p[0]), lift(p[1]), lift(p[2]), lift(p[3]));
        CLAIM("prop1.P3", answer == expected, "%+d for %+d", answer, expected);
        CLAIM("prop1.P3", rounded == expected, "orient3d: %+d for %+d", rounded,
              expected);
        int turn = orient2d(p[0], p[1], p[2]);
        int below = below_plane_rounded(p[0], p[1], p[2], p[3]);
        if (turn != 0)
            CLAIM("prop1.P2", below == turn * expected, "%+d, not %+d", below,
                  turn * expected);
    }
}

/* ---- Where it breaks. ---- */

/* A side of 1 is exact here: all doubles from 1024 to 2048 are multiples of
 * one. So the four corners are cocircular, and every other answer is wrong. */
static void
the_lift_must_not_be_rounded(void)
{
    uint32_t wrong = 0;
    for (int i = 0; i < 100; i++)
        for (int j = 0; j < 100; j++) {
            double x = 1024.1 + i, y = 1024.3 + j;
            point2 a = {x, y}, b = {x + 1, y}, c = {x + 1, y + 1},
                   d = {x, y + 1};
            CLAIM("prop1.P5", orient3d_lifted(a, b, c, d) == 0, "square %d, %d",
                  i, j);
            wrong += below_plane_rounded(a, b, c, d) != 0;
        }
    CLAIM("prop1.P5", wrong == 6400, "%u of 10000 squares get a wrong sign",
          wrong);
}

/* Three collinear sites lift into a vertical plane: nothing is below it, and
 * both of its sides are taken, although no circle is there to be inside of. */
static void
e26_collinear(void)
{
    const point2 a = {0, 0}, b = {1, 0}, c = {3, 0}, left = {1, 2},
                 right = {1, -2};
    CLAIM("E26", orient2d(a, b, c) == 0, "not collinear");
    CLAIM("E26",
          orient3d_lifted(a, b, c, left) * orient3d_lifted(a, b, c, right) ==
              -1,
          "the plane of a, b, c is not between the points on its two sides");
    for (int i = -100; i <= 100; i++) {
        point2 on_line = {0.25 * i, 0};
        CLAIM("E26", orient3d_lifted(a, b, c, on_line) == 0,
              "%g is not in the plane", on_line.x);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Proposition 1: inside the circle is below the plane");
    test_random("gap and power, in whole numbers", inside_is_below, 2000, 9);
    test_random("no three lifted points in line", no_three_in_line, 2000, 12);
    test_random("the determinant of the lifted points", same_determinant, 2000,
                30);
    test_near_degenerate("the determinant of the lifted points",
                         same_determinant, 3000, 20);
    test_run("orient3d, where the lift is exact", same_as_orient3d);
    test_run("unit squares near (1024, 1024)", the_lift_must_not_be_rounded);
    test_run("E26: three collinear sites", e26_collinear);
    return test_end((test_minima){.trials = 9000,
                                  .largest_n = 25,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 5000});
}
