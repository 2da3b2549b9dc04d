/* bucket_grid.c - the cells, their vertices, and the rings around a cell. */
#include "chapters/3.6_randomized_incremental/bucket_grid.h"

#include "chapters/3.6_randomized_incremental/incremental.h"
#include "lib/memory.h"

enum { MOST_PER_CELL = 2 };

/* ---- Cells. ---- */

/* In which of `side` equal parts of [least, most] does c lie? Halves, so that the
 * difference of two coordinates is no infinity. */
static uint32_t
part_of(double c, double least, double most, uint32_t side)
{
    double at = (c / 2 - least / 2) / (most / 2 - least / 2) * side;
    if (!(at >= 0)) /* there is no width */
        return 0;
    return at < side ? (uint32_t)at : side - 1;
}

static uint32_t
column_of(const bucket_grid *g, point2 p)
{
    return part_of(p.x, g->least.x, g->most.x, g->side);
}

static uint32_t
row_of(const bucket_grid *g, point2 p)
{
    return part_of(p.y, g->least.y, g->most.y, g->side);
}

uint32_t
bucket_grid_cell(const bucket_grid *g, point2 p)
{
    return row_of(g, p) * g->side + column_of(g, p);
}

/* ---- Filling. ---- */

/* Divides the cells so that n vertices are at most MOST_PER_CELL for each; there are
 * fewer than 2n cells then, or one. */
static uint32_t
side_for(uint32_t side, uint32_t n)
{
    while (n > MOST_PER_CELL * (uint64_t)side * side)
        side *= 2;
    return side;
}

tri_status
bucket_grid_init(bucket_grid *g, const point2 *points, const vertex_id *order,
                 uint32_t most)
{
    *g = (bucket_grid){.points = points, .order = order, .side = 1,
                       .least = points[order[0]], .most = points[order[0]]};
    size_t side = side_for(1, most);
    g->latest = memory_array(side * side, sizeof *g->latest);
    if (g->latest == NULL) {
        *g = (bucket_grid){0};
        return TRI_OUT_OF_MEMORY;
    }
    g->latest[0] = NONE;
    for (uint32_t i = 1; i < most; i++) {
        point2 p = points[order[i]];
        g->least.x = p.x < g->least.x ? p.x : g->least.x;
        g->least.y = p.y < g->least.y ? p.y : g->least.y;
        g->most.x = p.x > g->most.x ? p.x : g->most.x;
        g->most.y = p.y > g->most.y ? p.y : g->most.y;
    }
    return TRI_OK;
}

void
bucket_grid_free(bucket_grid *g)
{
    memory_free(g->latest);
    *g = (bucket_grid){0};
}

static void
put(bucket_grid *g, vertex_id v)
{
    g->latest[bucket_grid_cell(g, g->points[v])] = v;
}

void
bucket_grid_add(bucket_grid *g)
{
    g->count++;
    uint32_t side = side_for(g->side, g->count);
    if (side == g->side) {
        put(g, g->order[g->count - 1]);
        return;
    }
    g->side = side;
    for (uint32_t cell = 0; cell < side * side; cell++)
        g->latest[cell] = NONE;
    for (uint32_t i = 0; i < g->count; i++)
        put(g, g->order[i]);
}

/* ---- Searching. ---- */

/* Some vertex in ring number `ring` around a cell: in the cells that are so many
 * columns or rows away from it, and not more. NONE if they are empty. */
static vertex_id
vertex_in_ring(const bucket_grid *g, int64_t column, int64_t row, int64_t ring)
{
    int64_t first = row > ring ? row - ring : 0;
    for (int64_t y = first; y <= row + ring && y < g->side; y++) {
        bool whole_row = y == row - ring || y == row + ring;
        int64_t step = whole_row ? 1 : 2 * ring; /* else its two ends */
        for (int64_t x = column - ring; x <= column + ring; x += step)
            if (x >= 0 && x < g->side && g->latest[y * g->side + x] != NONE)
                return g->latest[y * g->side + x];
    }
    return NONE;
}

/* Some cell is not empty, so the loop ends. */
vertex_id
bucket_grid_near(const bucket_grid *g, point2 p)
{
    int64_t column = column_of(g, p), row = row_of(g, p), ring = 0;
    vertex_id v;
    while ((v = vertex_in_ring(g, column, row, ring)) == NONE)
        ring++;
    return v;
}

/* ---- Figure 12 with a grid. ---- */

tri_status
bucketed_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                     mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    used.locator = TRI_LOCATOR_GRID;
    return incremental_triangulate(points, n, &used, out);
}
