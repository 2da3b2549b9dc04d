/* walk.h - where in the triangulation does a point lie? By walking there.
 *
 * Notes: section 3.6.4. Needs: 3.4, lib/mesh.h. Exercise: 3.6-b.
 */
#ifndef CHAPTERS_3_6_WALK_H
#define CHAPTERS_3_6_WALK_H

#include "lib/mesh.h"

/* The three ways in which a point that is no vertex can lie in a triangulation. */
typedef enum place_kind {
    PLACE_TRIANGLE, /* in the triangle of e; if that is a ghost, seeing its edge */
    PLACE_EDGE,     /* on edge e, between its ends */
    PLACE_BEYOND    /* in line with a path, beyond its end where hull edge e begins */
} place_kind;

typedef struct place {
    place_kind kind;
    halfedge_id e;
} place;

/* The place of p, found by a straight walk from vertex v: through the triangles
 * that the segment from v to p meets, each of them once.
 *
 * Requires: v is a vertex and has an edge; p is no vertex.
 * Cost: at most 2 orientation tests for each triangle at v, 2 for each triangle that
 * the walk comes through, and 3 in the last one; where it runs along the hull, 3 for
 * each triangle at a vertex on the way. An observer sees TRACE_VISIT for each triangle
 * that it comes through.
 * Source: notes 3.6.4; Devillers, Pion and Teillaud 2002.
 */
place straight_walk(mesh *m, const point2 *points, vertex_id v, point2 p);

/* The place of p in the triangle of e, or on its sides.
 * Requires: no corner is at infinity; p lies in the triangle and is no corner. */
place place_in_triangle(const mesh *m, const point2 *points, halfedge_id e, point2 p);

/* Does p lie strictly right of e? If e is a hull edge, p sees it then (2.3). */
bool lies_beyond(const mesh *m, const point2 *points, halfedge_id e, point2 p);

/* The hull edge on whose outer side the triangle of e lies.
 * Requires: it is a ghost triangle. */
halfedge_id hull_edge_of(const mesh *m, halfedge_id e);

/* Are p and q on the same side of s, all three being on one line? */
bool is_same_side(point2 s, point2 p, point2 q);

#endif
