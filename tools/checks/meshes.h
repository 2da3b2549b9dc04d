/* meshes.h - triangulations that a case brings along, made without any algorithm that a
 * student is to write: edges are drawn in random order, as long as they cross nothing.
 */
#ifndef TOOLS_CHECKS_MESHES_H
#define TOOLS_CHECKS_MESHES_H

#include "lib/random.h"
#include "lib/triangles.h"
#include "tools/checks/plane.h"

/* A random triangulation of the points, each location by its lowest index; a random
 * Delaunay triangulation if `delaunay`: ties are broken at random. Empty when the points
 * are collinear. The caller frees it.
 * Cost: O(n^3), Delaunay O(n^4): for at most about 60 points. */
triangle_list mesh_at_random(random_source *source, const site *points, uint32_t n,
                             bool delaunay);

/* The locations of collinear points by their lowest indices, from one end to the other.
 * Requires: room for n. Returns how many. */
uint32_t path_of(const site *points, uint32_t n, uint32_t *path);

#endif
