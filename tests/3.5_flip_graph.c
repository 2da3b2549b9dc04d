/* The flip graph (notes 3.5.4): its nodes are all triangulations of the points, it
 * is connected, and from any triangulation to any other lead at most n(n-1) flips.
 *
 * Hypotheses: none; no general position. The sets are small, as all of their
 * triangulations are looked at.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "lib/memory.h"
#include "lib/mesh_build.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

static flip_graph
graph_of(const point2 *points, uint32_t n)
{
    flip_graph g;
    tri_status status = flip_graph_build(points, n, NULL, &g);
    CLAIM("flipgraph.P2", status == TRI_OK, "%s", tri_status_text(status));
    return g;
}

/* A node as a mesh; one without edges if it has no triangles. */
static mesh
mesh_of(const flip_graph *g, const point2 *points, uint32_t node)
{
    mesh m = {0};
    triangle_list list;
    CLAIM("flipgraph.P2", flip_graph_triangles(g, points, node, &list) == TRI_OK &&
          (list.count == 0 || mesh_from_triangles(g->points, list, &m) == TRI_OK),
          "out of memory");
    triangle_list_free(&list);
    return m;
}

static uint32_t
node_of(const flip_graph *g, const mesh *m)
{
    uint32_t node;
    CLAIM("flipgraph.P2", flip_graph_find(g, m, &node) == TRI_OK, "out of memory");
    return node;
}

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

/* Do the open segments have a point in common? Requires: different segments without
 * points between their ends. */
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
            bool possible = is_first_of_its_kind(p, a) && is_first_of_its_kind(p, b);
            for (vertex_id v = 0; v < n; v++)
                possible = possible && !lies_between(p[a], p[v], p[b]);
            if (!possible)
                continue;
            t.end[t.pairs][0] = a;
            t.end[t.pairs][1] = b;
            for (uint32_t i = 0; i < t.pairs; i++)
                if (segments_cross(p[a], p[b], p[t.end[i][0]], p[t.end[i][1]])) {
                    t.crossed[i] |= (uint64_t)1 << t.pairs;
                    t.crossed[t.pairs] |= (uint64_t)1 << i;
                }
            t.pairs++;
        }
    return t;
}

/* How many sets of pairs without crossings have `wanted` pairs from i on? As many as
 * a triangulation has edges: then no pair can be added, and such a set of edges is a
 * triangulation. (The depth is at most MOST_PAIRS.) */
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
    return without + count_sets(t, i + 1, forbidden | t->crossed[i], wanted - 1);
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

/* Each node is a triangulation, is found again, and they are as many as there are. */
static void
the_nodes_are_all_triangulations(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    for (uint32_t node = 0; node < g.nodes; node++) {
        triangle_list list;
        verdict v;
        CLAIM("flipgraph.P2", flip_graph_triangles(&g, points, node, &list) == TRI_OK &&
              is_triangulation(points, n, list, &v) == TRI_OK, "out of memory");
        triangle_list_free(&list);
        claim_verdict("flipgraph.P2", v);
        mesh m = mesh_of(&g, points, node);
        uint32_t found = m.triangles > 0 ? node_of(&g, &m) : node;
        mesh_free(&m);
        CLAIM("flipgraph.P2", found == node, "node %u is found as %u", node, found);
    }
    pair_table t = pairs_of(points, n);
    uint64_t all = count_sets(&t, 0, 0, edges_of_node(&g, 0));
    uint32_t nodes = g.nodes;
    flip_graph_free(&g);
    CLAIM("flipgraph.P2", nodes == all, "%u nodes, and %llu triangulations", nodes,
          (unsigned long long)all);
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
            CLAIM("flipgraph.P1", neighbours == (missing == 1), "%u and %u are %s "
                  "neighbours and differ in %u edges", node, other,
                  neighbours ? "" : "no", missing);
        }
    CLAIM("flipgraph.P1", seen == 2 * flip_graph_flips(&g), "a neighbour is listed twice");
    flip_graph_free(&g);
}

/* ---- P3, P4, E37, E38: all ways lead to one. ---- */

/* Figure 10 with ties decided; returns the number of flips. */
static uint32_t
descend(mesh *m, const point2 *points)
{
    edge_list path;
    edge_stack L;
    CLAIM("flipgraph.P3", flip_path(points, m, m, &path) == TRI_OK &&
          edge_stack_init(&L, m) == TRI_OK, "out of memory");
    uint32_t flips = path.count / 2; /* down, and up again */
    edge_list_free(&path);
    push_all_edges(&L);
    lawson_flip_perturbed(&L, points);
    edge_stack_free(&L);
    return flips;
}

static void
all_end_in_one(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    uint32_t end = NONE, u = 0;
    for (uint32_t node = 0; node < g.nodes; node++) {
        mesh m = mesh_of(&g, points, node);
        if (m.triangles == 0)
            break;
        u = m.locations;
        uint32_t flips = descend(&m, points), here = node_of(&g, &m);
        mesh_free(&m);
        if (node == 0)
            end = here;
        CLAIM("flipgraph.P3", here == end, "node 0 ends in %u, node %u in %u", end, node,
              here);
        CLAIM("flipgraph.P3", g.is_delaunay[here], "node %u is not Delaunay", here);
        CLAIM("flipgraph.P3", flips <= u * (u - 1) / 2, "%u flips", flips);
    }
    flip_graph_free(&g);
}

static halfedge_id
find_edge(const mesh *m, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_origin(m, e) == a && mesh_dest(m, e) == b)
            return e;
    return NONE;
}

/* Flips along the path; each of its edges must be there, and flippable. */
static void
replay(mesh *m, const point2 *points, edge_list path)
{
    for (uint32_t k = 0; k < path.count; k++) {
        halfedge_id ab = find_edge(m, path.ends[k][0], path.ends[k][1]);
        CLAIM("flipgraph.P4", ab != NONE && is_flippable(m, points, ab), "step %u: edge "
              "%u %u cannot be flipped", k, path.ends[k][0], path.ends[k][1]);
        flip(m, ab);
    }
}

static void
a_path_leads_anywhere(const point2 *points, uint32_t n)
{
    mesh from, to;
    random_triangulation(points, n, &from);
    random_triangulation(points, n, &to);
    edge_list path, reached, wanted;
    CLAIM("flipgraph.P4", flip_path(points, &from, &to, &path) == TRI_OK, "out of memory");
    uint32_t u = from.locations, flips = path.count;
    replay(&from, points, path);
    /* The same edges now? Lists of edges are in one order for all meshes. */
    CLAIM("flipgraph.P4", mesh_edges(&from, NULL, &reached) == TRI_OK &&
          mesh_edges(&to, NULL, &wanted) == TRI_OK, "out of memory");
    bool same = reached.count == wanted.count;
    for (uint32_t i = 0; i < reached.count && same; i++)
        same = reached.ends[i][0] == wanted.ends[i][0] && reached.ends[i][1] == wanted.ends[i][1];
    edge_list_free(&path);
    edge_list_free(&reached);
    edge_list_free(&wanted);
    mesh_free(&from);
    mesh_free(&to);
    CLAIM("flipgraph.P4", same, "the path of %u flips ends elsewhere", flips);
    CLAIM("E37", u == 0 || flips <= u * (u - 1), "%u flips for %u locations", flips, u);
}

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
                    crossings += t.crossed[i] >> j & 1 &&
                        flip_graph_has_edge(&g, from, t.end[i][0], t.end[i][1]) &&
                        flip_graph_has_edge(&g, to, t.end[j][0], t.end[j][1]);
            CLAIM("E37", distance[to] <= crossings, "%u and %u: %u flips, %u crossings",
                  from, to, distance[to], crossings);
        }
    }
    free(distance);
    flip_graph_free(&g);
}

/* P5: from each Delaunay triangulation to each other one through Delaunay ones. */
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
    CLAIM("flipgraph.P5", seen == all, "%u of %u Delaunay triangulations are reached",
          seen, all);
}

/* E38: the square. Figure 10 ends where it begins, at two different nodes. */
static void
e38_two_ends(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    CLAIM("E38", g.nodes == 2 && g.is_delaunay[0] && g.is_delaunay[1],
          "%u triangulations", g.nodes);
    for (uint32_t node = 0; node < 2; node++) {
        mesh m = mesh_of(&g, points, node);
        edge_stack L;
        CLAIM("E38", edge_stack_init(&L, &m) == TRI_OK, "out of memory");
        push_all_edges(&L);
        lawson_flip(&L, points);
        edge_stack_free(&L);
        CLAIM("E38", node_of(&g, &m) == node, "Figure 10 leaves node %u", node);
        mesh_free(&m);
    }
    flip_graph_free(&g);
    all_end_in_one(points, n);
}

/* ---- P6: the diameter. ---- */

static uint32_t
diameter_of(const flip_graph *g)
{
    uint32_t diameter;
    CLAIM("flipgraph.P6", flip_graph_diameter(g, &diameter) == TRI_OK, "out of memory");
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
            CLAIM("flipgraph.P6", distance[to] != NONE, "%u is not reached", to);
            CLAIM("flipgraph.P6", (distance[to] == 0) == (to == from) &&
                  (distance[to] == 1) == are_neighbours(&g, from, to),
                  "%u is %u flips from %u", to, distance[to], from);
            for (size_t i = g.first[to]; i < g.first[to + 1]; i++)
                CLAIM("flipgraph.P6", distance[to] <= distance[g.neighbour[i]] + 1,
                      "%u is nearer to %u by way of %u", to, from, g.neighbour[i]);
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
        CLAIM("flipgraph.P7", flip_graph_build(points, n, NULL, &g) == TRI_OK, "no graph");
        uint32_t nodes = g.nodes, wide = diameter_of(&g);
        size_t flips = flip_graph_flips(&g);
        flip_graph_free(&g);
        CLAIM("flipgraph.P7", nodes == catalan[n - 3], "%u for n = %u", nodes, n);
        CLAIM("flipgraph.P7", 2 * flips == (size_t)nodes * (n - 3), "%zu flips", flips);
        CLAIM("flipgraph.P7", wide == diameter[n - 3], "diameter %u for n = %u", wide, n);
    }
}

static void
grids(void)
{
    static const struct {
        uint32_t columns, rows, nodes, flips, diameter; /* 0: not looked at */
    } known[] = {{2, 2, 2, 1, 1}, {3, 3, 64, 132, 8}, {3, 4, 852, 2626, 20},
                 {4, 4, 46456, 0, 0}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        point2 points[16];
        uint32_t n = known[k].columns * known[k].rows;
        for (uint32_t i = 0; i < n; i++)
            points[i] = (point2){i % known[k].columns, i / known[k].columns};
        flip_graph g;
        CLAIM("flipgraph.P8", flip_graph_build(points, n, NULL, &g) == TRI_OK, "no graph");
        uint32_t nodes = g.nodes, wide = known[k].diameter ? diameter_of(&g) : 0;
        uint32_t delaunay = delaunay_nodes(&g);
        size_t flips = flip_graph_flips(&g);
        flip_graph_free(&g);
        CLAIM("flipgraph.P8", nodes == known[k].nodes, "%u triangulations", nodes);
        CLAIM("flipgraph.P8", known[k].flips == 0 || flips == known[k].flips,
              "%zu flips", flips);
        CLAIM("flipgraph.P8", wide == known[k].diameter, "diameter %u", wide);
        uint32_t squares = (known[k].columns - 1) * (known[k].rows - 1);
        CLAIM("flipgraph.P8", delaunay == (uint32_t)1 << squares, "%u Delaunay", delaunay);
    }
}

/* ---- P9: the order of the stack. ---- */

typedef struct counter {
    trace base; /* first: see lib/trace.h */
    uint32_t flips;
} counter;

static int
count_flips(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    ((counter *)self)->flips += event->kind == TRACE_FLIP;
    return 0;
}

/* Figure 10 on the fan at the last of n points (i, i*i), i = 1..n. Its inner edges
 * are pushed from lower to higher index, the first or the last of them first. */
static uint32_t
flips_from_the_fan(uint32_t n, bool last_first)
{
    point2 points[30];
    vertex_id corner[30][3];
    mesh m;
    edge_stack L;
    for (vertex_id i = 0; i < n; i++) {
        points[i] = (point2){i + 1, (i + 1) * (i + 1)};
        corner[i][0] = i;
        corner[i][1] = i + 1;
        corner[i][2] = n - 1;
    }
    CLAIM("flipgraph.P9", mesh_from_triangles(n, (triangle_list){n - 2, corner}, &m) ==
          TRI_OK && edge_stack_init(&L, &m) == TRI_OK, "out of memory");
    for (vertex_id k = 1; k + 2 < n; k++)
        edge_stack_push(&L, find_edge(&m, last_first ? n - 2 - k : k, n - 1));
    counter flips = {{count_flips}, 0};
    m.trace = &flips.base;
    lawson_flip(&L, points);
    edge_stack_free(&L);
    for (vertex_id k = 2; k + 1 < n; k++)
        CLAIM("flipgraph.P9", find_edge(&m, 0, k) != NONE, "no fan at the first point");
    mesh_free(&m);
    return flips.flips;
}

static void
the_order_of_the_stack_matters(void)
{
    for (uint32_t n = 4; n <= 30; n++) {
        uint32_t slow = flips_from_the_fan(n, false), fast = flips_from_the_fan(n, true);
        CLAIM("flipgraph.P9", slow == (n - 2) * (n - 3) / 2, "%u flips, n = %u", slow, n);
        CLAIM("flipgraph.P9", fast == n - 3, "%u flips, n = %u", fast, n);
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
        CLAIM("flipgraph.P2", status == TRI_OK || (g.edges == NULL && g.nodes == 0),
              "allocation %lu leaves %u nodes", k, g.nodes);
    }
    CLAIM("flipgraph.P2", status == TRI_OK && k > 15 && g.nodes == 64, "%lu allocations",
          k);
    mesh from = mesh_of(&g, points, 5), to = mesh_of(&g, points, 60);
    edge_list path;
    status = TRI_OUT_OF_MEMORY;
    for (k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = flip_path(points, &from, &to, &path);
        memory_fail_at(0);
        CLAIM("flipgraph.P4", status == TRI_OK || (path.ends == NULL && path.count == 0),
              "allocation %lu leaves %u flips", k, path.count);
    }
    CLAIM("flipgraph.P4", status == TRI_OK && path.count > 0, "%u flips", path.count);
    replay(&from, points, path);
    CLAIM("flipgraph.P4", node_of(&g, &from) == 60, "the path ends elsewhere");
    uint32_t diameter = 1;
    triangle_list list;
    memory_fail_at(1);
    CLAIM("flipgraph.P6", flip_graph_diameter(&g, &diameter) == TRI_OUT_OF_MEMORY &&
          diameter == 0, "diameter %u", diameter);
    memory_fail_at(1);
    CLAIM("flipgraph.P2", flip_graph_triangles(&g, points, 0, &list) ==
          TRI_OUT_OF_MEMORY && list.corner == NULL, "%u triangles", list.count);
    memory_fail_at(1);
    uint32_t node;
    CLAIM("flipgraph.P2", flip_graph_find(&g, &from, &node) == TRI_OUT_OF_MEMORY,
          "node %u", node);
    memory_fail_at(0);
    edge_list_free(&path);
    mesh_free(&from);
    mesh_free(&to);
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
    CLAIM("flipgraph.P2", flip_graph_build(points, 20, &options, &g) == TRI_CANCELLED &&
          g.edges == NULL && g.nodes == 0, "%u nodes", g.nodes);
    points[7].x = 1.0 / 0.0;
    CLAIM("flipgraph.P2", flip_graph_build(points, 20, NULL, &g) == TRI_NOT_FINITE &&
          g.edges == NULL, "a point at infinity is accepted");
}

int
main(int argc, char **argv)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    test_begin(argc, argv, "The flip graph: all triangulations, connected by flips");
    test_random("the nodes are all triangulations", the_nodes_are_all_triangulations,
                1000, 8);
    test_near_degenerate("the nodes are all triangulations",
                         the_nodes_are_all_triangulations, 1000, 8);
    test_grid_subsets("the nodes are all triangulations",
                      the_nodes_are_all_triangulations, 3);
    test_random("neighbours differ in one edge", neighbours_differ_in_one_edge, 300, 8);
    test_grid_subsets("neighbours differ in one edge", neighbours_differ_in_one_edge, 3);
    test_random("all end in one", all_end_in_one, 500, 8);
    test_near_degenerate("all end in one", all_end_in_one, 500, 8);
    test_grid_subsets("all end in one", all_end_in_one, 3);
    test_random("a path leads anywhere", a_path_leads_anywhere, 2000, 30);
    test_near_degenerate("a path leads anywhere", a_path_leads_anywhere, 2000, 25);
    test_grid_subsets("a path leads anywhere", a_path_leads_anywhere, 4);
    test_random("E37: distance and crossings", e37_distance_and_crossings, 300, 7);
    test_grid_subsets("E37: distance and crossings", e37_distance_and_crossings, 3);
    test_random("Delaunay nodes", delaunay_nodes_are_connected, 500, 8);
    test_grid_subsets("Delaunay nodes", delaunay_nodes_are_connected, 3);
    test_permutations("E38: the square", e38_two_ends, square, 4);
    test_random("the diameter", the_diameter_is_the_largest_distance, 300, 8);
    test_grid_subsets("the diameter", the_diameter_is_the_largest_distance, 3);
    test_run("convex polygons", convex_polygons);
    test_run("grids", grids);
    test_run("the order of the stack", the_order_of_the_stack_matters);
    test_run("out of memory", memory_may_run_out);
    test_run("stopped", it_can_be_stopped);
    return test_end((test_minima){.trials = 10000, .largest_n = 25, .zeros = 100000,
                                  .expansions = 1000, .wide = 1000});
}
