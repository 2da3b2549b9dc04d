/* Section 3.6, line 1 of Figure 12: no finite triangle xyz is sufficiently large.
 *
 * Hypotheses: the errata's witnesses; for E41 and E46 some points inside a
 * triangle.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.6_randomized_incremental/large_triangle.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

/* Is what xyz leaves over a Delaunay triangulation? *lost is how many triangles
 * fewer than the vertex at infinity leaves. */
static bool
xyz_is_large_enough(const point2 *points, uint32_t n, double k, uint32_t *lost)
{
    triangle_list with_xyz, right;
    mesh m;
    verdict v;
    tri_status status = large_triangle_triangulate(points, n, k, &with_xyz);
    CLAIM("E40", status == TRI_OK, "%s", tri_status_text(status));
    CLAIM("E40", incremental_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    CLAIM("E40", mesh_triangles(&m, &right) == TRI_OK, "out of memory");
    mesh_free(&m);
    *lost = right.count - with_xyz.count;
    CLAIM("E40", is_delaunay(points, n, with_xyz, &v) == TRI_OK, "out of memory");
    bool good = v.holds;
    CLAIM("E40", is_delaunay(points, n, right, &v) == TRI_OK, "out of memory");
    claim_verdict("E40", v);
    triangle_list_free(&with_xyz);
    triangle_list_free(&right);
    return good;
}

static void
e40_no_triangle_is_large_enough(void)
{
    const point2 tiny[] = {{0, 2}, {1, 1}, {3, 0}};
    uint32_t lost;
    CLAIM("E40", !xyz_is_large_enough(tiny, 3, 3, &lost) && lost == 1,
          "three points, k = 3: %u triangles lost", lost);
    CLAIM("E40", xyz_is_large_enough(tiny, 3, 30, &lost) && lost == 0,
          "three points, k = 30: %u triangles lost", lost);

    const double M = 1e6;
    const point2 flat[] = {{0, 0}, {M, 0}, {M / 2, 1}, {M / 2 + 1, M}};
    for (double k = 10; k <= 1e5; k *= 10) {
        bool good = xyz_is_large_enough(flat, 4, k, &lost);
        CLAIM("E40", !good && lost > 0, "k = %g: %u triangles lost", k, lost);
    }
}

/* Of the triangles of D_n few have all of x, y and z for corners: only the first,
 * and none once a point has been inserted. And the degrees add up as E46 says. */
static void
lines_1_and_8(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    uint32_t count = n + 1;
    point2 *points = whole_points(NULL, count + 3, 50);
    vertex_id *order = malloc((count + 3) * sizeof *order);
    large_triangle(points, count, 30, &points[count]);
    for (uint32_t i = 0; i < count + 3; i++)
        order[i] = i < 3 ? count + i : i - 3;
    tri_options options = tri_options_default();
    options.order = order;
    mesh m;
    bool one_point =
        points[count].x == points[count + 1].x; /* the box has no size */
    tri_status status = incremental_triangulate(points, count + 3, &options, &m);
    free(order);
    free(points);
    CLAIM("E41", status == TRI_OK, "%s", tri_status_text(status));
    uint32_t all_three = 0, some = 0, degrees = 0, at_sites = 0,
             sites = m.locations - 3;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
        bool finite = mesh_origin(&m, e) != GHOST && mesh_dest(&m, e) != GHOST;
        degrees += finite;
        at_sites += finite && mesh_origin(&m, e) < count;
        if (e % 3 != 0 || !mesh_in_triangle(&m, e))
            continue;
        int removed = 0;
        for (halfedge_id f = e; f < e + 3; f++)
            removed += mesh_origin(&m, f) >= count;
        all_three += removed == 3;
        some += removed > 0;
    }
    mesh_free(&m);
    if (one_point)
        return;
    CLAIM("E41", all_three == 0 && some > 0,
          "%u triangles have x, y and z, %u one of them", all_three, some);
    CLAIM("E46", degrees == 6 * sites + 6 && at_sites <= 6 * sites - 3,
          "%u sites: all degrees add up to %u, those of the sites to %u", sites,
          degrees, at_sites);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6: no triangle xyz is sufficiently large");
    test_run("E40: three and four points", e40_no_triangle_is_large_enough);
    test_random("E41, E46: lines 1 and 8", lines_1_and_8, 500, 40);
    return test_end((test_minima){.trials = 501, .largest_n = 35});
}
