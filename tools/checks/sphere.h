/* sphere.h - triangulations with the outside: splits and flips that a program reports,
 * done again.
 *
 * One more vertex, at infinity, is joined to both ends of each side that has no twin.
 * So a point that lies outside lies in a triangle, too, and a path has a triangle on
 * either side of each of its edges. A report is believed only where the geometry allows
 * it.
 */
#ifndef TOOLS_CHECKS_SPHERE_H
#define TOOLS_CHECKS_SPHERE_H

#include "lib/triangles.h"
#include "tools/checks/plane.h"

#include <stdbool.h>

typedef struct sphere {
    const site *at;
    vertex_id infinity; /* the number of the vertex there: n */
    triangle_list list; /* with those of the outside */
    bool flat;          /* all are outside: the vertices are a path */
} sphere;

/* The triangles of the list, or of the path if there are none, and the outside; with
 * room for `more` vertices. The caller frees sphere.list. */
sphere sphere_of(const site *at, uint32_t n, triangle_list list, const uint32_t *path,
                 uint32_t count, uint32_t more);

/* The side from a to b of the triangle abc; NONE: there is no such triangle. */
halfedge_id sphere_side(const sphere *s, vertex_id a, vertex_id b, vertex_id c);

/* How a point that is no vertex lies in a triangle. */
typedef enum spot {
    SPOT_NOWHERE,  /* it does not */
    SPOT_TRIANGLE, /* strictly inside; outside: it sees the side */
    SPOT_EDGE,     /* on one of its sides, between the ends */
    SPOT_BEYOND    /* in line with the path, beyond its end */
} spot;

/* How p lies in the triangle of side *e; then *e is the side on which it lies, or the
 * one that leaves the end of the path. */
spot sphere_spot(const sphere *s, uint32_t p, halfedge_id *e);

/* Joins p to the corners around its spot. Requires: room. */
void sphere_split(sphere *s, spot at, halfedge_id e, vertex_id p);

/* Flips the edge between a and b, which is opposite p, so that p gets one more edge.
 * false: it is not opposite p, or some triangle would be flat or turned over. */
bool sphere_flip(sphere *s, vertex_id a, vertex_id b, vertex_id p);

/* Does p lie in triangle t or on its sides; outside: does it see the side, or is it in
 * line with it? On a path: is it at that edge, or beyond the end of that edge? */
bool sphere_has(const sphere *s, triangle_id t, uint32_t p);

/* How many edges end at v, those to infinity included. */
uint32_t sphere_degree(const sphere *s, vertex_id v);

/* The triangles without the outside; the caller frees them. */
triangle_list sphere_triangles(const sphere *s);

#endif
