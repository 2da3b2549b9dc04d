/* pair.h - what two threads are worth on this machine.
 *
 * Needs: tools/bench/bench.h.
 */
#ifndef TOOLS_BENCH_PAIR_H
#define TOOLS_BENCH_PAIR_H

#include "tools/bench/bench.h"

/* Two threads on one set of points, against two independent runs at the same
 * time, which is the most that the machine gives: prints a line PASS or FAIL.
 */
void compare_threads(const bench *b);

#endif
