/* 2.2.c - Euler's formula: cases for the student's functions. */
#include "chapters/2.2_eulers_formula/euler.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* Points and edges. Both exercises begin with a drawing. */
static plane_graph
case_drawing(void)
{
    uint32_t n;
    point2 *points = case_points(&n);
    uint32_t edges = case_number();
    edge_ends *edge = calloc((size_t)edges + 1, sizeof *edge);
    for (uint32_t k = 0; edge != NULL && k < edges; k++) {
        edge[k].a = case_number();
        edge[k].b = case_number();
    }
    plane_graph g;
    answer_number(graph_from_drawing(points, n, edge, edges, &g));
    free(edge);
    free(points);
    return g;
}

/* The exercise 2.2-a: a drawing; its counts. */
static void
solve_counts(void)
{
    plane_graph g = case_drawing();
    euler_counts counts = {0};
    answer_number(euler_count(&g, &counts));
    answer_number(counts.v);
    answer_number(counts.e);
    answer_number(counts.f);
    answer_number(counts.h);
    answer_number(counts.components);
    graph_free(&g);
}

/* The exercise 2.2-b: a drawing; where each edge went. */
static void
solve_trees(void)
{
    plane_graph g = case_drawing();
    edge_part *part = calloc((size_t)g.edges + 1, sizeof *part);
    answer_number(tree_and_cotree(&g, part));
    for (uint32_t k = 0; part != NULL && k < g.edges; k++)
        answer_number(part[k]);
    free(part);
    graph_free(&g);
}

void
solve(char exercise)
{
    if (exercise == 'a')
        solve_counts();
    else
        solve_trees();
}
