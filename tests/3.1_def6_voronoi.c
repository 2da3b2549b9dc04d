/* Definition 6: the regions, their edges and vertices are the Voronoi diagram, and
 * it is the dual of the Delaunay triangulation.
 *
 * Hypotheses: none. The sites may be cocircular, collinear or repeated; statements
 * that need three sites off a line say so.
 *
 * The diagram is certified by is_voronoi, which is itself tested by damage, and
 * compared cell by cell with the regions of Definition 5.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/contents.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>
#include <string.h>

/* ---- Diagrams to look at. ---- */

/* A Delaunay triangulation by an algorithm of the table, drawn anew, and with some of
 * the edges flipped that cocircular sites leave open: any one will do. */
static void
some_delaunay(const point2 *points, uint32_t n, mesh *m)
{
    random_source *r = test_random_source();
    const algorithm *a = &contents[random_below(r, contents_count)];
    while (!a->delaunay || n > a->most)
        a = &contents[random_below(r, contents_count)];
    CLAIM("sec3.1.P4", a->triangulate(points, n, NULL, m) == TRI_OK, "%s", a->name);
    for (uint32_t tries = random_below(r, 2 * n + 1); tries > 0 && m->triangles > 0;
         tries--) {
        halfedge_id e = random_below(r, mesh_halfedges(m));
        if (!is_flippable(m, points, e))
            continue;
        flip(m, e);
        if (!is_locally_delaunay(m, points, e))
            for (int back = 0; back < 3; back++)
                flip(m, e);
    }
}

static void
some_diagram(const point2 *points, uint32_t n, mesh *m, voronoi *d)
{
    some_delaunay(points, n, m);
    CLAIM("sec3.1.P4", voronoi_dual(m, points, d) == TRI_OK, "no diagram");
}

/* The diagram of a few points. */
static void
diagram_of(const point2 *points, uint32_t n, voronoi *d)
{
    mesh m;
    CLAIM("sec3.1.P4", lawson_triangulate(points, n, NULL, &m) == TRI_OK &&
          voronoi_dual(&m, points, d) == TRI_OK, "no diagram");
    mesh_free(&m);
}

static uint32_t
cell_size(const voronoi *d, vertex_id p)
{
    return d->cell_first[p + 1] - d->cell_first[p];
}

/* ---- The diagram is right. ---- */

static void
the_dual_is_certified(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    verdict v;
    some_delaunay(points, n, &m);
    uint32_t interior = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        interior += e < mesh_twin(&m, e) && mesh_is_interior(&m, e);
    uint64_t before = predicate_count.incircle;
    CLAIM("sec3.1.P4", voronoi_dual(&m, points, &d) == TRI_OK, "no diagram");
    uint64_t asked = predicate_count.incircle - before;
    CLAIM("sec3.1.P20", asked == interior, "%llu incircle tests, %u edges inside the hull",
          (unsigned long long)asked, interior);
    CLAIM("sec3.1.P11", is_voronoi(points, n, &d, &v) == TRI_OK, "out of memory");
    claim_verdict("sec3.1.P11", v);
    voronoi_free(&d);
    mesh_free(&m);
}

/* P4: beyond the edges of a cell are the sites of the region, in the same order. */
static void
the_dual_has_the_regions(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    some_diagram(points, n, &m, &d);
    for (vertex_id p = 0; p < n; p++) {
        if (mesh_leaving(&m, p) == NONE)
            continue;
        voronoi_region r;
        CLAIM("sec3.1.P4", voronoi_region_of(points, n, p, &r) == TRI_OK, "no region");
        CLAIM("sec3.1.P4", r.size == cell_size(&d, p), "site %u: %u edges by half-planes,"
              " %u by the dual", p, r.size, cell_size(&d, p));
        for (uint32_t i = 0; i < r.size; i++) {
            vertex_id q = voronoi_beyond(&d, d.cell_edge[d.cell_first[p] + i], p);
            CLAIM("sec3.1.P4", r.neighbour[i] == q, "site %u, edge %u: beyond it are %u "
                  "by half-planes and %u by the dual", p, i, r.neighbour[i], q);
        }
        voronoi_region_free(&r);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P5: the same diagram from two Delaunay triangulations, whatever their diagonals: the
 * cells have the same neighbours in the same order. */
static void
the_triangulation_does_not_matter(const point2 *points, uint32_t n)
{
    mesh m[2];
    voronoi d[2];
    for (int i = 0; i < 2; i++)
        some_diagram(points, n, &m[i], &d[i]);
    CLAIM("sec3.1.P5", d[0].vertices == d[1].vertices && d[0].edges == d[1].edges,
          "%u and %u vertices", d[0].vertices, d[1].vertices);
    for (vertex_id p = 0; p < n; p++) {
        CLAIM("sec3.1.P5", cell_size(&d[0], p) == cell_size(&d[1], p), "cell of %u", p);
        for (uint32_t i = 0; i < cell_size(&d[0], p); i++)
            CLAIM("sec3.1.P5",
                  voronoi_beyond(&d[0], d[0].cell_edge[d[0].cell_first[p] + i], p) ==
                  voronoi_beyond(&d[1], d[1].cell_edge[d[1].cell_first[p] + i], p),
                  "cell of %u, edge %u", p, i);
    }
    for (int i = 0; i < 2; i++) {
        voronoi_free(&d[i]);
        mesh_free(&m[i]);
    }
}

/* ---- What is true of vertices, edges and cells. ---- */

/* P6: a vertex has at least three nearest sites, and these are all: no site lies in
 * its circle, and on it only those listed. */
static void
vertices_have_empty_circles(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    some_diagram(points, n, &m, &d);
    for (uint32_t v = 0; v < d.vertices; v++) {
        const vertex_id *s = d.vertex_site + d.vertex_first[v];
        uint32_t size = d.vertex_first[v + 1] - d.vertex_first[v], on_circle = 0;
        CLAIM("sec3.1.P6", size >= 3, "vertex %u has %u sites", v, size);
        for (vertex_id x = 0; x < n; x++) {
            int side = oracle_incircle(points[s[0]], points[s[1]], points[s[2]], points[x]);
            CLAIM("sec3.1.P6", side <= 0, "%u lies in the circle of vertex %u", x, v);
            on_circle += side == 0 && mesh_leaving(&m, x) != NONE;
        }
        CLAIM("sec3.1.P6", on_circle == size, "vertex %u: %u sites are listed, and %u on "
              "its circle", v, size, on_circle);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P7: a point of an edge has exactly its two sites nearest. By the proof that follows
 * from this: the circles at the two ends are empty and differ, so no site but these two
 * is in or on both. */
static void
edges_have_two_nearest_sites(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    some_diagram(points, n, &m, &d);
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
            bool at_from = oracle_incircle(points[s[0]], points[s[1]], points[s[2]],
                                           points[x]) >= 0;
            bool at_to = oracle_incircle(points[t[0]], points[t[1]], points[t[2]],
                                         points[x]) >= 0;
            CLAIM("sec3.1.P7", (at_from && at_to) == copy, "site %u and the edge between "
                  "%u and %u", x, e.left, e.right);
        }
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* P8: unbounded exactly on the boundary of the hull; without vertices exactly when
 * collinear. */
static void
unbounded_cells_are_on_the_hull(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    some_diagram(points, n, &m, &d);
    bool *on_hull = calloc(n + 1, sizeof *on_hull);
    vertex_id *hull = malloc((n + 1) * sizeof *hull);
    uint32_t h = hull_vertices(&m, hull), u = m.locations;
    for (uint32_t i = 0; i < h; i++)
        on_hull[hull[i]] = true;
    for (vertex_id p = 0; p < n; p++)
        if (mesh_leaving(&m, p) != NONE)
            CLAIM("sec3.1.P8", voronoi_is_bounded(&d, p) == !on_hull[p],
                  "site %u is%s on the hull boundary", p, on_hull[p] ? "" : " not");
    bool collinear = affine_dimension(points, n) < 2;
    CLAIM("sec3.1.P8", (d.vertices == 0) == collinear, "%u vertices", d.vertices);
    uint32_t rays = 0;
    for (uint32_t k = 0; k < d.edges; k++) {
        bool from_infinity = d.edge[k].from == NONE, to_infinity = d.edge[k].to == NONE;
        rays += (from_infinity ? 1u : 0) + (to_infinity ? 1u : 0);
        CLAIM("sec3.1.P8", !from_infinity || to_infinity, "ray %u runs inwards", k);
    }
    CLAIM("sec3.1.P8", rays == (u < 2 ? 0 : collinear ? 2 * (u - 1) : h),
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
    some_diagram(points, n, &m, &d);
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
    some_diagram(points, n, &m, &d);
    for (vertex_id p = 0; p < n && m.locations > 1; p++) {
        if (mesh_leaving(&m, p) == NONE)
            continue;
        vertex_id best = NONE;
        for (vertex_id q = 0; q < n; q++)
            if (q != p && mesh_leaving(&m, q) != NONE && (best == NONE ||
                oracle_compare_distance(points[p], points[q], points[p], points[best]) < 0))
                best = q;
        for (vertex_id q = 0; q < n; q++)
            if (q != p && mesh_leaving(&m, q) != NONE &&
                oracle_compare_distance(points[p], points[q], points[p], points[best]) == 0)
                CLAIM("sec3.1.P10", share_an_edge(&d, p, q), "%u is nearest to %u", q, p);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* ---- Exercise X2: general position. ---- */

/* Without four cocircular sites around an empty circle, two Delaunay triangulations,
 * however they came about, have the same triangles. The lists are compared as sets. */
static bool
has_triangle(triangle_list list, const vertex_id *t)
{
    for (uint32_t k = 0; k < list.count; k++)
        for (int i = 0; i < 3; i++)
            if (list.corner[k][i] == t[0] && list.corner[k][(i + 1) % 3] == t[1] &&
                list.corner[k][(i + 2) % 3] == t[2])
                return true;
    return false;
}

static void
general_position_means_unique(const point2 *points, uint32_t n)
{
    mesh m[2];
    voronoi d;
    triangle_list list[2];
    some_diagram(points, n, &m[0], &d);
    bool general = d.vertex_first[d.vertices] == 3 * d.vertices;
    voronoi_free(&d);
    random_triangulation(points, n, &m[1]); /* and then flips in a random order */
    edge_stack L;
    CLAIM("sec3.1.P12", edge_stack_init(&L, &m[1]) == TRI_OK, "out of memory");
    push_all_edges(&L);
    lawson_flip(&L, points);
    edge_stack_free(&L);
    for (int i = 0; i < 2; i++)
        CLAIM("sec3.1.P12", mesh_triangles(&m[i], &list[i]) == TRI_OK, "out of memory");
    bool same = list[0].count == list[1].count;
    for (uint32_t t = 0; t < list[0].count; t++)
        same = same && has_triangle(list[1], list[0].corner[t]);
    CLAIM("sec3.1.P12", same || !general, "two different Delaunay triangulations");
    for (int i = 0; i < 2; i++) {
        triangle_list_free(&list[i]);
        mesh_free(&m[i]);
    }
}

/* ---- Exact values and errata. ---- */

static void
grids_have_squares(void)
{
    for (uint32_t k = 1; k <= 9; k++) {
        point2 points[81];
        for (uint32_t i = 0; i < k * k; i++)
            points[i] = (point2){i % k, i / k};
        voronoi d;
        diagram_of(points, k * k, &d);
        CLAIM("sec3.1.P5", d.vertices == (k - 1) * (k - 1) && d.edges == 2 * k * (k - 1),
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
    CLAIM("E14", d.cells == 3 && d.vertices == 1 && d.edges == 3, "v = %u, e = %u",
          d.vertices, d.edges);
    voronoi_free(&d);
}

static void
e15_two_sites(void)
{
    const point2 points[] = {{0, 0}, {1, 0}};
    voronoi d;
    diagram_of(points, 2, &d);
    CLAIM("E15", d.vertices == 0 && d.edges == 1, "v = %u, e = %u", d.vertices, d.edges);
    voronoi_free(&d);
}

/* How many triangulations of these points are Delaunay: all ways to choose triangles
 * among the counterclockwise ones, for at most 8 points and few triangles. */
static uint32_t
count_delaunay(const point2 *points, uint32_t n)
{
    vertex_id triple[56][3], chosen[20][3];
    uint32_t triples = 0, found = 0, wanted = 0;
    mesh m;
    triangle_list list;
    CLAIM("E17", lawson_triangulate(points, n, NULL, &m) == TRI_OK &&
          mesh_triangles(&m, &list) == TRI_OK, "no triangulation");
    wanted = list.count;
    triangle_list_free(&list);
    mesh_free(&m);
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = a + 1; b < n; b++)
            for (vertex_id c = a + 1; c < n; c++)
                if (orient2d(points[a], points[b], points[c]) > 0)
                    memcpy(triple[triples++], (vertex_id[3]){a, b, c}, sizeof *triple);
    for (uint32_t set = 0; set < 1u << triples; set++) {
        uint32_t size = 0;
        for (uint32_t i = 0; i < triples && size <= wanted; i++)
            if (set >> i & 1)
                memcpy(chosen[size++], triple[i], sizeof *chosen);
        verdict v;
        if (size != wanted)
            continue;
        CLAIM("E17", is_delaunay(points, n, (triangle_list){size, chosen}, &v) == TRI_OK,
              "out of memory");
        found += v.holds;
    }
    return found;
}

static void
e17_only_empty_circles_matter(void)
{
    const point2 square[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {0, 0}};
    CLAIM("E17", incircle(square[0], square[1], square[2], square[3]) == 0,
          "the corners are not cocircular");
    uint32_t with_centre = count_delaunay(square, 5), without = count_delaunay(square, 4);
    CLAIM("E17", with_centre == 1, "%u Delaunay triangulations", with_centre);
    CLAIM("E17", without == 2, "without the centre, %u", without);
}

static void
e18_grids_are_not_random(void)
{
    point2 points[9];
    uint32_t quadruples = 0, cocircular = 0;
    for (uint32_t i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    for (uint32_t a = 0; a < 9; a++)
        for (uint32_t b = a + 1; b < 9; b++)
            for (uint32_t c = b + 1; c < 9; c++)
                for (uint32_t d = c + 1; d < 9; d++) {
                    bool circle = orient2d(points[a], points[b], points[c]) != 0;
                    quadruples++;
                    cocircular += circle &&
                        oracle_incircle(points[a], points[b], points[c], points[d]) == 0;
                }
    CLAIM("E18", quadruples == 126 && cocircular == 14, "%u of %u quadruples", cocircular,
          quadruples);
}

/* (1,0), moved up by ever less, leaves the hull boundary, and its cell is bounded;
 * moved down it becomes a corner of the hull. Only unmoved it is in the hull edge. */
static void
e19_perturbing_moves_the_hull(void)
{
    for (int i = 0; i <= 60; i++) {
        double tiny = i < 60 ? 1.0 / (double)(UINT64_C(1) << i) / 4 : 0x1p-1074;
        for (int sign = -1; sign <= 1; sign++) {
            const point2 points[] = {{0, 0}, {1, sign * tiny}, {2, 0}, {1, 2}};
            mesh m;
            voronoi d;
            CLAIM("E19", lawson_triangulate(points, 4, NULL, &m) == TRI_OK &&
                  voronoi_dual(&m, points, &d) == TRI_OK, "no diagram");
            uint32_t h = mesh_hull_size(&m);
            CLAIM("E19", h == (sign > 0 ? 3 : 4), "moved by %g: h = %u", sign * tiny, h);
            CLAIM("E19", voronoi_is_bounded(&d, 1) == (sign > 0), "moved by %g",
                  sign * tiny);
            voronoi_free(&d);
            mesh_free(&m);
        }
    }
}

/* ---- The check, by damage. ---- */

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
    case 0: { /* the edge turned around: a ray comes from infinity to the wrong side */
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
    some_diagram(points, n, &m, &d);
    uint32_t kind = random_below(test_random_source(), 9);
    bool damaged = damage(&d, kind);
    CLAIM("sec3.1.P11", is_voronoi(points, n, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !damaged || !v.holds, "damage %u was not seen", kind);
    voronoi_free(&d);
    mesh_free(&m);
}

/* Forgeries in which every cell looks right. The sites (0,0), (4,0), (0,4), (5,5)
 * have two vertices; here are the edges of the first one only, and (5,5) has no cell. */
static void
a_forgotten_vertex_is_seen(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {5, 5}};
    uint32_t vertex_first[] = {0, 3, 6}, cell_first[] = {0, 2, 4, 6, 6};
    vertex_id vertex_site[] = {0, 1, 2, 1, 3, 2};
    voronoi_edge edge[] = {{1, 0, 0, NONE}, {2, 1, 0, NONE}, {0, 2, 0, NONE}};
    uint32_t cell_edge[] = {0, 2, 1, 0, 2, 1};
    voronoi forged = {4, 3, 2, 3, vertex_first, vertex_site, edge, cell_first, cell_edge};
    verdict v;
    CLAIM("sec3.1.P11", is_voronoi(points, 4, &forged, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a vertex without edges was not seen");
    forged.points = 3;
    forged.vertices = 1;
    CLAIM("sec3.1.P11", is_voronoi(points, 3, &forged, &v) == TRI_OK, "out of memory");
    claim_verdict("sec3.1.P11", v); /* of three sites this is the diagram */
}

/* The diagram of (0,0), (4,0), (0,4) and two copies, with an edge too many: in no cell;
 * or a line between the copies, in theirs. */
static void
one_edge_more_is_seen(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {4, 0}, {0, 4}};
    uint32_t vertex_first[] = {0, 3}, cell_first[] = {0, 2, 4, 6, 6, 6};
    vertex_id vertex_site[] = {0, 1, 2};
    voronoi_edge edge[] = {{1, 0, 0, NONE}, {2, 1, 0, NONE}, {0, 2, 0, NONE},
                           {3, 4, NONE, NONE}};
    uint32_t cell_edge[] = {0, 2, 1, 0, 2, 1, 3, 3};
    voronoi d = {5, 3, 1, 3, vertex_first, vertex_site, edge, cell_first, cell_edge};
    verdict v;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK, "out of memory");
    claim_verdict("sec3.1.P11", v);
    d.edges = 4;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "an edge in no cell was not seen");
    cell_first[4] = 7;
    cell_first[5] = 8;
    d.cells = 5;
    CLAIM("sec3.1.P11", is_voronoi(points, 5, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a line between copies was not seen");
}

/* In a grid, one cell goes around twice, and another of the same size not at all. */
static void
a_cell_around_twice_is_seen(void)
{
    point2 points[16];
    for (uint32_t i = 0; i < 16; i++)
        points[i] = (point2){i % 4, i / 4};
    voronoi d;
    verdict v;
    diagram_of(points, 16, &d);
    uint32_t *twice = d.cell_edge + d.cell_first[5], *none = d.cell_edge + d.cell_first[6];
    CLAIM("sec3.1.P11", cell_size(&d, 5) == 4 && cell_size(&d, 6) == 4, "no grid");
    memcpy(none, twice, 4 * sizeof *none); /* the two follow each other */
    d.cell_first[6] += 4;
    d.cells--;
    CLAIM("sec3.1.P11", is_voronoi(points, 16, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", !v.holds, "a cell around twice was not seen");
    voronoi_free(&d);
}

/* The dual of some other triangulation is refuted. */
static void
only_delaunay_has_the_dual(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    verdict v, delaunay;
    triangle_list list;
    random_triangulation(points, n, &m);
    CLAIM("sec3.1.P11", mesh_triangles(&m, &list) == TRI_OK &&
          voronoi_dual(&m, points, &d) == TRI_OK, "no diagram");
    CLAIM("sec3.1.P11", is_delaunay(points, n, list, &delaunay) == TRI_OK &&
          is_voronoi(points, n, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P11", v.holds == delaunay.holds, "the dual of %s triangulation %s",
          delaunay.holds ? "a Delaunay" : "another", v.holds ? "is taken" : "is refuted");
    triangle_list_free(&list);
    voronoi_free(&d);
    mesh_free(&m);
}

/* One vertex for each triangle is the diagram of Definition 6 exactly in general
 * position; the numbers are those of the triangulation. */
static void
per_triangle_is_the_triangulation(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi merged, d;
    verdict v;
    triangle_list list;
    some_diagram(points, n, &m, &merged);
    CLAIM("sec3.1.P5", voronoi_per_triangle(&m, &d) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P5", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P5", d.vertices == list.count, "%u vertices", d.vertices);
    for (uint32_t t = 0; t < list.count; t++) {
        const vertex_id *s = d.vertex_site + d.vertex_first[t];
        CLAIM("sec3.1.P5", d.vertex_first[t + 1] == 3 * t + 3 &&
              has_triangle((triangle_list){1, &list.corner[t]}, s), "vertex %u", t);
    }
    uint32_t joining = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        joining += mesh_origin(&m, e) < mesh_dest(&m, e) && mesh_dest(&m, e) < n;
    CLAIM("sec3.1.P5", d.edges == joining, "%u edges", d.edges);
    CLAIM("sec3.1.P5", is_voronoi(points, n, &d, &v) == TRI_OK, "out of memory");
    CLAIM("sec3.1.P5", v.holds == (d.vertices == merged.vertices), "%s",
          v.holds ? "holds, although two vertices are the same point" : v.because);
    triangle_list_free(&list);
    voronoi_free(&d);
    voronoi_free(&merged);
    mesh_free(&m);
}

/* ---- Memory that runs out. ---- */

static void
nothing_leaks(void)
{
    point2 points[30];
    for (int i = 0; i < 30; i++)
        points[i] = (point2){i % 6, i / 6 + i % 2 * 0.25};
    mesh m;
    voronoi d;
    verdict v;
    CLAIM("sec3.1.P4", lawson_triangulate(points, 30, NULL, &m) == TRI_OK, "no mesh");
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = voronoi_dual(&m, points, &d);
        memory_fail_at(0);
        CLAIM("sec3.1.P4", status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
              d.edge == NULL && d.vertices == 0), "allocation %lu: %s", k,
              tri_status_text(status));
    }
    status = TRI_OUT_OF_MEMORY;
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
    test_begin(argc, argv, "Definition 6: the Voronoi diagram, dual to Delaunay");
    test_random("certified", the_dual_is_certified, 2000, 80);
    test_near_degenerate("certified", the_dual_is_certified, 1500, 40);
    test_grid_subsets("certified", the_dual_is_certified, 4);
    test_random("the regions of Definition 5", the_dual_has_the_regions, 1000, 30);
    test_near_degenerate("the regions of Definition 5", the_dual_has_the_regions, 800, 16);
    test_grid_subsets("the regions of Definition 5", the_dual_has_the_regions, 3);
    test_random("any Delaunay triangulation", the_triangulation_does_not_matter, 1000, 60);
    test_random("empty circles", vertices_have_empty_circles, 500, 20);
    test_near_degenerate("empty circles", vertices_have_empty_circles, 300, 10);
    test_random("points of edges", edges_have_two_nearest_sites, 500, 16);
    test_near_degenerate("points of edges", edges_have_two_nearest_sites, 150, 10);
    test_random("unbounded cells", unbounded_cells_are_on_the_hull, 1500, 60);
    test_near_degenerate("unbounded cells", unbounded_cells_are_on_the_hull, 1000, 40);
    test_random("counts", the_counts_are_right, 1500, 200);
    test_near_degenerate("counts", the_counts_are_right, 1000, 60);
    test_grid_subsets("counts", the_counts_are_right, 3);
    test_random("nearest sites", nearest_sites_share_an_edge, 1000, 30);
    test_near_degenerate("nearest sites", nearest_sites_share_an_edge, 500, 16);
    test_random("uniqueness", general_position_means_unique, 1500, 30);
    test_near_degenerate("uniqueness", general_position_means_unique, 1000, 20);
    test_random("a vertex for each triangle", per_triangle_is_the_triangulation, 1000, 40);
    test_random("another triangulation", only_delaunay_has_the_dual, 1500, 20);
    test_near_degenerate("another triangulation", only_delaunay_has_the_dual, 500, 10);
    test_random("damage", damage_is_seen, 4000, 30);
    test_grid_subsets("damage", damage_is_seen, 3);
    test_run("a forgotten vertex", a_forgotten_vertex_is_seen);
    test_run("one edge more", one_edge_more_is_seen);
    test_run("a cell around twice", a_cell_around_twice_is_seen);
    test_run("grids", grids_have_squares);
    test_run("E14: three sites", e14_three_sites);
    test_run("E15: two sites", e15_two_sites);
    test_run("E17: only empty circles matter", e17_only_empty_circles_matter);
    test_run("E18: grids", e18_grids_are_not_random);
    test_run("E19: perturbation", e19_perturbing_moves_the_hull);
    test_run("out of memory", nothing_leaks);
    return test_end((test_minima){.trials = 20000, .largest_n = 150, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
