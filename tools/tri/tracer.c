/* tracer.c - from events to steps.
 *
 * Which edges come and go is taken from the event and from the mesh near it. The reason
 * is asked of the predicates anew: a step says what is so, and not what the algorithm
 * believes.
 */
#include "tools/tri/tracer.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/walk.h"

/* ---- What many steps say and show. ---- */

/* Does p see the hull edge from u to v? */
static bool
sees(const tracer *w, vertex_id p, vertex_id u, vertex_id v)
{
    return orient2d(w->points[u], w->points[v], w->points[p]) < 0;
}

/* "9 lies inside the circle of 3, 7, 2", or whatever is so. */
static void
say_where(tracer *w, const vertex_id circle[3], vertex_id p)
{
    const point2 *points = w->points;
    int sign = incircle(points[circle[0]], points[circle[1]], points[circle[2]], points[p]);
    const char *where = sign > 0 ? "inside" : sign < 0 ? "outside" : "on";
    say_point(&w->step, p);
    say(&w->step, " lies %s the circle of ", where);
    say_corners(&w->step, circle);
}

static void
show_circle(step *s, const vertex_id circle[3], vertex_id p)
{
    for (int i = 0; i < 3; i++)
        id_list_add(&s->field[CIRCLE], circle[i]);
    id_list_add(&s->field[POINT], p);
}

/* The corners of the triangle of e; or of the hull edge, and NONE, on whose outer side
 * it lies. */
static void
corners_of(const mesh *m, halfedge_id e, vertex_id corner[3])
{
    bool inside = mesh_in_triangle(m, e);
    if (!inside)
        e = hull_edge_of(m, e);
    corner[0] = mesh_origin(m, e);
    corner[1] = mesh_dest(m, e);
    corner[2] = inside ? mesh_apex(m, e) : NONE;
}

static void
show_corners(step *s, const vertex_id corner[3])
{
    if (corner[2] == NONE)
        id_list_add_edge(&s->field[EDGES], corner[0], corner[1]);
    for (int i = 0; corner[2] != NONE && i < 3; i++)
        id_list_add(&s->field[TRIANGLE], corner[i]);
}

/* The new vertex p and its edges: "join 9 to 1, 2 and 5". */
static void
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

/* ---- 2.3: the first edge, and points that join the hull. ---- */

static void
see_start(tracer *w, vertex_id a, vertex_id b)
{
    step *s = &w->step;
    say(s, "begin with %lu and %lu: the edge ", (unsigned long)a, (unsigned long)b);
    say_edge(s, a, b);
    id_list_add_edge(&s->field[ADD], a, b);
    id_list_add(&s->field[INSERT], a);
    id_list_add(&s->field[INSERT], b);
    step_end(s, STEP_START);
    w->flipped = false;
}

/* p has seen the edges opposite it: "no hull edge, ..." or "the hull edges 1-2 and 2-5". */
static void
say_seen(step *s, const mesh *m, vertex_id p)
{
    id_list *seen = &s->field[EDGES];
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        if (mesh_in_triangle(m, e))
            id_list_add_edge(seen, mesh_dest(m, e), mesh_apex(m, e));
        e = mesh_around(m, e);
    } while (e != first);
    id_list_add(&s->field[POINT], p);
    if (seen->count == 0) {
        say(s, "no hull edge, as all points so far are in line with it");
    } else {
        say(s, "the hull edge%s ", seen->count == 2 ? "" : "s");
        say_list(s, seen, 2);
    }
}

static void
see_attach(tracer *w, const mesh *m, vertex_id p)
{
    step *s = &w->step;
    say(s, "%lu comes: it sees ", (unsigned long)p);
    say_seen(s, m, p);
    step_end(s, STEP_SEE);

    join(s, m, p);
    say(s, ": it sees ");
    say_seen(s, m, p);
    step_end(s, STEP_ATTACH);
    w->flipped = false;
}

/* ---- 3.5 and 3.6: the stack. ---- */

static void
see_push(tracer *w, vertex_id a, vertex_id b)
{
    w->pending = MORE_PUSHES;
    if (a == GHOST || b == GHOST)
        id_list_add(&w->rays, a == GHOST ? b : a);
    else
        id_list_add_edge(&w->step.field[PUSH], a, b);
}

static void
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

/* In 3.6 only a new point can lie in the circle of an old triangle; in 3.5 it is as well
 * to ask for one as for the other. */
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

static void
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

static void
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

/* The edge that was popped has been flipped: ab became cd. What was a ray leads to the
 * next vertex of the hull now. */
static void
see_flip(tracer *w, vertex_id c, vertex_id d)
{
    step *s = &w->step;
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
    step_end(s, STEP_FLIP);
}

/* ---- 3.6: the place of a point. ---- */

/* A walk visits triangles of today; a search of the history, those of other days. */
static void
see_visit(tracer *w, const mesh *m, halfedge_id e)
{
    if (e == NONE) {
        w->arrows++;
        return;
    }
    vertex_id corner[3];
    corners_of(m, e, corner);
    for (int i = 0; i < 3; i++)
        id_list_add(&w->walk, corner[i]);
}

/* The walk was a walk to p. */
static void
write_visits(tracer *w, vertex_id p)
{
    step *s = &w->step;
    for (uint32_t i = 0; i < w->walk.count; i += 3) {
        const vertex_id *corner = w->walk.id + i;
        say(s, "the walk to %lu %s ", (unsigned long)p,
            corner[2] != NONE ? i == 0 ? "begins in the triangle" : "comes to the triangle"
                              : i == 0 ? "begins at the edge" : "leaves the hull through");
        if (corner[2] != NONE)
            say_corners(s, corner);
        else
            say_edge(s, corner[0], corner[1]);
        show_corners(s, corner);
        id_list_add(&s->field[POINT], p);
        step_end(s, STEP_VISIT);
    }
    for (uint32_t i = 0; i < w->walk.count; i++)
        id_list_add(&s->field[VISITS], w->walk.id[i]);
    w->walk.count = 0;
}

/* p lies in the triangle of ab. If p is in line with ab it lies on the edge, between
 * its ends, or beyond the end a of the path along which all points lie. */
static void
see_locate(tracer *w, const mesh *m, halfedge_id ab, vertex_id p)
{
    step *s = &w->step;
    const point2 *points = w->points;
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab), corner[3];
    bool in_line = orient2d(points[a], points[b], points[p]) == 0;
    bool between = in_line && is_same_side(points[a], points[b], points[p]) &&
                   is_same_side(points[b], points[a], points[p]);
    corners_of(m, ab, corner);
    if (in_line)
        corner[2] = NONE;
    w->divided[0] = between ? a : NONE;
    w->divided[1] = between ? b : NONE;

    write_visits(w, p);
    say(s, "%lu lies ", (unsigned long)p);
    if (in_line && !between) {
        say(s, "in line with all points so far, beyond %lu", (unsigned long)a);
    } else if (corner[2] != NONE) {
        say(s, "in the triangle ");
        say_corners(s, corner);
    } else {
        say(s, between ? "on the edge " : "outside of the hull: it sees ");
        say_edge(s, a, b);
    }
    if (w->arrows > 0) {
        say(s, "; the history tells it after ");
        say_count(s, w->arrows, "arrow");
    }
    show_corners(s, corner);
    id_list_add(&s->field[POINT], p);
    step_end(s, STEP_LOCATE);
    w->arrows = 0;
}

static void
see_split(tracer *w, const mesh *m, vertex_id p)
{
    step *s = &w->step;
    join(s, m, p);
    if (w->divided[0] != NONE) {
        id_list_add_edge(&s->field[REMOVE], w->divided[0], w->divided[1]);
        say(s, "; it divides ");
        say_edge(s, w->divided[0], w->divided[1]);
    }
    step_end(s, STEP_SPLIT);
    w->newest = p;
    w->flipped = false;
}

/* The point q now waits in the triangle of e. It may have moved before, since the last
 * step: then that is forgotten. */
static void
see_move(tracer *w, const mesh *m, halfedge_id e, vertex_id q)
{
    id_list *moves = &w->step.field[MOVES];
    vertex_id corner[3];
    w->pending = MORE_MOVES;
    corners_of(m, e, corner);
    uint32_t i = 0;
    while (i < moves->count && moves->id[i] != q)
        i += 4;
    if (i == moves->count)
        for (int k = 0; k < 4; k++)
            id_list_add(moves, q);
    for (uint32_t k = 0; k < 3; k++)
        moves->id[i + 1 + k] = corner[k];
}

static bool
is_same_place(const vertex_id p[3], const vertex_id q[3])
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* "2 and 4 now wait in the triangle 0, 1, 5; 3 outside, behind 0-1" */
static void
write_moves(tracer *w)
{
    step *s = &w->step;
    const id_list *moves = &s->field[MOVES];
    for (uint32_t i = 0; i < moves->count; i += 4) {
        const vertex_id *here = moves->id + i + 1;
        bool said = false;
        for (uint32_t k = 0; k < i && !said; k += 4)
            said = is_same_place(moves->id + k + 1, here);
        if (said)
            continue;
        id_list points = {0};
        for (uint32_t k = i; k < moves->count; k += 4)
            if (is_same_place(moves->id + k + 1, here))
                id_list_add(&points, moves->id[k]);
        say(s, "%s", i == 0 ? "" : "; ");
        say_list(s, &points, 1);
        say(s, "%s%s ", i > 0 ? "" : points.count == 1 ? " now waits" : " now wait",
            here[2] == NONE ? " outside, behind" : " in the triangle");
        say_corners(s, here);
        id_list_free(&points);
    }
    step_end(s, STEP_MOVE);
}

/* ---- 3.7: the merge. ---- */

static void
see_bridge(tracer *w, vertex_id l, vertex_id r)
{
    step *s = &w->step;
    w->merging = true;
    w->l = l;
    w->r = r;
    say_edge(s, l, r);
    say(s, " is the lower tangent: no point of the two parts lies right of the line from "
        "%lu to %lu", (unsigned long)l, (unsigned long)r);
    id_list_add_edge(&s->field[EDGES], l, r);
    step_end(s, STEP_TANGENT);

    id_list_add_edge(&s->field[ADD], l, r);
    say(s, "join %lu and %lu by the lower tangent", (unsigned long)l, (unsigned long)r);
    step_end(s, STEP_BRIDGE);
}

/* The hull edge ab of the triangle abc goes, because of the other end of lr. */
static void
see_drop(tracer *w, vertex_id a, vertex_id b, vertex_id c)
{
    step *s = &w->step;
    const vertex_id circle[3] = {a, b, c};
    bool left = a == w->l;
    vertex_id p = left ? w->r : w->l;
    id_list_add_edge(&s->field[REMOVE], a, b);
    show_circle(s, circle, p);
    say_edge(s, a, b);
    say(s, " goes: ");
    say_where(w, circle, p);
    step_end(s, left ? STEP_DROP_LEFT : STEP_DROP_RIGHT);
}

/* There is one triangle more, on lr; its upper side is rl. One end of the edge has
 * stayed. The other candidate, if there is one, is still the hull edge behind it. */
static void
see_rise(tracer *w, const mesh *m, halfedge_id rl)
{
    step *s = &w->step;
    vertex_id r = mesh_origin(m, rl), l = mesh_dest(m, rl);
    bool on_right = r != w->r;
    vertex_id winner = on_right ? r : l, stays = on_right ? l : r;
    vertex_id left_behind = on_right ? w->r : w->l;
    halfedge_id other = on_right ? mesh_hull_next(m, rl) : mesh_hull_prev(m, rl);
    vertex_id u = mesh_origin(m, other), v = mesh_dest(m, other);
    const vertex_id circle[3] = {w->l, w->r, winner};

    id_list_add_edge(&s->field[ADD], l, r);
    for (int i = 0; i < 3; i++)
        id_list_add(&s->field[TRIANGLE], circle[i]);
    say(s, "join ");
    say_edge(s, l, r);
    say(s, ": ");
    if (sees(w, left_behind, u, v)) {
        vertex_id loser = on_right ? v : u;
        show_circle(s, circle, loser);
        say_where(w, circle, loser);
    } else {
        say(s, "%lu is the only candidate, as %lu sees no hull edge at %lu",
            (unsigned long)winner, (unsigned long)left_behind, (unsigned long)stays);
    }
    step_end(s, STEP_RISE);
    w->l = l;
    w->r = r;
}

static void
write_top(tracer *w)
{
    step *s = &w->step;
    w->merging = false;
    id_list_add_edge(&s->field[EDGES], w->l, w->r);
    say_edge(s, w->l, w->r);
    say(s, " is the upper tangent: no point of the two parts lies left of the line from "
        "%lu to %lu", (unsigned long)w->l, (unsigned long)w->r);
    step_end(s, STEP_TOP);
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
        see_flip(w, event->c, event->d);
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
    case TRACE_PUSH: see_push(w, event->a, event->b); break;
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
    id_list_free(&w->rays);
    id_list_free(&w->walk);
}
