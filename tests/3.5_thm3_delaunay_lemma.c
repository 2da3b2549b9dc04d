/* Definition 9 and Theorem 3, the Delaunay Lemma: if every edge of K is locally
 * Delaunay, then no site lies inside the circumcircle of a triangle of K; and
 * conversely.
 *
 * Hypotheses: K is a triangulation. No general position: "inside" is strict.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

static bool
every_edge_is_locally_delaunay(const mesh *m, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_in_triangle(m, e) && !is_locally_delaunay(m, points, e))
            return false;
    return true;
}

/* Is the circle of each triangle empty of all n points? By trying all of them. */
static bool
every_circle_is_empty(const mesh *m, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e += 3) {
        if (!mesh_in_triangle(m, e))
            continue;
        point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
        point2 c = points[mesh_apex(m, e)];
        for (vertex_id d = 0; d < m->points; d++)
            if (incircle(a, b, c, points[d]) > 0)
                return false;
    }
    return true;
}

/* Lawson's result and arbitrary triangulations: the two sides of the theorem are
 * true together or false together, and is_delaunay says which. */
static void
locally_delaunay_means_delaunay(const point2 *points, uint32_t n)
{
    mesh m;
    triangle_list list;
    verdict v;
    if (random_below(test_random_source(), 2) == 0)
        random_triangulation(points, n, &m);
    else
        CLAIM("thm3.P2", lawson_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    bool local = every_edge_is_locally_delaunay(&m, points);
    bool empty = every_circle_is_empty(&m, points);
    CLAIM("thm3.P2", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM("thm3.P2", is_delaunay(points, n, list, &v) == TRI_OK, "out of memory");
    triangle_list_free(&list);
    mesh_free(&m);
    CLAIM("thm3.P2", !local || empty,
          "all edges are locally Delaunay, some circle is not "
          "empty");
    CLAIM("thm3.P3", local || !empty, "all circles are empty, some edge is not locally "
          "Delaunay");
    CLAIM("thm3.P2", v.holds == empty, "is_delaunay says %s", v.because);
    CLAIM("thm3.P2", v.holds || v.witnesses == 4, "without four witnesses: %s",
          v.because);
}

/* ---- The walk of the proof, on whole numbers small enough for doubles. ---- */

/* The power of d with respect to the circle of t's corners, times twice the area. */
static double
scaled_power(const point2 *p, const mesh *m, halfedge_id t, vertex_id d, double *area)
{
    vertex_id v[3] = {mesh_origin(m, t), mesh_dest(m, t), mesh_apex(m, t)};
    double x[3], y[3], power = 0;
    for (int i = 0; i < 3; i++) {
        x[i] = p[v[i]].x - p[d].x;
        y[i] = p[v[i]].y - p[d].y;
    }
    *area = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        power -= (x[i] * x[i] + y[i] * y[i]) * (x[j] * y[k] - x[k] * y[j]);
        *area += x[j] * y[k] - x[k] * y[j];
    }
    return power;
}

/* P1, for every edge and not only those on a walk: where ab is locally Delaunay, a
 * site on d's side of ab has no greater power on that side of the edge. */
static void
power_does_not_increase(const point2 *drawn, uint32_t n)
{
    point2 *points = whole_points(drawn, n, 60);
    mesh m;
    random_triangulation(points, n, &m);
    for (halfedge_id ab = 0; ab < mesh_halfedges(&m); ab++) {
        if (!mesh_is_interior(&m, ab) || !is_locally_delaunay(&m, points, ab))
            continue;
        point2 a = points[mesh_origin(&m, ab)], b = points[mesh_dest(&m, ab)];
        for (vertex_id d = 0; d < n; d++) {
            if (orient2d(a, b, points[d]) > 0)
                continue; /* d is on c's side: the walk crosses the other way */
            double here_area, there_area;
            double here = scaled_power(points, &m, ab, d, &here_area);
            double there = scaled_power(points, &m, mesh_twin(&m, ab), d, &there_area);
            CLAIM("thm3.P1", here * there_area >= there * here_area,
                  "the power of %u grows from %g/%g to %g/%g", d, here, here_area,
                  there, there_area);
        }
    }
    mesh_free(&m);
    free(points);
}

/* ---- The errata. ---- */

/* E32: with "outside or on it" for "not inside", cocircular sites never end. A flip of
 * an edge with incircle = 0 gives an edge with incircle = 0. */
static void
e32_cocircular_edges_would_flip_for_ever(const point2 *points, uint32_t n)
{
    mesh m;
    CLAIM("E32", lawson_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    for (int round = 0; round < 1000; round++) {
        uint32_t flips = 0;
        for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
            if (!mesh_is_interior(&m, e))
                continue;
            CLAIM("E32", is_locally_delaunay(&m, points, e), "a tie is no defect");
            int sign = incircle(points[mesh_origin(&m, e)], points[mesh_dest(&m, e)],
                                points[mesh_apex(&m, e)],
                                points[mesh_apex(&m, mesh_twin(&m, e))]);
            if (sign >= 0) {
                flip(&m, e);
                flips++;
            }
        }
        CLAIM("E32", flips > 0, "round %d finds nothing to flip", round);
    }
    mesh_free(&m);
}

/* E36: an edge that is locally Delaunay and not Delaunay: every circle through its
 * ends has a site inside. */
static void
e36_local_is_not_global(void)
{
    const point2 p[] = {{1, 1}, {0, 3}, {0, 2}, {2, 2}, {1, 0}};
    vertex_id corner[][3] = {{0, 3, 1}, {0, 1, 4}, {0, 4, 3}, {1, 2, 4}};
    triangle_list list = {4, corner};
    verdict v;
    CLAIM("E36", is_triangulation(p, 5, list, &v) == TRI_OK, "out of memory");
    claim_verdict("E36", v);
    CLAIM("E36", incircle(p[0], p[3], p[1], p[4]) <= 0, "01 is not locally Delaunay");
    /* 01 is Delaunay when some circle through 0 and 1 is empty. The largest one that
     * keeps out the sites on its left goes through one of them; try each, on both
     * sides: some site is inside every time. */
    for (vertex_id c = 2; c < 5; c++) {
        bool empty = true;
        int side = orient2d(p[0], p[1], p[c]);
        for (vertex_id d = 2; d < 5; d++)
            empty = empty && side * incircle(p[0], p[1], p[c], p[d]) <= 0;
        CLAIM("E36", !empty, "the circle of 0, 1, %u is empty", c);
    }
}

int
main(int argc, char **argv)
{
    const point2 circle[] = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}};
    test_begin(argc, argv, "Theorem 3: locally Delaunay everywhere is Delaunay");
    test_random("locally Delaunay means Delaunay", locally_delaunay_means_delaunay,
                3000, 40);
    test_near_degenerate("locally Delaunay means Delaunay",
                         locally_delaunay_means_delaunay, 3000, 25);
    test_grid_subsets("locally Delaunay means Delaunay",
                      locally_delaunay_means_delaunay, 4);
    test_random("the power does not increase", power_does_not_increase, 1000, 30);
    test_points("E32: ties would flip for ever",
                e32_cocircular_edges_would_flip_for_ever, circle, 5);
    test_run("E36: local is not global", e36_local_is_not_global);
    return test_end((test_minima){.trials = 50000, .largest_n = 30, .zeros = 100000,
                                  .expansions = 1000, .wide = 1000});
}
