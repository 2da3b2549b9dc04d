/* hard.h - inputs of which one might be afraid: copies, lines, extreme
 * coordinates.
 *
 * Needs: tools/bench/bench.h.
 */
#ifndef TOOLS_BENCH_HARD_H
#define TOOLS_BENCH_HARD_H

#include "tools/bench/bench.h"

extern const distribution hard_inputs[]; /* ended by a row without a name */

enum { HARD_INPUTS = 8 }; /* uniform points, and the seven */

/* Questions asked, and of those that the filter did not answer, who did
 * (predicates.h); doubles, since they are divided. */
typedef struct tier_counts {
    double orient2d, incircle, others, signs, expansions, wide, zeros;
} tier_counts;

typedef struct hard_result {
    const distribution *input;
    run_end end;    /* RUN_FAILED when the answer was wrong, too */
    double seconds; /* user time, the least of three */
    bool counted;
    tier_counts tiers;
} hard_result;

/* Runs the subject on n points of each, in turns; result[0] is for uniform
 * points. Requires: room for HARD_INPUTS results. */
void measure_hard(const bench *b, uint32_t n, hard_result *result);

void print_hard(const hard_result *result, uint32_t n);

#endif
