/* check.c - is_voronoi: a diagram is certified by questions to the sites alone.
 *
 * Notes: section 3.1; page 3.1, sec3.1.P11. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* The verdict with four sites to look at. */
static verdict
with_sites(verdict v, vertex_id a, vertex_id b, vertex_id c, vertex_id x)
{
    return verdict_with(verdict_with(verdict_with(verdict_with(v, a), b), c),
                        x);
}

/* ---- The numbers are numbers of something. ---- */

/* Are first[0 .. count] places in a list, in order? */
static bool
are_places(const uint32_t *first, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        if (first[i] > first[i + 1])
            return false;
    return first[0] == 0;
}

static verdict
check_numbers(const voronoi *d, uint32_t n)
{
    if (d->points != n || !are_places(d->vertex_first, d->vertices) ||
        !are_places(d->cell_first, n))
        return verdict_refuted(
            "the lists of the vertices or of the cells are broken");
    uint32_t corners = d->vertex_first[d->vertices];
    for (uint32_t i = 0; i < corners; i++)
        if (d->vertex_site[i] >= n)
            return verdict_refuted("a vertex has the site %u, and there are %u",
                                   (unsigned)d->vertex_site[i], (unsigned)n);
    for (uint32_t k = 0; k < d->edges; k++) {
        voronoi_edge e = d->edge[k];
        if (e.left >= n || e.right >= n ||
            (e.from >= d->vertices && e.from != NONE) ||
            (e.to >= d->vertices && e.to != NONE))
            return verdict_refuted(
                "edge %u has a site or an end that does not exist",
                (unsigned)k);
    }
    for (uint32_t i = 0; i < d->cell_first[n]; i++)
        if (d->cell_edge[i] >= d->edges)
            return verdict_refuted("a cell has the edge %u, and there are %u",
                                   (unsigned)d->cell_edge[i],
                                   (unsigned)d->edges);
    return verdict_holds();
}

/* ---- 1 and 2: the vertices. ---- */

/* Are there at least three sites, all on one circle? */
static verdict
check_vertex(const voronoi *d, const point2 *points, uint32_t v)
{
    const vertex_id *s = d->vertex_site + d->vertex_first[v];
    uint32_t size = d->vertex_first[v + 1] - d->vertex_first[v];
    if (size < 3)
        return verdict_refuted("vertex %u has %u sites", (unsigned)v,
                               (unsigned)size);
    for (uint32_t i = 3; i < size; i++) {
        point2 a = points[s[0]], b = points[s[1]], c = points[s[2]];
        if (incircle(a, b, c, points[s[i]]) == 0)
            continue;
        verdict refuted = verdict_refuted(
            "the sites of vertex %u are on no circle", (unsigned)v);
        return with_sites(refuted, s[0], s[1], s[2], s[i]);
    }
    return verdict_holds();
}

/* The fans over all vertices, and which vertex each triangle belongs to.
 * Requires: each vertex has at least three sites. */
static void
make_fans(const voronoi *d, triangle_list *fans, uint32_t *vertex_of)
{
    for (uint32_t v = 0; v < d->vertices; v++) {
        const vertex_id *s = d->vertex_site + d->vertex_first[v];
        uint32_t size = d->vertex_first[v + 1] - d->vertex_first[v];
        for (uint32_t i = 1; i + 1 < size; i++) {
            vertex_id *corner = fans->corner[fans->count];
            corner[0] = s[0];
            corner[1] = s[i];
            corner[2] = s[i + 1];
            vertex_of[fans->count++] = v;
        }
    }
}

/* Between two vertices, does neither circle have a site of the other triangle
 * inside, and are the circles different? Within a vertex they are the same. */
static verdict
check_circles(const point2 *points, triangle_list fans, const halfedge_id *twin,
              const uint32_t *vertex_of)
{
    for (halfedge_id e = 0; e < 3 * fans.count; e++) {
        if (twin[e] == NONE || vertex_of[e / 3] == vertex_of[twin[e] / 3])
            continue;
        vertex_id a = side_origin(fans, e), b = side_dest(fans, e);
        vertex_id c = side_apex(fans, e), x = side_apex(fans, twin[e]);
        int side = incircle(points[a], points[b], points[c], points[x]);
        if (side < 0)
            continue;
        unsigned v = (unsigned)vertex_of[e / 3];
        unsigned w = (unsigned)vertex_of[twin[e] / 3];
        verdict refuted = verdict_refuted(
            side == 0 ? "vertices %u and %u are the same point"
                      : "the circle of vertex %u is not empty, see vertex %u",
            v, w);
        return with_sites(refuted, a, b, c, x);
    }
    return verdict_holds();
}

static tri_status
check_vertices(const point2 *points, uint32_t n, const voronoi *d, verdict *out)
{
    for (uint32_t v = 0; v < d->vertices; v++) {
        *out = check_vertex(d, points, v);
        if (!out->holds)
            return TRI_OK;
    }
    size_t most = d->vertex_first[d->vertices]; /* more than triangles */
    triangle_list fans = {0, memory_array(most, sizeof *fans.corner)};
    uint32_t *vertex_of = memory_array(most, sizeof *vertex_of);
    halfedge_id *twin = NULL;
    tri_status status = TRI_OUT_OF_MEMORY;
    if (fans.corner != NULL && vertex_of != NULL) {
        make_fans(d, &fans, vertex_of);
        status = is_triangulation_with_twins(points, n, fans, out, &twin);
        if (status == TRI_OK && out->holds)
            *out = check_circles(points, fans, twin, vertex_of);
    }
    triangle_list_free(&fans);
    memory_free(vertex_of);
    memory_free(twin);
    return status;
}

/* ---- 3: the cells. ---- */

/* An edge as seen from p, which lies on its left then. */
static voronoi_edge
seen_from(const voronoi *d, uint32_t k, vertex_id p)
{
    voronoi_edge e = d->edge[k];
    if (e.left != p)
        e = (voronoi_edge){e.right, e.left, e.to, e.from};
    return e;
}

/* Is q, p, r a corner of the polygon of vertex v: does p come after r and
 * before q? */
static bool
is_corner(const voronoi *d, uint32_t v, vertex_id r, vertex_id p, vertex_id q)
{
    const vertex_id *s = d->vertex_site + d->vertex_first[v];
    uint32_t size = d->vertex_first[v + 1] - d->vertex_first[v];
    for (uint32_t i = 0; i < size; i++)
        if (s[i] == p)
            return s[(i + size - 1) % size] == r && s[(i + 1) % size] == q;
    return false;
}

static verdict
refuted_cell(vertex_id p, vertex_id q, const char *what)
{
    verdict v = verdict_refuted("the cell of %u, at its edge with %u: %s",
                                (unsigned)p, (unsigned)q, what);
    return verdict_with(verdict_with(v, p), q);
}

/* Do the edges of p's cell run from corner to corner, infinity at most between
 * the last and the first? Adds to *corners how many have been met; met[q] = p
 * says that q has been met beyond an edge of p. */
static verdict
check_cell(const voronoi *d, vertex_id p, vertex_id *met, uint32_t *corners)
{
    uint32_t begin = d->cell_first[p], size = d->cell_first[p + 1] - begin;
    for (uint32_t i = 0; i < size; i++) {
        voronoi_edge e = seen_from(d, d->cell_edge[begin + i], p);
        voronoi_edge next =
            seen_from(d, d->cell_edge[begin + (i + 1) % size], p);
        if (e.left != p || e.right == p)
            return refuted_cell(p, e.right, "it is not an edge of both");
        if (met[e.right] == p)
            return refuted_cell(p, e.right, "there are two of them");
        met[e.right] = p;
        if (e.from == NONE && e.to == NONE)
            return refuted_cell(p, e.right,
                                "it is a line, and there are vertices");
        if (e.to == NONE && i + 1 < size)
            return refuted_cell(p, e.right,
                                "it is a ray, and not the last one");
        if (e.to != NONE && !is_corner(d, e.to, next.right, p, e.right))
            return refuted_cell(p, e.right,
                                "its end is no corner at these sites");
        *corners += e.to != NONE;
    }
    return verdict_holds();
}

/* Sites that differ beyond the edges of a cell make the corners that are met
 * different ones. If there are as many as corners, each has been met. */
static tri_status
check_cells(const voronoi *d, verdict *out)
{
    vertex_id *met = memory_array(d->points, sizeof *met);
    if (met == NULL)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id p = 0; p < d->points; p++)
        met[p] = NONE;
    uint32_t corners = 0, cells = 0;
    *out = verdict_holds();
    for (vertex_id p = 0; p < d->points && out->holds; p++) {
        *out = check_cell(d, p, met, &corners);
        cells += d->cell_first[p] < d->cell_first[p + 1];
    }
    memory_free(met);
    if (out->holds && corners != d->vertex_first[d->vertices])
        *out = verdict_refuted("the vertices have %u corners, and the cells %u",
                               (unsigned)d->vertex_first[d->vertices],
                               (unsigned)corners);
    if (out->holds && d->cell_first[d->points] != 2 * d->edges)
        *out = verdict_refuted(
            "%u edges in all cells: each of %u should be in two",
            (unsigned)d->cell_first[d->points], (unsigned)d->edges);
    if (out->holds && cells != d->cells)
        *out = verdict_refuted("%u cells are announced, and there are %u",
                               (unsigned)d->cells, (unsigned)cells);
    return TRI_OK;
}

/* ---- 4: collinear sites. ---- */

/* Is the line k the one between p and q? */
static bool
is_line_between(const voronoi *d, uint32_t k, vertex_id p, vertex_id q)
{
    voronoi_edge e = seen_from(d, k, p);
    return e.left == p && e.right == q && e.from == NONE && e.to == NONE;
}

/* Are the edges of each cell the lines to its site's neighbours in order? */
static verdict
check_lines(const voronoi *d, const vertex_id *order, uint32_t u)
{
    if (d->cells != u || d->edges != (u > 0 ? u - 1 : 0) ||
        d->cell_first[d->points] != 2 * d->edges)
        return verdict_refuted("%u cells and %u lines of %u collinear sites",
                               (unsigned)d->cells, (unsigned)d->edges,
                               (unsigned)u);
    for (uint32_t i = 0; i < u; i++) {
        vertex_id p = order[i], wanted[2];
        uint32_t begin = d->cell_first[p], count = 0;
        uint32_t size = d->cell_first[p + 1] - begin;
        if (i > 0)
            wanted[count++] = order[i - 1];
        if (i + 1 < u)
            wanted[count++] = order[i + 1];
        bool right = size == count;
        for (uint32_t k = 0; k < count && right; k++)
            right = is_line_between(d, d->cell_edge[begin], p, wanted[k]) ||
                    is_line_between(d, d->cell_edge[begin + size - 1], p,
                                    wanted[k]);
        if (!right)
            return verdict_with(
                verdict_refuted("the cell of %u does not lie between lines to "
                                "its neighbours", (unsigned)p), p);
    }
    return verdict_holds();
}

/* ---- All together. ---- */

tri_status
is_voronoi(const point2 *points, uint32_t n, const voronoi *d, verdict *out)
{
    *out = check_numbers(d, n);
    if (!out->holds)
        return TRI_OK;
    tri_status status = check_vertices(points, n, d, out);
    if (status != TRI_OK || !out->holds)
        return status;
    if (d->vertices > 0)
        return check_cells(d, out);

    uint32_t u;
    vertex_id *order = memory_array(n, sizeof *order);
    if (order == NULL)
        return TRI_OUT_OF_MEMORY;
    status = sort_along(points, n, (point2){1, 0}, order, &u);
    if (status == TRI_OK)
        *out = check_lines(d, order, u);
    memory_free(order);
    return status;
}
