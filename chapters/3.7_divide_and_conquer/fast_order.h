/* fast_order.h - dividing: where to cut; no program includes it.
 *
 * Notes: section 3.7. Needs: fast_parts.h.
 */
#ifndef CHAPTERS_3_7_FAST_ORDER_H
#define CHAPTERS_3_7_FAST_ORDER_H

#include "chapters/3.7_divide_and_conquer/fast_grid.h"
#include "chapters/3.7_divide_and_conquer/fast_share.h"
#include "lib/random.h"

/* Up to how many sites are a part for one thread (job), and are sorted instead of
 * divided by cells (few). The number of threads changes nothing but the time. */
typedef struct fast_limits {
    uint32_t few, job, threads;
} fast_limits;

fast_limits fast_limits_for(uint32_t n, uint32_t threads);

/* fast_divide_triangulate with other limits: with low ones the whole of it runs on few
 * points. For tests. */
tri_status fast_divide_with(const point2 *points, uint32_t n, fast_limits limits,
                            mesh *out);

/* A part to be triangulated, or a cut: two parts are merged. Then what came of it. */
typedef struct fast_step {
    fast_site *from;    /* a part: its sites; NULL: a cut */
    uint32_t lo, count; /* of a part: see fast_divide */
    int axis;           /* of a cut: the first part comes before the second along it */
    uint32_t begin;     /* the first step that belongs to this one; see below */
    uint32_t cut;       /* the step that needs this one; NONE: the last step */
    fast_count ready;   /* of a cut: how many of its parts */
    uint32_t duplicates; /* points whose location has another vertex */
    fast_part part;
    fast_pool pool;
} fast_step;

/* What is to be done, in postfix order: before a cut stand all steps of its first part,
 * then all of its second. */
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
    uint32_t duplicates; /* so far; see fast_step */
    random_source random;
    fast_plan *plan;    /* not NULL: nothing is triangulated yet, only written down */
    uint32_t threads;   /* of the planner */
    tri_status status;
} fast_worker;

/* Triangulates the sites from[0 .. count-1], which become numbers lo .. lo+count-1 in
 * some order; duplicates leave gaps behind the others. The box is the smallest around
 * them. */
fast_part fast_divide(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count,
                      fast_box box);

/* Divides all n sites until parts are small enough for one thread, and writes down what
 * is to be done. TRI_OUT_OF_MEMORY: the caller frees plan->step, as always. */
tri_status fast_make_plan(fast_plan *plan, fast_run *run, fast_site *spare, uint32_t n,
                          fast_limits limits, fast_box box);

/* Merges two parts, the first before the second along the axis. */
fast_part fast_cut(const fast_run *run, fast_pool *pool, int axis, fast_part a,
                   fast_part b);

#endif
