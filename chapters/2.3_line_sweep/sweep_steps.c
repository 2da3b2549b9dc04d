/* sweep_steps.c - Figure 3, for those who watch it step by step. */
#include "chapters/2.3_line_sweep/sweep.h"

const figure_steps sweep_steps = {
    .figure = "Figure 3",
    .lines = {
        {"Line 1", "sort the points along s into v1, ..., vn"},
        {"Line 2", "begin with v1 and v2"},
        {"Line 3", "for each point vi after these"},
        {"Line 4", "  Q: the hull edges that see vi"},
        {"Line 5", "  a triangle from each edge of Q to vi"},
        {"Line 6", "end for"},
    },
    .label = {
        [STEP_START] = "Line 2",
        [STEP_SEE] = "Line 4",
        [STEP_ATTACH] = "Line 5",
    },
};
