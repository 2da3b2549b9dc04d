/* point.h - points of the plane and of space, and how a point is named.
 *
 * Notes: section 2. Needs: nothing.
 *
 * The caller owns the points; everything else speaks of them by index. The
 * plain code of a chapter reads .x and .y only where the notes compute with
 * coordinates (3.1, 3.3, 3.4); everywhere else it asks predicates.h.
 */
#ifndef LIB_POINT_H
#define LIB_POINT_H

#include <stdint.h>

typedef struct point2 {
    double x, y;
} point2;

typedef struct point3 {
    double x, y, z;
} point3;

/* A vertex is a point, named by its place in the caller's array. */
typedef uint32_t vertex_id;

#endif
