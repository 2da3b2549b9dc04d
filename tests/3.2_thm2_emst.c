/* Theorem 2: every Euclidean minimum spanning tree lies in the Delaunay
 * triangulation; in every one of them, and without general position (E25).
 *
 * Hypotheses: none; of copies of a site the lowest index is its vertex.
 *
 * `Every` tree: Prim's algorithm on the complete graph, with ties broken at
 * random, can make each of them. `Every` triangulation: that of
 * random_delaunay.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>

static edge_list
tree_of(const mesh *m, const point2 *points)
{
    edge_list tree;
    tri_status status = emst(m, points, &tree);
    CLAIM("thm2.P5", status == TRI_OK, "%s", tri_status_text(status));
    return tree;
}

static int
compare_lengths(const point2 *points, const vertex_id *e, const vertex_id *f)
{
    return compare_distance(points[e[0]], points[e[1]], points[f[0]],
                            points[f[1]]);
}

/* ---- Prim's algorithm on the complete graph. ---- */

/* A vertex that is in the tree, or the candidate edge that would bring it
 * there. */
typedef struct candidate {
    bool in_tree;
    vertex_id from; /* the tree's end of the candidate edge */
} candidate;

static void
ordered(vertex_id v, vertex_id w, vertex_id e[2])
{
    e[0] = v < w ? v : w;
    e[1] = v < w ? w : v;
}

/* Does the edge e come before f? Ties: by indices, or at random. */
static bool
precedes(const point2 *points, const vertex_id e[2], const vertex_id f[2],
         bool random)
{
    int sign = compare_lengths(points, e, f);
    if (sign != 0)
        return sign < 0;
    if (random)
        return random_below(test_random_source(), 2) == 0;
    return e[0] != f[0] ? e[0] < f[0] : e[1] < f[1];
}

/* A minimum spanning tree of the u given sites, grown from the first one. */
static edge_list
prim(const point2 *points, const vertex_id *site, uint32_t u, bool random)
{
    edge_list tree = {0, malloc((u + 1) * sizeof *tree.ends)};
    candidate *c = malloc((u + 1) * sizeof *c);
    for (uint32_t i = 0; i < u; i++)
        c[i] = (candidate){i == 0, site[0]};
    for (uint32_t round = 1; round < u; round++) {
        uint32_t best = 0; /* none yet: site[0] is in the tree */
        vertex_id e[2], f[2];
        for (uint32_t i = 1; i < u; i++) {
            if (c[i].in_tree)
                continue;
            ordered(site[i], c[i].from, e);
            ordered(site[best], c[best].from, f);
            if (best == 0 || precedes(points, e, f, random))
                best = i;
        }
        c[best].in_tree = true;
        ordered(site[best], c[best].from, tree.ends[tree.count++]);
        for (uint32_t i = 1; i < u; i++) {
            ordered(site[i], site[best], e);
            ordered(site[i], c[i].from, f);
            if (!c[i].in_tree && precedes(points, e, f, random))
                c[i].from = site[best];
        }
    }
    free(c);
    return tree;
}

/* The distinct sites; there is room for n. */
static uint32_t
distinct_sites(const point2 *points, uint32_t n, vertex_id *site)
{
    const point2 along_x = {1, 0};
    uint32_t u;
    CLAIM("thm2.P5", sort_along(points, n, along_x, site, &u) == TRI_OK,
          "no order");
    return u;
}

/* ---- P1: a site in the closed disc is nearer to both ends. ---- */

static void
in_the_disc_is_nearer_to_both(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    for (uint32_t tries = 10 * n; tries > 0; tries--) {
        random_source *s = test_random_source();
        point2 p = points[random_below(s, n)], q = points[random_below(s, n)];
        point2 r = points[random_below(s, n)];
        bool apart = oracle_compare_distance(p, r, p, p) > 0 &&
                     oracle_compare_distance(q, r, q, q) > 0;
        if (!apart || dot_sign(p, r, q) > 0)
            continue;
        CLAIM("thm2.P1",
              oracle_compare_distance(p, r, p, q) < 0 &&
                  oracle_compare_distance(q, r, p, q) < 0,
              "(%g,%g) lies in the disc of "
              "(%g,%g) (%g,%g)",
              r.x, r.y, p.x, p.y, q.x, q.y);
    }
}

/* The sign of (p-r).(q-r), by big integers: that of a cross product, a quarter
 * turn away. */
static void
dot_products_are_exact(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    for (uint32_t i = 0; i < n; i++) {
        point2 p = points[i], r = points[(i + 1) % n], q = points[(i + 2) % n];
        point2 turned_q = {-q.y, q.x}, turned_r = {-r.y, r.x};
        int expected = oracle_cross(p, r, turned_q, turned_r);
        CLAIM("thm2.P1", dot_sign(p, r, q) == expected, "%+d for %+d",
              dot_sign(p, r, q), expected);
        CLAIM("thm2.P1", dot_sign(q, r, p) == expected,
              "p and q are not alike");
        CLAIM("thm2.P1", dot_sign(p, p, q) == 0, "p is not on its circle");
    }
}

/* ---- P2 to P4: every tree lies in every graph of the chain. ---- */

static bool
in_mesh(const mesh *m, vertex_id v, vertex_id w)
{
    halfedge_id first = mesh_leaving(m, v), e = first;
    do {
        if (mesh_dest(m, e) == w)
            return true;
        e = mesh_around(m, e);
    } while (e != first);
    return false;
}

static void
every_tree_lies_in_the_chain(const point2 *points, uint32_t n)
{
    vertex_id *site = malloc((n + 1) * sizeof *site);
    uint32_t u = distinct_sites(points, n, site);
    edge_list tree = prim(points, site, u, true);
    mesh m = random_delaunay(points, n);
    for (uint32_t i = 0; i < tree.count; i++) {
        vertex_id v = tree.ends[i][0], w = tree.ends[i][1];
        point2 p = points[v], q = points[w];
        for (uint32_t k = 0; k < u; k++) {
            point2 z = points[site[k]];
            if (site[k] == v || site[k] == w)
                continue;
            CLAIM("thm2.P2",
                  compare_distance(p, z, p, q) >= 0 ||
                      compare_distance(q, z, p, q) >= 0,
                  "%u lies in the lune of the tree's "
                  "edge %u %u",
                  site[k], v, w);
            CLAIM("thm2.P3", dot_sign(p, z, q) > 0,
                  "%u lies in the disc of the tree's "
                  "edge %u %u",
                  site[k], v, w);
        }
        CLAIM("thm2.P4", in_mesh(&m, v, w), "%u %u is no Delaunay edge", v, w);
        CLAIM("E25", in_mesh(&m, v, w), "%u %u is no Delaunay edge", v, w);
    }
    free(site);
    free(tree.ends);
    mesh_free(&m);
}

/* ---- P5: Kruskal's tree on the Delaunay edges. ---- */

static bool
is_among(edge_list list, const vertex_id e[2])
{
    for (uint32_t i = 0; i < list.count; i++)
        if (list.ends[i][0] == e[0] && list.ends[i][1] == e[1])
            return true;
    return false;
}

static void
kruskal_is_prim(const point2 *points, uint32_t n)
{
    vertex_id *site = malloc((n + 1) * sizeof *site);
    uint32_t u = distinct_sites(points, n, site);
    edge_list expected = prim(points, site, u, false);
    mesh m = random_delaunay(points, n);
    edge_list tree = tree_of(&m, points);
    CLAIM("thm2.P5", tree.count == expected.count, "%u edges, %u are needed",
          tree.count, expected.count);
    for (uint32_t i = 0; i < tree.count; i++)
        CLAIM("thm2.P5", is_among(expected, tree.ends[i]),
              "Prim does without %u %u", tree.ends[i][0], tree.ends[i][1]);
    edge_list_free(&tree);
    free(expected.ends);
    free(site);
    mesh_free(&m);
}

/* ---- The order of the edges. ---- */

static void
shuffle(edge_list edges)
{
    for (uint32_t i = edges.count; i > 1; i--) {
        vertex_id *last = edges.ends[i - 1];
        vertex_id *chosen = edges.ends[random_below(test_random_source(), i)];
        vertex_id kept[2] = {chosen[0], chosen[1]};
        chosen[0] = last[0];
        chosen[1] = last[1];
        last[0] = kept[0];
        last[1] = kept[1];
    }
}

static void
edges_are_sorted(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    edge_list all, edges;
    CLAIM("thm2.P5",
          mesh_edges(&m, NULL, &all) == TRI_OK &&
              mesh_edges(&m, NULL, &edges) == TRI_OK,
          "out of memory");
    if (n % 2 == 0)
        shuffle(edges);
    CLAIM("thm2.P5", sort_by_length(points, edges) == TRI_OK, "out of memory");
    for (uint32_t i = 0; i + 1 < edges.count; i++)
        CLAIM("thm2.P5",
              precedes(points, edges.ends[i], edges.ends[i + 1], false),
              "%u %u comes before %u %u", edges.ends[i][0], edges.ends[i][1],
              edges.ends[i + 1][0], edges.ends[i + 1][1]);
    for (uint32_t i = 0; i < all.count; i++)
        CLAIM("thm2.P5", is_among(edges, all.ends[i]), "%u %u is lost",
              all.ends[i][0], all.ends[i][1]);
    edge_list_free(&edges);
    edge_list_free(&all);
    mesh_free(&m);
}

/* ---- P6: the check accepts exactly the minimum spanning trees. ---- */

/* Marks the vertices that are still connected with v when edge `cut` is left
 * out. */
static void
mark_part(edge_list tree, uint32_t cut, vertex_id v, bool *in_part)
{
    in_part[v] = true;
    for (bool more = true; more;) {
        more = false;
        for (uint32_t i = 0; i < tree.count; i++) {
            vertex_id a = tree.ends[i][0], b = tree.ends[i][1];
            if (i == cut || in_part[a] == in_part[b])
                continue;
            in_part[a] = in_part[b] = more = true;
        }
    }
}

/* Replaces a random edge of the tree by a random one between the two parts. Any
 * spanning tree can be reached in this way. */
static void
exchange_an_edge(uint32_t n, const vertex_id *site, uint32_t u, edge_list tree)
{
    random_source *r = test_random_source();
    uint32_t cut = random_below(r, tree.count);
    bool *in_part = calloc(n, sizeof *in_part);
    mark_part(tree, cut, tree.ends[cut][0], in_part);
    vertex_id v, w;
    do {
        v = site[random_below(r, u)];
        w = site[random_below(r, u)];
    } while (!in_part[v] || in_part[w]);
    free(in_part);
    tree.ends[cut][0] = v;
    tree.ends[cut][1] = w;
}

static verdict
judge(const mesh *m, const point2 *points, edge_list tree)
{
    verdict v;
    tri_status status = is_emst(m, points, tree, &v);
    CLAIM("thm2.P6", status == TRI_OK, "%s", tri_status_text(status));
    return v;
}

/* All minimum spanning trees have the same lengths, so a tree is one of them
 * exactly when its sorted lengths are those of Prim's. */
static void
accepts_exactly_the_minimum_trees(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 2);
    vertex_id *site = malloc(n * sizeof *site);
    uint32_t u = distinct_sites(points, n, site);
    mesh m = random_delaunay(points, n);
    edge_list least = prim(points, site, u, false),
              tree = prim(points, site, u, true);
    claim_verdict("thm2.P6", judge(&m, points, tree));
    CLAIM("thm2.P6", sort_by_length(points, least) == TRI_OK, "out of memory");
    for (int step = 0; step < 4 && u > 1; step++) {
        exchange_an_edge(n, site, u, tree);
        verdict v = judge(&m, points, tree);
        edge_list copy = {tree.count, malloc(tree.count * sizeof *copy.ends)};
        for (uint32_t i = 0; i < tree.count; i++)
            ordered(tree.ends[i][0], tree.ends[i][1], copy.ends[i]);
        CLAIM("thm2.P6", sort_by_length(points, copy) == TRI_OK,
              "out of memory");
        bool minimum = true;
        for (uint32_t i = 0; i < tree.count && minimum; i++)
            minimum = compare_lengths(points, copy.ends[i], least.ends[i]) == 0;
        CLAIM("thm2.P6", v.holds == minimum,
              "a tree that is %sminimum is judged %s", minimum ? "" : "not ",
              v.holds ? "minimum" : v.because);
        CLAIM("thm2.P6", v.holds || v.witnesses == 2, "%d witnesses",
              v.witnesses);
        free(copy.ends);
    }
    free(least.ends);
    free(tree.ends);
    free(site);
    mesh_free(&m);
}

static void
what_is_no_tree_is_refuted(const point2 *points, uint32_t n)
{
    mesh m = random_delaunay(points, n);
    if (m.locations < 3) {
        mesh_free(&m);
        return;
    }
    edge_list tree = tree_of(&m, points);
    claim_verdict("thm2.P6", judge(&m, points, tree));
    random_source *r = test_random_source();
    uint32_t i = random_below(r, tree.count), j = (i + 1) % tree.count;
    vertex_id kept[2] = {tree.ends[i][0], tree.ends[i][1]};

    tree.count--;
    CLAIM("thm2.P6", !judge(&m, points, tree).holds, "u-2 edges are a tree");
    tree.count++;
    edge_list all;
    CLAIM("thm2.P6", mesh_edges(&m, NULL, &all) == TRI_OK, "out of memory");
    CLAIM("thm2.P6", judge(&m, points, all).holds == (all.count < m.locations),
          "%u edges between %u locations are a tree", all.count, m.locations);
    edge_list_free(&all);
    tree.ends[i][0] = tree.ends[j][1];
    tree.ends[i][1] = tree.ends[j][0];
    CLAIM("thm2.P6", !judge(&m, points, tree).holds,
          "an edge there and back is no cycle");
    tree.ends[i][1] = tree.ends[i][0];
    CLAIM("thm2.P6", !judge(&m, points, tree).holds, "an edge has one end");
    tree.ends[i][1] = n;
    CLAIM("thm2.P6", !judge(&m, points, tree).holds, "point %u of %u is an end",
          n, n);
    for (vertex_id v = 0; v < n; v++)
        if (mesh_leaving(&m, v) == NONE) {
            tree.ends[i][0] = kept[0];
            tree.ends[i][1] = v;
            CLAIM("thm2.P6", !judge(&m, points, tree).holds,
                  "the copy %u is an end", v);
        }
    edge_list_free(&tree);
    mesh_free(&m);
}

/* ---- P7: the costs. ---- */

static void
few_comparisons_are_needed(void)
{
    enum { N = 5000, SIDE = 70 };
    random_source *r = test_random_source();
    point2 *points = malloc(N * sizeof *points);
    for (int grid = 0; grid < 2; grid++) {
        for (uint32_t i = 0; i < N; i++)
            points[i] = grid ? (point2){i % SIDE, i / SIDE} : random_point(r);
        mesh m = random_delaunay(points, N);
        edge_list edges;
        CLAIM("thm2.P7", mesh_edges(&m, NULL, &edges) == TRI_OK,
              "out of memory");
        uint64_t before = predicate_count.compare_distance;
        CLAIM("thm2.P7", sort_by_length(points, edges) == TRI_OK,
              "out of memory");
        uint64_t comparisons = predicate_count.compare_distance - before;
        CLAIM("thm2.P7", comparisons < edges.count,
              "%llu comparisons of %u edges", (unsigned long long)comparisons,
              edges.count);
        edge_list_free(&edges);
        mesh_free(&m);
    }
    free(points);
}

/* Where squares overflow, or vanish, all edges seem to be equally long. */
static void
extreme_lengths_are_sorted(void)
{
    for (int tiny = 0; tiny < 2; tiny++) {
        point2 points[40];
        for (int i = 0; i < 40; i++) {
            double x = random_below(test_random_source(), 1000);
            double unit = tiny ? 0x1p-1074 : 0x1p1013;
            points[i] = (point2){x * unit, i * unit};
        }
        uint64_t before = predicate_count.wide;
        edges_are_sorted(points, 40);
        CLAIM("thm2.P7", predicate_count.wide > before,
              "rounded lengths suffice");
        kruskal_is_prim(points, 40);
    }
}

/* ---- Memory that runs out. ---- */

static void
memory_may_run_out(void)
{
    const point2 points[] = {{0, 0}, {2, 0}, {2, 3}, {0, 2}, {1, 5}, {7, 2}};
    mesh m = random_delaunay(points, 6);
    edge_list tree, edges;
    verdict v;
    unsigned long k = 0;
    tri_status status = TRI_OUT_OF_MEMORY;
    while (status != TRI_OK) {
        memory_fail_at(++k);
        status = emst(&m, points, &tree);
        memory_fail_at(0);
        CLAIM("thm2.P5",
              status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                                   tree.ends == NULL && tree.count == 0),
              "allocation %lu", k);
    }
    CLAIM("thm2.P5", k > 5, "%lu allocations", k - 1);
    for (status = TRI_OUT_OF_MEMORY, k = 0; status != TRI_OK;) {
        memory_fail_at(++k);
        status = is_emst(&m, points, tree, &v);
        memory_fail_at(0);
        CLAIM("thm2.P6", status == TRI_OK || status == TRI_OUT_OF_MEMORY,
              "allocation %lu: %s", k, tri_status_text(status));
    }
    claim_verdict("thm2.P6", v);
    CLAIM("thm2.P6", k > 5, "%lu allocations", k - 1);
    for (status = TRI_OUT_OF_MEMORY, k = 0; status != TRI_OK;) {
        memory_fail_at(++k);
        status = mesh_edges(&m, NULL, &edges);
        memory_fail_at(0);
        CLAIM("mesh_edges",
              status == TRI_OK || (edges.ends == NULL && edges.count == 0),
              "allocation %lu", k);
    }
    edge_list_free(&edges);
    edge_list_free(&tree);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Theorem 2: minimum spanning trees lie in Delaunay");
    test_random("in the disc", in_the_disc_is_nearer_to_both, 500, 30);
    test_near_degenerate("in the disc", in_the_disc_is_nearer_to_both, 500, 12);
    test_near_degenerate("dot products", dot_products_are_exact, 1000, 20);
    test_random("every tree in the chain", every_tree_lies_in_the_chain, 1500,
                40);
    test_near_degenerate("every tree in the chain",
                         every_tree_lies_in_the_chain, 1500, 20);
    test_grid_subsets("every tree in the chain", every_tree_lies_in_the_chain,
                      3);
    test_random("Kruskal is Prim", kruskal_is_prim, 1500, 60);
    test_near_degenerate("Kruskal is Prim", kruskal_is_prim, 1000, 25);
    test_grid_subsets("Kruskal is Prim", kruskal_is_prim, 3);
    test_random("edges are sorted", edges_are_sorted, 1000, 60);
    test_near_degenerate("edges are sorted", edges_are_sorted, 1000, 25);
    test_random("exactly the minimum trees", accepts_exactly_the_minimum_trees,
                1500, 25);
    test_near_degenerate("exactly the minimum trees",
                         accepts_exactly_the_minimum_trees, 1000, 12);
    test_grid_subsets("exactly the minimum trees",
                      accepts_exactly_the_minimum_trees, 3);
    test_random("no tree at all", what_is_no_tree_is_refuted, 1000, 25);
    test_run("few comparisons", few_comparisons_are_needed);
    test_run("extreme lengths", extreme_lengths_are_sorted);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 12000,
                                  .largest_n = 55,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 10000});
}
