/* options.h - what can be asked of an algorithm, and what all of them refuse.
 *
 * Needs: lib/point.h, lib/status.h, lib/trace.h.
 *
 * Every algorithm has one shape:
 *
 *     tri_status X_triangulate(const point2 *points, uint32_t n,
 *                              const tri_options *options, mesh *out);
 *
 * NULL for the options means the defaults. Of duplicate points the one with the
 * lowest index is the vertex; the others stay unused. Collinear points are no
 * error: zero triangles, and the path along the line. On any status but TRI_OK
 * *out is zeroed and nothing is leaked.
 */
#ifndef LIB_OPTIONS_H
#define LIB_OPTIONS_H

#include "lib/point.h"
#include "lib/status.h"
#include "lib/trace.h"

#include <stddef.h>

/* 3.7: how points are divided that lie in order along the direction. */
typedef enum tri_cuts {
    TRI_CUTS_VERTICAL,   /* always across the direction */
    TRI_CUTS_ALTERNATING /* across it and along it in turn */
} tri_cuts;

/* 3.6: how the triangle is found that contains the next point. */
typedef enum tri_locator {
    TRI_LOCATOR_WALK,    /* by a straight walk from the point before */
    TRI_LOCATOR_BUCKETS, /* each triangle keeps the points that wait in it */
    TRI_LOCATOR_HISTORY, /* through all triangles that have been there */
    TRI_LOCATOR_GRID     /* by a walk from a vertex that a grid finds near by */
} tri_locator;

typedef struct tri_options {
    size_t size;            /* sizeof (tri_options): tells versions apart */
    point2 direction;       /* 2.3, 3.7: the order of the points; default (1,0) */
    struct trace *trace;    /* who watches; default NULL, nobody */
    tri_cuts cuts;          /* 3.7; default TRI_CUTS_VERTICAL */
    const vertex_id *order; /* 3.6: each index once; default NULL, at random */
    uint64_t seed;          /* 3.6: names the random order; default 0 */
    tri_locator locator;    /* 3.6; default TRI_LOCATOR_BUCKETS */
    uint32_t threads;       /* 3.7, faster: how many work at once; default 1 */
} tri_options;

/* The defaults, with their size filled in. */
tri_options tri_options_default(void);

/* What every algorithm does first: may it run on these points?
 *
 *   TRI_OK                  yes; *used holds the options to use
 *   TRI_BAD_OPTION          another version's size, a direction that is zero or not
 *                           finite, cuts or a locator that are none of the above,
 *                           no thread
 *   TRI_BAD_FP_ENVIRONMENT  rounding is not to nearest, or subnormals are flushed
 *   TRI_NOT_FINITE          some coordinate is NaN or infinite
 *
 * Cost: reads every point once. */
tri_status tri_accept(const point2 *points, uint32_t n, const tri_options *given,
                      tri_options *used);

#endif
