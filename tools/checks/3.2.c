/* 3.2.c - the properties of exercises 3.2-a and 3.2-b: empty circumcircles. */
#include "tools/checks/certify.h"
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/trees.h"
#include "tools/checks/room.h"

#include <stdlib.h>
#include <string.h>

/* ---- 3.2-a: the trivial algorithm. ---- */

static bool
is_variant(const session *s, const char *name)
{
    return strcmp(variant_of(s), name) == 0;
}

/* Definition 7 for counterclockwise a, b, c: the first point strictly inside, or NONE.
 * In the variant `farthest` no point may be strictly outside instead. */
static uint32_t
first_inside(const session *s, const site *p, uint32_t n, uint32_t a, uint32_t b,
             uint32_t c)
{
    int wrong = is_variant(s, "farthest") ? -1 : +1;
    for (uint32_t d = 0; d < n; d++)
        if (plane_incircle(p[a], p[b], p[c], p[d]) == wrong)
            return d;
    return NONE;
}

/* The triangles, counterclockwise if the student's have the orientation asked for. */
static triangle_list
ask_triangles(session *s, const site *p, uint32_t n)
{
    begin_case(s, 'a', p, n);
    give_points(s);
    if (!ask(s) || !take_ok(s))
        return (triangle_list){0};
    triangle_list list = take_triangles(s, n, n * n * n);
    take_end(s);
    for (uint32_t t = 0; is_variant(s, "clockwise") && t < list.count; t++) {
        vertex_id *c = list.corner[t], second = c[1];
        c[1] = c[2];
        c[2] = second;
    }
    return list;
}

static void
triangles_are_empty(session *s, const site *p, uint32_t n)
{
    triangle_list list = ask_triangles(s, p, n);
    if (failed(s))
        return;
    expect(s, list.count > 0 || cases_are_collinear(p, n), "no triangle is listed");
    for (uint32_t t = 0; t < list.count && !failed(s); t++) {
        const vertex_id *c = list.corner[t];
        uint32_t d = NONE;
        if (expect(s, plane_orient(p[c[0]], p[c[1]], p[c[2]]) > 0,
                   "triangle %lu-%lu-%lu is not %s", (unsigned long)c[0],
                   (unsigned long)c[1], (unsigned long)c[2],
                   is_variant(s, "clockwise") ? "clockwise" : "counterclockwise"))
            d = first_inside(s, p, n, c[0], c[1], c[2]);
        expect(s, failed(s) || d == NONE,
               "%lu lies %s the circle of triangle %lu-%lu-%lu", (unsigned long)d,
               is_variant(s, "farthest") ? "outside" : "inside", (unsigned long)c[0],
               (unsigned long)c[1], (unsigned long)c[2]);
        for (int i = 0; failed(s) && i < 3; i++)
            show_witness(s, c[i]);
        if (d != NONE)
            show_witness(s, d);
    }
}

/* Is a triangle of these three locations in the list; how often? */
static uint32_t
count_listed(triangle_list list, const site *p, const uint32_t v[3])
{
    uint32_t times = 0;
    for (uint32_t t = 0; t < list.count; t++) {
        int found = 0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                found += plane_same(p[v[i]], p[list.corner[t][j]]);
        times += found == 3;
    }
    return times;
}

/* All triples of locations, by the definition. */
static void
check_all(session *s, const site *p, uint32_t n, uint32_t most_times)
{
    triangle_list list = ask_triangles(s, p, n);
    uint32_t *at = room_for(n, sizeof *at);
    uint32_t u = cases_locations(p, n, at);
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = i + 1; j < u; j++)
            for (uint32_t k = j + 1; k < u && !failed(s); k++) {
                uint32_t v[3] = {at[i], at[j], at[k]};
                int sign = plane_orient(p[v[0]], p[v[1]], p[v[2]]);
                if (sign == 0 ||
                    first_inside(s, p, n, v[0], v[sign > 0 ? 1 : 2],
                                 v[sign > 0 ? 2 : 1]) != NONE)
                    continue;
                uint32_t times = count_listed(list, p, v);
                expect(s, times > 0 && times <= most_times,
                       "triangle %lu-%lu-%lu has %s circle, and is listed %lu times",
                       (unsigned long)v[0], (unsigned long)v[1], (unsigned long)v[2],
                       is_variant(s, "farthest") ? "an enclosing" : "an empty",
                       (unsigned long)times);
                for (int w = 0; failed(s) && w < 3; w++)
                    show_witness(s, v[w]);
            }
    free(at);
}

static void
triangles_are_all(session *s, const site *p, uint32_t n)
{
    check_all(s, p, n, UINT32_MAX);
}

static void
triangles_come_once(session *s, const site *p, uint32_t n)
{
    check_all(s, p, n, 1);
}

/* ---- 3.2-b: minimum spanning trees. ---- */

/* The points as distances are measured: in the variant `metric` a way up is twice as
 * long as it looks. */
static site *
measured(const session *s, const site *p, uint32_t n)
{
    site *q = calloc((size_t)n + 1, sizeof *q);
    if (q == NULL)
        exit(1);
    for (uint32_t i = 0; i < n; i++)
        q[i] = (site){p[i].x, is_variant(s, "metric") ? 2 * p[i].y : p[i].y};
    return q;
}

static void
check_tree(session *s, const site *p, uint32_t n, bool minimum)
{
    uint32_t *path = calloc((size_t)n + 1, sizeof *path);
    tree_edge *edge = calloc((size_t)n + 1, sizeof *edge);
    if (path == NULL || edge == NULL)
        exit(1);
    site *q = measured(s, p, n);
    triangle_list list = mesh_at_random(trial_random(s), q, n, true);
    keep_triangles(s, list);
    begin_case(s, 'b', p, n);
    give_points(s);
    if (list.count > 0)
        give_triangles(s, list);
    else
        give_path(s, path, path_of(p, n, path));
    if (ask(s) && take_ok(s)) {
        uint32_t count = take_number(s, 0, n, "the number of edges");
        for (uint32_t k = 0; k < count && !failed(s); k++) {
            edge[k].a = take_number(s, 0, n - 1, "the end of an edge");
            edge[k].b = take_number(s, 0, n - 1, "the end of an edge");
            if (!failed(s))
                show_edge(s, SVG_NEW, edge[k].a, edge[k].b);
        }
        take_end(s);
        if (!failed(s) && expect_verdict(s, certify_spanning(q, n, edge, count)) &&
            minimum)
            expect_verdict(s, certify_minimum(q, n, edge, count));
    }
    free(q);
    free(edge);
    free(path);
}

static void
tree_spans(session *s, const site *p, uint32_t n)
{
    check_tree(s, p, n, false);
}

static void
tree_is_minimum(session *s, const site *p, uint32_t n)
{
    check_tree(s, p, n, true);
}

const property properties[] = {
    {"3.2-a", "empty", "No point lies strictly inside the circle of a listed triangle",
     "notes 3.2, Definition 7; page 3.2, def7.P3",
     CASES_GENERAL | CASES_CONVEX | CASES_GRID | CASES_COCIRCULAR, 14, 150, false,
     triangles_are_empty},
    {"3.2-a", "all",
     "All triangles with an empty circle are listed, those of cocircular points too",
     "notes 3.2.1; page 3.2, erratum E22",
     CASES_GENERAL | CASES_CONVEX | CASES_GRID | CASES_COCIRCULAR, 14, 150, false,
     triangles_are_all},
    {"3.2-a", "copies", "Each is listed once, also where points coincide",
     "empty_circle.h, delaunay_triangles", CASES_DUPLICATES | CASES_GRID, 14, 150,
     false, triangles_come_once},
    {"3.2-b", "spanning", "The edges join all locations, without a cycle",
     "notes 3.2.2, Theorem 2", CASES_GENERAL | CASES_CONVEX, 24, 100, false,
     tree_spans},
    {"3.2-b", "minimum",
     "No two points are closer together than the longest edge between them in the tree",
     "notes 3.2.2, Theorem 2; page 3.2, thm2.P5",
     CASES_GENERAL | CASES_CONVEX | CASES_GRID | CASES_COCIRCULAR, 24, 100, false,
     tree_is_minimum},
    {"3.2-b", "degenerate",
     "The tree spans and is minimum, too, when points coincide or lie on a line",
     "page 3.2, where it breaks", CASES_DEGENERATE, 24, 200, false, tree_is_minimum},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
