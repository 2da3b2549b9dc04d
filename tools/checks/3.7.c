/* 3.7.c - the properties of exercises 3.7-a to 3.7-c: divide and conquer. */
#include "tools/checks/certify.h"
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/room.h"

#include <math.h>
#include <stdlib.h>

/* (1,0), or another direction with small coordinates. */
static site
some_direction(session *s)
{
    site d = {1, 0};
    if (random_below(trial_random(s), 2) == 0)
        do
            d = (site){(int32_t)random_below(trial_random(s), 7) - 3,
                       (int32_t)random_below(trial_random(s), 7) - 3};
        while (d.x == 0 && d.y == 0);
    return d;
}

/* The triangles of the answer, and the edges if there can be none. */
static void
take_delaunay(session *s, const site *p, uint32_t n)
{
    triangle_list list = take_triangles(s, n, 2 * n);
    if (failed(s) || !expect_verdict(s, certify_delaunay(p, n, list)))
        return;
    if (cases_are_collinear(p, n))
        take_path(s);
}

/* ---- 3.7-a: the merge. ---- */

/* Each location by its lowest index, along d. */
static uint32_t
order_along(const site *p, uint32_t n, site d, uint32_t *order)
{
    uint32_t count = cases_locations(p, n, order);
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t j = i; j > 0 && plane_along(d, p[order[j - 1]], p[order[j]]) > 0;
             j--) {
            uint32_t other = order[j];
            order[j] = order[j - 1];
            order[j - 1] = other;
        }
    return count;
}

static void
give_piece(session *s, const site *p, const uint32_t *part, uint32_t count)
{
    piece given = piece_at_random(trial_random(s), p, part, count, true);
    keep_triangles(s, given.list);
    if (given.list.count > 0)
        give_triangles(s, given.list);
    else
        give_path(s, given.path, given.length);
    free(given.path);
}

/* Cuts the locations in two, each with an edge at least; merges them. Returns how many
 * there are, or 0. */
static uint32_t
check_merge(session *s, const site *p, uint32_t n)
{
    uint32_t *order = room_for(n, sizeof *order);
    uint32_t count = order_along(p, n, some_direction(s), order);
    if (count < 4) {
        free(order);
        return 0;
    }
    uint32_t half = 2 + random_below(trial_random(s), count - 3);
    begin_case(s, 'a', p, n);
    give_points(s);
    give_piece(s, p, order, half);
    give_piece(s, p, order + half, count - half);
    give_number(s, order[half - 1]);
    give_number(s, order[half]);
    if (ask(s))
        take_delaunay(s, p, n);
    if (failed(s)) { /* where the two sides meet */
        show_witness(s, order[half - 1]);
        show_witness(s, order[half]);
    }
    free(order);
    return count;
}

static void
merge_is_delaunay(session *s, const site *p, uint32_t n)
{
    check_merge(s, p, n);
}

/* Page 3.7, P9: at most 8u of either kind. */
static void
merge_is_linear(session *s, const site *p, uint32_t n)
{
    uint32_t u = check_merge(s, p, n);
    uint64_t most = 16 * (uint64_t)u;
    expect(s, asked_in_all(s) <= most || u == 0,
           "%llu questions to merge %lu points, left and right together; 8 orientation "
           "and 8 incircle tests for each are %llu",
           (unsigned long long)asked_in_all(s), (unsigned long)u,
           (unsigned long long)most);
}

/* ---- 3.7-b and 3.7-c: the whole algorithm. ---- */

static void
check_divide(session *s, char exercise, const site *p, uint32_t n)
{
    begin_case(s, exercise, p, n);
    give_points(s);
    site d = some_direction(s);
    give_real(s, d.x);
    give_real(s, d.y);
    if (ask(s) && take_ok(s))
        take_delaunay(s, p, n);
}

static void
divide_is_delaunay(session *s, const site *p, uint32_t n)
{
    check_divide(s, 'b', p, n);
}

static void
divide_is_cheap(session *s, const site *p, uint32_t n)
{
    check_divide(s, 'b', p, n);
    double most = n > 1 ? 6.0 * n * log2(n) : 0;
    expect(s, (double)asked_in_all(s) <= most,
           "%llu questions of all kinds for %lu points; 6 n log2 n is %.0f",
           (unsigned long long)asked_in_all(s), (unsigned long)n, most);
}

static void
turns_are_delaunay(session *s, const site *p, uint32_t n)
{
    check_divide(s, 'c', p, n);
}

static void
turns_are_cheap(session *s, const site *p, uint32_t n)
{
    check_divide(s, 'c', p, n);
    uint64_t tests = asked(s, WIRE_ORIENT) + asked(s, WIRE_INCIRCLE);
    expect(s, tests <= 20 * (uint64_t)n,
           "%llu orientation and incircle tests for %lu points; 20 n is %llu",
           (unsigned long long)tests, (unsigned long)n, 20 * (unsigned long long)n);
}

const property properties[] = {
    {"3.7-a", "delaunay", "The two triangulations become one, and that is Delaunay",
     "notes 3.7; page 3.7, sec3.7.P6", CASES_GENERAL | CASES_CONVEX, 40, 100, true,
     merge_is_delaunay},
    {"3.7-a", "degenerate",
     "The result is Delaunay, too, when points coincide, or lie on a line or circle",
     "page 3.7, sec3.7.P7 and where it breaks", CASES_DEGENERATE, 30, 200, true,
     merge_is_delaunay},
    {"3.7-a", "linear",
     "There are at most 16 questions for each point, left and right "
     "together",
     "page 3.7, sec3.7.P9", CASES_GENERAL | CASES_CONVEX | CASES_GRID, 80, 20, true,
     merge_is_linear},
    {"3.7-b", "delaunay", "The result is a Delaunay triangulation",
     "notes 3.7; page 3.7, sec3.7.P6", CASES_GENERAL | CASES_CONVEX, 60, 60, true,
     divide_is_delaunay},
    {"3.7-b", "degenerate",
     "The result is Delaunay, too, when points coincide, or lie on a line or circle",
     "page 3.7, where it breaks", CASES_DEGENERATE, 40, 200, true, divide_is_delaunay},
    {"3.7-b", "tests",
     "There are at most 6 n log2 n questions of all kinds, for random "
     "points",
     "page 3.7, sec3.7.P10", CASES_GENERAL, 250, 12, true, divide_is_cheap},
    {"3.7-c", "delaunay", "The result is a Delaunay triangulation",
     "page 3.7, sec3.7.P12", CASES_GENERAL | CASES_CONVEX | CASES_DEGENERATE, 40, 200,
     true, turns_are_delaunay},
    {"3.7-c", "tests",
     "There are at most 20 n orientation and incircle tests, for random "
     "points",
     "page 3.7, sec3.7.P15", CASES_GENERAL, 400, 16, true, turns_are_cheap},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
