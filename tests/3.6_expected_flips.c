/* Section 3.6.3: how many flips are expected, by equation (5): exactly, over all n!
 * orders of small sets; and within four standard errors, over many orders of a
 * large one.
 *
 * Hypotheses: general position, no three points on a line and no four on a circle:
 * then the Delaunay triangulation of every subset is unique.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "chapters/3.6_randomized_incremental/probability.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 7, MOST_ORDERS = 5040 };

static bool
is_in_general_position(const point2 *p, uint32_t n)
{
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = 0; b < a; b++)
            for (uint32_t c = 0; c < b; c++) {
                if (orient2d(p[a], p[b], p[c]) == 0)
                    return false;
                for (uint32_t d = 0; d < c; d++)
                    if (incircle(p[a], p[b], p[c], p[d]) == 0)
                        return false;
            }
    return true;
}

/* ---- One order. ---- */

typedef struct counter {
    trace observer;  /* first: see lib/trace.h */
    uint32_t points; /* inserted so far, the two of the first edge too */
    uint64_t flips;  /* at all insertions */
    uint64_t *flips_at, *degree_at; /* i -> summed over the runs; or NULL */
    double *hull_at;                /* i -> hull edges then; or NULL */
    vertex_id last;
} counter;

/* After the insertion of point number c->points. */
static void
end_insertion(const mesh *m, counter *c)
{
    if (c->degree_at != NULL && c->points > 2)
        c->degree_at[c->points] += degree(m, c->last);
    if (c->hull_at != NULL)
        c->hull_at[c->points] += mesh_hull_size(m);
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    counter *c = (counter *)self;
    if (event->kind == TRACE_LOCATE) {
        end_insertion(m, c);
        c->points++;
        c->last = event->a;
    }
    if (event->kind == TRACE_FLIP) {
        c->flips++;
        if (c->flips_at != NULL)
            c->flips_at[c->points]++;
    }
    return 0;
}

/* The number of flips in this order; in the random one of `seed` if it is NULL. */
static uint64_t
count_flips(const point2 *points, uint32_t n, const vertex_id *order, uint64_t seed,
            counter *c)
{
    c->observer.see = see;
    c->points = 2;
    c->flips = 0;
    tri_options options = tri_options_default();
    options.order = order;
    options.seed = seed;
    options.trace = &c->observer;
    mesh m;
    tri_status status = incremental_triangulate(points, n, &options, &m);
    CLAIM("expected.P1", status == TRI_OK, "%s", tri_status_text(status));
    end_insertion(&m, c);
    mesh_free(&m);
    return c->flips;
}

/* ---- All n! orders. ---- */

/* The next order in lexicographic order; false after the last. */
static bool
next_order(vertex_id *L, uint32_t n)
{
    uint32_t i = n - 1, j = n - 1;
    while (i > 0 && L[i - 1] >= L[i])
        i--;
    if (i == 0)
        return false;
    while (L[j] <= L[i - 1])
        j--;
    vertex_id old = L[i - 1];
    L[i - 1] = L[j];
    L[j] = old;
    for (j = n - 1; i < j; i++, j--) {
        old = L[i];
        L[i] = L[j];
        L[j] = old;
    }
    return true;
}

typedef struct all_orders {
    int64_t orders;
    uint64_t flips, flips_at[MOST + 1],
        degree_at[MOST + 1]; /* summed over all orders */
    rational mean;           /* E[F], by equation (5) */
} all_orders;

/* Equation (5): each order is an outcome of probability 1/n!, F its flips. */
static all_orders
run_all_orders(const point2 *points, uint32_t n)
{
    all_orders all = {0};
    counter c = {.flips_at = all.flips_at, .degree_at = all.degree_at};
    vertex_id L[MOST];
    rational *F = malloc(MOST_ORDERS * sizeof *F); /* order -> its flips */
    rational *chance = malloc(MOST_ORDERS * sizeof *chance);
    for (uint32_t i = 0; i < n; i++)
        L[i] = i;
    do {
        uint64_t flips = count_flips(points, n, L, 0, &c);
        F[all.orders++] = rational_of((int64_t)flips, 1);
        all.flips += flips;
    } while (next_order(L, n));
    for (int64_t i = 0; i < all.orders; i++)
        chance[i] = rational_of(1, all.orders);
    probability_space orders = {(uint32_t)all.orders, chance};
    claim_verdict("expected.P1", is_probability_space(orders));
    all.mean = expected_value(orders, F);
    free(chance);
    free(F);
    return all;
}

/* E[h_i]: the mean number of hull vertices of i of the n points. */
static rational
mean_hull(const point2 *points, uint32_t n, uint32_t i)
{
    int64_t sum = 0, subsets = 0;
    for (uint32_t set = 0; set < 1u << n; set++) {
        point2 chosen[MOST];
        uint32_t count = 0;
        for (uint32_t k = 0; k < n; k++)
            if (set >> k & 1)
                chosen[count++] = points[k];
        if (count != i)
            continue;
        mesh m;
        CLAIM("expected.P1", sweep_triangulate(chosen, i, NULL, &m) == TRI_OK,
              "no mesh");
        sum += mesh_hull_size(&m);
        mesh_free(&m);
        subsets++;
    }
    return rational_of(sum, subsets);
}

/* P1 to P3 for these points: the mean of each insertion, and of all together. */
static void
check_all_orders(const point2 *points, uint32_t n)
{
    all_orders all = run_all_orders(points, n);
    rational expected = rational_of(0, 1), six = rational_of(6, 1);
    for (uint32_t i = 3; i <= n; i++) {
        rational h = mean_hull(points, n, i);
        rational less = rational_quotient(rational_sum(six, h), rational_of(i, 1));
        rational new =
            rational_sum(six, rational_product(rational_of(-1, 1), less));
        rational seen = rational_of((int64_t)all.degree_at[i], all.orders);
        CLAIM("expected.P2", rational_equal(seen, new),
              "%d/%d new triangles at insertion %u, "
              "%d/%d expected",
              (int)seen.num, (int)seen.den, i, (int)new.num, (int)new.den);
        CLAIM("expected.P2", rational_value(new) < 6, "%g new triangles",
              rational_value(new));
        expected = rational_sum(expected, rational_sum(new, rational_of(-3, 1)));
        CLAIM("E45", all.flips_at[i] <= 3 * (uint64_t)all.orders,
              "%u flips at insertion %u", (unsigned)all.flips_at[i], i);
    }
    CLAIM("expected.P1", rational_equal(all.mean, expected),
          "%d/%d flips, %d/%d expected", (int)all.mean.num, (int)all.mean.den,
          (int)expected.num, (int)expected.den);
    CLAIM("expected.P3", all.flips <= 3 * n * (uint64_t)all.orders,
          "%u flips in all orders", (unsigned)all.flips);
}

static void
equation_5_of_small_sets(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    point2 *points = whole_points(NULL, n, 40);
    bool good = n >= 1 && is_in_general_position(points, n);
    if (good)
        check_all_orders(points, n);
    free(points);
    HYPOTHESIS(good);
}

/* In convex position h_i = i, so insertion i makes 2 - 6/i flips on average. */
static void
equation_5_in_convex_position(void)
{
    const point2 points[MOST] = {{1, 1},    {13, 169}, {4, 16}, {2, 4},
                                 {11, 121}, {7, 49},   {5, 25}};
    for (uint32_t n = 3; n <= MOST; n++) {
        CLAIM("expected.P1", is_in_general_position(points, n),
              "choose other points");
        check_all_orders(points, n);
        all_orders all = run_all_orders(points, n);
        rational expected = rational_of(0, 1);
        for (uint32_t i = 3; i <= n; i++)
            expected = rational_sum(expected, rational_of(2 * (int64_t)i - 6, i));
        CLAIM("expected.P1", rational_equal(all.mean, expected),
              "n = %u: %d/%d flips", n, (int)all.mean.num, (int)all.mean.den);
    }
}

/* E45: nested triangles, whose hulls are small: more flips than the printed sum
 * 3n (n-1)! + 3(n-1) (n-2)! + ... allows, at the last insertion but one and
 * together. */
static void
e45_the_printed_sum_is_no_bound(void)
{
    const point2 points[MOST] = {{-100, -90}, {101, -85}, {3, 130}, {-7, -11},
                                 {13, -6},    {1, 17},    {2, 1}};
    CLAIM("E45", is_in_general_position(points, MOST), "choose other points");
    all_orders all = run_all_orders(points, MOST);
    uint64_t factorial = 1, sum = 0, last_but_one = 0;
    for (uint64_t i = 1; i <= MOST; i++) {
        factorial *= i;
        sum += 3 * factorial;
        if (i + 1 == MOST)
            last_but_one = 3 * factorial; /* 3(n-1) (n-2)! */
    }
    CLAIM("E45", all.flips > sum, "%u flips, the printed sum is %u",
          (unsigned)all.flips, (unsigned)sum);
    CLAIM("E45", all.flips_at[MOST - 1] > last_but_one, "%u flips at insertion %d",
          (unsigned)all.flips_at[MOST - 1], MOST - 1);
    check_all_orders(points, MOST);
}

/* ---- The worst order. ---- */

/* P4: (i, i^2) from right to left makes C(n-2, 2) flips, from left to right none. */
static void
the_worst_order(void)
{
    for (uint32_t n = 3; n <= 120; n += 13) {
        point2 *points = malloc(n * sizeof *points);
        vertex_id *ascending = malloc(n * sizeof *ascending);
        vertex_id *descending = malloc(n * sizeof *descending);
        for (uint32_t i = 0; i < n; i++) {
            points[i] = (point2){i + 1, (i + 1.0) * (i + 1.0)};
            ascending[i] = i;
            descending[i] = n - 1 - i;
        }
        counter c = {0};
        uint64_t up = count_flips(points, n, ascending, 0, &c);
        uint64_t down = count_flips(points, n, descending, 0, &c);
        free(ascending);
        free(descending);
        free(points);
        CLAIM("expected.P4", up == 0, "%u flips from left to right", (unsigned)up);
        CLAIM("expected.P4", down == (uint64_t)(n - 2) * (n - 3) / 2,
              "%u flips from right to left, n = %u", (unsigned)down, n);
    }
}

/* ---- Many orders of a large set. ---- */

static void
flips_of_a_large_set(void)
{
    enum { n = 2000, orders = 100 };
    point2 *points = malloc(n * sizeof *points);
    double hull[n + 1] = {0}, sum = 0, squares = 0, expected = 0;
    random_source *r = test_random_source();
    for (int i = 0; i < n; i++)
        points[i] = (point2){random_unit(r), random_unit(r)};
    for (int k = 0; k < orders; k++) {
        counter c = {.hull_at = hull};
        double flips = (double)count_flips(points, n, NULL, random_bits(r), &c);
        sum += flips;
        squares += flips * flips;
    }
    free(points);
    for (int i = 3; i <= n; i++)
        expected += 3 - (6 + hull[i] / orders) / i;
    double mean = sum / orders;
    double error = 4 * sqrt((squares / orders - mean * mean) / orders);
    printf("# flips: %.1f +- %.1f, %.1f expected, 3n = %d\n", mean, error, expected,
           3 * n);
    fflush(stdout);
    CLAIM("expected.P1", fabs(mean - expected) < error,
          "%.1f +- %.1f flips, %.1f expected", mean, error, expected);
    CLAIM("expected.P3", mean - error <= 3 * n, "%.1f flips", mean);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6.3: the expected number of flips");
    test_random("equation (5)", equation_5_of_small_sets, 300, 6);
    test_run("equation (5), convex position", equation_5_in_convex_position);
    test_run("E45: the printed sum", e45_the_printed_sum_is_no_bound);
    test_run("the worst order", the_worst_order);
    test_run("a large set", flips_of_a_large_set);
    return test_end((test_minima){.trials = 304, .largest_n = 6});
}
