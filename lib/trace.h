/* trace.h - the one observer: whoever watches an algorithm hangs a trace on it.
 *
 * Needs: lib/mesh.h.
 *
 * The verbs (attach, flip, edge_stack_pop, ...) report what they have done; the
 * functions that are figures of the notes contain no trace call. Tests, step-by-
 * step pictures, statistics and grading are all observers.
 */
#ifndef LIB_TRACE_H
#define LIB_TRACE_H

#include "lib/mesh.h"

#include <stddef.h>

typedef enum trace_kind {
    TRACE_START,  /* first edge of a triangulation: a b */
    TRACE_ATTACH, /* a joined to the hull; edge = the new hull edge leaving a */
    TRACE_POP,    /* edge, from a to b, taken from the stack */
    TRACE_FLIP,   /* a b became c d; edge now leads from d to c */
    TRACE_PUSH,   /* edge, from a to b, put on the stack */
    TRACE_BRIDGE, /* edge, from a to b, joins two triangulations */
    TRACE_VISIT,  /* a search looks at the triangle of edge */
    TRACE_LOCATE, /* the place of a has been found: in the triangle of edge */
    TRACE_SPLIT,  /* a joined to the corners around its place; edge leaves a */
    TRACE_MOVE    /* a, not a vertex yet, now waits in the triangle of edge */
} trace_kind;

typedef struct trace_event {
    trace_kind kind;
    halfedge_id edge;
    vertex_id a, b, c, d; /* as the kind says; NONE where it says nothing */
} trace_event;

/* An observer: a struct that begins with this one and adds what it remembers.
 * `see` is called after each event, when the mesh is consistent again; when it
 * returns non-zero the algorithm stops and returns TRI_CANCELLED. When an algorithm
 * returns nobody watches its mesh any more. */
typedef struct trace {
    int (*see)(struct trace *self, const mesh *m, const trace_event *event);
} trace;

/* What the verbs call. Costs one test of a pointer when nobody watches. */
static inline void
trace_report(mesh *m, trace_event event)
{
    if (m->trace != NULL && !m->cancelled)
        m->cancelled = m->trace->see(m->trace, m, &event) != 0;
}

#endif
