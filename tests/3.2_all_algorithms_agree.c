/* Definition 8 without general position: all Delaunay triangulations of a point
 * set have the same cells. So all algorithms must agree on them.
 *
 * Hypotheses: none. Agreement never stands alone: each result is certified too,
 * by Theorem 3 (is_delaunay) and by big integers that share no code with the
 * library.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/contents.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <stdlib.h>

static const char *const locator_name[] = {"walk", "buckets", "history", "grid"};

/* What some of the algorithms take and the result must not depend on. */
static tri_options
random_options(void)
{
    random_source *r = test_random_source();
    tri_options options = tri_options_default();
    options.locator = (tri_locator)random_below(r, TRI_LOCATOR_GRID + 1);
    options.cuts = (tri_cuts)random_below(r, TRI_CUTS_ALTERNATING + 1);
    options.seed = random_bits(r);
    return options;
}

/* The algorithm's mesh, which is certified by Theorem 3. */
static mesh
certified(const algorithm *a, const point2 *points, uint32_t n)
{
    mesh m;
    tri_options options = random_options();
    tri_status status = a->triangulate(points, n, &options, &m);
    CLAIM("def8.P5", status == TRI_OK, "%s, cuts %d, locator %s: %s", a->name,
          (int)options.cuts, locator_name[options.locator], tri_status_text(status));
    claim_verdict("def8.P5", mesh_check(&m));
    triangle_list list;
    verdict v;
    CLAIM("def8.P5", mesh_triangles(&m, &list) == TRI_OK, "no list");
    test_picture(list);
    CLAIM("def8.P5", is_delaunay(points, n, list, &v) == TRI_OK,
          "out of memory");
    triangle_list_free(&list);
    claim_verdict("def8.P5", v);
    return m;
}

static bool
same_hull(const mesh *m, const mesh *k)
{
    vertex_id *hull = malloc((m->locations + 1) * sizeof *hull);
    vertex_id *other = malloc((k->locations + 1) * sizeof *other);
    uint32_t h = hull_vertices(m, hull);
    bool same = m->locations == k->locations && h == hull_vertices(k, other);
    for (uint32_t i = 0; i < h && same; i++)
        same = hull[i] == other[i];
    free(hull);
    free(other);
    return same;
}

/* On a path, too, where there are no cells: then the hull is the whole path. */
static void
expect_agreement(const point2 *points, const mesh *m, const mesh *k,
                 const char *name)
{
    subdivision s, t;
    CLAIM("def8.P5",
          delaunay_subdivision(m, points, &s) == TRI_OK &&
              delaunay_subdivision(k, points, &t) == TRI_OK,
          "out of memory");
    CLAIM("def8.P5", subdivisions_are_equal(&s, &t), "%s has other cells",
          name);
    CLAIM("def8.P5", same_hull(m, k), "%s has another hull", name);
    subdivision_free(&s);
    subdivision_free(&t);
}

/* The algorithms that can be given `size` points agree on these n. */
static void
agree(const point2 *points, uint32_t n, uint32_t size)
{
    const algorithm *lawson = contents_find("lawson");
    mesh m = certified(lawson, points, n);
    for (uint32_t i = 0; i < contents_count; i++) {
        const algorithm *a = &contents[i];
        if (!a->delaunay || a == lawson || size > a->most)
            continue;
        mesh k = certified(a, points, n);
        expect_agreement(points, &m, &k, a->name);
        mesh_free(&k);
    }
    mesh_free(&m);
}

static void
all_algorithms_agree(const point2 *points, uint32_t n)
{
    agree(points, n, n);
}

static void
fast_algorithms_agree(const point2 *points, uint32_t n)
{
    agree(points, n, UINT32_MAX);
}

/* Other diagonals of a cell make another Delaunay triangulation. */
static void
other_diagonals_do_not_matter(const point2 *points, uint32_t n)
{
    mesh m = certified(contents_find("divide"), points, n);
    mesh k = random_delaunay(points, n);
    expect_agreement(points, &m, &k, "with other diagonals, a triangulation");
    mesh_free(&m);
    mesh_free(&k);
}

/* No site inside any circle and none outside the hull, say big integers. */
static void
big_integers_agree(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < contents_count; i++) {
        mesh m;
        if (!contents[i].delaunay || n > contents[i].most)
            continue;
        CLAIM("def8.P5", contents[i].triangulate(points, n, NULL, &m) == TRI_OK,
              "%s", contents[i].name);
        for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
            if (!mesh_in_triangle(&m, e))
                continue;
            vertex_id a = mesh_origin(&m, e), b = mesh_dest(&m, e),
                      c = mesh_apex(&m, e);
            CLAIM("def8.P5",
                  oracle_orient2d(points[a], points[b], points[c]) > 0,
                  "%s: %u %u %u is not counterclockwise", contents[i].name, a,
                  b, c);
            bool hull = mesh_is_hull_edge(&m, e);
            for (vertex_id d = 0; d < n; d++) {
                CLAIM("def8.P5",
                      e % 3 != 0 || oracle_incircle(points[a], points[b],
                                                    points[c], points[d]) <= 0,
                      "%s: %u lies inside the circle of "
                      "%u %u %u",
                      contents[i].name, d, a, b, c);
                CLAIM("def8.P5",
                      !hull ||
                          oracle_orient2d(points[a], points[b], points[d]) >= 0,
                      "%s: %u lies outside the hull edge %u %u",
                      contents[i].name, d, a, b);
            }
        }
        mesh_free(&m);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "all Delaunay algorithms make the same cells");
    test_random("small sets", all_algorithms_agree, 1500, 24);
    test_random("large sets", fast_algorithms_agree, 200, 400);
    test_near_degenerate("small sets", all_algorithms_agree, 1000, 14);
    test_near_degenerate("larger sets", fast_algorithms_agree, 500, 60);
    test_grid_subsets("every set of a grid", all_algorithms_agree, 3);
    test_grid_subsets("every set of a larger grid", fast_algorithms_agree, 4);
    test_random("other diagonals", other_diagonals_do_not_matter, 1000, 100);
    test_near_degenerate("other diagonals", other_diagonals_do_not_matter, 1000,
                         40);
    test_random("big integers", big_integers_agree, 150, 16);
    test_near_degenerate("big integers", big_integers_agree, 150, 10);
    return test_end((test_minima){.trials = 60000,
                                  .largest_n = 350,
                                  .zeros = 100000,
                                  .expansions = 100000,
                                  .wide = 100000});
}
