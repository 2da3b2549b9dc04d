/* replay.h - flips that a program reports, done again in a list of triangles.
 *
 * A report is believed only when the list allows the flip; the result is then known
 * without believing anything.
 */
#ifndef TOOLS_CHECKS_REPLAY_H
#define TOOLS_CHECKS_REPLAY_H

#include "lib/triangles.h"
#include "tools/checks/plane.h"

#include <stdbool.h>

/* The two triangles abc and bad at an edge, as sides of the list. */
typedef struct quadrilateral {
    halfedge_id ab, ba;
    vertex_id a, b, c, d;
} quadrilateral;

/* The triangles at the edge between a and b. false: it is no edge, or on the hull. */
bool find_quadrilateral(triangle_list list, vertex_id a, vertex_id b,
                        quadrilateral *found);

/* Is it strictly convex, so that ab can be flipped? */
bool is_strictly_convex(const site *points, const quadrilateral *q);

/* abc and bad become dca and cdb, in place. */
void replay_flip(triangle_list list, const quadrilateral *q);

/* A copy, which the caller frees. */
triangle_list copy_triangles(triangle_list list);

/* A triangle of t that the other list does not have, in any order, turned in any way;
 * NONE: it has them all. If both are equally long, and those of t differ, they are the
 * same. */
triangle_id missing_triangle(triangle_list t, triangle_list in);

#endif
