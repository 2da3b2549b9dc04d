/* locator.h - line 3 of Figure 12, in one of four ways.
 *
 * Notes: section 3.6.4; the grid: 3.7. Needs: walk.h, buckets.h, history.h,
 * bucket_grid.h.
 */
#ifndef CHAPTERS_3_6_LOCATOR_H
#define CHAPTERS_3_6_LOCATOR_H

#include "chapters/3.6_randomized_incremental/bucket_grid.h"
#include "chapters/3.6_randomized_incremental/buckets.h"
#include "chapters/3.6_randomized_incremental/history.h"
#include "chapters/3.6_randomized_incremental/walk.h"
#include "lib/options.h"

typedef struct locator {
    tri_locator kind;
    mesh *m;
    const point2 *points;
    vertex_id last;    /* walk: the vertex to begin at, the one found last */
    buckets waiting;   /* zeroed for the other kinds */
    history past;      /* zeroed for the other kinds */
    bucket_grid near;  /* zeroed for the other kinds */
    tri_status status; /* has memory run out? Then locate must not be called */
} locator;

/* Requires: *m is the edge from order[0] to order[1]; order has m->locations
 * entries, all different. TRI_OUT_OF_MEMORY: *T is zeroed but for its status. */
tri_status locator_init(locator *T, tri_locator kind, mesh *m, const point2 *points,
                        const vertex_id *order);

/* Frees the arrays and zeroes *T; a zeroed struct is accepted. */
void locator_free(locator *T);

/* The place of the point p, which is no vertex yet. An observer sees TRACE_LOCATE. */
place locate(locator *T, vertex_id p);

/* Tells the locator that p has been put at its place `at`, and not flipped yet. */
void locator_split(locator *T, place at, vertex_id p);

/* Tells the locator that e is a new edge, by a flip. */
void locator_flip(locator *T, halfedge_id e);

#endif
