/* 3.5.c - edge flips: cases for the student's functions. */
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/trace.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.5-a: points and a mesh; for each side of each triangle, and then for its
 * twin, whether it is locally Delaunay. */
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

/* Counts the flips, and then writes them down. */
typedef struct recorder {
    trace base; /* first: see lib/trace.h */
    uint32_t count;
    vertex_id (*ends)[2];
    uint32_t room;
} recorder;

static int
record(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    recorder *r = (recorder *)self;
    if (event->kind != TRACE_FLIP)
        return 0;
    if (r->count == r->room)
        return 1; /* more than all triangulations need: stop */
    r->ends[r->count][0] = event->a;
    r->ends[r->count++][1] = event->b;
    return 0;
}

static void
answer_ends(const vertex_id (*ends)[2], uint32_t count)
{
    answer_number(count);
    for (uint32_t i = 0; i < count; i++) {
        answer_number(ends[i][0]);
        answer_number(ends[i][1]);
    }
}

/* The exercise 3.5-c: points and a mesh; the flips, and the triangles afterwards. */
static void
solve_lawson_flip(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    recorder r = {.base = {record}, .room = 4 * n * n};
    r.ends = calloc(r.room + 1, sizeof *r.ends);
    edge_stack L;
    if (r.ends != NULL && edge_stack_init(&L, &m) == TRI_OK) {
        push_all_edges(&L);
        m.trace = &r.base;
        lawson_flip(&L, points);
        m.trace = NULL;
        edge_stack_free(&L);
    }
    answer_ends((const vertex_id(*)[2])r.ends, r.count);
    answer_mesh(&m);
    free(r.ends);
    mesh_free(&m);
    free(points);
}

/* The exercise 3.5-d: points and two meshes; the flips that lead from one to the other. */
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
    answer_ends((const vertex_id(*)[2])path.ends, path.count);
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
