/* lawson_steps.c - Figure 10, for those who watch it step by step. */
#include "chapters/3.5_edge_flips/flips.h"

/* The steps of the sweep that come before are in no line of this figure. */
const figure_steps lawson_steps = {
    .figure = "Figure 10",
    .lines = {
        {"Input", "a stack L of edges: all that two triangles share"},
        {"Line 1", "while L is not empty"},
        {"Line 2", "  pop an edge ab from L"},
        {"Line 3", "  if ab is not locally Delaunay"},
        {"Line 4", "    flip ab to cd"},
        {"Line 5", "    push ac, cb, bd, da on L"},
        {"Line 6", "  end if"},
        {"Line 7", "end while"},
    },
    .label = {
        [STEP_PUSH] = "Input",
        [STEP_POP] = "Line 2",
        [STEP_KEEP] = "Line 3",
        [STEP_FLIP] = "Line 4",
        [STEP_PUSH_LINK] = "Line 5",
    },
};
