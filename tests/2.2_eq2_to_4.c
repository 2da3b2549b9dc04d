/* Equations (2), (3), (4): the numbers of edges and triangles of a triangulation.
 *
 * With v locations, t triangles and h sides of the outer face: 3t = 2e-h and
 * v-e+t = 1, hence e = 3v-3-h and t = 2v-2-h.
 *
 * Hypotheses: v >= 1 for the equations, collinear points too; v >= 3 for the bounds
 * e <= 3v-6 and f <= 2v-4. The same bounds for all plane graphs: 2.2_thm1_euler.c.
 *
 * Nothing is derived: e, f and h are counted by walking (euler_count), t on the list
 * of triangles, and h once more by asking for each edge on which side the points lie.
 */
#include "chapters/2.2_eulers_formula/euler.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/contents.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

#include <stdlib.h>

/* ---- What is counted. ---- */

typedef struct counted {
    euler_counts c;
    uint32_t t;
} counted;

static counted
count_mesh(const mesh *m)
{
    counted k = {0};
    triangle_list list;
    plane_graph g;
    CLAIM("eq2.P1", mesh_triangles(m, &list) == TRI_OK &&
          graph_from_mesh(m, &g) == TRI_OK && euler_count(&g, &k.c) == TRI_OK,
          "no counts of %u points", m->points);
    k.t = list.count;
    graph_free(&g);
    triangle_list_free(&list);
    return k;
}

/* For the errata: the counts of the first algorithm. */
static counted
count_points(const point2 *points, uint32_t n)
{
    mesh m;
    CLAIM("eq2.P1", contents[0].triangulate(points, n, NULL, &m) == TRI_OK,
          "no mesh of %u points", n);
    counted k = count_mesh(&m);
    mesh_free(&m);
    return k;
}

/* How many edges have all points on one side of their line, or on it. */
static uint32_t
count_hull_edges(const plane_graph *g, const point2 *points, uint32_t n)
{
    uint32_t hull_edges = 0;
    for (halfedge_id h = 0; h < 2 * g->edges; h++) {
        uint32_t right = 0;
        for (vertex_id p = 0; p < n; p++)
            right += orient2d(points[g->origin[h]], points[graph_dest(g, h)],
                              points[p]) < 0;
        hull_edges += right == 0; /* on a path, counted in both directions */
    }
    return hull_edges;
}

/* ---- The equations. ---- */

static void
check_equations(const counted *k, const char *name)
{
    uint32_t v = k->c.v, e = k->c.e, f = k->c.f, h = k->c.h, t = k->t;
    CLAIM("eq2.P1", 3 * t == 2 * e - h, "%s: t = %u, e = %u, h = %u", name, t, e, h);
    CLAIM("eq2.P2", f == t + 1 && v - e + t == 1, "%s: v = %u, e = %u, t = %u, f = %u",
          name, v, e, t, f);
    CLAIM("eq2.P3", e == 3 * v - 3 - h && t == 2 * v - 2 - h,
          "%s: v = %u, e = %u, t = %u, h = %u", name, v, e, t, h);
    if (v < 3)
        return;
    CLAIM("eq3.P2", 3 * f <= 2 * e && (3 * f == 2 * e) == (h == 3),
          "%s: f = %u, e = %u, h = %u", name, f, e, h);
    CLAIM("eq4.P2", e <= 3 * v - 6 && (e == 3 * v - 6) == (h == 3),
          "%s: v = %u, e = %u, h = %u", name, v, e, h);
    CLAIM("eq4.P2", f <= 2 * v - 4 && (f == 2 * v - 4) == (h == 3),
          "%s: v = %u, f = %u, h = %u", name, v, f, h);
}

static void
every_algorithm_obeys(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    const algorithm *row;
    do /* one of them for each trial: there are trials enough for all */
        row = &contents[random_below(test_random_source(), contents_count)];
    while (n > row->most);
    mesh m;
    tri_status status = row->triangulate(points, n, NULL, &m);
    CLAIM("eq2.P1", status == TRI_OK, "%s: %s", row->name, tri_status_text(status));
    counted k = count_mesh(&m);
    CLAIM("eq2.P1", k.c.v == m.locations && k.c.components == 1, "%u of %u, in %u",
          k.c.v, m.locations, k.c.components);
    check_equations(&k, row->name);
    mesh_free(&m);
}

/* h is what the notes say: the edges on the boundary of the convex hull. */
static void
h_is_counted_twice(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    mesh m;
    plane_graph g;
    euler_counts c = {0};
    CLAIM("eq2.P1", contents[0].triangulate(points, n, NULL, &m) == TRI_OK &&
          graph_from_mesh(&m, &g) == TRI_OK && euler_count(&g, &c) == TRI_OK,
          "no graph of %u points", n);
    point2 *used = malloc(n * sizeof *used); /* the points as the graph numbers them */
    uint32_t u = 0;
    for (vertex_id v = 0; v < n; v++)
        if (mesh_leaving(&m, v) != NONE)
            used[u++] = points[v];
    uint32_t hull_edges = count_hull_edges(&g, used, u);
    CLAIM("eq2.P1", c.h == hull_edges && c.h == mesh_hull_size(&m),
          "h = %u, %u edges have all points on one side", c.h, hull_edges);
    free(used);
    graph_free(&g);
    mesh_free(&m);
}

/* ---- Maximal among straight-line graphs. ---- */

/* Is p strictly inside the segment from a to b? */
static bool
lies_inside(point2 a, point2 b, point2 p)
{
    const point2 x = {1, 0};
    return orient2d(a, b, p) == 0 &&
           compare_along(x, a, p) * compare_along(x, p, b) > 0;
}

/* Do the segments ab and cd cross in a point that is an end of neither? */
static bool
cross_inside(point2 a, point2 b, point2 c, point2 d)
{
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 &&
           orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

/* Is a b an edge, or is there something in the way of drawing it? */
static bool
joined_or_blocked(const mesh *m, const point2 *points, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (!mesh_in_triangle(m, e) && !mesh_is_hull_edge(m, e))
            continue;
        vertex_id c = mesh_origin(m, e), d = mesh_dest(m, e);
        if ((a == c && b == d) || (a == d && b == c) ||
            lies_inside(points[a], points[b], points[c]) ||
            cross_inside(points[a], points[b], points[c], points[d]))
            return true;
    }
    return false;
}

static void
no_edge_can_be_added(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < contents_count; i++) {
        mesh m;
        CLAIM("eq4.P3", contents[i].triangulate(points, n, NULL, &m) == TRI_OK,
              "%s: no mesh", contents[i].name);
        for (vertex_id a = 0; a < n; a++)
            for (vertex_id b = 0; b < a; b++)
                if (mesh_leaving(&m, a) != NONE && mesh_leaving(&m, b) != NONE)
                    CLAIM("eq4.P3", joined_or_blocked(&m, points, a, b),
                          "%s: %u and %u can be joined", contents[i].name, a, b);
        mesh_free(&m);
    }
}

/* ---- The errata. ---- */

static const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/* The half-edge that leaves v along the outer face. */
static halfedge_id
leave_along_outside(const plane_graph *g, vertex_id v)
{
    halfedge_id h = g->outside;
    while (g->origin[h] != v)
        h = g->next[h];
    return h;
}

static halfedge_id
before(const plane_graph *g, halfedge_id h)
{
    halfedge_id s = h;
    while (g->next[s] != h)
        s = g->next[s];
    return s;
}

/* Draws the edge a b as a curve through the outer face, which it divides. Requires:
 * room for one more edge. */
static void
join_through_outside(plane_graph *g, vertex_id a, vertex_id b)
{
    halfedge_id ab = 2 * g->edges, ba = ab + 1;
    halfedge_id from_a = leave_along_outside(g, a), from_b = leave_along_outside(g, b);
    halfedge_id to_a = before(g, from_a), to_b = before(g, from_b);
    g->edges++;
    g->origin[ab] = a;
    g->origin[ba] = b;
    g->next[to_a] = ab;
    g->next[ab] = from_b;
    g->next[to_b] = ba;
    g->next[ba] = from_a;
}

static void
e6_one_more_edge_around_the_outside(void)
{
    mesh m;
    plane_graph g;
    euler_counts c = {0};
    CLAIM("E6", contents[0].triangulate(square, 4, NULL, &m) == TRI_OK &&
          graph_from_mesh(&m, &g) == TRI_OK, "no graph of %u points", 4u);
    g.origin = memory_resize(g.origin, 12, sizeof *g.origin);
    g.next = memory_resize(g.next, 12, sizeof *g.next);
    CLAIM("E6", g.edges == 5 && g.origin != NULL && g.next != NULL, "e = %u", g.edges);

    bool joined[4][4] = {{false}}, simple = false;
    for (halfedge_id h = 0; h < 10; h++)
        joined[g.origin[h]][graph_dest(&g, h)] = true;
    vertex_id a = joined[0][2] ? 1 : 0;
    CLAIM("E6", !joined[a][a + 2], "both diagonals: %u %u", a, a + 2);
    no_edge_can_be_added(square, 4);

    join_through_outside(&g, a, a + 2);
    CLAIM("E6", euler_count(&g, &c) == TRI_OK && graph_is_simple(&g, &simple) == TRI_OK,
          "no counts of %u edges", g.edges);
    CLAIM("E6", simple && c.e == 3 * c.v - 6 && c.v - c.e + c.f == 2,
          "v = %u, e = %u, f = %u", c.v, c.e, c.f);
    graph_free(&g);
    mesh_free(&m);
}

static void
e7_f_means_two_things(void)
{
    counted k = count_points(square, 4);
    uint32_t v = k.c.v, e = k.c.e, f = k.c.f, h = k.c.h, t = k.t;
    CLAIM("E7", v - e + f == 2 && 3 * f != 2 * e - h, "e = %u, f = %u, h = %u", e, f,
          h);
    CLAIM("E7", v - e + t != 2 && 3 * t == 2 * e - h, "e = %u, t = %u, h = %u", e, t,
          h);
    CLAIM("E7", v == 4 && e == 5 && t == 2 && h == 4, "e = %u, t = %u, h = %u", e, t,
          h);
}

static void
e8_a_triangle_has_equality(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {0, 1}};
    counted k = count_points(points, 3);
    CLAIM("E8", k.c.f == 2 && k.c.e == 3 && 3 * k.c.f == 2 * k.c.e, "f = %u, e = %u",
          k.c.f, k.c.e);
}

static void
e9_h_counts_boundary_edges(void)
{
    point2 grid[9];
    for (int i = 0; i < 9; i++)
        grid[i] = (point2){i % 3, i / 3};
    counted k = count_points(grid, 9);
    CLAIM("E9", k.c.h == 8 && k.c.e == 16 && k.t == 8, "h = %u, e = %u, t = %u", k.c.h,
          k.c.e, k.t);
    k = count_points(grid, 2);
    CLAIM("E9", k.c.v == 2 && k.c.e == 1, "v = %u, e = %u: v >= 3 is needed", k.c.v,
          k.c.e);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Equations (2), (3), (4): e = 3v-3-h, t = 2v-2-h");
    test_random("every algorithm", every_algorithm_obeys, 3000, 200);
    test_near_degenerate("every algorithm", every_algorithm_obeys, 3000, 60);
    test_grid_subsets("every algorithm", every_algorithm_obeys, 4);
    test_random("h, counted twice", h_is_counted_twice, 2000, 50);
    test_near_degenerate("h, counted twice", h_is_counted_twice, 2000, 30);
    test_random("maximal", no_edge_can_be_added, 1000, 20);
    test_near_degenerate("maximal", no_edge_can_be_added, 1000, 15);
    test_grid_subsets("maximal", no_edge_can_be_added, 3);
    test_run("E6: one more edge", e6_one_more_edge_around_the_outside);
    test_run("E7: f means two things", e7_f_means_two_things);
    test_run("E8: equality", e8_a_triangle_has_equality);
    test_run("E9: h counts boundary edges", e9_h_counts_boundary_edges);
    return test_end((test_minima){.trials = 70000, .largest_n = 180, .zeros = 1000000,
                                  .expansions = 1000, .wide = 1000});
}
