/* Section 3.6: the biased order: random rounds of doubling size, each along a curve
 * that stays in one place until it has been everywhere there.
 *
 * Hypotheses: none.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "tests/harness/harness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- P1: the curve. ---- */

/* The box of the points L[from .. to-1]: is its side along x the longer one? */
static bool
is_longer_in_x(const point2 *points, const vertex_id *L, uint32_t from, uint32_t to)
{
    point2 least = points[L[from]], most = least;
    for (uint32_t i = from; i < to; i++) {
        point2 p = points[L[i]];
        least = (point2){p.x < least.x ? p.x : least.x, p.y < least.y ? p.y : least.y};
        most = (point2){p.x > most.x ? p.x : most.x, p.y > most.y ? p.y : most.y};
    }
    return most.x - least.x >= most.y - least.y;
}

/* Are all of L[from .. cut-1] on one side of all of L[cut .. to-1]? */
static bool
is_cut(const point2 *points, const vertex_id *L, uint32_t from, uint32_t cut,
       uint32_t to, bool x)
{
    bool before = true, behind = true;
    for (uint32_t i = from; i < cut; i++)
        for (uint32_t j = cut; j < to; j++) {
            point2 p = points[L[i]], q = points[L[j]];
            before = before && (x ? p.x < q.x : p.y < q.y);
            behind = behind && (x ? p.x > q.x : p.y > q.y);
        }
    return before || behind;
}

enum { MOST = 16 };

/* Can L[0 .. count-1] have come about by cuts across the longer sides? Tries all
 * cuts of all intervals, the short ones first. */
static bool
is_cut_again_and_again(const point2 *points, const vertex_id *L, uint32_t count)
{
    bool good[MOST + 1][MOST + 1] = {{false}}; /* is from .. to-1 such a part? */
    for (uint32_t length = 1; length <= count; length++)
        for (uint32_t from = 0; from + length <= count; from++) {
            uint32_t to = from + length;
            bool x = is_longer_in_x(points, L, from, to);
            good[from][to] = length <= 2;
            for (uint32_t cut = from + 1; cut < to && !good[from][to]; cut++)
                good[from][to] = good[from][cut] && good[cut][to] &&
                                 is_cut(points, L, from, cut, to, x);
        }
    return count == 0 || good[0][count];
}

/* Is order[0 .. count-1] a permutation of the lowest indices at all locations? */
static bool
is_each_location_once(const point2 *points, uint32_t n, const vertex_id *order,
                      uint32_t count)
{
    uint32_t locations;
    vertex_id *sorted = malloc((n + 1) * sizeof *sorted);
    bool *there = calloc(n + 1, sizeof *there);
    bool right = sort_along(points, n, (point2){1, 0}, sorted, &locations) == TRI_OK &&
                 count == locations;
    for (uint32_t i = 0; i < locations; i++)
        there[sorted[i]] = true;
    for (uint32_t i = 0; i < count && right; i++) {
        right = order[i] < n && there[order[i]];
        if (right)
            there[order[i]] = false;
    }
    free(there);
    free(sorted);
    return right;
}

static void
the_curve_runs_through_one_side_before_the_other(const point2 *points, uint32_t n)
{
    uint32_t count;
    vertex_id L[MOST];
    HYPOTHESIS(n <= MOST);
    CLAIM("biased.P1",
          along_curve(points, n, test_random_source(), L, &count) == TRI_OK,
          "out of memory");
    CLAIM("biased.P1", is_each_location_once(points, n, L, count),
          "the %u points are not the distinct locations", count);
    CLAIM("biased.P1", is_cut_again_and_again(points, L, count),
          "the curve does not stay on one side of some cut");
}

/* A few places with many copies: each cut must leave something on both sides. */
static void
the_curve_comes_to_an_end(void)
{
    enum { n = 100000 };
    point2 *points = calloc(n, sizeof *points);
    vertex_id *L = malloc(n * sizeof *L);
    uint32_t count;
    points[n / 3] = (point2){1, 0};
    points[n / 2] = (point2){-0x1p-1074, 0};
    points[n - 1] = (point2){0, 1e308};
    CLAIM("biased.P1",
          along_curve(points, n, test_random_source(), L, &count) == TRI_OK,
          "out of memory");
    CLAIM("biased.P1", is_each_location_once(points, n, L, count) && count == 4,
          "%u locations", count);
    free(L);
    free(points);
}

/* ---- P2: its length. ---- */

static double
length_along_curve(const point2 *points, uint32_t n)
{
    uint32_t count;
    vertex_id *L = malloc(n * sizeof *L);
    CLAIM("biased.P2",
          along_curve(points, n, test_random_source(), L, &count) == TRI_OK,
          "out of memory");
    double length = 0;
    for (uint32_t i = 1; i < count; i++)
        length += hypot(points[L[i]].x - points[L[i - 1]].x,
                        points[L[i]].y - points[L[i - 1]].y);
    free(L);
    return length;
}

static void
the_curve_is_short(void)
{
    enum { most = 65536 };
    point2 *points = malloc(most * sizeof *points);
    for (uint32_t n = 256; n <= most; n *= 4) {
        for (uint32_t i = 0; i < n; i++)
            points[i] = random_point(test_random_source());
        double length = length_along_curve(points, n) / sqrt(n);
        printf("# %u uniform points: the curve is %.3f sqrt(n) long\n", n, length);
        fflush(stdout);
        CLAIM("biased.P2", length < 1.5, "%u points: %.3f sqrt(n)", n, length);
    }
    free(points);
}

/* ---- P3: the rounds. ---- */

/* Index -> its rank along the curve that these random numbers make. */
static uint32_t *
ranks_along_curve(const point2 *points, uint32_t n, random_source random)
{
    uint32_t count;
    vertex_id *curve = malloc((n + 1) * sizeof *curve);
    uint32_t *rank = calloc(n + 1, sizeof *rank);
    CLAIM("biased.P3", along_curve(points, n, &random, curve, &count) == TRI_OK,
          "out of memory");
    for (uint32_t i = 0; i < count; i++)
        rank[curve[i]] = i;
    free(curve);
    return rank;
}

/* A permutation; and it steps back along the curve only where a round begins. There
 * may be more rounds than log2 n, but 30 more are seen once in 10^9 trials. */
static void
each_round_follows_the_curve(const point2 *points, uint32_t n)
{
    random_source *r = test_random_source();
    uint32_t count, *rank = ranks_along_curve(points, n, *r);
    vertex_id *L = malloc((n + 1) * sizeof *L);
    tri_status status = biased_order(points, n, r, L, &count);
    bool once = status == TRI_OK && is_each_location_once(points, n, L, count);
    uint32_t back = 0, most = 30;
    for (uint32_t i = 1; i < count; i++)
        back += rank[L[i]] < rank[L[i - 1]];
    for (uint32_t i = count; i > 0; i /= 2)
        most++;
    free(rank);
    free(L);
    CLAIM("biased.P3", once, "the %u points are not the distinct locations", count);
    CLAIM("biased.P3", back <= most, "%u steps back along the curve", back);
}

/* Each point is in the last round equally often, and each pair of points. */
static void
the_rounds_are_random(void)
{
    enum { n = 24, orders = 24000 };
    point2 points[n];
    uint32_t late[n] = {0}, both[n] = {0};
    random_source *r = test_random_source();
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){i % 5, i / 5};
    for (int k = 0; k < orders; k++) {
        vertex_id L[n];
        bool last_round[n] = {false};
        uint32_t count, *rank = ranks_along_curve(points, n, *r);
        CLAIM("biased.P3", biased_order(points, n, r, L, &count) == TRI_OK,
              "out of memory");
        for (uint32_t i = n; i > 0 && (i == n || rank[L[i - 1]] < rank[L[i]]); i--)
            last_round[L[i - 1]] = true;
        for (uint32_t i = 0; i < n; i++) {
            late[i] += last_round[i];
            both[i] += last_round[i] && last_round[(i + 1) % n];
        }
        free(rank);
    }
    /* Probabilities 1/2 and 1/4; six standard deviations are 465 and 403. */
    for (uint32_t i = 0; i < n; i++) {
        CLAIM("biased.P3", abs((int)late[i] - orders / 2) < 465,
              "point %u is in the last round %u of %d times", i, late[i], orders);
        CLAIM("biased.P3", abs((int)both[i] - orders / 4) < 403,
              "points %u and %u are in the last round together %u of %d times", i,
              (i + 1) % n, both[i], orders);
    }
}

/* ---- P4: a walk is short. ---- */

typedef struct walker {
    trace observer; /* first: see lib/trace.h */
    uint64_t visits;
} walker;

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    ((walker *)self)->visits += event->kind == TRACE_VISIT;
    return 0;
}

static double
visits_for_each(const point2 *points, uint32_t n, bool biased)
{
    walker w = {.observer = {see}};
    tri_options options = tri_options_default();
    options.locator = TRI_LOCATOR_WALK;
    options.trace = &w.observer;
    mesh m;
    tri_status status = biased ? biased_triangulate(points, n, &options, &m)
                               : incremental_triangulate(points, n, &options, &m);
    CLAIM("biased.P4", status == TRI_OK, "%s", tri_status_text(status));
    mesh_free(&m);
    return (double)w.visits / n;
}

/* The ways in which points may lie unevenly. */
enum { UNIFORM, NEAR_LINE, DENSE_MIDDLE, CLUSTERS, TWO_LINES, ALL_SCALES, SHAPES };
static const char *const shape_name[] = {"uniform", "near a line", "dense middle",
                                         "clusters", "two lines", "all scales"};

static point2
draw(int shape, random_source *r)
{
    point2 p = random_point(r);
    double rest = 1 - random_unit(r);
    switch (shape) {
    case NEAR_LINE:
        return (point2){p.x, 1e-6 * p.y};
    case DENSE_MIDDLE: /* with outliers as far as 1/rest */
        return (point2){(p.x - 0.5) / rest, (p.y - 0.5) / rest};
    case CLUSTERS: {
        uint32_t k = random_below(r, 100);
        return (point2){k % 10 + 1e-4 * p.x, k / 10 + 1e-4 * p.y};
    }
    case TWO_LINES:
        return (point2){p.x, random_below(r, 2)};
    case ALL_SCALES: {
        int scale = -(int)random_below(r, 300);
        return (point2){ldexp(p.x, scale), ldexp(p.y, scale)};
    }
    default:
        return p;
    }
}

static void
walks_are_short(void)
{
    enum { n = 16384 };
    point2 *points = malloc(n * sizeof *points);
    random_source *r = test_random_source();
    for (int shape = 0; shape < SHAPES; shape++) {
        for (int i = 0; i < n; i++)
            points[i] = draw(shape, r);
        double few = visits_for_each(points, n / 16, true),
               many = visits_for_each(points, n, true);
        printf("# %s: %.2f and %.2f triangles a walk\n", shape_name[shape], few, many);
        fflush(stdout);
        CLAIM("biased.P4", many < 5 && many < 1.4 * few,
              "%s: %.2f and %.2f triangles a walk", shape_name[shape], few, many);
        if (shape == UNIFORM) {
            double few_at_random = visits_for_each(points, n / 16, false);
            double many_at_random = visits_for_each(points, n, false);
            CLAIM("biased.P4", many_at_random > 3 * few_at_random,
                  "in random order %.1f and %.1f", few_at_random, many_at_random);
        }
    }
    free(points);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6: the biased order");
    test_random("one side before the other",
                the_curve_runs_through_one_side_before_the_other, 2000, MOST);
    test_near_degenerate("one side before the other",
                         the_curve_runs_through_one_side_before_the_other, 2000, MOST);
    test_grid_subsets("one side before the other",
                      the_curve_runs_through_one_side_before_the_other, 4);
    test_run("many copies", the_curve_comes_to_an_end);
    test_run("the curve is short", the_curve_is_short);
    test_random("each round follows the curve", each_round_follows_the_curve, 500,
                200);
    test_near_degenerate("each round follows the curve", each_round_follows_the_curve,
                         500, 60);
    test_run("the rounds are random", the_rounds_are_random);
    test_run("walks are short", walks_are_short);
    return test_end((test_minima){.trials = 60000, .largest_n = 150});
}
