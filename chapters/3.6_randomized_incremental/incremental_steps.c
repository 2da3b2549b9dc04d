/* incremental_steps.c - Figure 12, for those who watch it step by step. */
#include "chapters/3.6_randomized_incremental/incremental.h"

/* Points that wait and move are in no line: line 3 is prepared while lines 4 and 6
 * are run. */
const figure_steps incremental_steps = {
    .figure = "Figure 12",
    .lines = {
        {"Line 1", "begin with a triangle xyz around all (here: with an edge)"},
        {"Line 2", "for each point p"},
        {"Line 3", "  find the triangle that contains p"},
        {"Line 4", "  split it into three around p"},
        {"Line 5", "  L: the edges opposite p"},
        {"Line 6", "  LawsonFlip(L)"},
        {"Line 7", "end for"},
        {"Line 8", "remove what ends at x, y, z (here: at infinity)"},
    },
    .label = {
        [STEP_START] = "Line 1",
        [STEP_VISIT] = "Line 3",
        [STEP_LOCATE] = "Line 3",
        [STEP_SPLIT] = "Line 4",
        [STEP_PUSH] = "Line 5",
        [STEP_POP] = "Line 6",
        [STEP_KEEP] = "Line 6",
        [STEP_FLIP] = "Line 6",
        [STEP_PUSH_LINK] = "Line 6",
    },
};
