/* mesh_build.h - a mesh from triangles, or from a path, that are known already.
 *
 * Needs: lib/mesh.h.
 *
 * For algorithms that find all triangles at once (3.2, 3.3) and for triangles
 * read from a file. What they triangulate is their business: nothing here asks
 * a predicate.
 */
#ifndef LIB_MESH_BUILD_H
#define LIB_MESH_BUILD_H

#include "lib/mesh.h"

/* The mesh over n points of these triangles: side e of the list becomes
 * half-edge e; the outside follows.
 *
 * Requires: at least one triangle; they triangulate their vertices
 * (is_triangulation, 2.1, tells whether a list does).
 * Cost: O(n + triangles).
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *out is zeroed.
 */
tri_status mesh_from_triangles(uint32_t n, triangle_list list, mesh *out);

/* The mesh over n points, all of them on one line, that runs along path[0],
 * path[1], ..., path[count-1]; for fewer than two there are no edges.
 *
 * Requires: these are the distinct locations in their order on the line.
 * Cost: O(n). TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *out is zeroed.
 */
tri_status mesh_from_path(uint32_t n, const vertex_id *path, uint32_t count,
                          mesh *out);

#endif
