/* voronoi.c - tri voronoi. */
#include "tools/tri/tri.h"

#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "lib/decimal.h"
#include "lib/memory.h"
#include "lib/svg.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- Files that appear all together. ---- */

enum { VERTICES, EDGES, TRIANGLES, SIDES, PICTURE, FILES };

typedef struct files {
    char *path[FILES]; /* NULL: not wanted */
    output output[FILES];
} files;

/* One more file is wanted, with the two together as its name. */
static void
want_file(files *f, int which, const char *name, const char *ending)
{
    size_t room = strlen(name) + strlen(ending) + 1;
    f->path[which] = memory_array(room, 1);
    if (f->path[which] == NULL)
        must(TRI_OUT_OF_MEMORY);
    snprintf(f->path[which], room, "%s%s", name, ending);
    check_output(f->path[which]);
}

/* Begins all files that are wanted. */
static void
begin_files(files *f)
{
    for (int i = 0; i < FILES; i++)
        if (f->path[i] != NULL)
            f->output[i] = begin_output(f->path[i]);
}

/* Writes what is left of every file, and only then renames any. */
static void
finish_files(files *f)
{
    for (int i = 0; i < FILES; i++)
        if (f->path[i] != NULL)
            flush_output(&f->output[i], f->path[i]);
    for (int i = 0; i < FILES; i++) {
        if (f->path[i] != NULL)
            finish_output(&f->output[i], f->path[i]);
        memory_free(f->path[i]);
    }
}

/* ---- The diagram as text. ---- */

static void
put_number(FILE *file, double x)
{
    char text[DECIMAL_ROOM];
    decimal_write(text, x);
    fprintf(file, " %s", text);
}

static void
put_point(FILE *file, point2 p)
{
    put_number(file, p.x);
    put_number(file, p.y);
}

/* Triangle's .v.edge: an edge has two vertices; a ray one, -1, and the
 * direction in which it leaves. A line, which Triangle does not have: -1 twice,
 * a point of it and its direction. */
static void
write_edges(FILE *file, const voronoi *d, const point2 *points, uint32_t first)
{
    fprintf(file, "%lu 0\n", (unsigned long)d->edges);
    for (uint32_t k = 0; k < d->edges; k++) {
        voronoi_edge e = d->edge[k];
        fprintf(file, "%lu", (unsigned long)first + k);
        if (e.from != NONE)
            fprintf(file, " %lu", (unsigned long)first + e.from);
        else
            fprintf(file, " -1");
        if (e.to != NONE) {
            fprintf(file, " %lu", (unsigned long)first + e.to);
        } else {
            fprintf(file, " -1");
            if (e.from == NONE)
                put_point(file, voronoi_midpoint(d, points, k));
            put_point(file, voronoi_direction(d, points, k));
        }
        fprintf(file, "\n");
    }
}

/* The pairs of sites beside the edges: the edges of the triangulation. */
static edge_list
dual_edges(const voronoi *d)
{
    edge_list list = {d->edges, memory_array(d->edges, sizeof *list.ends)};
    if (list.ends == NULL)
        must(TRI_OUT_OF_MEMORY);
    for (uint32_t k = 0; k < d->edges; k++) {
        list.ends[k][0] = d->edge[k].left;
        list.ends[k][1] = d->edge[k].right;
    }
    return list;
}

/* ---- The diagram as a picture. ---- */

/* The box of the sites and a fifth more on each side. */
static svg_box
picture_box(const text_points *in)
{
    svg_box box = svg_box_of(in->points, in->count);
    double more =
        fmax(box.max.x / 5 - box.min.x / 5, box.max.y / 5 - box.min.y / 5);
    if (more == 0)
        more = fmax(1, fmax(fabs(box.min.x), fabs(box.min.y))) / 5;
    box.min.x = fmax(box.min.x - more, -DBL_MAX);
    box.min.y = fmax(box.min.y - more, -DBL_MAX);
    box.max.x = fmin(box.max.x + more, DBL_MAX);
    box.max.y = fmin(box.max.y + more, DBL_MAX);
    return box;
}

static void
write_diagram(FILE *file, const voronoi *d, const text_points *in,
              const point2 *at)
{
    svg page;
    char caption[120];
    svg_box box = picture_box(in);
    snprintf(caption, sizeof caption, "%lu cells, %lu vertices, %lu edges.",
             (unsigned long)d->cells, (unsigned long)d->vertices,
             (unsigned long)d->edges);
    svg_begin(&page, file, svg_one_panel(box), "Voronoi diagram", caption);
    svg_panel(&page, box, in->count, caption);
    for (uint32_t k = 0; k < d->edges; k++) {
        point2 segment[2];
        if (voronoi_edge_in_box(d, in->points, at, k, box.min, box.max,
                                segment))
            svg_segment(&page, segment[0], segment[1], SVG_PLAIN);
    }
    svg_points(&page, in->points, in->count, SVG_STRONG);
    if (in->count <= 50)
        svg_label_points(&page, in->points, in->count);
    svg_end(&page);
}

/* ---- The command. ---- */

/* What was asked for. */
typedef struct request {
    files files;
    bool per_triangle;
    const char *points;
} request;

static request
parse(int argc, char **argv)
{
    request r = {0};
    const char *name = take_option(&argc, argv, "-o");
    const char *picture = take_option(&argc, argv, "--svg");
    r.per_triangle = take_flag(&argc, argv, "--per-triangle");
    expect_words(argc, argv, 1, 1);
    r.points = argv[1];
    if (name == NULL && picture == NULL)
        die_usage(argv[0],
                  "-o or --svg is needed: there are several files to write");
    if (name != NULL && strcmp(name, "-") == 0)
        die_usage(argv[0], "-o needs a name: there are several files to write");
    if (name == NULL && r.per_triangle)
        die_usage(argv[0],
                  "--per-triangle says what -o writes, and is without -o");
    if (name != NULL) {
        want_file(&r.files, VERTICES, name, ".v.node");
        want_file(&r.files, EDGES, name, ".v.edge");
    }
    if (r.per_triangle) {
        want_file(&r.files, TRIANGLES, name, ".ele");
        want_file(&r.files, SIDES, name, ".edge");
    }
    if (picture != NULL)
        want_file(&r.files, PICTURE, picture, "");
    return r;
}

/* The coordinates of the vertices. */
static point2 *
place_vertices(const voronoi *d, const point2 *points)
{
    point2 *at = memory_array(d->vertices, sizeof *at);
    if (at == NULL)
        must(TRI_OUT_OF_MEMORY);
    must(voronoi_vertices(d, points, at));
    return at;
}

int
command_voronoi(int argc, char **argv)
{
    request r = parse(argc, argv);
    text_points in = load_points(r.points);
    mesh m;
    voronoi d;
    triangle_list list;
    must(default_algorithm()->triangulate(in.points, in.count, NULL, &m));
    must(r.per_triangle ? voronoi_per_triangle(&m, &d)
                        : voronoi_dual(&m, in.points, &d));
    must(mesh_triangles(&m, &list));
    edge_list sides = dual_edges(&d);
    point2 *at = place_vertices(&d, in.points);
    note_degenerate(in.count, m.locations, list.count);

    begin_files(&r.files);
    if (r.files.path[VERTICES] != NULL) {
        text_write_points(r.files.output[VERTICES].file, at, d.vertices,
                          in.first);
        write_edges(r.files.output[EDGES].file, &d, in.points, in.first);
    }
    if (r.per_triangle) {
        text_write_triangles(r.files.output[TRIANGLES].file, list, in.first);
        text_write_edges(r.files.output[SIDES].file, sides, in.first);
    }
    if (r.files.path[PICTURE] != NULL)
        write_diagram(r.files.output[PICTURE].file, &d, &in, at);
    finish_files(&r.files);

    memory_free(at);
    edge_list_free(&sides);
    triangle_list_free(&list);
    voronoi_free(&d);
    mesh_free(&m);
    text_points_free(&in);
    return EXIT_HOLDS;
}
