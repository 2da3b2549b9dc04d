/* step.h - a step of a trace: what it says, what it shows, and how it is written.
 *
 * Needs: lib/point.h, lib/steps.h. docs/trace.md has the format.
 */
#ifndef TOOLS_TRI_STEP_H
#define TOOLS_TRI_STEP_H

#include "lib/point.h"
#include "lib/steps.h"

#include <stdio.h>

/* What a step has besides its sentence; all are lists of points. */
typedef enum step_field {
    REMOVE,   /* edges that vanish */
    ADD,      /* edges that appear */
    PUSH,     /* edges put on the stack, the last one on top */
    POP,      /* the edge taken from it */
    TURNED,   /* groups of three: an entry of the stack, and the edge that it is now */
    INSERT,   /* points that become vertices */
    EDGES,    /* edges to be shown */
    CIRCLE,   /* the circle through three points, to be shown */
    TRIANGLE, /* a triangle to be shown */
    POINT,    /* a point to be shown */
    VISITS,   /* groups of three: the triangles of a walk; or hull edges and NONE */
    MOVES,    /* groups of four: a point and where it waits now, as in VISITS */
    STEP_FIELDS
} step_field;

typedef struct id_list {
    uint32_t count, room;
    vertex_id *id;
} id_list;

enum { STEP_SAYS = 2000 }; /* no sentence is longer */

/* The step that is being made, and where it will be written. */
typedef struct step {
    FILE *file;
    const figure_steps *figure;
    uint32_t written; /* steps before it */
    id_list field[STEP_FIELDS];
    char says[STEP_SAYS];
    size_t length; /* of the sentence so far */
} step;

/* Writes the step and begins another. A kind that is no event of its own (STEP_SEE,
 * STEP_TANGENT, STEP_TOP) is written only if the figure has a line for it. */
void step_end(step *s, step_kind kind);

/* Frees the lists. */
void step_free(step *s);

/* ---- Lists. When memory is out the program ends with a message. ---- */

void id_list_add(id_list *list, vertex_id v);
void id_list_add_edge(id_list *list, vertex_id a, vertex_id b); /* the lower first */
void id_list_free(id_list *list);

/* ---- The sentence; each of these adds to it. ---- */

#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
void say(step *s, const char *words, ...);

/* "7" */
void say_point(step *s, vertex_id p);

/* "3-7" */
void say_edge(step *s, vertex_id a, vertex_id b);

/* "3-7", "3, 7, 2": two points that are an edge, in this order, or the corners of a
 * triangle if the third is not NONE. */
void say_corners(step *s, const vertex_id corner[3]);

/* "1-2, 2-3 and 3-7", or "1, 2 and 7": a list of edges (size 2) or points (size 1),
 * six of them at most. */
void say_list(step *s, const id_list *list, uint32_t size);

/* "1 arrow", "2 arrows" */
void say_count(step *s, uint32_t count, const char *thing);

#endif
