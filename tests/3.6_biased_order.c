/* Section 3.6: the biased order: rounds of doubling size, each along a curve that
 * goes from neighbour to neighbour.
 *
 * Hypotheses: none.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "tests/harness/harness.h"

#include <stdlib.h>

/* P1: the curve visits all cells, and goes from each to a cell beside it. */
static void
the_curve_goes_from_cell_to_cell(void)
{
    const uint32_t side = 1u << 16;
    random_source *r = test_random_source();
    CLAIM("biased.P1", curve_place(0, 0) == 0, "the curve begins at %u",
          curve_place(0, 0));
    for (int k = 0; k < 100000; k++) {
        uint32_t x = random_below(r, k % 2 == 0 ? side : 16);
        uint32_t y = random_below(r, k % 3 == 0 ? side : 16);
        uint32_t here = curve_place(x, y), after = 0, before = 0;
        for (int way = 0; way < 4; way++) {
            uint32_t nx = x + (way == 0) - (way == 1),
                     ny = y + (way == 2) - (way == 3);
            if (nx >= side || ny >= side)
                continue;
            after += curve_place(nx, ny) == here + 1;
            before += curve_place(nx, ny) + 1 == here;
        }
        CLAIM("biased.P1", after == (here != UINT32_MAX),
              "%u cells beside (%u,%u) come next", after, x, y);
        CLAIM("biased.P1", before == (here != 0),
              "%u cells beside (%u,%u) come before", before, x, y);
    }
}

/* In which cell of the box from `least` to `most` is c? Here for whole numbers. */
static uint32_t
cell_of(uint32_t c, uint32_t least, uint32_t most)
{
    if (most == least)
        return 0;
    uint64_t at = (uint64_t)(c - least) * 65536 / (most - least);
    return at < 65536 ? (uint32_t)at : 65535;
}

/* P2: a permutation; and round r, the places from 2^(r-1) on, follows the curve.
 * The sides of the box are powers of two, so that nothing is rounded. */
static void
each_round_follows_the_curve(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    random_source *r = test_random_source();
    point2 *points = malloc((n + 2) * sizeof *points);
    vertex_id *L = malloc((n + 2) * sizeof *L);
    uint32_t side = 1u << random_below(r, 12), count = n + 2;
    for (uint32_t i = 0; i < count; i++) {
        points[i] = (point2){random_below(r, side + 1), random_below(r, side + 1)};
        L[i] = i;
    }
    points[0] = (point2){0, 0};
    points[1] = (point2){side, side};
    tri_status status = biased_order(points, L, count, r);
    bool *seen = calloc(count, sizeof *seen), once = true;
    uint32_t wrong = 0, before = 0;
    for (uint32_t i = 0; i < count; i++) {
        once = once && L[i] < count && !seen[L[i]];
        if (!once)
            break;
        seen[L[i]] = true;
        uint32_t here = curve_place(cell_of((uint32_t)points[L[i]].x, 0, side),
                                    cell_of((uint32_t)points[L[i]].y, 0, side));
        bool round_begins = (i & (i - 1)) == 0; /* 0, or a power of two */
        wrong += !round_begins && here < before;
        before = here;
    }
    free(seen);
    free(L);
    free(points);
    CLAIM("biased.P2", status == TRI_OK && once, "not a permutation");
    CLAIM("biased.P2", wrong == 0, "%u steps back along the curve", wrong);
}

/* P2: which points are in a round is random: each is in the last one equally often. */
static void
the_rounds_are_random(void)
{
    enum { n = 24, orders = 24000, last_round = 16 };
    point2 points[n];
    uint32_t late[n] = {0};
    random_source *r = test_random_source();
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){i % 5, i / 5};
    for (int k = 0; k < orders; k++) {
        vertex_id L[n];
        for (uint32_t i = 0; i < n; i++)
            L[i] = i;
        CLAIM("biased.P2", biased_order(points, L, n, r) == TRI_OK,
              "out of memory");
        for (uint32_t i = last_round; i < n; i++)
            late[L[i]]++;
    }
    /* Each is late with probability 1/3; five standard deviations are 365. */
    for (uint32_t i = 0; i < n; i++)
        CLAIM("biased.P2", late[i] > orders / 3 - 365 && late[i] < orders / 3 + 365,
              "point %u is in the last round %u of %d times", i, late[i], orders);
}

/* P3: a walk is short. */
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
    CLAIM("biased.P3", status == TRI_OK, "%s", tri_status_text(status));
    mesh_free(&m);
    return (double)w.visits / n;
}

static void
walks_are_short(void)
{
    enum { n = 16384 };
    point2 *points = malloc(n * sizeof *points);
    random_source *r = test_random_source();
    for (int i = 0; i < n; i++)
        points[i] = (point2){random_unit(r), random_unit(r)};
    double few = visits_for_each(points, n / 16, true),
           many = visits_for_each(points, n, true);
    double few_at_random = visits_for_each(points, n / 16, false);
    double many_at_random = visits_for_each(points, n, false);
    free(points);
    CLAIM("biased.P3", many < 4 && many < 1.2 * few,
          "%.2f and %.2f triangles a walk", few, many);
    CLAIM("biased.P3", many_at_random > 3 * few_at_random,
          "in random order %.1f and %.1f", few_at_random, many_at_random);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6: the biased order");
    test_run("the curve", the_curve_goes_from_cell_to_cell);
    test_random("each round follows the curve", each_round_follows_the_curve, 500,
                200);
    test_run("the rounds are random", the_rounds_are_random);
    test_run("walks are short", walks_are_short);
    return test_end((test_minima){.trials = 503, .largest_n = 150});
}
