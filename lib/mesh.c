/* mesh.c - the sphere of triangles: making, changing, certifying.
 *
 * The only file, with mesh.h, that knows how half-edges are laid out in memory.
 */
#include "lib/mesh.h"

#include "lib/memory.h"

#include <stddef.h>

tri_status
mesh_fits(uint32_t locations)
{
    return locations <= MESH_MOST_LOCATIONS ? TRI_OK : TRI_TOO_MANY_POINTS;
}

tri_status
mesh_init(mesh *m, uint32_t points, uint32_t locations)
{
    assert(locations <= points);
    *m = (mesh){.points = points, .locations = locations, .ghost_leaving = NONE};
    tri_status status = mesh_fits(locations);
    if (status == TRI_OK) {
        size_t triangles = locations > 1 ? 2 * (size_t)locations - 2 : 0;
        m->halfedge = memory_array(triangles, 3 * sizeof *m->halfedge);
        m->leaving = memory_array(points, sizeof *m->leaving);
        if (m->halfedge == NULL || m->leaving == NULL)
            status = TRI_OUT_OF_MEMORY;
    }
    if (status != TRI_OK) {
        mesh_free(m);
        return status;
    }
    for (vertex_id v = 0; v < points; v++)
        m->leaving[v] = NONE;
    return TRI_OK;
}

void
mesh_free(mesh *m)
{
    memory_free(m->halfedge);
    memory_free(m->leaving);
    *m = (mesh){0};
}

tri_status
mesh_finish(mesh *m, tri_status status)
{
    m->trace = NULL;
    if (status == TRI_OK && m->cancelled)
        status = TRI_CANCELLED;
    if (status != TRI_OK)
        mesh_free(m);
    return status;
}

halfedge_id
mesh_add_triangle(mesh *m, vertex_id a, vertex_id b, vertex_id c)
{
    assert(m->triangles + 2 < 2 * m->locations);
    halfedge_id ab = mesh_halfedges(m);
    m->triangles++;
    mesh_set_triangle(m, ab, a, b, c);
    return ab;
}

halfedge_id
mesh_start(mesh *m, vertex_id a, vertex_id b)
{
    assert(a != b);
    halfedge_id ab = mesh_add_triangle(m, a, b, GHOST);
    halfedge_id ba = mesh_add_triangle(m, b, a, GHOST);
    mesh_link(m, ab, ba);
    mesh_link(m, mesh_next(ab), mesh_prev(ba)); /* b GHOST and GHOST b */
    mesh_link(m, mesh_prev(ab), mesh_next(ba)); /* GHOST a and a GHOST */
    return ab;
}

/* Cuts open two spheres along the edges e and f, which have the same ends, and sews
 * each side of one cut to the opposite side of the other: the two are one sphere. */
static void
sew(mesh *m, halfedge_id e, halfedge_id f)
{
    halfedge_id e_twin = mesh_twin(m, e), f_twin = mesh_twin(m, f);
    mesh_link(m, e, f_twin);
    mesh_link(m, f, e_twin);
}

halfedge_id
mesh_bridge(mesh *m, halfedge_id e, halfedge_id f)
{
    halfedge_id a_ghost = mesh_next(mesh_twin(m, e));
    halfedge_id b_ghost = mesh_next(mesh_twin(m, f));
    halfedge_id ab = mesh_start(m, mesh_origin(m, e), mesh_origin(m, f));
    sew(m, a_ghost, mesh_next(mesh_twin(m, ab)));
    sew(m, b_ghost, mesh_next(ab));
    return ab;
}

void
mesh_cover(mesh *m, halfedge_id e, vertex_id p)
{
    assert(mesh_is_hull_edge(m, e));
    mesh_set_origin(m, mesh_prev(mesh_twin(m, e)), p);
}

halfedge_id
mesh_hull_join(mesh *m, halfedge_id first, halfedge_id end, vertex_id p)
{
    vertex_id u = mesh_origin(m, first), w = mesh_origin(m, end);

    /* The outside is a fan of triangles around GHOST. The spokes at u and at w are
     * where it is cut open: what lies between them is no longer outside. */
    halfedge_id u_inside = mesh_next(mesh_twin(m, first));
    halfedge_id u_outside = mesh_twin(m, u_inside);
    halfedge_id w_outside = mesh_next(mesh_twin(m, end));
    halfedge_id w_inside = mesh_twin(m, w_outside);

    halfedge_id pu = mesh_add_triangle(m, p, u, GHOST);
    halfedge_id wp = mesh_add_triangle(m, w, p, GHOST);
    mesh_link(m, mesh_prev(pu), mesh_next(wp)); /* the spoke at p */
    mesh_link(m, mesh_next(pu), u_outside);
    mesh_link(m, mesh_prev(wp), w_outside);
    if (first == end) { /* nothing was covered: p hangs on the edge u p */
        mesh_link(m, pu, wp);
    } else {
        mesh_link(m, pu, u_inside);
        mesh_link(m, wp, w_inside);
    }
    return mesh_twin(m, wp);
}

halfedge_id
mesh_some_hull_edge(const mesh *m)
{
    if (m->triangles == 0)
        return NONE;
    return mesh_twin(m, mesh_next(m->ghost_leaving));
}

uint32_t
mesh_hull_size(const mesh *m)
{
    halfedge_id first = mesh_some_hull_edge(m);
    if (first == NONE)
        return 0;
    uint32_t size = 0;
    halfedge_id e = first;
    do {
        size++;
        e = mesh_hull_next(m, e);
    } while (e != first);
    return size;
}

/* ---- Certifying. ---- */

static verdict
refuted_at(const mesh *m, halfedge_id e, const char *what)
{
    vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
    verdict v = verdict_refuted("half-edge %u of triangle %u: %s", (unsigned)e,
                                (unsigned)mesh_triangle_of(e), what);
    if (a < m->points)
        v = verdict_with(v, a);
    if (b < m->points)
        v = verdict_with(v, b);
    return v;
}

/* Are the ends and the twin of e what they must be? */
static verdict
check_halfedge(const mesh *m, halfedge_id e)
{
    vertex_id a = mesh_origin(m, e);
    halfedge_id f = mesh_twin(m, e);
    if (a != GHOST && a >= m->points)
        return refuted_at(m, e, "its origin is no vertex");
    if (a == mesh_dest(m, e))
        return refuted_at(m, e, "both its ends are the same vertex");
    if (f >= mesh_halfedges(m) || mesh_twin(m, f) != e)
        return refuted_at(m, e, "it is not the twin of its twin");
    if (mesh_origin(m, f) != mesh_dest(m, e) || mesh_dest(m, f) != a)
        return refuted_at(m, e, "it and its twin do not join the same two vertices");
    return verdict_holds();
}

/* How many half-edges are met by going around the origin of e; 0 when e does not
 * leave v. Requires: every half-edge has been checked, so the walk closes. */
static uint32_t
degree_at(const mesh *m, vertex_id v, halfedge_id e)
{
    if (e >= mesh_halfedges(m) || mesh_origin(m, e) != v)
        return 0;
    uint32_t degree = 0;
    halfedge_id f = e;
    do {
        degree++;
        f = mesh_around(m, f);
    } while (f != e);
    return degree;
}

verdict
mesh_check(const mesh *m)
{
    uint32_t u = m->locations;
    if (m->triangles != (u > 1 ? 2 * u - 2 : 0))
        return verdict_refuted("%u triangles, ghosts included, and %u locations: "
                               "2u-2 are needed", (unsigned)m->triangles, (unsigned)u);
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        verdict v = check_halfedge(m, e);
        if (!v.holds)
            return v;
    }
    /* A vertex with two stars would be met by only one of them, so the degrees
     * add up to the number of half-edges exactly when each vertex has one star. */
    uint64_t met = 0;
    uint32_t used = 0;
    for (vertex_id v = 0; v < m->points; v++) {
        if (m->leaving[v] == NONE)
            continue;
        uint32_t degree = degree_at(m, v, m->leaving[v]);
        if (degree == 0)
            return verdict_with(verdict_refuted("the half-edge kept for vertex %u "
                                "does not leave it", (unsigned)v), v);
        met += degree;
        used++;
    }
    if (u > 1)
        met += degree_at(m, GHOST, m->ghost_leaving);
    if (met != mesh_halfedges(m))
        return verdict_refuted("the triangles around some vertex are no single cycle: "
                               "%llu of %u half-edges are met",
                               (unsigned long long)met, (unsigned)mesh_halfedges(m));
    if (u > 1 && used != u)
        return verdict_refuted("%u vertices are used and there are %u locations",
                               (unsigned)used, (unsigned)u);
    return verdict_holds();
}

tri_status
mesh_triangles(const mesh *m, triangle_list *out)
{
    *out = (triangle_list){0};
    out->corner = memory_array(m->triangles, sizeof *out->corner);
    if (out->corner == NULL)
        return TRI_OUT_OF_MEMORY;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e += 3) {
        if (!mesh_in_triangle(m, e))
            continue;
        vertex_id *corner = out->corner[out->count++];
        corner[0] = mesh_origin(m, e);
        corner[1] = mesh_dest(m, e);
        corner[2] = mesh_apex(m, e);
    }
    return TRI_OK;
}
