/* The flip: an edge inside a strictly convex quadrilateral is replaced by the other
 * diagonal, every half-edge turns one place counterclockwise, and four flips
 * restore everything.
 *
 * Hypotheses: the edge is flippable. That an edge which is not locally Delaunay
 * always is (E34) is proved and tested with Figure 10.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>
#include <string.h>

static void
check_triangulation(const char *claim, const point2 *points, const mesh *m)
{
    triangle_list list;
    verdict v = mesh_check(m);
    claim_verdict(claim, v);
    CLAIM(claim, mesh_triangles(m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM(claim, is_triangulation(points, m->points, list, &v) == TRI_OK,
          "out of memory");
    triangle_list_free(&list);
    claim_verdict(claim, v);
}

/* An edge between two triangles, if there is one; else NONE. */
static halfedge_id
some_interior_edge(const mesh *m)
{
    random_source *r = test_random_source();
    for (int tries = 0; tries < 30 && m->triangles > 0; tries++) {
        halfedge_id e = random_below(r, mesh_halfedges(m));
        if (mesh_is_interior(m, e))
            return e;
    }
    return NONE;
}

/* The table of flip's contract: before, (origin, dest) of six half-edges. */
static void
check_turned(const mesh *m, halfedge_id ab, const vertex_id v[4])
{
    enum { a, b, c, d };
    const int after[6][2] = {{d, c}, {c, a}, {a, d}, {c, d}, {d, b}, {b, c}};
    halfedge_id ba = mesh_twin(m, ab);
    halfedge_id e[6] = {ab, mesh_next(ab), mesh_prev(ab),
                        ba, mesh_next(ba), mesh_prev(ba)};
    for (int i = 0; i < 6; i++)
        CLAIM("flip.P1",
              mesh_origin(m, e[i]) == v[after[i][0]] &&
                  mesh_dest(m, e[i]) == v[after[i][1]],
              "half-edge %d of the table leads from "
              "%u to %u",
              i, mesh_origin(m, e[i]), mesh_dest(m, e[i]));
}

static void
a_flip_turns_the_edge(const point2 *points, uint32_t n)
{
    mesh m;
    random_triangulation(points, n, &m);
    halfedge_id ab = some_interior_edge(&m);
    if (ab != NONE && is_flippable(&m, points, ab)) {
        halfedge_id ba = mesh_twin(&m, ab);
        vertex_id v[4] = {mesh_origin(&m, ab), mesh_origin(&m, ba), mesh_apex(&m, ab),
                          mesh_apex(&m, ba)};
        size_t bytes = mesh_halfedges(&m) * sizeof *m.halfedge;
        mesh_halfedge *before = malloc(bytes);
        memcpy(before, m.halfedge, bytes);
        flip(&m, ab);
        check_turned(&m, ab, v);
        check_triangulation("flip.P1", points, &m);
        flip(&m, ab);
        flip(&m, ab);
        flip(&m, ab);
        bool same = memcmp(before, m.halfedge, bytes) == 0;
        free(before);
        CLAIM("flip.P2", same, "four flips of one edge change the mesh");
    }
    mesh_free(&m);
}

/* is_flippable is right when it says yes (the flip leaves a triangulation) and when
 * it says no (the other diagonal crosses or touches what it must not). */
static void
flippable_means_convex(const point2 *points, uint32_t n)
{
    mesh m;
    random_triangulation(points, n, &m);
    halfedge_id ab = some_interior_edge(&m);
    if (ab != NONE && !is_flippable(&m, points, ab)) {
        vertex_id a = mesh_origin(&m, ab), b = mesh_dest(&m, ab);
        vertex_id c = mesh_apex(&m, ab), d = mesh_apex(&m, mesh_twin(&m, ab));
        int left = orient2d(points[c], points[d], points[a]);
        int right = orient2d(points[c], points[d], points[b]);
        CLAIM("flip.P3", left * right >= 0, "ab = %u %u and cd = %u %u cross", a, b, c,
              d);
    }
    if (ab != NONE && is_flippable(&m, points, ab)) {
        flip(&m, ab);
        check_triangulation("flip.P3", points, &m);
    }
    mesh_free(&m);
}

/* E34: in the triangle with an inner point no edge at all can be flipped. */
static void
e34_nothing_is_flippable(const point2 *points, uint32_t n)
{
    mesh m;
    random_triangulation(points, n, &m);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        CLAIM("E34", !is_flippable(&m, points, e), "half-edge %u can be flipped", e);
    CLAIM("E34", mesh_hull_size(&m) == 3, "the inner point is on the hull");
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    const point2 inner[] = {{0, 0}, {3, 0}, {0, 3}, {1, 1}};
    test_begin(argc, argv, "The flip: ab becomes cd");
    test_random("a flip turns the edge", a_flip_turns_the_edge, 3000, 40);
    test_near_degenerate("a flip turns the edge", a_flip_turns_the_edge, 3000, 25);
    test_random("flippable means convex", flippable_means_convex, 3000, 40);
    test_near_degenerate("flippable means convex", flippable_means_convex, 3000, 25);
    test_grid_subsets("flippable means convex", flippable_means_convex, 3);
    test_points("E34: nothing is flippable", e34_nothing_is_flippable, inner, 4);
    return test_end((test_minima){.trials = 10000, .largest_n = 30, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
