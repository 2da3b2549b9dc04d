/* figures.c - the pictures of section 2.1. What is said of a list of triangles in a
 * caption is the verdict of the section's own checks.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/figures.h"
#include "lib/svg.h"

static const svg_box square = {{-0.3, -0.3}, {4.3, 4.3}};

/* ---- Figure 1: simplices of dimension 0 to 3. ---- */

static void
draw_simplices(FILE *file)
{
    /* The fourth is seen from the side: a projection of a tetrahedron. */
    const point2 p[4][4] = {
        {{2, 2}},
        {{0.5, 1}, {3.5, 3}},
        {{0.4, 0.6}, {3.6, 0.9}, {1.9, 3.6}},
        {{0.3, 1.2}, {2.4, 0.3}, {3.8, 1.9}, {2, 3.8}},
    };
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 150, 150, 1},
              "Simplices of dimension 0 to 3",
              "A point, a segment, a triangle and a tetrahedron, each with its "
              "vertices and edges.");
    for (uint32_t k = 0; k < 4; k++) {
        simplex s = {(int)k, {0, 1, 2, 3}}, face[16];
        uint32_t faces = simplex_faces(s, face);
        char caption[40];
        snprintf(caption, sizeof caption, "%u-simplex: %u faces", (unsigned)k,
                 (unsigned)faces);
        svg_panel(&page, square, 4, caption);
        if (k == 2)
            svg_triangle(&page, p[k][0], p[k][1], p[k][2], SVG_PLAIN);
        for (uint32_t i = 0; i < faces; i++) {
            const vertex_id *v = face[i].vertex;
            bool behind = k == 3 && v[0] == 0 && v[1] == 2;
            if (face[i].dimension == 1)
                svg_segment(&page, p[k][v[0]], p[k][v[1]],
                            behind ? SVG_FAINT : SVG_STRONG);
        }
        svg_points(&page, p[k], k + 1, SVG_STRONG);
    }
    svg_end(&page);
}

/* ---- Triangulations, and lists that are none. ---- */

/* One panel: the list, and what the check says of it. */
static void
draw_checked(svg *page, const point2 *points, uint32_t n, triangle_list list,
             const char *name)
{
    verdict v;
    char caption[120];
    must(is_triangulation(points, n, list, &v), "is_triangulation");
    snprintf(caption, sizeof caption, "%s\n%s", name,
             v.holds ? "a triangulation" : "refuted");
    svg_panel(page, square, n, caption);
    if (v.holds)
        svg_triangulation(page, points, n, list);
    else
        svg_verdict(page, points, n, list, &v);
}

static void
draw_complexes(FILE *file)
{
    const point2 p[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1.6}, {2, 0}};
    vertex_id crossing[][3] = {{0, 1, 2}, {0, 1, 3}};
    vertex_id on_edge[][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    vertex_id bay[][3] = {{1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 190, 190, 2},
              "Three lists of triangles that are no triangulation, and one that is",
              "Overlapping triangles; a point in the middle of an edge; a bay in "
              "the boundary; a triangulation of six points.");
    draw_checked(&page, p, 4, (triangle_list){2, crossing}, "triangles overlap");
    draw_checked(&page, p, 6, (triangle_list){4, on_edge}, "5 lies on an edge");
    draw_checked(&page, p, 5, (triangle_list){3, bay}, "the hull is not filled");
    mesh m;
    triangle_list list;
    must(sweep_triangulate(p, 6, NULL, &m), "sweep_triangulate");
    must(mesh_triangles(&m, &list), "mesh_triangles");
    draw_checked(&page, p, 6, list, "T fills the convex hull of V");
    triangle_list_free(&list);
    mesh_free(&m);
    svg_end(&page);
}

int
main(int argc, char **argv)
{
    const figure figures[] = {
        {"simplices", draw_simplices},
        {"complexes", draw_complexes},
    };
    return draw_figures(argc, argv, figures, sizeof figures / sizeof *figures);
}
