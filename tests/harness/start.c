/* start.c - triangulations to begin with. */
#include "tests/harness/start.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/contents.h"

#include <stdlib.h>

point2
random_direction(void)
{
    static const point2 special[] = {{1, 0}, {0, 1}, {-1, 0}, {1, 1}, {-3, 2},
                                     {1e-300, 1e300}};
    random_source *r = test_random_source();
    uint32_t i = random_below(r, 8);
    if (i < 6)
        return special[i];
    point2 p = random_point(r);
    return (point2){p.x - 0.5, p.y - 0.75};
}

void
show(const mesh *m)
{
    triangle_list list;
    if (mesh_triangles(m, &list) == TRI_OK)
        test_picture(list);
    triangle_list_free(&list);
}

void
random_triangulation(const point2 *points, uint32_t n, mesh *out)
{
    random_source *r = test_random_source();
    tri_options options = tri_options_default();
    options.direction = random_direction();
    tri_status status = sweep_triangulate(points, n, &options, out);
    CLAIM("fig3.P3", status == TRI_OK, "%s", tri_status_text(status));
    if (out->triangles == 0)
        return;
    for (uint32_t flips = random_below(r, 4 * n); flips > 0; flips--) {
        halfedge_id e = random_below(r, mesh_halfedges(out));
        if (is_flippable(out, points, e))
            flip(out, e);
    }
}

/* An edge that has been flipped and is locally Delaunay afterwards was so before, too:
 * its four sites are cocircular. */
mesh
random_delaunay(const point2 *points, uint32_t n)
{
    mesh m;
    random_source *r = test_random_source();
    const algorithm *a = &contents[random_below(r, contents_count)];
    while (!a->delaunay || n > a->most)
        a = &contents[random_below(r, contents_count)];
    tri_status status = a->triangulate(points, n, NULL, &m);
    CLAIM("def8.P5", status == TRI_OK, "%s: %s", a->name, tri_status_text(status));
    if (m.triangles == 0)
        return m;
    for (uint32_t tries = random_below(r, 4 * n); tries > 0; tries--) {
        halfedge_id e = random_below(r, mesh_halfedges(&m));
        if (!is_flippable(&m, points, e))
            continue;
        flip(&m, e);
        if (!is_locally_delaunay(&m, points, e)) /* four flips restore everything */
            for (int back = 0; back < 3; back++)
                flip(&m, e);
    }
    return m;
}

void
random_diagram(const point2 *points, uint32_t n, mesh *m, voronoi *d)
{
    *m = random_delaunay(points, n);
    CLAIM("sec3.1.P4", voronoi_dual(m, points, d) == TRI_OK, "no diagram");
}

uint32_t
degree(const mesh *m, vertex_id v)
{
    uint32_t found = 0;
    halfedge_id first = mesh_leaving(m, v), e = first;
    do {
        found++;
        e = mesh_around(m, e);
    } while (e != first);
    return found;
}

bool
has_triangle(triangle_list list, const vertex_id *t)
{
    for (uint32_t k = 0; k < list.count; k++)
        for (int i = 0; i < 3; i++)
            if (list.corner[k][i] == t[0] && list.corner[k][(i + 1) % 3] == t[1] &&
                list.corner[k][(i + 2) % 3] == t[2])
                return true;
    return false;
}

/* x if it is a whole number 0 .. most; else a random one. */
static double
whole(double x, uint32_t most)
{
    bool stays = x >= 0 && x <= most && x == (double)(uint32_t)x;
    return stays ? x : random_below(test_random_source(), most + 1);
}

point2 *
whole_points(const point2 *drawn, uint32_t n, uint32_t most)
{
    point2 *points = malloc((n + 1) * sizeof *points);
    CLAIM("fig3.P3", points != NULL, "out of memory");
    for (uint32_t i = 0; i < n; i++) {
        points[i].x = whole(drawn != NULL ? drawn[i].x : -1, most);
        points[i].y = whole(drawn != NULL ? drawn[i].y : -1, most);
    }
    return points;
}
