/* Figure 10, LawsonFlip: ends, with a Delaunay triangulation, after at most C(n,2)
 * flips, from any triangulation and in any order of the stack.
 *
 * Hypotheses: every edge that is not locally Delaunay is on the stack at first.
 *
 * An observer looks at every edge that is popped and at every flip.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

typedef struct watcher {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
    edge_stack *L;
    bool shuffled;    /* take the edges in a random order? */
    bool only_counts; /* ask nothing, so that the questions asked are L's? */
    bool *gone;       /* a * n + b -> was edge ab flipped away? */
    uint64_t flips, pops;
} watcher;

/* P5: each edge that is not locally Delaunay is on the stack, or was just popped; and
 * what was popped is an edge of the triangulation as it is now. */
static void
check_stack(const mesh *m, const watcher *w, halfedge_id popped)
{
    CLAIM("E35",
          mesh_in_triangle(m, popped) || mesh_in_triangle(m, mesh_twin(m, popped)),
          "half-edge %u is a side of no triangle", popped);
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        halfedge_id f = mesh_twin(m, e);
        if (!mesh_is_interior(m, e) || e == popped || f == popped)
            continue;
        bool on_stack = w->L->on_stack[e] || w->L->on_stack[f];
        CLAIM("fig10.P5", on_stack || is_locally_delaunay(m, w->points, e),
              "edge %u %u is forgotten", mesh_origin(m, e), mesh_dest(m, e));
    }
}

/* P1 to P4: what the proof says of the flip of ab to cd. */
static void
check_flip(const mesh *m, watcher *w, const trace_event *f)
{
    const point2 *p = w->points;
    point2 a = p[f->a], b = p[f->b], c = p[f->c], d = p[f->d];
    CLAIM("fig10.P1", orient2d(d, c, a) > 0 && orient2d(c, d, b) > 0,
          "abc, bad with ab = %u %u, cd = %u %u is not convex", f->a, f->b, f->c, f->d);
    CLAIM("fig10.P2", incircle(d, c, a, b) < 0, "the new edge %u %u is not locally "
          "Delaunay", f->c, f->d);
    CLAIM("fig10.P3", incircle(a, b, c, d) > 0, "the flip of %u %u does not lower the "
          "surface", f->a, f->b);
    uint32_t n = m->points;
    w->gone[f->a * n + f->b] = w->gone[f->b * n + f->a] = true;
    CLAIM("fig10.P4", !w->gone[f->c * n + f->d], "edge %u %u comes back", f->c, f->d);
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    watcher *w = (watcher *)self;
    w->pops += event->kind == TRACE_POP;
    w->flips += event->kind == TRACE_FLIP;
    if (w->only_counts)
        return 0;
    show(m);
    if (event->kind == TRACE_POP)
        check_stack(m, w, event->edge);
    if (event->kind == TRACE_FLIP) {
        check_flip(m, w, event);
        if (w->shuffled && w->L->size > 1) { /* any order will do */
            uint32_t i = random_below(test_random_source(), w->L->size);
            halfedge_id top = w->L->entry[w->L->size - 1];
            w->L->entry[w->L->size - 1] = w->L->entry[i];
            w->L->entry[i] = top;
        }
    }
    return 0;
}

/* Runs Figure 10 on all edges of *m under the eyes of w. */
static void
run_watched(mesh *m, const point2 *points, watcher *w)
{
    edge_stack L;
    w->gone = calloc((size_t)m->points * m->points + 1, sizeof *w->gone);
    CLAIM("fig10.P6", w->gone != NULL && edge_stack_init(&L, m) == TRI_OK, "no memory");
    push_all_edges(&L);
    uint64_t interior = 0, before = predicate_count.incircle;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        interior += mesh_is_interior(m, e);
    interior /= 2;
    CLAIM("fig10.P6", L.size == interior, "%u entries for %llu edges", L.size,
          (unsigned long long)interior);
    w->observer.see = see;
    w->points = points;
    w->L = &L;
    m->trace = &w->observer;
    lawson_flip(&L, points);
    m->trace = NULL;
    uint64_t tests = predicate_count.incircle - before;
    edge_stack_free(&L);
    free(w->gone);
    CLAIM("fig10.P6", w->pops <= interior + 4 * w->flips, "%llu edges popped",
          (unsigned long long)w->pops);
    CLAIM("fig10.P6", !w->only_counts || tests <= w->pops,
          "%llu incircle tests for %llu "
          "edges",
          (unsigned long long)tests, (unsigned long long)w->pops);
}

static void
check_delaunay(const mesh *m, const point2 *points)
{
    triangle_list list;
    verdict v;
    claim_verdict("fig10.P5", mesh_check(m));
    CLAIM("fig10.P5", mesh_triangles(m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM("fig10.P5", is_delaunay(points, m->points, list, &v) == TRI_OK,
          "out of memory");
    triangle_list_free(&list);
    claim_verdict("fig10.P5", v);
}

static void
every_flip_is_as_proved(const point2 *points, uint32_t n)
{
    mesh m;
    random_triangulation(points, n, &m);
    watcher w = {.shuffled = random_below(test_random_source(), 2) == 0};
    run_watched(&m, points, &w);
    uint64_t u = m.locations;
    CLAIM("fig10.P4", w.flips <= u * (u - 1) / 2 || u == 0, "%llu flips",
          (unsigned long long)w.flips);
    check_delaunay(&m, points);
    mesh_free(&m);
}

/* E37: from any triangulation to any other, through the Delaunay triangulation,
 * takes at most n(n-1) flips. Here: there, and so back by the same flips. */
static void
two_triangulations_are_near(const point2 *points, uint32_t n)
{
    uint64_t flips = 0;
    for (int which = 0; which < 2; which++) {
        mesh m;
        random_triangulation(points, n, &m);
        watcher w = {.only_counts = true};
        run_watched(&m, points, &w);
        flips += w.flips;
        mesh_free(&m);
    }
    CLAIM("E37", n == 0 || flips <= (uint64_t)n * (n - 1), "%llu flips for %u points",
          (unsigned long long)flips, n);
}

/* P6, on larger inputs. */
static void
the_cost_is_as_counted(const point2 *points, uint32_t n)
{
    mesh m;
    random_triangulation(points, n, &m);
    watcher w = {.only_counts = true};
    run_watched(&m, points, &w);
    mesh_free(&m);
}

/* P7: (i,0) and (m+i,1), swept upward: exactly m^2 flips in any order. */
static void
the_ladder_needs_m_squared_flips(void)
{
    for (uint32_t m = 1; m <= 30; m++) {
        for (int shuffled = 0; shuffled < 2; shuffled++) {
            uint32_t n = 2 * (m + 1);
            point2 *points = malloc(n * sizeof *points);
            for (uint32_t i = 0; i <= m; i++) {
                points[i] = (point2){i, 0};
                points[m + 1 + i] = (point2){m + i, 1};
            }
            tri_options up = tri_options_default();
            up.direction = (point2){0, 1};
            mesh K;
            CLAIM("fig10.P7", sweep_triangulate(points, n, &up, &K) == TRI_OK,
                  "no mesh");
            watcher w = {.shuffled = shuffled};
            run_watched(&K, points, &w);
            check_delaunay(&K, points);
            free(points);
            mesh_free(&K);
            CLAIM("fig10.P7", w.flips == (uint64_t)m * m, "%llu flips for m = %u",
                  (unsigned long long)w.flips, m);
        }
    }
}

/* ---- lawson_triangulate as a whole. ---- */

static void
lawson_gives_delaunay(const point2 *points, uint32_t n)
{
    mesh m;
    tri_status status = lawson_triangulate(points, n, NULL, &m);
    CLAIM("fig10.P5", status == TRI_OK, "%s", tri_status_text(status));
    check_delaunay(&m, points);
    mesh_free(&m);
}

static int
stop_at_the_third_flip(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    watcher *w = (watcher *)self;
    w->flips += event->kind == TRACE_FLIP;
    return w->flips == 3;
}

static void
it_can_be_stopped_and_memory_may_run_out(void)
{
    point2 points[30];
    for (int i = 0; i < 30; i++)
        points[i] = (point2){i % 6 + 0.1 * (i / 6), i / 6};
    watcher w = {.observer = {stop_at_the_third_flip}};
    tri_options options = tri_options_default();
    options.trace = &w.observer;
    mesh m;
    CLAIM("fig10.P5",
          lawson_triangulate(points, 30, &options, &m) == TRI_CANCELLED &&
              m.halfedge == NULL && w.flips == 3,
          "%llu flips", (unsigned long long)w.flips);
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = lawson_triangulate(points, 30, NULL, &m);
        memory_fail_at(0);
        CLAIM("fig10.P5", status == TRI_OK || m.halfedge == NULL, "allocation %lu", k);
    }
    CLAIM("fig10.P5", status == TRI_OK, "%s", tri_status_text(status));
    triangle_list list;
    verdict v;
    CLAIM("fig10.P5", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    mesh_free(&m);
    status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = is_delaunay(points, 30, list, &v);
        memory_fail_at(0);
    }
    triangle_list_free(&list);
    CLAIM("fig10.P5", status == TRI_OK && v.holds, "%s", tri_status_text(status));
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Figure 10: LawsonFlip ends, and is Delaunay then");
    test_random("every flip is as proved", every_flip_is_as_proved, 2000, 25);
    test_near_degenerate("every flip is as proved", every_flip_is_as_proved, 2000, 20);
    test_grid_subsets("every flip is as proved", every_flip_is_as_proved, 3);
    test_random("the cost", the_cost_is_as_counted, 1000, 60);
    test_near_degenerate("the cost", the_cost_is_as_counted, 500, 30);
    test_random("E37: n(n-1) flips", two_triangulations_are_near, 1000, 40);
    test_grid_subsets("Lawson's result", lawson_gives_delaunay, 4);
    test_random("Lawson's result", lawson_gives_delaunay, 1000, 200);
    test_run("the ladder", the_ladder_needs_m_squared_flips);
    test_run("stopped, out of memory", it_can_be_stopped_and_memory_may_run_out);
    return test_end((test_minima){.trials = 50000, .largest_n = 150, .zeros = 100000,
                                  .expansions = 1000, .wide = 1000});
}
