/* bucket_grid.h - a vertex near a point, from a grid of cells; and insertion with it.
 *
 * Notes: section 3.7, which names it: the buckets of Su and Drysdale. Needs:
 * incremental.h.
 *
 * The buckets of buckets.h are triangles, and keep the points that are still to come.
 * These are the cells of a grid, and know the points that have come already: a walk
 * begins at one that is near its end.
 */
#ifndef CHAPTERS_3_6_BUCKET_GRID_H
#define CHAPTERS_3_6_BUCKET_GRID_H

#include "lib/mesh.h"
#include "lib/options.h"

typedef struct bucket_grid {
    const point2 *points;
    const vertex_id *order; /* order[0 .. count-1] are in the grid */
    uint32_t count;
    point2 least, most; /* the box around all that will ever be in it */
    uint32_t side;      /* there are side * side cells, in rows */
    vertex_id *latest;  /* cell -> the vertex that came into it last, or NONE */
} bucket_grid;

/* An empty grid for the points order[0 .. most-1], which shall come in this order.
 * Requires: most > 0. TRI_OUT_OF_MEMORY: *g is zeroed. */
tri_status bucket_grid_init(bucket_grid *g, const point2 *points,
                            const vertex_id *order, uint32_t most);

/* Frees the array and zeroes *g; a zeroed struct is accepted. */
void bucket_grid_free(bucket_grid *g);

/* The next of the order comes into the grid. When there are more than 2 for each
 * cell, the cells are divided in four and filled anew.
 * Requires: there is a next one. Cost: O(1) amortised. */
void bucket_grid_add(bucket_grid *g);

/* The cell of p, of side * side. Rounding moves p over the border of a cell at most,
 * which does no harm. Requires: p is one of the points of the order. */
uint32_t bucket_grid_cell(const bucket_grid *g, point2 p);

/* A vertex in the cell of p or in a nearest ring of cells around it that is not empty.
 *
 * Requires: as above, and the grid is not empty.
 * Cost: at most (2r+1)^2 cells for ring number r. Asks no predicate.
 * Source: Bentley, Weide and Yao 1980, for nearest neighbours.
 */
vertex_id bucket_grid_near(const bucket_grid *g, point2 p);

/* Figure 12, with a walk from a vertex that the grid finds: incremental_triangulate
 * with TRI_LOCATOR_GRID, whatever options->locator says.
 *
 * Statuses and conventions: lib/options.h.
 * Cost: O(n log n) comparisons to find the distinct locations; then O(n) expected
 * for uniform points in random order, and O(n^2) for the worst points.
 * Source: Su and Drysdale 1995.
 */
tri_status bucketed_triangulate(const point2 *points, uint32_t n,
                                const tri_options *options, mesh *out);

#endif
