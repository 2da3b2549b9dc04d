/* 3.5.c - edge flips: cases for the student's functions. */
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/trace.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.5-a: points and a mesh; for each side of each triangle, and then for
 * its twin, whether it is locally Delaunay. */
static void
solve_locally_delaunay(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    uint32_t sides = case_mesh(n, &m);
    for (halfedge_id e = 0; e < sides; e++) {
        answer_number(is_locally_delaunay(&m, points, e));
        answer_number(is_locally_delaunay(&m, points, mesh_twin(&m, e)));
    }
    mesh_free(&m);
    free(points);
}

/* The exercise 3.5-b: points, a mesh, a side, how often to flip it; all half-edges, and
 * those that leave the vertices. */
static void
solve_flip(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    halfedge_id ab = case_number();
    for (uint32_t times = case_number(); times > 0; times--)
        flip(&m, ab);
    answer_number(mesh_halfedges(&m));
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
        answer_number(mesh_origin(&m, e));
        answer_number(mesh_twin(&m, e));
    }
    for (vertex_id v = 0; v < n; v++)
        answer_number(mesh_leaving(&m, v));
    mesh_free(&m);
    free(points);
}

/* Writes down the flips, and the edges put on the stack and taken off. */
typedef struct recorder {
    trace base; /* first: see lib/trace.h */
    trace_event *event;
    uint32_t count, room, flips, most_flips;
} recorder;

static int
record(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    recorder *r = (recorder *)self;
    if (event->kind != TRACE_FLIP && event->kind != TRACE_PUSH &&
        event->kind != TRACE_POP)
        return 0;
    if (r->count == r->room || r->flips == r->most_flips)
        return 1; /* more than all triangulations need: stop */
    r->event[r->count++] = *event;
    r->flips += event->kind == TRACE_FLIP;
    return 0;
}

/* The ends of the flipped edges. */
static void
answer_flips(const recorder *r)
{
    answer_number(r->flips);
    for (uint32_t i = 0; i < r->count; i++)
        if (r->event[i].kind == TRACE_FLIP) {
            answer_number(r->event[i].a);
            answer_number(r->event[i].b);
        }
}

/* What happened, to which half-edges: tools/checks/turns.h. */
static void
answer_turns(const recorder *r)
{
    answer_number(r->count);
    for (uint32_t i = 0; i < r->count; i++) {
        trace_kind kind = r->event[i].kind;
        answer_number(kind == TRACE_PUSH ? 0 : kind == TRACE_POP ? 1 : 2);
        answer_number(r->event[i].edge);
    }
}

/* The exercise 3.5-c: points and a mesh; the flips, the triangles afterwards, and how
 * the edges came and went: at most 3n at first, and four for each flip. */
static void
solve_lawson_flip(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    recorder r = {.base = {record}, .most_flips = 4 * n * n};
    r.room = 2 * (3 * n + 4 * r.most_flips) + r.most_flips;
    r.event = calloc(r.room, sizeof *r.event);
    edge_stack L;
    if (r.event != NULL && edge_stack_init(&L, &m) == TRI_OK) {
        m.trace = &r.base;
        push_all_edges(&L);
        lawson_flip(&L, points);
        m.trace = NULL;
        edge_stack_free(&L);
    }
    answer_flips(&r);
    answer_mesh(&m);
    answer_turns(&r);
    free(r.event);
    mesh_free(&m);
    free(points);
}

/* The exercise 3.5-d: points and two meshes; the flips that lead from one to the
 * other. */
static void
solve_flip_path(void)
{
    uint32_t n;
    mesh from, to;
    edge_list path;
    point2 *points = case_points(&n);
    case_mesh(n, &from);
    case_mesh(n, &to);
    answer_number(flip_path(points, &from, &to, &path));
    answer_number(path.count);
    for (uint32_t i = 0; i < path.count; i++) {
        answer_number(path.ends[i][0]);
        answer_number(path.ends[i][1]);
    }
    edge_list_free(&path);
    mesh_free(&from);
    mesh_free(&to);
    free(points);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_locally_delaunay(); break;
    case 'b': solve_flip(); break;
    case 'c': solve_lawson_flip(); break;
    default: solve_flip_path(); break;
    }
}
