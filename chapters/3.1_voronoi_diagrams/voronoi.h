/* voronoi.h - who is nearest to what: regions, the diagram, and its dual.
 *
 * Notes: section 3.1, Definitions 5 and 6. Needs: 3.4 (orient2d, incircle,
 * compare_along, compare_distance), a Delaunay triangulation from whoever calls,
 * 2.1 and 2.3 for the check, lib/mesh.h. Exercises: 3.1-a to 3.1-c.
 *
 * A Voronoi vertex is the centre of a circle through at least three sites, so
 * it is named by these sites, and all questions about it are asked of them. Its
 * coordinates are computed only to be shown (circumcentre) and decide nothing.
 */
#ifndef CHAPTERS_3_1_VORONOI_H
#define CHAPTERS_3_1_VORONOI_H

#include "lib/mesh.h"

/* ---- Definition 5: one region, from the definition. ---- */

/* The region of site p: the sites whose bisectors carry its edges,
 * counterclockwise.
 *
 * Sites i and i+1 (the last and the first, too) meet in a vertex if they turn
 * left around p, orient2d(p, i, i+1) > 0; otherwise the region is unbounded
 * between their edges. An unbounded region begins after that gap; a bounded
 * one, and a strip, with the lowest index. The whole plane has no edges. */
typedef struct voronoi_region {
    uint32_t size;
    vertex_id *neighbour;
} voronoi_region;

/* The Voronoi region of p, by intersecting the half-planes H_pq one by one.
 *
 * Of sites at one location the lowest index is listed; copies of p do not
 * matter.
 * Cost: O(n k) tests, if the region never has more than k edges on the way.
 * TRI_OUT_OF_MEMORY: *out is zeroed.
 * Source: notes 3.1, Definition 5. */
tri_status voronoi_region_of(const point2 *points, uint32_t n, vertex_id p,
                             voronoi_region *out);

/* Frees the array and zeroes *region; a zeroed region is accepted. */
void voronoi_region_free(voronoi_region *region);

/* ---- Definition 6: all regions together. ---- */

/* An edge lies on the bisector of two sites and runs with `left` on its left.
 * A ray has a vertex in `from` and NONE in `to`; a line, which only collinear
 * sites have, NONE in both. */
typedef struct voronoi_edge {
    vertex_id left, right;
    uint32_t from, to; /* vertices; NONE at infinity */
} voronoi_edge;

typedef struct voronoi {
    uint32_t points;   /* n: sites are numbered 0 .. n-1 */
    uint32_t cells;    /* u: distinct sites, each with its cell */
    uint32_t vertices; /* v */
    uint32_t edges;    /* e */

    /* Vertex i is the centre of a circle through the sites vertex_site[k], for
     * k from vertex_first[i] to vertex_first[i+1]-1: all sites that are on it,
     * counterclockwise, at least three. */
    uint32_t *vertex_first;
    vertex_id *vertex_site;

    voronoi_edge *edge;

    /* The cell of site p has the edges cell_edge[k], for k from cell_first[p]
     * to cell_first[p+1]-1, counterclockwise, from where a region begins.
     * Copies of an earlier site have none, nor has a single site. */
    uint32_t *cell_first;
    uint32_t *cell_edge;
} voronoi;

/* The Voronoi diagram, as the dual of a Delaunay triangulation.
 *
 * Requires: *m is a Delaunay triangulation of the points. Which one does not
 * matter: triangles with the same circle share a vertex, and the edge between
 * them vanishes.
 * Cost: O(n); one incircle test for each edge inside the hull.
 * TRI_OUT_OF_MEMORY: *out is zeroed.
 * Source: notes 3.1, Definition 6 and the dual. */
tri_status voronoi_dual(const mesh *m, const point2 *points, voronoi *out);

/* The same with a vertex for each triangle, in the order of mesh_triangles, and
 * an edge for each edge, of length 0 where two circles are the same. */
tri_status voronoi_per_triangle(const mesh *m, voronoi *out);

/* Frees the arrays and zeroes *d; a zeroed diagram is accepted. */
void voronoi_free(voronoi *d);

/* The site on the other side of edge k of p's cell. */
static inline vertex_id
voronoi_beyond(const voronoi *d, uint32_t k, vertex_id p)
{
    return d->edge[k].left == p ? d->edge[k].right : d->edge[k].left;
}

/* Is the cell of p bounded? */
bool voronoi_is_bounded(const voronoi *d, vertex_id p);

/* Is *d the Voronoi diagram of the points?
 *
 * It holds exactly when
 *   1. the sites of each vertex are cocircular, and fans of triangles over them
 *      make a triangulation;
 *   2. of two neighbouring vertices, the circle of each has no site of the
 *      other inside or on it, but for the two that they share;
 *   3. around each site the edges of its cell run from corner to corner of
 *      these polygons, each corner is met once, each edge has its two cells;
 *   4. of collinear sites, the edges are lines between neighbours on their line
 * (page 3.1, sec3.1.P11: that is enough). Refuted: the sites to look at.
 * Cost: O(n), and O(k^2) for each vertex of k sites; of collinear sites O(n log n).
 * TRI_OUT_OF_MEMORY: *out says nothing. */
tri_status is_voronoi(const point2 *points, uint32_t n, const voronoi *d,
                      verdict *out);

/* ---- Coordinates, rounded. ---- */

/* The centre of the circle through a, b and c: each coordinate is the exact
 * quotient rounded once, to the nearest double, ties to even.
 *
 * Requires: a, b, c are not collinear.
 * Cost: a few exact signs; a hundred if a coordinate is very large or small.
 * TRI_OUT_OF_RANGE: a coordinate exceeds the largest double; *out is zeroed. */
tri_status circumcentre(point2 a, point2 b, point2 c, point2 *out);

/* The coordinates of all vertices: at[0 .. vertices-1].
 * TRI_OUT_OF_RANGE: one of them has none; at[] says nothing. */
tri_status voronoi_vertices(const voronoi *d, const point2 *points, point2 *at);

/* The direction in which edge k runs: the vector from its left to its right
 * site, turned left by 90 degrees, each component rounded once; half of it if
 * that is more than the doubles hold. */
point2 voronoi_direction(const voronoi *d, const point2 *points, uint32_t k);

/* The point half way between the two sites of edge k, each coordinate rounded
 * once. The edge's line runs through it. */
point2 voronoi_midpoint(const voronoi *d, const point2 *points, uint32_t k);

/* ---- For pictures. ---- */

/* The part of edge k inside a box, rounded; false when there is none.
 * Requires: at[] holds the vertices' coordinates; min <= max. */
bool voronoi_edge_in_box(const voronoi *d, const point2 *points,
                         const point2 *at, uint32_t k, point2 min, point2 max,
                         point2 segment[2]);

/* What a convex polygon keeps inside H_pq, where p is at least as near as q.
 * Returns its size. Rounded; for pictures and areas.
 * Requires: room for size + 1 corners in out, which is another array. */
uint32_t cut_polygon(const point2 *polygon, uint32_t size, point2 p, point2 q,
                     point2 *out);

/* ---- The nearest site, and coordinates among neighbours. ---- */

/* A site that is nearest to x, by walking over the Delaunay triangulation *m:
 * from each site to the neighbour nearest to x, as long as one is nearer.
 *
 * Requires: m->locations > 0; start is a vertex of *m, or there is one only.
 * Cost: a comparison of distances for each neighbour of each site on the way.
 * *visited, if not NULL, counts the sites that have been compared, and start.
 * Source: notes 3.1, the post-office problem. */
vertex_id nearest_site(const mesh *m, const point2 *points, point2 x,
                       vertex_id start, uint32_t *visited);

/* The local coordinates of site p among the sites beyond the edges of its cell:
 * weights w, positive before rounding, with the sum 1, for which the sum of
 * w_q q is p. There are two such families:
 *
 *   laplace   w_q proportional to l_q / |pq|, with l_q the length of the edge
 *             that the cells of p and q share
 *   sibson    w_q proportional to the area that the cell of p takes from the
 *             cell that q would have without p
 *
 * weight[i] belongs to the site beyond the i-th edge of the cell. All rounded.
 * Requires: voronoi_is_bounded; room for as many weights as the cell has edges.
 * Cost: O(k), and O(k^3) for sibson, of a cell with k edges.
 * TRI_OUT_OF_RANGE if lengths or areas are; TRI_OUT_OF_MEMORY: no weights.
 * Source: Sibson (1980), named on the page of the notes' Figure 6. */
tri_status laplace_coordinates(const voronoi *d, const point2 *points,
                               vertex_id p, double *weight);
tri_status sibson_coordinates(const voronoi *d, const point2 *points,
                              vertex_id p, double *weight);

#endif
