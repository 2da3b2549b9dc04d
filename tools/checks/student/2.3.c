/* 2.3.c - the line sweep: cases for the student's functions. */
#include "chapters/2.3_line_sweep/sweep.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 2.3-a: points and a direction; the order. */
static void
solve_order(void)
{
    uint32_t n, locations;
    point2 *points = case_points(&n);
    point2 direction = case_point();
    vertex_id *order = calloc(n + 1, sizeof *order);
    answer_number(sort_along(points, n, direction, order, &locations));
    answer_number(locations);
    for (uint32_t i = 0; i < locations && i < n; i++)
        answer_number(order[i]);
    free(order);
    free(points);
}

/* The hull edge that leaves v. */
static halfedge_id
hull_edge_leaving(const mesh *m, vertex_id v)
{
    halfedge_id e = mesh_some_hull_edge(m);
    uint32_t size = mesh_hull_size(m);
    for (uint32_t i = 0; i < size && mesh_origin(m, e) != v; i++)
        e = mesh_hull_next(m, e);
    return e;
}

/* The exercise 2.3-b: points, a mesh of all but p, the latest vertex, p; the vertices
 * along the chain. */
static void
solve_seeing(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    vertex_id latest = case_number(), p = case_number();
    hull_chain q = hull_edges_seeing(&m, points, hull_edge_leaving(&m, latest), p);
    uint32_t size = mesh_hull_size(&m), length = 0;
    for (halfedge_id e = q.first; e != q.end && length <= size; length++)
        e = mesh_hull_next(&m, e);
    answer_number(length);
    answer_number(mesh_origin(&m, q.first));
    halfedge_id e = q.first;
    for (uint32_t i = 0; i < length; i++) {
        answer_number(mesh_dest(&m, e));
        e = mesh_hull_next(&m, e);
    }
    mesh_free(&m);
    free(points);
}

/* The exercise 2.3-c: points and a direction; the triangles, and the edges of a
 * path. */
static void
solve_sweep(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    tri_options options = tri_options_default();
    options.direction = case_point();
    answer_number(sweep_triangulate(points, n, &options, &m));
    answer_mesh(&m);
    answer_edges(&m);
    mesh_free(&m);
    free(points);
}

/* The exercise 2.3-d: points and a mesh; its hull. */
static void
solve_hull(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    vertex_id *hull = calloc(n + 1, sizeof *hull);
    uint32_t count = hull_vertices(&m, hull);
    answer_number(count);
    for (uint32_t i = 0; i < count && i < n; i++)
        answer_number(hull[i]);
    free(hull);
    mesh_free(&m);
    free(points);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_order(); break;
    case 'b': solve_seeing(); break;
    case 'c': solve_sweep(); break;
    default: solve_hull(); break;
    }
}
