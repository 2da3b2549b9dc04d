/* Section 3.4: compare_distance returns the sign of |pq|^2 - |rs|^2 over the
 * real numbers.
 *
 * Hypotheses: the coordinates are finite doubles; nothing else.
 */
#include "tests/harness/harness.h"
#include "tests/oracle/agreement.h"
#include "tests/oracle/oracle.h"

/* Neighbours in the circular sequence of the points, with two pairs apart, with
 * a point in common, and with a pair that is a single point. */
static void
signs_are_those_of_the_distances(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 p = points[i], q = points[(i + 1) % n];
        point2 r = points[(i + 2) % n], s = points[(i + 3) % n];
        predicate_counts before = predicate_count;
        int sign = compare_distance(p, q, r, s);
        claim_sign(before, sign, oracle_compare_distance(p, q, r, s));
        before = predicate_count;
        claim_sign(before, compare_distance(p, q, r, q),
                   oracle_compare_distance(p, q, r, q));
        before = predicate_count;
        claim_sign(before, compare_distance(p, p, r, s),
                   oracle_compare_distance(p, p, r, s));
        int swapped = compare_distance(q, p, r, s),
            back = compare_distance(r, s, p, q);
        CLAIM("sec3.4.P1", swapped == sign, "qp: %+d, pq: %+d", swapped, sign);
        CLAIM("sec3.4.P1", back == -sign, "back: %+d, there: %+d", back, sign);
    }
}

/* Distances in whole units, some of them equal in different directions. */
static void
pythagoras_is_a_tie(void)
{
    const point2 o = {0, 0}, far = {5, 0}, there = {3, 4}, nearer = {-4, 2};
    int tie = compare_distance(o, far, o, there);
    int less = compare_distance(o, nearer, o, far);
    CLAIM("sec3.4.P1", tie == 0, "%+d", tie);
    CLAIM("sec3.4.P1", less == -1, "%+d", less);
}

/* Of random distances the rounded answer is nearly always sure. */
static void
the_filter_decides(void)
{
    uint32_t decided = 0, trials = 20000;
    for (uint32_t i = 0; i < trials; i++) {
        random_source *source = test_random_source();
        point2 p[3];
        for (int k = 0; k < 3; k++) {
            p[k].x = random_unit(source);
            p[k].y = random_unit(source);
        }
        predicate_counts before = predicate_count;
        (void)compare_distance(p[0], p[1], p[2], p[1]);
        decided += tier_since(before) == FILTER;
    }
    CLAIM("sec3.4.P12", decided >= trials / 100 * 99, "only %u of %u", decided,
          trials);
}

/* Where squares leave the doubles on either side. */
static void
extreme_distances_compare(void)
{
    const double most = 0x1.fffffffffffffp1023, least = 0x1p-1074;
    const point2 o = {0, 0}, far = {most, most}, further = {most, -most};
    const point2 near = {least, 0}, also_near = {0, -least};
    CLAIM("sec3.4.P11", compare_distance(far, further, far, o) == +1,
          "2 > sqrt 2");
    CLAIM("sec3.4.P11", compare_distance(o, far, o, further) == 0,
          "the same length");
    CLAIM("sec3.4.P11", compare_distance(o, near, near, also_near) == -1,
          "1 < sqrt 2");
    CLAIM("sec3.4.P11", compare_distance(o, near, o, also_near) == 0,
          "the same length");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "3.4: compare_distance is the sign of |pq|^2 - |rs|^2");
    test_random("signs of the differences", signs_are_those_of_the_distances,
                2500, 60);
    test_near_degenerate("signs of the differences, nearly degenerate",
                         signs_are_those_of_the_distances, 10000, 60);
    test_run("pythagoras", pythagoras_is_a_tie);
    test_run("the filter decides nearly always", the_filter_decides);
    test_run("underflow and overflow", extreme_distances_compare);
    /* Each tier has answered, beside the oracle, and all together often. */
    return test_end((test_minima){.trials = 7000,
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
