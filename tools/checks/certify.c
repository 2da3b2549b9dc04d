/* certify.c - triangulations, Delaunay triangulations and hulls, proved right. */
#include "tools/checks/certify.h"

#include "tools/checks/cases.h"
#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>

/* ---- Sides and their twins. ---- */

/* Sides in the order of their lower end, then their upper end. */
typedef struct side {
    vertex_id low, high;
    halfedge_id e;
} side;

static int
compare_sides(const void *left, const void *right)
{
    const side *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return (a->e > b->e) - (a->e < b->e);
}

/* Fills twin[]; returns a side that runs along the same edge in the same direction as
 * another, or is the third there, or NONE. */
static halfedge_id
find_twins(triangle_list list, halfedge_id *twin)
{
    uint32_t sides = 3 * list.count;
    halfedge_id repeated = NONE;
    side *sorted = room_for(sides, sizeof *sorted);
    for (halfedge_id e = 0; e < sides; e++) {
        vertex_id a = side_origin(list, e), b = side_dest(list, e);
        sorted[e] = a < b ? (side){a, b, e} : (side){b, a, e};
        twin[e] = NONE;
    }
    qsort(sorted, sides, sizeof *sorted, compare_sides);
    for (uint32_t i = 1; i < sides; i++) {
        halfedge_id e = sorted[i - 1].e, f = sorted[i].e;
        if (sorted[i - 1].low != sorted[i].low || sorted[i - 1].high != sorted[i].high)
            continue;
        if (side_origin(list, e) == side_origin(list, f) || twin[e] != NONE) {
            repeated = f;
            continue;
        }
        twin[e] = f;
        twin[f] = e;
    }
    free(sorted);
    return repeated;
}

void
certify_twins(triangle_list list, halfedge_id *twin)
{
    find_twins(list, twin);
}

/* ---- Triangulations. ---- */

/* Which points are corners; each location by exactly one of its indices. */
static verdict
check_vertices(const site *points, uint32_t n, triangle_list list)
{
    verdict v = verdict_holds();
    bool *used = room_for(n, sizeof *used);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        used[list.corner[i / 3][i % 3]] = true;
    for (uint32_t i = 0; v.holds && i < n; i++) {
        uint32_t by = NONE;
        for (uint32_t j = 0; v.holds && j < n; j++) {
            if (!used[j] || !plane_same(points[i], points[j]))
                continue;
            if (by != NONE)
                v = verdict_with(
                    verdict_with(verdict_refuted("points %lu and %lu coincide, and "
                                                 "both are corners",
                                                 (unsigned long)by, (unsigned long)j),
                                 by),
                    j);
            by = j;
        }
        if (v.holds && by == NONE)
            v = verdict_with(verdict_refuted("point %lu is no corner of any triangle",
                                             (unsigned long)i),
                             i);
    }
    free(used);
    return v;
}

static verdict
check_orientations(const site *points, triangle_list list)
{
    for (uint32_t t = 0; t < list.count; t++) {
        const vertex_id *c = list.corner[t];
        int sign = plane_orient(points[c[0]], points[c[1]], points[c[2]]);
        if (sign <= 0) {
            verdict v = verdict_refuted(
                "triangle %lu-%lu-%lu is %s", (unsigned long)c[0], (unsigned long)c[1],
                (unsigned long)c[2], sign < 0 ? "clockwise" : "flat");
            for (int i = 0; i < 3; i++)
                v = verdict_with(v, c[i]);
            return v;
        }
    }
    return verdict_holds();
}

/* Is q lexicographically larger than p? */
static bool
is_after(site p, site q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

static verdict
refuted_at(const char *because, vertex_id a, vertex_id b, vertex_id c)
{
    verdict v = verdict_refuted("%s (at %lu-%lu-%lu)", because, (unsigned long)a,
                                (unsigned long)b, (unsigned long)c);
    return verdict_with(verdict_with(verdict_with(v, a), b), c);
}

/* Does the boundary turn at b, between a and c, as that of a convex set does? Counts
 * lexicographic maxima: one for each time around. */
static verdict
check_turn(const site *points, vertex_id a, vertex_id b, vertex_id c, uint32_t *maxima)
{
    int turn = plane_orient(points[a], points[b], points[c]);
    if (turn < 0)
        return refuted_at("the boundary turns right: something is missing or too much",
                          a, b, c);
    if (turn == 0 && plane_dot(points[a], points[b], points[c]) >= 0)
        return refuted_at("the boundary turns back", a, b, c);
    if (is_after(points[a], points[b]) && is_after(points[c], points[b]))
        (*maxima)++;
    return verdict_holds();
}

/* The sides without a twin: one cycle, convex, once around. */
static verdict
check_boundary(const site *points, uint32_t n, triangle_list list,
               const halfedge_id *twin)
{
    uint32_t sides = 0, walked = 0, maxima = 0;
    verdict v = verdict_holds();
    halfedge_id *leaving = room_for(n, sizeof *leaving), start = NONE;
    for (uint32_t i = 0; i < n; i++)
        leaving[i] = NONE;
    for (halfedge_id e = 0; v.holds && e < 3 * list.count; e++) {
        if (twin[e] != NONE)
            continue;
        vertex_id a = side_origin(list, e);
        if (leaving[a] != NONE)
            v = refuted_at("the boundary passes a point twice", a, side_dest(list, e),
                           side_dest(list, leaving[a]));
        leaving[a] = start = e;
        sides++;
    }
    halfedge_id e = start;
    while (v.holds && walked < sides) {
        halfedge_id next = leaving[side_dest(list, e)];
        if (next == NONE) {
            v = verdict_with(verdict_refuted("the boundary ends at point %lu",
                                             (unsigned long)side_dest(list, e)),
                             side_dest(list, e));
            break;
        }
        v = check_turn(points, side_origin(list, e), side_dest(list, e),
                       side_dest(list, next), &maxima);
        walked++;
        e = next;
        if (e == start)
            break;
    }
    free(leaving);
    if (v.holds && (walked != sides || e != start))
        return verdict_refuted("the boundary is in several pieces");
    if (v.holds && maxima != 1)
        return verdict_refuted("the boundary runs around %lu times",
                               (unsigned long)maxima);
    return v;
}

/* The list itself: everything but the twins, which come out for the next check. */
static verdict
check_triangles(const site *points, uint32_t n, triangle_list list, halfedge_id *twin)
{
    verdict v = check_orientations(points, list);
    if (!v.holds)
        return v;
    halfedge_id repeated = find_twins(list, twin);
    if (repeated != NONE) {
        vertex_id a = side_origin(list, repeated), b = side_dest(list, repeated);
        v = verdict_refuted("two triangles overlap: both have the side from %lu to %lu",
                            (unsigned long)a, (unsigned long)b);
        return verdict_with(verdict_with(v, a), b);
    }
    v = check_vertices(points, n, list);
    return v.holds ? check_boundary(points, n, list, twin) : v;
}

static verdict
certify(const site *points, uint32_t n, triangle_list list, bool delaunay)
{
    bool collinear = cases_are_collinear(points, n);
    if (collinear && list.count > 0)
        return verdict_refuted("the points are collinear, and yet there are triangles");
    if (!collinear && list.count == 0)
        return verdict_refuted("there is no triangle at all");
    if (collinear)
        return verdict_holds();

    halfedge_id *twin = room_for(3 * (size_t)list.count, sizeof *twin);
    verdict v = check_triangles(points, n, list, twin);
    for (halfedge_id e = 0; delaunay && v.holds && e < 3 * list.count; e++) {
        if (twin[e] == NONE)
            continue;
        vertex_id w[4] = {side_origin(list, e), side_dest(list, e), side_apex(list, e),
                          side_apex(list, twin[e])};
        int where = plane_incircle(points[w[0]], points[w[1]], points[w[2]],
                                   points[w[3]]);
        if (where > 0) {
            v = verdict_refuted("%lu lies inside the circle of triangle %lu-%lu-%lu",
                                (unsigned long)w[3], (unsigned long)w[0],
                                (unsigned long)w[1], (unsigned long)w[2]);
            for (int i = 0; i < 4; i++)
                v = verdict_with(v, w[i]);
        }
    }
    free(twin);
    return v;
}

verdict
certify_triangulation(const site *points, uint32_t n, triangle_list list)
{
    return certify(points, n, list, false);
}

verdict
certify_delaunay(const site *points, uint32_t n, triangle_list list)
{
    return certify(points, n, list, true);
}

/* ---- Hulls. ---- */

/* Every location once, in their order along the line. */
static verdict
check_path(const site *points, uint32_t n, const vertex_id *path, uint32_t count)
{
    uint32_t *lowest = room_for(n, sizeof *lowest);
    uint32_t locations = cases_locations(points, n, lowest);
    free(lowest);
    if (count != locations)
        return verdict_refuted("%lu vertices on the line, and there are %lu locations",
                               (unsigned long)count, (unsigned long)locations);
    for (uint32_t i = 1; i < count; i++)
        if (plane_same(points[path[i - 1]], points[path[i]]))
            return refuted_at("the path stays where it is", path[i - 1], path[i],
                              path[i]);
    for (uint32_t i = 2; i < count; i++)
        if (plane_dot(points[path[i - 2]], points[path[i - 1]], points[path[i]]) >= 0)
            return refuted_at("the path turns back", path[i - 2], path[i - 1], path[i]);
    return verdict_holds();
}

verdict
certify_hull(const site *points, uint32_t n, const vertex_id *hull, uint32_t count)
{
    if (cases_are_collinear(points, n))
        return check_path(points, n, hull, count);
    uint32_t maxima = 0;
    if (count < 3)
        return verdict_refuted("a hull of %lu vertices", (unsigned long)count);
    for (uint32_t i = 0; i < count; i++) {
        vertex_id a = hull[i], b = hull[(i + 1) % count], c = hull[(i + 2) % count];
        if (plane_orient(points[a], points[b], points[c]) < 0)
            return refuted_at(
                "the hull turns right: it is listed clockwise, or goes to a "
                "point inside",
                a, b, c);
        verdict v = check_turn(points, a, b, c, &maxima);
        if (!v.holds)
            return v;
    }
    if (maxima != 1)
        return verdict_refuted("the hull runs around %lu times", (unsigned long)maxima);
    for (uint32_t i = 0; i < count; i++) {
        vertex_id a = hull[i], b = hull[(i + 1) % count];
        for (uint32_t p = 0; p < n; p++) {
            if (plane_orient(points[a], points[b], points[p]) < 0)
                return refuted_at("a point lies outside of a hull edge", a, b, p);
            if (plane_orient(points[a], points[b], points[p]) == 0 &&
                plane_dot(points[a], points[p], points[b]) < 0)
                return refuted_at("a point inside a hull edge is left out", a, b, p);
        }
    }
    return verdict_holds();
}
