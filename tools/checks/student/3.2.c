/* 3.2.c - empty circumcircles: cases for the student's functions. */
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.2-a: points; the Delaunay triangles. */
static void
solve_triangles(void)
{
    uint32_t n;
    triangle_list list;
    point2 *points = case_points(&n);
    answer_number(delaunay_triangles(points, n, &list));
    answer_number(list.count);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        answer_number(list.corner[i / 3][i % 3]);
    triangle_list_free(&list);
    free(points);
}

/* The exercise 3.2-b: points and a Delaunay triangulation; the tree. */
static void
solve_tree(void)
{
    uint32_t n;
    mesh m;
    edge_list tree;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    answer_number(emst(&m, points, &tree));
    answer_number(tree.count);
    for (uint32_t i = 0; i < tree.count; i++) {
        answer_number(tree.ends[i][0]);
        answer_number(tree.ends[i][1]);
    }
    edge_list_free(&tree);
    mesh_free(&m);
    free(points);
}

void
solve(char exercise)
{
    if (exercise == 'a')
        solve_triangles();
    else
        solve_tree();
}
