/* coordinates.c - a site as a weighted mean of its neighbours.
 *
 * Notes: section 3.1. Rounded; all coordinates are taken relative to the site
 * p, so that the weights are as good far from the origin as near it. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "lib/memory.h"

#include <math.h>

static uint32_t
cell_size(const voronoi *d, vertex_id p)
{
    return d->cell_first[p + 1] - d->cell_first[p];
}

/* Edge i of p's cell; the numbers go around. */
static uint32_t
cell_edge(const voronoi *d, vertex_id p, uint32_t i)
{
    return d->cell_edge[d->cell_first[p] + i % cell_size(d, p)];
}

bool
voronoi_is_bounded(const voronoi *d, vertex_id p)
{
    for (uint32_t i = 0; i < cell_size(d, p); i++) {
        voronoi_edge edge = d->edge[cell_edge(d, p, i)];
        if (edge.from == NONE || edge.to == NONE)
            return false;
    }
    return cell_size(d, p) > 0;
}

static point2
minus(point2 a, point2 b)
{
    return (point2){a.x - b.x, a.y - b.y};
}

/* The site beyond edge i, seen from p. */
static point2
beyond(const voronoi *d, const point2 *points, vertex_id p, uint32_t i)
{
    return minus(points[voronoi_beyond(d, cell_edge(d, p, i), p)], points[p]);
}

/* The corner where edge i of p's cell begins, seen from p. */
static tri_status
corner(const voronoi *d, const point2 *points, vertex_id p, uint32_t i,
       point2 *at)
{
    voronoi_edge edge = d->edge[cell_edge(d, p, i)];
    const vertex_id *site =
        d->vertex_site + d->vertex_first[edge.left == p ? edge.from : edge.to];
    tri_status status =
        circumcentre(points[site[0]], points[site[1]], points[site[2]], at);
    *at = minus(*at, points[p]);
    return status;
}

/* Divides the weights by their sum. */
static tri_status
normalise(double *weight, uint32_t size)
{
    double sum = 0;
    for (uint32_t i = 0; i < size; i++)
        sum += weight[i];
    if (!(sum > 0) || !isfinite(sum))
        return TRI_OUT_OF_RANGE;
    for (uint32_t i = 0; i < size; i++)
        weight[i] /= sum;
    return TRI_OK;
}

tri_status
laplace_coordinates(const voronoi *d, const point2 *points, vertex_id p,
                    double *weight)
{
    assert(voronoi_is_bounded(d, p));
    uint32_t size = cell_size(d, p);
    for (uint32_t i = 0; i < size; i++) {
        point2 begin, end, q = beyond(d, points, p, i);
        tri_status status = corner(d, points, p, i, &begin);
        if (status == TRI_OK)
            status = corner(d, points, p, i + 1, &end);
        if (status != TRI_OK)
            return status;
        weight[i] = hypot(end.x - begin.x, end.y - begin.y) / hypot(q.x, q.y);
    }
    return normalise(weight, size);
}

/* Twice the area, by the triangles of the sides and the first corner. */
static double
twice_area(const point2 *polygon, uint32_t size)
{
    double sum = 0;
    for (uint32_t i = 1; i + 1 < size; i++) {
        point2 u = minus(polygon[i], polygon[0]);
        point2 v = minus(polygon[i + 1], polygon[0]);
        sum += u.x * v.y - u.y * v.x;
    }
    return sum;
}

/* What p's cell takes from q, the i-th neighbour, is the part of it that is
 * nearer to q than to the other neighbours: without p, each point of the cell
 * is nearest to one of them. The two arrays have room for cell and cuts. */
static double
taken_from(const voronoi *d, const point2 *points, vertex_id p, uint32_t i,
           const point2 *cell, point2 *polygon, point2 *other)
{
    uint32_t size = cell_size(d, p), left = size;
    for (uint32_t k = 0; k < size; k++)
        polygon[k] = cell[k];
    for (uint32_t k = 0; k < size; k++) {
        if (k == i)
            continue;
        left = cut_polygon(polygon, left, beyond(d, points, p, i),
                           beyond(d, points, p, k), other);
        point2 *cut = other;
        other = polygon;
        polygon = cut;
    }
    return twice_area(polygon, left);
}

tri_status
sibson_coordinates(const voronoi *d, const point2 *points, vertex_id p,
                   double *weight)
{
    assert(voronoi_is_bounded(d, p));
    size_t size = cell_size(d, p);
    /* The cell, and two polygons of at most twice its size. */
    point2 *cell = memory_array(size, 5 * sizeof *cell);
    if (cell == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = TRI_OK;
    for (uint32_t i = 0; i < size && status == TRI_OK; i++)
        status = corner(d, points, p, i, &cell[i]);
    if (status == TRI_OK) {
        for (uint32_t i = 0; i < size; i++)
            weight[i] =
                taken_from(d, points, p, i, cell, cell + size, cell + 3 * size);
        status = normalise(weight, (uint32_t)size);
    }
    memory_free(cell);
    return status;
}
