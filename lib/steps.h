/* steps.h - which line of a figure is a step of an algorithm?
 *
 * Needs: nothing.
 *
 * What an observer sees (lib/trace.h) is a step to be shown: with the line of the
 * figure that is being run. The section that has the figure has the table.
 */
#ifndef LIB_STEPS_H
#define LIB_STEPS_H

/* The steps of all algorithms. */
typedef enum step_kind {
    STEP_START,      /* the first edge */
    STEP_SEE,        /* a point comes: the hull edges that it sees */
    STEP_ATTACH,     /* ... and is joined to them */
    STEP_PUSH,       /* edges are put on an empty stack */
    STEP_POP,        /* the last one is taken from it */
    STEP_KEEP,       /* ... and stays as it is */
    STEP_FLIP,       /* ... or is flipped */
    STEP_PUSH_LINK,  /* edges around a flipped one are put on the stack */
    STEP_VISIT,      /* a walk comes to a triangle */
    STEP_LOCATE,     /* the place of a point has been found */
    STEP_SPLIT,      /* ... and the point is put there */
    STEP_MOVE,       /* points that wait have new triangles to wait in */
    STEP_TANGENT,    /* where two triangulations will be joined */
    STEP_BRIDGE,     /* ... and the edge that joins them */
    STEP_DROP_LEFT,  /* a triangle that has to go, on the left */
    STEP_DROP_RIGHT, /* the same on the right */
    STEP_RISE,       /* a new triangle between left and right */
    STEP_TOP,        /* there is no further one */
    STEP_KINDS
} step_kind;

typedef struct figure_line {
    const char *label; /* as in the code: "Line 4", "Step 2" */
    const char *text;  /* what the line says, in short */
} figure_line;

typedef struct figure_steps {
    const char *figure;            /* "Figure 10" */
    figure_line lines[9];          /* ended by one without a label */
    const char *label[STEP_KINDS]; /* step -> the line it is in; NULL if in none */
} figure_steps;

#endif
