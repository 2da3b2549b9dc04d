/* 2.3.c - the properties of exercises 2.3-a to 2.3-d: the line sweep. */
#include "tools/checks/certify.h"
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/room.h"

#include <stdlib.h>
#include <string.h>

/* ---- 2.3-a: the order of the sweep. ---- */

static site
give_direction(session *s)
{
    site d = {1, 0};
    if (random_below(trial_random(s), 2) == 0)
        do
            d = (site){(int32_t)random_below(trial_random(s), 7) - 3,
                       (int32_t)random_below(trial_random(s), 7) - 3};
        while (d.x == 0 && d.y == 0);
    give_real(s, d.x);
    give_real(s, d.y);
    return d;
}

static uint32_t
count_locations(const site *p, uint32_t n)
{
    uint32_t *lowest = room_for(n, sizeof *lowest);
    uint32_t count = cases_locations(p, n, lowest);
    free(lowest);
    return count;
}

static void
order_is_right(session *s, const site *p, uint32_t n)
{
    begin_case(s, 'a', p, n);
    give_points(s);
    site d = give_direction(s);
    if (strcmp(variant_of(s), "from-right") == 0)
        d = (site){-d.x, -d.y}; /* the line moves the other way */
    if (!ask(s) || !take_ok(s))
        return;
    uint32_t count = take_number(s, 0, n, "the number of locations");
    expect(s, failed(s) || count == count_locations(p, n),
           "%lu locations, but there are %lu", (unsigned long)count,
           (unsigned long)count_locations(p, n));
    uint32_t before = 0;
    for (uint32_t i = 0; i < count && !failed(s); i++) {
        uint32_t v = take_number(s, 0, n - 1, "an index in order[]");
        if (i > 0 && !failed(s))
            show_edge(s, SVG_NEW, before, v);
        if (i > 0 && !failed(s) &&
            !expect(
                s, plane_along(d, p[before], p[v]) < 0,
                "%lu is listed right before %lu, but a line that moves along (%ld,%ld) "
                "does not meet it first",
                (unsigned long)before, (unsigned long)v, (long)d.x, (long)d.y)) {
            show_witness(s, before);
            show_witness(s, v);
        }
        before = v;
    }
    take_end(s);
}

/* 2 n ceil(log2 n) */
static uint64_t
most_comparisons(uint32_t n)
{
    uint32_t log = 0;
    while ((1u << log) < n)
        log++;
    return 2 * (uint64_t)n * log;
}

/* A wrong order may be cheap: only a right one counts. */
static void
order_is_cheap(session *s, const site *p, uint32_t n)
{
    order_is_right(s, p, n);
    expect(s, asked_in_all(s) <= most_comparisons(n),
           "%llu comparisons for %lu points; 2 n ceil(log2 n) is %llu",
           (unsigned long long)asked_in_all(s), (unsigned long)n,
           (unsigned long long)most_comparisons(n));
}

/* ---- 2.3-b: the hull edges that p sees. ---- */

/* What has been swept before p: a triangulation, or a path. */
typedef struct scene {
    uint32_t p, latest; /* the last two locations in the order of the sweep */
    piece before;       /* of all other points than p */
} scene;

/* Finds p and the location before it; false when there are fewer than three. */
static bool
find_last_two(const site *p, uint32_t n, scene *sc)
{
    static const site rightwards = {1, 0};
    uint32_t *order = room_for(n, sizeof *order);
    uint32_t count = cases_locations(p, n, order);
    for (uint32_t i = 0; i < 2 && i + 1 < count; i++) /* the two largest to the front */
        for (uint32_t j = i + 1; j < count; j++)
            if (plane_along(rightwards, p[order[i]], p[order[j]]) < 0) {
                uint32_t other = order[i];
                order[i] = order[j];
                order[j] = other;
            }
    sc->p = order[0];
    sc->latest = count > 1 ? order[1] : order[0];
    free(order);
    return count >= 3;
}

static void
set_scene(session *s, scene *sc, const site *p, uint32_t n)
{
    uint32_t *swept = room_for(n, sizeof *swept), count = 0;
    for (uint32_t i = 0; i < n; i++)
        if (!plane_same(p[i], p[sc->p]))
            swept[count++] = i;
    sc->before = piece_at_random(trial_random(s), p, swept, count, false);
    keep_triangles(s, sc->before.list);
    free(swept);
}

static void
give_scene(session *s, const scene *sc)
{
    give_points(s);
    if (sc->before.list.count > 0)
        give_triangles(s, sc->before.list);
    else
        give_path(s, sc->before.path, sc->before.length);
    show_path(s, sc->before.path, sc->before.length);
    give_number(s, sc->latest);
    give_number(s, sc->p);
}

/* How many hull edges p sees; those of a path count on the side towards p. They are
 * shown when the trial has failed. */
static uint32_t
count_seen(session *s, const scene *sc, const site *p)
{
    uint32_t count = 0;
    triangle_list list = sc->before.list;
    halfedge_id *twin = room_for(3 * list.count, sizeof *twin);
    certify_twins(list, twin);
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        if (twin[e] == NONE && plane_orient(p[side_origin(list, e)],
                                            p[side_dest(list, e)], p[sc->p]) < 0) {
            count++;
            if (failed(s))
                show_edge(s, SVG_BAD, side_origin(list, e), side_dest(list, e));
        }
    const uint32_t *path = sc->before.path;
    for (uint32_t i = 1; i < sc->before.length; i++)
        if (plane_orient(p[path[i - 1]], p[path[i]], p[sc->p]) != 0) {
            count++;
            if (failed(s))
                show_edge(s, SVG_BAD, path[i - 1], path[i]);
        }
    free(twin);
    return count;
}

/* The chain of the answer: does it have as many edges as are seen? */
static void
check_length(session *s, const site *p, const scene *sc, uint32_t begins,
             uint32_t length)
{
    uint32_t seen = count_seen(s, sc, p);
    expect(s, length == seen, "the chain has %lu edges, but %lu sees %lu",
           (unsigned long)length, (unsigned long)sc->p, (unsigned long)seen);
    expect(s, length > 0 || begins == sc->latest,
           "nothing is seen, and the place on the hull is at %lu, not at %lu",
           (unsigned long)begins, (unsigned long)sc->latest);
    if (failed(s))
        count_seen(s, sc, p);
}

/* Is each of its edges seen, from the first to the last? */
static void
check_chain(session *s, const site *p, uint32_t n, bool all)
{
    scene sc = {0};
    if (!find_last_two(p, n, &sc))
        return;
    set_scene(s, &sc, p, n);
    begin_case(s, 'b', p, n);
    give_scene(s, &sc);
    uint32_t *chain = room_for(n, sizeof *chain), length = 0;
    if (ask(s)) {
        length = take_number(s, 0, n - 1, "the length of the chain");
        for (uint32_t i = 0; i <= length; i++)
            chain[i] = take_number(s, 0, n - 1, "a vertex of the chain");
        take_end(s);
    }
    if (!failed(s)) {
        show_witness(s, sc.p);
        for (uint32_t i = 0; i < length; i++)
            show_edge(s, SVG_NEW, chain[i], chain[i + 1]);
        if (all)
            check_length(s, p, &sc, chain[0], length);
        else
            expect(s, length > 0 || count_seen(s, &sc, p) == 0,
                   "the chain is empty, but %lu sees %lu of the hull edges",
                   (unsigned long)sc.p, (unsigned long)count_seen(s, &sc, p));
    }
    for (uint32_t i = 0; i < length && !failed(s); i++)
        if (!expect(
                s, plane_orient(p[chain[i]], p[chain[i + 1]], p[sc.p]) < 0,
                "hull edge %lu-%lu is in the chain, and %lu is not strictly right of "
                "it",
                (unsigned long)chain[i], (unsigned long)chain[i + 1],
                (unsigned long)sc.p))
            show_edge(s, SVG_BAD, chain[i], chain[i + 1]);
    free(chain);
    free(sc.before.path);
}

static void
what_is_listed_is_seen(session *s, const site *p, uint32_t n)
{
    check_chain(s, p, n, false);
}

static void
what_is_seen_is_listed(session *s, const site *p, uint32_t n)
{
    check_chain(s, p, n, true);
}

/* ---- 2.3-c: the sweep. ---- */

static void
sweep_triangulates(session *s, const site *p, uint32_t n)
{
    begin_case(s, 'c', p, n);
    give_points(s);
    give_direction(s);
    if (!ask(s) || !take_ok(s))
        return;
    triangle_list list = take_triangles(s, n, 2 * n);
    if (failed(s) || !expect_verdict(s, certify_triangulation(p, n, list)))
        return;
    if (cases_are_collinear(p, n))
        take_path(s);
}

static void
sweep_is_cheap(session *s, const site *p, uint32_t n)
{
    sweep_triangulates(s, p, n);
    expect(s, asked(s, WIRE_ORIENT) <= 6 * (uint64_t)n,
           "%llu orientation tests for %lu points; 6 n is %llu",
           (unsigned long long)asked(s, WIRE_ORIENT), (unsigned long)n,
           6 * (unsigned long long)n);
}

/* ---- 2.3-d: the hull. ---- */

/* The same hull the other way around, from the same vertex. */
static void
turn_around(uint32_t *vertex, uint32_t count)
{
    for (uint32_t i = 1, k = count; i + 1 < k; i++) {
        uint32_t v = vertex[--k];
        vertex[k] = vertex[i];
        vertex[i] = v;
    }
}

static void
hull_is_right(session *s, const site *p, uint32_t n)
{
    uint32_t *vertex = room_for(n, sizeof *vertex);
    triangle_list list = mesh_at_random(trial_random(s), p, n, false);
    keep_triangles(s, list);
    begin_case(s, 'd', p, n);
    give_points(s);
    if (list.count > 0)
        give_triangles(s, list);
    else
        give_path(s, vertex, path_of(p, n, vertex));
    if (ask(s)) {
        uint32_t count = take_number(s, 0, n, "the number of hull vertices");
        for (uint32_t i = 0; i < count && !failed(s); i++)
            vertex[i] = take_number(s, 0, n - 1, "a hull vertex");
        take_end(s);
        for (uint32_t i = 0; i < count && !failed(s); i++)
            if (i + 1 < count || list.count > 0)
                show_edge(s, SVG_NEW, vertex[i], vertex[(i + 1) % count]);
        if (strcmp(variant_of(s), "clockwise") == 0 && list.count > 0)
            turn_around(vertex, count);
        if (!failed(s))
            expect_verdict(s, certify_hull(p, n, vertex, count));
    }
    free(vertex);
}

const property properties[] = {
    {"2.3-a", "order", "The locations come in the order in which the line meets them",
     "notes 2.3, line 1 of Figure 3", CASES_GENERAL | CASES_DEGENERATE, 60, 300, true,
     order_is_right},
    {"2.3-a", "comparisons", "There are at most 2 n ceil(log2 n) comparisons",
     "page 2.3, what it costs", CASES_GENERAL | CASES_GRID | CASES_COLLINEAR, 300, 20,
     true, order_is_cheap},
    {"2.3-b", "sees", "p sees every hull edge of the chain",
     "notes 2.3, line 4 of Figure 3; page 2.3, fig3.P2",
     CASES_GENERAL | CASES_DEGENERATE | CASES_CONVEX, 30, 300, true,
     what_is_listed_is_seen},
    {"2.3-b", "chain", "The chain has every hull edge that p sees",
     "notes 2.3, line 4 of Figure 3; page 2.3, fig3.P1 and fig3.P2",
     CASES_GENERAL | CASES_DEGENERATE | CASES_CONVEX, 30, 300, true,
     what_is_seen_is_listed},
    {"2.3-c", "triangulation", "The result is a triangulation of the points",
     "notes 2.3, Figure 3; Definition 4; page 2.3, fig3.P3",
     CASES_GENERAL | CASES_CONVEX, 60, 100, true, sweep_triangulates},
    {"2.3-c", "degenerate",
     "The result is a triangulation of the points when some coincide, or lie on a line "
     "or circle",
     "page 2.3, where it breaks", CASES_DEGENERATE, 40, 300, true, sweep_triangulates},
    {"2.3-c", "tests", "There are at most 6 n orientation tests",
     "page 2.3, what it costs", CASES_GENERAL | CASES_CONVEX | CASES_GRID, 300, 20,
     true, sweep_is_cheap},
    {"2.3-d", "hull", "The hull is listed counterclockwise, edge points included",
     "notes 2.3, last paragraph", CASES_GENERAL | CASES_CONVEX, 30, 100, true,
     hull_is_right},
    {"2.3-d", "degenerate",
     "The hull is right, too, when points coincide or lie on a line",
     "page 2.3, where it breaks", CASES_DEGENERATE, 30, 200, true, hull_is_right},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
