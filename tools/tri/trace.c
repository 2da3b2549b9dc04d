/* trace.c - tri trace: an algorithm step by step, as JSON; docs/trace.md has the
 * format.
 *
 * An observer writes each step when it happens. From the event and the mesh it takes
 * which edges have come and gone, and it asks the predicates again for the reason, so
 * that what a step says is what is so, and not what the algorithm believes.
 */
#include "tools/tri/tri.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "lib/decimal.h"
#include "lib/memory.h"

#include <stdarg.h>
#include <string.h>

enum { MOST_POINTS = 10000, MOST_STEPS = 1000000, SAY_ROOM = 1000 };

/* ---- A step, and how it is written. ---- */

/* What belongs to a step besides its sentence. */
typedef enum field {
    REMOVE, ADD, PUSH, POP, TURNED, INSERT, EDGES, CIRCLE, TRIANGLE, POINT, VISITS, MOVES,
    FIELDS
} field;

/* All are lists of points. They are written as lists of groups of so many points; or of
 * single points, for 1; or there is just one, for 0. NONE fills up a group. */
static const struct {
    const char *name;
    uint32_t group;
} form[FIELDS] = {
    [REMOVE] = {"remove", 2}, [ADD] = {"add", 2}, [PUSH] = {"push", 2}, [POP] = {"pop", 2},
    [TURNED] = {"turned", 3}, [INSERT] = {"insert", 1}, [EDGES] = {"edges", 2}, [CIRCLE] = {"circle", 1},
    [TRIANGLE] = {"triangle", 1}, [POINT] = {"point", 0}, [VISITS] = {"visits", 3},
    [MOVES] = {"moves", 4},
};

static const char *const event_name[STEP_KINDS] = {
    [STEP_START] = "start", [STEP_SEE] = "locate", [STEP_ATTACH] = "attach",
    [STEP_PUSH] = "push", [STEP_POP] = "pop", [STEP_KEEP] = "keep", [STEP_FLIP] = "flip",
    [STEP_PUSH_LINK] = "push", [STEP_VISIT] = "visit", [STEP_LOCATE] = "locate",
    [STEP_SPLIT] = "split", [STEP_MOVE] = "move", [STEP_TANGENT] = "locate",
    [STEP_BRIDGE] = "bridge", [STEP_DROP_LEFT] = "flip", [STEP_DROP_RIGHT] = "flip",
    [STEP_RISE] = "flip", [STEP_TOP] = "keep",
};

typedef struct id_list {
    uint32_t count, room;
    vertex_id *id;
} id_list;

/* An edge that has been taken from the stack, ab, and the question about it. */
typedef struct question {
    enum { OF_CIRCLE, OF_HULL, OF_RAY } kind;
    vertex_id a, b;      /* the edge; of a ray, the hull edge that follows it */
    vertex_id circle[3]; /* OF_CIRCLE: does p lie inside this one? */
    vertex_id p;         /* OF_RAY: does p see ab? */
} question;

/* What can still happen to the last event. */
typedef enum pending { NOTHING, MORE_PUSHES, MORE_MOVES, KEEP_OR_FLIP } pending;

typedef struct tracer {
    trace base;
    FILE *file;
    const point2 *points;
    const figure_steps *steps;
    uint32_t written; /* steps */
    /* The next step. */
    id_list field[FIELDS];
    char say[SAY_ROOM];
    size_t said;
    /* What has been seen before. */
    pending pending;
    question asked;     /* about the edge popped last */
    bool flipped;       /* since a point was inserted last */
    id_list stack;      /* the half-edges on it, but for those of rays */
    id_list rays;       /* in a push: where edges to infinity begin */
    id_list walk;       /* triangles visited */
    uint32_t arrows;    /* nodes of the history visited */
    vertex_id place[2]; /* the edge on which the next point lies, or NONE */
    vertex_id newest;   /* the point inserted last, by a split */
    bool merging;
    vertex_id l, r; /* the ends of the edge that rises in a merge */
} tracer;

static void
put(id_list *list, vertex_id v)
{
    if (list->count == list->room) {
        uint32_t room = 2 * list->room + 8;
        vertex_id *id = memory_resize(list->id, room, sizeof *id);
        if (id == NULL)
            must(TRI_OUT_OF_MEMORY);
        list->id = id;
        list->room = room;
    }
    list->id[list->count++] = v;
}

static void
put_edge(id_list *list, vertex_id a, vertex_id b)
{
    put(list, a < b ? a : b);
    put(list, a < b ? b : a);
}

static void
write_group(FILE *file, const vertex_id *id, uint32_t size)
{
    for (uint32_t i = 0; i < size && id[i] != NONE; i++)
        fprintf(file, "%s%lu", i > 0 ? "," : "", (unsigned long)id[i]);
}

static void
write_field(FILE *file, field f, const id_list *list)
{
    uint32_t group = form[f].group;
    fprintf(file, ", \"%s\": %s", form[f].name, group > 0 ? "[" : "");
    if (group < 2)
        write_group(file, list->id, list->count);
    for (uint32_t i = 0; group >= 2 && i < list->count; i += group) {
        fputs(i > 0 ? ",[" : "[", file);
        write_group(file, list->id + i, group);
        fputc(']', file);
    }
    if (group > 0)
        fputc(']', file);
}

/* The next step is over. A step that is no event of its own is written only if a line
 * of the figure shows it. */
static void
write_step(tracer *w, step_kind kind)
{
    const char *label = w->steps->label[kind];
    bool extra = kind == STEP_SEE || kind == STEP_TANGENT || kind == STEP_TOP;
    if (label != NULL || !extra) {
        fprintf(w->file, "%s\n  {\"event\": \"%s\", \"line\": \"%s\", \"say\": \"%s\"",
                w->written++ > 0 ? "," : "", event_name[kind],
                label != NULL ? label : "", w->say);
        for (field f = 0; f < FIELDS; f++)
            if (w->field[f].count > 0 || f == REMOVE || f == ADD)
                write_field(w->file, f, &w->field[f]);
        fputc('}', w->file);
    }
    for (field f = 0; f < FIELDS; f++)
        w->field[f].count = 0;
    w->say[0] = '\0';
    w->said = 0;
}

/* ---- Words. ---- */

/* Adds to the sentence of the next step. */
#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static void
say(tracer *w, const char *words, ...)
{
    va_list arguments;
    va_start(arguments, words);
    int length = vsnprintf(w->say + w->said, SAY_ROOM - w->said, words, arguments);
    va_end(arguments);
    w->said += (size_t)length;
}

/* The points as in "1", "1-2" or "1, 2, 3". */
static void
say_points(tracer *w, const vertex_id *id, uint32_t size)
{
    for (uint32_t i = 0; i < size && id[i] != NONE; i++)
        say(w, "%s%lu", i == 0 ? "" : size == 2 ? "-" : ", ", (unsigned long)id[i]);
}

static void
say_edge(tracer *w, vertex_id a, vertex_id b)
{
    const vertex_id ends[2] = {a < b ? a : b, a < b ? b : a};
    say_points(w, ends, 2);
}

/* The word between item i of `count` and the one before it. */
static const char *
between(uint32_t i, uint32_t count)
{
    return i == 0 ? "" : i + 1 == count ? " and " : ", ";
}

/* "1-2, 2-3 and 3-7", at most six items: edges or, if group is 1, points. */
static void
say_list(tracer *w, const id_list *list, uint32_t group)
{
    const uint32_t most = 6;
    uint32_t count = list->count / group;
    bool all = count <= most;
    for (uint32_t i = 0; i < (all ? count : most - 1); i++) {
        say(w, "%s", all ? between(i, count) : between(i, count + 1));
        say_points(w, list->id + i * group, group);
    }
    if (!all)
        say(w, " and %lu more", (unsigned long)(count - (most - 1)));
}

static void
say_count(tracer *w, uint32_t count, const char *thing)
{
    say(w, "%lu %s%s", (unsigned long)count, thing, count == 1 ? "" : "s");
}

/* "9 lies inside the circle of 3, 7, 2", or whatever is so. */
static void
say_where(tracer *w, const vertex_id circle[3], vertex_id p)
{
    int sign = incircle(w->points[circle[0]], w->points[circle[1]], w->points[circle[2]],
                        w->points[p]);
    say(w, "%lu lies %s the circle of ", (unsigned long)p,
        sign > 0 ? "inside" : sign < 0 ? "outside" : "on");
    say_points(w, circle, 3);
}

/* Shows a circle and a point in the next step. */
static void
show_circle(tracer *w, const vertex_id circle[3], vertex_id p)
{
    for (int i = 0; i < 3; i++)
        put(&w->field[CIRCLE], circle[i]);
    put(&w->field[POINT], p);
}

/* Shows the triangle of e, or the hull edge if it is a part of the outside. */
static void
show_triangle(tracer *w, const mesh *m, halfedge_id e)
{
    if (mesh_in_triangle(m, e)) {
        put(&w->field[TRIANGLE], mesh_origin(m, e));
        put(&w->field[TRIANGLE], mesh_dest(m, e));
        put(&w->field[TRIANGLE], mesh_apex(m, e));
    } else {
        halfedge_id hull = hull_edge_of(m, e);
        put_edge(&w->field[EDGES], mesh_origin(m, hull), mesh_dest(m, hull));
    }
}

/* The points to which p is joined now are new ends of edges. */
static void
add_star(tracer *w, const mesh *m, vertex_id p)
{
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        if (mesh_dest(m, e) != GHOST)
            put_edge(&w->field[ADD], p, mesh_dest(m, e));
        e = mesh_around(m, e);
    } while (e != first);
}

/* "join 9 to 1, 2 and 5" */
static void
say_join(tracer *w, vertex_id p)
{
    id_list others = {0};
    const id_list *add = &w->field[ADD];
    for (uint32_t i = 0; i < add->count; i++)
        if (add->id[i] != p)
            put(&others, add->id[i]);
    say(w, "join %lu to ", (unsigned long)p);
    say_list(w, &others, 1);
    memory_free(others.id);
}

/* ---- 2.3: the first edge, and points that join the hull. ---- */

static void
see_start(tracer *w, const trace_event *event)
{
    say(w, "begin with %lu and %lu: the edge ", (unsigned long)event->a,
        (unsigned long)event->b);
    say_edge(w, event->a, event->b);
    put_edge(&w->field[ADD], event->a, event->b);
    put(&w->field[INSERT], event->a);
    put(&w->field[INSERT], event->b);
    write_step(w, STEP_START);
    w->flipped = false;
}

/* The edges opposite p, if they are in a triangle with p: these it has seen. */
static void
show_seen(tracer *w, const mesh *m, vertex_id p)
{
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        if (mesh_in_triangle(m, e))
            put_edge(&w->field[EDGES], mesh_dest(m, e), mesh_apex(m, e));
        e = mesh_around(m, e);
    } while (e != first);
    put(&w->field[POINT], p);
}

static void
see_attach(tracer *w, const mesh *m, vertex_id p)
{
    id_list *seen = &w->field[EDGES];
    show_seen(w, m, p);
    if (seen->count == 0) {
        say(w, "%lu comes: it sees no hull edge, all points so far are in line with it",
            (unsigned long)p);
    } else {
        say(w, "%lu comes: it sees the hull edge%s ", (unsigned long)p,
            seen->count == 2 ? "" : "s");
        say_list(w, seen, 2);
    }
    write_step(w, STEP_SEE);

    show_seen(w, m, p);
    add_star(w, m, p);
    put(&w->field[INSERT], p);
    say_join(w, p);
    if (seen->count == 0) {
        say(w, ", which is in line with it: it saw no hull edge");
    } else {
        say(w, ": it saw ");
        say_list(w, seen, 2);
    }
    write_step(w, STEP_ATTACH);
    w->flipped = false;
}

/* ---- 3.5 and 3.6: the stack. ---- */

static void
see_push(tracer *w, const trace_event *event)
{
    w->pending = MORE_PUSHES;
    if (event->a == GHOST || event->b == GHOST)
        put(&w->rays, event->a == GHOST ? event->b : event->a);
    else {
        put_edge(&w->field[PUSH], event->a, event->b);
        put(&w->stack, event->edge);
    }
}

static void
write_pushes(tracer *w)
{
    const id_list *push = &w->field[PUSH];
    say(w, "push ");
    say_list(w, push, 2);
    if (w->rays.count > 0) {
        say(w, "%sthe ray%s to infinity from ", push->count > 0 ? ", and " : "",
            w->rays.count == 1 ? "" : "s");
        say_list(w, &w->rays, 1);
    }
    write_step(w, w->flipped ? STEP_PUSH_LINK : STEP_PUSH);
    w->rays.count = 0;
}

/* What will be asked about edge e, which has just been popped. */
static question
question_about(const tracer *w, const mesh *m, halfedge_id e)
{
    vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
    vertex_id c = mesh_apex(m, e), d = mesh_apex(m, mesh_twin(m, e));
    if (a == GHOST || b == GHOST)
        return (question){.kind = OF_RAY, .a = a == GHOST ? b : a, .b = d, .p = c};
    if (c == GHOST || d == GHOST)
        return (question){.kind = OF_HULL, .a = a, .b = b};
    if (c == w->newest)
        return (question){.kind = OF_CIRCLE, .a = a, .b = b, .circle = {b, a, d}, .p = c};
    return (question){.kind = OF_CIRCLE, .a = a, .b = b, .circle = {a, b, c}, .p = d};
}

/* Shows what the question is about. */
static void
show_question(tracer *w)
{
    const question *q = &w->asked;
    put_edge(&w->field[EDGES], q->a, q->b);
    if (q->kind == OF_CIRCLE)
        show_circle(w, q->circle, q->p);
    if (q->kind == OF_RAY)
        put(&w->field[POINT], q->p);
}

static void
see_pop(tracer *w, const mesh *m, halfedge_id e)
{
    const question *q = &w->asked;
    w->asked = question_about(w, m, e);
    w->pending = KEEP_OR_FLIP;
    show_question(w);
    if (q->kind == OF_RAY) {
        say(w, "pop the ray from %lu: does %lu see the hull edge ", (unsigned long)q->a,
            (unsigned long)q->p);
        say_edge(w, q->a, q->b);
        say(w, "?");
    } else {
        w->stack.count--;
        put_edge(&w->field[POP], q->a, q->b);
        say(w, "pop ");
        say_edge(w, q->a, q->b);
        if (q->kind == OF_HULL) {
            say(w, ", a hull edge");
        } else {
            say(w, ": does %lu lie inside the circle of ", (unsigned long)q->p);
            say_points(w, q->circle, 3);
            say(w, "?");
        }
    }
    write_step(w, STEP_POP);
}

static void
write_keep(tracer *w)
{
    const question *q = &w->asked;
    show_question(w);
    if (q->kind == OF_RAY) {
        say(w, "the ray from %lu stays: %lu does not see ", (unsigned long)q->a,
            (unsigned long)q->p);
        say_edge(w, q->a, q->b);
    } else {
        say_edge(w, q->a, q->b);
        say(w, " stays: ");
        if (q->kind == OF_HULL)
            say(w, "it is on the hull");
        else
            say_where(w, q->circle, q->p);
    }
    write_step(w, STEP_KEEP);
}

/* Entries of the stack are half-edges. A flip has turned those of two triangles, dc and
 * its twin among them: entry i, counted from the bottom, is another edge now. */
static void
show_turned(tracer *w, const mesh *m, halfedge_id dc)
{
    triangle_id t = mesh_triangle_of(dc), u = mesh_triangle_of(mesh_twin(m, dc));
    for (uint32_t i = 0; i < w->stack.count; i++) {
        halfedge_id e = w->stack.id[i];
        if (mesh_triangle_of(e) != t && mesh_triangle_of(e) != u)
            continue;
        put(&w->field[TURNED], i);
        put_edge(&w->field[TURNED], mesh_origin(m, e), mesh_dest(m, e));
    }
}

/* What was popped is flipped: ab became cd. A ray becomes an edge to the next hull
 * vertex. */
static void
see_flip(tracer *w, const mesh *m, const trace_event *event)
{
    const question *q = &w->asked;
    w->pending = NOTHING;
    w->flipped = true;
    put_edge(&w->field[ADD], event->c, event->d);
    show_turned(w, m, event->edge);
    if (q->kind == OF_RAY) {
        put(&w->field[POINT], q->p);
        put_edge(&w->field[EDGES], q->a, q->b);
        say(w, "flip the ray from %lu to ", (unsigned long)q->a);
        say_edge(w, event->c, event->d);
        say(w, ": %lu sees ", (unsigned long)q->p);
        say_edge(w, q->a, q->b);
    } else {
        put_edge(&w->field[REMOVE], q->a, q->b);
        show_circle(w, q->circle, q->p);
        say(w, "flip ");
        say_edge(w, q->a, q->b);
        say(w, " to ");
        say_edge(w, event->c, event->d);
        say(w, ": ");
        say_where(w, q->circle, q->p);
    }
    write_step(w, STEP_FLIP);
}

/* ---- 3.6: the place of a point. ---- */

/* "the triangle 1, 2, 5", or "the outside of the hull edge 2-5" */
static void
say_triangle(tracer *w)
{
    const id_list *triangle = &w->field[TRIANGLE];
    if (triangle->count > 0) {
        say(w, "the triangle ");
        say_points(w, triangle->id, 3);
    } else {
        say(w, "the outside of the hull edge ");
        say_points(w, w->field[EDGES].id, 2);
    }
}

static void
see_visit(tracer *w, const mesh *m, halfedge_id e)
{
    if (e == NONE) { /* a triangle of some other time */
        w->arrows++;
        return;
    }
    show_triangle(w, m, e);
    bool outside = w->field[TRIANGLE].count == 0;
    const id_list *corners = &w->field[outside ? EDGES : TRIANGLE];
    for (uint32_t i = 0; i < 3; i++)
        put(&w->walk, i < corners->count ? corners->id[i] : NONE);
    say(w, "the walk comes to ");
    say_triangle(w);
    write_step(w, STEP_VISIT);
}

/* p lies in the triangle of ab; on ab, if it is in line with it and between its ends;
 * else beyond the end of the path along which all points lie. */
static void
see_locate(tracer *w, const mesh *m, halfedge_id ab, vertex_id p)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    const point2 *points = w->points;
    bool in_line = orient2d(points[a], points[b], points[p]) == 0;
    bool on_edge = in_line && is_same_side(points[a], points[b], points[p]) &&
                   is_same_side(points[b], points[a], points[p]);
    w->place[0] = on_edge ? a : NONE;
    w->place[1] = on_edge ? b : NONE;

    say(w, "%lu lies ", (unsigned long)p);
    if (in_line) {
        put_edge(&w->field[EDGES], a, b);
        say(w, "%s ", on_edge ? "on the edge" : "in line with all points so far, beyond");
        if (on_edge)
            say_edge(w, a, b);
        else
            say(w, "%lu", (unsigned long)a);
    } else {
        show_triangle(w, m, ab);
        bool outside = w->field[TRIANGLE].count == 0;
        say(w, "%s ", outside ? "outside of the hull: it sees the edge" : "in the triangle");
        say_points(w, w->field[outside ? EDGES : TRIANGLE].id, outside ? 2 : 3);
    }
    if (w->arrows > 0) {
        say(w, ", as the history tells after ");
        say_count(w, w->arrows, "arrow");
    }
    for (uint32_t i = 0; i < w->walk.count; i++)
        put(&w->field[VISITS], w->walk.id[i]);
    put(&w->field[POINT], p);
    write_step(w, STEP_LOCATE);
    w->walk.count = 0;
    w->arrows = 0;
}

static void
see_split(tracer *w, const mesh *m, vertex_id p)
{
    add_star(w, m, p);
    put(&w->field[INSERT], p);
    say_join(w, p);
    if (w->place[0] != NONE) {
        put_edge(&w->field[REMOVE], w->place[0], w->place[1]);
        say(w, ", which divides ");
        say_edge(w, w->place[0], w->place[1]);
    }
    write_step(w, STEP_SPLIT);
    w->newest = p;
    w->flipped = false;
}

/* A point now waits in the triangle of e: it, and the corners. */
static void
see_move(tracer *w, const mesh *m, const trace_event *event)
{
    w->pending = MORE_MOVES;
    halfedge_id e = event->edge;
    bool inside = mesh_in_triangle(m, e);
    if (!inside)
        e = hull_edge_of(m, e);
    put(&w->field[MOVES], event->a);
    put(&w->field[MOVES], mesh_origin(m, e));
    put(&w->field[MOVES], mesh_dest(m, e));
    put(&w->field[MOVES], inside ? mesh_apex(m, e) : NONE);
}

static void
write_moves(tracer *w)
{
    const id_list *moves = &w->field[MOVES];
    if (moves->count == 4) {
        bool inside = moves->id[3] != NONE;
        say(w, "%lu now waits %s ", (unsigned long)moves->id[0],
            inside ? "in the triangle" : "outside, behind");
        say_points(w, moves->id + 1, inside ? 3 : 2);
    } else {
        say_count(w, moves->count / 4, "point");
        say(w, " that wait in the old triangles now wait in the new ones");
    }
    write_step(w, STEP_MOVE);
}

/* ---- 3.7: the merge. ---- */

static bool
sees(const tracer *w, vertex_id p, vertex_id u, vertex_id v)
{
    return orient2d(w->points[u], w->points[v], w->points[p]) < 0;
}

static void
see_bridge(tracer *w, vertex_id l, vertex_id r)
{
    w->merging = true;
    w->l = l;
    w->r = r;
    say_edge(w, l, r);
    say(w, " is the lower tangent: no point of the two parts lies right of the line from "
        "%lu to %lu", (unsigned long)l, (unsigned long)r);
    put_edge(&w->field[EDGES], l, r);
    write_step(w, STEP_TANGENT);

    put_edge(&w->field[ADD], l, r);
    say(w, "join %lu and %lu", (unsigned long)l, (unsigned long)r);
    write_step(w, STEP_BRIDGE);
}

/* The hull edge ab of the triangle abc goes, because of the other end of lr. */
static void
see_drop(tracer *w, vertex_id a, vertex_id b, vertex_id c)
{
    const vertex_id circle[3] = {a, b, c};
    bool left = a == w->l;
    vertex_id p = left ? w->r : w->l;
    put_edge(&w->field[REMOVE], a, b);
    show_circle(w, circle, p);
    say_edge(w, a, b);
    say(w, " goes: ");
    say_where(w, circle, p);
    write_step(w, left ? STEP_DROP_LEFT : STEP_DROP_RIGHT);
}

/* The triangle on lr whose upper side is rl; the other candidate, if there is one, is
 * still the hull edge behind that end of lr that stays. */
static void
see_rise(tracer *w, const mesh *m, halfedge_id rl)
{
    vertex_id r = mesh_origin(m, rl), l = mesh_dest(m, rl);
    bool on_right = r != w->r;
    vertex_id winner = on_right ? r : l;
    halfedge_id other = on_right ? mesh_hull_next(m, rl) : mesh_hull_prev(m, rl);
    vertex_id u = mesh_origin(m, other), v = mesh_dest(m, other);
    vertex_id loser = on_right ? v : u;
    const vertex_id circle[3] = {w->l, w->r, winner};

    put_edge(&w->field[ADD], l, r);
    for (int i = 0; i < 3; i++)
        put(&w->field[TRIANGLE], circle[i]);
    say(w, "join ");
    say_edge(w, l, r);
    if (sees(w, on_right ? w->r : w->l, u, v)) {
        show_circle(w, circle, loser);
        say(w, ": ");
        say_where(w, circle, loser);
    } else {
        say(w, ": %lu is the only candidate, as %lu sees no hull edge that ends at %lu",
            (unsigned long)winner, (unsigned long)(on_right ? w->r : w->l),
            (unsigned long)(on_right ? w->l : w->r));
    }
    write_step(w, STEP_RISE);
    w->l = l;
    w->r = r;
}

static void
write_top(tracer *w)
{
    w->merging = false;
    put_edge(&w->field[EDGES], w->l, w->r);
    say_edge(w, w->l, w->r);
    say(w, " is the upper tangent: there is no candidate on either side");
    write_step(w, STEP_TOP);
}

/* In a merge, flips are of two kinds: an edge to infinity comes or goes. */
static void
see_merge_flip(tracer *w, const mesh *m, const trace_event *event)
{
    if (event->d == GHOST)
        see_drop(w, event->a, event->b, event->c);
    else
        see_rise(w, m, event->edge);
}

/* ---- All events. ---- */

/* Writes what was waiting for more to come. */
static void
settle(tracer *w)
{
    pending before = w->pending;
    w->pending = NOTHING;
    if (before == MORE_PUSHES)
        write_pushes(w);
    if (before == MORE_MOVES)
        write_moves(w);
    if (before == KEEP_OR_FLIP)
        write_keep(w);
}

static bool
belongs_to(pending before, trace_kind kind)
{
    return (before == MORE_PUSHES && kind == TRACE_PUSH) ||
           (before == MORE_MOVES && kind == TRACE_MOVE) ||
           (before == KEEP_OR_FLIP && kind == TRACE_FLIP);
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    tracer *w = (tracer *)self;
    if (!belongs_to(w->pending, event->kind))
        settle(w);
    if (w->merging && event->kind != TRACE_FLIP)
        write_top(w);
    switch (event->kind) {
    case TRACE_START:
        see_start(w, event);
        break;
    case TRACE_ATTACH:
        see_attach(w, m, event->a);
        break;
    case TRACE_PUSH:
        see_push(w, event);
        break;
    case TRACE_POP:
        see_pop(w, m, event->edge);
        break;
    case TRACE_FLIP:
        if (w->merging)
            see_merge_flip(w, m, event);
        else
            see_flip(w, m, event);
        break;
    case TRACE_VISIT:
        see_visit(w, m, event->edge);
        break;
    case TRACE_LOCATE:
        see_locate(w, m, event->edge, event->a);
        break;
    case TRACE_SPLIT:
        see_split(w, m, event->a);
        break;
    case TRACE_MOVE:
        see_move(w, m, event);
        break;
    case TRACE_BRIDGE:
        see_bridge(w, event->a, event->b);
        break;
    }
    return w->written > MOST_STEPS;
}

/* ---- The file. ---- */

static void
write_head(FILE *file, const algorithm *a, const text_points *in)
{
    const figure_steps *steps = a->steps;
    fprintf(file, "{\"format\": \"tri-trace 1\",\n \"algorithm\": \"%s\",\n"
            " \"section\": \"%s\",\n \"figure\": {\"name\": \"%s\", \"lines\": [",
            a->name, a->section, steps->figure);
    for (const figure_line *line = steps->lines; line->label != NULL; line++)
        fprintf(file, "%s\n  {\"label\": \"%s\", \"text\": \"%s\"}",
                line > steps->lines ? "," : "", line->label, line->text);
    fprintf(file, "]},\n \"points\": [");
    for (uint32_t v = 0; v < in->count; v++) {
        char x[DECIMAL_ROOM], y[DECIMAL_ROOM];
        decimal_write(x, in->points[v].x);
        decimal_write(y, in->points[v].y);
        fprintf(file, "%s\n  [%s, %s]", v > 0 ? "," : "", x, y);
    }
    fprintf(file, "],\n \"steps\": [");
}

static void
write_trace(FILE *file, const algorithm *a, tri_options options, const text_points *in)
{
    tracer w = {.base = {see}, .file = file, .points = in->points, .steps = a->steps,
                .place = {NONE, NONE}, .newest = NONE};
    mesh m;
    write_head(file, a, in);
    options.trace = &w.base;
    tri_status status = a->triangulate(in->points, in->count, &options, &m);
    if (status == TRI_CANCELLED)
        die("tri trace: these are more than %d steps; trace fewer points", MOST_STEPS);
    must(status);
    settle(&w);
    if (w.merging)
        write_top(&w);
    fprintf(file, "]}\n");

    note_degenerate(in->count, m.locations, m.triangles - mesh_hull_size(&m));
    for (field f = 0; f < FIELDS; f++)
        memory_free(w.field[f].id);
    memory_free(w.stack.id);
    memory_free(w.rays.id);
    memory_free(w.walk.id);
    mesh_free(&m);
}

/* The algorithm of that name, if it can be watched. */
static const algorithm *
find_watchable(const char *name)
{
    char all[200] = "";
    for (uint32_t i = 0; i < contents_count; i++)
        if (contents[i].steps != NULL)
            strcat(strcat(all, " "), contents[i].name);
    if (name == NULL)
        die_usage("trace", "say which algorithm, --algorithm NAME; one of:%s", all);
    const algorithm *a = contents_find(name);
    if (a == NULL)
        die_usage("trace", "there is no algorithm %s; needed is one of:%s", name, all);
    if (a->steps == NULL)
        die_usage("trace", "%s reports no steps; these do:%s", name, all);
    return a;
}

int
command_trace(int argc, char **argv)
{
    tri_options options = parse_options(&argc, argv);
    const algorithm *a = find_watchable(take_option(&argc, argv, "--algorithm"));
    const char *path = take_option(&argc, argv, "-o");
    expect_words(argc, argv, 1, 1);
    if (path == NULL)
        path = "-";
    check_output(path);
    text_points in = load_points(argv[1]);
    if (in.count > MOST_POINTS)
        die("tri trace: %lu points are too many to watch; at most %d", (unsigned long)in.count,
            MOST_POINTS);
    output o = begin_output(path);
    write_trace(o.file, a, options, &in);
    finish_output(&o, path);
    text_points_free(&in);
    return EXIT_HOLDS;
}
