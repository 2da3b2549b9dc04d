/* plane_graph.c - plane graphs: from a mesh, from a drawing, and their duals.
 *
 * The order of edges around a vertex is a geometric question and needs 3.4; all
 * the rest of section 2.2 is about that order alone.
 */
#include "chapters/2.2_eulers_formula/plane_graph.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

static tri_status
graph_init(plane_graph *g, uint32_t vertices, uint32_t edges)
{
    *g = (plane_graph){.vertices = vertices, .edges = edges, .outside = NONE};
    tri_status status = TRI_OK;
    if (edges > UINT32_MAX / 2)
        status = TRI_TOO_MANY_POINTS;
    if (status == TRI_OK) {
        g->origin = memory_array(edges, 2 * sizeof *g->origin);
        g->next = memory_array(edges, 2 * sizeof *g->next);
        g->leaving = memory_array(vertices, sizeof *g->leaving);
        if (g->origin == NULL || g->next == NULL || g->leaving == NULL)
            status = TRI_OUT_OF_MEMORY;
    }
    if (status != TRI_OK) {
        graph_free(g);
        return status;
    }
    for (vertex_id v = 0; v < vertices; v++)
        g->leaving[v] = NONE;
    return TRI_OK;
}

void
graph_free(plane_graph *g)
{
    memory_free(g->origin);
    memory_free(g->next);
    memory_free(g->leaving);
    *g = (plane_graph){0};
}

/* ---- From a mesh. ---- */

/* Does e join two points? Then there is a triangle on its left, or the outside. */
static bool
joins_points(const mesh *m, halfedge_id e)
{
    return mesh_in_triangle(m, e) || mesh_is_hull_edge(m, mesh_twin(m, e));
}

/* The next half-edge along the face left of e. Along the outside one walks against
 * the direction of the hull edges. */
static halfedge_id
next_along_face(const mesh *m, halfedge_id e)
{
    if (mesh_in_triangle(m, e))
        return mesh_next(e);
    return mesh_twin(m, mesh_hull_prev(m, mesh_twin(m, e)));
}

/* number[e] is the half-edge of the graph that half-edge e of the mesh becomes, NONE
 * if it does not join two points. Returns how many edges do. */
static uint32_t
number_edges(const mesh *m, halfedge_id *number)
{
    uint32_t edges = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        halfedge_id f = mesh_twin(m, e);
        if (e > f)
            continue; /* numbered with its twin */
        number[e] = number[f] = NONE;
        if (!joins_points(m, e))
            continue;
        number[e] = 2 * edges;
        number[f] = 2 * edges + 1;
        edges++;
    }
    return edges;
}

static void
number_vertices(const mesh *m, vertex_id *name)
{
    vertex_id next = 0;
    for (vertex_id v = 0; v < m->points; v++)
        if (mesh_leaving(m, v) != NONE)
            name[v] = next++;
}

static void
copy_edges(const mesh *m, const halfedge_id *number, const vertex_id *name,
           plane_graph *g)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        halfedge_id h = number[e];
        if (h == NONE)
            continue;
        g->origin[h] = name[mesh_origin(m, e)];
        g->next[h] = number[next_along_face(m, e)];
        g->leaving[g->origin[h]] = h;
    }
    halfedge_id hull = mesh_some_hull_edge(m);
    if (hull != NONE)
        g->outside = number[mesh_twin(m, hull)];
}

tri_status
graph_from_mesh(const mesh *m, plane_graph *out)
{
    *out = (plane_graph){0};
    halfedge_id *number = memory_array(mesh_halfedges(m), sizeof *number);
    vertex_id *name = memory_array(m->points, sizeof *name);
    tri_status status = TRI_OUT_OF_MEMORY;
    if (number != NULL && name != NULL)
        status = graph_init(out, m->locations, number_edges(m, number));
    if (status == TRI_OK) {
        number_vertices(m, name);
        copy_edges(m, number, name, out);
    }
    memory_free(number);
    memory_free(name);
    return status;
}

/* ---- From a drawing. ---- */

/* Is f before h when one turns counterclockwise around their common origin, from
 * straight down once around? Those that lead to lexicographically larger points
 * come first; within each half turn, left is later. */
static bool
comes_before(const plane_graph *g, const point2 *points, halfedge_id f, halfedge_id h)
{
    const point2 right = {1, 0};
    point2 a = points[g->origin[f]];
    point2 b = points[graph_dest(g, f)], c = points[graph_dest(g, h)];
    bool f_first_half = compare_along(right, a, b) < 0;
    bool h_first_half = compare_along(right, a, c) < 0;
    if (f_first_half != h_first_half)
        return f_first_half;
    return orient2d(a, b, c) > 0;
}

/* Puts h into the list of half-edges that leave its origin, which begins with
 * `leaving`, goes on with `later`, and ends with NONE. */
static void
insert_in_order(plane_graph *g, halfedge_id *later, const point2 *points, halfedge_id h)
{
    halfedge_id *place = &g->leaving[g->origin[h]];
    while (*place != NONE && comes_before(g, points, *place, h))
        place = &later[*place];
    later[h] = *place;
    *place = h;
}

/* Who walks along a face and arrives at a vertex turns left as far as possible: out
 * by h means in by the twin of the half-edge after h, counterclockwise. */
static void
link_faces(plane_graph *g, const halfedge_id *later)
{
    for (halfedge_id h = 0; h < 2 * g->edges; h++) {
        halfedge_id after = later[h] != NONE ? later[h] : g->leaving[g->origin[h]];
        g->next[graph_twin(after)] = h;
    }
}

/* All neighbours of the lexicographically smallest vertex with an edge lie in the
 * first half turn, so the outer face is left of the last half-edge in its list. */
static halfedge_id
leave_outside(const plane_graph *g, const halfedge_id *later, const point2 *points)
{
    const point2 right = {1, 0};
    halfedge_id h = NONE;
    for (vertex_id v = 0; v < g->vertices; v++)
        if (g->leaving[v] != NONE &&
            (h == NONE || compare_along(right, points[v], points[g->origin[h]]) < 0))
            h = g->leaving[v];
    while (h != NONE && later[h] != NONE)
        h = later[h];
    return h;
}

tri_status
graph_from_drawing(const point2 *points, uint32_t n, const edge_ends *edge,
                   uint32_t edges, plane_graph *out)
{
    tri_status status = graph_init(out, n, edges);
    if (status != TRI_OK)
        return status;
    halfedge_id *later = memory_array(edges, 2 * sizeof *later);
    if (later == NULL) {
        graph_free(out);
        return TRI_OUT_OF_MEMORY;
    }
    for (uint32_t k = 0; k < edges; k++) {
        out->origin[2 * k] = edge[k].a;
        out->origin[2 * k + 1] = edge[k].b;
        insert_in_order(out, later, points, 2 * k);
        insert_in_order(out, later, points, 2 * k + 1);
    }
    link_faces(out, later);
    out->outside = leave_outside(out, later, points);
    memory_free(later);
    return TRI_OK;
}

/* ---- Faces, and the dual. ---- */

uint32_t
graph_trace_faces(const plane_graph *g, face_id *left)
{
    uint32_t walks = 0;
    for (halfedge_id h = 0; h < 2 * g->edges; h++)
        left[h] = NONE;
    for (halfedge_id h = 0; h < 2 * g->edges; h++) {
        if (left[h] != NONE)
            continue;
        for (halfedge_id s = h; left[s] == NONE; s = g->next[s])
            left[s] = walks;
        walks++;
    }
    for (vertex_id v = 0; v < g->vertices; v++)
        walks += g->leaving[v] == NONE;
    return walks;
}

tri_status
graph_dual(const plane_graph *g, plane_graph *out)
{
    *out = (plane_graph){0};
    face_id *left = memory_array(g->edges, 2 * sizeof *left);
    if (left == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = graph_init(out, graph_trace_faces(g, left), g->edges);
    /* Around a face of G its edges follow each other counterclockwise, and so do the
     * dual half-edges that leave it. A walk in G* that comes back to the face across
     * next(h) therefore turns left, and leaves it across h. */
    for (halfedge_id h = 0; status == TRI_OK && h < 2 * g->edges; h++) {
        out->origin[h] = left[h];
        out->leaving[left[h]] = h;
        out->next[graph_twin(g->next[h])] = h;
    }
    memory_free(left);
    return status;
}
