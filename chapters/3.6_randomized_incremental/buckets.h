/* buckets.h - each triangle keeps the points that wait in it.
 *
 * Notes: section 3.6.4. Needs: waiting.h. Exercise: 3.6-e.
 */
#ifndef CHAPTERS_3_6_BUCKETS_H
#define CHAPTERS_3_6_BUCKETS_H

#include "chapters/3.6_randomized_incremental/waiting.h"

typedef struct buckets {
    mesh *m;
    const point2 *points;
    vertex_id o;
    vertex_id *first;  /* triangle -> a point that waits in it, or NONE */
    vertex_id *next;   /* waiting point -> the next in its triangle, or NONE */
    triangle_id *home; /* waiting point -> its triangle */
} buckets;

/* All points but the two of the first edge wait, on one side of it or the other.
 * Requires: *m is that edge, from order[0] to order[1].
 * TRI_OUT_OF_MEMORY: *b is zeroed. */
tri_status buckets_init(buckets *b, mesh *m, const point2 *points,
                        const vertex_id *order);

/* Frees the arrays and zeroes *b; a zeroed struct is accepted. */
void buckets_free(buckets *b);

/* The triangle in which p waits. */
triangle_id buckets_find(const buckets *b, vertex_id p);

/* The triangles left and right of e have taken the place of others: shares out
 * among the two what waits under their numbers. Vertices wait no more.
 *
 * Cost: 1 orientation test for each point that waits there, or 2 if it is in line
 * with a ray to infinity. An observer sees TRACE_MOVE for each.
 */
void buckets_share(buckets *b, halfedge_id e);

/* The same for the three triangles around the vertex that e leaves. */
void buckets_share_three(buckets *b, halfedge_id e);

#endif
