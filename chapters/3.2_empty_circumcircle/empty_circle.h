/* empty_circle.h - Delaunay simplices by definition, and all of them together.
 *
 * Notes: section 3.2, Definitions 7 and 8, 3.2.1. Needs: 2.3 (the distinct
 * sites in order), 3.4, lib/mesh_build.h. Exercise: 3.2-a.
 *
 * A circle encloses the points strictly inside it. So cocircular sites with
 * nothing inside their circle form Delaunay triangles three by three, and these
 * overlap.
 */
#ifndef CHAPTERS_3_2_EMPTY_CIRCLE_H
#define CHAPTERS_3_2_EMPTY_CIRCLE_H

#include "lib/mesh.h"
#include "lib/options.h"

/* ---- Definition 7, executed. ---- */

/* Does the circle through a, b, c enclose no site?
 *
 * Requires: a, b, c are in counterclockwise order.
 * Cost: at most n incircle tests. Source: notes 3.2, Definition 7. */
bool has_empty_circle(const point2 *points, uint32_t n, vertex_id a,
                      vertex_id b, vertex_id c);

/* Does some circle through a and b enclose no site? An edge has infinitely many
 * circumcircles; one pass over the sites finds out whether one of them is
 * empty.
 *
 * Requires: a and b are different locations.
 * Cost: 2n orientation tests, at most 2n incircle tests.
 * Source: notes 3.2, Definition 7. */
bool is_delaunay_edge(const point2 *points, uint32_t n, vertex_id a,
                      vertex_id b);

/* The trivial algorithm: all Delaunay triangles, each once, counterclockwise.
 *
 * Exactly Definition 7. With cocircular sites they overlap, and are no
 * triangulation: docs/errata.md, E22. Of sites at one location the lowest index
 * is the vertex.
 * Cost: O(n^4).
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS (too many triangles): *out is zeroed.
 * Source: notes 3.2.1.
 */
tri_status delaunay_triangles(const point2 *points, uint32_t n,
                              triangle_list *out);

/* A Delaunay triangulation: of the triangles above, those that make a fan at
 * the lowest index on their circle. Statuses and conventions: lib/options.h;
 * there is nothing for an observer to see. Cost: O(n^4). */
tri_status brute_triangulate(const point2 *points, uint32_t n,
                             const tri_options *options, mesh *out);

/* ---- The Delaunay subdivision. ---- */

/* The Delaunay subdivision: convex polygons, the cells, each with all of its
 * corners on one empty circle. Cell i has the corners vertex[first[i] ..
 * first[i+1]-1], counterclockwise, the lowest index first. Cells are in the
 * order of their first corners; those with the same one follow each other
 * counterclockwise around it, beginning at the lowest second corner. So equal
 * subdivisions have equal arrays. */
typedef struct subdivision {
    uint32_t cells;
    uint32_t *first;
    vertex_id *vertex;
} subdivision;

/* The Delaunay subdivision, from any Delaunay triangulation: triangles with the
 * same circle become one cell. Collinear sites have no cells.
 *
 * Requires: *m is a Delaunay triangulation of the points.
 * Cost: O(n); one incircle test for each edge inside the hull.
 * TRI_OUT_OF_MEMORY: *out is zeroed.
 * Source: notes 3.2, below Definition 8; docs/errata.md, E21.
 */
tri_status delaunay_subdivision(const mesh *m, const point2 *points,
                                subdivision *out);

/* Have the two the same cells? Requires: neither is zeroed. Cost: O(n). */
bool subdivisions_are_equal(const subdivision *s, const subdivision *t);

/* Frees the arrays and zeroes *s; a zeroed subdivision is accepted. */
void subdivision_free(subdivision *s);

#endif
