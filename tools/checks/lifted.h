/* lifted.h - (f) of what is enough to check: the convex hull of the lifted points. */
#ifndef TOOLS_CHECKS_LIFTED_H
#define TOOLS_CHECKS_LIFTED_H

#include "lib/triangles.h"
#include "lib/verdict.h"
#include "tools/checks/plane.h"

/* Are these the faces of the hull of the points (x, y, x^2 + y^2), each location by one
 * index, counterclockwise as seen from outside; none if all are in one plane? So
 *
 *   - there are 2v - 4 of them, for v locations
 *   - no lifted point is outside of the plane of any
 *   - each side joins two locations, is there once, and once the other way
 *
 * Enough: no three lifted points are on a line, so that each face has an area. They lie
 * on the hull, are turned outwards, and have no boundary: so they cover each place of
 * it equally often. As all lifted points are corners of the hull, to cover it once
 * takes 2v - 4 triangles, by Euler's formula. Then those that are seen from below are a
 * Delaunay triangulation (page 3.3, prop1.P2). */
verdict certify_lifted_hull(const site *points, uint32_t n, triangle_list faces);

/* Are they as many as there should be? */
verdict certify_lifted_count(const site *points, uint32_t n, triangle_list faces);

#endif
