/* meshes.h - triangulations that a case brings along, made without any algorithm that a
 * student is to write: edges are drawn in random order, as long as they cross nothing.
 */
#ifndef TOOLS_CHECKS_MESHES_H
#define TOOLS_CHECKS_MESHES_H

#include "lib/random.h"
#include "lib/triangles.h"
#include "tools/checks/plane.h"

/* A random triangulation of the points, each location by its lowest index; a random
 * Delaunay triangulation if `delaunay`: ties are broken at random. Empty when the
 * points are collinear. The caller frees it. Cost: O(n^3), Delaunay O(n^4): for at most
 * about 60 points. */
triangle_list mesh_at_random(random_source *source, const site *points, uint32_t n,
                             bool delaunay);

/* The locations of collinear points by their lowest indices, from one end to the other.
 * Requires: room for n. Returns how many. */
uint32_t path_of(const site *points, uint32_t n, uint32_t *path);

/* A random triangulation of some of the points; if they are collinear, their path. */
typedef struct piece {
    triangle_list list;
    uint32_t *path, length;
} piece;

/* Of the points with the indices part[0 .. count-1]; as above. The caller frees
 * both. */
piece piece_at_random(random_source *source, const site *points, const uint32_t *part,
                      uint32_t count, bool delaunay);

#endif
