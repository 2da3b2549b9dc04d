/* meshes.c - any maximal set of edges that do not cross triangulates the points.
 *
 * For if some bounded face were no triangle, a diagonal of it could be added. With only
 * the edges that have an empty disc on a circle through both ends, the same gives a
 * Delaunay triangulation: two of these cross only when all four ends lie on one circle.
 */
#include "tools/checks/meshes.h"

#include "tools/checks/cases.h"
#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct edge {
    uint32_t a, b;
} edge;

/* Does r lie strictly between p and q on their line? */
static bool
is_between(site p, site r, site q)
{
    return plane_orient(p, q, r) == 0 && plane_dot(p, r, q) < 0;
}

/* Do the open segments cross in one point? */
static bool
cross(site a, site b, site c, site d)
{
    return plane_orient(a, b, c) * plane_orient(a, b, d) < 0 &&
           plane_orient(c, d, a) * plane_orient(c, d, b) < 0;
}

/* Is there a circle through p and q with no point strictly inside? The circles through
 * both form a pencil; one point left of pq and one right must leave room between
 * them. */
static bool
has_empty_circle(const site *at, const uint32_t *v, uint32_t u, site p, site q)
{
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = 0; plane_orient(p, q, at[v[i]]) > 0 && j < u; j++)
            if (plane_orient(p, q, at[v[j]]) < 0 &&
                plane_incircle(p, q, at[v[i]], at[v[j]]) > 0)
                return false;
    return true;
}

/* All pairs of locations whose segment contains no third one, in random order. */
static uint32_t
candidates(random_source *source, const site *at, const uint32_t *v, uint32_t u,
           bool delaunay, edge *candidate)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = i + 1; j < u; j++) {
            bool blocked = false;
            for (uint32_t k = 0; k < u && !blocked; k++)
                blocked = is_between(at[v[i]], at[v[k]], at[v[j]]);
            if (!blocked &&
                (!delaunay || has_empty_circle(at, v, u, at[v[i]], at[v[j]])))
                candidate[count++] = (edge){v[i], v[j]};
        }
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = random_below(source, i);
        edge chosen = candidate[j];
        candidate[j] = candidate[i - 1];
        candidate[i - 1] = chosen;
    }
    return count;
}

static uint32_t
keep_uncrossed(const site *at, edge *e, uint32_t count)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < count; i++) {
        bool crossed = false;
        for (uint32_t j = 0; j < kept && !crossed; j++)
            crossed = cross(at[e[i].a], at[e[i].b], at[e[j].a], at[e[j].b]);
        if (!crossed)
            e[kept++] = e[i];
    }
    return kept;
}

/* Is abc counterclockwise, with no location in it? */
static bool
is_empty_triangle(const site *at, const uint32_t *v, uint32_t u, uint32_t a, uint32_t b,
                  uint32_t c)
{
    if (plane_orient(at[a], at[b], at[c]) <= 0)
        return false;
    for (uint32_t i = 0; i < u; i++)
        if (plane_orient(at[a], at[b], at[v[i]]) > 0 &&
            plane_orient(at[b], at[c], at[v[i]]) > 0 &&
            plane_orient(at[c], at[a], at[v[i]]) > 0)
            return false;
    return true;
}

/* The triples joined by three edges, with nothing inside, are the triangles. */
static triangle_list
triangles_of(const site *at, const uint32_t *v, uint32_t u, uint32_t n, const edge *e,
             uint32_t edges)
{
    bool *joined = room_for((size_t)n * n, sizeof *joined);
    for (uint32_t i = 0; i < edges; i++)
        joined[(size_t)e[i].a * n + e[i].b] = joined[(size_t)e[i].b * n + e[i].a] =
            true;
    triangle_list list = {0};
    list.corner = room_for(2 * (size_t)n, sizeof *list.corner);
    for (uint32_t i = 0; i < edges; i++)
        for (uint32_t k = 0; k < u; k++) {
            uint32_t a = e[i].a, b = e[i].b, c = v[k];
            /* each triangle once: at the edge between its two lowest corners */
            if (c < a || c < b || !joined[(size_t)a * n + c] ||
                !joined[(size_t)b * n + c])
                continue;
            if (is_empty_triangle(at, v, u, b, a, c)) {
                uint32_t other = a;
                a = b;
                b = other;
            } else if (!is_empty_triangle(at, v, u, a, b, c)) {
                continue;
            }
            list.corner[list.count][0] = a;
            list.corner[list.count][1] = b;
            list.corner[list.count++][2] = c;
        }
    free(joined);
    return list;
}

triangle_list
mesh_at_random(random_source *source, const site *points, uint32_t n, bool delaunay)
{
    if (cases_are_collinear(points, n))
        return (triangle_list){0};
    uint32_t *v = room_for(n, sizeof *v);
    edge *e = room_for((size_t)n * n / 2, sizeof *e);
    uint32_t u = cases_locations(points, n, v);
    uint32_t count = candidates(source, points, v, u, delaunay, e);
    count = keep_uncrossed(points, e, count);
    triangle_list list = triangles_of(points, v, u, n, e, count);
    free(v);
    free(e);
    return list;
}

uint32_t
path_of(const site *points, uint32_t n, uint32_t *path)
{
    static const site along = {1, 0};
    uint32_t count = cases_locations(points, n, path);
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t j = i; j > 0 && plane_along(along, points[path[j - 1]],
                                                  points[path[j]]) > 0; j--) {
            uint32_t other = path[j];
            path[j] = path[j - 1];
            path[j - 1] = other;
        }
    return count;
}

piece
piece_at_random(random_source *source, const site *points, const uint32_t *part,
                uint32_t count, bool delaunay)
{
    site *at = room_for(count, sizeof *at);
    for (uint32_t i = 0; i < count; i++)
        at[i] = points[part[i]];
    piece found = {mesh_at_random(source, at, count, delaunay),
                   room_for(count, sizeof *found.path), 0};
    for (uint32_t i = 0; i < 3 * found.list.count; i++)
        found.list.corner[i / 3][i % 3] = part[found.list.corner[i / 3][i % 3]];
    found.length = found.list.count > 0 ? 0 : path_of(at, count, found.path);
    for (uint32_t i = 0; i < found.length; i++)
        found.path[i] = part[found.path[i]];
    free(at);
    return found;
}
