/* measure.h - one run of an algorithm or of another program, in a process of
 * its own.
 *
 * Needs: chapters/contents.h, tools/bench/certify.h, tools/bench/stopwatch.h.
 */
#ifndef TOOLS_BENCH_MEASURE_H
#define TOOLS_BENCH_MEASURE_H

#include "chapters/contents.h"
#include "tools/bench/certify.h"
#include "tools/bench/stopwatch.h"

typedef enum run_end {
    RUN_DONE,
    RUN_TOO_LONG, /* stopped at the limit */
    RUN_FAILED    /* any other end; standard error says which */
} run_end;

typedef struct run {
    run_end end;
    times times;   /* of the work alone; its result is there at the end */
    answer answer; /* if nobody has asked: right, and no text */
} run;

/* Runs the algorithm with these options, or the yardstick when it is NULL, on
 * the points, once or, when that is too short for the clock, until it is not.
 * The run is a child's, so that no run finds memory as an earlier one has left
 * it. The memory is counted without the points, with the mesh.
 *
 * Requires: seconds > 0; the limit is on processor time, in whole seconds, what
 * it takes to certify included. */
run measure(const algorithm *a, const tri_options *options,
            const point2 *points, uint32_t n, unsigned seconds, bool certify);

/* The same for a peer (tools/bench/peers/peer.h) on the points of a file. */
run measure_peer(const char *program, const char *points, unsigned seconds,
                 bool certify);

/* The same for a whole program, from its beginning to its end: bytes are not
 * known. The last of the arguments is followed by NULL; standard output and
 * error go to `said`. */
run measure_program(const char *const *arguments, const char *said,
                    unsigned seconds);

#endif
