/* empty_circle.c - Definition 7, and the trivial algorithm of 3.2.1. */
#include "chapters/3.2_empty_circumcircle/empty_circle.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/mesh_build.h"

static const point2 along_x = {1, 0};

/* ---- Definition 7. ---- */

bool
has_empty_circle(const point2 *points, uint32_t n, vertex_id a, vertex_id b,
                 vertex_id c)
{
    for (vertex_id d = 0; d < n; d++)
        if (incircle(points[a], points[b], points[c], points[d]) > 0)
            return false;
    return true;
}

/* Does d lie on the segment ab, between its ends? A flat angle is obtuse. */
static bool
lies_between(const point2 *points, vertex_id a, vertex_id b, vertex_id d)
{
    return orient2d(points[a], points[b], points[d]) == 0 &&
           dot_sign(points[a], points[d], points[b]) < 0;
}

/* The circles through a and b form a row, in the order of their centres. Going
 * left, each takes more of the left side in and leaves more of the right side
 * out. Of the sites on the left, the one that the row meets first bounds how
 * far left the centre of an empty circle can be; so the circle through it is
 * the best chance to leave out the sites on the right. */
bool
is_delaunay_edge(const point2 *points, uint32_t n, vertex_id a, vertex_id b)
{
    vertex_id c = NONE; /* the site on the left that is met first */
    for (vertex_id d = 0; d < n; d++) {
        if (lies_between(points, a, b, d))
            return false;
        if (orient2d(points[a], points[b], points[d]) > 0 &&
            (c == NONE ||
             incircle(points[a], points[b], points[c], points[d]) > 0))
            c = d;
    }
    return c == NONE || has_empty_circle(points, n, a, b, c);
}

/* ---- 3.2.1: all triangles with an empty circle. ---- */

/* Adds the triangle abc to the list, which has room for *room triangles. */
static tri_status
append_triangle(triangle_list *list, uint32_t *room, vertex_id a, vertex_id b,
                vertex_id c)
{
    if (list->count == *room) {
        if (*room > NONE / 6 - 16) /* sides must have numbers */
            return TRI_TOO_MANY_POINTS;
        *room = 2 * *room + 16;
        void *larger = memory_resize(list->corner, *room, sizeof *list->corner);
        if (larger == NULL)
            return TRI_OUT_OF_MEMORY;
        list->corner = larger;
    }
    vertex_id *corner = list->corner[list->count++];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    return TRI_OK;
}

/* Adds the triangle abc, counterclockwise, if it is one and is Delaunay. */
static tri_status
append_if_delaunay(const point2 *points, uint32_t n, vertex_id a, vertex_id b,
                   vertex_id c, triangle_list *list, uint32_t *room)
{
    int turn = orient2d(points[a], points[b], points[c]);
    if (turn == 0)
        return TRI_OK;
    vertex_id second = turn > 0 ? b : c, third = turn > 0 ? c : b;
    if (!has_empty_circle(points, n, a, second, third))
        return TRI_OK;
    return append_triangle(list, room, a, second, third);
}

/* The Delaunay triangles with corners among the u given sites. */
static tri_status
try_all_triangles(const point2 *points, uint32_t n, const vertex_id *site,
                  uint32_t u, triangle_list *list)
{
    tri_status status = TRI_OK;
    uint32_t room = 0;
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = i + 1; j < u; j++)
            for (uint32_t k = j + 1; k < u && status == TRI_OK; k++)
                status = append_if_delaunay(points, n, site[i], site[j],
                                            site[k], list, &room);
    return status;
}

tri_status
delaunay_triangles(const point2 *points, uint32_t n, triangle_list *out)
{
    *out = (triangle_list){0};
    uint32_t u;
    vertex_id *site = memory_array(n, sizeof *site);
    if (site == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = sort_along(points, n, along_x, site, &u);
    if (status == TRI_OK)
        status = try_all_triangles(points, n, site, u, out);
    memory_free(site);
    if (status != TRI_OK)
        triangle_list_free(out);
    return status;
}

/* ---- From overlapping triangles to a triangulation. ---- */

/* Is abc a piece of the fan at a, where a is the lowest index on its circle,
 * and bc a side of the polygon of all sites on it? Other sites on the circle
 * that lie beyond bc would be corners between b and c. */
static bool
belongs_to_fan(const point2 *points, uint32_t n, vertex_id a, vertex_id b,
               vertex_id c)
{
    for (vertex_id d = 0; d < n; d++) {
        if (incircle(points[a], points[b], points[c], points[d]) != 0)
            continue;
        if (d < a || orient2d(points[b], points[c], points[d]) < 0)
            return false;
    }
    return true;
}

/* Drops the triangles that belong to no fan; a triangle begins at its lowest
 * index. */
static void
keep_fans(const point2 *points, uint32_t n, triangle_list *list)
{
    uint32_t kept = 0;
    for (uint32_t t = 0; t < list->count; t++) {
        vertex_id *c = list->corner[t];
        int low = c[0] < c[1] && c[0] < c[2] ? 0 : c[1] < c[2] ? 1 : 2;
        vertex_id a = c[low], b = c[(low + 1) % 3], d = c[(low + 2) % 3];
        if (!belongs_to_fan(points, n, a, b, d))
            continue;
        vertex_id *corner = list->corner[kept++];
        corner[0] = a;
        corner[1] = b;
        corner[2] = d;
    }
    list->count = kept;
}

/* The path along collinear points: its order is the same in every direction. */
static tri_status
path_along(const point2 *points, uint32_t n, mesh *out)
{
    uint32_t u;
    vertex_id *path = memory_array(n, sizeof *path);
    if (path == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = sort_along(points, n, along_x, path, &u);
    if (status == TRI_OK)
        status = mesh_from_path(n, path, u, out);
    memory_free(path);
    return status;
}

tri_status
brute_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                  mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    triangle_list list;
    tri_status status = tri_accept(points, n, options, &used);
    if (status == TRI_OK)
        status = delaunay_triangles(points, n, &list);
    if (status != TRI_OK)
        return status;
    keep_fans(points, n, &list);
    status = list.count > 0 ? mesh_from_triangles(n, list, out)
                            : path_along(points, n, out);
    triangle_list_free(&list);
    return status;
}
