/* 3.5.c - the properties of exercises 3.5-a to 3.5-d: edge flips. */
#include "tools/checks/certify.h"
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/replay.h"
#include "tools/checks/room.h"
#include "tools/checks/turns.h"

#include <stdlib.h>
#include <string.h>

/* A case about a random triangulation; empty when there is none. */
static triangle_list
give_triangulation(session *s, char exercise, const site *p, uint32_t n)
{
    triangle_list list = mesh_at_random(trial_random(s), p, n, false);
    keep_triangles(s, list);
    begin_case(s, exercise, p, n);
    give_points(s);
    give_triangles(s, list);
    return list;
}

/* ---- 3.5-a: locally Delaunay. ---- */

/* One answer about side e, and whether it is right. */
static void
check_side(session *s, const site *p, triangle_list list, halfedge_id e,
           halfedge_id twin)
{
    bool says = take_number(s, 0, 1, "the answer of is_locally_delaunay") == 1;
    vertex_id w[4] = {side_origin(list, e), side_dest(list, e), side_apex(list, e), 0};
    bool holds = true;
    if (twin != NONE) {
        w[3] = side_apex(list, twin);
        holds = plane_incircle(p[w[0]], p[w[1]], p[w[2]], p[w[3]]) <= 0;
    }
    if (failed(s) || says == holds)
        return;
    if (twin == NONE)
        expect(s, false,
               "%lu-%lu is on the hull, and is said not to be locally Delaunay",
               (unsigned long)w[0], (unsigned long)w[1]);
    else
        expect(s, false,
               "%lu-%lu is said %sto be locally Delaunay, and %lu lies %s the "
               "circle of %lu, %lu, %lu",
               (unsigned long)w[0], (unsigned long)w[1], says ? "" : "not ",
               (unsigned long)w[3], holds ? "not inside" : "inside",
               (unsigned long)w[0], (unsigned long)w[1], (unsigned long)w[2]);
    for (int i = 0; i < (twin == NONE ? 2 : 4); i++)
        show_witness(s, w[i]);
}

/* Checks all sides; those inside, or those on the hull. */
static void
check_sides(session *s, const site *p, uint32_t n, bool hull)
{
    triangle_list list = give_triangulation(s, 'a', p, n);
    if (list.count == 0 || !ask(s))
        return;
    halfedge_id *twin = room_for(3 * list.count, sizeof *twin);
    certify_twins(list, twin);
    for (halfedge_id e = 0; e < 3 * list.count && !failed(s); e++)
        /* e, and the same edge from its other side */
        for (int side = 0; side < 2; side++)
            if ((twin[e] == NONE) == hull)
                check_side(s, p, list, e, twin[e]);
            else
                take_number(s, 0, 1, "the answer of is_locally_delaunay");
    take_end(s);
    free(twin);
}

static void
inner_edges_are_judged(session *s, const site *p, uint32_t n)
{
    check_sides(s, p, n, false);
}

static void
hull_edges_are_judged(session *s, const site *p, uint32_t n)
{
    check_sides(s, p, n, true);
}

/* ---- 3.5-b: the flip. ---- */

/* A mesh that was flipped, as reported: half-edges and vertices. */
typedef struct reported {
    uint32_t count;
    uint32_t *origin, *twin; /* half-edge -> */
    uint32_t *leaving;       /* vertex -> */
} reported;

static reported
take_reported(session *s, uint32_t n, uint32_t count)
{
    reported r = {count, room_for(count, sizeof *r.origin),
                  room_for(count, sizeof *r.twin), room_for(n, sizeof *r.leaving)};
    uint32_t told = take_number(s, 0, UINT32_MAX, "the number of half-edges");
    expect(s, told == count, "there are %lu half-edges after the flip, and %lu before",
           (unsigned long)told, (unsigned long)count);
    for (uint32_t e = 0; e < count; e++) {
        r.origin[e] = take_number(s, 0, UINT32_MAX, "an origin");
        r.twin[e] = take_number(s, 0, count - 1, "a twin");
    }
    for (uint32_t v = 0; v < n; v++)
        r.leaving[v] = take_number(s, 0, UINT32_MAX, "a half-edge leaving a vertex");
    take_end(s);
    return r;
}

static void
forget_reported(reported *r)
{
    free(r->origin);
    free(r->twin);
    free(r->leaving);
}

static uint32_t
next_of(uint32_t e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* Some side that can be flipped, or NONE. */
static halfedge_id
some_flippable(session *s, const site *p, triangle_list list, quadrilateral *q)
{
    uint32_t sides = 3 * list.count;
    uint32_t start = sides > 0 ? random_below(trial_random(s), sides) : 0;
    for (uint32_t i = 0; i < sides; i++) {
        halfedge_id e = (start + i) % sides;
        if (find_quadrilateral(list, side_origin(list, e), side_dest(list, e), q) &&
            is_strictly_convex(p, q))
            return e;
    }
    return NONE;
}

static uint32_t
count_locations(const site *p, uint32_t n)
{
    uint32_t *lowest = room_for(n, sizeof *lowest),
             count = cases_locations(p, n, lowest);
    free(lowest);
    return count;
}

/* Flips some edge so many times; false when there is none, or no answer. */
static bool
ask_flips(session *s, const site *p, uint32_t n, uint32_t times, triangle_list *list,
          quadrilateral *q, reported *r)
{
    *list = give_triangulation(s, 'b', p, n);
    halfedge_id e = some_flippable(s, p, *list, q);
    if (e == NONE)
        return false;
    give_number(s, e);
    give_number(s, times);
    if (!ask(s))
        return false;
    *r = take_reported(s, n, 6 * count_locations(p, n) - 6);
    return true;
}

/* Do the half-edges make a closed surface: twins of each other, with the same ends? */
static void
check_links(session *s, const reported *r)
{
    for (uint32_t e = 0; e < r->count && !failed(s); e++) {
        uint32_t t = r->twin[e];
        expect(s, t != e && r->twin[t] == e,
               "the twin of half-edge %lu is %lu, but the twin of that is %lu",
               (unsigned long)e, (unsigned long)t, (unsigned long)r->twin[t]);
        expect(s,
               r->origin[t] == r->origin[next_of(e)] &&
                   r->origin[e] == r->origin[next_of(t)],
               "half-edges %lu (%lu-%lu) and %lu (%lu-%lu) are twins, and do not run "
               "between the same vertices",
               (unsigned long)e, (unsigned long)r->origin[e],
               (unsigned long)r->origin[next_of(e)], (unsigned long)t,
               (unsigned long)r->origin[t], (unsigned long)r->origin[next_of(t)]);
    }
}

static void
links_are_right(session *s, const site *p, uint32_t n)
{
    triangle_list list;
    quadrilateral q;
    reported r;
    if (!ask_flips(s, p, n, 1, &list, &q, &r))
        return;
    triangle_list expected = copy_triangles(list), seen = copy_triangles(list);
    replay_flip(expected, &q);
    for (uint32_t e = 0; e < 3 * list.count; e++)
        seen.corner[e / 3][e % 3] = r.origin[e];
    expect(s, failed(s) || missing_triangle(expected, seen) == NONE,
           "%lu-%lu was to become %lu-%lu: the triangles are not those around %lu-%lu",
           (unsigned long)q.a, (unsigned long)q.b, (unsigned long)q.c,
           (unsigned long)q.d, (unsigned long)q.c, (unsigned long)q.d);
    check_links(s, &r);
    expect(s, failed(s) || (r.origin[q.ab] == q.d && r.origin[q.ba] == q.c),
           "the half-edge that led from %lu to %lu does not lead from %lu to %lu",
           (unsigned long)q.a, (unsigned long)q.b, (unsigned long)q.d,
           (unsigned long)q.c);
    if (failed(s)) {
        show_edge(s, SVG_NEW, q.c, q.d);
        show_edge(s, SVG_BAD, q.a, q.b);
    }
    triangle_list_free(&expected);
    triangle_list_free(&seen);
    forget_reported(&r);
}

static void
vertices_leave(session *s, const site *p, uint32_t n)
{
    triangle_list list;
    quadrilateral q;
    reported r;
    if (!ask_flips(s, p, n, 1, &list, &q, &r))
        return;
    for (uint32_t v = 0; v < n && !failed(s); v++)
        if (r.leaving[v] != NONE &&
            !expect(s, r.leaving[v] < r.count && r.origin[r.leaving[v]] == v,
                    "the half-edge that is to leave vertex %lu leaves another one",
                    (unsigned long)v))
            show_witness(s, v);
    /* A flip that changes nothing leaves all vertices as they were. */
    expect(s, failed(s) || (r.origin[q.ab] == q.d && r.origin[q.ba] == q.c),
           "the edge %lu-%lu has not become %lu-%lu", (unsigned long)q.a,
           (unsigned long)q.b, (unsigned long)q.c, (unsigned long)q.d);
    forget_reported(&r);
}

/* After two flips ab is there again, and after four everything is where it was. */
static void
flips_are_undone(session *s, const site *p, uint32_t n)
{
    triangle_list list;
    quadrilateral q;
    reported once, r;
    if (!ask_flips(s, p, n, 4, &list, &q, &r))
        return;
    for (uint32_t e = 0; e < 3 * list.count && !failed(s); e++)
        expect(s, r.origin[e] == side_origin(list, e),
               "after four flips of the same edge half-edge %lu leaves vertex %lu, and "
               "%lu before",
               (unsigned long)e, (unsigned long)r.origin[e],
               (unsigned long)side_origin(list, e));
    check_links(s, &r);
    forget_reported(&r);
    if (failed(s) || !ask_flips(s, p, n, 1, &list, &q, &once))
        return;
    expect(s, failed(s) || once.origin[q.ab] == q.d,
           "after one flip the half-edge from %lu to %lu leaves %lu, and not %lu",
           (unsigned long)q.a, (unsigned long)q.b, (unsigned long)once.origin[q.ab],
           (unsigned long)q.d);
    if (failed(s)) {
        show_edge(s, SVG_NEW, q.c, q.d);
        show_edge(s, SVG_BAD, q.a, q.b);
    }
    forget_reported(&once);
}

/* ---- 3.5-c: LawsonFlip. ---- */

/* Does the reported flips again; counts them. The list is changed. */
static uint32_t
replay_all(session *s, const site *p, uint32_t n, triangle_list list, bool needed)
{
    uint32_t flips = take_number(s, 0, 4 * n * n, "the number of flips");
    for (uint32_t i = 0; i < flips && !failed(s); i++) {
        vertex_id a = take_number(s, 0, n - 1, "the end of a flipped edge");
        vertex_id b = take_number(s, 0, n - 1, "the end of a flipped edge");
        quadrilateral q;
        if (failed(s) ||
            !expect(s, find_quadrilateral(list, a, b, &q),
                    "flip %lu is to be of %lu-%lu, which is no inner edge then",
                    (unsigned long)i + 1, (unsigned long)a, (unsigned long)b)) {
            show_edge(s, SVG_BAD, a, b);
            break;
        }
        if (!expect(
                s, is_strictly_convex(p, &q),
                "flip %lu is of %lu-%lu, whose quadrilateral is not strictly convex",
                (unsigned long)i + 1, (unsigned long)a, (unsigned long)b) ||
            !expect(s, !needed || plane_incircle(p[q.a], p[q.b], p[q.c], p[q.d]) > 0,
                    "flip %lu is of %lu-%lu, which is locally Delaunay: %lu is not "
                    "inside the circle of %lu, %lu, %lu",
                    (unsigned long)i + 1, (unsigned long)a, (unsigned long)b,
                    (unsigned long)q.d, (unsigned long)q.a, (unsigned long)q.b,
                    (unsigned long)q.c)) {
            const vertex_id w[4] = {q.a, q.b, q.c, q.d};
            for (int k = 0; k < (is_strictly_convex(p, &q) ? 4 : 2); k++)
                show_witness(s, w[k]);
            show_edge(s, SVG_NEW, q.c, q.d);
            break;
        }
        replay_flip(list, &q);
    }
    return flips;
}

/* Inner edges: every triangle has three sides, and the others are on the hull. */
static uint32_t
count_inner_edges(triangle_list list)
{
    halfedge_id *twin = room_for(3 * list.count, sizeof *twin);
    uint32_t sides = 0;
    certify_twins(list, twin);
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        sides += twin[e] != NONE;
    free(twin);
    return sides / 2;
}

/* The variant `queue`: how the edges came and went. The list is changed. */
static void
check_turns(session *s, const site *p, uint32_t n, triangle_list list)
{
    uint32_t count = take_number(s, 0, WIRE_MOST_WORDS / 2, "the number of events");
    turn *report = room_for(count, sizeof *report);
    for (uint32_t i = 0; i < count; i++) {
        report[i].kind = (turn_kind)take_number(s, 0, 2, "the kind of an event");
        report[i].e = take_number(s, 0, 6 * n, "a half-edge");
    }
    take_end(s);
    if (!failed(s))
        expect_verdict(s, certify_turns(p, list, report, count));
    free(report);
}

/* The result is what the flips make of the case, and Delaunay. */
static void
check_lawson_flip(session *s, const site *p, uint32_t n, bool needed, bool cheap)
{
    triangle_list given = give_triangulation(s, 'c', p, n);
    if (given.count == 0 || !ask(s))
        return;
    uint64_t tests = asked(s, WIRE_INCIRCLE);
    uint32_t inner = count_inner_edges(given);
    triangle_list list = copy_triangles(given);
    keep_triangles(s, list);
    uint32_t flips = replay_all(s, p, n, list, needed);
    if (!failed(s))
        expect_verdict(s, certify_delaunay(p, n, take_triangles(s, n, 2 * n)));
    if (needed && !failed(s)) {
        triangle_list again = copy_triangles(list);
        keep_triangles(s, again);
        expect_verdict(s, certify_delaunay(p, n, again));
    }
    if (needed && !cheap && !failed(s) && strcmp(variant_of(s), "queue") == 0) {
        triangle_list again = copy_triangles(given);
        keep_triangles(s, again);
        check_turns(s, p, n, again);
    }
    if (cheap)
        expect(s, failed(s) || tests <= inner + 4 * (uint64_t)flips,
               "%llu incircle tests for %lu inner edges and %lu flips; E + 4F is %llu",
               (unsigned long long)tests, (unsigned long)inner, (unsigned long)flips,
               (unsigned long long)inner + 4 * (unsigned long long)flips);
}

static void
result_is_delaunay(session *s, const site *p, uint32_t n)
{
    check_lawson_flip(s, p, n, false, false);
}

static void
flips_are_needed(session *s, const site *p, uint32_t n)
{
    check_lawson_flip(s, p, n, true, false);
}

static void
tests_are_few(session *s, const site *p, uint32_t n)
{
    check_lawson_flip(s, p, n, true, true);
}

/* ---- 3.5-d: a way between two triangulations. ---- */

static void
check_path(session *s, const site *p, uint32_t n, bool count)
{
    triangle_list to = mesh_at_random(trial_random(s), p, n, false);
    keep_triangles(s, to);
    triangle_list from = give_triangulation(s, 'd', p, n);
    give_triangles(s, to);
    if (from.count == 0 || !ask(s))
        return;
    take_ok(s);
    triangle_list now = copy_triangles(from);
    keep_triangles(s, now);
    uint32_t flips = replay_all(s, p, n, now, false), u = count_locations(p, n);
    take_end(s);
    triangle_id t = failed(s) ? NONE : missing_triangle(to, now);
    if (t != NONE) {
        expect(
            s, false,
            "after %lu flips the triangles are not those of the second triangulation: "
            "%lu-%lu-%lu is missing",
            (unsigned long)flips, (unsigned long)to.corner[t][0],
            (unsigned long)to.corner[t][1], (unsigned long)to.corner[t][2]);
        show_face(s, SVG_BAD, to.corner[t], 3);
    }
    if (count)
        expect(s, failed(s) || flips <= u * (u - 1),
               "%lu flips for %lu locations; n (n-1) is %lu", (unsigned long)flips,
               (unsigned long)u, (unsigned long)(u * (u - 1)));
}

static void
path_leads_there(session *s, const site *p, uint32_t n)
{
    check_path(s, p, n, false);
}

static void
path_is_short(session *s, const site *p, uint32_t n)
{
    check_path(s, p, n, true);
}

enum { EVERYTHING = CASES_GENERAL | CASES_CONVEX | CASES_DEGENERATE };

const property properties[] = {
    {"3.5-a", "interior",
     "An edge of two triangles abc and abd is locally Delaunay exactly when d is not "
     "inside the circle of abc",
     "notes 3.5, Definition 9; page 3.5, erratum E32", EVERYTHING, 16, 200, true,
     inner_edges_are_judged},
    {"3.5-a", "hull", "An edge of one triangle only is locally Delaunay",
     "notes 3.5, Definition 9", EVERYTHING, 16, 100, true, hull_edges_are_judged},
    {"3.5-b", "links",
     "After the flip all half-edges have their twins, and the triangles "
     "abc and bad have become dca and cdb",
     "notes 3.5.1; page 3.5, flip.P1; flips.h", EVERYTHING, 16, 200, false,
     links_are_right},
    {"3.5-b", "vertices", "After the flip each vertex knows a half-edge that leaves it",
     "lib/mesh.h, mesh_leaving", EVERYTHING, 16, 200, false, vertices_leave},
    {"3.5-b", "inverse", "Four flips of the same half-edge restore everything",
     "page 3.5, flip.P2", EVERYTHING, 16, 200, false, flips_are_undone},
    {"3.5-c", "delaunay", "The result is a Delaunay triangulation",
     "notes 3.5, Theorem 3; page 3.5, fig10.P5", EVERYTHING, 24, 150, true,
     result_is_delaunay},
    {"3.5-c", "needed",
     "Each flip is of an edge that is not locally Delaunay, and is "
     "reported by flip (trace_report); from a queue the edge that has "
     "waited longest is taken",
     "notes 3.5, lines 3 and 4 of Figure 10", EVERYTHING, 24, 150, true,
     flips_are_needed},
    {"3.5-c", "tests",
     "There are at most E + 4F incircle tests, for E inner edges and F "
     "flips",
     "page 3.5, what it costs", EVERYTHING, 24, 100, true, tests_are_few},
    {"3.5-d", "ends", "The flips lead from the first triangulation to the second",
     "notes 3.5.4; page 3.5, flipgraph.P4", EVERYTHING, 14, 150, false,
     path_leads_there},
    {"3.5-d", "flips", "There are at most n (n-1) flips", "notes 3.5.4, Theorem 5",
     EVERYTHING, 14, 150, false, path_is_short},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
