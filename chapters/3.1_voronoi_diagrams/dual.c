/* dual.c - Definition 6 of the notes: the Voronoi diagram, as the dual of a
 * Delaunay triangulation. A triangle becomes a vertex, an edge an edge, and a
 * site a cell. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* ---- Room. ---- */

void
voronoi_free(voronoi *d)
{
    memory_free(d->vertex_first);
    memory_free(d->vertex_site);
    memory_free(d->edge);
    memory_free(d->cell_first);
    memory_free(d->cell_edge);
    *d = (voronoi){0};
}

/* There are at most as many vertices and corners as triangles and sides. */
static tri_status
make_room(voronoi *d, const mesh *m)
{
    size_t sides = mesh_halfedges(m);
    *d = (voronoi){.points = m->points, .cells = m->locations};
    d->vertex_first = memory_array(sides / 3 + 1, sizeof *d->vertex_first);
    d->vertex_site = memory_array(sides, sizeof *d->vertex_site);
    d->edge = memory_array(sides / 2, sizeof *d->edge);
    d->cell_first = memory_array((size_t)m->points + 1, sizeof *d->cell_first);
    d->cell_edge = memory_array(sides, sizeof *d->cell_edge);
    if (d->vertex_first != NULL && d->vertex_site != NULL && d->edge != NULL &&
        d->cell_first != NULL && d->cell_edge != NULL)
        return TRI_OK;
    voronoi_free(d);
    return TRI_OUT_OF_MEMORY;
}

/* What the steps below tell each other. */
typedef struct names {
    uint32_t *edge;   /* half-edge -> Voronoi edge; NONE if it has none */
    uint32_t *vertex; /* triangle -> Voronoi vertex; NONE outside the hull */
} names;

/* ---- Step 1: which edges are dual to an edge? ---- */

/* Does e join two sites? (The other edges of the mesh lead from the hull
 * outwards.) */
static bool
joins_sites(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, e) < m->points && mesh_dest(m, e) < m->points;
}

/* Are the centres on both sides of e the same point? Then the two triangles
 * have the same circle, and no edge lies between their vertices. */
static bool
vanishes(const mesh *m, const point2 *points, halfedge_id e)
{
    if (!mesh_is_interior(m, e))
        return false;
    vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
    vertex_id c = mesh_apex(m, e), d = mesh_apex(m, mesh_twin(m, e));
    return incircle(points[a], points[b], points[c], points[d]) == 0;
}

/* Numbers the edges. Without points, no edge vanishes. */
static void
name_edges(voronoi *d, const mesh *m, const point2 *points, names *of)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        halfedge_id twin = mesh_twin(m, e);
        if (twin < e)
            of->edge[e] = of->edge[twin];
        else if (!joins_sites(m, e) ||
                 (points != NULL && vanishes(m, points, e)))
            of->edge[e] = NONE;
        else
            of->edge[e] = d->edges++;
    }
}

/* ---- Step 2: the vertices. ---- */

/* The triangles with one circle fill a convex polygon, whose sides are the
 * edges that do not vanish. Walks around that polygon from its side e; the walk
 * turns through each triangle at each of its corners, so it meets them all. */
static void
add_vertex(voronoi *d, const mesh *m, names *of, halfedge_id start)
{
    uint32_t at = d->vertex_first[d->vertices];
    halfedge_id e = start;
    do {
        d->vertex_site[at++] = mesh_origin(m, e);
        of->vertex[mesh_triangle_of(e)] = d->vertices;
        e = mesh_next(e);
        while (of->edge[e] == NONE) {
            e = mesh_next(mesh_twin(m, e));
            of->vertex[mesh_triangle_of(e)] = d->vertices;
        }
    } while (e != start);
    d->vertex_first[++d->vertices] = at;
}

static void
name_vertices(voronoi *d, const mesh *m, names *of)
{
    d->vertex_first[0] = 0;
    for (triangle_id t = 0; t < m->triangles; t++)
        of->vertex[t] = NONE;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_in_triangle(m, e) && of->edge[e] != NONE &&
            of->vertex[mesh_triangle_of(e)] == NONE)
            add_vertex(d, m, of, e);
}

/* ---- Step 3: the ends of the edges. ---- */

/* The half-edge from p to q has its triangle on its left, and so lies the
 * triangle's centre along the bisector: the Voronoi edge with p on its left
 * ends there. */
static void
fill_edges(voronoi *d, const mesh *m, const names *of)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        uint32_t from = of->vertex[mesh_triangle_of(mesh_twin(m, e))];
        uint32_t to = of->vertex[mesh_triangle_of(e)];
        bool first = e < mesh_twin(m, e), ray = (from == NONE) != (to == NONE);
        bool wanted = ray ? to == NONE : first; /* rays run outwards */
        if (of->edge[e] != NONE && wanted)
            d->edge[of->edge[e]] =
                (voronoi_edge){mesh_origin(m, e), mesh_dest(m, e), from, to};
    }
}

/* ---- Step 4: the cells. ---- */

/* Does the list of the cell have to begin with e rather than with best? After a
 * gap, which is outside the hull and on the right of a hull edge; else, and of
 * two, with the lowest index. */
static bool
begins_before(const mesh *m, halfedge_id e, halfedge_id best)
{
    bool after_gap = mesh_is_hull_edge(m, e);
    if (after_gap != mesh_is_hull_edge(m, best))
        return after_gap;
    return mesh_dest(m, e) < mesh_dest(m, best);
}

/* The edges of p's cell are met in the order of its star. */
static void
fill_cell(voronoi *d, const mesh *m, const names *of, vertex_id p)
{
    uint32_t at = d->cell_first[p];
    halfedge_id leaving = mesh_leaving(m, p), begin = NONE;
    if (leaving != NONE) {
        halfedge_id e = leaving;
        do {
            if (of->edge[e] != NONE &&
                (begin == NONE || begins_before(m, e, begin)))
                begin = e;
            e = mesh_around(m, e);
        } while (e != leaving);
        e = begin;
        do {
            if (of->edge[e] != NONE)
                d->cell_edge[at++] = of->edge[e];
            e = mesh_around(m, e);
        } while (e != begin);
    }
    d->cell_first[p + 1] = at;
}

/* ---- The diagram. ---- */

static tri_status
dual(const mesh *m, const point2 *points, voronoi *out)
{
    tri_status status = make_room(out, m);
    if (status != TRI_OK)
        return status;
    names of = {memory_array(mesh_halfedges(m), sizeof *of.edge),
                memory_array(m->triangles, sizeof *of.vertex)};
    if (of.edge != NULL && of.vertex != NULL) {
        name_edges(out, m, points, &of); // Step 1
        name_vertices(out, m, &of);      // Step 2
        fill_edges(out, m, &of);         // Step 3
        out->cell_first[0] = 0;
        for (vertex_id p = 0; p < m->points; p++)
            fill_cell(out, m, &of, p);   // Step 4
    } else {
        voronoi_free(out);
        status = TRI_OUT_OF_MEMORY;
    }
    memory_free(of.edge);
    memory_free(of.vertex);
    return status;
}

tri_status
voronoi_dual(const mesh *m, const point2 *points, voronoi *out)
{
    return dual(m, points, out);
}

tri_status
voronoi_per_triangle(const mesh *m, voronoi *out)
{
    return dual(m, NULL, out);
}
