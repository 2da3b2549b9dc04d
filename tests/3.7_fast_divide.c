/* Section 3.7, faster: fast_divide_triangulate gives what divide_triangulate gives.
 *
 * Hypotheses: none. Every finite input; duplicates, collinear points and 0 to 3 points
 * are ordinary. With low limits, few points are enough to run all of it: a plan of
 * several parts, grids in grids, cuts at the median.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/3.7_divide_and_conquer/fast_divide.h"
#include "chapters/3.7_divide_and_conquer/fast_order.h"
#include "chapters/3.7_divide_and_conquer/fast_questions.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static fast_limits
some_limits(uint32_t n)
{
    random_source *r = test_random_source();
    fast_limits limits = {.few = 1 + random_below(r, 9),
                          .job = 1 + random_below(r, n + 2),
                          .threads = random_below(r, 16) == 0 ? 3 : 1};
    return limits;
}

/* ---- The result. ---- */

static void
expect_delaunay(const mesh *m, const point2 *points, uint32_t n)
{
    triangle_list list;
    verdict v;
    claim_verdict("fast.P1", mesh_check(m));
    CLAIM("fast.P1", mesh_triangles(m, &list) == TRI_OK, "no memory");
    test_picture(list);
    CLAIM("fast.P1", is_delaunay(points, n, list, &v) == TRI_OK, "no memory");
    triangle_list_free(&list);
    claim_verdict("fast.P1", v);
}

/* The cells of the Delaunay subdivision and, for a path, too, the hull. */
static void
expect_same_cells(const mesh *m, const mesh *k, const point2 *points)
{
    subdivision s, t;
    CLAIM("fast.P1", m->points == k->points && m->locations == k->locations &&
          mesh_hull_size(m) == mesh_hull_size(k), "%u and %u locations", m->locations,
          k->locations);
    CLAIM("fast.P1", delaunay_subdivision(m, points, &s) == TRI_OK &&
          delaunay_subdivision(k, points, &t) == TRI_OK, "no memory");
    CLAIM("fast.P1", subdivisions_are_equal(&s, &t), "the cells are others");
    subdivision_free(&s);
    subdivision_free(&t);
    for (uint32_t v = 0; v < m->points; v++)
        CLAIM("fast.P1", (m->leaving[v] == NONE) == (k->leaving[v] == NONE),
              "the location of point %u has another vertex", v);
}

static void
compare_with_divide(const point2 *points, uint32_t n, fast_limits limits)
{
    mesh m, k;
    CLAIM("fast.P1", fast_divide_with(points, n, limits, &m) == TRI_OK &&
          divide_triangulate(points, n, NULL, &k) == TRI_OK, "no mesh");
    expect_delaunay(&m, points, n);
    expect_same_cells(&m, &k, points);
    mesh_free(&m);
    mesh_free(&k);
}

static void
divide_says_the_same(const point2 *points, uint32_t n)
{
    compare_with_divide(points, n, fast_limits_for(n, 1));
}

static void
with_low_limits_too(const point2 *points, uint32_t n)
{
    compare_with_divide(points, n, some_limits(n));
}

/* The same bytes from one thread and from several; the numbers of the vertices, too. */
static void
threads_change_nothing(const point2 *points, uint32_t n)
{
    fast_limits limits = some_limits(n);
    limits.job = 1 + random_below(test_random_source(), 1 + n / 8);
    const uint32_t threads[] = {1, 2, 3, 8};
    mesh first;
    for (int i = 0; i < 4; i++) {
        mesh m;
        limits.threads = threads[i];
        CLAIM("fast.P6", fast_divide_with(points, n, limits, &m) == TRI_OK, "no mesh");
        if (i == 0) {
            first = m;
            continue;
        }
        CLAIM(
            "fast.P6",
            m.triangles == first.triangles && m.locations == first.locations &&
                m.ghost_leaving == first.ghost_leaving &&
                (n == 0 ||
                 memcmp(m.leaving, first.leaving, n * sizeof *m.leaving) == 0) &&
                (m.triangles == 0 || memcmp(m.halfedge, first.halfedge,
                                            3 * m.triangles * sizeof *m.halfedge) == 0),
            "%u threads make another mesh", threads[i]);
        mesh_free(&m);
    }
    mesh_free(&first);
}

/* ---- The questions. ---- */

/* The points as sites of a run that has the bounds for them. The caller frees the
 * sites. */
static fast_run
run_of(const point2 *points, uint32_t n, double unit)
{
    fast_run run = {.site = malloc((n + 1) * sizeof *run.site)};
    CLAIM("fast.P2", run.site != NULL, "no memory");
    for (uint32_t i = 0; i < n; i++)
        run.site[i] = (fast_site){points[i].x, points[i].y, i, NONE};
    fast_box b = fast_box_around(run.site, n);
    fast_bounds(&run, b.high[0] - b.low[0], b.high[1] - b.low[1], unit);
    return run;
}

/* Asks everything about four sites l, r, p and q; `claim` is what says that it is
 * right. */
#define EXPECT_RIGHT_ANSWERS(claim, at, unit) do { \
        fast_run run = run_of(at, 4, unit); \
        int side = oracle_orient2d(at[0], at[1], at[2]); \
        fast_view ps = fast_look(&run, 2, 0, 1), qs = fast_look(&run, 3, 0, 1); \
        CLAIM(claim, fast_turn(&run, 0, 1, 2) == side, "not %d", side); \
        CLAIM(claim, fast_is_above(&run, 0, 1, 2, ps) == (side > 0), "not %d", side); \
        if (side > 0) { \
            int circle = oracle_incircle(at[0], at[1], at[2], at[3]); \
            CLAIM(claim, fast_is_inside(&run, 0, 1, 2, 3, ps, qs) == (circle > 0), \
                  "not %d", circle); \
        } \
        free(run.site); \
    } while (0)

/* Four of the points, perhaps one of them twice. */
static void
choose_four(const point2 *points, uint32_t n, point2 at[4])
{
    for (int k = 0; k < 4; k++)
        at[k] = points[random_below(test_random_source(), n)];
}

static void
answers_are_right(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 4);
    for (int i = 0; i < 20; i++) {
        point2 at[4];
        choose_four(points, n, at);
        EXPECT_RIGHT_ANSWERS("fast.P2", at, 0);
    }
}

static point2
on_unit_circle(void)
{
    double t = 2 * random_unit(test_random_source()) - 1, s = 1 + t * t;
    return (point2){(1 - t * t) / s, 2 * t / s};
}

/* The products of which fast_is_inside takes the difference; for sites l, r, p, q. */
static void
products_of(const point2 at[4], double product[2])
{
    fast_run run = run_of(at, 4, 0);
    fast_view ps = fast_look(&run, 2, 0, 1), qs = fast_look(&run, 3, 0, 1);
    product[0] = ps.dot * qs.turn;
    product[1] = qs.dot * ps.turn;
    free(run.site);
}

/* Points of a circle so large that both products are about 2^1024: rounded, one may
 * overflow and the other not. Then their difference is infinite, and says nothing. */
static void
one_product_may_overflow(void)
{
    uint32_t overflows = 0;
    for (int i = 0; i < 40000; i++) {
        point2 at[4];
        double product[2];
        for (int k = 0; k < 4; k++)
            at[k] = on_unit_circle();
        products_of(at, product);
        if (fabs(product[0]) < 0x1p-20)
            continue;
        double radius = ldexp(sqrt(sqrt(1 / fabs(product[0]))), 256);
        for (int k = 0; k < 4; k++)
            at[k] = (point2){at[k].x * radius, at[k].y * radius};
        EXPECT_RIGHT_ANSWERS("fast.P2", at, 0);
        products_of(at, product);
        bool first = isfinite(product[0]), second = isfinite(product[1]);
        overflows += first != second;
    }
    CLAIM("fast.P2", overflows >= 1000, "one product overflowed %u times", overflows);
}

static double
random_whole(uint32_t most)
{
    random_source *s = test_random_source();
    return (double)random_below(s, 2 * most + 1) - most;
}

/* A whole point of the circle around the origin whose squared radius is the product of
 * the first numbers 5, 13, 17, 29, ...: a product of complex numbers with these norms,
 * each of which may be conjugated. */
static point2
whole_point_on_circle(uint32_t factors)
{
    static const point2 factor[12] = {{2, 1}, {3, 2}, {4, 1}, {5, 2}, {6, 1}, {5, 4},
                                      {7, 2}, {6, 5}, {8, 3}, {8, 5}, {9, 4}, {10, 1}};
    random_source *s = test_random_source();
    point2 z = {1, 0};
    for (uint32_t k = 0; k < factors; k++) {
        point2 f = factor[k];
        if (random_below(s, 2) == 0)
            f.y = -f.y;
        z = (point2){z.x * f.x - z.y * f.y, z.x * f.y + z.y * f.x};
    }
    return random_below(s, 2) == 0 ? z : (point2){-z.y, z.x};
}

/* Points of a circle, or three in a row, of which one is perhaps moved a little: whole
 * multiples of a power of two, few or many. */
static void
whole_multiples_are_right(void)
{
    enum { TWICE_EXACT = 9 }; /* then no squared distance exceeds 2^50 */
    random_source *s = test_random_source();
    for (int i = 0; i < 200000; i++) {
        uint32_t factors = random_below(s, 13);
        double unit = ldexp(1, (int)random_below(s, 40) - 20);
        double x = random_whole(1000), y = random_whole(1000);
        point2 at[4];
        for (int j = 0; j < 4; j++)
            at[j] = whole_point_on_circle(factors);
        if (random_below(s, 4) == 0)
            at[2] = (point2){2 * at[1].x - at[0].x, 2 * at[1].y - at[0].y};
        if (random_below(s, 4) == 0)
            at[3].x += random_whole(1);
        for (int j = 0; j < 4; j++)
            at[j] = (point2){(x + at[j].x) * unit, (y + at[j].y) * unit};
        predicate_counts before = predicate_count;
        EXPECT_RIGHT_ANSWERS("fast.P3", at, unit);
        uint64_t closer = predicate_count.signs + predicate_count.expansions -
                          before.signs - before.expansions;
        CLAIM("fast.P3", factors > TWICE_EXACT || closer == 0,
              "multiples of %g with %u factors needed exact.c", unit, factors);
    }
}

/* How many determinants have gone to exact.c. */
static uint64_t
asked_exact(void)
{
    return predicate_count.signs + predicate_count.expansions + predicate_count.wide;
}

/* Asks with a determinant 0, of which the bounds for few bits say nothing. Returns how
 * many of the two answers came from twice as many bits. */
static uint32_t
expect_right_with_more_bits(const point2 at[4])
{
    fast_run run = run_of(at, 4, 0);
    uint64_t before = asked_exact();
    int side = oracle_orient2d(at[0], at[1], at[2]);
    int circle = oracle_incircle(at[0], at[1], at[2], at[3]);
    CLAIM("fast.P8", fast_near_turn(&run, 0, 1, 2, 0) == side, "not %d", side);
    uint32_t answered = asked_exact() == before;
    before = asked_exact();
    CLAIM("fast.P8", fast_near_circle(&run, 0, 1, 2, 3, 0) == (circle > 0), "not %d",
          circle);
    free(run.site);
    return answered + (asked_exact() == before);
}

static void
more_bits_are_right(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 4);
    for (int i = 0; i < 20; i++) {
        point2 at[4];
        choose_four(points, n, at);
        expect_right_with_more_bits(at);
    }
}

/* One in four is 0; the others have 53 bits and are about 2^(least .. most). */
static double
random_number(int least, int most)
{
    random_source *s = test_random_source();
    double x = 0.5 + random_unit(s) / 2;
    int exponent = least + (int)random_below(s, (uint32_t)(most - least + 1));
    uint32_t kind = random_below(s, 4);
    return kind == 0 ? 0 : ldexp(kind == 1 ? -x : x, exponent);
}

/* x, or a double or two above it. */
static double
stepped(double x)
{
    for (uint32_t k = random_below(test_random_source(), 3); k > 0; k--)
        x = nextafter(x, HUGE_VAL);
    return x;
}

/* Points of a circle as doubles come; rectangles, of which the corner at the origin is
 * moved by as little as the bounds are; three points in a row that miss each other by
 * as little; and coordinates of every magnitude. */
static void
more_bits_are_enough(void)
{
    enum { TRIALS = 40000, FEW_BITS = 53, MORE_BITS = 2 * FEW_BITS };
    random_source *s = test_random_source();
    uint32_t answered = 0, on_circles = 0, magnitudes = 0;
    for (int i = 0; i < TRIALS; i++) {
        point2 at[4];
        for (int k = 0; k < 4; k++)
            at[k] = on_unit_circle();
        uint32_t more = expect_right_with_more_bits(at);
        on_circles += more == 2;

        double a = random_number(-2, 0), b = random_number(-2, 0);
        int tiny = -40 - (int)random_below(s, MORE_BITS - 40);
        at[0] = (point2){random_number(tiny, tiny), random_number(tiny, tiny)};
        at[1] = (point2){a, 0};
        at[2] = (point2){stepped(a), b};
        at[3] = (point2){0, stepped(b)};
        uint32_t first = random_below(s, 4);
        const point2 turned[4] = {at[first], at[(first + 1) % 4], at[(first + 2) % 4],
                                  at[(first + 3) % 4]};
        answered += expect_right_with_more_bits(turned);
        double third = ldexp(1, tiny) / 3;
        const point2 row[4] = {{a, b}, {third * a, third * b}, {-4 * a, -4 * b},
                               {b, 2 * a}};
        answered += expect_right_with_more_bits(row);

        for (int k = 0; k < 4; k++)
            at[k] = (point2){random_number(-1000, 1000), random_number(-1000, 1000)};
        magnitudes += expect_right_with_more_bits(at);
        answered += more;
    }
    CLAIM("fast.P8", on_circles >= TRIALS / 100 * 99 && answered >= TRIALS * 2 &&
          magnitudes >= TRIALS / 2, "%u on circles, %u of all, %u of all magnitudes",
          on_circles, answered, magnitudes);
}

/* ---- The cells. ---- */

static void
halves_are_apart(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 2);
    fast_run run = run_of(points, n, 0);
    fast_site *to = malloc(n * sizeof *to);
    fast_cells cells;
    random_source *s = test_random_source();
    fast_box all = fast_box_around(run.site, n), box = all;
    if (random_below(s, 2) == 0) { /* any box will do */
        const fast_site *p = &run.site[random_below(s, n)], *q = &run.site[0];
        box = (fast_box){{fmin(p->x, q->x), fmin(p->y, q->y)},
                         {fmax(p->x, q->x), fmax(p->y, q->y)}};
    }
    int bits = 1 + (int)random_below(s, FAST_GRID_BITS);
    uint32_t threads = random_below(s, 16) == 0 ? 3 : 1;
    double longer = fmax(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    bool sorted = fast_grid_sort(&cells, box, bits, run.site, to, n, threads);
    CLAIM("fast.P4", sorted || !(longer > 1e-200 && longer < 1e200), "no grid");
    uint32_t seen = 0;
    for (uint32_t c = 0; c < 1u << bits && sorted; c++)
        for (; seen < cells.end[c]; seen++)
            to[seen].edge = c;
    CLAIM("fast.P4", !sorted || seen == n, "%u of %u sites are in cells", seen, n);
    for (uint32_t i = 0; i + 1 < n && sorted; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            uint32_t differs = to[i].edge ^ to[j].edge;
            int bit = 0;
            while (differs >> bit > 1)
                bit++;
            CLAIM("fast.P4", differs == 0 || (cells.axis[bit] == 0 ? to[i].x < to[j].x
                                                                 : to[i].y < to[j].y),
                  "sites %u and %u are in the wrong halves", to[i].id, to[j].id);
        }
    free(to);
    free(run.site);
}

/* ---- The cost. ---- */

static void
uniform_points_cost_little(void)
{
    enum { N = 20000 };
    point2 *points = malloc(N * sizeof *points);
    for (uint32_t i = 0; i < N; i++)
        points[i] = random_point(test_random_source());
    predicate_counts before = predicate_count;
    mesh m;
    CLAIM("fast.P7", fast_divide_triangulate(points, N, NULL, &m) == TRI_OK, "no mesh");
    double orient = (double)(predicate_count.orient2d - before.orient2d) / N;
    double circle = (double)(predicate_count.incircle - before.incircle) / N;
    uint64_t closer = predicate_count.signs + predicate_count.expansions -
                      before.signs - before.expansions;
    CLAIM("fast.P7", orient < 9.5 && circle < 8.2 && closer == 0,
          "%g orientation and %g incircle tests a point, %u of them for exact.c",
          orient, circle, (unsigned)closer);
    mesh_free(&m);
    free(points);
}

/* Coordinates that are whole multiples of anything, all of them huge, tiny or equal. */
static void
scales_change_nothing(const point2 *points, uint32_t n)
{
    point2 *whole = whole_points(points, n, 50),
           *scaled = malloc((n + 1) * sizeof *scaled);
    int k = (int)random_below(test_random_source(), 2090) - 1074;
    for (uint32_t i = 0; i < n; i++)
        scaled[i] = (point2){ldexp(whole[i].x, k), ldexp(whole[i].y, k)};
    mesh m, z;
    predicate_counts before = predicate_count;
    CLAIM("fast.P5", fast_divide_triangulate(whole, n, NULL, &m) == TRI_OK &&
          fast_divide_triangulate(scaled, n, NULL, &z) == TRI_OK, "no mesh");
    CLAIM("fast.P5",
          predicate_count.wide == before.wide &&
              predicate_count.expansions == before.expansions,
          "scaled by 2^%d: not cheap", k);
    CLAIM("fast.P5", m.triangles == z.triangles && (m.triangles == 0 ||
          memcmp(m.halfedge, z.halfedge, 3 * m.triangles * sizeof *m.halfedge) == 0),
          "scaled by 2^%d: another mesh", k);
    mesh_free(&m);
    mesh_free(&z);
    free(scaled);
    free(whole);
}

/* ---- Watched, and out of memory. ---- */

static int
count_events(trace *self, const mesh *m, const trace_event *event)
{
    (void)self;
    return event->kind == TRACE_FLIP && m->triangles >= 30;
}

static void
it_can_be_watched_and_refused(void)
{
    point2 points[50];
    for (int i = 0; i < 50; i++)
        points[i] = (point2){i % 7, i * i % 11};
    trace stop = {count_events};
    tri_options options = tri_options_default();
    mesh m;
    options.trace = &stop;
    tri_status stopped = fast_divide_triangulate(points, 50, &options, &m);
    CLAIM("fast.P1", stopped == TRI_CANCELLED && m.halfedge == NULL,
          "the observer could not stop it");
    for (uint32_t job = 3; job <= 100; job += 97) {
        fast_limits limits = {.few = 3, .job = job, .threads = 2};
        tri_status status = TRI_OUT_OF_MEMORY;
        for (unsigned long k = 1; status != TRI_OK; k++) {
            memory_fail_at(k);
            status = fast_divide_with(points, 50, limits, &m);
            memory_fail_at(0);
            CLAIM("fast.P1", status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                  m.halfedge == NULL && m.leaving == NULL), "allocation %lu: %s", k,
                  tri_status_text(status));
        }
        mesh_free(&m);
    }
    points[7].y = HUGE_VAL;
    CLAIM("fast.P1", fast_divide_triangulate(points, 50, NULL, &m) == TRI_NOT_FINITE,
          "a point at infinity was accepted");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.7: faster, with the same result");
    test_random("the result", divide_says_the_same, 2000, 120);
    test_near_degenerate("the result", divide_says_the_same, 1000, 50);
    test_random("low limits", with_low_limits_too, 3000, 200);
    test_near_degenerate("low limits", with_low_limits_too, 3000, 60);
    test_grid_subsets("low limits", with_low_limits_too, 4);
    test_random("threads", threads_change_nothing, 300, 300);
    test_near_degenerate("threads", threads_change_nothing, 200, 60);
    test_random("answers", answers_are_right, 3000, 30);
    test_near_degenerate("answers", answers_are_right, 5000, 30);
    test_run("answers, one product overflows", one_product_may_overflow);
    test_run("whole multiples", whole_multiples_are_right);
    test_random("more bits", more_bits_are_right, 1000, 30);
    test_near_degenerate("more bits", more_bits_are_right, 3000, 30);
    test_run("more bits", more_bits_are_enough);
    test_random("cells", halves_are_apart, 1000, 60);
    test_near_degenerate("cells", halves_are_apart, 1000, 40);
    test_random("scales", scales_change_nothing, 500, 60);
    test_run("the cost", uniform_points_cost_little);
    test_run("watched, out of memory, refused", it_can_be_watched_and_refused);
    return test_end((test_minima){.trials = 70000, .largest_n = 150, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
