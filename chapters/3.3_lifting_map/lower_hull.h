/* lower_hull.h - the Delaunay triangulation as the underside of a polytope.
 *
 * Notes: section 3.3, Figure 8. Needs: 2.1 (is_triangulation), 2.3 (the order
 * of the points, and the flat case), lifting.h, lib/mesh.h. Exercise: 3.3-b.
 */
#ifndef CHAPTERS_3_3_LOWER_HULL_H
#define CHAPTERS_3_3_LOWER_HULL_H

#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/verdict.h"

/* The convex hull, in space, of lifted sites: its surface as triangles, each
 * with three neighbours.
 *
 * A face a, b, c is ordered so that the polytope is on the -1 side of
 * orient3d_lifted(a, b, c, .) and the outside on the +1 side. So a lower face
 * is counterclockwise in the plane, an upper one clockwise, a vertical one
 * flat. Facets with more corners are there as several triangles of one plane.
 *
 * v lifted sites that do not lie in one plane make exactly 2v-4 faces. */
typedef struct lifted_hull {
    const point2 *points; /* the caller's; indices below are places in it */
    triangle_list faces;  /* none: the hull is flat */
    halfedge_id *twin;    /* side -> the same edge in the face next to it */
    bool *seen;           /* face -> does the new point see it? */
    halfedge_id *beyond;  /* vertex of the horizon -> the side leaving it whose
                           * face is not seen */
} lifted_hull;

/* The hull of three lifted sites: a triangle, whose two sides are its faces.
 * There is room for `locations` of the n points.
 *
 * Requires: a, b, c are distinct locations (lifted, no three are collinear).
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *H is zeroed.
 */
tri_status lifted_hull_start(lifted_hull *H, const point2 *points, uint32_t n,
                             uint32_t locations, vertex_id a, vertex_id b,
                             vertex_id c);

/* Adds the lifted p: the faces that it sees are replaced by faces at p.
 *
 * Requires: p's location is new; *H is not flat, or p is not in its plane;
 * room.
 * Cost: 1 orient3d_lifted for each face.
 * Source: notes 3.3 name no algorithm; incremental insertion, see the page.
 */
void lifted_hull_add(lifted_hull *H, vertex_id p);

/* The hull of all sites of L, which are `locations` distinct ones.
 *
 * Flat, that is without faces, when they are fewer than four, collinear or
 * cocircular (docs/errata.md, E26).
 * Cost: (u-2)(u-3) orient3d_lifted, and at most u-3 more, for u locations.
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *H is zeroed.
 */
tri_status lifted_hull_of(lifted_hull *H, const point2 *points, uint32_t n,
                          const vertex_id *L, uint32_t locations);

/* Frees the arrays and zeroes *H; a zeroed hull is accepted. */
void lifted_hull_free(lifted_hull *H);

/* The projections of the faces that are seen from below, and of those that are
 * seen from above, counterclockwise. A hull that is flat has none.
 * Cost: 1 orientation test for each face. TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status lower_faces(const lifted_hull *H, triangle_list *out);
tri_status upper_faces(const lifted_hull *H, triangle_list *out);

/* A Delaunay triangulation: the lower faces of the lifted sites, which are
 * added in the order of 2.3 along options->direction.
 * Nothing is reported to a trace. Statuses and conventions: lib/options.h.
 * Cost: O(n^2). Source: notes 3.3, below Proposition 1.
 */
tri_status lift_triangulate(const point2 *points, uint32_t n,
                            const tri_options *options, mesh *out);

/* Do the triangles, lifted, make the underside of the convex hull?
 *
 * Holds exactly when is_triangulation (2.1) does and across each edge ab of a
 * triangle abc the lifted apex of the neighbour lies in the plane of abc or
 * above it (page 3.3, lower.P6: that is enough).
 * Refuted: the four points a, b, c and the apex, or the witness of
 * is_triangulation.
 * Cost: O(n + triangles). TRI_OUT_OF_MEMORY: *out says nothing.
 */
tri_status is_lower_hull(const point2 *points, uint32_t n, triangle_list list,
                         verdict *out);

#endif
