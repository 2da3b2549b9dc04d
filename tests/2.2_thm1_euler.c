/* Theorem 1, Euler's formula: a connected plane graph has v - e + f = 2.
 *
 * Hypotheses: the graph is drawn without crossings. Here a drawing is some of the
 * edges of a triangulation that has been flipped at random; it has several
 * components or is connected, as chance will have it, and both are tried.
 *
 * Three counts that know nothing of each other meet in each trial: faces as walks
 * around them (graph_trace_faces), faces as regions of triangles that flow together
 * where an edge is missing (flood), and components by joining sets. The proof's two
 * trees are looked at one by one (page 2.2, P2 to P5).
 */
#include "chapters/2.2_eulers_formula/euler.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

#include <stdlib.h>

/* ---- Sets that are joined: the test's own way to components and cycles. ---- */

static uint32_t *
new_sets(uint32_t n)
{
    uint32_t *parent = malloc((n + 1) * sizeof *parent);
    for (uint32_t i = 0; i < n; i++)
        parent[i] = i;
    return parent;
}

static uint32_t
set_of(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/* Were a and b in different sets until now? */
static bool
join_sets(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = set_of(parent, a);
    b = set_of(parent, b);
    parent[a] = b;
    return a != b;
}

static uint32_t
count_sets(uint32_t *parent, uint32_t n)
{
    uint32_t sets = 0;
    for (uint32_t i = 0; i < n; i++)
        sets += set_of(parent, i) == i;
    return sets;
}

/* ---- Random drawings. ---- */

typedef struct drawing {
    mesh m; /* the triangulation whose edges are drawn in part */
    point2 *points;
    uint32_t n;        /* of the points, all distinct */
    halfedge_id *side; /* edge -> the mesh's half-edge that is the graph's 2k */
    edge_ends *edge;
    uint32_t edges;
    uint32_t *region; /* triangle t is in set t+1, the outside in set 0 */
    plane_graph g;
} drawing;

/* The region left of the mesh's half-edge e. */
static uint32_t
region_left_of(const drawing *d, halfedge_id e)
{
    return set_of(d->region, mesh_in_triangle(&d->m, e) ? mesh_triangle_of(e) + 1 : 0);
}

/* The region left of half-edge h of the graph. */
static uint32_t
region_of(const drawing *d, halfedge_id h)
{
    halfedge_id e = d->side[h / 2];
    return region_left_of(d, h % 2 == 0 ? e : mesh_twin(&d->m, e));
}

static void
triangulate(drawing *d, const point2 *points, uint32_t n)
{
    vertex_id *order = malloc((n + 1) * sizeof *order);
    d->points = malloc((n + 1) * sizeof *d->points);
    CLAIM("thm1.P1", sort_along(points, n, (point2){1, 0}, order, &d->n) == TRI_OK,
          "no memory for %u points", n);
    for (uint32_t i = 0; i < d->n; i++) /* in random order, without duplicates */
        d->points[i] = points[order[i]];
    for (uint32_t i = d->n; i > 1; i--) {
        uint32_t j = random_below(test_random_source(), i);
        point2 p = d->points[j];
        d->points[j] = d->points[i - 1];
        d->points[i - 1] = p;
    }
    free(order);
    CLAIM("thm1.P1", sweep_triangulate(d->points, d->n, NULL, &d->m) == TRI_OK,
          "no mesh of %u points", d->n);
    for (uint32_t i = 0; i < mesh_halfedges(&d->m); i++) {
        halfedge_id e = random_below(test_random_source(), mesh_halfedges(&d->m));
        if (is_flippable(&d->m, d->points, e))
            flip(&d->m, e);
    }
}

/* Is e an edge of the triangulation, as one of its triangles or a path sees it? */
static bool
is_side(const mesh *m, halfedge_id e)
{
    return mesh_in_triangle(m, e) || mesh_is_hull_edge(m, e);
}

/* Keeps each edge with a probability of 0, 1/4, ... or 1; if `connected`, also each
 * edge that is needed for a path. Regions flow together where none is kept. */
static void
draw_some_edges(drawing *d, bool connected)
{
    uint32_t *joined = new_sets(d->n), halfedges = mesh_halfedges(&d->m);
    uint32_t quarters = random_below(test_random_source(), 5);
    d->region = new_sets(d->m.triangles + 1);
    d->side = malloc((halfedges + 1) * sizeof *d->side);
    d->edge = malloc((halfedges + 1) * sizeof *d->edge);
    d->edges = 0;
    for (halfedge_id e = 0; e < halfedges; e++) {
        if (!is_side(&d->m, e) ||
            (mesh_twin(&d->m, e) < e && is_side(&d->m, mesh_twin(&d->m, e))))
            continue; /* no edge, or one that has been met from its other side */
        vertex_id a = mesh_origin(&d->m, e), b = mesh_dest(&d->m, e);
        bool needed = join_sets(joined, a, b) && connected;
        if (needed || random_below(test_random_source(), 4) < quarters) {
            d->side[d->edges] = e;
            d->edge[d->edges++] = (edge_ends){a, b};
        } else {
            join_sets(d->region, region_left_of(d, e),
                      region_left_of(d, mesh_twin(&d->m, e)));
        }
    }
    free(joined);
    CLAIM("thm1.P1", graph_from_drawing(d->points, d->n, d->edge, d->edges, &d->g) ==
                         TRI_OK, "no graph with %u edges", d->edges);
}

static drawing
random_drawing(const point2 *points, uint32_t n, bool connected)
{
    drawing d = {0};
    triangulate(&d, points, n);
    draw_some_edges(&d, connected);
    return d;
}

static void
drawing_free(drawing *d)
{
    graph_free(&d->g);
    mesh_free(&d->m);
    free(d->points);
    free(d->side);
    free(d->edge);
    free(d->region);
}

static uint32_t
count_regions(const drawing *d)
{
    uint32_t regions = 1; /* the one with the outside */
    for (halfedge_id e = 0; e < mesh_halfedges(&d->m); e += 3)
        if (mesh_in_triangle(&d->m, e))
            regions += set_of(d->region, e / 3 + 1) == e / 3 + 1 &&
                       set_of(d->region, 0) != e / 3 + 1;
    return regions;
}

static uint32_t
count_components(const plane_graph *g)
{
    uint32_t *joined = new_sets(g->vertices);
    for (uint32_t k = 0; k < g->edges; k++)
        join_sets(joined, g->origin[2 * k], g->origin[2 * k + 1]);
    uint32_t components = count_sets(joined, g->vertices);
    free(joined);
    return components;
}

static euler_counts
counts_of(const plane_graph *g)
{
    euler_counts c = {0};
    CLAIM("thm1.P5", euler_count(g, &c) == TRI_OK, "no counts of %u edges", g->edges);
    return c;
}

/* ---- P1: the walks are the faces. ---- */

static void
check_walks(const drawing *d, const euler_counts *c)
{
    face_id *left = malloc((2 * d->edges + 1) * sizeof *left);
    uint32_t *of_walk = malloc((2 * d->edges + 1) * sizeof *of_walk);
    uint32_t walks = graph_trace_faces(&d->g, left);
    for (halfedge_id h = 0; h < 2 * d->edges; h++)
        of_walk[left[h]] = region_of(d, h);
    for (halfedge_id h = 0; h < 2 * d->edges; h++)
        CLAIM("thm1.P1", of_walk[left[h]] == region_of(d, h),
              "the walk at %u %u leaves its face", d->g.origin[h],
              graph_dest(&d->g, h));
    uint32_t regions = count_regions(d);
    if (c->components == 1)
        CLAIM("thm1.P1", walks == regions, "%u walks, %u regions", walks, regions);
    if (d->g.outside != NONE)
        CLAIM("thm1.P1", region_of(d, d->g.outside) == set_of(d->region, 0),
              "half-edge %u is not on the outer face", d->g.outside);
    CLAIM("thm1.P1", c->f == regions, "%u faces counted, %u regions", c->f, regions);
    uint32_t around = 0; /* the sides that have the outer face on their left */
    for (halfedge_id h = 0; h < 2 * d->edges; h++)
        around += region_of(d, h) == set_of(d->region, 0);
    if (c->components == 1)
        CLAIM("thm1.P1", c->h == around, "h = %u, and %u sides", c->h, around);
    free(of_walk);
    free(left);
}

static void
walks_are_faces(const point2 *points, uint32_t n)
{
    drawing d = random_drawing(points, n, random_below(test_random_source(), 2) == 0);
    euler_counts c = counts_of(&d.g);
    uint32_t components = count_components(&d.g);
    CLAIM("thm1.P6", c.components == components, "%u components, %u are joined",
          c.components, components);
    CLAIM("thm1.P6", c.v - c.e + c.f == 1 + c.components,
          "v = %u, e = %u, f = %u in %u components", c.v, c.e, c.f, c.components);
    check_walks(&d, &c);
    drawing_free(&d);
}

/* Both ways to a plane graph lead to the same one. */
static void
mesh_and_drawing_agree(const point2 *points, uint32_t n)
{
    drawing d = {0};
    triangulate(&d, points, n);
    plane_graph g, again;
    CLAIM("thm1.P1", graph_from_mesh(&d.m, &g) == TRI_OK, "no graph of %u points", d.n);
    edge_ends *edge = malloc((g.edges + 1) * sizeof *edge);
    for (uint32_t k = 0; k < g.edges; k++)
        edge[k] = (edge_ends){g.origin[2 * k], g.origin[2 * k + 1]};
    CLAIM("thm1.P1", graph_from_drawing(d.points, d.n, edge, g.edges, &again) == TRI_OK,
          "no graph with %u edges", g.edges);
    for (halfedge_id h = 0; h < 2 * g.edges; h++)
        CLAIM("thm1.P1", g.next[h] == again.next[h], "after %u %u comes %u or %u",
              g.origin[h], graph_dest(&g, h), graph_dest(&g, g.next[h]),
              graph_dest(&again, again.next[h]));
    euler_counts a = counts_of(&g), b = counts_of(&again);
    CLAIM("thm1.P1", a.h == b.h && a.f == b.f, "h = %u or %u, f = %u or %u", a.h, b.h,
          a.f, b.f);
    free(edge);
    graph_free(&g);
    graph_free(&again);
    drawing_free(&d);
}

/* ---- P2 to P5: the proof. ---- */

static void
check_tree(const plane_graph *g, const edge_part *part)
{
    uint32_t *joined = new_sets(g->vertices), edges = 0;
    for (uint32_t k = 0; k < g->edges; k++)
        if (part[k] == IN_TREE) {
            vertex_id a = g->origin[2 * k], b = g->origin[2 * k + 1];
            CLAIM("thm1.P2", join_sets(joined, a, b), "%u %u closes a cycle", a, b);
            edges++;
        }
    uint32_t trees = count_sets(joined, g->vertices);
    CLAIM("thm1.P2", trees == 1 && edges == g->vertices - 1,
          "%u trees with %u edges and %u vertices", trees, edges, g->vertices);
    free(joined);
}

/* Looks at the regions, not at the walks that the dual is made of: P3, the co-tree
 * joins them all; P4, no edge outside T closes a cycle. */
static void
check_cotree(const drawing *d, const edge_part *part)
{
    uint32_t *by_cotree = new_sets(d->m.triangles + 1);
    uint32_t *by_all = new_sets(d->m.triangles + 1);
    uint32_t joined = 1, regions = count_regions(d);
    for (uint32_t k = 0; k < d->edges; k++) {
        uint32_t left = region_of(d, 2 * k), right = region_of(d, 2 * k + 1);
        if (part[k] == IN_COTREE)
            joined += join_sets(by_cotree, left, right);
        if (part[k] != IN_TREE)
            CLAIM("thm1.P4", join_sets(by_all, left, right),
                  "the dual edge across %u %u closes a cycle", d->edge[k].a,
                  d->edge[k].b);
    }
    CLAIM("thm1.P3", joined == regions, "%u of %u regions are joined", joined, regions);
    free(by_all);
    free(by_cotree);
}

static void
the_two_trees(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    drawing d = random_drawing(points, n, true);
    euler_counts c = counts_of(&d.g);
    edge_part *part = malloc((d.edges + 1) * sizeof *part);
    CLAIM("thm1.P5", c.components == 1, "%u components", c.components);
    CLAIM("thm1.P5", c.v - c.e + c.f == 2, "v = %u, e = %u, f = %u", c.v, c.e, c.f);
    CLAIM("thm1.P5", tree_and_cotree(&d.g, part) == TRI_OK, "no trees of %u edges",
          c.e);
    check_tree(&d.g, part);
    check_cotree(&d, part);
    free(part);
    drawing_free(&d);
}

/* What the notes' proof does not say: the two trees together use each edge once. */
static void
e5_every_edge_once(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    drawing d = random_drawing(points, n, true);
    edge_part *part = malloc((d.edges + 1) * sizeof *part);
    uint32_t in_tree = 0, in_cotree = 0, regions = count_regions(&d);
    CLAIM("E5", tree_and_cotree(&d.g, part) == TRI_OK, "no trees of %u edges", d.edges);
    for (uint32_t k = 0; k < d.edges; k++) {
        in_tree += part[k] == IN_TREE;
        in_cotree += part[k] == IN_COTREE;
    }
    CLAIM("E5", in_tree == d.n - 1 && in_cotree == regions - 1 &&
          in_tree + in_cotree == d.edges, "%u edges and %u dual edges, v = %u, f = %u, "
          "e = %u", in_tree, in_cotree, d.n, regions, d.edges);
    free(part);
    drawing_free(&d);
}

/* ---- P7: the dual. ---- */

/* Do two half-edges of the dual have the same face on their left exactly when those
 * that they cross enter the same vertex? */
static void
check_dual_faces(const plane_graph *g, const plane_graph *dual)
{
    face_id *left = malloc((2 * g->edges + 1) * sizeof *left);
    face_id *around = malloc((g->vertices + 1) * sizeof *around); /* vertex -> face */
    uint32_t faces = graph_trace_faces(dual, left);
    CLAIM("thm1.P7", faces == g->vertices, "f* = %u, v = %u", faces, g->vertices);
    for (halfedge_id h = 0; h < 2 * g->edges; h++)
        around[graph_dest(g, h)] = left[h];
    for (halfedge_id h = 0; h < 2 * g->edges; h++)
        CLAIM("thm1.P7", around[graph_dest(g, h)] == left[h],
              "two faces of the dual at vertex %u", graph_dest(g, h));
    free(around);
    free(left);
}

/* Simple, by comparing all pairs of edges. */
static bool
all_pairs_simple(const plane_graph *g)
{
    for (uint32_t j = 0; j < g->edges; j++) {
        vertex_id a = g->origin[2 * j], b = g->origin[2 * j + 1];
        if (a == b)
            return false;
        for (uint32_t k = 0; k < j; k++) {
            vertex_id c = g->origin[2 * k], d = g->origin[2 * k + 1];
            if ((a == c && b == d) || (a == d && b == c))
                return false;
        }
    }
    return true;
}

static void
the_dual_of_a_graph(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    drawing d = random_drawing(points, n, true);
    euler_counts c = counts_of(&d.g);
    plane_graph dual;
    bool connected = false, simple = false, dual_simple = false;
    CLAIM("thm1.P7", graph_dual(&d.g, &dual) == TRI_OK &&
          graph_is_connected(&dual, &connected) == TRI_OK &&
          graph_is_simple(&d.g, &simple) == TRI_OK &&
          graph_is_simple(&dual, &dual_simple) == TRI_OK, "no dual of %u edges", c.e);
    CLAIM("thm1.P7", dual.vertices == c.f && dual.edges == c.e && connected,
          "v* = %u, f = %u, e* = %u, e = %u", dual.vertices, c.f, dual.edges, c.e);
    check_dual_faces(&d.g, &dual);
    CLAIM("graph.P1", simple, "a straight drawing of %u edges is not simple", c.e);
    CLAIM("graph.P1", dual_simple == all_pairs_simple(&dual), "simple: %d",
          dual_simple);
    graph_free(&dual);
    drawing_free(&d);
}

/* ---- Paths. ---- */

/* vertex -> the fewest edges of a path from `from`, by relaxing all edges. */
static uint32_t *
distances(const plane_graph *g, vertex_id from)
{
    uint32_t *distance = malloc((g->vertices + 1) * sizeof *distance);
    for (vertex_id v = 0; v < g->vertices; v++)
        distance[v] = v == from ? 0 : NONE;
    for (bool changed = true; changed;) {
        changed = false;
        for (halfedge_id h = 0; h < 2 * g->edges; h++) {
            uint32_t *a = &distance[g->origin[h]], *b = &distance[graph_dest(g, h)];
            if (*a != NONE && *a + 1 < *b) {
                *b = *a + 1;
                changed = true;
            }
        }
    }
    return distance;
}

static void
paths_are_shortest(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    drawing d = random_drawing(points, n, false);
    vertex_id from = random_below(test_random_source(), d.n);
    uint32_t *distance = distances(&d.g, from), length = 0;
    halfedge_id *path = malloc(d.n * sizeof *path);
    bool all = true, connected = false;
    for (vertex_id to = 0; to < d.n; to++) {
        CLAIM("graph.P2", graph_path(&d.g, from, to, path, &length) == TRI_OK,
              "no memory for %u vertices", d.n);
        CLAIM("graph.P2", length == distance[to], "%u edges from %u to %u, or %u",
              length, from, to, distance[to]);
        vertex_id at = from;
        for (uint32_t i = 0; length != NONE && i < length; i++) {
            CLAIM("graph.P2", d.g.origin[path[i]] == at, "the path jumps from %u", at);
            at = graph_dest(&d.g, path[i]);
        }
        CLAIM("graph.P2", length == NONE || at == to, "it ends at %u, not %u", at, to);
        all = all && length != NONE;
    }
    CLAIM("graph.P2",
          graph_is_connected(&d.g, &connected) == TRI_OK && connected == all,
          "connected: %d, paths to all: %d", connected, all);
    free(path);
    free(distance);
    drawing_free(&d);
}

/* ---- (3) and (4) for all plane graphs; triangulations: 2.2_eq2_to_4.c. ---- */

static void
plane_graphs_are_sparse(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 2);
    drawing d = random_drawing(points, n, random_below(test_random_source(), 2) == 0);
    euler_counts c = counts_of(&d.g);
    if (c.v > 2) {
        CLAIM("eq4.P1", c.e <= 3 * c.v - 6, "v = %u, e = %u", c.v, c.e);
        CLAIM("eq4.P1", c.f <= 2 * c.v - 4, "v = %u, f = %u", c.v, c.f);
    }
    bool triangles = true;
    for (halfedge_id h = 0; h < 2 * c.e && c.v > 2 && c.components == 1; h++) {
        halfedge_id third = d.g.next[d.g.next[h]];
        CLAIM("eq3.P1", d.g.next[h] != h && third != h, "few sides at half-edge %u", h);
        triangles = triangles && d.g.next[third] == h;
    }
    if (c.v > 2 && c.components == 1) {
        CLAIM("eq3.P1", 3 * c.f <= 2 * c.e, "f = %u, e = %u", c.f, c.e);
        CLAIM("eq3.P1", (3 * c.f == 2 * c.e) == triangles, "f = %u, e = %u", c.f, c.e);
        CLAIM("eq4.P1",
              (c.e == 3 * c.v - 6) == triangles && (c.f == 2 * c.v - 4) == triangles,
              "v = %u, e = %u, f = %u", c.v, c.e, c.f);
    }
    drawing_free(&d);
}

/* ---- Every order around the vertices of K4 and K5. ---- */

/* The edges of the complete graph, and nothing yet about their order. */
static plane_graph
complete_graph(uint32_t n)
{
    plane_graph g = {.vertices = n, .edges = n * (n - 1) / 2, .outside = NONE};
    g.origin = memory_array(g.edges, 2 * sizeof *g.origin);
    g.next = memory_array(g.edges, 2 * sizeof *g.next);
    g.leaving = memory_array(g.vertices, sizeof *g.leaving);
    halfedge_id h = 0;
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = 0; b < a; b++) {
            g.leaving[a] = h;
            g.leaving[b] = h + 1;
            g.origin[h++] = a;
            g.origin[h++] = b;
        }
    return g;
}

/* Orders the half-edges around v, of which there are 3 or 4: the first one stays, the
 * others follow it in the order that `number` names. */
static void
order_around(plane_graph *g, vertex_id v, uint32_t number)
{
    static const uint8_t order[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                        {2, 1, 0}, {1, 2, 0}, {2, 0, 1}};
    halfedge_id spoke[4], first = NONE;
    uint32_t others = 0;
    for (halfedge_id h = 0; h < 2 * g->edges; h++)
        if (g->origin[h] == v) {
            if (first == NONE)
                first = h;
            else
                spoke[others++] = h;
        }
    halfedge_id h = first;
    for (uint32_t i = 0; i < 3; i++)
        if (order[number][i] < others) {
            halfedge_id after = spoke[order[number][i]];
            g->next[graph_twin(h)] = after;
            h = after;
        }
    g->next[graph_twin(h)] = first;
}

/* How many of all orders are plane? In each, v-e+f is 2 minus the edges left over. */
static uint32_t
count_plane_orders(uint32_t n, uint32_t orders_a_vertex, uint32_t *tried)
{
    plane_graph g = complete_graph(n);
    edge_part part[10];
    uint32_t plane = 0, orders = 1;
    for (vertex_id v = 0; v < n; v++)
        orders *= orders_a_vertex;
    for (uint32_t i = 0; i < orders; i++) {
        uint32_t rest = i, over = 0;
        for (vertex_id v = 0; v < n; v++) {
            order_around(&g, v, rest % orders_a_vertex);
            rest /= orders_a_vertex;
        }
        euler_counts c = counts_of(&g);
        CLAIM("thm1.P8", tree_and_cotree(&g, part) == TRI_OK, "no trees of %u", n);
        for (uint32_t k = 0; k < g.edges; k++)
            over += part[k] == IN_NEITHER;
        CLAIM("thm1.P8", c.v - c.e + c.f + over == 2, "order %u: f = %u, %u left over",
              i, c.f, over);
        CLAIM("thm1.P8", over % 2 == 0, "order %u: %u left over", i, over);
        plane += over == 0;
    }
    graph_free(&g);
    *tried = orders;
    return plane;
}

static void
k4_is_planar(void)
{
    uint32_t tried, plane = count_plane_orders(4, 2, &tried);
    CLAIM("planar.P1", tried == 16 && plane == 2, "%u of %u orders", plane, tried);
    const point2 points[] = {{0, 0}, {4, 0}, {2, 3}, {2, 1}};
    const edge_ends edge[] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    plane_graph g;
    CLAIM("planar.P1", graph_from_drawing(points, 4, edge, 6, &g) == TRI_OK, "no %s",
          "K4");
    euler_counts c = counts_of(&g);
    CLAIM("planar.P1", c.f == 4 && c.h == 3, "K4 drawn: f = %u, h = %u", c.f, c.h);
    graph_free(&g);
}

static void
k5_is_not(void)
{
    uint32_t tried, plane = count_plane_orders(5, 6, &tried);
    CLAIM("planar.P2", tried == 7776 && plane == 0, "%u of %u orders", plane, tried);
    plane_graph g = complete_graph(5);
    CLAIM("planar.P2", g.edges > 3 * g.vertices - 6, "K5 has %u edges", g.edges);
    graph_free(&g);
}

/* ---- The errata of the theorem, and memory that runs out. ---- */

static void
e4_duals_are_not_simple(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {0, 1}};
    const edge_ends edge[] = {{0, 1}, {1, 2}, {2, 0}};
    plane_graph g, dual;
    bool simple = true;
    CLAIM("E4", graph_from_drawing(points, 2, edge, 1, &g) == TRI_OK &&
          graph_dual(&g, &dual) == TRI_OK && graph_is_simple(&dual, &simple) == TRI_OK,
          "no dual of %s", "K2");
    CLAIM("E4",
          dual.vertices == 1 && dual.edges == 1 && !simple &&
              dual.origin[0] == dual.origin[1],
          "the dual of K2 has %u vertices", dual.vertices);
    graph_free(&g);
    graph_free(&dual);
    CLAIM("E4", graph_from_drawing(points, 3, edge, 3, &g) == TRI_OK &&
          graph_dual(&g, &dual) == TRI_OK && graph_is_simple(&dual, &simple) == TRI_OK,
          "no dual of %s", "a triangle");
    CLAIM("E4", dual.vertices == 2 && dual.edges == 3 && !simple,
          "the dual of a triangle has %u vertices", dual.vertices);
    for (halfedge_id h = 0; h < 6; h++)
        CLAIM("E4", dual.origin[h] != graph_dest(&dual, h), "half-edge %u is a loop",
              h);
    graph_free(&g);
    graph_free(&dual);
}

/* Graphs with nothing in them, and graphs with too much. */
static void
the_smallest_and_the_largest(void)
{
    plane_graph g, dual;
    bool yes = false;
    CLAIM("graph.P2", graph_from_drawing(NULL, 0, NULL, 0, &g) == TRI_OK &&
          graph_is_connected(&g, &yes) == TRI_OK && yes,
          "the graph with %u vertices is not connected", g.vertices);
    CLAIM("thm1.P7", graph_dual(&g, &dual) == TRI_OK && dual.vertices == 0,
          "%u faces of nothing", dual.vertices);
    graph_free(&dual);
    graph_free(&g);
    tri_status status = graph_from_drawing(NULL, 0, NULL, UINT32_MAX / 2 + 1, &g);
    CLAIM("thm1.P1", status == TRI_TOO_MANY_POINTS && g.origin == NULL,
          "more half-edges than numbers: %s", tri_status_text(status));
}

/* Everything that allocates, once. */
static tri_status
all_of_it(const mesh *m, const point2 *points)
{
    const edge_ends edge[] = {{0, 1}, {1, 2}};
    plane_graph g = {0}, dual = {0}, drawn = {0};
    edge_part part[64];
    halfedge_id path[64];
    euler_counts c;
    uint32_t length;
    bool yes;
    tri_status status = graph_from_mesh(m, &g);
    if (status == TRI_OK)
        status = graph_from_drawing(points, 3, edge, 2, &drawn);
    if (status == TRI_OK)
        status = graph_dual(&g, &dual);
    if (status == TRI_OK)
        status = euler_count(&g, &c);
    if (status == TRI_OK)
        status = tree_and_cotree(&g, part);
    if (status == TRI_OK)
        status = graph_is_simple(&g, &yes);
    if (status == TRI_OK)
        status = graph_is_connected(&g, &yes);
    if (status == TRI_OK)
        status = graph_path(&g, 0, 1, path, &length);
    graph_free(&drawn);
    graph_free(&dual);
    graph_free(&g);
    return status;
}

static void
memory_may_run_out(void)
{
    point2 points[12];
    mesh m;
    for (int i = 0; i < 12; i++)
        points[i] = (point2){i % 4, i / 4};
    CLAIM("thm1.P5", sweep_triangulate(points, 12, NULL, &m) == TRI_OK, "no %s",
          "mesh");
    unsigned long failures = 0;
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = all_of_it(&m, points);
        memory_fail_at(0);
        CLAIM("thm1.P5", status == TRI_OK || status == TRI_OUT_OF_MEMORY,
              "allocation %lu: %s", k, tri_status_text(status));
        failures += status == TRI_OUT_OF_MEMORY;
    }
    CLAIM("thm1.P5", failures > 20, "only %lu allocations failed", failures);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Theorem 1: a connected plane graph has v - e + f = 2");
    test_random("walks are faces", walks_are_faces, 3000, 60);
    test_near_degenerate("walks are faces", walks_are_faces, 2000, 30);
    test_grid_subsets("walks are faces", walks_are_faces, 4);
    test_random("mesh and drawing agree", mesh_and_drawing_agree, 2000, 60);
    test_near_degenerate("mesh and drawing agree", mesh_and_drawing_agree, 2000, 30);
    test_random("tree and co-tree", the_two_trees, 3000, 100);
    test_near_degenerate("tree and co-tree", the_two_trees, 1000, 30);
    test_grid_subsets("tree and co-tree", the_two_trees, 3);
    test_random("E5: every edge once", e5_every_edge_once, 1000, 60);
    test_random("the dual", the_dual_of_a_graph, 2000, 60);
    test_near_degenerate("the dual", the_dual_of_a_graph, 500, 30);
    test_random("paths", paths_are_shortest, 1000, 40);
    test_random("plane graphs are sparse", plane_graphs_are_sparse, 3000, 40);
    test_grid_subsets("plane graphs are sparse", plane_graphs_are_sparse, 3);
    test_run("K4 is planar", k4_is_planar);
    test_run("K5 is not", k5_is_not);
    test_run("E4: duals are not simple", e4_duals_are_not_simple);
    test_run("the smallest and the largest", the_smallest_and_the_largest);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 80000, .largest_n = 90, .zeros = 100000,
                                  .expansions = 1000, .wide = 1000});
}
