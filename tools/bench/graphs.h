/* graphs.h - what the graphs of 3.2 cost beyond the triangulation they lie in.
 *
 * Needs: tools/bench/bench.h.
 */
#ifndef TOOLS_BENCH_GRAPHS_H
#define TOOLS_BENCH_GRAPHS_H

#include "tools/bench/bench.h"

enum { GRAPHS = 4 };

extern const char *const graph_name[GRAPHS]; /* as `tri` calls them */

/* How many times as long as sorting n points of the distribution each graph takes,
 * when the triangulation is there: the least of three runs of each, in turns.
 * False: a run has failed. */
bool measure_graphs(const bench *b, const distribution *d, uint32_t n,
                    double times_sorting[GRAPHS]);

#endif
