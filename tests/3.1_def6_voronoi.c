/* Definition 6: the regions, their edges and vertices are the Voronoi diagram,
 * and it is the dual of the Delaunay triangulation.
 *
 * Hypotheses: none. The sites may be cocircular, collinear or repeated;
 * statements that need three sites off a line say so.
 *
 * The diagram is certified by is_voronoi, which has a test of its own, and
 * compared cell by cell with the regions of Definition 5.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>

static uint32_t
cell_size(const voronoi *d, vertex_id p)
{
    return d->cell_first[p + 1] - d->cell_first[p];
}

/* ---- The diagram is right. ---- */

static void
the_dual_is_certified(const point2 *points, uint32_t n)
{
    voronoi d;
    verdict v;
    mesh m = random_delaunay(points, n);
    uint32_t interior = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        interior += e < mesh_twin(&m, e) && mesh_is_interior(&m, e);
    uint64_t before = predicate_count.incircle;
    CLAIM("sec3.1.P4", voronoi_dual(&m, points, &d) == TRI_OK, "no diagram");
    uint64_t asked = predicate_count.incircle - before;
    CLAIM("sec3.1.P20", asked == interior,
          "%llu incircle tests, %u edges inside the hull",
          (unsigned long long)asked, interior);
    CLAIM("sec3.1.P11", is_voronoi(points, n, &d, &v) == TRI_OK,
          "out of memory");
    claim_verdict("sec3.1.P11", v);
    voronoi_free(&d);
    mesh_free(&m);
}

/* P4: beyond the edges of a cell are the sites of the region, in the same
 * order. */
static void
the_dual_has_the_regions(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    for (vertex_id p = 0; p < n; p++) {
        if (mesh_leaving(&m, p) == NONE)
            continue;
        voronoi_region r;
        CLAIM("sec3.1.P4", voronoi_region_of(points, n, p, &r) == TRI_OK,
              "no region");
        CLAIM("sec3.1.P4", r.size == cell_size(&d, p),
              "site %u: %u edges by half-planes,"
              " %u by the dual",
              p, r.size, cell_size(&d, p));
        for (uint32_t i = 0; i < r.size; i++) {
            vertex_id q =
                voronoi_beyond(&d, d.cell_edge[d.cell_first[p] + i], p);
            CLAIM("sec3.1.P4", r.neighbour[i] == q,
                  "site %u, edge %u: beyond it are %u "
                  "by half-planes and %u by the dual",
                  p, i, r.neighbour[i], q);
        }
        voronoi_region_free(&r);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P5: the same diagram from two Delaunay triangulations, whatever their
 * diagonals: the cells have the same neighbours in the same order. */
static void
the_triangulation_does_not_matter(const point2 *points, uint32_t n)
{
    mesh m[2];
    voronoi d[2];
    for (int i = 0; i < 2; i++)
        random_diagram(points, n, &m[i], &d[i]);
    CLAIM("sec3.1.P5",
          d[0].vertices == d[1].vertices && d[0].edges == d[1].edges,
          "%u and %u vertices", d[0].vertices, d[1].vertices);
    for (vertex_id p = 0; p < n; p++) {
        CLAIM("sec3.1.P5", cell_size(&d[0], p) == cell_size(&d[1], p),
              "cell of %u", p);
        for (uint32_t i = 0; i < cell_size(&d[0], p); i++)
            CLAIM("sec3.1.P5",
                  voronoi_beyond(&d[0], d[0].cell_edge[d[0].cell_first[p] + i],
                                 p) ==
                      voronoi_beyond(&d[1],
                                     d[1].cell_edge[d[1].cell_first[p] + i], p),
                  "cell of %u, edge %u", p, i);
    }
    for (int i = 0; i < 2; i++) {
        voronoi_free(&d[i]);
        mesh_free(&m[i]);
    }
}

/* ---- What is true of vertices, edges and cells. ---- */

/* P6: a vertex has at least three nearest sites, and these are all: no site
 * lies in its circle, and on it only those listed. */
static void
vertices_have_empty_circles(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    for (uint32_t v = 0; v < d.vertices; v++) {
        const vertex_id *s = d.vertex_site + d.vertex_first[v];
        uint32_t size = d.vertex_first[v + 1] - d.vertex_first[v],
                 on_circle = 0;
        CLAIM("sec3.1.P6", size >= 3, "vertex %u has %u sites", v, size);
        for (vertex_id x = 0; x < n; x++) {
            int side = oracle_incircle(points[s[0]], points[s[1]], points[s[2]],
                                       points[x]);
            CLAIM("sec3.1.P6", side <= 0, "%u lies in the circle of vertex %u",
                  x, v);
            on_circle += side == 0 && mesh_leaving(&m, x) != NONE;
        }
        CLAIM("sec3.1.P6", on_circle == size,
              "vertex %u: %u sites are listed, and %u on "
              "its circle",
              v, size, on_circle);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P7: a point of an edge has exactly its two sites nearest. By the proof that
 * follows from this: the circles at the two ends are empty and differ, so no
 * site but these two is in or on both. */
static void
edges_have_two_nearest_sites(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    for (uint32_t k = 0; k < d.edges; k++) {
        voronoi_edge e = d.edge[k];
        if (e.from == NONE || e.to == NONE)
            continue;
        const vertex_id *s = d.vertex_site + d.vertex_first[e.from];
        const vertex_id *t = d.vertex_site + d.vertex_first[e.to];
        for (vertex_id x = 0; x < n; x++) {
            bool copy = compare_distance(points[x], points[e.left], points[x],
                                         points[x]) == 0 ||
                        compare_distance(points[x], points[e.right], points[x],
                                         points[x]) == 0;
            bool at_from = oracle_incircle(points[s[0]], points[s[1]],
                                           points[s[2]], points[x]) >= 0;
            bool at_to = oracle_incircle(points[t[0]], points[t[1]],
                                         points[t[2]], points[x]) >= 0;
            CLAIM("sec3.1.P7", (at_from && at_to) == copy,
                  "site %u and the edge between "
                  "%u and %u",
                  x, e.left, e.right);
        }
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P8: unbounded exactly on the boundary of the hull; without vertices exactly
 * when collinear. */
static void
unbounded_cells_are_on_the_hull(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    bool *on_hull = calloc(n + 1, sizeof *on_hull);
    vertex_id *hull = malloc((n + 1) * sizeof *hull);
    uint32_t h = hull_vertices(&m, hull), u = m.locations;
    for (uint32_t i = 0; i < h; i++)
        on_hull[hull[i]] = true;
    for (vertex_id p = 0; p < n; p++)
        if (mesh_leaving(&m, p) != NONE)
            CLAIM("sec3.1.P8", voronoi_is_bounded(&d, p) == !on_hull[p],
                  "site %u is%s on the hull boundary", p,
                  on_hull[p] ? "" : " not");
    if (u == 1) /* the whole plane, which is listed without an edge */
        CLAIM("sec3.1.P8", !voronoi_is_bounded(&d, 0), "the plane is bounded");
    bool collinear = affine_dimension(points, n) < 2;
    CLAIM("sec3.1.P8", (d.vertices == 0) == collinear, "%u vertices",
          d.vertices);
    uint32_t rays = 0;
    for (uint32_t k = 0; k < d.edges; k++) {
        bool from_infinity = d.edge[k].from == NONE,
             to_infinity = d.edge[k].to == NONE;
        rays += (from_infinity ? 1u : 0) + (to_infinity ? 1u : 0);
        CLAIM("sec3.1.P8", !from_infinity || to_infinity, "ray %u runs inwards",
              k);
    }
    CLAIM("sec3.1.P8",
          rays == (u < 2       ? 0
                   : collinear ? 2 * (u - 1)
                               : h),
          "%u ends at infinity, %u sites on the hull", rays, h);
    free(on_hull);
    free(hull);
    voronoi_free(&d);
    mesh_free(&m);
}

/* P9, with E14 and E15: the counts. */
static void
the_counts_are_right(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    uint32_t u = d.cells, v = d.vertices, e = d.edges;
    if (affine_dimension(points, n) == 2) {
        CLAIM("E14", u + v == e + 1, "n = %u, v = %u, e = %u", u, v, e);
        CLAIM("E15", e <= 3 * u - 6, "n = %u, e = %u", u, e);
        CLAIM("sec3.1.P9", v <= 2 * u - 5, "n = %u, v = %u", u, v);
        uint32_t corners = d.vertex_first[v], rays = 0, sides = d.cell_first[n];
        for (uint32_t k = 0; k < e; k++)
            rays += d.edge[k].to == NONE;
        CLAIM("sec3.1.P9", 2 * e == corners + rays && corners >= 3 * v,
              "e = %u, %u corners, %u rays", e, corners, rays);
        CLAIM("sec3.1.P9", sides == 2 * e && sides < 6 * u,
              "%u sides of %u cells", sides, u);
    } else {
        CLAIM("E15", v == 0 && e + (u > 0) == u, "%u sites, %u lines", u, e);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P10: each site shares an edge with all those nearest to it; in particular the
 * closest pairs share edges. */
static bool
share_an_edge(const voronoi *d, vertex_id p, vertex_id q)
{
    for (uint32_t i = d->cell_first[p]; i < d->cell_first[p + 1]; i++)
        if (voronoi_beyond(d, d->cell_edge[i], p) == q)
            return true;
    return false;
}

static void
nearest_sites_share_an_edge(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    for (vertex_id p = 0; p < n && m.locations > 1; p++) {
        if (mesh_leaving(&m, p) == NONE)
            continue;
        vertex_id best = NONE;
        for (vertex_id q = 0; q < n; q++)
            if (q != p && mesh_leaving(&m, q) != NONE &&
                (best == NONE ||
                 oracle_compare_distance(points[p], points[q], points[p],
                                         points[best]) < 0))
                best = q;
        for (vertex_id q = 0; q < n; q++)
            if (q != p && mesh_leaving(&m, q) != NONE &&
                oracle_compare_distance(points[p], points[q], points[p],
                                        points[best]) == 0)
                CLAIM("sec3.1.P10", share_an_edge(&d, p, q),
                      "%u is nearest to %u", q, p);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* ---- Exact values. ---- */

/* The diagram of a few points. */
static void
diagram_of(const point2 *points, uint32_t n, voronoi *d)
{
    mesh m;
    CLAIM("sec3.1.P4",
          lawson_triangulate(points, n, NULL, &m) == TRI_OK &&
              voronoi_dual(&m, points, d) == TRI_OK,
          "no diagram");
    mesh_free(&m);
}

static void
grids_have_squares(void)
{
    for (uint32_t k = 1; k <= 9; k++) {
        point2 points[81];
        for (uint32_t i = 0; i < k * k; i++)
            points[i] = (point2){i % k, i / k};
        voronoi d;
        diagram_of(points, k * k, &d);
        CLAIM("sec3.1.P5",
              d.vertices == (k - 1) * (k - 1) && d.edges == 2 * k * (k - 1),
              "%u x %u: v = %u, e = %u", k, k, d.vertices, d.edges);
        voronoi_free(&d);
    }
}

static void
e14_three_sites(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {1, 3}};
    voronoi d;
    diagram_of(points, 3, &d);
    CLAIM("E14", d.cells == 3 && d.vertices == 1 && d.edges == 3,
          "v = %u, e = %u", d.vertices, d.edges);
    voronoi_free(&d);
}

static void
e15_two_sites(void)
{
    const point2 points[] = {{0, 0}, {1, 0}};
    voronoi d;
    diagram_of(points, 2, &d);
    CLAIM("E15", d.vertices == 0 && d.edges == 1, "v = %u, e = %u", d.vertices,
          d.edges);
    voronoi_free(&d);
}

static void
nothing_leaks(void)
{
    point2 points[30];
    for (int i = 0; i < 30; i++)
        points[i] = (point2){i % 6, i / 6 + i % 2 * 0.25};
    mesh m;
    voronoi d;
    CLAIM("sec3.1.P4", lawson_triangulate(points, 30, NULL, &m) == TRI_OK,
          "no mesh");
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = voronoi_dual(&m, points, &d);
        memory_fail_at(0);
        CLAIM("sec3.1.P4",
              status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                                   d.edge == NULL && d.vertices == 0),
              "allocation %lu: %s", k, tri_status_text(status));
    }
    voronoi_free(&d);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Definition 6: the Voronoi diagram, dual to Delaunay");
    test_random("certified", the_dual_is_certified, 2000, 80);
    test_near_degenerate("certified", the_dual_is_certified, 1500, 40);
    test_grid_subsets("certified", the_dual_is_certified, 4);
    test_random("the regions of Definition 5", the_dual_has_the_regions, 1000,
                30);
    test_near_degenerate("the regions of Definition 5",
                         the_dual_has_the_regions, 800, 16);
    test_grid_subsets("the regions of Definition 5", the_dual_has_the_regions,
                      3);
    test_random("any Delaunay triangulation", the_triangulation_does_not_matter,
                1000, 60);
    test_random("empty circles", vertices_have_empty_circles, 500, 20);
    test_near_degenerate("empty circles", vertices_have_empty_circles, 300, 10);
    test_random("points of edges", edges_have_two_nearest_sites, 500, 16);
    test_near_degenerate("points of edges", edges_have_two_nearest_sites, 150,
                         10);
    test_random("unbounded cells", unbounded_cells_are_on_the_hull, 1500, 60);
    test_near_degenerate("unbounded cells", unbounded_cells_are_on_the_hull,
                         1000, 40);
    test_random("counts", the_counts_are_right, 1500, 200);
    test_near_degenerate("counts", the_counts_are_right, 1000, 60);
    test_grid_subsets("counts", the_counts_are_right, 3);
    test_random("nearest sites", nearest_sites_share_an_edge, 1000, 30);
    test_near_degenerate("nearest sites", nearest_sites_share_an_edge, 500, 16);
    test_run("grids", grids_have_squares);
    test_run("E14: three sites", e14_three_sites);
    test_run("E15: two sites", e15_two_sites);
    test_run("out of memory", nothing_leaks);
    return test_end((test_minima){.trials = 12000,
                                  .largest_n = 150,
                                  .zeros = 10000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
