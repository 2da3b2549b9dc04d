/* divide.h - Delaunay triangulations by dividing the points and merging.
 *
 * Notes: section 3.7, which names the method and prints no algorithm (docs/errata.md,
 * E52): the page does. Needs: 2.3 (the order, and up to three points), 3.4, 3.5 (the
 * flip), lib/mesh.h. Exercises: 3.7-a to 3.7-c.
 */
#ifndef CHAPTERS_3_7_DIVIDE_H
#define CHAPTERS_3_7_DIVIDE_H

#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/random.h"
#include "lib/steps.h"

/* Two hull edges of different triangulations; speaks of the segment from the vertex
 * where `left` begins to the one where `right` begins. */
typedef struct hull_pair {
    halfedge_id left, right;
} hull_pair;

/* The segment below two triangulations: every vertex of both lies left of the line
 * from its left to its right end, or on the line but not between the two.
 *
 * Requires: along some direction every vertex on the left comes before every vertex
 * on the right, and `left` begins at the last on the left, `right` at the first
 * on the right.
 * Cost: at most 2h + 2 orientation tests, for h hull edges together.
 * Source: Lee and Schachter 1980.
 */
hull_pair lower_tangent(const mesh *m, const point2 *points, halfedge_id left,
                        halfedge_id right);

/* Makes one Delaunay triangulation of two.
 *
 * Requires: *m holds a Delaunay triangulation that has v and another that has w.
 * Along some direction all vertices of the first come before all of the second, v
 * is the last of the first and w the first of the second.
 * Cost: O(u) for u vertices together; an edge, then flips, among which are as many
 * as there are new triangles. No memory but two triangles.
 * Source: Lee and Schachter 1980; Guibas and Stolfi 1985.
 */
void merge(mesh *m, const point2 *points, vertex_id v, vertex_id w);

/* Puts that point at L[k] which would be there if the `count` distinct points were
 * sorted along d; the earlier ones come to stand before it, the later ones behind.
 *
 * Requires: k < count.
 * Cost: fewer than 4 count comparisons on average over the pivots, whatever the points.
 * Source: Hoare 1961 (FIND).
 */
void select_along(const point2 *points, vertex_id *L, uint32_t count, uint32_t k,
                  point2 d, random_source *random);

/* A Delaunay triangulation of the points, divided along options->direction, or as
 * options->cuts says along this direction and across it in turn.
 *
 * Of u locations that are divided together the triangles have consecutive numbers,
 * ghosts included, which depend on the locations before them only.
 * Statuses and conventions: lib/options.h. Cost: O(n log n).
 * Source: Lee and Schachter 1980; alternating cuts: Dwyer 1987.
 */
tri_status divide_triangulate(const point2 *points, uint32_t n,
                              const tri_options *options, mesh *out);

/* Which step of the merge is run in each step that can be watched. */
extern const figure_steps divide_steps;

#endif
