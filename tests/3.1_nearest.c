/* Section 3.1: walking over the Delaunay triangulation finds a site nearest to
 * x.
 *
 * Hypotheses: there is a site. x may be a site, lie on an edge of the diagram
 * or be a vertex of it, and be as far away as doubles reach.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/oracle/oracle.h"

#include <float.h>

/* A question: a site, halfway between two, a vertex, near the sites, or far
 * away. */
static point2
some_question(const point2 *points, uint32_t n)
{
    random_source *source = test_random_source();
    point2 p = points[random_below(source, n)],
           q = points[random_below(source, n)];
    point2 r = points[random_below(source, n)], x;
    switch (random_below(source, 5)) {
    case 0:
        return p;
    case 1:
        return (point2){p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
    case 2:
        if (oracle_orient2d(p, q, r) != 0 &&
            circumcentre(p, q, r, &x) == TRI_OK)
            return x;
        return q;
    case 3:
        return (point2){p.x, q.y};
    default:
        return (point2){random_below(source, 2) ? DBL_MAX : -DBL_MAX, p.y};
    }
}

static void
the_walk_ends_at_a_nearest_site(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 1);
    mesh m;
    CLAIM("sec3.1.P14", lawson_triangulate(points, n, NULL, &m) == TRI_OK,
          "no mesh");
    vertex_id start = random_below(test_random_source(), n);
    while (m.locations > 1 && mesh_leaving(&m, start) == NONE)
        start = (start + 1) % n;
    for (int i = 0; i < 8; i++) {
        point2 x = some_question(points, n);
        uint32_t visited;
        vertex_id found = nearest_site(&m, points, x, start, &visited);
        for (vertex_id q = 0; q < n; q++)
            CLAIM("sec3.1.P14",
                  oracle_compare_distance(x, points[found], x, points[q]) <= 0,
                  "%u is nearer to (%g,%g) than %u", q, x.x, x.y, found);
        /* No site is left twice, so no half-edge is looked along twice. */
        CLAIM("sec3.1.P14", visited >= 1 && visited <= 1 + mesh_halfedges(&m),
              "%u sites visited", visited);
        CLAIM("sec3.1.P14", m.locations == 1 || mesh_leaving(&m, found) != NONE,
              "%u is a copy of an earlier site", found);
        start = found;
    }
    mesh_free(&m);
}

/* In a grid of k x k sites a walk from one corner to the other goes along
 * diagonals and rows: it leaves at most 2k sites, with 8 neighbours at most. */
static void
a_walk_is_short(void)
{
    enum { K = 40 };
    point2 points[K * K];
    for (uint32_t i = 0; i < K * K; i++)
        points[i] = (point2){i % K, i / K};
    mesh m;
    CLAIM("sec3.1.P14", lawson_triangulate(points, K * K, NULL, &m) == TRI_OK,
          "no mesh");
    uint32_t visited;
    vertex_id found = nearest_site(&m, points, (point2){K, K}, 0, &visited);
    CLAIM("sec3.1.P14", found == K * K - 1, "%u", found);
    CLAIM("sec3.1.P14", visited <= 16 * K, "%u sites visited", visited);
    mesh_free(&m);
}

/* With one location there is no vertex to begin at, and copies change nothing. */
static void
one_site_is_the_nearest(void)
{
    const point2 points[] = {{2, 3}, {2, 3}, {2, 3}};
    for (uint32_t n = 1; n <= 3; n++) {
        mesh m;
        uint32_t visited;
        CLAIM("sec3.1.P14", lawson_triangulate(points, n, NULL, &m) == TRI_OK,
              "no mesh");
        vertex_id found = nearest_site(&m, points, (point2){9, 9}, n - 1, &visited);
        CLAIM("sec3.1.P14", found == 0 && visited == 1, "%u, %u visited", found,
              visited);
        mesh_free(&m);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.1: the nearest site, by walking");
    test_random("nearest", the_walk_ends_at_a_nearest_site, 2000, 60);
    test_near_degenerate("nearest", the_walk_ends_at_a_nearest_site, 1000, 30);
    test_grid_subsets("nearest", the_walk_ends_at_a_nearest_site, 3);
    test_run("a walk is short", a_walk_is_short);
    test_run("one site", one_site_is_the_nearest);
    return test_end((test_minima){.trials = 3000,
                                  .largest_n = 50,
                                  .zeros = 1000,
                                  .expansions = 500,
                                  .wide = 500});
}
