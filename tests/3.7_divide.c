/* Section 3.7: divided, triangulated and merged, the points are Delaunay triangulated.
 *
 * Hypotheses: none. Every finite input, along every direction, with both ways to cut;
 * duplicates, collinear points and 0 to 3 points are ordinary.
 *
 * The merge is called here on parts of all sizes, not only on halves. An observer
 * looks at the first edge, at every triangle that goes and at every one that comes.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>
#include <string.h>

/* The points in order along d; the caller frees them. */
static vertex_id *
in_order(const point2 *points, uint32_t n, point2 d, uint32_t *u)
{
    vertex_id *L = malloc((n + 1) * sizeof *L);
    CLAIM("sec3.7.P6", L != NULL && sort_along(points, n, d, L, u) == TRI_OK,
          "no memory");
    return L;
}

/* ---- A merge, watched. ---- */

/* What is merged: L[0 .. left-1] and L[left .. count-1], in order along d. Their
 * triangles have the numbers from `first` on. */
typedef struct watcher {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
    point2 d;
    const vertex_id *L;
    uint32_t left, count, first;
    uint32_t bridges, gone, new; /* edges joined, triangles taken away and made */
} watcher;

static bool
is_left(const watcher *w, vertex_id p)
{
    return compare_along(w->d, w->points[p], w->points[w->L[w->left]]) < 0;
}

/* P1: every point lies left of ab, or on the line but not between the two. */
static void
check_tangent(const watcher *w, vertex_id a, vertex_id b)
{
    CLAIM("sec3.7.P1", is_left(w, a) && !is_left(w, b), "%u %u does not join the two",
          a, b);
    point2 from = w->points[a], to = w->points[b];
    for (uint32_t i = 0; i < w->count; i++) {
        point2 p = w->points[w->L[i]];
        int side = orient2d(from, to, p);
        CLAIM("sec3.7.P1", side >= 0, "%u lies below %u %u", w->L[i], a, b);
        CLAIM("sec3.7.P1", side > 0 || compare_along(w->d, p, from) <= 0 ||
              compare_along(w->d, to, p) <= 0, "%u lies between %u and %u",
              w->L[i], a, b);
    }
}

/* Which of the points lies strictly inside the circle of a, b, c? */
static vertex_id
inside_circle(const watcher *w, vertex_id a, vertex_id b, vertex_id c)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (incircle(w->points[a], w->points[b], w->points[c],
                     w->points[w->L[i]]) > 0)
            return w->L[i];
    return NONE;
}

/* P3: a triangle that goes lies on one side, and its circle contains a point of the
 * other side. P5: one that comes has points of both sides, and an empty circle. */
static void
check_flip(watcher *w, const trace_event *f)
{
    bool goes = f->d == GHOST;
    CLAIM("sec3.7.P8", goes || f->b == GHOST, "%u %u, an inner edge, is flipped",
          f->a, f->b);
    if (goes) {
        w->gone++;
        bool left = is_left(w, f->a);
        vertex_id p = inside_circle(w, f->a, f->b, f->c);
        CLAIM("sec3.7.P3", left == is_left(w, f->b) && left == is_left(w, f->c),
              "%u %u %u joins the two sides and goes", f->a, f->b, f->c);
        CLAIM("sec3.7.P3", p != NONE && is_left(w, p) != left,
              "%u %u %u goes and is Delaunay", f->a, f->b, f->c);
    } else {
        w->new++;
        const point2 *p = w->points;
        vertex_id within = inside_circle(w, f->d, f->c, f->a);
        CLAIM("sec3.7.P5", is_left(w, f->d) != is_left(w, f->c),
              "the new edge %u %u is on one side", f->d, f->c);
        CLAIM("sec3.7.P5", orient2d(p[f->d], p[f->c], p[f->a]) > 0 && within == NONE,
              "%u lies in the circle of the new triangle %u %u %u", within, f->d, f->c,
              f->a);
    }
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    watcher *w = (watcher *)self;
    if (event->kind == TRACE_BRIDGE) {
        w->bridges++;
        check_tangent(w, event->a, event->b);
    } else if (event->kind == TRACE_FLIP) {
        check_flip(w, event);
    }
    CLAIM("sec3.7.P11", mesh_triangle_of(event->edge) >= w->first &&
          mesh_triangle_of(mesh_twin(m, event->edge)) >= w->first,
          "half-edge %u lies in an older triangle than %u", event->edge, w->first);
    return 0;
}

/* How many hull edges has the triangulation of v? Requires: v lies on its hull. */
static uint32_t
hull_size_at(const mesh *m, vertex_id v)
{
    halfedge_id first = mesh_leaving(m, v), e;
    while (!mesh_is_hull_edge(m, first))
        first = mesh_around(m, first);
    uint32_t size = 0;
    for (e = first; size == 0 || e != first; e = mesh_hull_next(m, e))
        size++;
    return size;
}

/* P6: triangles number `first` and up are a Delaunay triangulation of
 * L[0 .. count-1]. */
static void
check_part(const mesh *m, const watcher *w)
{
    point2 *points = malloc(w->count * sizeof *points);
    vertex_id *place = malloc((m->points + 1) * sizeof *place);
    triangle_list list = {0};
    verdict v = verdict_holds();
    for (uint32_t i = 0; i < w->count; i++) {
        points[i] = w->points[w->L[i]];
        place[w->L[i]] = i;
    }
    list.corner = malloc((m->triangles + 1) * sizeof *list.corner);
    for (halfedge_id e = 3 * w->first; e < mesh_halfedges(m); e += 3) {
        if (!mesh_in_triangle(m, e))
            continue;
        vertex_id *corner = list.corner[list.count++];
        corner[0] = place[mesh_origin(m, e)];
        corner[1] = place[mesh_dest(m, e)];
        corner[2] = place[mesh_apex(m, e)];
    }
    tri_status status = is_delaunay(points, w->count, list, &v);
    free(list.corner);
    free(place);
    free(points);
    CLAIM("sec3.7.P6", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("sec3.7.P6", v);
}

/* P2, P8 and P9: the bounds of the page for one merge, on counted questions. The
 * observer must not have asked any. */
typedef struct cost {
    uint32_t hull; /* hull edges before, left and right together */
    uint64_t orient2d, incircle;
} cost;

static void
check_cost(const watcher *w, cost before, uint32_t hull_after, uint64_t tangent)
{
    uint64_t orient = predicate_count.orient2d - before.orient2d;
    uint64_t circle = predicate_count.incircle - before.incircle;
    uint64_t k = w->new, d = w->gone, u = w->count;
    CLAIM("sec3.7.P2", tangent <= 2 * (uint64_t)before.hull + 2,
          "%u tests for the tangent", (unsigned)tangent);
    CLAIM("sec3.7.P8", k + hull_after == d + before.hull + 2,
          "%u new triangles, %u gone, %u and %u hull edges", w->new, w->gone,
          before.hull, hull_after);
    CLAIM("sec3.7.P9", orient == tangent + 2 * (k + 1) + d, "%u orientation tests",
          (unsigned)orient);
    CLAIM("sec3.7.P9", circle <= 3 * k + d, "%u incircle tests", (unsigned)circle);
    CLAIM("sec3.7.P9", k + d <= 4 * u && orient <= 8 * u && circle <= 8 * u,
          "%u vertices, %u flips, %u orientation and %u incircle tests", (unsigned)u,
          (unsigned)(k + d), (unsigned)orient, (unsigned)circle);
}

/* The tests that the walk to the tangent asks, by a walk that changes nothing. */
static uint64_t
tangent_tests(const mesh *m, const point2 *points, vertex_id v, vertex_id w)
{
    halfedge_id left = mesh_leaving(m, v), right = mesh_leaving(m, w);
    while (!mesh_is_hull_edge(m, left))
        left = mesh_around(m, left);
    while (!mesh_is_hull_edge(m, right))
        right = mesh_around(m, right);
    uint64_t before = predicate_count.orient2d;
    lower_tangent(m, points, left, right);
    return predicate_count.orient2d - before;
}

static int
see_counts(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    watcher *w = (watcher *)self;
    w->bridges += event->kind == TRACE_BRIDGE;
    w->gone += event->kind == TRACE_FLIP && event->d == GHOST;
    w->new += event->kind == TRACE_FLIP && event->b == GHOST;
    return 0;
}

/* ---- Dividing, watched. ---- */

typedef struct plan {
    const point2 *points;
    point2 d;
    bool halves; /* divide in the middle, as divide.c does? */
    bool counts; /* look at the costs, not at the geometry? */
} plan;

static void
merge_watched(mesh *m, const plan *p, const vertex_id *L, uint32_t left,
              uint32_t count, uint32_t first)
{
    watcher w = {.observer = {p->counts ? see_counts : see}, .points = p->points,
                 .d = p->d, .L = L, .left = left, .count = count, .first = first};
    vertex_id last = L[left - 1], next = L[left];
    bool in_line = true;
    for (uint32_t i = 2; i < count; i++)
        in_line = in_line &&
            orient2d(p->points[L[0]], p->points[L[1]], p->points[L[i]]) == 0;
    uint64_t tangent = tangent_tests(m, p->points, last, next);
    cost before = {hull_size_at(m, last) + hull_size_at(m, next),
                   predicate_count.orient2d, predicate_count.incircle};
    m->trace = &w.observer;
    merge(m, p->points, last, next);
    m->trace = NULL;
    if (p->counts)
        check_cost(&w, before, hull_size_at(m, L[0]), tangent);
    else
        check_part(m, &w);
    CLAIM("sec3.7.P7", !in_line || w.new + w.gone == 0, "%u flips on a line",
          w.new + w.gone);
    CLAIM("sec3.7.P11", w.bridges == 1 && m->triangles == first + 2 * count - 2,
          "%u triangles from number %u on, for %u points", m->triangles - first, first,
          count);
}

static void
divide_watched(mesh *m, const plan *p, const vertex_id *L, uint32_t count)
{
    uint32_t first = m->triangles;
    if (count <= 3) {
        if (count < 2)
            return;
        halfedge_id last = mesh_hull_next(m, mesh_start(m, L[0], L[1]));
        if (count == 3)
            attach(m, hull_edges_seeing(m, p->points, last, L[2]), L[2]);
        return;
    }
    uint32_t left = p->halves ? count / 2
                              : 2 + random_below(test_random_source(), count - 3);
    divide_watched(m, p, L, left);
    divide_watched(m, p, L + left, count - left);
    merge_watched(m, p, L, left, count, first);
}

static void
run_plan(const point2 *points, uint32_t n, plan p, mesh *m)
{
    uint32_t u = 0;
    p.points = points;
    p.d = random_direction();
    vertex_id *L = in_order(points, n, p.d, &u);
    CLAIM("sec3.7.P6", mesh_init(m, n, u) == TRI_OK, "no memory");
    divide_watched(m, &p, L, u);
    free(L);
    claim_verdict("sec3.7.P6", mesh_check(m));
    mesh_free(m);
}

static void
every_merge_is_as_proved(const point2 *points, uint32_t n)
{
    mesh m;
    run_plan(points, n, (plan){.halves = false}, &m);
}

static void
every_merge_is_linear(const point2 *points, uint32_t n)
{
    bool halves = random_below(test_random_source(), 2) == 0;
    mesh m;
    run_plan(points, n, (plan){.halves = halves, .counts = true}, &m);
}

/* ---- The whole. ---- */

static tri_options
some_options(void)
{
    tri_options options = tri_options_default();
    options.direction = random_direction();
    options.cuts = random_below(test_random_source(), 2) == 0 ? TRI_CUTS_VERTICAL
                                                              : TRI_CUTS_ALTERNATING;
    return options;
}

static void
the_result_is_delaunay(const point2 *points, uint32_t n)
{
    tri_options options = some_options();
    mesh m;
    triangle_list list;
    verdict v;
    tri_status status = divide_triangulate(points, n, &options, &m);
    CLAIM("sec3.7.P6", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("sec3.7.P6", mesh_check(&m));
    CLAIM("sec3.7.P6", mesh_triangles(&m, &list) == TRI_OK, "no memory");
    test_picture(list);
    CLAIM("sec3.7.P6", is_delaunay(points, n, list, &v) == TRI_OK, "no memory");
    if (options.cuts == TRI_CUTS_VERTICAL)
        claim_verdict("sec3.7.P6", v);
    else
        claim_verdict("sec3.7.P12", v);
    uint32_t h = mesh_hull_size(&m);
    CLAIM("sec3.7.P6", m.locations < 2 || list.count + h + 2 == 2 * m.locations,
          "%u triangles and %u hull edges for %u locations", list.count, h,
          m.locations);
    triangle_list_free(&list);
    mesh_free(&m);
}

/* P7: collinear points are a path in their order. */
static void
points_on_a_line_are_a_path(const point2 *points, uint32_t n)
{
    point2 *line = malloc((n + 1) * sizeof *line);
    for (uint32_t i = 0; i < n; i++)
        line[i] = (point2){points[i].x, -points[i].x}; /* exactly collinear */
    tri_options options = some_options();
    mesh m;
    uint32_t u;
    CLAIM("sec3.7.P7", divide_triangulate(line, n, &options, &m) == TRI_OK, "no mesh");
    claim_verdict("sec3.7.P7", mesh_check(&m));
    vertex_id *L = in_order(line, n, (point2){1, 0}, &u);
    CLAIM("sec3.7.P7", u < 2 || mesh_hull_size(&m) == 2 * u - 2, "%u hull edges",
          mesh_hull_size(&m));
    halfedge_id e = mesh_some_hull_edge(&m);
    while (u >= 2 && (mesh_origin(&m, e) != L[0]))
        e = mesh_hull_next(&m, e);
    for (uint32_t i = 0; i + 1 < u; i++, e = mesh_hull_next(&m, e))
        CLAIM("sec3.7.P7", mesh_origin(&m, e) == L[i] && mesh_dest(&m, e) == L[i + 1],
              "the path does not lead from %u to %u", L[i], L[i + 1]);
    free(L);
    free(line);
    mesh_free(&m);
}

/* Is ab an edge of *m? */
static bool
has_edge(const mesh *m, vertex_id a, vertex_id b)
{
    halfedge_id first = mesh_leaving(m, a), e = first;
    do {
        if (mesh_dest(m, e) == b)
            return true;
        e = mesh_around(m, e);
    } while (e != first);
    return false;
}

/* With Lawson's: the same number of triangles; and where no two of its triangles share
 * a circle there is one Delaunay triangulation only, so the same edges. */
static void
lawson_says_the_same(const point2 *points, uint32_t n)
{
    tri_options options = some_options();
    mesh m, K;
    CLAIM("sec3.7.P6", divide_triangulate(points, n, &options, &m) == TRI_OK &&
          lawson_triangulate(points, n, NULL, &K) == TRI_OK, "no mesh");
    CLAIM("sec3.7.P6", mesh_hull_size(&m) == mesh_hull_size(&K), "%u and %u hull edges",
          mesh_hull_size(&m), mesh_hull_size(&K));
    bool unique = true;
    for (halfedge_id e = 0; e < mesh_halfedges(&K); e++)
        if (mesh_is_interior(&K, e))
            unique = unique &&
                incircle(points[mesh_origin(&K, e)], points[mesh_dest(&K, e)],
                         points[mesh_apex(&K, e)],
                         points[mesh_apex(&K, mesh_twin(&K, e))]) < 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&K) && unique; e++) {
        vertex_id a = mesh_origin(&K, e), b = mesh_dest(&K, e);
        if (a != GHOST && b != GHOST)
            CLAIM("sec3.7.P6", has_edge(&m, a, b), "only Lawson has the edge %u %u", a,
                  b);
    }
    mesh_free(&m);
    mesh_free(&K);
}

/* P11: divide_triangulate gives the mesh of our own division, number by number. */
static void
numbers_depend_on_the_places_only(const point2 *points, uint32_t n)
{
    uint32_t u = 0;
    plan p = {.points = points, .d = random_direction(), .halves = true};
    vertex_id *L = in_order(points, n, p.d, &u);
    tri_options options = tri_options_default();
    options.direction = p.d;
    mesh ours, theirs;
    CLAIM("sec3.7.P11", mesh_init(&ours, n, u) == TRI_OK &&
          divide_triangulate(points, n, &options, &theirs) == TRI_OK, "no mesh");
    divide_watched(&ours, &p, L, u);
    size_t size = mesh_halfedges(&ours) * sizeof *ours.halfedge;
    CLAIM("sec3.7.P11", theirs.triangles == ours.triangles &&
          (size == 0 || memcmp(ours.halfedge, theirs.halfedge, size) == 0),
          "the meshes of %u points differ", u);
    free(L);
    mesh_free(&ours);
    mesh_free(&theirs);
}

/* P10: orientation and incircle tests of the whole. */
static void
n_log_n_tests(const point2 *points, uint32_t n)
{
    tri_options options = some_options();
    uint64_t orient = predicate_count.orient2d, circle = predicate_count.incircle;
    mesh m;
    CLAIM("sec3.7.P10", divide_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    orient = predicate_count.orient2d - orient;
    circle = predicate_count.incircle - circle;
    uint64_t u = m.locations, levels = 0;
    mesh_free(&m);
    while ((uint64_t)1 << levels < u)
        levels++;
    CLAIM("sec3.7.P10", orient <= 8 * u * levels && circle <= 8 * u * levels,
          "%llu orientation and %llu incircle tests for %llu points",
          (unsigned long long)orient, (unsigned long long)circle,
          (unsigned long long)u);
}

/* P13: the selected point, and what lies before and behind it. */
static void
selecting_is_sorting_in_one_place(const point2 *points, uint32_t n)
{
    point2 d = random_direction();
    uint32_t u = 0;
    vertex_id *L = in_order(points, n, d, &u);
    vertex_id *sorted = malloc((n + 1) * sizeof *sorted);
    random_source *r = test_random_source();
    for (uint32_t i = 0; i < u; i++)
        sorted[i] = L[i];
    for (uint32_t i = u; i > 1; i--) { /* any order will do */
        uint32_t j = random_below(r, i);
        vertex_id old = L[j];
        L[j] = L[i - 1];
        L[i - 1] = old;
    }
    uint32_t k = u > 0 ? random_below(r, u) : 0;
    if (u > 0)
        select_along(points, L, u, k, d, r);
    uint64_t sum = 0, sum_sorted = 0;
    for (uint32_t i = 0; i < u; i++) {
        int order = compare_along(d, points[L[i]], points[sorted[k]]);
        CLAIM("sec3.7.P13", i == k ? order == 0 : (order < 0) == (i < k),
              "after selecting number %u, %u stands at place %u", k, L[i], i);
        sum += L[i];
        sum_sorted += sorted[i];
    }
    CLAIM("sec3.7.P13", sum == sum_sorted, "some point is there twice");
    free(sorted);
    free(L);
}

/* P19: how many comparisons for a place in the middle, on average over the pivots. The
 * sites begin in order, which is bad luck for who always takes the first. */
static void
selecting_takes_four_comparisons_a_site(void)
{
    enum { n = 400, runs = 200 };
    point2 points[n];
    vertex_id L[n];
    uint64_t before = predicate_count.compare_along;
    for (int run = 0; run < runs; run++) {
        for (uint32_t i = 0; i < n; i++) {
            points[i] = (point2){i, i % 7};
            L[i] = i;
        }
        select_along(points, L, n, n / 2, (point2){1, 0}, test_random_source());
    }
    double each = (double)(predicate_count.compare_along - before) / runs / n;
    CLAIM("sec3.7.P19", each < 4, "%.2f comparisons a site", each);
}

/* ---- Cuts in turn. ---- */

/* The first edges of the parts of two and three, in the order in which they come. */
typedef struct first_edges {
    trace observer; /* first: see lib/trace.h */
    vertex_id (*edge)[2];
    uint32_t count, seen, wrong;
} first_edges;

static void
sort_slowly(const point2 *points, vertex_id *L, uint32_t count, point2 d)
{
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t j = i; j > 0; j--) {
            vertex_id p = L[j - 1], q = L[j];
            if (compare_along(d, points[p], points[q]) < 0)
                break;
            L[j - 1] = q;
            L[j] = p;
        }
}

/* What P18 says about them. */
static void
expect_cuts(first_edges *e, const point2 *points, vertex_id *L, uint32_t count,
            point2 d)
{
    sort_slowly(points, L, count, d);
    if (count >= 4) {
        uint32_t half = count / 2;
        const point2 across = {-d.y, d.x};
        expect_cuts(e, points, L, half, across);
        expect_cuts(e, points, L + half, count - half, across);
    } else if (count >= 2) {
        e->edge[e->count][0] = L[0];
        e->edge[e->count++][1] = L[1];
    }
}

static int
see_first_edge(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    first_edges *e = (first_edges *)self;
    if (event->kind != TRACE_START)
        return 0;
    e->wrong += e->seen >= e->count || e->edge[e->seen][0] != event->a ||
        e->edge[e->seen][1] != event->b;
    e->seen++;
    return 0;
}

static void
cuts_are_along_and_across_in_turn(const point2 *points, uint32_t n)
{
    tri_options options = tri_options_default();
    options.direction = random_direction();
    options.cuts = TRI_CUTS_ALTERNATING;
    uint32_t u = 0;
    vertex_id *L = in_order(points, n, options.direction, &u);
    first_edges e = {.observer = {see_first_edge},
                     .edge = malloc((n + 1) * sizeof *e.edge)};
    expect_cuts(&e, points, L, u, options.direction);
    options.trace = &e.observer;
    mesh m;
    CLAIM("sec3.7.P18", divide_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    mesh_free(&m);
    free(e.edge);
    free(L);
    CLAIM("sec3.7.P18", e.wrong == 0 && e.seen == e.count,
          "%u of %u parts begin with another edge", e.wrong, e.count);
}

/* P20: a unit square in two halves. */
static void
ties_stay_and_go_left(void)
{
    const point2 square[] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
    mesh m;
    CLAIM("sec3.7.P20", divide_triangulate(square, 4, NULL, &m) == TRI_OK, "no mesh");
    CLAIM("sec3.7.P20", has_edge(&m, 1, 2), "the right candidate was taken");
    mesh_free(&m);
}

/* ---- The erratum, cancelling, refusals, and memory that runs out. ---- */

/* E52: two Delaunay triangulations are not merged by filling what lies between them.
 * Here the triangle on the left has to go, as (1,0) lies in its circle. */
static void
e52_merging_takes_triangles_away(void)
{
    const point2 points[] = {{-1, 0}, {0, -9}, {0, 9}, {1, 0}, {2, -1}, {2, 1}};
    const vertex_id L[] = {0, 1, 2, 3, 4, 5};
    const plan p = {.points = points, .d = {1, 0}};
    CLAIM("E52", incircle(points[0], points[1], points[2], points[3]) > 0,
          "the triangle on the left may stay");
    mesh m;
    CLAIM("E52", mesh_init(&m, 6, 6) == TRI_OK, "no memory");
    watcher w = {.observer = {see_counts}};
    divide_watched(&m, &p, L, 3);
    divide_watched(&m, &p, L + 3, 3);
    m.trace = &w.observer;
    merge(&m, points, 2, 3);
    CLAIM("E52", w.gone == 1 && has_edge(&m, 0, 3), "%u triangles have gone", w.gone);
    mesh_free(&m);
}

/* Stops at a flip or at a bridge, when so many triangles are there. */
typedef struct stopper {
    trace observer; /* first: see lib/trace.h */
    trace_kind kind;
    uint32_t triangles;
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
    stopper *s = (stopper *)self;
    s->asked = tests_asked();
    return event->kind == s->kind && m->triangles >= s->triangles;
}

static void
it_can_be_stopped_and_refused(void)
{
    point2 points[50];
    for (int i = 0; i < 50; i++)
        points[i] = (point2){i % 7, i * i % 11};
    tri_options options = tri_options_default();
    mesh m;
    for (int cuts = 0; cuts < 2; cuts++) {
        options.cuts = cuts == 0 ? TRI_CUTS_VERTICAL : TRI_CUTS_ALTERNATING;
        for (uint32_t triangles = 2; triangles <= 60; triangles += 2) {
            stopper stop = {{see_and_stop}, TRACE_BRIDGE, triangles, 0};
            options.trace = &stop.observer;
            tri_status stopped = divide_triangulate(points, 50, &options, &m);
            uint64_t more = tests_asked() - stop.asked;
            CLAIM("sec3.7.P6", stopped == TRI_CANCELLED && m.halfedge == NULL &&
                  more <= 24, "stopped at %u triangles, it asked %u more tests",
                  triangles, (unsigned)more);
        }
        options.trace = NULL;
        tri_status status = TRI_OUT_OF_MEMORY;
        for (unsigned long k = 1; status != TRI_OK; k++) {
            memory_fail_at(k);
            status = divide_triangulate(points, 50, &options, &m);
            memory_fail_at(0);
            CLAIM("sec3.7.P6", status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                  m.halfedge == NULL), "allocation %lu: %s", k,
                  tri_status_text(status));
        }
        mesh_free(&m);
    }
    options.cuts = (tri_cuts)2;
    CLAIM("sec3.7.P6", divide_triangulate(points, 50, &options, &m) == TRI_BAD_OPTION,
          "cuts of a third kind were accepted");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.7: what is divided and merged is Delaunay");
    test_random("every merge", every_merge_is_as_proved, 3000, 40);
    test_near_degenerate("every merge", every_merge_is_as_proved, 2000, 25);
    test_grid_subsets("every merge", every_merge_is_as_proved, 3);
    test_random("the result", the_result_is_delaunay, 3000, 120);
    test_near_degenerate("the result", the_result_is_delaunay, 2000, 50);
    test_grid_subsets("the result", the_result_is_delaunay, 4);
    test_random("Lawson's result", lawson_says_the_same, 2000, 60);
    test_near_degenerate("Lawson's result", lawson_says_the_same, 1000, 30);
    test_random("on a line", points_on_a_line_are_a_path, 500, 40);
    test_random("the numbers", numbers_depend_on_the_places_only, 500, 60);
    test_random("the cost of a merge", every_merge_is_linear, 1000, 300);
    test_near_degenerate("the cost of a merge", every_merge_is_linear, 1000, 60);
    test_random("the cost of all", n_log_n_tests, 1000, 400);
    test_random("selecting", selecting_is_sorting_in_one_place, 1000, 60);
    test_near_degenerate("selecting", selecting_is_sorting_in_one_place, 500, 40);
    test_run("the cost of selecting", selecting_takes_four_comparisons_a_site);
    test_random("cuts in turn", cuts_are_along_and_across_in_turn, 500, 60);
    test_near_degenerate("cuts in turn", cuts_are_along_and_across_in_turn, 500, 40);
    test_run("ties", ties_stay_and_go_left);
    test_run("E52: merging takes triangles away", e52_merging_takes_triangles_away);
    test_run("stopped, refused, out of memory", it_can_be_stopped_and_refused);
    return test_end((test_minima){.trials = 80000, .largest_n = 300, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
