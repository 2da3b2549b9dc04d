/* 2.1.c - simplicial complexes: cases for the student's functions. */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "tools/checks/student/driver.h"

#include <stdlib.h>

static simplex
case_simplex(void)
{
    simplex s = {.dimension = (int)case_number() - 1};
    for (int i = 0; i <= s.dimension; i++)
        s.vertex[i] = case_number();
    return s;
}

static simplex_list
case_simplices(void)
{
    simplex_list list = {.count = case_number()};
    list.simplex = calloc((size_t)list.count + 1, sizeof *list.simplex);
    for (uint32_t i = 0; list.simplex != NULL && i < list.count; i++)
        list.simplex[i] = case_simplex();
    return list;
}

static void
answer_simplex(simplex s)
{
    answer_number((uint64_t)(s.dimension + 1));
    for (int i = 0; i <= s.dimension && i < 4; i++)
        answer_number(s.vertex[i]);
}

/* The exercise 2.1-a: a simplex; its faces. */
static void
solve_faces(void)
{
    simplex face[17] = {{0}};
    uint32_t count = simplex_faces(case_simplex(), face);
    answer_number(count);
    for (uint32_t i = 0; i < count && i < 16; i++)
        answer_simplex(face[i]);
}

/* The exercise 2.1-b: points and simplices; the verdict. */
static void
solve_complex(void)
{
    uint32_t n;
    point2 *points = case_points(&n);
    simplex_list list = case_simplices();
    verdict v = is_complex(points, n, list);
    answer_number(v.holds);
    answer_number((uint64_t)v.witnesses);
    for (int i = 0; i < v.witnesses && i < 4; i++)
        answer_number(v.witness[i]);
    free(list.simplex);
    free(points);
}

/* The exercise 2.1-c: simplices; their closure. */
static void
solve_closure(void)
{
    simplex_list list = case_simplices(), closure;
    answer_number(simplex_closure(list, &closure));
    answer_number(closure.count);
    for (uint32_t i = 0; i < closure.count; i++)
        answer_simplex(closure.simplex[i]);
    simplex_list_free(&closure);
    free(list.simplex);
}

void
solve(char exercise)
{
    switch (exercise) {
    case 'a': solve_faces(); break;
    case 'b': solve_complex(); break;
    default: solve_closure(); break;
    }
}
