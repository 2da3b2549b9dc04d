/* 3.3.c - the lifting map: cases for the student's functions. */
#include "chapters/3.3_lifting_map/lifting.h"
#include "chapters/3.3_lifting_map/lower_hull.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

/* The exercise 3.3-a: a, b, c and d; the lifted a, and where the lifted d is. */
static void
solve_lifting(void)
{
    point2 p[4];
    for (int i = 0; i < 4; i++)
        p[i] = case_point();
    point3 lifted = lift(p[0]);
    answer_real(lifted.x);
    answer_real(lifted.y);
    answer_real(lifted.z);
    answer_sign(below_plane_rounded(p[0], p[1], p[2], p[3]));
}

/* The exercise 3.3-b: points, and different locations among them; the faces of their
 * lifted hull, and the twin of each side. */
static void
solve_hull(void)
{
    uint32_t n, locations;
    lifted_hull hull;
    point2 *points = case_points(&n);
    vertex_id *L = case_numbers(&locations);
    answer_number(lifted_hull_of(&hull, points, n, L, locations));
    answer_number(hull.faces.count);
    for (uint32_t i = 0; i < 3 * hull.faces.count; i++)
        answer_number(hull.faces.corner[i / 3][i % 3]);
    for (uint32_t i = 0; i < 3 * hull.faces.count; i++)
        answer_number(hull.twin[i]);
    lifted_hull_free(&hull);
    free(L);
    free(points);
}

void
solve(char exercise)
{
    if (exercise == 'a')
        solve_lifting();
    else
        solve_hull();
}
