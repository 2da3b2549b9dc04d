/* Definitions 7 and 8: simplices with an empty circle, and what they are
 * together.
 *
 * Hypotheses: none; collinear and cocircular sites and copies are ordinary.
 * Where the notes assume general position (E21, E22), what holds without it is
 * tested.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>

static triangle_list
all_delaunay_triangles(const point2 *points, uint32_t n)
{
    triangle_list list;
    tri_status status = delaunay_triangles(points, n, &list);
    CLAIM("def7.P1", status == TRI_OK, "%s", tri_status_text(status));
    return list;
}

static mesh
brute_mesh(const point2 *points, uint32_t n)
{
    mesh m;
    tri_status status = brute_triangulate(points, n, NULL, &m);
    CLAIM("def8.P4", status == TRI_OK, "%s", tri_status_text(status));
    return m;
}

static subdivision
cells_of(const mesh *m, const point2 *points)
{
    subdivision s;
    tri_status status = delaunay_subdivision(m, points, &s);
    CLAIM("def8.P5", status == TRI_OK, "%s", tri_status_text(status));
    return s;
}

/* Is an earlier point at the same place? */
static bool
is_copy(const point2 *points, vertex_id v)
{
    for (vertex_id w = 0; w < v; w++)
        if (points[w].x == points[v].x && points[w].y == points[v].y)
            return true;
    return false;
}

/* ---- Definition 7, judged by big integers. ---- */

static bool
is_listed(triangle_list list, vertex_id a, vertex_id b, vertex_id c)
{
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        if (side_origin(list, e) == a && side_dest(list, e) == b &&
            side_apex(list, e) == c)
            return true;
    return false;
}

static void
exactly_the_delaunay_triangles(const point2 *points, uint32_t n)
{
    triangle_list list = all_delaunay_triangles(points, n);
    uint32_t expected = 0;
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = 0; b < n; b++)
            for (vertex_id c = 0; c < n; c++) {
                if (b <= a || c <= a || is_copy(points, a) ||
                    is_copy(points, b) || is_copy(points, c) ||
                    oracle_orient2d(points[a], points[b], points[c]) <= 0)
                    continue;
                bool empty = true;
                for (vertex_id d = 0; d < n && empty; d++)
                    empty = oracle_incircle(points[a], points[b], points[c],
                                            points[d]) <= 0;
                CLAIM("def7.P1", is_listed(list, a, b, c) == empty,
                      "%u %u %u is %slisted", a, b, c, empty ? "not " : "");
                expected += empty;
            }
    CLAIM("def7.P1", list.count == expected,
          "%u triangles are listed, %u exist", list.count, expected);
    triangle_list_free(&list);
}

/* Is ab, in either direction, a side of a listed triangle? */
static bool
is_side(triangle_list list, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        vertex_id u = side_origin(list, e), w = side_dest(list, e);
        if ((u == a && w == b) || (u == b && w == a))
            return true;
    }
    return false;
}

static void
delaunay_edges_are_sides(const point2 *points, uint32_t n)
{
    HYPOTHESIS(affine_dimension(points, n) == 2);
    triangle_list list = all_delaunay_triangles(points, n);
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = 0; b < n; b++)
            if (a != b && !is_copy(points, a) && !is_copy(points, b)) {
                bool edge = is_delaunay_edge(points, n, a, b);
                CLAIM("def7.P2", edge == is_side(list, a, b), "%u %u: %s", a, b,
                      edge ? "an empty circle and no triangle"
                           : "a side, and no empty circle");
            }
    triangle_list_free(&list);
}

/* On a line, the Delaunay edges are those between neighbours. */
static void
on_a_line_neighbours_are_joined(const point2 *points, uint32_t n)
{
    const point2 along_x = {1, 0};
    point2 *line = malloc((n + 1) * sizeof *line);
    vertex_id *order = malloc((n + 1) * sizeof *order);
    uint32_t u;
    for (uint32_t i = 0; i < n; i++)
        line[i] = (point2){points[i].x, 0};
    CLAIM("def7.P2", sort_along(line, n, along_x, order, &u) == TRI_OK,
          "no order");
    for (uint32_t i = 0; i < u; i++)
        for (uint32_t j = 0; j < u; j++)
            if (i != j)
                CLAIM("def7.P2",
                      is_delaunay_edge(line, n, order[i], order[j]) ==
                          (i + 1 == j || j + 1 == i),
                      "%u %u, number %u and %u", order[i], order[j], i, j);
    free(line);
    free(order);
}

/* ---- Definition 8 without general position. ---- */

static bool
is_cocircular(const point2 *points, const vertex_id *c, vertex_id d)
{
    return incircle(points[c[0]], points[c[1]], points[c[2]], points[d]) == 0;
}

static bool
same_circle(const point2 *points, const vertex_id *c, const vertex_id *d)
{
    return is_cocircular(points, c, d[0]) && is_cocircular(points, c, d[1]) &&
           is_cocircular(points, c, d[2]);
}

/* Do the open segments ab and cd have exactly one point in common? */
static bool
cross(const point2 *points, vertex_id a, vertex_id b, vertex_id c, vertex_id d)
{
    point2 p = points[a], q = points[b], r = points[c], s = points[d];
    return orient2d(p, q, r) * orient2d(p, q, s) < 0 &&
           orient2d(r, s, p) * orient2d(r, s, q) < 0;
}

static void
crossing_edges_are_cocircular(const point2 *points, uint32_t n)
{
    triangle_list list = all_delaunay_triangles(points, n);
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        for (halfedge_id f = 0; f < e; f++) {
            vertex_id a = side_origin(list, e), b = side_dest(list, e);
            vertex_id c = side_origin(list, f), d = side_dest(list, f);
            if (cross(points, a, b, c, d))
                CLAIM("def8.P1",
                      incircle(points[a], points[b], points[c], points[d]) == 0,
                      "%u %u crosses %u %u", a, b, c, d);
        }
    triangle_list_free(&list);
}

/* Is every corner of one triangle on the right of some side of the other, or on
 * it? Two convex polygons have no inner point in common exactly when a line
 * through a side of one of them separates them. */
static bool
separated_by_a_side_of(const point2 *points, const vertex_id *c,
                       const vertex_id *d)
{
    for (int i = 0; i < 3; i++) {
        point2 p = points[c[i]], q = points[c[(i + 1) % 3]];
        if (orient2d(p, q, points[d[0]]) <= 0 &&
            orient2d(p, q, points[d[1]]) <= 0 &&
            orient2d(p, q, points[d[2]]) <= 0)
            return true;
    }
    return false;
}

static void
overlapping_triangles_share_their_circle(const point2 *points, uint32_t n)
{
    triangle_list list = all_delaunay_triangles(points, n);
    for (uint32_t s = 0; s < list.count; s++)
        for (uint32_t t = 0; t < s; t++) {
            const vertex_id *c = list.corner[s], *d = list.corner[t];
            CLAIM("def8.P2",
                  separated_by_a_side_of(points, c, d) ||
                      separated_by_a_side_of(points, d, c) ||
                      same_circle(points, c, d),
                  "%u %u %u and %u %u %u overlap", c[0], c[1], c[2], d[0], d[1],
                  d[2]);
        }
    triangle_list_free(&list);
}

/* Is uw a side of a cell, with the cell on its left? */
static bool
is_cell_side(const subdivision *s, vertex_id u, vertex_id w)
{
    for (uint32_t i = 0; i < s->cells; i++)
        for (uint32_t k = s->first[i]; k < s->first[i + 1]; k++) {
            uint32_t next = k + 1 < s->first[i + 1] ? k + 1 : s->first[i];
            if (s->vertex[k] == u && s->vertex[next] == w)
                return true;
        }
    return false;
}

/* Cell i: its corners turn left, all on one circle, on which there is no other
 * site, and inside which there is none. */
static void
check_cell(const point2 *points, uint32_t n, const subdivision *s, uint32_t i)
{
    const vertex_id *c = s->vertex + s->first[i];
    uint32_t size = s->first[i + 1] - s->first[i];
    CLAIM("def8.P3", size >= 3, "a cell with %u corners", size);
    uint32_t on = 0;
    for (vertex_id d = 0; d < n; d++) {
        int side =
            incircle(points[c[0]], points[c[1]], points[c[2]], points[d]);
        CLAIM("def8.P3", side <= 0, "%u lies inside the circle of cell %u", d,
              i);
        on += side == 0 && !is_copy(points, d);
    }
    CLAIM("def8.P3", on == size, "%u sites on the circle of a cell of %u", on,
          size);
    for (uint32_t k = 0; k < size; k++) {
        vertex_id u = c[k], w = c[(k + 1) % size], x = c[(k + 2) % size];
        CLAIM("def8.P3", orient2d(points[u], points[w], points[x]) > 0,
              "cell %u is not convex at %u", i, w);
        CLAIM("def8.P3", u >= c[0], "cell %u begins at %u, not at %u", i, c[0],
              u);
        bool beyond = false; /* is there a site on the other side? */
        for (vertex_id d = 0; d < n && !beyond; d++)
            beyond = orient2d(points[u], points[w], points[d]) < 0;
        CLAIM("def8.P3", is_cell_side(s, w, u) == beyond,
              "beyond the side %u %u of cell %u is %s", u, w, i,
              beyond ? "no cell" : "a cell");
    }
}

static void
cells_fit_together(const point2 *points, uint32_t n)
{
    mesh m = brute_mesh(points, n);
    subdivision s = cells_of(&m, points);
    CLAIM("def8.P3", (s.cells > 0) == (affine_dimension(points, n) == 2),
          "%u cells", s.cells);
    for (uint32_t i = 0; i < s.cells; i++)
        check_cell(points, n, &s, i);
    subdivision_free(&s);
    mesh_free(&m);
}

/* The fans: a Delaunay triangulation in which each triangle has the lowest
 * index on its circle for a corner. */
static void
fans_triangulate(const point2 *points, uint32_t n)
{
    mesh m = brute_mesh(points, n);
    claim_verdict("def8.P4", mesh_check(&m));
    triangle_list list;
    verdict v;
    CLAIM("def8.P4", mesh_triangles(&m, &list) == TRI_OK, "no list");
    test_picture(list);
    CLAIM("def8.P4", is_delaunay(points, n, list, &v) == TRI_OK,
          "out of memory");
    claim_verdict("def8.P4", v);
    for (uint32_t t = 0; t < list.count; t++) {
        const vertex_id *c = list.corner[t];
        CLAIM("def8.P4", c[0] < c[1] && c[0] < c[2], "triangle %u begins at %u",
              t, c[0]);
        for (vertex_id d = 0; d < c[0]; d++)
            CLAIM("def8.P4", !is_cocircular(points, c, d),
                  "%u is on the circle of triangle %u", d, t);
    }
    triangle_list_free(&list);
    mesh_free(&m);
}

/* ---- The errata. ---- */

/* E21: of the Delaunay edges those are left that no other one crosses. They are
 * the sides of the cells, and these are polygons. */
static void
what_is_left_is_the_subdivision(const point2 *points, uint32_t n)
{
    HYPOTHESIS(affine_dimension(points, n) == 2);
    triangle_list list = all_delaunay_triangles(points, n);
    mesh m = brute_mesh(points, n);
    subdivision s = cells_of(&m, points);
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        vertex_id a = side_origin(list, e), b = side_dest(list, e);
        bool crossed = false;
        for (halfedge_id f = 0; f < 3 * list.count && !crossed; f++)
            crossed =
                cross(points, a, b, side_origin(list, f), side_dest(list, f));
        bool side = is_cell_side(&s, a, b) || is_cell_side(&s, b, a);
        CLAIM("E21", side == !crossed, "%u %u is %scrossed, and %s side", a, b,
              crossed ? "" : "not ", side ? "a" : "no");
    }
    triangle_list_free(&list);
    subdivision_free(&s);
    mesh_free(&m);
}

/* E22: as many triangles as the cells have triples of corners. */
static void
every_triple_of_a_cell_is_listed(const point2 *points, uint32_t n)
{
    triangle_list list = all_delaunay_triangles(points, n);
    mesh m = brute_mesh(points, n);
    subdivision s = cells_of(&m, points);
    uint32_t triples = 0, triangles = 0;
    for (uint32_t i = 0; i < s.cells; i++) {
        uint32_t k = s.first[i + 1] - s.first[i];
        triples += k * (k - 1) * (k - 2) / 6;
        triangles += k - 2;
    }
    CLAIM("def7.P3", list.count == triples, "%u triangles, %u triples",
          list.count, triples);
    CLAIM("def8.P4",
          m.locations < 2 || s.cells == 0 ||
              triangles + mesh_hull_size(&m) == 2 * m.locations - 2,
          "%u triangles in the fans", triangles);
    triangle_list_free(&list);
    subdivision_free(&s);
    mesh_free(&m);
}

static void
the_unit_square(void)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    triangle_list list = all_delaunay_triangles(square, 4);
    CLAIM("E22", list.count == 4, "%u Delaunay triangles", list.count);
    CLAIM("E22", is_side(list, 0, 2) && is_side(list, 1, 3),
          "a diagonal is missing");
    verdict v;
    CLAIM("E22", is_triangulation(square, 4, list, &v) == TRI_OK && !v.holds,
          "they are a triangulation");
    triangle_list_free(&list);

    mesh m = brute_mesh(square, 4);
    subdivision s = cells_of(&m, square);
    CLAIM("E21", s.cells == 1 && s.first[1] == 4, "%u cells", s.cells);
    subdivision_free(&s);
    mesh_free(&m);
}

/* Three sites on the circle of a square's corners but for one: other cells. */
static void
equal_cells_only(void)
{
    const point2 sites[][5] = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {9, 1}},
                               {{0, 0}, {2, 0}, {2, 3}, {0, 2}, {9, 1}},
                               {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 9}},
                               {{0, 0}, {0, 2}, {2, 2}, {2, 0}, {9, 1}}};
    enum { SETS = sizeof sites / sizeof sites[0] };
    mesh m[SETS];
    subdivision s[SETS];
    for (int i = 0; i < SETS; i++) {
        m[i] = brute_mesh(sites[i], 5);
        s[i] = cells_of(&m[i], sites[i]);
    }
    for (int i = 0; i < SETS; i++)
        for (int j = 0; j < SETS; j++)
            CLAIM("def8.P5", subdivisions_are_equal(&s[i], &s[j]) == (i == j),
                  "the cells of sets %d and %d", i, j);
    for (int i = 0; i < SETS; i++) {
        subdivision_free(&s[i]);
        mesh_free(&m[i]);
    }
}

/* ---- Memory that runs out. ---- */

static void
memory_may_run_out(void)
{
    const point2 points[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 5}, {2, 2}};
    const point2 line[] = {{0, 0}, {1, 1}, {3, 3}};
    mesh m, path;
    triangle_list list;
    subdivision s;
    mesh whole = brute_mesh(points, 6);
    for (int which = 0; which < 4; which++) {
        tri_status status = TRI_OUT_OF_MEMORY;
        unsigned long k = 0;
        while (status != TRI_OK) {
            memory_fail_at(++k);
            status = which == 0   ? delaunay_triangles(points, 6, &list)
                     : which == 1 ? brute_triangulate(points, 6, NULL, &m)
                     : which == 2 ? brute_triangulate(line, 3, NULL, &path)
                                  : delaunay_subdivision(&whole, points, &s);
            memory_fail_at(0);
            CLAIM("def7.P1", status == TRI_OK || status == TRI_OUT_OF_MEMORY,
                  "allocation %lu: %s", k, tri_status_text(status));
            bool empty = which == 0   ? list.corner == NULL && list.count == 0
                         : which == 1 ? m.halfedge == NULL && m.leaving == NULL
                         : which == 2
                             ? path.halfedge == NULL && path.leaving == NULL
                             : s.first == NULL && s.vertex == NULL;
            CLAIM("def7.P1", empty == (status != TRI_OK), "allocation %lu", k);
        }
        CLAIM("def7.P1", k > 3, "%lu allocations", k - 1);
    }
    triangle_list_free(&list);
    subdivision_free(&s);
    mesh_free(&m);
    mesh_free(&path);
    mesh_free(&whole);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Definitions 7 and 8: simplices with an empty circle");
    test_random("exactly Definition 7", exactly_the_delaunay_triangles, 300,
                12);
    test_near_degenerate("exactly Definition 7", exactly_the_delaunay_triangles,
                         300, 8);
    test_random("edges", delaunay_edges_are_sides, 500, 16);
    test_near_degenerate("edges", delaunay_edges_are_sides, 500, 12);
    test_grid_subsets("edges", delaunay_edges_are_sides, 3);
    test_random("edges on a line", on_a_line_neighbours_are_joined, 300, 20);
    test_random("crossing edges", crossing_edges_are_cocircular, 500, 16);
    test_near_degenerate("crossing edges", crossing_edges_are_cocircular, 500,
                         10);
    test_grid_subsets("crossing edges", crossing_edges_are_cocircular, 3);
    test_random("overlaps", overlapping_triangles_share_their_circle, 500, 16);
    test_near_degenerate("overlaps", overlapping_triangles_share_their_circle,
                         500, 10);
    test_random("cells", cells_fit_together, 500, 20);
    test_near_degenerate("cells", cells_fit_together, 500, 12);
    test_grid_subsets("cells", cells_fit_together, 3);
    test_random("fans", fans_triangulate, 1000, 24);
    test_near_degenerate("fans", fans_triangulate, 1000, 14);
    test_grid_subsets("fans", fans_triangulate, 3);
    test_random("what is left", what_is_left_is_the_subdivision, 400, 14);
    test_near_degenerate("what is left", what_is_left_is_the_subdivision, 300,
                         10);
    test_random("triples", every_triple_of_a_cell_is_listed, 500, 24);
    test_near_degenerate("triples", every_triple_of_a_cell_is_listed, 500, 14);
    test_run("E21, E22: the unit square", the_unit_square);
    test_run("equal cells only", equal_cells_only);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 9000,
                                  .largest_n = 23,
                                  .zeros = 10000,
                                  .expansions = 10000,
                                  .wide = 10000});
}
