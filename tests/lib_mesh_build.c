/* lib/mesh_build: the mesh made of its own triangles is the same mesh again.
 *
 * Hypotheses: mesh_from_triangles wants at least one triangle, mesh_from_path
 * collinear points. A random triangulation is taken apart and put together, its
 * triangles in random order and turned at random.
 */
#include "lib/mesh_build.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "lib/memory.h"
#include "tests/harness/start.h"

#include <stdlib.h>

static bool
is_zeroed(const mesh *m)
{
    return m->halfedge == NULL && m->leaving == NULL && m->points == 0 &&
           m->locations == 0 && m->triangles == 0;
}

static void
exchange(vertex_id *a, vertex_id *b)
{
    vertex_id kept = *a;
    *a = *b;
    *b = kept;
}

/* Puts the triangles into random order, and begins some at another corner. */
static void
shuffle(triangle_list list)
{
    random_source *r = test_random_source();
    for (uint32_t t = list.count; t > 0; t--) {
        vertex_id *last = list.corner[t - 1],
                  *chosen = list.corner[random_below(r, t)];
        for (int i = 0; i < 3; i++)
            exchange(&last[i], &chosen[i]);
        if (random_below(r, 2) == 0) { /* a b c becomes b c a */
            exchange(&last[0], &last[1]);
            exchange(&last[1], &last[2]);
        }
    }
}

/* Do both meshes have the same vertices on the hull? */
static void
expect_same_hull(const mesh *m, const mesh *again)
{
    vertex_id *hull = malloc((m->locations + 1) * sizeof *hull);
    vertex_id *other = malloc((m->locations + 1) * sizeof *other);
    uint32_t h = hull_vertices(m, hull), k = hull_vertices(again, other);
    CLAIM("mesh_build", h == k, "%u hull vertices became %u", h, k);
    for (uint32_t i = 0; i < h; i++)
        CLAIM("mesh_build", hull[i] == other[i],
              "hull vertex %u is %u and was %u", i, other[i], hull[i]);
    free(hull);
    free(other);
}

static void
triangles_make_their_mesh(const point2 *points, uint32_t n)
{
    mesh m, again;
    triangle_list list;
    HYPOTHESIS(affine_dimension(points, n) == 2);
    random_triangulation(points, n, &m);
    CLAIM("mesh_build", mesh_triangles(&m, &list) == TRI_OK, "no triangles");
    shuffle(list);
    tri_status status = mesh_from_triangles(n, list, &again);
    CLAIM("mesh_build", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("mesh_build", mesh_check(&again));
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        CLAIM("mesh_build",
              mesh_origin(&again, e) == side_origin(list, e) &&
                  mesh_dest(&again, e) == side_dest(list, e),
              "side %u is no half-edge", e);
    CLAIM("mesh_build",
          again.triangles == m.triangles && again.locations == m.locations,
          "%u triangles became %u", m.triangles, again.triangles);
    expect_same_hull(&m, &again);
    triangle_list_free(&list);
    mesh_free(&m);
    mesh_free(&again);
}

static void
a_path_makes_its_mesh(const point2 *points, uint32_t n)
{
    const point2 along_x = {1, 0};
    point2 *line = malloc((n + 1) * sizeof *line);
    for (uint32_t i = 0; i < n;
         i++) /* the diagonal, with the same duplicates */
        line[i] = (point2){points[i].x, points[i].x};
    vertex_id *order = malloc((n + 1) * sizeof *order);
    uint32_t u;
    mesh m, again;
    CLAIM("mesh_build", sort_along(line, n, along_x, order, &u) == TRI_OK,
          "no order");
    CLAIM("mesh_build", sweep_triangulate(line, n, NULL, &m) == TRI_OK,
          "no mesh");
    tri_status status = mesh_from_path(n, order, u, &again);
    CLAIM("mesh_build", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("mesh_build", mesh_check(&again));
    CLAIM("mesh_build", again.locations == u, "%u locations became %u", u,
          again.locations);
    expect_same_hull(&m, &again);
    free(line);
    free(order);
    mesh_free(&m);
    mesh_free(&again);
}

/* In both functions, for every k. */
static void
memory_may_run_out(void)
{
    const point2 points[] = {{0, 0}, {4, 1}, {1, 3}, {2, 1}, {5, 5}};
    const vertex_id path[] = {1, 0, 2};
    triangle_list list;
    mesh m, again;
    CLAIM("mesh_build",
          sweep_triangulate(points, 5, NULL, &m) == TRI_OK &&
              mesh_triangles(&m, &list) == TRI_OK,
          "no triangles");
    mesh_free(&m);
    for (int which = 0; which < 2; which++) {
        tri_status status = TRI_OUT_OF_MEMORY;
        unsigned long k = 0;
        while (status != TRI_OK) {
            memory_fail_at(++k);
            status = which == 0 ? mesh_from_triangles(5, list, &again)
                                : mesh_from_path(3, path, 3, &again);
            memory_fail_at(0);
            CLAIM("mesh_build",
                  status == TRI_OK ||
                      (status == TRI_OUT_OF_MEMORY && is_zeroed(&again)),
                  "allocation %lu: %s", k, tri_status_text(status));
        }
        CLAIM("mesh_build", k > 2, "%lu allocations", k - 1);
        mesh_free(&again);
    }
    triangle_list_free(&list);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "lib/mesh_build: a mesh made of its triangles, or of a path");
    test_random("triangles make their mesh", triangles_make_their_mesh, 2000,
                100);
    test_grid_subsets("triangles make their mesh", triangles_make_their_mesh,
                      3);
    test_random("a path makes its mesh", a_path_makes_its_mesh, 1000, 60);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 3000, .largest_n = 90});
}
