/* 3.3.c - the properties of exercises 3.3-a and 3.3-b: the lifting map. */
#include "tools/checks/checker.h"
#include "tools/checks/lifted.h"
#include "tools/checks/room.h"

#include <stdlib.h>

/* ---- 3.3-a: below the plane is inside the circle. ---- */

/* Four points around some far centre; what is asked does not change when all are moved,
 * but a function that computes with int has a surprise coming. */
static bool
ask_lifting(session *s, const site *p, uint32_t n, bool draw, point2 *first)
{
    if (n < 4 || plane_orient(p[0], p[1], p[2]) == 0)
        return false;
    random_source *random = trial_random(s);
    uint32_t far = random_below(random, 3) == 0 ? 0 : (1u << 26) - 2 * PLANE_REACH;
    double x = random_below(random, far + 1), y = random_below(random, far + 1);
    begin_case(s, 'a', draw ? p : NULL, draw ? n : 0);
    for (int i = 0; i < 4; i++) {
        give_real(s, x + p[i].x);
        give_real(s, y + p[i].y);
    }
    *first = (point2){x + p[0].x, y + p[0].y};
    return ask(s);
}

static void
point_is_lifted(session *s, const site *p, uint32_t n)
{
    point2 a;
    if (!ask_lifting(s, p, n, false, &a)) /* one point is lifted: no picture */
        return;
    double x = take_real(s, "x"), y = take_real(s, "y"), z = take_real(s, "z");
    expect(s, failed(s) || (x == a.x && y == a.y && z == a.x * a.x + a.y * a.y),
           "(%.17g, %.17g) is lifted to (%.17g, %.17g, %.17g)", a.x, a.y, x, y, z);
}

static void
below_is_inside(session *s, const site *p, uint32_t n)
{
    point2 a;
    if (!ask_lifting(s, p, n, true, &a))
        return;
    for (int i = 0; i < 3; i++)
        take_real(s, "a coordinate");
    int inside =
        plane_orient(p[0], p[1], p[2]) * plane_incircle(p[0], p[1], p[2], p[3]);
    int below = take_sign(s, "the sign");
    take_end(s);
    if (!expect(s, failed(s) || below == inside,
                "moved by (%.17g, %.17g): 3 lies %s the circle of 0, 1, 2, which turn "
                "%s, and the answer is %+d",
                a.x - p[0].x, a.y - p[0].y,
                inside > 0   ? "inside"
                : inside < 0 ? "outside"
                             : "on",
                plane_orient(p[0], p[1], p[2]) > 0 ? "left" : "right", below))
        for (uint32_t i = 0; i < 4; i++)
            show_witness(s, i);
}

/* ---- 3.3-b: the lifted hull. ---- */

static triangle_list
ask_hull(session *s, const site *p, uint32_t n)
{
    uint32_t *at = room_for(n, sizeof *at);
    uint32_t locations = cases_locations(p, n, at);
    triangle_list faces = {0};
    begin_case(s, 'b', p, n);
    give_points(s);
    give_numbers(s, at, locations);
    if (ask(s) && take_ok(s))
        faces = take_triangles(s, n, 2 * n);
    free(at);
    return faces;
}

static void
hull_is_right(session *s, const site *p, uint32_t n)
{
    triangle_list faces = ask_hull(s, p, n);
    if (!failed(s))
        expect_verdict(s, certify_lifted_hull(p, n, faces));
}

/* Each side has its twin, which runs the other way. */
static void
neighbours_are_right(session *s, const site *p, uint32_t n)
{
    triangle_list faces = ask_hull(s, p, n);
    if (!failed(s))
        expect_verdict(s, certify_lifted_count(p, n, faces));
    uint32_t sides = 3 * faces.count;
    halfedge_id *twin = room_for(sides, sizeof *twin);
    for (uint32_t e = 0; e < sides; e++)
        twin[e] = take_number(s, 0, sides - 1, "a twin");
    take_end(s);
    for (uint32_t e = 0; e < sides && !failed(s); e++) {
        halfedge_id g = twin[e];
        expect(s, twin[g] == e && side_origin(faces, g) == side_dest(faces, e) &&
                      side_dest(faces, g) == side_origin(faces, e),
               "side %lu, from %lu to %lu, has the twin %lu, from %lu to %lu, whose "
               "twin is %lu",
               (unsigned long)e, (unsigned long)side_origin(faces, e),
               (unsigned long)side_dest(faces, e), (unsigned long)g,
               (unsigned long)side_origin(faces, g),
               (unsigned long)side_dest(faces, g), (unsigned long)twin[g]);
        if (failed(s))
            show_edge(s, SVG_BAD, side_origin(faces, e), side_dest(faces, e));
    }
    free(twin);
}

const property properties[] = {
    {"3.3-a", "lift", "f(x, y) = (x, y, x^2 + y^2), exactly for integers below 2^26",
     "notes 3.3, Figure 7; lifting.h, lift", CASES_GENERAL | CASES_GRID, 8, 200, false,
     point_is_lifted},
    {"3.3-a", "below",
     "The lifted d lies below the plane of a, b, c exactly when d is inside their "
     "circle, in either order of a, b, c",
     "notes 3.3, Proposition 1; page 3.3, prop1.P2",
     CASES_GENERAL | CASES_GRID | CASES_COCIRCULAR, 8, 400, false, below_is_inside},
    {"3.3-b", "hull",
     "There are 2v - 4 faces, no point is outside of any, and each side is there once, "
     "and once the other way",
     "notes 3.3, below Proposition 1; page 3.3, lower.P2", CASES_GENERAL | CASES_CONVEX,
     40, 80, true, hull_is_right},
    {"3.3-b", "degenerate",
     "The hull is right, too, for cocircular points and copies; points on one line or "
     "circle have a flat hull, without faces",
     "page 3.3, lower.P3; erratum E26", CASES_DEGENERATE, 30, 150, true, hull_is_right},
    {"3.3-b", "neighbours",
     "The twin of each side runs along the same edge, the other way",
     "lower_hull.h, lifted_hull", CASES_GENERAL | CASES_CONVEX | CASES_DEGENERATE, 30,
     100, true, neighbours_are_right},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
