/* Figure 3, LineSweep: after each step the swept points are triangulated.
 *
 * Hypotheses: none. Every finite input, in every direction that is not zero, is
 * swept; duplicates, collinear points and 0 to 3 points are ordinary.
 *
 * An observer stops after each `attach` and looks at everything the proof says
 * about that step (page 2.3): which edges the new point saw (P1, P2), whether T
 * is a triangulation of the swept points (P3), and t + h = 2u-2 (P4).
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

static const point2 along_x = {1, 0};

/* ---- The observer. ---- */

typedef struct watcher {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
    point2 direction;
    uint32_t attached;
} watcher;

/* How many vertices the mesh has so far: each brings two triangles. */
static uint32_t
swept_so_far(const mesh *m)
{
    return m->triangles / 2 + 1;
}

/* Does p lie strictly right of the line from u to w? */
static bool
sees(const point2 *points, vertex_id p, vertex_id u, vertex_id w)
{
    return orient2d(points[u], points[w], points[p]) < 0;
}

/* The edges opposite p were hull edges and p saw them; the hull edges that p is
 * not on are still there, and p does not see them. */
static uint32_t
check_visible_edges(const mesh *m, const point2 *points, halfedge_id leaving)
{
    vertex_id p = mesh_origin(m, leaving);
    uint32_t seen = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (mesh_apex(m, e) != p || !mesh_in_triangle(m, e))
            continue;
        /* The triangle lies left of e, so the old hull edge is e's twin. */
        vertex_id u = mesh_dest(m, e), w = mesh_origin(m, e);
        CLAIM("fig3.P2", sees(points, p, u, w),
              "%u is joined to the edge %u %u, which it "
              "does not see",
              p, u, w);
        seen++;
    }
    halfedge_id e = leaving;
    do {
        vertex_id u = mesh_origin(m, e), w = mesh_dest(m, e);
        if (u != p && w != p)
            CLAIM("fig3.P2", !sees(points, p, u, w),
                  "%u sees the edge %u %u, and is not "
                  "joined to it",
                  p, u, w);
        e = mesh_hull_next(m, e);
    } while (e != leaving);
    return seen;
}

/* P1: the chain touches the vertex v before p, unless all points are in line. */
static void
check_touches_last(const mesh *m, vertex_id v, vertex_id p, uint32_t seen)
{
    bool collinear = !mesh_in_triangle(m, mesh_some_hull_edge(m));
    CLAIM("fig3.P1", (seen == 0) == collinear, "%u sees %u edges", p, seen);
    bool touches = false;
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        touches = touches || mesh_dest(m, e) == v;
        e = mesh_around(m, e);
    } while (e != first);
    CLAIM("fig3.P1", touches, "%u is not joined to %u, swept just before", p, v);
}

/* P3: the list is a triangulation of the vertices of the mesh so far. */
static void
check_invariant(const mesh *m, const point2 *points)
{
    uint32_t u = 0;
    point2 *swept = malloc(m->points * sizeof *swept);
    vertex_id *place = malloc(m->points * sizeof *place); /* vertex -> index in swept */
    triangle_list list = {0};
    verdict v = verdict_holds();
    for (vertex_id i = 0; i < m->points; i++)
        if (mesh_leaving(m, i) != NONE) {
            place[i] = u;
            swept[u++] = points[i];
        }
    tri_status status = mesh_triangles(m, &list);
    for (uint32_t t = 0; t < list.count; t++)
        for (int i = 0; i < 3; i++)
            list.corner[t][i] = place[list.corner[t][i]];
    uint32_t found = list.count;
    if (status == TRI_OK)
        status = is_triangulation(swept, u, list, &v);
    triangle_list_free(&list);
    free(place);
    free(swept);
    CLAIM("fig3.P3", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("fig3.P3", v);
    CLAIM("fig3.P3", u == swept_so_far(m), "%u vertices, %u swept", u, swept_so_far(m));
    uint32_t h = mesh_hull_size(m);
    CLAIM("fig3.P4", found + h == 2 * u - 2, "t = %u, h = %u, u = %u", found, h, u);
}

static int
see_attach(trace *self, const mesh *m, const trace_event *event)
{
    watcher *w = (watcher *)self;
    if (event->kind != TRACE_ATTACH)
        return 0;
    show(m);
    uint32_t seen = check_visible_edges(m, w->points, event->edge);
    vertex_id before = NONE; /* the vertex swept just before: the latest but p */
    for (vertex_id i = 0; i < m->points; i++)
        if (i != event->a && mesh_leaving(m, i) != NONE &&
            (before == NONE ||
             compare_along(w->direction, w->points[before], w->points[i]) < 0))
            before = i;
    check_touches_last(m, before, event->a, seen);
    check_invariant(m, w->points);
    w->attached++;
    return 0;
}

/* ---- The statements. ---- */

static void
every_step_keeps_the_invariant(const point2 *points, uint32_t n)
{
    watcher w = {
        .observer = {see_attach}, .points = points, .direction = random_direction()};
    tri_options options = tri_options_default();
    options.direction = w.direction;
    options.trace = &w.observer;
    mesh m;
    tri_status status = sweep_triangulate(points, n, &options, &m);
    CLAIM("fig3.P3", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("fig3.P3", mesh_check(&m));
    CLAIM("fig3.P3", w.attached + 2 == m.locations || m.locations < 2,
          "%u points attached, %u locations", w.attached, m.locations);
    mesh_free(&m);
}

/* P5: the hull is convex, and no point lies outside of it. */
static void
the_hull_is_convex(const point2 *points, uint32_t n)
{
    mesh m;
    CLAIM("fig3.P5", sweep_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    vertex_id *hull = malloc((n + 1) * sizeof *hull);
    uint32_t h = hull_vertices(&m, hull);
    bool flat = affine_dimension(points, n) < 2;
    CLAIM("fig3.P5", !flat || h == m.locations, "%u of %u on the line", h, m.locations);
    for (uint32_t i = 0; i < h && !flat; i++) {
        vertex_id u = hull[i], w = hull[(i + 1) % h];
        CLAIM("fig3.P5", u > hull[0] || i == 0, "%u is below %u", u, hull[0]);
        for (vertex_id p = 0; p < n; p++)
            CLAIM("fig3.P5", orient2d(points[u], points[w], points[p]) >= 0,
                  "%u lies right of the hull edge %u %u", p, u, w);
    }
    for (uint32_t i = 0; i + 2 < h && flat; i++) /* from one end to the other */
        CLAIM("fig3.P5",
              compare_along(along_x, points[hull[i]], points[hull[i + 1]]) ==
                  compare_along(along_x, points[hull[i + 1]], points[hull[i + 2]]),
              "the path turns back at %u", hull[i + 1]);
    free(hull);
    mesh_free(&m);
}

/* P6 and P7, as equations and bounds on counted questions. */
static void
the_costs_are_as_counted(const point2 *points, uint32_t n)
{
    vertex_id *order = malloc((n + 1) * sizeof *order);
    uint32_t u, levels = 0;
    while ((uint64_t)1 << levels < n)
        levels++;
    point2 d = random_direction();
    uint64_t before = predicate_count.compare_along;
    CLAIM("fig3.P7", sort_along(points, n, d, order, &u) == TRI_OK, "out of memory");
    uint64_t comparisons = predicate_count.compare_along - before;
    free(order);
    CLAIM("fig3.P7", comparisons <= 2 * (uint64_t)n * levels,
          "%llu comparisons", (unsigned long long)comparisons);

    mesh m;
    before = predicate_count.orient2d;
    CLAIM("fig3.P6", sweep_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    uint64_t tests = predicate_count.orient2d - before;
    uint32_t h = mesh_hull_size(&m);
    mesh_free(&m);
    CLAIM("fig3.P6", tests == (u > 2 ? 4 * (uint64_t)u - 6 - h : 0),
          "%llu tests for u = %u, h = %u", (unsigned long long)tests, u, h);
}

/* sort_along: a permutation of the distinct points, strictly increasing, and of
 * duplicates the lowest index. */
static void
the_order_is_right(const point2 *points, uint32_t n)
{
    vertex_id *order = malloc((n + 1) * sizeof *order);
    uint32_t u;
    point2 d = random_direction();
    CLAIM("E12", sort_along(points, n, d, order, &u) == TRI_OK, "out of memory");
    for (uint32_t i = 0; i + 1 < u; i++)
        CLAIM("E12", compare_along(d, points[order[i]], points[order[i + 1]]) < 0,
              "%u does not come before %u", order[i], order[i + 1]);
    for (vertex_id p = 0; p < n; p++) {
        bool found = false;
        for (uint32_t i = 0; i < u && !found; i++)
            found = compare_along(d, points[order[i]], points[p]) == 0 && order[i] <= p;
        CLAIM("E12", found, "the location of %u is lost, or has a higher index", p);
    }
    free(order);
}

/* ---- The errata of the section. ---- */

static void
e10_one_point_can_see_everything(void)
{
    enum { m = 40 };
    point2 points[m + 1];
    for (int i = 0; i < m; i++)
        points[i] = (point2){i, i * i};
    points[m] = (point2){m, 0};
    mesh K;
    CLAIM("E10", sweep_triangulate(points, m + 1, NULL, &K) == TRI_OK, "no mesh");
    uint32_t degree = 0, last = m;
    halfedge_id first = mesh_leaving(&K, last), e = first;
    do {
        degree += mesh_in_triangle(&K, e);
        e = mesh_around(&K, e);
    } while (e != first);
    mesh_free(&K);
    CLAIM("E10", degree == m - 1, "the last point sees %u edges", degree);
}

static void
e11_a_collinear_beginning(void)
{
    const point2 points[] = {{0, 0}, {0, 1}, {0, 2}, {1, 0}};
    CLAIM("E11", orient2d(points[0], points[1], points[2]) == 0,
          "v1 v2 v3 is a triangle");
    every_step_keeps_the_invariant(points, 4);
}

static void
e12_ties_matter(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {1, 2}, {1, 1}};
    mesh K; /* the first three, swept in the printed order */
    CLAIM("E12", sweep_triangulate(points, 3, NULL, &K) == TRI_OK, "no mesh");
    halfedge_id first = mesh_some_hull_edge(&K), e = first;
    bool seen = false;
    do {
        seen = seen || sees(points, 3, mesh_origin(&K, e), mesh_dest(&K, e));
        e = mesh_hull_next(&K, e);
    } while (e != first);
    mesh_free(&K);
    CLAIM("E12", !seen, "the fourth point sees an edge although x alone was sorted");
    every_step_keeps_the_invariant(points, 4);
}

/* The chain that p sees after (0,0), (1,1), (2,0), as the number of edges before
 * and after the last vertex. */
static void
e13_chain(point2 p, uint32_t before, uint32_t after)
{
    const point2 points[] = {{0, 0}, {1, 1}, {2, 0}, p};
    mesh K;
    CLAIM("E13", sweep_triangulate(points, 3, NULL, &K) == TRI_OK, "no mesh");
    halfedge_id last = mesh_some_hull_edge(&K);
    while (mesh_origin(&K, last) != 2)
        last = mesh_hull_next(&K, last);
    hull_chain q = hull_edges_seeing(&K, points, last, 3);
    for (halfedge_id e = last; e != q.first; e = mesh_hull_prev(&K, e))
        before--;
    for (halfedge_id e = last; e != q.end; e = mesh_hull_next(&K, e))
        after--;
    mesh_free(&K);
    CLAIM("E13", before == 0 && after == 0, "another chain from (%g,%g)", p.x, p.y);
}

static void
e13_either_side_of_the_last_vertex(void)
{
    e13_chain((point2){3, -5}, 1, 0); /* only the edge that ends there */
    e13_chain((point2){3, 5}, 0, 2);  /* only edges from there on */
    e13_chain((point2){3, -0.5}, 1, 1);
}

/* ---- Refusals, cancelling, and memory that runs out. ---- */

static int
see_and_stop(trace *self, const mesh *m, const trace_event *event)
{
    (void)self;
    (void)event;
    return m->triangles >= 10;
}

static void
a_sweep_can_be_stopped_and_refused(void)
{
    point2 points[50];
    for (int i = 0; i < 50; i++)
        points[i] = (point2){i % 7, i};
    trace stop = {see_and_stop};
    tri_options options = tri_options_default();
    options.trace = &stop;
    mesh m;
    CLAIM("fig3.P3", sweep_triangulate(points, 50, &options, &m) == TRI_CANCELLED &&
          m.halfedge == NULL, "the observer could not stop the sweep");
    options.trace = NULL;
    options.direction = (point2){0, 0};
    CLAIM("fig3.P3", sweep_triangulate(points, 50, &options, &m) == TRI_BAD_OPTION,
          "a zero direction was accepted");
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = sweep_triangulate(points, 50, NULL, &m);
        memory_fail_at(0);
        CLAIM("fig3.P3", status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
              m.halfedge == NULL), "allocation %lu: %s", k, tri_status_text(status));
    }
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Figure 3: LineSweep triangulates, step by step");
    test_random("the invariant at every step", every_step_keeps_the_invariant, 2000,
                40);
    test_near_degenerate("the invariant at every step", every_step_keeps_the_invariant,
                         2000, 25);
    test_grid_subsets("the invariant at every step", every_step_keeps_the_invariant, 3);
    test_random("the hull", the_hull_is_convex, 2000, 60);
    test_near_degenerate("the hull", the_hull_is_convex, 2000, 40);
    test_grid_subsets("the hull", the_hull_is_convex, 3);
    test_random("the costs", the_costs_are_as_counted, 2000, 300);
    test_near_degenerate("the costs", the_costs_are_as_counted, 1000, 100);
    test_random("the order", the_order_is_right, 2000, 60);
    test_near_degenerate("the order", the_order_is_right, 2000, 60);
    test_run("E10: one point can see everything", e10_one_point_can_see_everything);
    test_run("E11: a collinear beginning", e11_a_collinear_beginning);
    test_run("E12: ties matter", e12_ties_matter);
    test_run("E13: either side", e13_either_side_of_the_last_vertex);
    test_run("stopped, refused, out of memory", a_sweep_can_be_stopped_and_refused);
    return test_end((test_minima){.trials = 10000, .largest_n = 250, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
