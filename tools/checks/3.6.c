/* 3.6.c - the properties of exercises 3.6-a to 3.6-e: incremental insertion. */
#include "tools/checks/certify.h"
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/replay.h"
#include "tools/checks/room.h"
#include "tools/checks/shuffles.h"
#include "tools/checks/sphere.h"

#include <math.h>
#include <stdlib.h>

/* ---- All points but one, and where that one lies. ---- */

typedef struct scene {
    uint32_t p;
    piece before;  /* of all points that are not at the place of p */
    sphere around; /* the same with the outside */
} scene;

static void
forget_scene(scene *sc)
{
    free(sc->before.path);
    triangle_list_free(&sc->around.list);
    sc->before = (piece){0};
}

/* false when fewer than two locations are left. */
static bool
set_scene(session *s, scene *sc, uint32_t p, const site *at, uint32_t n)
{
    uint32_t *others = room_for(n, sizeof *others), count = 0;
    for (uint32_t i = 0; i < n; i++)
        if (!plane_same(at[i], at[p]))
            others[count++] = i;
    sc->p = p;
    sc->before = piece_at_random(trial_random(s), at, others, count, false);
    free(others);
    sc->around = sphere_of(at, n, sc->before.list, sc->before.path, sc->before.length, 1);
    bool enough = sc->before.list.count > 0 || sc->before.length > 1;
    if (!enough)
        forget_scene(sc);
    return enough;
}

static void
give_scene(session *s, const scene *sc)
{
    keep_triangles(s, sc->before.list);
    give_points(s);
    if (sc->before.list.count > 0)
        give_triangles(s, sc->before.list);
    else
        give_path(s, sc->before.path, sc->before.length);
}

/* ---- In words. ---- */

/* Of a spot, or of a place: walk.h. */
static const char *const spot_names[] = {"nowhere", "in a triangle", "on an edge",
                                         "beyond the end of a path"};

/* What a failure calls a triangle, "triangle 1-2-3" or "the outside of 1-2", and an edge,
 * "1-2" or "the edge from 1 to infinity". */
typedef struct name {
    char text[60];
} name;

static name
name_of_triangle(vertex_id infinity, vertex_id a, vertex_id b, vertex_id c)
{
    name n;
    unsigned long p = a, q = b, r = c;
    if (a != infinity && b != infinity && c != infinity)
        snprintf(n.text, sizeof n.text, "triangle %lu-%lu-%lu", p, q, r);
    else
        snprintf(n.text, sizeof n.text, "the outside of %lu-%lu",
                 a == infinity ? r : b == infinity ? p : q,
                 a == infinity ? q : b == infinity ? r : p);
    return n;
}

static name
name_of_edge(vertex_id infinity, vertex_id a, vertex_id b)
{
    name n;
    if (a != infinity && b != infinity)
        snprintf(n.text, sizeof n.text, "%lu-%lu", (unsigned long)a, (unsigned long)b);
    else
        snprintf(n.text, sizeof n.text, "the edge from %lu to infinity",
                 (unsigned long)(a == infinity ? b : a));
    return n;
}

static name
name_of(const scene *sc, halfedge_id e)
{
    triangle_list list = sc->around.list;
    return name_of_triangle(sc->around.infinity, side_origin(list, e), side_dest(list, e),
                            side_apex(list, e));
}

/* ---- 3.6-a: the split. ---- */

/* A spot of p, of those that lie in a triangle or outside, or of the others; SPOT_NOWHERE if
 * it has none. */
static spot
some_spot(session *s, const scene *sc, bool in_triangle, halfedge_id *e)
{
    uint32_t triangles = sc->around.list.count;
    uint32_t start = random_below(trial_random(s), triangles);
    for (uint32_t i = 0; i < triangles; i++) {
        *e = 3 * ((start + i) % triangles) + random_below(trial_random(s), 3);
        spot found = sphere_spot(&sc->around, sc->p, e);
        if (found != SPOT_NOWHERE && (found == SPOT_TRIANGLE) == in_triangle)
            return found;
    }
    return SPOT_NOWHERE;
}

/* What is said about the mesh before and after the split. */
typedef struct halves {
    uint32_t count, e, twin; /* before: how many; the half-edge of the place, its twin */
    uint32_t *before, *origin, *twins, *leaving;
} halves;

static uint32_t *
take_row(session *s, uint32_t count, uint32_t most, const char *what)
{
    uint32_t *row = room_for(count, sizeof *row);
    for (uint32_t i = 0; i < count; i++)
        row[i] = take_number(s, 0, most, what);
    return row;
}

static halves
take_halves(session *s, const scene *sc, uint32_t n)
{
    halves h = {.count = 3 * sc->around.list.count};
    h.e = take_number(s, 0, h.count - 1, "the half-edge of the place");
    h.twin = take_number(s, 0, h.count - 1, "its twin");
    take_number(s, h.count, h.count, "the number of half-edges before the split");
    h.before = take_row(s, h.count, n, "an origin");
    uint32_t count = take_number(s, 0, UINT32_MAX, "the number of half-edges");
    expect(s, count == h.count + 6,
           "there were %lu half-edges before, and now there are %lu; two new triangles "
           "have 6 more", (unsigned long)h.count, (unsigned long)count);
    h.count += 6;
    h.origin = take_row(s, h.count, n, "an origin");
    h.twins = take_row(s, h.count, UINT32_MAX, "a twin");
    h.leaving = take_row(s, n + 1, UINT32_MAX, "a half-edge leaving a vertex");
    take_end(s);
    return h;
}

static void
forget_halves(halves *h)
{
    free(h->before);
    free(h->origin);
    free(h->twins);
    free(h->leaving);
}

static uint32_t
next_of(uint32_t e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* A random scene and a place of p in it, and the mesh after the split; false: p has no
 * such place, or there is no answer. */
static bool
ask_split(session *s, const site *at, uint32_t n, bool in_triangle, scene *sc, spot *how,
          halfedge_id *e, halves *h)
{
    uint32_t start = n > 0 ? random_below(trial_random(s), n) : 0;
    for (uint32_t i = 0; i < n; i++) {
        if (!set_scene(s, sc, (start + i) % n, at, n))
            continue;
        *how = some_spot(s, sc, in_triangle, e);
        if (*how != SPOT_NOWHERE)
            break;
        triangle_list_free(&sc->before.list);
        forget_scene(sc);
    }
    if (sc->before.path == NULL)
        return false;
    begin_case(s, 'a', at, n);
    give_scene(s, sc);
    give_number(s, *how - SPOT_TRIANGLE);
    give_number(s, side_origin(sc->around.list, *e));
    give_number(s, side_dest(sc->around.list, *e));
    give_number(s, side_apex(sc->around.list, *e));
    give_number(s, sc->p);
    show_witness(s, sc->p);
    if (!ask(s)) {
        forget_scene(sc);
        return false;
    }
    *h = take_halves(s, sc, n);
    return true;
}

/* Are the triangles afterwards those that they should be? */
static void
check_new_triangles(session *s, const scene *sc, spot how, halfedge_id e, const halves *h)
{
    name where = name_of(sc, e);
    if (how != SPOT_TRIANGLE)
        where = name_of_edge(sc->around.infinity, side_origin(sc->around.list, e),
                             side_dest(sc->around.list, e));
    sphere expected = sc->around;
    expected.list = (triangle_list){sc->around.list.count, NULL};
    expected.list.corner = room_for(h->count / 3, sizeof *expected.list.corner);
    for (uint32_t i = 0; i < 3 * sc->around.list.count; i++)
        expected.list.corner[i / 3][i % 3] = sc->around.list.corner[i / 3][i % 3];
    sphere_split(&expected, how, e, sc->p);
    triangle_list seen = {h->count / 3, NULL};
    seen.corner = room_for(seen.count, sizeof *seen.corner);
    for (uint32_t i = 0; !failed(s) && i < h->count; i++)
        seen.corner[i / 3][i % 3] = h->origin[i];
    expect(s, failed(s) || same_triangles(seen, expected.list),
           "%lu lies %s, %s: the triangles around it afterwards are wrong",
           (unsigned long)sc->p, spot_names[how], where.text);
    triangle_list_free(&seen);
    triangle_list_free(&expected.list);
}

/* The contract of split: what stays what it is. */
static void
check_what_stays(session *s, const scene *sc, spot how, halfedge_id e, const halves *h)
{
    vertex_id a = side_origin(sc->around.list, e), b = side_dest(sc->around.list, e);
    vertex_id to = how == SPOT_TRIANGLE ? b : sc->p;
    if (failed(s) || how == SPOT_BEYOND)
        return;
    expect(s, h->origin[h->e] == a && h->origin[next_of(h->e)] == to,
           "%s, the half-edge of the place, does not lead where incremental.h says it does",
           name_of_edge(sc->around.infinity, a, b).text);
    expect(s, how == SPOT_TRIANGLE ||
                  (h->origin[h->twin] == b && h->origin[next_of(h->twin)] == sc->p),
           "%s, the twin of the half-edge of the place, does not lead to %lu now",
           name_of_edge(sc->around.infinity, b, a).text, (unsigned long)sc->p);
    for (uint32_t i = 0; i + 6 < h->count; i++)
        if (i / 3 != h->e / 3 && (how == SPOT_TRIANGLE || i / 3 != h->twin / 3))
            expect(s, h->origin[i] == h->before[i],
                   "half-edge %lu leaves %lu, and %lu before: it is none of the "
                   "triangles of the place", (unsigned long)i, (unsigned long)h->origin[i],
                   (unsigned long)h->before[i]);
}

static void
check_split(session *s, const site *at, uint32_t n, bool in_triangle)
{
    scene sc = {0};
    spot how;
    halfedge_id e;
    halves h;
    if (!ask_split(s, at, n, in_triangle, &sc, &how, &e, &h))
        return;
    check_new_triangles(s, &sc, how, e, &h);
    check_what_stays(s, &sc, how, e, &h);
    forget_halves(&h);
    forget_scene(&sc);
}

static void
triangles_are_split(session *s, const site *at, uint32_t n)
{
    check_split(s, at, n, true);
}

static void
edges_are_split(session *s, const site *at, uint32_t n)
{
    check_split(s, at, n, false);
}

/* Twins of each other, with the same ends; and each vertex knows an edge. */
static void
check_links(session *s, uint32_t n, const halves *h)
{
    for (uint32_t e = 0; e < h->count && !failed(s); e++) {
        uint32_t t = h->twins[e];
        if (!expect(s, t < h->count, "half-edge %lu, from %lu to %lu, has no twin",
                    (unsigned long)e, (unsigned long)h->origin[e],
                    (unsigned long)h->origin[next_of(e)]))
            return;
        expect(s, t != e && h->twins[t] == e,
               "the twin of half-edge %lu is %lu, but the twin of that is %lu",
               (unsigned long)e, (unsigned long)t, (unsigned long)h->twins[t]);
        expect(s, h->origin[t] == h->origin[next_of(e)] &&
                      h->origin[e] == h->origin[next_of(t)],
               "half-edges %lu and %lu are twins, and do not run between the same "
               "vertices", (unsigned long)e, (unsigned long)t);
    }
    for (uint32_t v = 0; v <= n && !failed(s); v++)
        expect(s, h->leaving[v] == NONE ||
                      (h->leaving[v] < h->count && h->origin[h->leaving[v]] == v),
               "the half-edge that is to leave vertex %lu leaves another one",
               (unsigned long)v);
}

static void
links_are_right(session *s, const site *at, uint32_t n)
{
    scene sc = {0};
    spot how;
    halfedge_id e;
    halves h;
    bool in_triangle = random_below(trial_random(s), 2) == 0;
    if (!ask_split(s, at, n, in_triangle, &sc, &how, &e, &h))
        return;
    check_links(s, n, &h);
    expect(s, failed(s) || h.leaving[sc.p] != NONE, "no half-edge leaves %lu",
           (unsigned long)sc.p);
    check_new_triangles(s, &sc, how, e, &h);
    forget_halves(&h);
    forget_scene(&sc);
}

/* ---- 3.6-b: the straight walk. ---- */

/* Whether the triangle of e meets the segment from v to p. Two convex sets are apart exactly
 * when one of the lines along their sides is between them. */
typedef enum meeting { APART, TOUCHING, ENTERED } meeting;

static meeting
meets_segment(const site *at, triangle_list list, triangle_id t, uint32_t v, uint32_t p)
{
    meeting found = ENTERED;
    bool left = false, right = false, on = false;
    for (halfedge_id e = 3 * t; e < 3 * t + 3; e++) {
        site a = at[side_origin(list, e)], b = at[side_dest(list, e)];
        int of_v = plane_orient(a, b, at[v]), of_p = plane_orient(a, b, at[p]);
        if (of_v < 0 && of_p < 0)
            return APART;
        if (of_v <= 0 && of_p <= 0)
            found = TOUCHING;
        int side = plane_orient(at[v], at[p], a);
        left |= side > 0;
        right |= side < 0;
        on |= side == 0;
    }
    if (!on && !(left && right))
        return APART;
    return left && right ? found : TOUCHING;
}

/* The triangle abc of the answer, as a side of the scene; or the trial fails. */
static halfedge_id
take_side(session *s, const scene *sc, uint32_t n, const char *what)
{
    vertex_id a = take_number(s, 0, n, what), b = take_number(s, 0, n, what);
    vertex_id c = take_number(s, 0, n, what);
    halfedge_id e = failed(s) ? NONE : sphere_side(&sc->around, a, b, c);
    expect(s, failed(s) || e != NONE, "%s: %lu-%lu-%lu is no triangle of the mesh", what,
           (unsigned long)a, (unsigned long)b, (unsigned long)c);
    return failed(s) ? NONE : e;
}

/* Is the place right? Returns the half-edge of it. */
static halfedge_id
take_place(session *s, const scene *sc, uint32_t n, spot *kind)
{
    *kind = (spot)(SPOT_TRIANGLE + take_number(s, 0, 2, "the kind of the place"));
    halfedge_id e = take_side(s, sc, n, "the place"), exact = e;
    if (failed(s))
        return NONE;
    spot found = sphere_spot(&sc->around, sc->p, &exact);
    expect(s, found != SPOT_NOWHERE, "the place is said to be %s, and %lu does not lie there",
           name_of(sc, e).text, (unsigned long)sc->p);
    expect(s, found == *kind, "the place is said to be %s, and %lu lies %s (%s)",
           spot_names[*kind], (unsigned long)sc->p, spot_names[found],
           name_of(sc, e).text);
    expect(s, found == SPOT_TRIANGLE || e == exact,
           "the triangle of the place is right, but its half-edge is to lead from %lu to "
           "%lu", (unsigned long)side_origin(sc->around.list, exact),
           (unsigned long)side_dest(sc->around.list, exact));
    return failed(s) ? NONE : e;
}

/* One more triangle of the walk: not twice, beside the one before, and on the segment. */
static void
check_visit(session *s, const scene *sc, const site *at, uint32_t v, halfedge_id before,
            halfedge_id e, bool *visited)
{
    triangle_list list = sc->around.list;
    if (failed(s))
        return;
    expect(s, !visited[e / 3], "%s is visited twice", name_of(sc, e).text);
    visited[e / 3] = true;
    bool outside = e / 3 >= sc->before.list.count, beside = before == NONE;
    for (int i = 0; before != NONE && i < 3; i++, before = next_of(before))
        for (halfedge_id f = 3 * (e / 3); f < 3 * (e / 3) + 3; f++)
            beside |= side_origin(list, f) == side_dest(list, before) &&
                      side_dest(list, f) == side_origin(list, before);
    expect(s, beside, "%s is visited after %s, and they have no side in common",
           name_of(sc, e).text, before == NONE ? "" : name_of(sc, before).text);
    if (!failed(s) && !outside &&
        !expect(s, meets_segment(at, list, e / 3, v, sc->p) != APART,
                "%s is visited, and the segment from %lu to %lu does not meet it",
                name_of(sc, e).text, (unsigned long)v, (unsigned long)sc->p))
        show_witness(s, v);
}

/* The triangles that were visited; returns how many. */
static uint32_t
take_visits(session *s, const scene *sc, const site *at, uint32_t n, uint32_t v,
            spot kind, halfedge_id place)
{
    triangle_list list = sc->around.list;
    bool *visited = room_for(list.count, sizeof *visited);
    uint32_t visits = take_number(s, 0, 1000, "the number of visits");
    halfedge_id before = NONE;
    for (uint32_t i = 0; i < visits && !failed(s); i++) {
        halfedge_id e = take_side(s, sc, n, "a visit");
        check_visit(s, sc, at, v, before, e, visited);
        before = e;
    }
    take_end(s);
    for (triangle_id t = 0; t < sc->before.list.count && !failed(s); t++)
        expect(s, visited[t] || meets_segment(at, list, t, v, sc->p) != ENTERED,
               "the segment from %lu to %lu runs through %s, which is not visited",
               (unsigned long)v, (unsigned long)sc->p, name_of(sc, 3 * t).text);
    if (!failed(s) && kind == SPOT_TRIANGLE)
        expect(s, visited[place / 3], "%s, the place, is not visited",
               name_of(sc, place).text);
    free(visited);
    return visits;
}

/* How many edges end at v and at the vertices on the way to p, those to infinity counted. */
static uint32_t
count_edges_at_start(const scene *sc, const site *at, uint32_t n, uint32_t v)
{
    uint32_t edges = sphere_degree(&sc->around, v);
    for (uint32_t i = 0; i < n; i++)
        if (plane_orient(at[v], at[sc->p], at[i]) == 0 &&
            plane_dot(at[v], at[i], at[sc->p]) < 0)
            edges += sphere_degree(&sc->around, i);
    return edges;
}

static void
check_walk(session *s, const site *at, uint32_t n, bool visits, bool tests)
{
    scene sc = {0};
    if (n == 0 || !set_scene(s, &sc, random_below(trial_random(s), n), at, n))
        return;
    triangle_list list = sc.around.list;
    vertex_id v = sc.around.infinity;
    while (v == sc.around.infinity) {
        halfedge_id e = random_below(trial_random(s), 3 * list.count);
        v = side_origin(list, e);
    }
    begin_case(s, 'b', at, n);
    give_scene(s, &sc);
    give_number(s, v);
    give_number(s, sc.p);
    show_witness(s, sc.p);
    if (ask(s)) {
        spot kind;
        halfedge_id place = take_place(s, &sc, n, &kind);
        uint32_t seen = visits ? take_visits(s, &sc, at, n, v, kind, place) : 0;
        uint64_t most = 2 * (uint64_t)(count_edges_at_start(&sc, at, n, v) + seen) + 3;
        if (tests)
            expect(s, failed(s) || asked(s, WIRE_ORIENT) + asked(s, WIRE_INCIRCLE) <= most,
                   "%llu tests on the way from %lu to %lu, with %lu triangles; two for "
                   "each of these and for each at the start, and three more, are %llu",
                   (unsigned long long)asked(s, WIRE_ORIENT) + asked(s, WIRE_INCIRCLE),
                   (unsigned long)v, (unsigned long)sc.p, (unsigned long)seen,
                   (unsigned long long)most);
    }
    forget_scene(&sc);
}

static void
place_is_found(session *s, const site *at, uint32_t n)
{
    check_walk(s, at, n, false, false);
}

static void
walk_is_straight(session *s, const site *at, uint32_t n)
{
    check_walk(s, at, n, true, false);
}

static void
walk_is_cheap(session *s, const site *at, uint32_t n)
{
    check_walk(s, at, n, true, true);
}

/* ---- 3.6-c and 3.6-e: insertion, replayed. ---- */

/* The locations in random order. */
static uint32_t
give_order(session *s, const site *at, uint32_t n, uint32_t *order)
{
    uint32_t count = cases_locations(at, n, order);
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = random_below(trial_random(s), i), chosen = order[j];
        order[j] = order[i - 1];
        order[i - 1] = chosen;
    }
    give_numbers(s, order, count);
    return count;
}

/* What is told of an insertion: found, flipped, moved. */
typedef enum told_kind { TOLD_LOCATE, TOLD_FLIP, TOLD_MOVE } told_kind;

typedef struct told {
    told_kind kind;
    uint32_t p, a, b, c; /* of a point, a triangle; of a flip, the ends a and b */
} told;

static told
take_told(session *s, uint32_t n)
{
    told t;
    t.kind = (told_kind)take_number(s, TOLD_LOCATE, TOLD_MOVE, "what happened");
    t.p = take_number(s, 0, n, "a point");
    t.a = take_number(s, 0, n, "a vertex");
    t.b = take_number(s, 0, n, "a vertex");
    t.c = take_number(s, 0, UINT32_MAX, "a vertex");
    return t;
}

/* The insertion so far. */
typedef struct insertion {
    const site *at;
    uint32_t n;
    const uint32_t *order;
    uint32_t count, inserted;
    sphere now;
    uint32_t (*home)[3]; /* point -> corners of the triangle in which it waits */
    bool *waits;         /* point -> has it been told where? */
    uint32_t moves;
} insertion;

static insertion
begin_insertion(const site *at, uint32_t n, const uint32_t *order, uint32_t count)
{
    insertion in = {.at = at, .n = n, .order = order, .count = count, .inserted = 2};
    in.now = sphere_of(at, n, (triangle_list){0}, order, count < 2 ? count : 2, count);
    in.home = room_for(n, sizeof *in.home);
    in.waits = room_for(n, sizeof *in.waits);
    return in;
}

static void
end_insertion(insertion *in)
{
    triangle_list_free(&in->now.list);
    free(in->home);
    free(in->waits);
}

/* The next point has been found in a triangle: it is split. */
static void
replay_locate(session *s, insertion *in, told t)
{
    expect(s, in->inserted < in->count && in->order[in->inserted] == t.p,
           "%lu is looked for, and it is not its turn", (unsigned long)t.p);
    halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, t.a, t.b, t.c);
    name place = name_of_triangle(in->n, t.a, t.b, t.c);
    expect(s, failed(s) || e != NONE,
           "%lu is found in %s, which is not there after the flips that were reported",
           (unsigned long)t.p, place.text);
    spot how = e != NONE ? sphere_spot(&in->now, t.p, &e) : SPOT_NOWHERE;
    if (expect(s, how != SPOT_NOWHERE, "%lu is looked for in %s, and does not lie there",
               (unsigned long)t.p, place.text)) {
        sphere_split(&in->now, how, e, t.p);
        in->inserted++;
    }
}

static void
replay_flip_at(session *s, insertion *in, told t)
{
    uint32_t p = in->order[in->inserted - 1];
    if (!expect(s, in->inserted > 2 && sphere_flip(&in->now, t.a, t.b, p),
                "after %lu has been inserted %s is flipped, which is not opposite %lu, or "
                "cannot be flipped: each flip is to give %lu one edge more",
                (unsigned long)p, name_of_edge(in->n, t.a, t.b).text, (unsigned long)p,
                (unsigned long)p)) {
        show_witness(s, p);
        if (t.a < in->n)
            show_witness(s, t.a);
        if (t.b < in->n)
            show_witness(s, t.b);
    }
}

/* The result, and that of the replay: Delaunay. */
static void
check_result(session *s, const site *at, uint32_t n)
{
    if (!take_ok(s))
        return;
    triangle_list list = take_triangles(s, n, 2 * n);
    if (failed(s) || !expect_verdict(s, certify_delaunay(at, n, list)))
        return;
    if (cases_are_collinear(at, n))
        take_path(s);
}

static void
check_insertion(session *s, const site *at, uint32_t n, bool flips)
{
    uint32_t *order = room_for(n, sizeof *order);
    begin_case(s, 'c', at, n);
    give_points(s);
    uint32_t count = give_order(s, at, n, order);
    if (ask(s)) {
        insertion in = begin_insertion(at, n, order, count);
        uint32_t events = take_number(s, 0, 20000, "the number of events");
        for (uint32_t i = 0; i < events && !failed(s); i++) {
            told t = take_told(s, n);
            if (flips && !failed(s) && t.kind == TOLD_LOCATE)
                replay_locate(s, &in, t);
            else if (flips && !failed(s) && t.kind == TOLD_FLIP)
                replay_flip_at(s, &in, t);
        }
        check_result(s, at, n);
        expect(s, !flips || failed(s) || count < 3 || in.inserted == count,
               "locate has been asked for %lu points of %lu",
               (unsigned long)in.inserted - 2, (unsigned long)count - 2);
        if (flips && !failed(s)) {
            triangle_list again = sphere_triangles(&in.now);
            keep_triangles(s, again);
            expect_verdict(s, certify_delaunay(at, n, again));
        }
        end_insertion(&in);
    }
    free(order);
}

static void
insertion_is_delaunay(session *s, const site *at, uint32_t n)
{
    check_insertion(s, at, n, false);
}

static void
flips_give_edges(session *s, const site *at, uint32_t n)
{
    check_insertion(s, at, n, true);
}

/* ---- 3.6-e: the points that wait. ---- */

static void
replay_move(session *s, insertion *in, told t)
{
    expect(s, t.p < in->n, "the point that moves has the number %lu", (unsigned long)t.p);
    halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, t.a, t.b, t.c);
    if (!expect(s, e != NONE, "%lu is to wait in %s, which is not there then",
                (unsigned long)t.p, name_of_triangle(in->n, t.a, t.b, t.c).text))
        return;
    const uint32_t home[3] = {t.a, t.b, t.c};
    for (int i = 0; i < 3; i++)
        in->home[t.p][i] = home[i];
    in->waits[t.p] = true;
    in->moves++;
}

/* Before the next point is inserted: is everybody where he waits? */
static void
check_homes(session *s, const insertion *in)
{
    for (uint32_t i = in->inserted; i < in->count && !failed(s); i++) {
        uint32_t q = in->order[i];
        const uint32_t *h = in->home[q];
        expect(s, in->waits[q], "%lu has not been told where to wait", (unsigned long)q);
        halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, h[0], h[1], h[2]);
        name home = name_of_triangle(in->n, h[0], h[1], h[2]);
        expect(s, failed(s) || e != NONE,
               "%lu waits in %s still, which is not there any more", (unsigned long)q,
               home.text);
        if (!failed(s) &&
            !expect(s, sphere_has(&in->now, e / 3, q),
                    "%lu waits in %s, and does not lie there", (unsigned long)q, home.text))
            show_witness(s, q);
    }
}

static void
replay_waiting(session *s, insertion *in, uint32_t events)
{
    for (uint32_t i = 0; i < events && !failed(s); i++) {
        told t = take_told(s, in->n);
        if (failed(s))
            return;
        if (t.kind == TOLD_LOCATE) {
            check_homes(s, in);
            replay_locate(s, in, t);
        } else if (t.kind == TOLD_FLIP) {
            replay_flip_at(s, in, t);
        } else {
            replay_move(s, in, t);
        }
    }
}

/* Counts only; that all is right in the end is seen from the result. */
static void
count_moves(session *s, insertion *in, uint32_t events)
{
    uint32_t located = 0;
    for (uint32_t i = 0; i < events; i++) {
        told t = take_told(s, in->n);
        in->moves += t.kind == TOLD_MOVE;
        located += t.kind == TOLD_LOCATE;
    }
    double most = in->count > 1 ? 6.0 * in->count * log(in->count) : 0;
    expect(s, in->moves <= most, "%lu moves of waiting points for %lu points in random "
                                 "order; 6 n ln n is %.0f",
           (unsigned long)in->moves, (unsigned long)in->count, most);
    expect(s, failed(s) || in->count < 3 || (located + 2 == in->count && in->moves > 0),
           "%lu points, and nobody is told where to wait", (unsigned long)in->count);
}

static void
check_waiting(session *s, const site *at, uint32_t n, bool moves)
{
    uint32_t *order = room_for(n, sizeof *order);
    begin_case(s, 'e', at, n);
    give_points(s);
    uint32_t count = give_order(s, at, n, order);
    if (ask(s)) {
        insertion in = begin_insertion(at, n, order, count);
        uint32_t events = take_number(s, 0, 20000, "the number of events");
        if (moves)
            count_moves(s, &in, events);
        else
            replay_waiting(s, &in, events);
        check_result(s, at, n);
        end_insertion(&in);
    }
    free(order);
}

static void
waiting_points_are_at_home(session *s, const site *at, uint32_t n)
{
    check_waiting(s, at, n, false);
}

static void
moves_are_few(session *s, const site *at, uint32_t n)
{
    check_waiting(s, at, n, true);
}

/* ---- 3.6-d: the shuffle. ---- */

/* The points say how many items there are, and are of no other use. */
static void
every_order_comes(session *s, const site *at, uint32_t n)
{
    (void)at;
    check_shuffles(s, n, false);
    check_long_shuffle(s, 20 * n);
}

static void
orders_are_equally_likely(session *s, const site *at, uint32_t n)
{
    (void)at;
    check_shuffles(s, n, true);
}

enum { EVERYTHING = CASES_GENERAL | CASES_CONVEX | CASES_DEGENERATE };

const property properties[] = {
    {"3.6-a", "triangle",
     "A point in a triangle is joined to its corners; one that sees a hull edge, to its ends",
     "notes 3.6, line 4 of Figure 12; incremental.h", EVERYTHING, 14, 200, false,
     triangles_are_split},
    {"3.6-a", "edge",
     "A point on an edge is joined to four corners; one beyond the end of a path, to the end",
     "docs/errata.md, E42; incremental.h", CASES_DEGENERATE, 14, 200, false,
     edges_are_split},
    {"3.6-a", "links", "After the split all half-edges have their twins, and each vertex "
                       "knows one that leaves it",
     "page 3.6, fig12.P2; lib/mesh.h", EVERYTHING, 14, 200, false, links_are_right},
    {"3.6-b", "place", "The walk finds where p lies: in which triangle, outside of which "
                       "hull edge, on which edge, or beyond which end of a path",
     "page 3.6, walk.P1; walk.h", EVERYTHING, 24, 300, true, place_is_found},
    {"3.6-b", "visits", "The walk visits the triangles that the segment runs through, one "
                        "beside the other, each once, and reports each (TRACE_VISIT)",
     "notes 3.6.4; page 3.6, walk.P2", EVERYTHING, 24, 300, true, walk_is_straight},
    {"3.6-b", "tests", "There are at most two tests for each triangle at the start and for "
                       "each visited one, and three more",
     "page 3.6, walk.P3; walk.h", EVERYTHING, 50, 80, true, walk_is_cheap},
    {"3.6-c", "delaunay", "The result is a Delaunay triangulation",
     "notes 3.6, Figure 12; page 3.6, fig12.P4", CASES_GENERAL | CASES_CONVEX, 40, 100,
     true, insertion_is_delaunay},
    {"3.6-c", "flips",
     "The flips at p are deg(p) - 3, or deg(p) - 4 if p was put on an edge (edges to "
     "infinity counted): each is of an edge opposite p, and gives p one edge",
     "page 3.6, fig12.P3 and fig12.P5", EVERYTHING, 30, 100, true, flips_give_edges},
    {"3.6-c", "degenerate", "So it is when points coincide, or lie on a line or circle",
     "docs/errata.md, E42", CASES_DEGENERATE, 30, 200, true, insertion_is_delaunay},
    {"3.6-d", "permutation", "Every order of the items can come, and nothing else",
     "incremental.h, shuffle", CASES_GENERAL | CASES_FEW, 5, 20, false, every_order_comes},
    {"3.6-d", "fair", "All orders are equally likely: the checker has gone through all "
                      "numbers that random_below can give",
     "page 3.6, chance.P5 and chance.P6", CASES_GENERAL | CASES_FEW, 5, 20, false,
     orders_are_equally_likely},
    {"3.6-e", "waiting", "Each waiting point lies in the triangle with which it waits, and "
                         "is told where (TRACE_MOVE)",
     "page 3.6, buckets.P1; buckets.h", EVERYTHING, 30, 100, true,
     waiting_points_are_at_home},
    {"3.6-e", "moves", "Points move at most 6 n ln n times, for random points in random order",
     "notes 3.6.4; page 3.6, buckets.P4", CASES_GENERAL, 200, 15, true, moves_are_few},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
