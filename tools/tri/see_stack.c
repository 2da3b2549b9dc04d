/* see_stack.c - steps of 3.5 and 3.6: edges come to the stack, and are flipped or
 * not. */
#include "tools/tri/see.h"

/* ---- On the stack. ---- */

static void
set_entry(tracer *w, halfedge_id e, uint32_t entry)
{
    while (w->entry.count <= e)
        id_list_add(&w->entry, NONE);
    w->entry.id[e] = entry;
}

void
see_push(tracer *w, const mesh *m, halfedge_id ab)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    w->pending = MORE_PUSHES;
    if (a == GHOST || b == GHOST) {
        id_list_add(&w->rays, a == GHOST ? b : a);
        return;
    }
    id_list_add_edge(&w->step.field[PUSH], a, b);
    set_entry(w, ab, w->on_stack++);
}

void
write_pushes(tracer *w)
{
    step *s = &w->step;
    const id_list *push = &s->field[PUSH];
    say(s, "push ");
    say_list(s, push, 2);
    if (w->rays.count > 0) {
        say(s, "%sthe ray%s to infinity from ", push->count > 0 ? ", and " : "",
            w->rays.count == 1 ? "" : "s");
        say_list(s, &w->rays, 1);
    }
    step_end(s, w->flipped ? STEP_PUSH_LINK : STEP_PUSH);
    w->rays.count = 0;
}

/* ---- From the stack. ---- */

/* In 3.6 only a new point can lie in the circle of an old triangle; in 3.5 it is as
 * well to ask for one as for the other. */
static tracer_question
question_about(const tracer *w, const mesh *m, halfedge_id ab)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, mesh_twin(m, ab));
    if (a == GHOST || b == GHOST)
        return (tracer_question){OF_RAY, a == GHOST ? b : a, d, {NONE, NONE, NONE}, c};
    if (c == GHOST || d == GHOST)
        return (tracer_question){OF_HULL, a, b, {NONE, NONE, NONE}, NONE};
    if (c == w->newest)
        return (tracer_question){OF_CIRCLE, a, b, {b, a, d}, c};
    return (tracer_question){OF_CIRCLE, a, b, {a, b, c}, d};
}

static void
show_question(step *s, const tracer_question *q)
{
    id_list_add_edge(&s->field[EDGES], q->a, q->b);
    if (q->kind == OF_CIRCLE)
        show_circle(s, q->circle, q->p);
    if (q->kind == OF_RAY)
        id_list_add(&s->field[POINT], q->p);
}

void
see_pop(tracer *w, const mesh *m, halfedge_id e)
{
    step *s = &w->step;
    const tracer_question q = question_about(w, m, e);
    w->asked = q;
    w->pending = KEEP_OR_FLIP;
    show_question(s, &q);
    if (q.kind == OF_RAY) {
        say(s, "pop the ray from %lu: does %lu see the hull edge ", (unsigned long)q.a,
            (unsigned long)q.p);
        say_edge(s, q.a, q.b);
        say(s, "?");
    } else {
        set_entry(w, e, NONE);
        w->on_stack--;
        id_list_add_edge(&s->field[POP], q.a, q.b);
        say(s, "pop ");
        say_edge(s, q.a, q.b);
        say(s, q.kind == OF_HULL ? ": is it on the hull?" : ": does ");
    }
    if (q.kind == OF_CIRCLE) {
        say_point(s, q.p);
        say(s, " lie inside the circle of ");
        say_corners(s, q.circle);
        say(s, "?");
    }
    step_end(s, STEP_POP);
}

void
write_keep(tracer *w)
{
    step *s = &w->step;
    const tracer_question q = w->asked;
    show_question(s, &q);
    if (q.kind == OF_RAY) {
        say(s, "the ray from %lu stays: %lu does not see ", (unsigned long)q.a,
            (unsigned long)q.p);
        say_edge(s, q.a, q.b);
    } else {
        say_edge(s, q.a, q.b);
        say(s, " stays: ");
        if (q.kind == OF_HULL)
            say(s, "it is on the hull");
        else
            say_where(w, q.circle, q.p);
    }
    step_end(s, STEP_KEEP);
}

/* The stack holds half-edges. All of the two triangles have turned, by one place. */
static void
turn_entries(tracer *w, const mesh *m, halfedge_id dc)
{
    step *s = &w->step;
    halfedge_id cd = mesh_twin(m, dc);
    const halfedge_id turned[] = {dc, mesh_next(dc), mesh_prev(dc),
                                  cd, mesh_next(cd), mesh_prev(cd)};
    uint32_t count = 0;
    for (int i = 0; i < 6; i++) {
        if (turned[i] >= w->entry.count || w->entry.id[turned[i]] == NONE)
            continue;
        id_list_add(&s->field[TURNED], w->entry.id[turned[i]]);
        id_list_add_edge(&s->field[TURNED], mesh_origin(m, turned[i]),
                         mesh_dest(m, turned[i]));
        count++;
    }
    if (count > 0) {
        say(s, "; with it turn%s ", count == 1 ? "s" : "");
        say_count(s, count, "edge");
        say(s, " on the stack");
    }
}

/* The edge that was popped has been flipped to dc. What was a ray leads to the next
 * vertex of the hull now. */
void
see_flip(tracer *w, const mesh *m, halfedge_id dc)
{
    step *s = &w->step;
    vertex_id c = mesh_dest(m, dc), d = mesh_origin(m, dc);
    const tracer_question q = w->asked;
    w->pending = NOTHING;
    w->flipped = true;
    show_question(s, &q);
    id_list_add_edge(&s->field[ADD], c, d);
    if (q.kind == OF_RAY) {
        say(s, "flip the ray from %lu to ", (unsigned long)q.a);
    } else {
        id_list_add_edge(&s->field[REMOVE], q.a, q.b);
        s->field[EDGES].count = 0; /* it is no more */
        say(s, "flip ");
        say_edge(s, q.a, q.b);
        say(s, " to ");
    }
    say_edge(s, c, d);
    say(s, ": ");
    if (q.kind == OF_RAY) {
        say(s, "%lu sees ", (unsigned long)q.p);
        say_edge(s, q.a, q.b);
    } else {
        say_where(w, q.circle, q.p);
    }
    turn_entries(w, m, dc);
    step_end(s, STEP_FLIP);
}
