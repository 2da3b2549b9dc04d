/* walks.c - a walk, triangle by triangle. */
#include "tools/checks/walks.h"

#include "tools/checks/room.h"
#include "tools/checks/scenes.h"

#include <stdlib.h>

static halfedge_id
next_side(halfedge_id e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* Whether triangle t meets the segment from v to p. Two convex sets are apart exactly
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
    expect(s, failed(s) || e != NONE, "%s: %lu-%lu-%lu is no triangle of the mesh",
           what, (unsigned long)a, (unsigned long)b, (unsigned long)c);
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
    expect(s, found != SPOT_NOWHERE,
           "the place is said to be %s, and %lu does not lie there",
           name_of(sc, e).text, (unsigned long)sc->p);
    expect(s, found == *kind, "the place is said to be %s, and %lu lies %s (%s)",
           spot_name(*kind), (unsigned long)sc->p, spot_name(found),
           name_of(sc, e).text);
    expect(
        s, found == SPOT_TRIANGLE || e == exact,
        "the triangle of the place is right, but its half-edge is to lead from %lu to "
        "%lu",
        (unsigned long)side_origin(sc->around.list, exact),
        (unsigned long)side_dest(sc->around.list, exact));
    if (failed(s))
        show_triangle_of(s, SVG_BAD, sc, e);
    return failed(s) ? NONE : e;
}

/* One more triangle of the walk: not twice, beside the one before, and on the
 * segment. */
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
    for (int i = 0; before != NONE && i < 3; i++, before = next_side(before))
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
        if (!failed(s))
            show_triangle_of(s, SVG_NEW, sc, e);
        check_visit(s, sc, at, v, before, e, visited);
        before = e;
    }
    take_end(s);
    for (triangle_id t = 0; t < sc->before.list.count && !failed(s); t++)
        if (!expect(s, visited[t] || meets_segment(at, list, t, v, sc->p) != ENTERED,
                    "the segment from %lu to %lu runs through %s, which is not visited",
                    (unsigned long)v, (unsigned long)sc->p, name_of(sc, 3 * t).text))
            show_triangle_of(s, SVG_BAD, sc, 3 * t);
    if (!failed(s) && kind == SPOT_TRIANGLE &&
        !expect(s, visited[place / 3], "%s, the place, is not visited",
                name_of(sc, place).text))
        show_triangle_of(s, SVG_BAD, sc, place);
    free(visited);
    return visits;
}

/* How many edges end at v and at the vertices on the way to p; also those to
 * infinity. */
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

void
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
    show_edge(s, SVG_STRONG, v, sc.p);
    if (ask(s)) {
        spot kind;
        halfedge_id place = take_place(s, &sc, n, &kind);
        uint32_t seen = visits ? take_visits(s, &sc, at, n, v, kind, place) : 0;
        uint64_t most = 2 * (uint64_t)(count_edges_at_start(&sc, at, n, v) + seen) + 3;
        uint64_t asked_tests = asked(s, WIRE_ORIENT) + asked(s, WIRE_INCIRCLE);
        if (tests)
            expect(s, failed(s) || asked_tests <= most,
                   "%llu tests on the way from %lu to %lu, with %lu triangles; two for "
                   "each of these and for each at the start, and three more, are %llu",
                   (unsigned long long)asked_tests,
                   (unsigned long)v, (unsigned long)sc.p, (unsigned long)seen,
                   (unsigned long long)most);
    }
    forget_scene(&sc);
}
