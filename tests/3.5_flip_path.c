/* From any triangulation to any other lead at most n(n-1) flips (notes 3.5.4),
 * by way of one Delaunay triangulation in which all ways of Figure 10 meet,
 * when ties are decided by a rule; and how many flips Figure 10 takes depends
 * on its stack.
 *
 * Hypotheses: none; no general position.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_graph.h"
#include "lib/memory.h"
#include "lib/mesh_build.h"
#include "tests/harness/flip_graphs.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

/* ---- P3: all ways lead to one. ---- */

/* Figure 10 with ties decided; returns the number of flips. */
static uint32_t
descend(mesh *m, const point2 *points)
{
    edge_list path;
    edge_stack L;
    CLAIM("flipgraph.P3",
          flip_path(points, m, m, &path) == TRI_OK &&
              edge_stack_init(&L, m) == TRI_OK,
          "out of memory");
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
        mesh m = mesh_of_node(&g, points, node);
        if (m.triangles == 0)
            break;
        u = m.locations;
        uint32_t flips = descend(&m, points), here = node_of(&g, &m);
        mesh_free(&m);
        if (node == 0)
            end = here;
        CLAIM("flipgraph.P3", here == end, "node 0 ends in %u, node %u in %u",
              end, node, here);
        CLAIM("flipgraph.P3", g.is_delaunay[here], "node %u is not Delaunay",
              here);
        CLAIM("flipgraph.P3", flips <= u * (u - 1) / 2, "%u flips", flips);
    }
    flip_graph_free(&g);
}

/* ---- P4, E37: so there is a way from any to any other. ---- */

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
        CLAIM("flipgraph.P4", ab != NONE && is_flippable(m, points, ab),
              "step %u: edge "
              "%u %u cannot be flipped",
              k, path.ends[k][0], path.ends[k][1]);
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
    CLAIM("flipgraph.P4", flip_path(points, &from, &to, &path) == TRI_OK,
          "out of memory");
    uint32_t u = from.locations, flips = path.count;
    replay(&from, points, path);
    /* The same edges now? Lists of edges are in one order for all meshes. */
    CLAIM("flipgraph.P4",
          mesh_edges(&from, NULL, &reached) == TRI_OK &&
              mesh_edges(&to, NULL, &wanted) == TRI_OK,
          "out of memory");
    bool same = reached.count == wanted.count;
    for (uint32_t i = 0; i < reached.count && same; i++)
        same = reached.ends[i][0] == wanted.ends[i][0] &&
               reached.ends[i][1] == wanted.ends[i][1];
    edge_list_free(&path);
    edge_list_free(&reached);
    edge_list_free(&wanted);
    mesh_free(&from);
    mesh_free(&to);
    CLAIM("flipgraph.P4", same, "the path of %u flips ends elsewhere", flips);
    CLAIM("E37", u == 0 || flips <= u * (u - 1), "%u flips for %u locations",
          flips, u);
}

/* E38: the square. Figure 10 ends where it begins, at two different nodes. */
static void
e38_two_ends(const point2 *points, uint32_t n)
{
    flip_graph g = graph_of(points, n);
    CLAIM("E38", g.nodes == 2 && g.is_delaunay[0] && g.is_delaunay[1],
          "%u triangulations", g.nodes);
    for (uint32_t node = 0; node < 2; node++) {
        mesh m = mesh_of_node(&g, points, node);
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

/* How the inner edges of a fan at the last point n are pushed: (2,n) first,
 * (2,n) last, or (2,n) first as the half-edge from n to 2, and so on. */
typedef enum pushing { FIRST_FIRST, LAST_FIRST, TURNED } pushing;

/* Figure 10 on the fan at the last of n points (i, i*i), i = 1..n. */
static uint32_t
flips_from_the_fan(uint32_t n, pushing how)
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
    CLAIM("flipgraph.P9",
          mesh_from_triangles(n, (triangle_list){n - 2, corner}, &m) ==
                  TRI_OK &&
              edge_stack_init(&L, &m) == TRI_OK,
          "out of memory");
    for (vertex_id k = 1; k + 2 < n; k++) {
        halfedge_id e = find_edge(&m, how == LAST_FIRST ? n - 2 - k : k, n - 1);
        edge_stack_push(&L, how == TURNED ? mesh_twin(&m, e) : e);
    }
    counter flips = {{count_flips}, 0};
    m.trace = &flips.base;
    lawson_flip(&L, points);
    edge_stack_free(&L);
    for (vertex_id k = 2; k + 1 < n; k++)
        CLAIM("flipgraph.P9", find_edge(&m, 0, k) != NONE,
              "no fan at the first point");
    mesh_free(&m);
    return flips.flips;
}

static void
the_order_of_the_stack_matters(void)
{
    for (uint32_t n = 4; n <= 30; n++) {
        uint32_t slow = flips_from_the_fan(n, FIRST_FIRST);
        uint32_t fast = flips_from_the_fan(n, LAST_FIRST);
        uint32_t turned = flips_from_the_fan(n, TURNED);
        CLAIM("flipgraph.P9", slow == (n - 2) * (n - 3) / 2, "%u flips, n = %u",
              slow, n);
        CLAIM("flipgraph.P9", fast == n - 3, "%u flips, n = %u", fast, n);
        CLAIM("flipgraph.P9", (turned < slow) == (n >= 7),
              "turned half-edges: %u flips, n = %u", turned, n);
    }
}

/* ---- Memory. ---- */

static void
memory_may_run_out(void)
{
    point2 points[9];
    for (uint32_t i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    flip_graph g = graph_of(points, 9);
    mesh from = mesh_of_node(&g, points, 5), to = mesh_of_node(&g, points, 60);
    edge_list path;
    tri_status status = TRI_OUT_OF_MEMORY;
    unsigned long k;
    for (k = 1; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = flip_path(points, &from, &to, &path);
        memory_fail_at(0);
        CLAIM("flipgraph.P4",
              status == TRI_OK || (path.ends == NULL && path.count == 0),
              "allocation %lu leaves %u flips", k, path.count);
    }
    CLAIM("flipgraph.P4", status == TRI_OK && k > 20 && path.count > 0,
          "%u flips, %lu allocations", path.count, k);
    replay(&from, points, path);
    CLAIM("flipgraph.P4", node_of(&g, &from) == 60, "the path ends elsewhere");
    edge_list_free(&path);
    mesh_free(&from);
    mesh_free(&to);
    flip_graph_free(&g);
}

int
main(int argc, char **argv)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    test_begin(argc, argv,
               "At most n(n-1) flips between any two triangulations");
    test_random("all end in one", all_end_in_one, 500, 8);
    test_near_degenerate("all end in one", all_end_in_one, 500, 8);
    test_grid_subsets("all end in one", all_end_in_one, 3);
    test_random("a path leads anywhere", a_path_leads_anywhere, 2000, 30);
    test_near_degenerate("a path leads anywhere", a_path_leads_anywhere, 2000,
                         25);
    test_grid_subsets("a path leads anywhere", a_path_leads_anywhere, 4);
    test_permutations("E38: the square", e38_two_ends, square, 4);
    test_run("the order of the stack", the_order_of_the_stack_matters);
    test_run("out of memory", memory_may_run_out);
    return test_end((test_minima){.trials = 50000,
                                  .largest_n = 25,
                                  .zeros = 100000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
