/* subdivision.c - the Delaunay subdivision, from a Delaunay triangulation. */
#include "chapters/3.2_empty_circumcircle/empty_circle.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

#include <string.h>

/* The walk along the cells of a mesh. */
typedef struct cell_walk {
    const mesh *m;
    bool *side;    /* half-edge -> is it a side of the cell on its left? */
    bool *visited; /* half-edge -> has its cell been listed? */
} cell_walk;

/* Is ab the side of a cell: on the hull, or between two triangles with
 * different circles? Then d is not on the circle of a, b, c. */
static bool
separates_cells(const mesh *m, const point2 *points, halfedge_id ab)
{
    if (!mesh_is_interior(m, ab))
        return true;
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, mesh_twin(m, ab));
    return incircle(points[a], points[b], points[c], points[d]) != 0;
}

static void
find_sides(cell_walk *w, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(w->m); e++) {
        halfedge_id twin = mesh_twin(w->m, e);
        w->visited[e] = false;
        if (e < twin)
            w->side[e] = w->side[twin] = separates_cells(w->m, points, e);
    }
}

/* The next side of the same cell: after an edge inside the cell, which is none,
 * the walk goes on behind it. */
static halfedge_id
next_side(const cell_walk *w, halfedge_id e)
{
    halfedge_id f = mesh_next(e);
    while (!w->side[f])
        f = mesh_next(mesh_twin(w->m, f));
    return f;
}

/* Is e the side of a cell that has not been listed? */
static bool
begins_cell(const cell_walk *w, halfedge_id e)
{
    return mesh_in_triangle(w->m, e) && w->side[e] && !w->visited[e];
}

/* Lists the corners of the cell on the left of e, beginning at e. */
static void
list_cell(cell_walk *w, halfedge_id e, subdivision *s)
{
    uint32_t end = s->first[s->cells];
    for (; !w->visited[e]; e = next_side(w, e)) {
        w->visited[e] = true;
        s->vertex[end++] = mesh_origin(w->m, e);
    }
    s->first[++s->cells] = end;
}

/* Of the half-edges that leave v along sides of cells that are not listed yet,
 * the one with the lowest end; NONE when there is none. */
static halfedge_id
lowest_beginning(const cell_walk *w, vertex_id v)
{
    halfedge_id first = mesh_leaving(w->m, v), e = first, lowest = NONE;
    if (first == NONE)
        return NONE;
    do {
        if (begins_cell(w, e) &&
            (lowest == NONE || mesh_dest(w->m, e) < mesh_dest(w->m, lowest)))
            lowest = e;
        e = mesh_around(w->m, e);
    } while (e != first);
    return lowest;
}

/* The cells at v that are not listed yet have no corner below v: each cell is
 * found at its lowest corner. */
static void
list_cells_at(cell_walk *w, vertex_id v, subdivision *s)
{
    halfedge_id first = lowest_beginning(w, v), e = first;
    if (first == NONE)
        return;
    do {
        if (begins_cell(w, e))
            list_cell(w, e, s);
        e = mesh_around(w->m, e);
    } while (e != first);
}

tri_status
delaunay_subdivision(const mesh *m, const point2 *points, subdivision *out)
{
    uint32_t halfedges = mesh_halfedges(m);
    *out = (subdivision){0};
    out->first = memory_array((size_t)m->triangles + 1, sizeof *out->first);
    out->vertex = memory_array(halfedges, sizeof *out->vertex);
    cell_walk w = {.m = m,
                   .side = memory_array(halfedges, sizeof *w.side),
                   .visited = memory_array(halfedges, sizeof *w.visited)};
    tri_status status = TRI_OUT_OF_MEMORY;
    if (out->first != NULL && out->vertex != NULL && w.side != NULL &&
        w.visited != NULL) {
        status = TRI_OK;
        out->first[0] = 0;
        find_sides(&w, points);
        for (vertex_id v = 0; v < m->points; v++)
            list_cells_at(&w, v, out);
    }
    memory_free(w.side);
    memory_free(w.visited);
    if (status != TRI_OK)
        subdivision_free(out);
    return status;
}

bool
subdivisions_are_equal(const subdivision *s, const subdivision *t)
{
    if (s->cells != t->cells)
        return false;
    for (uint32_t i = 0; i < s->cells; i++)
        if (s->first[i + 1] != t->first[i + 1])
            return false;
    return memcmp(s->vertex, t->vertex,
                  s->first[s->cells] * sizeof *s->vertex) == 0;
}

void
subdivision_free(subdivision *s)
{
    memory_free(s->first);
    memory_free(s->vertex);
    *s = (subdivision){0};
}
