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
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>
#include <string.h>

static fast_limits
some_limits(uint32_t n)
{
    random_source *r = test_random_source();
    fast_limits limits = {.few = 1 + random_below(r, 9), .job = 1 + random_below(r, n + 2),
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
    test_run("watched, out of memory, refused", it_can_be_watched_and_refused);
    return test_end((test_minima){.trials = 70000, .largest_n = 150, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
