/* tracer.h - the observer that turns events into steps.
 *
 * Needs: step.h, lib/trace.h.
 */
#ifndef TOOLS_TRI_TRACER_H
#define TOOLS_TRI_TRACER_H

#include "lib/trace.h"
#include "tools/tri/step.h"

/* What can still become of the last event. */
typedef enum tracer_pending {
    NOTHING, MORE_PUSHES, MORE_MOVES, KEEP_OR_FLIP
} tracer_pending;

/* An edge ab has been taken from the stack. What is asked about it? */
typedef struct tracer_question {
    enum { OF_CIRCLE, OF_HULL, OF_RAY } kind;
    vertex_id a, b; /* the edge; OF_RAY, from a to infinity: the hull edge beside it */
    vertex_id circle[3]; /* OF_CIRCLE: does p lie inside this one? */
    vertex_id p;         /* OF_RAY: does p see ab? */
} tracer_question;

typedef struct tracer {
    trace base;
    const point2 *points;
    uint32_t most_steps; /* after so many the algorithm is stopped */
    step step;           /* the next one */
    tracer_pending pending;
    tracer_question asked; /* about the edge that was popped last */
    bool flipped;          /* has an edge been flipped since a point came? */
    uint32_t on_stack;     /* how many edges, those to infinity not counted */
    id_list entry;         /* half-edge -> its place on the stack, or NONE */
    id_list rays;          /* in a push: where the edges to infinity begin */
    id_list walk;          /* triangles that a walk has visited, as in VISITS */
    uint32_t arrows;       /* of the history, which a search has followed */
    vertex_id divided[2];  /* the edge on which the next point lies; or NONE */
    vertex_id newest;      /* the point that was put in its place last */
    bool merging;
    vertex_id l, r; /* the ends of the edge that rises in a merge */
} tracer;

/* Steps will be written to the file as they happen, while the algorithm that has this
 * figure is watched. When memory is out the program ends with a message. */
tracer tracer_begin(FILE *file, const figure_steps *figure, const point2 *points,
                    uint32_t most_steps);

/* Writes the last step and frees the lists. */
void tracer_end(tracer *w);

#endif
