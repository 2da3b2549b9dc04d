/* The flip graph (notes 3.5.4): its nodes are all triangulations of the points,
 * its edges are the flips, and it is connected.
 *
 * Hypotheses: none; no general position. The sets are small, as all of their
 * triangulations are looked at.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "lib/memory.h"
#include "tests/harness/flip_graphs.h"
#include "tests/harness/harness.h"

#include <stdlib.h>

/* ---- P2: all triangulations, counted in another way. ---- */

enum { MOST_PAIRS = 64 };

/* All pairs of points that could be an edge, and which of them cross. */
typedef struct pair_table {
    uint32_t pairs;
    vertex_id end[MOST_PAIRS][2];
    uint64_t crossed[MOST_PAIRS]; /* pair -> the set of pairs that it crosses */
} pair_table;

static bool
lies_between(point2 a, point2 p, point2 b)
{
    return orient2d(a, b, p) == 0 && dot_sign(a, p, b) < 0;
}

static bool
coincide(point2 a, point2 b)
{
    return a.x == b.x && a.y == b.y;
}

/* Do the open segments have a point in common? Requires: different segments
 * without points between their ends. */
static bool
segments_cross(point2 a, point2 b, point2 c, point2 d)
{
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 &&
           orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

static bool
is_first_of_its_kind(const point2 *p, vertex_id v)
{
    for (vertex_id w = 0; w < v; w++)
        if (coincide(p[v], p[w]))
            return false;
    return true;
}

static pair_table
pairs_of(const point2 *p, uint32_t n)
{
    pair_table t = {0};
    for (vertex_id b = 0; b < n; b++)
        for (vertex_id a = 0; a < b; a++) {
            bool possible =
                is_first_of_its_kind(p, a) && is_first_of_its_kind(p, b);
            for (vertex_id v = 0; v < n; v++)
                possible = possible && !lies_between(p[a], p[v], p[b]);
            if (!possible)
                continue;
            t.end[t.pairs][0] = a;
            t.end[t.pairs][1] = b;
            for (uint32_t i = 0; i < t.pairs; i++)
                if (segments_cross(p[a], p[b], p[t.end[i][0]],
                                   p[t.end[i][1]])) {
                    t.crossed[i] |= (uint64_t)1 << t.pairs;
                    t.crossed[t.pairs] |= (uint64_t)1 << i;
                }
            t.pairs++;
        }
    return t;
}

/* How many sets of pairs without crossings have `wanted` pairs from i on? As
 * many as a triangulation has edges: then no pair can be added, and such a set
 * of edges is a triangulation. (The depth is at most MOST_PAIRS.) */
static uint64_t
count_sets(const pair_table *t, uint32_t i, uint64_t forbidden, uint32_t wanted)
{
    if (wanted == 0)
        return 1;
    if (t->pairs - i < wanted)
        return 0;
    uint64_t without = count_sets(t, i + 1, forbidden, wanted);
    if (forbidden >> i & 1)
        return without;
    return without +
           count_sets(t, i + 1, forbidden | t->crossed[i], wanted - 1);
}

static uint32_t
edges_of_node(const flip_graph *g, uint32_t node)
{
    uint32_t edges = 0;
    for (vertex_id b = 0; b < g->points; b++)
        for (vertex_id a = 0; a < b; a++)
            edges += flip_graph_has_edge(g, node, a, b);
    return edges;
}

/* How many edges has the first node that the second has not? */
static uint32_t
edges_missing(const flip_graph *g, uint32_t first, uint32_t second)
{
    uint32_t missing = 0;
    for (vertex_id b = 0; b < g->points; b++)
        for (vertex_id a = 0; a < b; a++)
            missing += flip_graph_has_edge(g, first, a, b) &&
                       !flip_graph_has_edge(g, second, a, b);
    return missing;
}

/* Each node is a triangulation, is found again, and they are as many as there
 * are. */
static void
the_nodes_are_all_triangulations(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    for (uint32_t node = 0; node < g.nodes; node++) {
        triangle_list list;
        verdict v;
        CLAIM("flipgraph.P2",
              flip_graph_triangles(&g, points, node, &list) == TRI_OK &&
                  is_triangulation(points, n, list, &v) == TRI_OK,
              "out of memory");
        triangle_list_free(&list);
        claim_verdict("flipgraph.P2", v);
        mesh m = mesh_of_node(&g, points, node);
        uint32_t found = m.triangles > 0 ? node_of(&g, &m) : node;
        mesh_free(&m);
        CLAIM("flipgraph.P2", found == node, "node %u is found as %u", node,
              found);
    }
    pair_table t = pairs_of(points, n);
    uint64_t all = count_sets(&t, 0, 0, edges_of_node(&g, 0));
    uint32_t nodes = g.nodes;
    flip_graph_free(&g);
    CLAIM("flipgraph.P2", nodes == all, "%u nodes, and %llu triangulations",
          nodes, (unsigned long long)all);
}

/* ---- P1: the edges of the graph. ---- */

static bool
are_neighbours(const flip_graph *g, uint32_t node, uint32_t other)
{
    for (size_t i = g->first[node]; i < g->first[node + 1]; i++)
        if (g->neighbour[i] == other)
            return true;
    return false;
}

static void
neighbours_differ_in_one_edge(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    size_t seen = 0;
    for (uint32_t node = 0; node < g.nodes; node++)
        for (uint32_t other = 0; other < g.nodes; other++) {
            bool neighbours = are_neighbours(&g, node, other);
            seen += neighbours;
            uint32_t missing = edges_missing(&g, node, other);
            CLAIM("flipgraph.P1", neighbours == (missing == 1),
                  "%u and %u are %s "
                  "neighbours and differ in %u edges",
                  node, other, neighbours ? "" : "no", missing);
        }
    CLAIM("flipgraph.P1", seen == 2 * flip_graph_flips(&g),
          "a neighbour is listed twice");
    flip_graph_free(&g);
}

/* ---- E37, P5, P6: distances. ---- */

/* E37: two nodes are no further apart than their edges cross. */
static void
e37_distance_and_crossings(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    uint32_t *distance = malloc(g.nodes * 2 * sizeof *distance);
    pair_table t = pairs_of(points, n);
    for (uint32_t from = 0; from < g.nodes; from++) {
        flip_graph_distances(&g, from, distance, distance + g.nodes);
        for (uint32_t to = 0; to < g.nodes; to++) {
            uint32_t crossings = 0;
            for (uint32_t i = 0; i < t.pairs; i++)
                for (uint32_t j = 0; j < t.pairs; j++)
                    crossings +=
                        t.crossed[i] >> j & 1 &&
                        flip_graph_has_edge(&g, from, t.end[i][0],
                                            t.end[i][1]) &&
                        flip_graph_has_edge(&g, to, t.end[j][0], t.end[j][1]);
            CLAIM("E37", distance[to] <= crossings,
                  "%u and %u: %u flips, %u crossings", from, to, distance[to],
                  crossings);
        }
    }
    free(distance);
    flip_graph_free(&g);
}

/* P5: from each Delaunay triangulation to each other one through
 * Delaunay ones. */
static void
delaunay_nodes_are_connected(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    uint32_t *reached = malloc(g.nodes * sizeof *reached), seen = 0, all = 0;
    bool *is_reached = calloc(g.nodes, sizeof *is_reached);
    reached[seen++] = 0;
    is_reached[0] = true;
    for (uint32_t k = 0; k < seen; k++)
        for (size_t i = g.first[reached[k]]; i < g.first[reached[k] + 1]; i++) {
            uint32_t next = g.neighbour[i];
            if (g.is_delaunay[next] && !is_reached[next])
                reached[seen++] = next;
            is_reached[next] = is_reached[next] || g.is_delaunay[next];
        }
    for (uint32_t node = 0; node < g.nodes; node++)
        all += g.is_delaunay[node];
    free(reached);
    free(is_reached);
    flip_graph_free(&g);
    CLAIM("flipgraph.P5", seen == all,
          "%u of %u Delaunay triangulations are reached", seen, all);
}

static uint32_t
diameter_of(const flip_graph *g)
{
    uint32_t diameter;
    CLAIM("flipgraph.P6", flip_graph_diameter(g, &diameter) == TRI_OK,
          "out of memory");
    return diameter;
}

static void
the_diameter_is_the_largest_distance(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    uint32_t *distance = malloc(g.nodes * 2 * sizeof *distance), largest = 0;
    for (uint32_t from = 0; from < g.nodes; from++) {
        flip_graph_distances(&g, from, distance, distance + g.nodes);
        for (uint32_t to = 0; to < g.nodes; to++) {
            CLAIM("flipgraph.P6", distance[to] != NONE, "%u is not reached",
                  to);
            CLAIM("flipgraph.P6",
                  (distance[to] == 0) == (to == from) &&
                      (distance[to] == 1) == are_neighbours(&g, from, to),
                  "%u is %u flips from %u", to, distance[to], from);
            for (size_t i = g.first[to]; i < g.first[to + 1]; i++)
                CLAIM("flipgraph.P6",
                      distance[to] <= distance[g.neighbour[i]] + 1,
                      "%u is nearer to %u by way of %u", to, from,
                      g.neighbour[i]);
            largest = distance[to] > largest ? distance[to] : largest;
        }
    }
    uint32_t diameter = diameter_of(&g);
    free(distance);
    flip_graph_free(&g);
    CLAIM("flipgraph.P6", diameter == largest, "%u, not %u", diameter, largest);
}

/* ---- P7, P8: numbers that are known. ---- */

static uint32_t
delaunay_nodes(const flip_graph *g)
{
    uint32_t count = 0;
    for (uint32_t node = 0; node < g->nodes; node++)
        count += g->is_delaunay[node];
    return count;
}

static void
convex_polygons(void)
{
    static const uint32_t catalan[] = {1, 2, 5, 14, 42, 132, 429, 1430};
    static const uint32_t diameter[] = {0, 1, 2, 4, 5, 7, 9, 11};
    for (uint32_t n = 3; n <= 10; n++) {
        point2 points[10];
        flip_graph g;
        for (uint32_t i = 0; i < n; i++)
            points[i] = (point2){i, i * i};
        CLAIM("flipgraph.P7", flip_graph_build(points, n, NULL, &g) == TRI_OK,
              "no graph");
        uint32_t nodes = g.nodes, wide = diameter_of(&g);
        size_t flips = flip_graph_flips(&g);
        flip_graph_free(&g);
        CLAIM("flipgraph.P7", nodes == catalan[n - 3], "%u for n = %u", nodes,
              n);
        CLAIM("flipgraph.P7", 2 * flips == (size_t)nodes * (n - 3), "%zu flips",
              flips);
        CLAIM("flipgraph.P7", wide == diameter[n - 3], "diameter %u for n = %u",
              wide, n);
    }
}

static void
grids(void)
{
    static const struct {
        uint32_t columns, rows, nodes, flips, diameter; /* 0: not looked at */
    } known[] = {{2, 2, 2, 1, 1},
                 {3, 3, 64, 132, 8},
                 {3, 4, 852, 2626, 20},
                 {4, 4, 46456, 0, 0}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        point2 points[16];
        uint32_t n = known[k].columns * known[k].rows;
        for (uint32_t i = 0; i < n; i++)
            points[i] = (point2){i % known[k].columns, i / known[k].columns};
        flip_graph g;
        CLAIM("flipgraph.P8", flip_graph_build(points, n, NULL, &g) == TRI_OK,
              "no graph");
        uint32_t nodes = g.nodes,
                 wide = known[k].diameter ? diameter_of(&g) : 0;
        uint32_t delaunay = delaunay_nodes(&g);
        size_t flips = flip_graph_flips(&g);
        flip_graph_free(&g);
        CLAIM("flipgraph.P8", nodes == known[k].nodes, "%u triangulations",
              nodes);
        CLAIM("flipgraph.P8", known[k].flips == 0 || flips == known[k].flips,
              "%zu flips", flips);
        CLAIM("flipgraph.P8", wide == known[k].diameter, "diameter %u", wide);
        uint32_t squares = (known[k].columns - 1) * (known[k].rows - 1);
        CLAIM("flipgraph.P8", delaunay == (uint32_t)1 << squares, "%u Delaunay",
              delaunay);
    }
}

/* ---- Memory, and being stopped. ---- */

static void
memory_may_run_out(void)
{
    point2 points[9];
    for (uint32_t i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    flip_graph g;
    tri_status status = TRI_OUT_OF_MEMORY;
    unsigned long k;
    for (k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = flip_graph_build(points, 9, NULL, &g);
        memory_fail_at(0);
        CLAIM("flipgraph.P2",
              status == TRI_OK || (g.edges == NULL && g.nodes == 0),
              "allocation %lu leaves %u nodes", k, g.nodes);
    }
    CLAIM("flipgraph.P2", status == TRI_OK && k > 15 && g.nodes == 64,
          "%lu allocations", k);
    uint32_t diameter = 1;
    triangle_list list;
    memory_fail_at(1);
    CLAIM("flipgraph.P6",
          flip_graph_diameter(&g, &diameter) == TRI_OUT_OF_MEMORY &&
              diameter == 0,
          "diameter %u", diameter);
    memory_fail_at(1);
    CLAIM("flipgraph.P2",
          flip_graph_triangles(&g, points, 0, &list) == TRI_OUT_OF_MEMORY &&
              list.corner == NULL,
          "%u triangles", list.count);
    memory_fail_at(1);
    uint32_t node;
    mesh m = {0};
    CLAIM("flipgraph.P2", flip_graph_find(&g, &m, &node) == TRI_OUT_OF_MEMORY,
          "an answer without memory");
    memory_fail_at(0);
    flip_graph_free(&g);
}

/* An observer that stops when there are more than 1000 nodes. */
typedef struct limit {
    trace base; /* first: see lib/trace.h */
    const flip_graph *g;
} limit;

static int
stop_after_1000(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    (void)event;
    return ((limit *)self)->g->nodes > 1000;
}

static void
it_can_be_stopped(void)
{
    point2 points[20];
    for (uint32_t i = 0; i < 20; i++)
        points[i] = (point2){i, i * i};
    flip_graph g;
    limit stop = {{stop_after_1000}, &g};
    tri_options options = tri_options_default();
    options.trace = &stop.base;
    CLAIM("flipgraph.P2",
          flip_graph_build(points, 20, &options, &g) == TRI_CANCELLED &&
              g.edges == NULL && g.nodes == 0,
          "%u nodes", g.nodes);
    points[7].x = 1.0 / 0.0;
    CLAIM("flipgraph.P2",
          flip_graph_build(points, 20, NULL, &g) == TRI_NOT_FINITE &&
              g.edges == NULL,
          "a point at infinity is accepted");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "The flip graph: all triangulations, connected by flips");
    test_random("the nodes are all triangulations",
                the_nodes_are_all_triangulations, 1000, 8);
    test_near_degenerate("the nodes are all triangulations",
                         the_nodes_are_all_triangulations, 1000, 8);
    test_grid_subsets("the nodes are all triangulations",
                      the_nodes_are_all_triangulations, 3);
    test_random("neighbours differ in one edge", neighbours_differ_in_one_edge,
                300, 8);
    test_grid_subsets("neighbours differ in one edge",
                      neighbours_differ_in_one_edge, 3);
    test_random("E37: distance and crossings", e37_distance_and_crossings, 300,
                7);
    test_grid_subsets("E37: distance and crossings", e37_distance_and_crossings,
                      3);
    test_random("Delaunay nodes", delaunay_nodes_are_connected, 500, 8);
    test_grid_subsets("Delaunay nodes", delaunay_nodes_are_connected, 3);
    test_random("the diameter", the_diameter_is_the_largest_distance, 300, 8);
    test_grid_subsets("the diameter", the_diameter_is_the_largest_distance, 3);
    test_run("convex polygons", convex_polygons);
    test_run("grids", grids);
    test_run("out of memory", memory_may_run_out);
    test_run("stopped", it_can_be_stopped);
    return test_end((test_minima){.trials = 5000,
                                  .largest_n = 8,
                                  .zeros = 100000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
