/* Figure 12, IncrementalFlip: after each point the triangulation is Delaunay, and
 * the flips that made it so are as many as the new vertex has edges, less three.
 *
 * Hypotheses: none. Every finite input in every order; points on edges, on hull
 * edges, in line with them, duplicates, collinear beginnings and 0 to 3 points are
 * ordinary.
 *
 * An observer looks at each place that is found, each split and each flip. What it
 * sees when the next place has been found is D after a whole round of the loop.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

/* ---- The observer. ---- */

typedef struct watcher {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
    vertex_id p;    /* inserted last; NONE before the third point */
    uint32_t begun; /* the degree of p after its split */
    uint32_t flips; /* since then */
    uint32_t pops;
    uint32_t inserted;
    bool thorough; /* is each D_i to be certified? */
} watcher;

/* The mesh as if there were no more points to come. */
static mesh
mesh_so_far(const mesh *m)
{
    mesh now = *m;
    now.locations = m->triangles / 2 + 1;
    return now;
}

/* P4: the triangles are a Delaunay triangulation of the vertices so far. */
static void
check_delaunay_so_far(const mesh *m, const point2 *points)
{
    uint32_t u = 0;
    point2 *present = malloc(m->points * sizeof *present);
    vertex_id *name =
        malloc(m->points * sizeof *name); /* vertex -> its index there */
    triangle_list list = {0};
    verdict v = verdict_holds();
    for (vertex_id i = 0; i < m->points; i++)
        if (mesh_leaving(m, i) != NONE) {
            name[i] = u;
            present[u++] = points[i];
        }
    tri_status status = mesh_triangles(m, &list);
    for (uint32_t t = 0; t < list.count; t++)
        for (int i = 0; i < 3; i++)
            list.corner[t][i] = name[list.corner[t][i]];
    if (status == TRI_OK)
        status = is_delaunay(present, u, list, &v);
    triangle_list_free(&list);
    free(name);
    free(present);
    CLAIM("fig12.P4", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("fig12.P4", v);
}

/* What must be true when the insertion of w->p has ended. */
static void
check_insertion(const mesh *m, watcher *w)
{
    if (w->p == NONE)
        return;
    uint32_t d = degree(m, w->p);
    CLAIM("fig12.P5", w->flips == d - w->begun, "%u flips made degree %u of %u",
          w->flips, d, w->begun);
    CLAIM("fig12.P6", w->pops <= w->begun + 2 * w->flips,
          "%u edges were popped for %u flips", w->pops, w->flips);
    if (!w->thorough)
        return;
    mesh now = mesh_so_far(m);
    claim_verdict("fig12.P2", mesh_check(&now));
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        CLAIM("fig12.P4", is_locally_delaunay_at_infinity(m, w->points, e),
              "edge %u %u is not locally Delaunay", mesh_origin(m, e),
              mesh_dest(m, e));
    check_delaunay_so_far(m, w->points);
}

/* P3: both new triangles have p as a corner, and none is flat or turned over. */
static void
check_flip(const watcher *w, const trace_event *f)
{
    const point2 *at = w->points;
    CLAIM("fig12.P3", f->c == w->p || f->d == w->p, "%u %u became %u %u without %u",
          f->a, f->b, f->c, f->d, w->p);
    CLAIM("fig12.P3", f->c != GHOST && f->d != GHOST, "%u was joined to infinity",
          w->p);
    CLAIM("fig12.P3", f->a == GHOST || orient2d(at[f->d], at[f->c], at[f->a]) > 0,
          "%u %u %u is flat", f->d, f->c, f->a);
    CLAIM("fig12.P3", f->b == GHOST || orient2d(at[f->c], at[f->d], at[f->b]) > 0,
          "%u %u %u is flat", f->c, f->d, f->b);
}

/* P2: what the split has made, before any flip. */
static void
check_split(const mesh *m, watcher *w, vertex_id p)
{
    mesh now = mesh_so_far(m);
    claim_verdict("fig12.P2", mesh_check(&now));
    w->p = p;
    w->begun = degree(m, p);
    CLAIM("fig12.P2", w->begun >= 2 && w->begun <= 4, "degree %u", w->begun);
    w->flips = w->pops = 0;
    w->inserted++;
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        vertex_id b = mesh_dest(m, e), c = mesh_apex(m, e);
        CLAIM("fig12.P2",
              b == GHOST || c == GHOST ||
                  orient2d(w->points[p], w->points[b], w->points[c]) > 0,
              "%u %u %u is flat", p, b, c);
        e = mesh_around(m, e);
    } while (e != first);
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    watcher *w = (watcher *)self;
    w->flips += event->kind == TRACE_FLIP;
    w->pops += event->kind == TRACE_POP;
    if (event->kind == TRACE_LOCATE)
        check_insertion(m, w);
    else if (event->kind == TRACE_SPLIT)
        check_split(m, w, event->a);
    else if (event->kind == TRACE_FLIP)
        check_flip(w, event);
    return 0;
}

static watcher
new_watcher(const point2 *points, bool thorough)
{
    return (watcher){
        .observer = {see}, .points = points, .p = NONE, .thorough = thorough};
}

/* ---- The statements. ---- */

static void
check_delaunay(const mesh *m, const point2 *points)
{
    triangle_list list;
    verdict v;
    claim_verdict("fig12.P4", mesh_check(m));
    CLAIM("fig12.P4", mesh_triangles(m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM("fig12.P4", is_delaunay(points, m->points, list, &v) == TRI_OK,
          "out of memory");
    triangle_list_free(&list);
    claim_verdict("fig12.P4", v);
}

static void
insert_watched(const point2 *points, uint32_t n, tri_locator kind, bool thorough)
{
    watcher w = new_watcher(points, thorough);
    tri_options options = tri_options_default();
    options.locator = kind;
    options.seed = random_bits(test_random_source());
    options.trace = &w.observer;
    mesh m;
    tri_status status = incremental_triangulate(points, n, &options, &m);
    CLAIM("fig12.P4", status == TRI_OK, "%s", tri_status_text(status));
    CLAIM("fig12.P4", m.locations < 2 || w.inserted == m.locations - 2,
          "%u of %u inserted", w.inserted, m.locations);
    check_insertion(&m, &w);
    check_delaunay(&m, points);
    mesh_free(&m);
}

/* Every step, with one of the locators. */
static void
every_step_is_delaunay(const point2 *points, uint32_t n)
{
    insert_watched(points, n, (tri_locator)random_below(test_random_source(), 4),
                   true);
}

/* The result, with all locators. */
static void
all_locators_give_delaunay(const point2 *points, uint32_t n)
{
    for (int kind = 0; kind < 4; kind++)
        insert_watched(points, n, (tri_locator)kind, false);
}

static void
some_locator_gives_delaunay(const point2 *points, uint32_t n)
{
    insert_watched(points, n, (tri_locator)random_below(test_random_source(), 4),
                   false);
}

static void
the_biased_order_gives_delaunay(const point2 *points, uint32_t n)
{
    watcher w = new_watcher(points, false);
    tri_options options = tri_options_default();
    options.seed = random_bits(test_random_source());
    options.trace = &w.observer;
    mesh m;
    tri_status status = biased_triangulate(points, n, &options, &m);
    CLAIM("fig12.P4", status == TRI_OK, "%s", tri_status_text(status));
    check_insertion(&m, &w);
    check_delaunay(&m, points);
    mesh_free(&m);
}

/* P1: a far point on the outer side of hull edge xy: is its circle's inside, among
 * points of a small grid, the outer side? */
static void
a_far_point_is_like_infinity(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    point2 *points = whole_points(NULL, n, 100);
    for (uint32_t i = 0; i + 2 < n; i++) {
        point2 x = points[i], y = points[i + 1], q = points[i + 2];
        double far = 0x1p40;
        point2 z = {x.x + far * (y.y - x.y),
                    x.y - far * (y.x - x.x)}; /* right of xy */
        if ((x.x == y.x && x.y == y.y) || orient2d(x, y, q) == 0)
            continue;
        const point2 corner[3] = {y, x, q};
        CLAIM("fig12.P1",
              (incircle(y, x, z, q) > 0) == circle_contains(corner, 0, 1, GHOST, 2),
              "(%g,%g) and the circle of (%g,%g), (%g,%g) and a far point", q.x,
              q.y, x.x, x.y, y.x, y.y);
        CLAIM("fig12.P1",
              circle_contains(corner, 0, 1, GHOST, 2) ==
                      circle_contains(corner, GHOST, 0, 1, 2) &&
                  circle_contains(corner, 1, GHOST, 0, 2) ==
                      circle_contains(corner, 0, 1, GHOST, 2),
              "GHOST in another corner");
    }
    free(points);
}

/* ---- E42: on an edge, and duplicates. ---- */

/* The degree of the last of the points after its split, when they are inserted in
 * the order of their indices. */
static uint32_t
degree_after_split(const point2 *points, uint32_t n)
{
    const vertex_id order[] = {0, 1, 2, 3, 4, 5};
    watcher w = new_watcher(points, true);
    tri_options options = tri_options_default();
    options.order = order;
    options.trace = &w.observer;
    mesh m;
    CLAIM("E42", incremental_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    CLAIM("E42", w.p == m.locations - 1, "the last split is that of %u", w.p);
    mesh_free(&m);
    return w.begun;
}

static void
e42_on_an_edge_the_degree_begins_at_four(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {4, 4}, {2, 2}, {2, 2}};
    const point2 on_hull[] = {{0, 0}, {4, 0}, {0, 4}, {2, 0}};
    const point2 on_path[] = {{0, 0}, {4, 4}, {3, 3}},
                 beyond[] = {{0, 0}, {3, 3}, {4, 4}};
    uint32_t seen = degree_after_split(points, 4);
    CLAIM("E42", seen == 3, "outside the hull: degree %u", seen);
    seen = degree_after_split(points, 5);
    CLAIM("E42", seen == 4, "on a diagonal: degree %u", seen);
    seen = degree_after_split(points, 6);
    CLAIM("E42", seen == 4, "a copy comes last: degree %u", seen);
    seen = degree_after_split(on_hull, 4);
    CLAIM("E42", seen == 4, "on a hull edge: degree %u", seen);
    seen = degree_after_split(on_path, 3);
    CLAIM("E42", seen == 4, "on a path: degree %u", seen);
    seen = degree_after_split(beyond, 3);
    CLAIM("E42", seen == 2, "beyond the end of a path: degree %u", seen);
}

/* ---- Orders, refusals, and memory that runs out. ---- */

static void
some_points(point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){i % 7, i * i % 11};
}

/* Sees that the points come in a given order, some of them left out. */
typedef struct follower {
    trace observer; /* first: see lib/trace.h */
    const vertex_id *order;
    uint32_t next, splits;
} follower;

static int
see_order(trace *self, const mesh *m, const trace_event *event)
{
    follower *f = (follower *)self;
    if (event->kind != TRACE_SPLIT)
        return 0;
    while (f->next < m->points && f->order[f->next] != event->a)
        f->next++;
    CLAIM("fig12.P4", f->next < m->points, "%u comes too late", event->a);
    f->splits++;
    return 0;
}

static void
a_given_order_is_followed(void)
{
    enum { n = 50 };
    point2 points[n];
    vertex_id order[n];
    some_points(points, n);
    for (uint32_t i = 0; i < n; i++)
        order[i] = (i * 17 + 3) % n;
    follower f = {.observer = {see_order}, .order = order};
    tri_options options = tri_options_default();
    options.order = order;
    mesh m;
    options.trace = &f.observer;
    CLAIM("fig12.P4", incremental_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    CLAIM("fig12.P4", f.splits == m.locations - 2, "%u points were split in",
          f.splits);
    mesh_free(&m);
    options.trace = NULL;
    order[7] = order[8];
    CLAIM("fig12.P4",
          incremental_triangulate(points, n, &options, &m) == TRI_BAD_OPTION &&
              m.halfedge == NULL,
          "an order that names a point twice was accepted");
    order[7] = n;
    CLAIM("fig12.P4",
          incremental_triangulate(points, n, &options, &m) == TRI_BAD_OPTION,
          "an order that names no point was accepted");
    options.order = NULL;
    options.locator = (tri_locator)4;
    CLAIM("fig12.P4",
          incremental_triangulate(points, n, &options, &m) == TRI_BAD_OPTION,
          "a fifth locator was accepted");
}

/* Stops when 20 triangles are there. */
typedef struct stopper {
    trace observer; /* first: see lib/trace.h */
    uint64_t asked; /* until then */
} stopper;

static uint64_t
tests_asked(void)
{
    return predicate_count.orient2d + predicate_count.incircle;
}

static int
see_and_stop(trace *self, const mesh *m, const trace_event *event)
{
    (void)event;
    ((stopper *)self)->asked = tests_asked();
    return m->triangles >= 20;
}

static void
it_can_be_stopped_and_memory_may_run_out(void)
{
    enum { n = 60 };
    point2 points[n];
    vertex_id order[n];
    some_points(points, n);
    for (uint32_t i = 0; i < n; i++)
        order[i] = n - 1 - i;
    for (int kind = 0; kind < 5; kind++) {
        tri_options options = tri_options_default();
        options.locator = (tri_locator)(kind % 4);
        options.order = kind == 0 ? order : NULL;
        stopper stop = {{see_and_stop}, 0};
        options.trace = &stop.observer;
        mesh m;
        tri_status stopped = (kind < 4 ? incremental_triangulate
                                       : biased_triangulate)(points, n, &options, &m);
        uint64_t more = tests_asked() - stop.asked; /* one round of the loop at most */
        CLAIM("fig12.P4",
              stopped == TRI_CANCELLED && m.halfedge == NULL && more < 2 * n,
              "stopped with 20 triangles, it asked %u more tests", (unsigned)more);
        options.trace = NULL;
        tri_status status = TRI_OUT_OF_MEMORY;
        unsigned long k = 1;
        for (; status == TRI_OUT_OF_MEMORY; k++) {
            memory_fail_at(k);
            status = (kind < 4 ? incremental_triangulate
                               : biased_triangulate)(points, n, &options, &m);
            memory_fail_at(0);
            CLAIM("fig12.P4", status == TRI_OK || m.halfedge == NULL,
                  "allocation %lu", k);
        }
        CLAIM("fig12.P4", status == TRI_OK && k > 5, "allocation %lu: %s", k,
              tri_status_text(status));
        check_delaunay(&m, points);
        mesh_free(&m);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Figure 12: IncrementalFlip is Delaunay after each point");
    test_random("every step", every_step_is_delaunay, 1500, 30);
    test_near_degenerate("every step", every_step_is_delaunay, 2000, 20);
    test_grid_subsets("every step", every_step_is_delaunay, 3);
    test_random("all locators", all_locators_give_delaunay, 500, 150);
    test_near_degenerate("all locators", all_locators_give_delaunay, 1500, 40);
    test_grid_subsets("all locators", all_locators_give_delaunay, 3);
    test_grid_subsets("some locator", some_locator_gives_delaunay, 4);
    test_random("the biased order", the_biased_order_gives_delaunay, 500, 150);
    test_near_degenerate("the biased order", the_biased_order_gives_delaunay, 1000,
                         40);
    test_random("a far point", a_far_point_is_like_infinity, 500, 40);
    test_run("E42: on an edge", e42_on_an_edge_the_degree_begins_at_four);
    test_run("orders", a_given_order_is_followed);
    test_run("stopped, out of memory", it_can_be_stopped_and_memory_may_run_out);
    return test_end((test_minima){.trials = 60000,
                                  .largest_n = 140,
                                  .zeros = 100000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
