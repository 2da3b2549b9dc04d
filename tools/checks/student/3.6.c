/* 3.6.c - incremental insertion: cases for the student's functions. */
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "lib/trace.h"
#include "tools/checks/student/asked_random.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* In a case the vertex at infinity has the number n. */
static vertex_id
vertex_of(uint32_t number, uint32_t n)
{
    return number < n ? number : GHOST;
}

static void
answer_vertex(vertex_id v, uint32_t n)
{
    answer_number(v == GHOST ? n : v);
}

/* The half-edge from a to b in the triangle abc, three numbers of the case. */
static halfedge_id
case_halfedge(const mesh *m, uint32_t n)
{
    vertex_id a = vertex_of(case_number(), n), b = vertex_of(case_number(), n);
    vertex_id c = vertex_of(case_number(), n);
    halfedge_id e = 0;
    while (e < mesh_halfedges(m) &&
           (mesh_origin(m, e) != a || mesh_dest(m, e) != b || mesh_apex(m, e) != c))
        e++;
    return e;
}

static void
answer_origins(const mesh *m, uint32_t n)
{
    answer_number(mesh_halfedges(m));
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        answer_vertex(mesh_origin(m, e), n);
}

/* The exercise 3.6-a: points, a mesh, a place, p; the half-edges before and after. */
static void
solve_split(void)
{
    uint32_t n;
    mesh part, m;
    point2 *points = case_points(&n);
    case_mesh(n, &part);
    if (mesh_init(&m, n, part.locations + 1) != TRI_OK)
        exit(3);
    append_mesh(&m, &part);
    place at = {(place_kind)case_number(), case_halfedge(&m, n)};
    vertex_id p = case_number();
    answer_number(at.e);
    answer_number(mesh_twin(&m, at.e));
    answer_origins(&m, n);
    split(&m, at, p);
    answer_origins(&m, n);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        answer_number(mesh_twin(&m, e));
    for (vertex_id v = 0; v < n; v++)
        answer_number(mesh_leaving(&m, v));
    answer_number(mesh_leaving(&m, GHOST));
    mesh_free(&part);
    mesh_free(&m);
    free(points);
}

/* An event and the corners of a triangle, or the ends of an edge. */
typedef struct seen {
    trace_kind kind;
    vertex_id p, corner[3];
} seen;

typedef struct recorder {
    trace base; /* first: see lib/trace.h */
    seen *event;
    uint32_t count, room;
} recorder;

static int
record(trace *self, const mesh *m, const trace_event *event)
{
    recorder *r = (recorder *)self;
    bool of_a_triangle = event->kind == TRACE_VISIT || event->kind == TRACE_LOCATE ||
                         event->kind == TRACE_MOVE;
    if (event->edge == NONE || (!of_a_triangle && event->kind != TRACE_FLIP))
        return 0;
    if (r->count == r->room)
        return 1; /* more than the checker wants to read: stop */
    seen *s = &r->event[r->count++];
    *s = (seen){event->kind, event->a, {event->a, event->b, event->c}};
    if (of_a_triangle) {
        s->corner[0] = mesh_origin(m, event->edge);
        s->corner[1] = mesh_dest(m, event->edge);
        s->corner[2] = mesh_apex(m, event->edge);
    }
    return 0;
}

static recorder
recorder_with_room(uint32_t room)
{
    recorder r = {.base = {record}, .room = room};
    r.event = calloc(room, sizeof *r.event);
    if (r.event == NULL)
        exit(3);
    return r;
}

/* The exercise 3.6-b: points, a mesh, v, p; the place, and the triangles visited. */
static void
solve_walk(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    vertex_id v = case_number(), p = case_number();
    recorder r = recorder_with_room(1000);
    m.trace = &r.base;
    place at = straight_walk(&m, points, v, points[p]);
    m.trace = NULL;
    bool is_there = at.e < mesh_halfedges(&m);
    answer_number(at.kind);
    answer_vertex(is_there ? mesh_origin(&m, at.e) : NONE - 1, n);
    answer_vertex(is_there ? mesh_dest(&m, at.e) : NONE - 1, n);
    answer_vertex(is_there ? mesh_apex(&m, at.e) : NONE - 1, n);
    answer_number(r.count);
    for (uint32_t i = 0; i < 3 * r.count; i++)
        answer_vertex(r.event[i / 3].corner[i % 3], n);
    free(r.event);
    mesh_free(&m);
    free(points);
}

/* What the checker wants to know of an insertion. */
static void
answer_events(const recorder *r, uint32_t n)
{
    uint32_t visits = 0;
    for (uint32_t i = 0; i < r->count; i++)
        visits += r->event[i].kind == TRACE_VISIT;
    answer_number(r->count - visits);
    for (uint32_t i = 0; i < r->count; i++) {
        const seen *s = &r->event[i];
        if (s->kind == TRACE_VISIT)
            continue;
        answer_number(s->kind == TRACE_LOCATE ? 0 : s->kind == TRACE_FLIP ? 1 : 2);
        answer_vertex(s->p, n);
        for (int k = 0; k < 3; k++)
            answer_vertex(s->corner[k], n);
    }
}

/* The exercises 3.6-c and 3.6-e: points and an order; what happened, and the result. */
static void
solve_insertion(tri_locator how)
{
    uint32_t n, count;
    mesh m;
    point2 *points = case_points(&n);
    vertex_id *order = case_numbers(&count);
    recorder r = recorder_with_room(20000);
    tri_options options = tri_options_default();
    options.locator = how;
    options.trace = &r.base;
    tri_status status = insert_in_order(points, n, order, count, &options, &m);
    answer_events(&r, n);
    answer_number(status);
    answer_mesh(&m);
    answer_edges(&m);
    free(r.event);
    free(order);
    mesh_free(&m);
    free(points);
}

/* The exercise 3.6-d: how to draw (0: as the checker says, else a seed), and how many
 * items; the items 1, 2, ... afterwards, between two zeros that are none of them. */
static void
solve_shuffle(void)
{
    uint32_t seed = case_number(), count = case_number();
    vertex_id *L = calloc(count + 2, sizeof *L);
    random_source random = seed == 0 ? asked_random() : random_from_seed(seed);
    for (uint32_t i = 1; i <= count; i++)
        L[i] = i;
    shuffle(L + 1, count, &random);
    for (uint32_t i = 0; i < count + 2; i++)
        answer_number(L[i]);
    free(L);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_split(); break;
    case 'b': solve_walk(); break;
    case 'c': solve_insertion(TRI_LOCATOR_HISTORY); break;
    case 'd': solve_shuffle(); break;
    default: solve_insertion(TRI_LOCATOR_BUCKETS); break;
    }
}
