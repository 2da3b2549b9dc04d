/* tracer.c - from events to steps.
 *
 * Which edges come and go is taken from the event and from the mesh near it. The reason
 * is asked of the predicates anew: a step says what is so, and not what the algorithm
 * believes.
 */
#include "tools/tri/tracer.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/walk.h"
#include "tools/tri/see.h"

/* ---- What many steps say and show. ---- */

void
say_where(tracer *w, const vertex_id circle[3], vertex_id p)
{
    const point2 *points = w->points;
    int sign =
        incircle(points[circle[0]], points[circle[1]], points[circle[2]], points[p]);
    const char *where = sign > 0 ? "inside" : sign < 0 ? "outside" : "on";
    say_point(&w->step, p);
    say(&w->step, " lies %s the circle of ", where);
    say_corners(&w->step, circle);
}

void
show_circle(step *s, const vertex_id circle[3], vertex_id p)
{
    for (int i = 0; i < 3; i++)
        id_list_add(&s->field[CIRCLE], circle[i]);
    id_list_add(&s->field[POINT], p);
}

void
corners_of(const mesh *m, halfedge_id e, vertex_id corner[3])
{
    bool inside = mesh_in_triangle(m, e);
    if (!inside)
        e = hull_edge_of(m, e);
    corner[0] = mesh_origin(m, e);
    corner[1] = mesh_dest(m, e);
    corner[2] = inside ? mesh_apex(m, e) : NONE;
}

void
show_corners(step *s, const vertex_id corner[3])
{
    if (corner[2] == NONE)
        id_list_add_edge(&s->field[EDGES], corner[0], corner[1]);
    for (int i = 0; corner[2] != NONE && i < 3; i++)
        id_list_add(&s->field[TRIANGLE], corner[i]);
}

void
join(step *s, const mesh *m, vertex_id p)
{
    id_list others = {0};
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        vertex_id q = mesh_dest(m, e);
        if (q != GHOST) {
            id_list_add_edge(&s->field[ADD], p, q);
            id_list_add(&others, q);
        }
        e = mesh_around(m, e);
    } while (e != first);
    id_list_add(&s->field[INSERT], p);
    say(s, "join %lu to ", (unsigned long)p);
    say_list(s, &others, 1);
    id_list_free(&others);
}

/* ---- All events. ---- */

/* Writes the steps of which we know only now that they are over. */
static void
settle(tracer *w)
{
    tracer_pending before = w->pending;
    w->pending = NOTHING;
    if (before == MORE_PUSHES)
        write_pushes(w);
    if (before == MORE_MOVES)
        write_moves(w);
    if (before == KEEP_OR_FLIP)
        write_keep(w);
}

/* Is the event of this kind a part of what is pending? */
static bool
goes_on(tracer_pending before, trace_kind kind)
{
    return (before == MORE_PUSHES && kind == TRACE_PUSH) ||
           (before == MORE_MOVES && kind == TRACE_MOVE) ||
           (before == KEEP_OR_FLIP && kind == TRACE_FLIP);
}

/* In a merge there are two kinds of flips: an edge becomes one to infinity, or one to
 * infinity an edge. */
static void
see_any_flip(tracer *w, const mesh *m, const trace_event *event)
{
    if (!w->merging)
        see_flip(w, m, event->edge);
    else if (event->d == GHOST)
        see_drop(w, event->a, event->b, event->c);
    else
        see_rise(w, m, event->edge);
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    tracer *w = (tracer *)self;
    if (!goes_on(w->pending, event->kind))
        settle(w);
    if (w->merging && event->kind != TRACE_FLIP)
        write_top(w);
    switch (event->kind) {
    case TRACE_START: see_start(w, event->a, event->b); break;
    case TRACE_ATTACH: see_attach(w, m, event->a); break;
    case TRACE_POP: see_pop(w, m, event->edge); break;
    case TRACE_FLIP: see_any_flip(w, m, event); break;
    case TRACE_PUSH: see_push(w, m, event->edge); break;
    case TRACE_BRIDGE: see_bridge(w, event->a, event->b); break;
    case TRACE_VISIT: see_visit(w, m, event->edge); break;
    case TRACE_LOCATE: see_locate(w, m, event->edge, event->a); break;
    case TRACE_SPLIT: see_split(w, m, event->a); break;
    case TRACE_MOVE: see_move(w, m, event->edge, event->a); break;
    }
    return w->step.written > w->most_steps;
}

tracer
tracer_begin(FILE *file, const figure_steps *figure, const point2 *points,
             uint32_t most_steps)
{
    return (tracer){.base = {see}, .points = points, .most_steps = most_steps,
                    .step = {.file = file, .figure = figure},
                    .divided = {NONE, NONE}, .newest = NONE};
}

void
tracer_end(tracer *w)
{
    settle(w);
    if (w->merging)
        write_top(w);
    step_free(&w->step);
    id_list_free(&w->entry);
    id_list_free(&w->rays);
    id_list_free(&w->walk);
}
