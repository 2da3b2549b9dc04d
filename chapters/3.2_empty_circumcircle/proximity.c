/* proximity.c - three graphs between neighbours: Gabriel's, the relative
 * neighbourhood graph, and that of the nearest neighbours. */
#include "chapters/3.2_empty_circumcircle/graphs.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* GHOST stands outside the hull, at no place: its edges are none. */
static bool
is_edge(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, e) != GHOST && mesh_dest(m, e) != GHOST;
}

/* Is half-edge e shorter than f (-1), as long (0), or longer (+1)? */
static int
compare_halfedges(const mesh *m, const point2 *points, halfedge_id e,
                  halfedge_id f)
{
    return compare_distance(points[mesh_origin(m, e)], points[mesh_dest(m, e)],
                            points[mesh_origin(m, f)], points[mesh_dest(m, f)]);
}

/* ---- The Gabriel graph. ---- */

/* Is the apex of ab inside the circle with diameter ab, or on it? Then some
 * site is; and if some site on the left of ab is, the apex is, too (page 3.2,
 * graphs.P1). */
static bool
apex_in_diametral_disc(const mesh *m, const point2 *points, halfedge_id ab)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab),
              c = mesh_apex(m, ab);
    return mesh_in_triangle(m, ab) &&
           dot_sign(points[a], points[c], points[b]) <= 0;
}

tri_status
gabriel_graph(const mesh *m, const point2 *points, edge_list *out)
{
    *out = (edge_list){0};
    bool *chosen = memory_array(mesh_halfedges(m), sizeof *chosen);
    if (chosen == NULL)
        return TRI_OUT_OF_MEMORY;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        halfedge_id twin = mesh_twin(m, e);
        chosen[e] = e < twin && !apex_in_diametral_disc(m, points, e) &&
                    !apex_in_diametral_disc(m, points, twin);
    }
    tri_status status = mesh_edges(m, chosen, out);
    memory_free(chosen);
    return status;
}

/* ---- The relative neighbourhood graph. ---- */

/* Is z nearer to both ends of e than these are to each other? */
static bool
in_lune(const mesh *m, const point2 *points, halfedge_id e, vertex_id z)
{
    point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)],
           p = points[z];
    return compare_distance(a, p, a, b) < 0 && compare_distance(b, p, a, b) < 0;
}

/* An elimination path: a site z on the left of e, with e in its way, can be in
 * the lune of one edge behind e only, the longer one of the triangle on the
 * right of e (page 3.2, graphs.P3); of equally long ones in none. The half-edge
 * along it that has z on its left; NONE when there is no triangle. */
static halfedge_id
next_on_path(const mesh *m, const point2 *points, halfedge_id e)
{
    halfedge_id twin = mesh_twin(m, e);
    if (!mesh_in_triangle(m, twin))
        return NONE;
    halfedge_id f = mesh_next(twin), g = mesh_prev(twin);
    return compare_halfedges(m, points, f, g) > 0 ? f : g;
}

/* ahead[e] is e while nobody has eliminated e, and afterwards a half-edge that
 * comes later on every elimination path through e, such that nothing is left to
 * eliminate between the two; or NONE. The first one from e on that is not
 * eliminated, or NONE; the way there becomes shorter, as in `component` of
 * emst.c. */
static halfedge_id
first_ahead(halfedge_id *ahead, halfedge_id e)
{
    while (e != NONE && ahead[e] != e) {
        halfedge_id f = ahead[e];
        if (f != NONE)
            ahead[e] = f = ahead[f];
        e = f;
    }
    return e;
}

/* Takes e out of the paths. If the path from e comes back to e, it goes around
 * some of the sites, and something else is left on it: an edge that connects them
 * with the others, for the graph is connected (page 3.2, graphs.P6). */
static void
eliminate_halfedge(const mesh *m, const point2 *points, halfedge_id *ahead,
                   halfedge_id e)
{
    ahead[e] = first_ahead(ahead, next_on_path(m, points, e));
}

/* Eliminates what the site z, on the left of e, eliminates beginning at e. Each
 * test of a lune removes an edge for ever or is the last one. */
static void
follow_path(const mesh *m, const point2 *points, halfedge_id *ahead,
            halfedge_id e, vertex_id z)
{
    for (;;) {
        e = first_ahead(ahead, e);
        if (e == NONE || !in_lune(m, points, e, z))
            return;
        eliminate_halfedge(m, points, ahead, e);
        eliminate_halfedge(m, points, ahead, mesh_twin(m, e));
    }
}

tri_status
relative_neighbourhood_graph(const mesh *m, const point2 *points,
                             edge_list *out)
{
    *out = (edge_list){0};
    bool *chosen = memory_array(mesh_halfedges(m), sizeof *chosen);
    halfedge_id *ahead = memory_array(mesh_halfedges(m), sizeof *ahead);
    tri_status status = TRI_OUT_OF_MEMORY;
    if (chosen != NULL && ahead != NULL) {
        for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
            ahead[e] = e;
        for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
            if (mesh_in_triangle(m, e))
                follow_path(m, points, ahead, e, mesh_apex(m, e));
        for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
            chosen[e] = ahead[e] == e;
        status = mesh_edges(m, chosen, out);
    }
    memory_free(chosen);
    memory_free(ahead);
    return status;
}

/* ---- The graph of the nearest neighbours. ---- */

/* nearest[v] becomes one of the shortest half-edges that leave v; NONE without
 * any. */
static void
find_nearest(const mesh *m, const point2 *points, halfedge_id *nearest)
{
    for (vertex_id v = 0; v < m->points; v++)
        nearest[v] = NONE;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        vertex_id v = mesh_origin(m, e);
        if (is_edge(m, e) && (nearest[v] == NONE ||
                              compare_halfedges(m, points, e, nearest[v]) < 0))
            nearest[v] = e;
    }
}

tri_status
nearest_neighbour_graph(const mesh *m, const point2 *points, edge_list *out)
{
    *out = (edge_list){0};
    bool *chosen = memory_array(mesh_halfedges(m), sizeof *chosen);
    halfedge_id *nearest = memory_array(m->points, sizeof *nearest);
    tri_status status = TRI_OUT_OF_MEMORY;
    if (chosen != NULL && nearest != NULL) {
        find_nearest(m, points, nearest);
        for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
            vertex_id v = mesh_origin(m, e);
            chosen[e] = is_edge(m, e) &&
                        compare_halfedges(m, points, e, nearest[v]) == 0;
        }
        status = mesh_edges(m, chosen, out);
    }
    memory_free(chosen);
    memory_free(nearest);
    return status;
}
