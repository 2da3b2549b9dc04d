/* see.h - what the observer writes about each event; for tracer.c and see_*.c.
 *
 * Needs: tracer.h. `see_...` belongs to an event that has just happened; `write_...` to
 * a step of which the observer knows only later that it is over.
 */
#ifndef TOOLS_TRI_SEE_H
#define TOOLS_TRI_SEE_H

#include "tools/tri/tracer.h"

/* 2.3: see_hull.c */
void see_start(tracer *w, vertex_id a, vertex_id b);
void see_attach(tracer *w, const mesh *m, vertex_id p);

/* 3.5 and 3.6, the stack: see_stack.c */
void see_push(tracer *w, const mesh *m, halfedge_id ab);
void write_pushes(tracer *w);
void see_pop(tracer *w, const mesh *m, halfedge_id e);
void write_keep(tracer *w);
void see_flip(tracer *w, const mesh *m, halfedge_id dc);

/* 3.6, the place of a point: see_place.c */
void see_visit(tracer *w, const mesh *m, halfedge_id e);
void see_locate(tracer *w, const mesh *m, halfedge_id ab, vertex_id p);
void see_split(tracer *w, const mesh *m, vertex_id p);
void see_move(tracer *w, const mesh *m, halfedge_id e, vertex_id q);
void write_moves(tracer *w);

/* 3.7, the merge: see_hull.c */
void see_bridge(tracer *w, vertex_id l, vertex_id r);
void see_drop(tracer *w, vertex_id a, vertex_id b, vertex_id c);
void see_rise(tracer *w, const mesh *m, halfedge_id rl);
void write_top(tracer *w);

/* ---- What many steps say and show: tracer.c ---- */

/* "9 lies inside the circle of 3, 7, 2", or whatever is so. */
void say_where(tracer *w, const vertex_id circle[3], vertex_id p);

void show_circle(step *s, const vertex_id circle[3], vertex_id p);

/* The corners of the triangle of e; or of the hull edge, and NONE, on whose outer side
 * it lies. */
void corners_of(const mesh *m, halfedge_id e, vertex_id corner[3]);

void show_corners(step *s, const vertex_id corner[3]);

/* The new vertex p and its edges: "join 9 to 1, 2 and 5". */
void join(step *s, const mesh *m, vertex_id p);

#endif
