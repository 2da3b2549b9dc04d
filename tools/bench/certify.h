/* certify.h - is the answer right? Asked of every algorithm and peer, off the
 * clock.
 *
 * Needs: lib/triangles.h.
 */
#ifndef TOOLS_BENCH_CERTIFY_H
#define TOOLS_BENCH_CERTIFY_H

#include "lib/triangles.h"

#include <stdbool.h>

enum { ANSWER_ROOM = 100 };

/* What is to be said of the triangles of n points: "Delaunay", "triangulation",
 * or why they are none (or, if `delaunay`, why they are not Delaunay). Never
 * empty, one line. */
typedef struct answer {
    bool right;
    char text[ANSWER_ROOM];
} answer;

answer certify_triangles(const point2 *points, uint32_t n, triangle_list list,
                         bool delaunay);

/* "sorted", or where the points are not, by x and equal ones by y. */
answer certify_sorted(const point2 *points, uint32_t n);

#endif
