/* measure.h - one run of an algorithm, in a process of its own.
 *
 * Needs: chapters/contents.h.
 */
#ifndef TOOLS_BENCH_MEASURE_H
#define TOOLS_BENCH_MEASURE_H

#include "chapters/contents.h"

typedef enum run_end {
    RUN_DONE,
    RUN_TOO_LONG, /* stopped at the limit */
    RUN_FAILED    /* any other end; standard error says which */
} run_end;

typedef struct run {
    run_end end;
    double seconds; /* of processor time, user and system, for the call alone */
    double bytes;   /* the most memory it has held; negative when not known */
} run;

/* Runs the algorithm, or the yardstick when it is NULL, on copies of the points, once
 * or, when that is too short for the clock, until it is not; the mean of these.
 * The run is a child's, so that no run finds memory as an earlier one has left it.
 * Its memory is counted without the points, with the mesh.
 *
 * Requires: seconds > 0; the limit is on processor time, in whole seconds. */
run measure(const algorithm *a, const point2 *points, uint32_t n,
            unsigned seconds);

#endif
