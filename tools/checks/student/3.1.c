/* 3.1.c - Voronoi diagrams: cases for the student's functions. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.1-a: points, one of them; the sites around its region. */
static void
solve_region(void)
{
    uint32_t n;
    voronoi_region region;
    point2 *points = case_points(&n);
    answer_number(voronoi_region_of(points, n, case_number(), &region));
    answer_number(region.size);
    for (uint32_t i = 0; i < region.size; i++)
        answer_number(region.neighbour[i]);
    voronoi_region_free(&region);
    free(points);
}

static void
answer_vertices(const voronoi *d)
{
    answer_number(d->vertices);
    for (uint32_t i = 0; i < d->vertices; i++) {
        answer_number(d->vertex_first[i + 1] - d->vertex_first[i]);
        for (uint32_t k = d->vertex_first[i]; k < d->vertex_first[i + 1]; k++)
            answer_number(d->vertex_site[k]);
    }
}

static void
answer_voronoi_edges(const voronoi *d)
{
    answer_number(d->edges);
    for (uint32_t k = 0; k < d->edges; k++) {
        answer_number(d->edge[k].left);
        answer_number(d->edge[k].right);
        answer_number(d->edge[k].from);
        answer_number(d->edge[k].to);
    }
}

static void
answer_cells(const voronoi *d)
{
    for (uint32_t p = 0; p < d->points; p++) {
        answer_number(d->cell_first[p + 1] - d->cell_first[p]);
        for (uint32_t k = d->cell_first[p]; k < d->cell_first[p + 1]; k++)
            answer_number(d->cell_edge[k]);
    }
}

/* The exercise 3.1-b: points and a Delaunay triangulation; its dual. */
static void
solve_dual(void)
{
    uint32_t n;
    mesh m;
    voronoi d;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    tri_status status = voronoi_dual(&m, points, &d);
    answer_number(status);
    if (status == TRI_OK) {
        answer_vertices(&d);
        answer_voronoi_edges(&d);
        answer_cells(&d);
    }
    voronoi_free(&d);
    mesh_free(&m);
    free(points);
}

/* The exercise 3.1-c: points, a Delaunay triangulation of some of them, the one that is
 * asked about, and where the walk starts; the nearest site. */
static void
solve_nearest(void)
{
    uint32_t n;
    mesh m;
    point2 *points = case_points(&n);
    case_mesh(n, &m);
    uint32_t x = case_number(), start = case_number();
    answer_number(nearest_site(&m, points, points[x], start, NULL));
    mesh_free(&m);
    free(points);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_region(); break;
    case 'b': solve_dual(); break;
    default: solve_nearest(); break;
    }
}
