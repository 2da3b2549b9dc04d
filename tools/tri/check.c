/* check.c - tri check, hull and draw: what is said of points and triangles. */
#include "tools/tri/tri.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "lib/svg.h"

/* ---- tri check. ---- */

static void
print_refuted(const text_points *points, const verdict *v)
{
    printf("refuted: %s\n", v->because);
    for (int i = 0; i < v->witnesses; i++) {
        vertex_id w = v->witness[i];
        printf("witness: point %lu", (unsigned long)w);
        if (points->first != 0)
            printf(" (%lu in the file)", (unsigned long)points->first + w);
        printf(" at %.17g %.17g\n", points->points[w].x, points->points[w].y);
    }
}

int
command_check(int argc, char **argv)
{
    bool delaunay = take_flag(&argc, argv, "--delaunay");
    expect_words(argc, argv, 2, 2);
    text_points points = load_points(argv[1]);
    triangle_list list = load_triangles(argv[2], &points);

    verdict v;
    tell_progress("checking %lu triangles", (unsigned long)list.count);
    must(delaunay ? is_delaunay(points.points, points.count, list, &v)
                  : is_triangulation(points.points, points.count, list, &v));
    if (v.holds)
        printf("holds: %lu triangles are a %striangulation of %lu points\n",
               (unsigned long)list.count, delaunay ? "Delaunay " : "",
               (unsigned long)points.count);
    else
        print_refuted(&points, &v);
    triangle_list_free(&list);
    text_points_free(&points);
    return v.holds ? EXIT_HOLDS : EXIT_REFUTED;
}

/* ---- tri hull. ---- */

/* The edges between consecutive hull vertices; between the last and the first,
 * too, unless all points lie on one line. */
static edge_list
hull_edges(const mesh *m, uint32_t *triangles)
{
    triangle_list list;
    vertex_id *hull = memory_array(m->locations, sizeof *hull);
    edge_list edges = {0, memory_array(m->locations, sizeof *edges.ends)};
    if (hull == NULL || edges.ends == NULL)
        must(TRI_OUT_OF_MEMORY);
    must(mesh_triangles(m, &list));
    uint32_t size = hull_vertices(m, hull);
    bool closed = list.count > 0;
    for (uint32_t i = 0; i < size; i++) {
        if (i + 1 == size && !closed)
            break;
        vertex_id *ends = edges.ends[edges.count++];
        ends[0] = hull[i];
        ends[1] = hull[(i + 1) % size];
    }
    *triangles = list.count;
    triangle_list_free(&list);
    memory_free(hull);
    return edges;
}

int
command_hull(int argc, char **argv)
{
    const char *path = take_option(&argc, argv, "-o");
    expect_words(argc, argv, 1, 1);
    if (path == NULL)
        path = "-";
    check_output(path);
    text_points points = load_points(argv[1]);

    mesh m;
    uint32_t triangles;
    must(sweep_triangulate(points.points, points.count, NULL, &m));
    edge_list edges = hull_edges(&m, &triangles);
    note_degenerate(points.count, m.locations, triangles);
    output o = begin_output(path);
    text_write_edges(o.file, edges, points.first);
    finish_output(&o, path);

    edge_list_free(&edges);
    mesh_free(&m);
    text_points_free(&points);
    return EXIT_HOLDS;
}

/* ---- tri draw. ---- */

void
write_picture(const char *path, const char *title,
              const text_points *points, triangle_list list)
{
    svg page;
    char description[120];
    svg_box box = svg_box_of(points->points, points->count);
    snprintf(description, sizeof description, "%lu points and %lu triangles.",
             (unsigned long)points->count, (unsigned long)list.count);
    output o = begin_output(path);
    svg_begin(&page, o.file, svg_one_panel(box), title, description);
    svg_panel(&page, box, points->count, description);
    svg_triangulation(&page, points->points, points->count, list);
    svg_end(&page);
    finish_output(&o, path);
}

int
command_draw(int argc, char **argv)
{
    const char *path = take_option(&argc, argv, "-o");
    expect_words(argc, argv, 1, 2);
    if (path == NULL)
        path = "-";
    check_output(path);
    text_points points = load_points(argv[1]);
    triangle_list list = {0};
    if (argc == 3)
        list = load_triangles(argv[2], &points);
    write_picture(path, argv[1], &points, list);
    triangle_list_free(&list);
    text_points_free(&points);
    return EXIT_HOLDS;
}
