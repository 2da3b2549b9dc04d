/* certify.h - what is enough to check: an answer is proved right, whatever it is.
 *
 * Points have small integer coordinates (plane.h), so that all signs are exact. Each
 * answer is a verdict with the points to look at. Nothing here computes a
 * triangulation, a hull or a tree: it says whether somebody else's is one.
 */
#ifndef TOOLS_CHECKS_CERTIFY_H
#define TOOLS_CHECKS_CERTIFY_H

#include "lib/triangles.h"
#include "lib/verdict.h"
#include "tools/checks/plane.h"

/* Is the list a triangulation of the points: are all triangles counterclockwise, each
 * directed side there at most once, each location a corner by one of its indices, and
 * do the sides without a twin make one convex cycle? (For collinear points: is it
 * empty?)
 *
 * Enough, because twins cancel: the number of triangles over a point is the winding
 * number of that cycle, which is 1 inside and 0 outside. */
verdict certify_triangulation(const site *points, uint32_t n, triangle_list list);

/* The same, and across no side lies a point strictly inside the circle. Enough by
 * Theorem 3. Ties are no concern: on the circle is not inside. */
verdict certify_delaunay(const site *points, uint32_t n, triangle_list list);

/* The twin of each side of a certified list, or NONE: the side of the triangle on its
 * other side. Requires: room for 3 * count entries. */
void certify_twins(triangle_list list, halfedge_id *twin);

/* Is this the convex hull, counterclockwise, with the points inside its edges: do the
 * vertices turn nowhere right, once around, and does no point lie outside? For
 * collinear points: every location once, from one end to the other. */
verdict certify_hull(const site *points, uint32_t n, const vertex_id *hull,
                     uint32_t count);

#endif
