/* fast_order.h - dividing: where to cut; no program includes it.
 *
 * Notes: section 3.7. Needs: fast_parts.h.
 */
#ifndef CHAPTERS_3_7_FAST_ORDER_H
#define CHAPTERS_3_7_FAST_ORDER_H

#include "chapters/3.7_divide_and_conquer/fast_grid.h"
#include "lib/random.h"

/* Up to how many sites make a part of a worker's (job), and one that is sorted instead of
 * divided by cells (few). */
typedef struct fast_limits {
    uint32_t few, job;
} fast_limits;

fast_limits fast_limits_for(uint32_t n);

/* fast_divide_triangulate with other limits: with low ones the whole of it runs on few
 * points. For tests. */
tri_status fast_divide_with(const point2 *points, uint32_t n, fast_limits limits,
                            mesh *out);

/* A part to be triangulated, or a cut: the last two parts are merged. */
typedef struct fast_step {
    fast_site *from; /* NULL: a cut */
    uint32_t lo, count;
    int axis; /* of a cut */
    uint32_t duplicates;
    fast_part part;
    fast_pool pool;
} fast_step;

/* What is to be done, in postfix order: each cut comes behind its parts. */
typedef struct fast_plan {
    fast_step *step;
    uint32_t size, room;
} fast_plan;

/* Who divides. */
typedef struct fast_worker {
    fast_run *run;
    fast_pool pool;
    fast_site *spare;   /* as many sites as run->site, for sorting to and fro */
    uint32_t few;       /* parts with so many sites are not divided by cells */
    uint32_t duplicates; /* points that share the location of another one */
    random_source random;
    fast_plan *plan;    /* not NULL: nothing is triangulated yet, only written down */
    tri_status status;
} fast_worker;

/* Triangulates the sites from[0 .. count-1], which become numbers lo .. lo+count-1 in
 * some order; duplicates leave gaps behind the others. The box is the smallest around
 * them. */
fast_part fast_divide(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count,
                      fast_box box);

/* Merges two parts, the first before the second along the axis. */
fast_part fast_cut(fast_run *run, fast_pool *pool, int axis, fast_part a, fast_part b);

#endif
