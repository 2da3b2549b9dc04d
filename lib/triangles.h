/* triangles.h - a list of triangles: what files, checks and other programs speak of.
 *
 * Needs: lib/point.h, lib/status.h.
 *
 * A list claims nothing; is_triangulation (2.1) says whether it triangulates
 * anything. Side i of triangle t runs from corner i to corner i+1 and has the
 * number 3t+i, like the half-edges of a mesh.
 */
#ifndef LIB_TRIANGLES_H
#define LIB_TRIANGLES_H

#include "lib/point.h"
#include "lib/status.h"

typedef uint32_t triangle_id;
typedef uint32_t halfedge_id; /* 3t, 3t+1 and 3t+2 are the sides of triangle t */

#define NONE UINT32_MAX /* no half-edge, no triangle */

typedef struct triangle_list {
    uint32_t count;
    vertex_id (*corner)[3]; /* triangle -> its corners, counterclockwise */
} triangle_list;

/* Frees the array and zeroes *list; a zeroed list is accepted. */
void triangle_list_free(triangle_list *list);

/* The vertex that side e leaves. The next side is 3t + (i+1) mod 3. */
static inline vertex_id
side_origin(triangle_list list, halfedge_id e)
{
    return list.corner[e / 3][e % 3];
}

/* The vertex that side e enters. */
static inline vertex_id
side_dest(triangle_list list, halfedge_id e)
{
    return list.corner[e / 3][(e + 1) % 3];
}

/* The corner of e's triangle that is not on e. */
static inline vertex_id
side_apex(triangle_list list, halfedge_id e)
{
    return list.corner[e / 3][(e + 2) % 3];
}

/* Which sides run along the same edge in opposite directions?
 *
 * twin[e] is that other side, or NONE. If two sides run along the same edge in the
 * same direction, *repeated is the second of such a pair, else it is NONE.
 * Requires: room for 3 * count entries in twin. Cost: O(count).
 * TRI_OUT_OF_MEMORY; TRI_TOO_MANY_POINTS when 3 * count does not fit: no result.
 */
tri_status triangle_list_twins(triangle_list list, halfedge_id *twin,
                               halfedge_id *repeated);

#endif
