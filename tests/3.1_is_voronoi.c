/* Section 3.1: is_voronoi takes the Voronoi diagram and nothing else.
 *
 * Hypotheses: none. Diagrams are damaged at random, forged by hand, or made
 * from other triangulations; those of the dual must be taken.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <string.h>

/* ---- Damage. ---- */

/* Some damage to a diagram; false when it has nothing to be damaged there. */
static bool
damage(voronoi *d, uint32_t kind)
{
    random_source *r = test_random_source();
    if (kind <= 4 && d->edges == 0)
        return false;
    if (kind >= 5 && kind <= 7 && d->vertices == 0)
        return false;
    uint32_t k = d->edges > 0 ? random_below(r, d->edges) : 0;
    uint32_t v = d->vertices > 0 ? random_below(r, d->vertices) : 0;
    voronoi_edge *e = &d->edge[k];
    switch (kind) {
    case 0: { /* the edge turned around: a ray leaves on the wrong side */
        vertex_id left = e->left;
        e->left = e->right;
        e->right = left;
        return e->from != NONE || e->to != NONE;
    }
    case 1: /* another end */
        e->to = e->to == NONE ? 0 : NONE;
        return d->vertices > 0;
    case 2: /* one edge less */
        d->edges--;
        return true;
    case 3: { /* another site beyond it */
        vertex_id other = random_below(r, d->points);
        bool changed = other != e->right;
        e->right = other;
        return changed;
    }
    case 4: { /* two edges of a cell exchanged */
        uint32_t i = random_below(r, d->cell_first[d->points]);
        uint32_t j = random_below(r, d->cell_first[d->points]);
        uint32_t first = d->cell_edge[i], second = d->cell_edge[j];
        d->cell_edge[i] = second;
        d->cell_edge[j] = first;
        /* Two lines of one cell may be listed in either order. */
        return first != second && d->vertices > 0;
    }
    case 5: { /* another site at a vertex */
        uint32_t i = random_below(r, d->vertex_first[d->vertices]);
        vertex_id other = random_below(r, d->points);
        bool changed = other != d->vertex_site[i];
        d->vertex_site[i] = other;
        return changed;
    }
    case 6: { /* two sites of a vertex exchanged */
        uint32_t i = d->vertex_first[v] + 1;
        vertex_id site = d->vertex_site[i];
        d->vertex_site[i] = d->vertex_site[i - 1];
        d->vertex_site[i - 1] = site;
        return true;
    }
    case 7: /* one vertex less */
        d->vertices--;
        return true;
    default: /* another number of cells */
        d->cells++;
        return true;
    }
}

static void
damage_is_seen(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    verdict v;
    random_diagram(points, n, &m, &d);
    uint32_t kind = random_below(test_random_source(), 9);
    bool damaged = damage(&d, kind);
    CLAIM("sec3.1.P11", is_voronoi(points, n, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", !damaged || !v.holds, "damage %u was not seen", kind);
    voronoi_free(&d);
    mesh_free(&m);
}

/* ---- Forgeries. ---- */

/* Forgeries in which every cell looks right. The sites (0,0), (4,0), (0,4),
 * (5,5) have two vertices; here are the edges of the first one only, and (5,5)
 * has no cell. */
static void
a_forgotten_vertex_is_seen(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {5, 5}};
    uint32_t vertex_first[] = {0, 3, 6}, cell_first[] = {0, 2, 4, 6, 6};
    vertex_id vertex_site[] = {0, 1, 2, 1, 3, 2};
    voronoi_edge edge[] = {{1, 0, 0, NONE}, {2, 1, 0, NONE}, {0, 2, 0, NONE}};
    uint32_t cell_edge[] = {0, 2, 1, 0, 2, 1};
    voronoi forged = {4,           3,    2,          3,        vertex_first,
                      vertex_site, edge, cell_first, cell_edge};
    verdict v;
    CLAIM("sec3.1.P11", is_voronoi(points, 4, &forged, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a vertex without edges was not seen");
    forged.points = 3;
    forged.vertices = 1;
    CLAIM("sec3.1.P11", is_voronoi(points, 3, &forged, &v) == TRI_OK,
          "out of memory");
    claim_verdict("sec3.1.P11", v); /* of three sites this is the diagram */
}

/* The diagram of (0,0), (4,0), (0,4) and two copies, with an edge too many: in
 * no cell; or a line between the copies, in theirs. */
static void
one_edge_more_is_seen(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {4, 0}, {0, 4}};
    uint32_t vertex_first[] = {0, 3}, cell_first[] = {0, 2, 4, 6, 6, 6};
    vertex_id vertex_site[] = {0, 1, 2};
    voronoi_edge edge[] = {
        {1, 0, 0, NONE}, {2, 1, 0, NONE}, {0, 2, 0, NONE}, {3, 4, NONE, NONE}};
    uint32_t cell_edge[] = {0, 2, 1, 0, 2, 1, 3, 3};
    voronoi d = {5,           3,    1,          3,        vertex_first,
                 vertex_site, edge, cell_first, cell_edge};
    verdict v;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK,
          "out of memory");
    claim_verdict("sec3.1.P11", v);
    d.edges = 4;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "an edge in no cell was not seen");
    cell_first[4] = 7;
    cell_first[5] = 8;
    d.cells = 5;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a line between copies was not seen");
}

/* In a grid, one cell goes around twice, and another of the same size not at
 * all. */
static void
a_cell_around_twice_is_seen(void)
{
    point2 points[16];
    for (uint32_t i = 0; i < 16; i++)
        points[i] = (point2){i % 4, i / 4};
    voronoi d;
    verdict v;
    mesh m;
    CLAIM("sec3.1.P11",
          lawson_triangulate(points, 16, NULL, &m) == TRI_OK &&
              voronoi_dual(&m, points, &d) == TRI_OK,
          "no diagram");
    mesh_free(&m);
    uint32_t *twice = d.cell_edge + d.cell_first[5];
    uint32_t *none = d.cell_edge + d.cell_first[6];
    uint32_t size = d.cell_first[7] - d.cell_first[6];
    CLAIM("sec3.1.P11", none - twice == 4 && size == 4, "no grid");
    memcpy(none, twice, 4 * sizeof *none); /* the two follow each other */
    d.cell_first[6] += 4;
    d.cells--;
    CLAIM("sec3.1.P11", is_voronoi(points, 16, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a cell around twice was not seen");
    voronoi_free(&d);
}

/* ---- Other triangulations, and a vertex for each triangle. ---- */

/* The dual of some other triangulation is refuted. */
static void
only_delaunay_has_the_dual(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    verdict v, delaunay;
    triangle_list list;
    random_triangulation(points, n, &m);
    CLAIM("sec3.1.P11",
          mesh_triangles(&m, &list) == TRI_OK &&
              voronoi_dual(&m, points, &d) == TRI_OK,
          "no diagram");
    CLAIM("sec3.1.P11",
          is_delaunay(points, n, list, &delaunay) == TRI_OK &&
              is_voronoi(points, n, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P11", v.holds == delaunay.holds,
          "the dual of %s triangulation %s",
          delaunay.holds ? "a Delaunay" : "another",
          v.holds ? "is taken" : "is refuted");
    triangle_list_free(&list);
    voronoi_free(&d);
    mesh_free(&m);
}

/* One vertex for each triangle is the diagram of Definition 6 exactly in
 * general position; the numbers are those of the triangulation. */
static void
per_triangle_is_the_triangulation(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi merged, d;
    verdict v;
    triangle_list list;
    random_diagram(points, n, &m, &merged);
    CLAIM("sec3.1.P5", voronoi_per_triangle(&m, &d) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P5", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P5", d.vertices == list.count, "%u vertices", d.vertices);
    for (uint32_t t = 0; t < list.count; t++) {
        const vertex_id *s = d.vertex_site + d.vertex_first[t];
        CLAIM("sec3.1.P5",
              d.vertex_first[t + 1] == 3 * t + 3 &&
                  has_triangle((triangle_list){1, &list.corner[t]}, s),
              "vertex %u", t);
    }
    uint32_t joining = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        joining +=
            mesh_origin(&m, e) < mesh_dest(&m, e) && mesh_dest(&m, e) < n;
    CLAIM("sec3.1.P5", d.edges == joining, "%u edges", d.edges);
    CLAIM("sec3.1.P5", is_voronoi(points, n, &d, &v) == TRI_OK,
          "out of memory");
    CLAIM("sec3.1.P5", v.holds == (d.vertices == merged.vertices), "%s",
          v.holds ? "holds, although two vertices are the same point"
                  : v.because);
    triangle_list_free(&list);
    voronoi_free(&d);
    voronoi_free(&merged);
    mesh_free(&m);
}

/* The diagram of a square is forged for a quadrilateral whose corners are on no circle:
 * all is in order but that circle. */
static void
a_vertex_needs_its_circle(void)
{
    const point2 square[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const point2 other[] = {{0, 0}, {2, 0}, {3, 3}, {0, 2}};
    mesh m;
    voronoi d;
    verdict v;
    random_diagram(square, 4, &m, &d);
    CLAIM("sec3.1.P11", is_voronoi(square, 4, &d, &v) == TRI_OK, "out of memory");
    claim_verdict("sec3.1.P11", v);
    CLAIM("sec3.1.P11", is_voronoi(other, 4, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !v.holds && v.witnesses == 4, "four sites on no circle");
    voronoi_free(&d);
    mesh_free(&m);
}

/* Lists that begin after they end. */
static void
broken_lists_are_seen(void)
{
    const point2 points[] = {{0, 0}, {3, 0}, {3, 2}, {0, 2}, {1, 1}};
    mesh m;
    voronoi d;
    verdict v;
    random_diagram(points, 5, &m, &d);
    uint32_t *const first[] = {d.vertex_first, d.cell_first};
    for (int i = 0; i < 2; i++) {
        uint32_t kept = first[i][1];
        first[i][1] = first[i][2] + 1;
        CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK, "memory");
        CLAIM("sec3.1.P11", !v.holds, "list %d is in no order", i);
        first[i][1] = kept;
    }
    voronoi_free(&d);
    mesh_free(&m);
}

static void
nothing_leaks(void)
{
    point2 points[30];
    for (int i = 0; i < 30; i++)
        points[i] = (point2){i % 6, i / 6 + i % 2 * 0.25};
    mesh m;
    voronoi d;
    verdict v;
    CLAIM("sec3.1.P11",
          lawson_triangulate(points, 30, NULL, &m) == TRI_OK &&
              voronoi_dual(&m, points, &d) == TRI_OK,
          "no mesh");
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = is_voronoi(points, 30, &d, &v);
        memory_fail_at(0);
        CLAIM("sec3.1.P11", status == TRI_OK || status == TRI_OUT_OF_MEMORY,
              "allocation %lu: %s", k, tri_status_text(status));
    }
    claim_verdict("sec3.1.P11", v);
    voronoi_free(&d);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "3.1: is_voronoi takes the diagram and nothing else");
    test_random("a vertex for each triangle", per_triangle_is_the_triangulation,
                1000, 40);
    test_random("another triangulation", only_delaunay_has_the_dual, 1500, 20);
    test_near_degenerate("another triangulation", only_delaunay_has_the_dual,
                         500, 10);
    test_random("damage", damage_is_seen, 4000, 30);
    test_grid_subsets("damage", damage_is_seen, 3);
    test_run("a forgotten vertex", a_forgotten_vertex_is_seen);
    test_run("one edge more", one_edge_more_is_seen);
    test_run("a cell around twice", a_cell_around_twice_is_seen);
    test_run("a vertex without a circle", a_vertex_needs_its_circle);
    test_run("broken lists", broken_lists_are_seen);
    test_run("out of memory", nothing_leaks);
    return test_end((test_minima){
        .trials = 6000, .largest_n = 30, .zeros = 10000, .expansions = 1000});
}
