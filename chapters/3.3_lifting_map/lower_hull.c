/* lower_hull.c - a convex hull in space, of points on the paraboloid, and its
 * underside. */
#include "chapters/3.3_lifting_map/lower_hull.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.3_lifting_map/lifting.h"
#include "lib/memory.h"
#include "lib/mesh_build.h"

/* ---- The surface of the hull. ---- */

/* Sides e and f run along the same edge. */
static void
link_faces(lifted_hull *H, halfedge_id e, halfedge_id f)
{
    H->twin[e] = f;
    H->twin[f] = e;
}

static void
set_face(lifted_hull *H, triangle_id t, vertex_id a, vertex_id b, vertex_id c)
{
    H->faces.corner[t][0] = a;
    H->faces.corner[t][1] = b;
    H->faces.corner[t][2] = c;
}

tri_status
lifted_hull_start(lifted_hull *H, const point2 *points, uint32_t n,
                  uint32_t locations, vertex_id a, vertex_id b, vertex_id c)
{
    *H = (lifted_hull){.points = points};
    tri_status status = mesh_fits(locations); /* as many sides as here */
    if (status != TRI_OK)
        return status;
    H->faces.corner = memory_array(locations, 2 * sizeof *H->faces.corner);
    H->twin = memory_array(locations, 6 * sizeof *H->twin);
    H->seen = memory_array(locations, 2 * sizeof *H->seen);
    H->beyond = memory_array(n, sizeof *H->beyond);
    if (H->faces.corner == NULL || H->twin == NULL || H->seen == NULL ||
        H->beyond == NULL) {
        lifted_hull_free(H);
        return TRI_OUT_OF_MEMORY;
    }
    H->faces.count = 2;
    set_face(H, 0, a, b, c);
    set_face(H, 1, b, a, c);
    link_faces(H, 0, 3); /* ab and ba */
    link_faces(H, 1, 5); /* bc and cb */
    link_faces(H, 2, 4); /* ca and ac */
    return TRI_OK;
}

void
lifted_hull_free(lifted_hull *H)
{
    triangle_list_free(&H->faces);
    memory_free(H->twin);
    memory_free(H->seen);
    memory_free(H->beyond);
    *H = (lifted_hull){0};
}

/* ---- One more point. ---- */

/* Does the lifted p lie strictly outside of face t? A point in the plane of a
 * face does not see it: then the faces at p leave the face as it is and
 * continue it, and a facet with many corners grows piece by piece (page 3.3,
 * lower.P3). */
static bool
sees_face(const lifted_hull *H, vertex_id p, triangle_id t)
{
    const vertex_id *v = H->faces.corner[t];
    point2 a = H->points[v[0]], b = H->points[v[1]], c = H->points[v[2]];
    return orient3d_lifted(a, b, c, H->points[p]) > 0;
}

/* The horizon is where seen and unseen faces meet: one closed walk. Notes for
 * each of its vertices the side that leaves it on the unseen side; returns one
 * of them. */
static halfedge_id
find_horizon(lifted_hull *H)
{
    halfedge_id some = NONE;
    for (halfedge_id e = 0; e < 3 * H->faces.count; e++) {
        halfedge_id g = H->twin[e];
        if (!H->seen[e / 3] || H->seen[g / 3])
            continue;
        H->beyond[side_origin(H->faces, g)] = g;
        some = g;
    }
    assert(some != NONE); /* p sees a face, and not all of them */
    return some;
}

/* The next place for a face, from place t on: of a face that is seen, and so is
 * no more, or behind all others. */
static triangle_id
take_place(lifted_hull *H, triangle_id t)
{
    while (t < H->faces.count && !H->seen[t])
        t++;
    if (t == H->faces.count)
        H->faces.count++;
    H->seen[t] = false;
    return t;
}

/* Walks along the horizon, from side g back to g, and joins each of its sides
 * to p:
 *
 *           p           side 0: w to u, the twin of g
 *         /   \         side 1: u to p, the twin of side 2 of the face before
 *       w <--- u        side 2: p to w, the twin of side 1 of the face after
 *         <-g-
 */
static void
join_horizon(lifted_hull *H, halfedge_id g, vertex_id p)
{
    triangle_id first = NONE, before = NONE, t = 0;
    vertex_id start = side_origin(H->faces, g), u = start;
    do {
        g = H->beyond[u];
        vertex_id w = side_dest(H->faces, g);
        t = take_place(H, t);
        set_face(H, t, w, u, p);
        link_faces(H, 3 * t, g);
        if (before == NONE)
            first = t;
        else
            link_faces(H, 3 * before + 2, 3 * t + 1);
        before = t;
        u = w;
    } while (u != start);
    link_faces(H, 3 * before + 2, 3 * first + 1);
}

void
lifted_hull_add(lifted_hull *H, vertex_id p)
{
    for (triangle_id t = 0; t < H->faces.count; t++)
        H->seen[t] = sees_face(H, p, t); // Step 1: what p sees
    halfedge_id g = find_horizon(H);     // Step 2: where that ends
    join_horizon(H, g, p);               // Step 3: faces at p instead of it
}

/* ---- All points. ---- */

/* The place in L of the first site whose lifted point is not in the plane of
 * the first three; `locations` when there is none. */
static uint32_t
first_off_plane(const point2 *points, const vertex_id *L, uint32_t locations)
{
    for (uint32_t i = 3; i < locations; i++)
        if (orient3d_lifted(points[L[0]], points[L[1]], points[L[2]],
                            points[L[i]]) != 0)
            return i;
    return locations;
}

tri_status
lifted_hull_of(lifted_hull *H, const point2 *points, uint32_t n,
               const vertex_id *L, uint32_t locations)
{
    *H = (lifted_hull){.points = points};
    uint32_t off = first_off_plane(points, L, locations);
    if (off == locations)
        return TRI_OK;
    tri_status status;
    status = lifted_hull_start(H, points, n, locations, L[0], L[1], L[2]);
    if (status != TRI_OK)
        return status;
    lifted_hull_add(H, L[off]);
    for (uint32_t i = 3; i < locations; i++)
        if (i != off)
            lifted_hull_add(H, L[i]);
    return TRI_OK;
}

/* ---- Lower and upper faces. ---- */

/* The faces whose projections have this orientation, made counterclockwise. */
static tri_status
oriented_faces(const lifted_hull *H, int orientation, triangle_list *out)
{
    *out = (triangle_list){0};
    out->corner = memory_array(H->faces.count, sizeof *out->corner);
    if (out->corner == NULL)
        return TRI_OUT_OF_MEMORY;
    for (triangle_id t = 0; t < H->faces.count; t++) {
        const vertex_id *c = H->faces.corner[t];
        point2 p = H->points[c[0]], q = H->points[c[1]], r = H->points[c[2]];
        if (orient2d(p, q, r) != orientation)
            continue;
        vertex_id *corner = out->corner[out->count++];
        corner[0] = c[0];
        corner[1] = c[orientation > 0 ? 1 : 2];
        corner[2] = c[orientation > 0 ? 2 : 1];
    }
    return TRI_OK;
}

tri_status
lower_faces(const lifted_hull *H, triangle_list *out)
{
    return oriented_faces(H, +1, out);
}

tri_status
upper_faces(const lifted_hull *H, triangle_list *out)
{
    return oriented_faces(H, -1, out);
}

/* When the hull is flat, no site lies inside any circle of others: every
 * triangulation is Delaunay, and the sweep's will do. */
tri_status
lift_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                 mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    used.trace = NULL;
    vertex_id *L = memory_array(n, sizeof *L);
    if (L == NULL)
        return TRI_OUT_OF_MEMORY;
    uint32_t locations;
    lifted_hull H = {0};
    triangle_list lower = {0};
    status = sort_along(points, n, used.direction, L, &locations);
    if (status == TRI_OK)
        status = lifted_hull_of(&H, points, n, L, locations);
    if (status == TRI_OK)
        status = lower_faces(&H, &lower);
    if (status == TRI_OK && lower.count > 0)
        status = mesh_from_triangles(n, lower, out);
    else if (status == TRI_OK)
        status = sweep_triangulate(points, n, &used, out);
    triangle_list_free(&lower);
    lifted_hull_free(&H);
    memory_free(L);
    return status;
}

/* ---- Certifying: is it the underside of a convex body? ---- */

/* Is the surface convex at each edge? Each is looked at from one side. */
static verdict
check_edges_convex(const point2 *points, triangle_list list,
                   const halfedge_id *twin)
{
    for (halfedge_id ab = 0; ab < 3 * list.count; ab++) {
        halfedge_id ba = twin[ab];
        if (ba == NONE || ba < ab)
            continue;
        vertex_id a = side_origin(list, ab), b = side_dest(list, ab);
        vertex_id c = side_apex(list, ab), d = side_apex(list, ba);
        if (orient3d_lifted(points[a], points[b], points[c], points[d]) <= 0)
            continue;
        verdict v = verdict_refuted(
            "the surface is not convex at edge %u %u: lifted, %u lies "
            "below the plane of %u, %u, %u",
            (unsigned)a, (unsigned)b, (unsigned)d, (unsigned)a, (unsigned)b,
            (unsigned)c);
        v = verdict_with(verdict_with(v, a), b);
        return verdict_with(verdict_with(v, c), d);
    }
    return verdict_holds();
}

tri_status
is_lower_hull(const point2 *points, uint32_t n, triangle_list list, verdict *out)
{
    halfedge_id *twin;
    tri_status status = is_triangulation_with_twins(points, n, list, out, &twin);
    if (status == TRI_OK && out->holds)
        *out = check_edges_convex(points, list, twin);
    memory_free(twin);
    return status;
}
