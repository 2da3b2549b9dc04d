/* 3.7.c - divide and conquer: cases for the student's functions. */
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.7-a: points, the meshes of the left and of the right ones, the last
 * and the first of them; the mesh of both. */
static void
solve_merge(void)
{
    uint32_t n;
    mesh left, right, m;
    point2 *points = case_points(&n);
    case_mesh(n, &left);
    case_mesh(n, &right);
    vertex_id v = case_number(), w = case_number();
    if (mesh_init(&m, n, left.locations + right.locations) != TRI_OK)
        exit(3);
    append_mesh(&m, &left);
    append_mesh(&m, &right);
    merge(&m, points, v, w);
    answer_mesh(&m);
    answer_edges(&m);
    mesh_free(&left);
    mesh_free(&right);
    mesh_free(&m);
    free(points);
}

/* The exercises 3.7-b and 3.7-c: points and a direction; the mesh. */
static void
solve_divide(tri_cuts cuts)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    tri_options options = tri_options_default();
    options.direction = case_point();
    options.cuts = cuts;
    answer_number(divide_triangulate(points, n, &options, &m));
    answer_mesh(&m);
    answer_edges(&m);
    mesh_free(&m);
    free(points);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_merge(); break;
    case 'b': solve_divide(TRI_CUTS_VERTICAL); break;
    default: solve_divide(TRI_CUTS_ALTERNATING); break;
    }
}
