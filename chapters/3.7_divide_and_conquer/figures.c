/* figures.c - the pictures of section 3.7. The merges that are drawn are those of
 * divide_triangulate, seen by an observer.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"
#include "lib/svg_chart.h"

/* ---- The last merge, step by step. ---- */

/* Draws a panel at the last bridge and one for each flip after it. */
typedef struct merge_painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t n;
    bool last_merge;
    vertex_id l, r; /* the ends of the edge that rises */
} merge_painter;

static void
panel(merge_painter *painter, const char *caption)
{
    svg_box box = svg_box_of(painter->points, painter->n);
    svg_panel(painter->page, box, painter->n, caption);
}

/* The edges but for `left_out`, the points, and the names of l and r. */
static void
draw_mesh(merge_painter *painter, const mesh *m, halfedge_id left_out)
{
    const point2 *p = painter->points;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
        if (a != GHOST && b != GHOST && e < mesh_twin(m, e) && e != left_out)
            svg_segment(painter->page, p[a], p[b], SVG_PLAIN);
    }
    svg_points(painter->page, p, painter->n, SVG_PLAIN);
}

static void
name_ends(merge_painter *painter)
{
    svg_label(painter->page, painter->points[painter->l], "l", SVG_STRONG);
    svg_label(painter->page, painter->points[painter->r], "r", SVG_STRONG);
}

static void
paint_bridge(merge_painter *painter, const mesh *m, const trace_event *event)
{
    const point2 *p = painter->points;
    painter->l = event->a;
    painter->r = event->b;
    panel(painter, "left and right are Delaunay");
    draw_mesh(painter, m, event->edge);
    panel(painter, "Steps 1-2: the lower tangent");
    svg_segment(painter->page, p[event->a], p[event->b], SVG_NEW);
    draw_mesh(painter, m, event->edge);
    name_ends(painter);
}

/* Hull edge ab gives way, and triangle abc with it, as its circle contains the end of
 * lr on the other side. */
static void
paint_gone(merge_painter *painter, const mesh *m, const trace_event *event)
{
    const point2 *p = painter->points;
    point2 a = p[event->a], b = p[event->b], c = p[event->c];
    bool left = event->a == painter->l;
    panel(painter, left ? "Step 3: r drives a triangle out"
                        : "Step 4: l drives a triangle out");
    svg_triangle(painter->page, a, b, c, SVG_BAD);
    svg_circle(painter->page, a, b, c, SVG_FAINT);
    svg_segment(painter->page, p[painter->l], p[painter->r], SVG_STRONG);
    draw_mesh(painter, m, NONE);
    svg_segment(painter->page, a, b, SVG_BAD);
    name_ends(painter);
}

/* Triangle d c a is new, and dc rises. */
static void
paint_new(merge_painter *painter, const mesh *m, const trace_event *event)
{
    const point2 *p = painter->points;
    panel(painter, event->a == painter->l ? "Step 6: the left candidate is first"
                                          : "Step 6: the right candidate is first");
    svg_triangle(painter->page, p[event->d], p[event->c], p[event->a], SVG_NEW);
    svg_circle(painter->page, p[event->d], p[event->c], p[event->a], SVG_FAINT);
    svg_segment(painter->page, p[event->d], p[event->c], SVG_STRONG);
    draw_mesh(painter, m, NONE);
    painter->r = event->d; /* the new edge leads from the right to the left */
    painter->l = event->c;
    name_ends(painter);
}

static int
paint(trace *self, const mesh *m, const trace_event *event)
{
    merge_painter *painter = (merge_painter *)self;
    if (event->kind == TRACE_BRIDGE && m->triangles == 2 * m->locations - 2) {
        painter->last_merge = true;
        paint_bridge(painter, m, event);
    } else if (event->kind == TRACE_FLIP && painter->last_merge) {
        if (event->d == GHOST)
            paint_gone(painter, m, event);
        else
            paint_new(painter, m, event);
    }
    return 0;
}

static void
triangulate_watched(const point2 *points, uint32_t n, trace *observer, mesh *m)
{
    tri_options options = tri_options_default();
    options.trace = observer;
    must(divide_triangulate(points, n, &options, m), "divide_triangulate");
}

/* An observer that counts the flips after the last bridge. */
typedef struct merge_counter {
    trace base;
    bool last_merge;
    uint32_t flips;
} merge_counter;

static int
count(trace *self, const mesh *m, const trace_event *event)
{
    merge_counter *counter = (merge_counter *)self;
    counter->last_merge = counter->last_merge || (event->kind == TRACE_BRIDGE &&
        m->triangles == 2 * m->locations - 2);
    counter->flips += event->kind == TRACE_FLIP && counter->last_merge;
    return 0;
}

/* The last merge of these points; so many panels in a row. */
static void
draw_merge(FILE *file, const point2 *points, uint32_t n, uint32_t columns,
           const char *title, const char *description)
{
    mesh m;
    merge_counter counter = {.base = {count}};
    triangulate_watched(points, n, &counter.base, &m);
    mesh_free(&m);
    uint32_t panels = 2 + counter.flips + 1;
    svg page;
    uint32_t rows = (panels + columns - 1) / columns;
    svg_begin(&page, file, (svg_layout){columns, rows, 230, 230, 1}, title,
              description);
    merge_painter painter = {.base = {paint}, .page = &page, .points = points, .n = n};
    triangulate_watched(points, n, &painter.base, &m);
    panel(&painter, "Step 5: the upper tangent");
    svg_mesh(&page, points, &m);
    svg_points(&page, points, n, SVG_PLAIN);
    name_ends(&painter);
    mesh_free(&m);
    svg_end(&page);
}

static void
draw_steps(FILE *file)
{
    const point2 points[] = {{0.0, 2.0}, {4.0, 4.0}, {0.8, 7.5}, {2.0, 4.7},
                             {2.7, 1.3}, {5.8, 8.8}, {9.2, 5.5}, {7.2, 2.3},
                             {8.5, 3.5}, {8.0, 7.5}};
    draw_merge(
        file, points, 10, 4, "A merge, step by step",
        "Two Delaunay triangulations of five points each, left and right of a "
        "vertical line. An edge rises from their lower to their upper common "
        "tangent. In each panel it drives a triangle of the left or of the right "
        "out, or a new triangle is put on it.");
}

static void
draw_spike(FILE *file)
{
    const point2 points[] = {{0, 0}, {4, 0.5}, {5, 6}, {5.5, -6}, {7, 0.2}};
    draw_merge(file, points, 5, 4, "An edge with the outside on both sides",
               "On the left there are two points and one edge. The rising edge passes "
               "below it, around its end, and above it: new triangles lie on both of "
               "its sides.");
}

/* ---- E52: what a merge has to take away. ---- */

static void
draw_e52(FILE *file)
{
    const point2 points[] = {{-1, 0}, {0, -9}, {0, 9}, {1, 0}, {2, -1}, {2, 1}};
    svg page;
    svg_box box = svg_box_of(points, 6);
    svg_begin(
        &page, file, (svg_layout){2, 1, 280, 300, 2}, "A triangle that has to go",
        "On the left one long triangle, on the right a small one. The circle of the "
        "long triangle contains a point of the right, so it is not there after the "
        "merge.");
    mesh m;
    must(divide_triangulate(points, 6, NULL, &m), "divide_triangulate");
    svg_panel(&page, box, 6, "each side is Delaunay,\nbut not with the other");
    svg_triangle(&page, points[0], points[1], points[2], SVG_BAD);
    svg_circle(&page, points[0], points[1], points[2], SVG_FAINT);
    svg_triangle(&page, points[3], points[4], points[5], SVG_PLAIN);
    svg_points(&page, points, 6, SVG_PLAIN);
    svg_points(&page, &points[3], 1, SVG_BAD);
    svg_panel(&page, box, 6, "merged");
    svg_mesh(&page, points, &m);
    svg_points(&page, points, 6, SVG_PLAIN);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Vertical and alternating cuts. ---- */

enum { CUT_POINTS = 320, CUT_LEVELS = 4 };

/* The Delaunay triangulation of the points L[0 .. count-1] alone. */
static void
draw_part(svg *page, const point2 *points, const vertex_id *L, uint32_t count)
{
    point2 part[CUT_POINTS];
    for (uint32_t i = 0; i < count; i++)
        part[i] = points[L[i]];
    mesh m;
    must(divide_triangulate(part, count, NULL, &m), "divide_triangulate");
    svg_mesh(page, part, &m);
    mesh_free(&m);
}

/* Cuts at the median so many times, with or without turning, and draws the parts.
 * Few levels: the recursion is shallow. */
static void
draw_parts(svg *page, const point2 *points, vertex_id *L, uint32_t count, int levels,
           point2 d, bool turn)
{
    if (levels == 0) {
        draw_part(page, points, L, count);
        return;
    }
    random_source random = random_from_seed(1);
    uint32_t half = count / 2;
    select_along(points, L, count, half, d, &random);
    point2 next = turn ? (point2){-d.y, d.x} : d;
    draw_parts(page, points, L, half, levels - 1, next, turn);
    draw_parts(page, points, L + half, count - half, levels - 1, next, turn);
}

/* An observer that counts all flips. */
static int
count_all(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    ((merge_counter *)self)->flips += event->kind == TRACE_FLIP;
    return 0;
}

static void
draw_cuts(FILE *file)
{
    point2 points[CUT_POINTS];
    random_source random = random_from_seed(37);
    for (int i = 0; i < CUT_POINTS; i++)
        points[i] = random_point(&random);
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 360, 360, 2}, "Vertical and alternating cuts",
        "The same points, divided into sixteen parts by vertical cuts, which are "
        "strips, and by alternating cuts, which are nearly squares. The strips have "
        "more and longer hull edges.");
    for (int turn = 0; turn < 2; turn++) {
        vertex_id L[CUT_POINTS];
        for (vertex_id v = 0; v < CUT_POINTS; v++)
            L[v] = v;
        merge_counter counter = {.base = {count_all}};
        tri_options options = tri_options_default();
        options.trace = &counter.base;
        options.cuts = turn ? TRI_CUTS_ALTERNATING : TRI_CUTS_VERTICAL;
        mesh m;
        must(divide_triangulate(points, CUT_POINTS, &options, &m),
             "divide_triangulate");
        mesh_free(&m);
        char caption[80];
        snprintf(caption, sizeof caption, "%s cuts\n%.1f flips per point in all merges",
                 turn ? "alternating" : "vertical", counter.flips / (double)CUT_POINTS);
        svg_panel(&page, svg_box_of(points, CUT_POINTS), CUT_POINTS, caption);
        const point2 d = {1, 0};
        draw_parts(&page, points, L, CUT_POINTS, CUT_LEVELS, d, turn);
        svg_points(&page, points, CUT_POINTS, SVG_PLAIN);
    }
    svg_end(&page);
}

/* ---- The comparison: curves of a table that `make compare` counts. ---- */

static void
draw_counts(FILE *file, const char *column, const char *title, const char *description,
            const char *caption)
{
    static const char path[] = "chapters/3.7_divide_and_conquer/comparison.csv";
    chart c;
    FILE *table = fopen(path, "r");
    must(table != NULL ? TRI_OK : TRI_CANNOT_READ, path);
    must(chart_read(table, column, true, &c), path);
    fclose(table);
    svg_charts(file, &c, title, description, caption);
    chart_free(&c);
}

static void
draw_compared_orient2d(FILE *file)
{
    draw_counts(file, "orient2d", "Orientation tests, compared",
                "For six distributions, the orientation tests a point that each "
                "algorithm asks, over the number of points.",
                "orientation tests a point");
}

static void
draw_compared_incircle(FILE *file)
{
    draw_counts(file, "incircle", "Incircle tests, compared",
                "For six distributions, the incircle tests a point that each algorithm "
                "asks, over the number of points.", "incircle tests a point");
}

static const figure figures[] = {
    {"merge_steps", draw_steps},
    {"spike", draw_spike},
    {"e52_triangle_goes", draw_e52},
    {"cuts", draw_cuts},
    {"compared_orient2d", draw_compared_orient2d},
    {"compared_incircle", draw_compared_incircle},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures, sizeof figures / sizeof figures[0]);
}
