/* stopwatch.h - how long does a piece of work take, and how much memory does it
 * hold?
 *
 * Needs: nothing. For C++ too: the peers use it.
 *
 *     stopwatch w = stopwatch_start(0.2, SIZE_MAX);
 *     do {
 *         the work
 *     } while (stopwatch_again(&w));
 *     times t = stopwatch_stop(&w);
 */
#ifndef TOOLS_BENCH_STOPWATCH_H
#define TOOLS_BENCH_STOPWATCH_H

#include <stdbool.h>
#include <stddef.h>

typedef struct times {
    double user; /* seconds of processor time spent in the program itself; if
                  * all rounds are shorter than 0.15 s, the same as processor */
    double processor; /* the same and the system's share, page faults mostly */
    double wall;      /* seconds on the wall */
    double bytes;     /* the most memory that was added; negative: not known */
} times;

typedef struct stopwatch {
    double least;  /* seconds that the rounds should take together */
    size_t rounds; /* done so far */
    size_t most;   /* and how many there can be */
    times start;   /* bytes: what was held then */
} stopwatch;

/* Starts a first round. There will be more until they have taken `least`
 * seconds: some clocks of processor time tick every hundredth of a second.
 * Requires: most > 0. */
stopwatch stopwatch_start(double least, size_t most);

/* One more round has been done; shall there be another one? */
bool stopwatch_again(stopwatch *w);

/* The mean of the rounds; of the bytes, the most. */
times stopwatch_stop(const stopwatch *w);

/* How long the rounds should take together for n points: the small sizes are
 * many, and serve to see the growth. */
double stopwatch_least(size_t n);

/* So many copies of n points are enough for a sort to take that long, at 20 ns
 * a point at the least; a larger input is sorted once. */
size_t stopwatch_copies(size_t n);

#endif
