/* divide_steps.c - the merge of 3.7, for those who watch it step by step. */
#include "chapters/3.7_divide_and_conquer/divide.h"

const figure_steps divide_steps = {
    .figure = "Merge",
    .lines = {
        {"Divide", "two or three points are triangulated as in 2.3"},
        {"Step 1", "walk down to the lower tangent lr"},
        {"Step 2", "join l and r"},
        {"Step 3", "  take triangles on the left away, whose circles contain r"},
        {"Step 4", "  take triangles on the right away, whose circles contain l"},
        {"Step 5", "  stop at the upper tangent"},
        {"Step 6", "  the next triangle on lr; its new side is lr; go to 3"},
    },
    .label = {
        [STEP_START] = "Divide",
        [STEP_ATTACH] = "Divide",
        [STEP_TANGENT] = "Step 1",
        [STEP_BRIDGE] = "Step 2",
        [STEP_DROP_LEFT] = "Step 3",
        [STEP_DROP_RIGHT] = "Step 4",
        [STEP_TOP] = "Step 5",
        [STEP_RISE] = "Step 6",
    },
};
