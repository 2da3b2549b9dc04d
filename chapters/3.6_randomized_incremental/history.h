/* history.h - the history graph: all triangles that have ever been there.
 *
 * Notes: section 3.6.4, which names it. Needs: waiting.h.
 *
 * A triangle that is destroyed gets arrows to those that have taken its place. A
 * point that has waited in a bucket would have gone along these arrows, one by
 * one; here it goes when its turn has come, and asks the same questions.
 */
#ifndef CHAPTERS_3_6_HISTORY_H
#define CHAPTERS_3_6_HISTORY_H

#include "chapters/3.6_randomized_incremental/waiting.h"

/* A triangle of some time. */
typedef struct history_node {
    uint32_t children; /* 0: it is there today; 2 or 3: they have taken its place */
    uint32_t child[3]; /* nodes; if none, child[0] is its number in the mesh */
    vertex_id at;      /* the corner that the children have in common */
    vertex_id ray[3];  /* 3 children: as in goes_between; 2: w and right of goes_left */
} history_node;

typedef struct history {
    mesh *m;
    const point2 *points;
    vertex_id o;
    history_node *node; /* node[0 .. count-1]; node 0 is the whole plane */
    uint32_t count, room;
    uint32_t *today; /* triangle -> its node, NONE if it is newer than the graph */
} history;

/* The whole plane and the two sides of the first edge.
 * Requires: *m is that edge, from order[0] to order[1].
 * TRI_OUT_OF_MEMORY: *h is zeroed. */
tri_status history_init(history *h, mesh *m, const point2 *points,
                        const vertex_id *order);

/* Frees the arrays and zeroes *h; a zeroed struct is accepted. */
void history_free(history *h);

/* The triangle of today in which q lies.
 * Cost: a node for each time that the buckets would have moved q, and one more;
 * at most 3 orientation tests for each. An observer sees TRACE_VISIT for each. */
triangle_id history_find(const history *h, vertex_id q);

/* The triangles left and right of e have taken the place of those that had their
 * numbers. TRI_OUT_OF_MEMORY: nothing has changed. Cost: O(1) on average. */
tri_status history_share(history *h, halfedge_id e);

/* The same for the three triangles around the vertex that e leaves. */
tri_status history_share_three(history *h, halfedge_id e);

#endif
