/* The graphs between the nearest neighbours and Delaunay: each is exactly what
 * its definition says of all sites, and each lies inside the next.
 *
 * Hypotheses: none; of copies of a site the lowest index is its vertex.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "tests/harness/start.h"

#include <stdlib.h>

typedef tri_status graph_of(const mesh *m, const point2 *points,
                            edge_list *out);

static edge_list
graph(graph_of *make, const mesh *m, const point2 *points)
{
    edge_list list;
    tri_status status = make(m, points, &list);
    CLAIM("graphs.P5", status == TRI_OK, "%s", tri_status_text(status));
    for (uint32_t i = 0; i + 1 < list.count; i++) {
        const vertex_id *e = list.ends[i], *f = list.ends[i + 1];
        CLAIM("graphs.P5",
              e[0] < e[1] && (e[0] < f[0] || (e[0] == f[0] && e[1] < f[1])),
              "%u %u stands before %u %u", e[0], e[1], f[0], f[1]);
    }
    return list;
}

static bool
is_among(edge_list list, vertex_id v, vertex_id w)
{
    for (uint32_t i = 0; i < list.count; i++)
        if (list.ends[i][0] == v && list.ends[i][1] == w)
            return true;
    return false;
}

/* ---- The definitions, of all sites. ---- */

static bool
in_lune(const point2 *points, vertex_id v, vertex_id w, vertex_id z)
{
    point2 p = points[v], q = points[w], r = points[z];
    return compare_distance(p, r, p, q) < 0 && compare_distance(q, r, p, q) < 0;
}

static bool
is_relative_neighbour(const point2 *points, const vertex_id *site, uint32_t u,
                      vertex_id v, vertex_id w)
{
    for (uint32_t i = 0; i < u; i++)
        if (in_lune(points, v, w, site[i]))
            return false;
    return true;
}

static bool
is_gabriel(const point2 *points, const vertex_id *site, uint32_t u, vertex_id v,
           vertex_id w)
{
    for (uint32_t i = 0; i < u; i++)
        if (site[i] != v && site[i] != w &&
            dot_sign(points[v], points[site[i]], points[w]) <= 0)
            return false;
    return true;
}

static bool
is_nearest_of(const point2 *points, const vertex_id *site, uint32_t u,
              vertex_id v, vertex_id w)
{
    for (uint32_t i = 0; i < u; i++)
        if (site[i] != v && compare_distance(points[v], points[site[i]],
                                             points[v], points[w]) < 0)
            return false;
    return true;
}

static void
graphs_are_as_defined(const point2 *points, uint32_t n)
{
    const point2 along_x = {1, 0};
    vertex_id *site = malloc((n + 1) * sizeof *site);
    uint32_t u;
    CLAIM("graphs.P5", sort_along(points, n, along_x, site, &u) == TRI_OK,
          "no order");
    mesh m = random_delaunay(points, n);
    edge_list gabriel = graph(gabriel_graph, &m, points);
    edge_list rng = graph(relative_neighbourhood_graph, &m, points);
    edge_list nng = graph(nearest_neighbour_graph, &m, points);
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = 0; j < u; j++) {
            vertex_id v = site[i], w = site[j];
            if (v >= w)
                continue;
            CLAIM("graphs.P1",
                  is_among(gabriel, v, w) == is_gabriel(points, site, u, v, w),
                  "Gabriel: %u %u", v, w);
            CLAIM("graphs.P4",
                  is_among(rng, v, w) ==
                      is_relative_neighbour(points, site, u, v, w),
                  "lune: %u %u", v, w);
            CLAIM("graphs.P5",
                  is_among(nng, v, w) ==
                      (is_nearest_of(points, site, u, v, w) ||
                       is_nearest_of(points, site, u, w, v)),
                  "nearest: %u %u", v, w);
        }
    edge_list_free(&gabriel);
    edge_list_free(&rng);
    edge_list_free(&nng);
    free(site);
    mesh_free(&m);
}

/* ---- Each lies inside the next. ---- */

static void
expect_inside(edge_list inner, edge_list outer, const char *which)
{
    for (uint32_t i = 0; i < inner.count; i++) {
        vertex_id v = inner.ends[i][0], w = inner.ends[i][1];
        CLAIM("graphs.P6", is_among(outer, v, w), "%s: %u %u", which, v, w);
    }
}

static void
the_chain_holds(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    edge_list tree, delaunay;
    CLAIM("graphs.P6",
          mesh_edges(&m, NULL, &delaunay) == TRI_OK &&
              emst(&m, points, &tree) == TRI_OK,
          "out of memory");
    edge_list gabriel = graph(gabriel_graph, &m, points);
    edge_list rng = graph(relative_neighbourhood_graph, &m, points);
    edge_list nng = graph(nearest_neighbour_graph, &m, points);
    expect_inside(nng, rng, "nearest, but no relative neighbours");
    expect_inside(tree, rng, "in the tree, but no relative neighbours");
    expect_inside(rng, gabriel, "relative neighbours, but not Gabriel");
    expect_inside(gabriel, delaunay, "Gabriel, but not Delaunay");
    edge_list_free(&tree);
    edge_list_free(&delaunay);
    edge_list_free(&gabriel);
    edge_list_free(&rng);
    edge_list_free(&nng);
    mesh_free(&m);
}

/* ---- P2 and P3: elimination paths, seen from the edge. ---- */

/* Do the open segments ab and cd cross? */
static bool
cross(const point2 *points, vertex_id a, vertex_id b, vertex_id c, vertex_id d)
{
    point2 p = points[a], q = points[b], r = points[c], s = points[d];
    return orient2d(p, q, r) * orient2d(p, q, s) < 0 &&
           orient2d(r, s, p) * orient2d(r, s, q) < 0;
}

static bool
in_triangle(const point2 *points, vertex_id a, vertex_id b, vertex_id c,
            vertex_id z)
{
    int turn = orient2d(points[a], points[b], points[c]);
    return orient2d(points[a], points[b], points[z]) * turn >= 0 &&
           orient2d(points[b], points[c], points[z]) * turn >= 0 &&
           orient2d(points[c], points[a], points[z]) * turn >= 0;
}

/* Is z in the lune of vw, no other site as near to both v and w, and none in
 * the triangle of the three? The site with the shortest way from v over it to w
 * is such. */
static bool
is_best_eliminator(const mesh *m, const point2 *points, vertex_id v,
                   vertex_id w, vertex_id z)
{
    if (mesh_leaving(m, z) == NONE || !in_lune(points, v, w, z))
        return false;
    point2 p = points[v], q = points[w], r = points[z];
    for (vertex_id k = 0; k < m->points; k++) {
        if (k == v || k == w || k == z || mesh_leaving(m, k) == NONE)
            continue;
        bool as_near = compare_distance(p, points[k], p, r) <= 0 &&
                       compare_distance(q, points[k], q, r) <= 0;
        if (as_near || in_triangle(points, v, w, z, k))
            return false;
    }
    return true;
}

/* Does the edge ab run between z and vw: from one side of the triangle zvw at
 * z, or from its end, across to the other? */
static bool
runs_between(const point2 *points, vertex_id a, vertex_id b, vertex_id v,
             vertex_id w, vertex_id z)
{
    if (a == z || b == z)
        return false;
    bool crosses_zv = cross(points, a, b, z, v),
         crosses_zw = cross(points, a, b, z, w);
    bool at_v = a == v || b == v, at_w = a == w || b == w;
    return (crosses_zv && crosses_zw) || (at_v && crosses_zw) ||
           (at_w && crosses_zv);
}

/* P2: the best site of a lune is in the lune of each edge on its way. */
static void
the_best_site_eliminates_all_on_its_way(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
        vertex_id v = mesh_origin(&m, e), w = mesh_dest(&m, e);
        if (v >= w || w == GHOST)
            continue;
        for (vertex_id z = 0; z < n; z++) {
            if (!is_best_eliminator(&m, points, v, w, z))
                continue;
            for (halfedge_id f = 0; f < mesh_halfedges(&m); f++) {
                vertex_id a = mesh_origin(&m, f), b = mesh_dest(&m, f);
                if (a < b && b != GHOST && runs_between(points, a, b, v, w, z))
                    CLAIM("graphs.P2", in_lune(points, a, b, z),
                          "%u eliminates %u %u, but not %u %u on the way", z, v,
                          w, a, b);
            }
        }
    }
    mesh_free(&m);
}

/* z lies behind the edge ab of the triangle abc and is in the lunes of ab and
 * of ac, with b on its side of ac: then ac is longer than bc. */
static void
only_the_longer_edge_is_next(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
        if (!mesh_in_triangle(&m, e))
            continue;
        for (int other = 0; other < 2; other++) {
            /* ab is side e, and ac one of the other two; b is the far end of
             * ab. */
            vertex_id a = other == 0 ? mesh_origin(&m, e) : mesh_dest(&m, e);
            vertex_id b = other == 0 ? mesh_dest(&m, e) : mesh_origin(&m, e);
            vertex_id c = mesh_apex(&m, e);
            for (vertex_id z = 0; z < n; z++) {
                point2 p = points[z];
                int at_ab = orient2d(points[a], points[b], p);
                int at_ac = orient2d(points[a], points[c], p);
                int b_at_ac = orient2d(points[a], points[c], points[b]);
                int c_at_ab = orient2d(points[a], points[b], points[c]);
                if (at_ab * c_at_ab < 0 && at_ac * b_at_ac > 0 &&
                    in_lune(points, a, b, z) && in_lune(points, a, c, z))
                    CLAIM("graphs.P3",
                          compare_distance(points[a], points[c], points[b],
                                           points[c]) > 0,
                          "%u goes on over %u %u, and %u %u is as long", z, a,
                          c, b, c);
            }
        }
    }
    mesh_free(&m);
}

/* ---- Costs, and numbers to compare with. ---- */

/* A test of a lune eliminates an edge or ends a path; there are three paths for
 * each triangle. A lune takes two comparisons, the next edge takes one for each
 * side. */
static void
the_costs_are_as_counted(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    edge_list delaunay, rng;
    CLAIM("graphs.P4", mesh_edges(&m, NULL, &delaunay) == TRI_OK,
          "out of memory");
    uint64_t before = predicate_count.compare_distance;
    rng = graph(relative_neighbourhood_graph, &m, points);
    uint64_t comparisons = predicate_count.compare_distance - before;
    uint64_t eliminated = delaunay.count - rng.count, triangles = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e += 3)
        triangles += mesh_in_triangle(&m, e);
    CLAIM("graphs.P4",
          comparisons <= 2 * (3 * triangles + eliminated) + 2 * eliminated,
          "%llu comparisons, %llu triangles, %llu edges eliminated",
          (unsigned long long)comparisons, (unsigned long long)triangles,
          (unsigned long long)eliminated);
    before = predicate_count.dot_sign;
    edge_list gabriel = graph(gabriel_graph, &m, points);
    CLAIM("graphs.P1",
          predicate_count.dot_sign - before <= 2 * (uint64_t)delaunay.count,
          "more than two tests for an edge");
    edge_list_free(&gabriel);
    edge_list_free(&delaunay);
    edge_list_free(&rng);
    mesh_free(&m);
}

/* The known expectations for uniform points: Gabriel 2 edges a site, relative
 * neighbours 1.279, up to what the border and chance take away. */
static void
uniform_densities_are_known(void)
{
    enum { N = 20000 };
    point2 *points = malloc(N * sizeof *points);
    for (uint32_t i = 0; i < N; i++)
        points[i] = random_point(test_random_source());
    mesh m = random_delaunay(points, N);
    edge_list gabriel = graph(gabriel_graph, &m, points);
    edge_list rng = graph(relative_neighbourhood_graph, &m, points);
    double g = (double)gabriel.count / N, r = (double)rng.count / N;
    CLAIM("graphs.P6", g > 1.96 && g < 2.02, "%g Gabriel edges a site", g);
    CLAIM("graphs.P6", r > 1.25 && r < 1.30, "%g relative neighbours a site",
          r);
    edge_list_free(&gabriel);
    edge_list_free(&rng);
    mesh_free(&m);
    free(points);
}

/* E24: with the open disc both diagonals of the unit square would be edges. */
static void
the_unit_square(void)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    CLAIM("E24",
          dot_sign(square[0], square[1], square[2]) == 0 &&
              dot_sign(square[0], square[3], square[2]) == 0 &&
              dot_sign(square[1], square[0], square[3]) == 0 &&
              dot_sign(square[1], square[2], square[3]) == 0,
          "a corner is not on the circle");
    CLAIM("E24", cross(square, 0, 2, 1, 3), "the diagonals do not cross");
    for (int tries = 0; tries < 20; tries++) {
        mesh m = random_delaunay(square, 4);
        edge_list gabriel = graph(gabriel_graph, &m, square);
        edge_list rng = graph(relative_neighbourhood_graph, &m, square);
        edge_list nng = graph(nearest_neighbour_graph, &m, square);
        CLAIM("E24", gabriel.count == 4 && rng.count == 4 && nng.count == 4,
              "%u, %u, %u edges", gabriel.count, rng.count, nng.count);
        CLAIM("E24", !is_among(gabriel, 0, 2) && !is_among(gabriel, 1, 3),
              "a diagonal");
        edge_list_free(&gabriel);
        edge_list_free(&rng);
        edge_list_free(&nng);
        mesh_free(&m);
    }
}

/* The edge 0 1 is eliminated by 4 alone, which is a Delaunay neighbour of
 * neither. */
static void
neighbours_do_not_suffice(void)
{
    const point2 points[] = {{7, 0}, {6, 7}, {5, 0}, {2, 5}, {1, 3}};
    mesh m = random_delaunay(points, 5);
    edge_list delaunay, rng = graph(relative_neighbourhood_graph, &m, points);
    CLAIM("graphs.P4", mesh_edges(&m, NULL, &delaunay) == TRI_OK,
          "out of memory");
    CLAIM("graphs.P4",
          is_among(delaunay, 0, 1) && !is_among(delaunay, 0, 4) &&
              !is_among(delaunay, 1, 4),
          "another triangulation");
    for (vertex_id z = 2; z < 5; z++)
        CLAIM("graphs.P4", in_lune(points, 0, 1, z) == (z == 4), "%u", z);
    CLAIM("graphs.P4", !is_among(rng, 0, 1), "0 1 is still there");
    edge_list_free(&delaunay);
    edge_list_free(&rng);
    mesh_free(&m);
}

static void
memory_may_run_out(void)
{
    const point2 points[] = {{0, 0}, {2, 0}, {2, 3}, {0, 2}, {1, 5}, {7, 2}};
    graph_of *const make[] = {gabriel_graph, relative_neighbourhood_graph,
                              nearest_neighbour_graph};
    mesh m = random_delaunay(points, 6);
    for (int which = 0; which < 3; which++) {
        edge_list list;
        tri_status status = TRI_OUT_OF_MEMORY;
        unsigned long k = 0;
        while (status != TRI_OK) {
            memory_fail_at(++k);
            status = make[which](&m, points, &list);
            memory_fail_at(0);
            CLAIM("graphs.P5",
                  status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                                       list.ends == NULL && list.count == 0),
                  "allocation %lu", k);
        }
        CLAIM("graphs.P5", k > 2, "%lu allocations", k - 1);
        edge_list_free(&list);
    }
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "graphs of neighbours: as defined, each inside the next");
    test_random("as defined", graphs_are_as_defined, 3000, 40);
    test_near_degenerate("as defined", graphs_are_as_defined, 2000, 20);
    test_grid_subsets("as defined", graphs_are_as_defined, 4);
    test_random("the chain", the_chain_holds, 1000, 60);
    test_near_degenerate("the chain", the_chain_holds, 1000, 30);
    test_random("on the way", the_best_site_eliminates_all_on_its_way, 1000,
                25);
    test_near_degenerate("on the way", the_best_site_eliminates_all_on_its_way,
                         500, 14);
    test_grid_subsets("on the way", the_best_site_eliminates_all_on_its_way, 3);
    test_random("the longer edge", only_the_longer_edge_is_next, 1000, 40);
    test_near_degenerate("the longer edge", only_the_longer_edge_is_next, 1000,
                         20);
    test_grid_subsets("the longer edge", only_the_longer_edge_is_next, 3);
    test_random("the costs", the_costs_are_as_counted, 1000, 200);
    test_near_degenerate("the costs", the_costs_are_as_counted, 500, 60);
    test_run("uniform densities", uniform_densities_are_known);
    test_run("E24: the unit square", the_unit_square);
    test_run("neighbours do not suffice", neighbours_do_not_suffice);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 70000,
                                  .largest_n = 190,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 10000});
}
