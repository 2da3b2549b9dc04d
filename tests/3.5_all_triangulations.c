/* Theorems 3 and 4 over all triangulations of small sets, as the flip graph
 * lists them: a triangulation is Delaunay exactly when all its edges are
 * locally Delaunay, and exactly when no flip makes the smallest of six angles
 * larger; the Delaunay ones have the largest minimum angle, and the best sorted
 * angles are among them.
 *
 * Hypotheses: none. For angles the coordinates are whole numbers up to 1000, so
 * that cotangents are compared exactly (see harness/angles.h).
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "lib/mesh_build.h"
#include "tests/harness/angles.h"
#include "tests/harness/flip_graphs.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

static triangle_list
triangles_of(const flip_graph *g, const point2 *points, uint32_t node)
{
    triangle_list list;
    CLAIM("flipgraph.P2",
          flip_graph_triangles(g, points, node, &list) == TRI_OK,
          "out of memory");
    return list;
}

/* ---- Theorem 3. ---- */

/* Is the circle of each triangle empty of all n points? By trying all
 * of them. */
static bool
every_circle_is_empty(const point2 *points, uint32_t n, triangle_list list)
{
    for (uint32_t t = 0; t < list.count; t++)
        for (vertex_id d = 0; d < n; d++)
            if (incircle(points[list.corner[t][0]], points[list.corner[t][1]],
                         points[list.corner[t][2]], points[d]) > 0)
                return false;
    return true;
}

static void
locally_delaunay_means_delaunay(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    for (uint32_t node = 0; node < g.nodes; node++) {
        triangle_list list = triangles_of(&g, points, node);
        verdict v;
        bool empty = every_circle_is_empty(points, n, list);
        test_picture(list);
        CLAIM("thm3.P2", is_delaunay(points, n, list, &v) == TRI_OK,
              "out of memory");
        triangle_list_free(&list);
        CLAIM("thm3.P2", empty || !g.is_delaunay[node],
              "node %u: all edges are locally "
              "Delaunay, some circle is not empty",
              node);
        CLAIM("thm3.P3", !empty || g.is_delaunay[node],
              "node %u: all circles are empty, "
              "some edge is not locally Delaunay",
              node);
        CLAIM("thm3.P2", v.holds == empty, "node %u: is_delaunay says %s", node,
              v.because);
    }
    flip_graph_free(&g);
}

/* ---- Angles. ---- */

static int
compare_for_qsort(const void *s, const void *t)
{
    return compare_angles(*(const angle *)s, *(const angle *)t);
}

/* All angles of a triangulation, the smallest first. */
typedef struct angle_vector {
    uint32_t count;
    angle *angle;
} angle_vector;

static angle_vector
angles_of(const flip_graph *g, const point2 *points, uint32_t node)
{
    triangle_list list = triangles_of(g, points, node);
    angle_vector v = {0, malloc((list.count + 1) * 3 * sizeof *v.angle)};
    CLAIM("flipgraph.P10", v.angle != NULL, "out of memory");
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        v.angle[v.count++] =
            angle_at(points[side_origin(list, e)], points[side_dest(list, e)],
                     points[side_apex(list, e)]);
    triangle_list_free(&list);
    qsort(v.angle, v.count, sizeof *v.angle, compare_for_qsort);
    return v;
}

/* -1 when the first angle that differs is smaller in v, 0 when none
 * does, +1. */
static int
compare_vectors(angle_vector v, angle_vector w)
{
    int sign = 0;
    for (uint32_t i = 0; i < v.count && sign == 0; i++)
        sign = compare_angles(v.angle[i], w.angle[i]);
    return sign;
}

/* Node 0, which is Delaunay, and the best of all nodes against every other.
 * Returns how many Delaunay triangulations have other angles than node 0. */
static uint32_t
compare_all(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    angle_vector *vector = malloc(g.nodes * sizeof *vector);
    CLAIM("flipgraph.P10", vector != NULL, "out of memory");
    uint32_t best = 0, different = 0;
    for (uint32_t node = 0; node < g.nodes; node++) {
        vector[node] = angles_of(&g, points, node);
        if (compare_vectors(vector[node], vector[best]) > 0)
            best = node;
    }
    for (uint32_t node = 0; node < g.nodes; node++) {
        if (vector[node].count > 0) {
            int sign =
                compare_angles(vector[node].angle[0], vector[0].angle[0]);
            CLAIM("thm4.P3", sign <= 0, "node %u has a larger minimum angle",
                  node);
            CLAIM("E39", sign == 0 || !g.is_delaunay[node],
                  "node %u is Delaunay and has "
                  "a smaller minimum angle",
                  node);
        }
        bool is_best = compare_vectors(vector[node], vector[best]) == 0;
        CLAIM("flipgraph.P10", !is_best || g.is_delaunay[node],
              "node %u has the best "
              "angles and is not Delaunay",
              node);
        different += g.is_delaunay[node] &&
                     compare_vectors(vector[node], vector[0]) != 0;
    }
    for (uint32_t node = 0; node < g.nodes; node++)
        free(vector[node].angle);
    free(vector);
    flip_graph_free(&g);
    return different;
}

static void
delaunay_has_the_best_angles(const point2 *points, uint32_t n)
{
    compare_all(points, n);
}

/* Six cocircular points: every triangulation is Delaunay, not all are
 * the best. */
static void
e39_angles_differ(const point2 *points, uint32_t n)
{
    uint32_t different = compare_all(points, n);
    CLAIM("E39", different > 0,
          "all Delaunay triangulations have the same angles");
}

/* ---- Sibson's local equiangularity. ---- */

/* The smallest angle of the triangles abc and bad. */
static angle
smallest_of_six(point2 a, point2 b, point2 c, point2 d)
{
    const angle six[] = {angle_at(a, b, c), angle_at(b, c, a),
                         angle_at(c, a, b), angle_at(b, a, d),
                         angle_at(a, d, b), angle_at(d, b, a)};
    angle least = six[0];
    for (int i = 1; i < 6; i++)
        if (compare_angles(six[i], least) < 0)
            least = six[i];
    return least;
}

/* Does the flip of ab make the smallest of the six angles larger (+1), does it
 * leave it (0), or make it smaller (-1)? */
static int
gain_of_flip(const mesh *m, const point2 *points, halfedge_id ab)
{
    point2 a = points[mesh_origin(m, ab)], b = points[mesh_dest(m, ab)];
    point2 c = points[mesh_apex(m, ab)],
           d = points[mesh_apex(m, mesh_twin(m, ab))];
    return compare_angles(smallest_of_six(d, c, a, b),
                          smallest_of_six(a, b, c, d));
}

static void
delaunay_is_locally_equiangular(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    for (uint32_t node = 0; node < g.nodes; node++) {
        triangle_list list = triangles_of(&g, points, node);
        mesh m = {0};
        CLAIM("flipgraph.P11",
              list.count == 0 || mesh_from_triangles(n, list, &m) == TRI_OK,
              "out of memory");
        triangle_list_free(&list);
        bool equiangular = true;
        for (halfedge_id ab = 0; ab < mesh_halfedges(&m); ab++) {
            if (!is_flippable(&m, points, ab))
                continue;
            int gain = gain_of_flip(&m, points, ab);
            CLAIM("flipgraph.P11",
                  (gain > 0) == !is_locally_delaunay(&m, points, ab),
                  "the flip of %u %u gains %d", mesh_origin(&m, ab),
                  mesh_dest(&m, ab), gain);
            equiangular = equiangular && gain <= 0;
        }
        mesh_free(&m);
        CLAIM("flipgraph.P11", equiangular == g.is_delaunay[node],
              "node %u is %slocally "
              "equiangular",
              node, equiangular ? "" : "not ");
    }
    flip_graph_free(&g);
}

/* ---- On whole numbers: small ones for ties, larger ones for none. ---- */

static void
on_whole_points(property *p, uint32_t n)
{
    static const uint32_t most[] = {3, 6, 1000};
    point2 *points =
        whole_points(NULL, n, most[random_below(test_random_source(), 3)]);
    p(points, n);
    free(points);
}

static void
best_angles_of_whole_points(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    on_whole_points(delaunay_has_the_best_angles, n);
}

static void
equiangular_whole_points(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    on_whole_points(delaunay_is_locally_equiangular, n);
}

int
main(int argc, char **argv)
{
    const point2 circle[] = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-5, 0}, {0, -5}};
    test_begin(argc, argv,
               "Theorems 3 and 4 over all triangulations of small sets");
    test_random("locally Delaunay means Delaunay",
                locally_delaunay_means_delaunay, 1000, 8);
    test_near_degenerate("locally Delaunay means Delaunay",
                         locally_delaunay_means_delaunay, 1000, 8);
    test_grid_subsets("locally Delaunay means Delaunay",
                      locally_delaunay_means_delaunay, 3);
    test_random("the best angles", best_angles_of_whole_points, 1000, 8);
    test_grid_subsets("the best angles", delaunay_has_the_best_angles, 3);
    test_random("locally equiangular", equiangular_whole_points, 1000, 8);
    test_grid_subsets("locally equiangular", delaunay_is_locally_equiangular,
                      3);
    test_points("E39: the angles differ", e39_angles_differ, circle, 6);
    return test_end((test_minima){.trials = 5000,
                                  .largest_n = 8,
                                  .zeros = 100000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
