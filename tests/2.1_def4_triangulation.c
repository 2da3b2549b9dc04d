/* Definition 4: is_triangulation accepts exactly the triangulations, and every
 * algorithm makes one.
 *
 * Hypotheses: none for the algorithms. To compare the checker with the definition,
 * small whole coordinates: then this file can decide Definition 4 by adding up
 * areas and comparing all pairs.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/contents.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

#include <stdlib.h>

/* ---- Every algorithm. ---- */

static void
every_algorithm_triangulates(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < contents_count; i++) {
        if (n > contents[i].most)
            continue;
        mesh m;
        triangle_list list;
        verdict v;
        tri_status status = contents[i].triangulate(points, n, NULL, &m);
        CLAIM("def4.P3", status == TRI_OK, "%s: %s", contents[i].name,
              tri_status_text(status));
        claim_verdict("def4.P3", mesh_check(&m));
        CLAIM("def4.P3", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
        test_picture(list);
        predicate_counts before = predicate_count;
        CLAIM("def4.P3", is_triangulation(points, n, list, &v) == TRI_OK,
              "out of memory");
        uint64_t tests = predicate_count.orient2d - before.orient2d;
        uint64_t comparisons = predicate_count.compare_along - before.compare_along;
        uint64_t t = list.count, h = mesh_hull_size(&m);
        CLAIM("def4.P6", t == 0 || (tests <= t + h && comparisons <= 2 * n + 4 * h),
              "%llu tests and %llu comparisons for t = %llu, h = %llu, n = %u",
              (unsigned long long)tests, (unsigned long long)comparisons,
              (unsigned long long)t, (unsigned long long)h, n);
        triangle_list_free(&list);
        mesh_free(&m);
        claim_verdict("def4.P3", v);
    }
}

/* ---- Definition 4 by brute force, on integers. ---- */

static double
twice_area(const point2 *p, const vertex_id *c)
{
    return (p[c[1]].x - p[c[0]].x) * (p[c[2]].y - p[c[0]].y) -
           (p[c[1]].y - p[c[0]].y) * (p[c[2]].x - p[c[0]].x);
}

/* Twice the area of the convex hull: of each two points with all others on the left
 * of their line or on it, the triangle they make with point 0; along a line only
 * the two farthest count, which are those with nothing beyond them. */
static double
twice_hull_area(const point2 *p, uint32_t n)
{
    double sum = 0;
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = 0; b < n; b++) {
            bool edge = a != b;
            for (vertex_id c = 0; c < n && edge; c++) {
                double side = twice_area(p, (vertex_id[]){a, b, c});
                double inside = (p[c].x - p[a].x) * (p[c].x - p[b].x) +
                                (p[c].y - p[a].y) * (p[c].y - p[b].y);
                edge = side > 0 || (side == 0 && inside <= 0);
            }
            if (edge)
                sum += twice_area(p, (vertex_id[]){0, a, b});
        }
    return sum;
}

static simplex
sorted(vertex_id a, vertex_id b, vertex_id c)
{
    vertex_id low = a < b ? a : b, high = a < b ? b : a;
    if (c < low)
        return (simplex){2, {c, low, high}};
    return c < high ? (simplex){2, {low, c, high}} : (simplex){2, {low, high, c}};
}

static bool
is_triangulation_by_definition(const point2 *p, uint32_t n, triangle_list list)
{
    double area = 0;
    bool holds = true;
    bool *used = calloc(n + 1, sizeof *used);
    simplex *triangle = malloc((list.count + 1) * sizeof *triangle);
    for (uint32_t t = 0; t < list.count && holds; t++) {
        const vertex_id *c = list.corner[t];
        double a = twice_area(p, c);
        area += a;
        holds = a > 0;
        used[c[0]] = used[c[1]] = used[c[2]] = true;
        triangle[t] = sorted(c[0], c[1], c[2]);
        for (uint32_t s = 0; s < t; s++)
            holds = holds && !(simplex_is_face(triangle[s], triangle[t]));
    }
    for (vertex_id v = 0; v < n && list.count > 0; v++)
        holds = holds && used[v];
    simplex_list K = {0};
    if (holds && simplex_closure((simplex_list){list.count, triangle}, &K) == TRI_OK)
        holds = is_complex(p, n, K).holds; /* see 2.1_def3_complex.c */
    simplex_list_free(&K);
    free(triangle);
    free(used);
    return holds && area == twice_hull_area(p, n);
}

/* ---- The checker against the definition, on lists with a few faults. ---- */

static void
spoil(triangle_list *list, uint32_t n, random_source *r)
{
    uint32_t t = random_below(r, list->count), s = random_below(r, list->count);
    uint32_t wrong = random_below(r, 3);
    vertex_id *c = list->corner[t];
    switch (random_below(r, 5)) {
    case 0: /* a triangle is missing */
        for (int i = 0; i < 3; i++)
            c[i] = list->corner[list->count - 1][i];
        list->count--;
        break;
    case 1: /* a corner is wrong */
        c[wrong] = random_below(r, n);
        break;
    case 2: /* a triangle is clockwise */
        c[0] ^= c[1], c[1] ^= c[0], c[0] ^= c[1];
        break;
    case 3: /* one triangle twice, another not at all */
        for (int i = 0; i < 3; i++)
            c[i] = list->corner[s][i];
        break;
    default: /* another first corner: no fault */
        c[0] ^= c[1], c[1] ^= c[0], c[0] ^= c[1];
        c[1] ^= c[2], c[2] ^= c[1], c[1] ^= c[2];
    }
}

static bool
all_distinct(const point2 *p, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < i; j++)
            if (p[i].x == p[j].x && p[i].y == p[j].y)
                return false;
    return true;
}

static void
accepts_exactly_the_triangulations(const point2 *points, uint32_t n)
{
    HYPOTHESIS(all_distinct(points, n)); /* here each index is a vertex */
    random_source *r = test_random_source();
    for (int repeat = 0; repeat < 2; repeat++) {
        mesh m;
        triangle_list list;
        verdict v;
        CLAIM("def4.P4", sweep_triangulate(points, n, NULL, &m) == TRI_OK &&
              mesh_triangles(&m, &list) == TRI_OK, "no triangles");
        mesh_free(&m);
        for (uint32_t faults = random_below(r, 4); faults > 0 && list.count > 0;
             faults--)
            spoil(&list, n, r);
        bool expected = is_triangulation_by_definition(points, n, list);
        tri_status status = is_triangulation(points, n, list, &v);
        test_picture(list);
        triangle_list_free(&list);
        CLAIM("def4.P4", status == TRI_OK, "%s", tri_status_text(status));
        CLAIM("def4.P4", !v.holds || expected, "accepted, and is no triangulation");
        CLAIM("def4.P5", v.holds || !expected, "refused although it is one: %s",
              v.because);
    }
}

/* ---- P1: how often a point is covered, and how often it is run around. ---- */

static int
side(point2 a, point2 b, point2 q)
{
    double det = (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
    return (det > 0) - (det < 0);
}

/* What the side from a to b adds to the winding number around q: it is counted where
 * it crosses the ray that runs from q to the right. */
static int
crosses_ray(point2 a, point2 b, point2 q)
{
    if (a.y <= q.y && q.y < b.y)
        return side(a, b, q) > 0;
    if (b.y <= q.y && q.y < a.y)
        return -(side(a, b, q) < 0);
    return 0;
}

/* Up to eight random counterclockwise triangles, no two along one directed side. */
static uint32_t
random_triangles(const point2 *p, uint32_t n, vertex_id corner[8][3], halfedge_id *twin)
{
    uint32_t count = 0;
    halfedge_id repeated;
    for (int tries = 0; tries < 24 && count < 8; tries++) {
        vertex_id *c = corner[count];
        for (int i = 0; i < 3; i++)
            c[i] = random_below(test_random_source(), n);
        if (twice_area(p, c) <= 0)
            continue;
        triangle_list list = {count + 1, corner};
        CLAIM("def4.P1", triangle_list_twins(list, twin, &repeated) == TRI_OK,
              "memory");
        count += repeated == NONE;
    }
    CLAIM("def4.P1",
          triangle_list_twins((triangle_list){count, corner}, twin, &repeated) ==
              TRI_OK,
          "memory");
    return count;
}

static void
covered_as_often_as_run_around(const point2 *p, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    vertex_id corner[8][3];
    halfedge_id twin[24];
    triangle_list list = {random_triangles(p, n, corner, twin), corner};
    test_picture(list);
    for (int x = 0; x < 3; x++)
        for (int y = 0; y < 3; y++) {
            point2 q = {x + 0.37, y + 0.41}; /* on no line of the grid */
            int covered = 0, winding = 0;
            for (uint32_t t = 0; t < list.count; t++) {
                point2 a = p[corner[t][0]], b = p[corner[t][1]], c = p[corner[t][2]];
                covered += side(a, b, q) > 0 && side(b, c, q) > 0 && side(c, a, q) > 0;
            }
            for (halfedge_id e = 0; e < 3 * list.count; e++)
                if (twin[e] == NONE)
                    winding += crosses_ray(p[side_origin(list, e)],
                                           p[side_dest(list, e)], q);
            CLAIM("def4.P1", covered == winding,
                  "(%g,%g) lies in %d triangles, and the "
                  "boundary winds %d times around it",
                  q.x, q.y, covered, winding);
        }
}

/* ---- Single cases. ---- */

static verdict
check(const point2 *points, uint32_t n, vertex_id (*corner)[3], uint32_t count)
{
    verdict v;
    tri_status status = is_triangulation(points, n, (triangle_list){count, corner}, &v);
    CLAIM("def4.P4", status == TRI_OK, "%s", tri_status_text(status));
    return v;
}

/* A boundary that always turns left, and runs around twice. */
static void
a_pentagram_is_no_hull(void)
{
    const point2 points[] = {{0, 0}, {10, 0}, {3, 10}, {-8, 6}, {-8, -6}, {3, -10}};
    vertex_id corner[5][3];
    for (vertex_id i = 0; i < 5; i++) {
        corner[i][0] = 0;
        corner[i][1] = 1 + i;
        corner[i][2] = 1 + (i + 2) % 5;
    }
    verdict v = check(points, 6, corner, 5);
    CLAIM("def4.P2", !v.holds, "five triangles that cover the middle twice");
    CLAIM("def4.P2", v.witnesses > 0, "without a witness");
}

static void
faults_have_witnesses(void)
{
    const point2 p[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    const point2 q[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 2}};
    vertex_id bay[][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}};
    vertex_id twice[][3] = {{0, 1, 2}, {0, 1, 3}};
    vertex_id clockwise[][3] = {{0, 1, 2}, {0, 3, 2}};
    vertex_id two_names[][3] = {{0, 1, 2}, {0, 4, 3}};
    vertex_id beyond[][3] = {{0, 1, 9}};
    vertex_id touching[][3] = {{0, 1, 4}, {4, 2, 3}};
    /* Vertex 4 lies inside the edge 02 of one triangle; a flat one sews it up. */
    vertex_id sewn[][3] = {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}, {0, 2, 4}};
    CLAIM("def4.P2", check(p, 5, bay, 3).witness[0] == 4, "the bay at vertex 4");
    CLAIM("def4.P4", !check(p, 4, twice, 2).holds, "two triangles left of one edge");
    CLAIM("def4.P3", check(p, 4, clockwise, 2).witnesses == 3, "a clockwise triangle");
    CLAIM("def4.P4", check(q, 5, two_names, 2).witnesses == 2,
          "one point, two vertices");
    CLAIM("def4.P3", !check(p, 4, beyond, 1).holds, "vertex 9 of 4");
    CLAIM("def4.P2", !check(p, 5, touching, 2).holds, "two triangles at a vertex");
    CLAIM("def4.P4", check(p, 5, sewn, 4).witnesses == 3, "a flat triangle");
    CLAIM("def4.P3", check(p, 4, NULL, 0).witnesses == 3, "no triangle for a square");
}

static void
e3_collinear_points_have_no_triangle(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {2, 0}};
    vertex_id flat[][3] = {{0, 1, 2}};
    CLAIM("E3", check(points, 3, NULL, 0).holds, "the empty list is refused");
    CLAIM("E3", !check(points, 3, flat, 1).holds, "a flat triangle is accepted");
    /* And V must be used: (1,1) below is no vertex of the two triangles. */
    const point2 square[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    vertex_id two[][3] = {{0, 1, 2}, {0, 2, 3}};
    verdict v = check(square, 5, two, 2);
    CLAIM("E3", !v.holds && v.witness[0] == 4, "an unused point is accepted");
}

static void
memory_may_run_out(void)
{
    const point2 p[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    vertex_id corner[][3] = {{0, 1, 2}, {0, 2, 3}};
    triangle_list list = {2, corner};
    verdict v;
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = is_triangulation(p, 4, list, &v);
        memory_fail_at(0);
    }
    CLAIM("def4.P4", status == TRI_OK && v.holds, "%s", tri_status_text(status));
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Definition 4: V is the vertex set of T, |T| its convex hull");
    test_random("every algorithm", every_algorithm_triangulates, 2000, 60);
    test_near_degenerate("every algorithm", every_algorithm_triangulates, 1000, 20);
    test_grid_subsets("every algorithm", every_algorithm_triangulates, 4);
    test_grid_subsets("exactly the triangulations", accepts_exactly_the_triangulations,
                      4);
    test_grid_subsets("covered as often as run around", covered_as_often_as_run_around,
                      4);
    test_run("a pentagram", a_pentagram_is_no_hull);
    test_run("faults have witnesses", faults_have_witnesses);
    test_run("E3: collinear points", e3_collinear_points_have_no_triangle);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 60000, .largest_n = 50, .zeros = 100000,
                                  .expansions = 1000, .wide = 1000});
}
