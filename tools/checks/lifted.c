/* lifted.c - is this the convex hull of the lifted points? */
#include "tools/checks/lifted.h"

#include "tools/checks/cases.h"
#include "tools/checks/room.h"

#include <stdlib.h>

/* Are the lifted points in one plane: all on one line, or on one circle? (The first
 * three are in no other, even if they are on a line: then it is upright.) */
static bool
is_flat(const site *p, const uint32_t *at, uint32_t u)
{
    for (uint32_t i = 3; i < u; i++)
        if (plane_incircle(p[at[0]], p[at[1]], p[at[2]], p[at[i]]) != 0)
            return false;
    return true;
}

verdict
certify_lifted_count(const site *points, uint32_t n, triangle_list faces)
{
    uint32_t *at = room_for(n, sizeof *at), u = cases_locations(points, n, at);
    uint32_t right = is_flat(points, at, u) ? 0 : 2 * u - 4;
    free(at);
    if (faces.count == right)
        return verdict_holds();
    return verdict_refuted("%lu faces; the hull of these %lu locations has %lu",
                           (unsigned long)faces.count, (unsigned long)u,
                           (unsigned long)right);
}

/* No lifted point is outside of a face. */
static verdict
check_support(const site *p, uint32_t n, triangle_list faces)
{
    for (triangle_id t = 0; t < faces.count; t++) {
        const vertex_id *c = faces.corner[t];
        for (vertex_id d = 0; d < n; d++) {
            if (plane_incircle(p[c[0]], p[c[1]], p[c[2]], p[d]) <= 0)
                continue;
            verdict v = verdict_refuted(
                "the lifted %lu lies outside of face %lu-%lu-%lu", (unsigned long)d,
                (unsigned long)c[0], (unsigned long)c[1], (unsigned long)c[2]);
            for (int i = 0; i < 3; i++)
                v = verdict_with(v, c[i]);
            return verdict_with(v, d);
        }
    }
    return verdict_holds();
}

/* Each side joins two locations, and is there once the other way: so once in all. */
static verdict
check_sides(const site *p, triangle_list faces)
{
    for (halfedge_id e = 0; e < 3 * faces.count; e++) {
        vertex_id a = side_origin(faces, e), b = side_dest(faces, e);
        uint32_t back = 0;
        for (halfedge_id f = 0; f < 3 * faces.count; f++)
            back += side_origin(faces, f) == b && side_dest(faces, f) == a;
        if (back == 1 && !plane_same(p[a], p[b]))
            continue;
        verdict v = verdict_refuted(
            "a face has a side from %lu to %lu, and %lu faces have one from %lu to %lu",
            (unsigned long)a, (unsigned long)b, (unsigned long)back, (unsigned long)b,
            (unsigned long)a);
        if (plane_same(p[a], p[b]))
            v = verdict_refuted("a face has a side from %lu to %lu, at the same place",
                                (unsigned long)a, (unsigned long)b);
        return verdict_with(verdict_with(v, a), b);
    }
    return verdict_holds();
}

verdict
certify_lifted_hull(const site *points, uint32_t n, triangle_list faces)
{
    verdict v = certify_lifted_count(points, n, faces);
    if (v.holds)
        v = check_support(points, n, faces);
    return v.holds ? check_sides(points, faces) : v;
}
