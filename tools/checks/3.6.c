/* 3.6.c - the properties of exercises 3.6-a to 3.6-e: incremental insertion. */
#include "tools/checks/checker.h"
#include "tools/checks/insertions.h"
#include "tools/checks/replay.h"
#include "tools/checks/room.h"
#include "tools/checks/scenes.h"
#include "tools/checks/shuffles.h"
#include "tools/checks/sphere.h"
#include "tools/checks/walks.h"

#include <stdlib.h>

/* ---- 3.6-a: the split. ---- */

/* A spot of p, of those that lie in a triangle or outside, or of the others; or
 * SPOT_NOWHERE. */
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
    uint32_t count, e, twin; /* before: how many; a half-edge of the place, its twin */
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
ask_split(session *s, const site *at, uint32_t n, bool in_triangle, scene *sc,
          spot *how, halfedge_id *e, halves *h)
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
    if (*how == SPOT_TRIANGLE)
        show_triangle_of(s, SVG_NEW, sc, *e);
    else
        show_edge(s, SVG_NEW, side_origin(sc->around.list, *e),
                  side_dest(sc->around.list, *e));
    if (!ask(s)) {
        forget_scene(sc);
        return false;
    }
    *h = take_halves(s, sc, n);
    return true;
}

/* Are the triangles afterwards those that they should be? */
static void
check_new_triangles(session *s, const scene *sc, spot how, halfedge_id e,
                    const halves *h)
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
    triangle_id t = failed(s) ? NONE : missing_triangle(expected.list, seen);
    if (t != NONE) {
        const vertex_id *c = expected.list.corner[t];
        expect(s, false,
               "%lu lies %s, %s: the triangles around it afterwards are wrong, %s is "
               "missing",
               (unsigned long)sc->p, spot_name(how), where.text,
               name_of_triangle(sc->around.infinity, c[0], c[1], c[2]).text);
        show_triangle(s, SVG_BAD, sc->around.infinity, c[0], c[1], c[2]);
    }
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
           "%s, the half-edge of the place, does not lead where incremental.h says",
           name_of_edge(sc->around.infinity, a, b).text);
    expect(s, how == SPOT_TRIANGLE ||
                  (h->origin[h->twin] == b && h->origin[next_of(h->twin)] == sc->p),
           "%s, the twin of the half-edge of the place, does not lead to %lu now",
           name_of_edge(sc->around.infinity, b, a).text, (unsigned long)sc->p);
    for (uint32_t i = 0; i + 6 < h->count; i++)
        if (i / 3 != h->e / 3 && (how == SPOT_TRIANGLE || i / 3 != h->twin / 3))
            expect(s, h->origin[i] == h->before[i],
                   "half-edge %lu leaves %lu, and %lu before: it is none of the "
                   "triangles of the place",
                   (unsigned long)i, (unsigned long)h->origin[i],
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
        expect(s,
               h->origin[t] == h->origin[next_of(e)] &&
                   h->origin[e] == h->origin[next_of(t)],
               "half-edges %lu (%s) and %lu (%s) are twins, and do not run between the "
               "same vertices",
               (unsigned long)e,
               name_of_edge(n, h->origin[e], h->origin[next_of(e)]).text,
               (unsigned long)t,
               name_of_edge(n, h->origin[t], h->origin[next_of(t)]).text);
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

/* ---- 3.6-c: insertion. ---- */

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

/* ---- 3.6-e: the points that wait. ---- */

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

enum { EVERYTHING = CASES_GENERAL | CASES_CONVEX | CASES_DEGENERATE };

const property properties[] = {
    {"3.6-a", "triangle",
     "A point in a triangle is joined to its corners; one that sees a hull edge, to "
     "its ends",
     "notes 3.6, line 4 of Figure 12; incremental.h", EVERYTHING, 14, 200, false,
     triangles_are_split},
    {"3.6-a", "edge",
     "A point on an edge is joined to four corners; one beyond the end of a path, to "
     "that end",
     "page 3.6, erratum E42; incremental.h", CASES_DEGENERATE, 14, 200, false,
     edges_are_split},
    {"3.6-a", "links",
     "After the split all half-edges have their twins, and each vertex "
     "knows one that leaves it",
     "page 3.6, fig12.P2; lib/mesh.h", EVERYTHING, 14, 200, false, links_are_right},
    {"3.6-b", "place",
     "The walk finds where p lies: in which triangle, outside of which "
     "hull edge, on which edge, or beyond which end of a path",
     "page 3.6, walk.P1; walk.h", EVERYTHING, 24, 300, true, place_is_found},
    {"3.6-b", "visits",
     "The walk visits the triangles that the segment runs through, one "
     "beside the other, each once, and reports each (TRACE_VISIT)",
     "notes 3.6.4; page 3.6, walk.P2", EVERYTHING, 24, 300, true, walk_is_straight},
    {"3.6-b", "tests",
     "There are at most two tests for each triangle at the start and for each visited "
     "one, and three more",
     "page 3.6, walk.P3; walk.h", EVERYTHING, 50, 80, true, walk_is_cheap},
    {"3.6-c", "delaunay", "The result is a Delaunay triangulation",
     "notes 3.6, Figure 12; page 3.6, fig12.P4", CASES_GENERAL | CASES_CONVEX, 40, 100,
     true, insertion_is_delaunay},
    {"3.6-c", "flips",
     "The flips at p are deg(p) - 3, or deg(p) - 4 if p was put on an edge (edges to "
     "infinity counted): each is of an edge opposite p, and gives p one edge",
     "page 3.6, fig12.P3 and fig12.P5", EVERYTHING, 30, 100, true, flips_give_edges},
    {"3.6-c", "degenerate",
     "The result is Delaunay, too, when points coincide, or lie on a line or circle",
     "page 3.6, erratum E42", CASES_DEGENERATE, 30, 200, true, insertion_is_delaunay},
    {"3.6-d", "permutation", "Every order of the items can come, and nothing else",
     "incremental.h, shuffle", CASES_GENERAL | CASES_FEW, 5, 20, false,
     every_order_comes},
    {"3.6-d", "fair",
     "All orders are equally likely: the checker has gone through all "
     "numbers that random_below can give",
     "page 3.6, chance.P5 and chance.P6", CASES_GENERAL | CASES_FEW, 5, 20, false,
     orders_are_equally_likely},
    {"3.6-e", "waiting",
     "Each waiting point lies in the triangle with which it waits, and is told where "
     "(TRACE_MOVE)",
     "page 3.6, buckets.P1; buckets.h", EVERYTHING, 30, 100, true,
     waiting_points_are_at_home},
    {"3.6-e", "moves",
     "Points move at most 6 n ln n times, for random points in random order",
     "notes 3.6.4; page 3.6, buckets.P4", CASES_GENERAL, 200, 15, true, moves_are_few},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
