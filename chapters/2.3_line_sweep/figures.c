/* figures.c - the pictures of section 2.3. What is drawn is what the code does:
 * the sweep runs under an observer, or is made step by step with its own verbs.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"

#include <stdlib.h>

/* ---- Pieces of pictures. ---- */

/* A vertical line through p, from the bottom of the box to its top. */
static void
draw_sweep_line(svg *page, svg_box box, point2 p)
{
    double beyond = (box.max.y - box.min.y) / 8;
    svg_segment(page, (point2){p.x, box.min.y - beyond},
                (point2){p.x, box.max.y + beyond}, SVG_FAINT);
}

/* The points, named v1, v2, ... in the order of L. */
static void
label_in_order(svg *page, const point2 *points, const vertex_id *L,
               uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        char name[16];
        snprintf(name, sizeof name, "v%u", (unsigned)i + 1);
        svg_label(page, points[L[i]], name, SVG_STRONG);
    }
}

/* The edges of a chain, marked, and lines of sight from p to its vertices. */
static void
draw_seen(svg *page, const point2 *points, const mesh *m, hull_chain q,
          point2 p)
{
    if (q.first == q.end)
        return;
    for (halfedge_id e = q.first; e != q.end; e = mesh_hull_next(m, e)) {
        svg_segment(page, points[mesh_origin(m, e)], points[mesh_dest(m, e)],
                    SVG_MARK);
        svg_segment(page, p, points[mesh_origin(m, e)], SVG_FAINT);
    }
    svg_segment(page, p, points[mesh_origin(m, q.end)], SVG_FAINT);
}

/* Runs once around p, which has just been attached: its triangles are new, and
 * the edges opposite p are those it has seen. */
static void
draw_new_triangles(svg *page, const point2 *points, const mesh *m,
                   halfedge_id leaving)
{
    halfedge_id e = leaving;
    do {
        if (mesh_in_triangle(m, e)) {
            point2 p = points[mesh_origin(m, e)];
            point2 a = points[mesh_dest(m, e)], b = points[mesh_apex(m, e)];
            svg_triangle(page, p, a, b, SVG_NEW);
            svg_segment(page, a, b, SVG_MARK);
        }
        e = mesh_around(m, e);
    } while (e != leaving);
}

/* Sweeps the first `count` points, which are in order; returns the hull edge
 * that leaves the last of them. There is room for all n. */
static halfedge_id
sweep_some(mesh *m, const point2 *points, uint32_t n, uint32_t count)
{
    must(mesh_init(m, n, n), "mesh_init");
    halfedge_id last = mesh_hull_next(m, mesh_start(m, 0, 1));
    for (vertex_id v = 2; v < count; v++)
        last = attach(m, hull_edges_seeing(m, points, last, v), v);
    return last;
}

/* ---- Figure 3, executed. ---- */

enum { STEPS_POINTS = 9 };

static const point2 steps_points[STEPS_POINTS] = {
    {6.4, 3.2}, {0.2, 2.0}, {4.4, 4.6}, {2.2, 4.0}, {1.2, 0.4},
    {5.2, 0.3}, {3.2, 1.6}, {8.6, 2.6}, {5.9, 1.6}};

/* An observer that draws a panel for each point that has been attached. */
typedef struct step_painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t n;
    const vertex_id *L;
    uint32_t swept;
} step_painter;

static int
paint_step(trace *self, const mesh *m, const trace_event *event)
{
    step_painter *painter = (step_painter *)self;
    svg *page = painter->page;
    const point2 *points = painter->points;
    if (event->kind != TRACE_ATTACH)
        return 0;

    uint32_t seen = 0;
    halfedge_id e = event->edge;
    do {
        seen += mesh_in_triangle(m, e);
        e = mesh_around(m, e);
    } while (e != event->edge);
    uint32_t i = ++painter->swept;
    char caption[64];
    snprintf(caption, sizeof caption, "i = %u: v%u sees %u edge%s", (unsigned)i,
             (unsigned)i, (unsigned)seen, seen == 1 ? "" : "s");

    svg_box box = svg_box_of(points, painter->n);
    svg_panel(page, box, painter->n, caption);
    draw_sweep_line(page, box, points[event->a]);
    draw_new_triangles(page, points, m, event->edge);
    svg_mesh(page, points, m);
    for (uint32_t k = 0; k < painter->n; k++)
        svg_points(page, &points[painter->L[k]], 1,
                   k < i ? SVG_PLAIN : SVG_FAINT);
    svg_points(page, &points[event->a], 1, SVG_NEW);
    char name[16];
    snprintf(name, sizeof name, "v%u", (unsigned)i);
    svg_label(page, points[event->a], name, SVG_NEW);
    return 0;
}

static void
draw_steps(FILE *file)
{
    const point2 *points = steps_points;
    vertex_id L[STEPS_POINTS];
    uint32_t u;
    must(sort_along(points, STEPS_POINTS, (point2){1, 0}, L, &u), "sort_along");

    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 3, 250, 160, 1}, "Figure 3, executed",
        "A vertical line sweeps over nine points. In each panel the line has "
        "reached one more point. The hull edges that this point sees are "
        "marked, and the new triangles over them are hatched.");

    svg_box box = svg_box_of(points, STEPS_POINTS);
    svg_panel(&page, box, STEPS_POINTS, "Lines 1-2: the order, and v1 v2");
    mesh first;
    must(mesh_init(&first, STEPS_POINTS, u), "mesh_init");
    mesh_start(&first, L[0], L[1]);
    draw_sweep_line(&page, box, points[L[1]]);
    svg_mesh(&page, points, &first);
    mesh_free(&first);
    svg_points(&page, points, STEPS_POINTS, SVG_PLAIN);
    label_in_order(&page, points, L, u);

    step_painter painter = {{paint_step}, &page, points, STEPS_POINTS, L, 2};
    tri_options options = tri_options_default();
    options.trace = &painter.base;
    mesh m;
    must(sweep_triangulate(points, STEPS_POINTS, &options, &m),
         "sweep_triangulate");

    triangle_list list;
    must(mesh_triangles(&m, &list), "mesh_triangles");
    char caption[80];
    snprintf(caption, sizeof caption, "Line 6: %u triangles, %u hull edges",
             (unsigned)list.count, (unsigned)mesh_hull_size(&m));
    svg_panel(&page, box, STEPS_POINTS, caption);
    svg_mesh(&page, points, &m);
    svg_points(&page, points, STEPS_POINTS, SVG_PLAIN);
    svg_end(&page);
    triangle_list_free(&list);
    mesh_free(&m);
}

/* ---- Before and after one point. ---- */

/* What p sees of *m, and nothing attached yet. */
static void
draw_before(svg *page, const point2 *points, uint32_t n, const mesh *m,
            hull_chain q, vertex_id p)
{
    draw_seen(page, points, m, q, points[p]);
    svg_mesh(page, points, m);
    svg_points(page, points, n, SVG_PLAIN);
    svg_points(page, &points[p], 1, SVG_NEW);
}

/* What `leaving` leaves has just been attached. */
static void
draw_after(svg *page, const point2 *points, uint32_t n, const mesh *m,
           halfedge_id leaving)
{
    draw_new_triangles(page, points, m, leaving);
    svg_mesh(page, points, m);
    svg_points(page, points, n, SVG_PLAIN);
    svg_points(page, &points[mesh_origin(m, leaving)], 1, SVG_NEW);
}

static const vertex_id as_given[] = {0, 1, 2, 3, 4, 5, 6, 7};

/* ---- The chain on both sides of the last vertex (E13). ---- */

static void
draw_both_sides(FILE *file)
{
    point2 points[] = {{0, 0}, {1, 1}, {2, 0}, {3, -5}};
    const point2 fourth[] = {{3, -5}, {3, 3}, {4, -1}};
    const char *const caption[] = {
        "v4 sees the edge that\nends at v3",
        "v4 sees the edge that\nbegins at v3",
        "v4 sees the edges on\nboth sides of v3"};
    svg_box box = {{0, -5}, {4, 3}};
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 185, 300, 2},
              "The edges that are seen touch the last vertex, on either side",
              "From a triangle v1 v2 v3, three places of the next point: "
              "below it, where it sees the hull edge that ends at the last "
              "vertex v3; above it, where it sees the one that begins there; "
              "and beside it, where it sees both. Who looks one way only "
              "finds nothing in the first case.");
    mesh m;
    halfedge_id last;
    for (int i = 0; i < 3; i++) {
        points[3] = fourth[i];
        last = sweep_some(&m, points, 4, 3);
        svg_panel(&page, box, 4, caption[i]);
        hull_chain q = hull_edges_seeing(&m, points, last, 3);
        draw_before(&page, points, 4, &m, q, 3);
        label_in_order(&page, points, as_given, 4);
        mesh_free(&m);
    }
    points[3] = fourth[0];
    last = sweep_some(&m, points, 4, 3);
    hull_chain forward = {last, hull_edges_seeing(&m, points, last, 3).end};
    halfedge_id leaving = attach(&m, forward, 3);
    svg_panel(&page, box, 4,
              "the first again, looking\nforward only: no triangle");
    draw_after(&page, points, 4, &m, leaving);
    label_in_order(&page, points, as_given, 4);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Ties (E12). ---- */

static void
draw_ties(FILE *file)
{
    const point2 points[] = {{0, 0}, {1, 0}, {1, 2}, {1, 1}};
    svg_box box = svg_box_of(points, 4);
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 220, 240, 2},
        "Points that are met at the same moment",
        "Three of four points lie on one vertical line. If the one in the "
        "middle comes last it lies on a hull edge and sees nothing. In "
        "lexicographic order the topmost comes last, and sees an edge.");
    mesh m;
    halfedge_id last = sweep_some(&m, points, 4, 3);
    svg_panel(&page, box, 4,
              "sorted along x only: v4 lies\non an edge and sees nothing");
    draw_sweep_line(&page, box, points[3]);
    hull_chain nothing = hull_edges_seeing(&m, points, last, 3);
    draw_before(&page, points, 4, &m, nothing, 3);
    label_in_order(&page, points, as_given, 4);
    mesh_free(&m);

    vertex_id L[4];
    uint32_t u;
    must(sort_along(points, 4, (point2){1, 0}, L, &u), "sort_along");
    point2 sorted[4];
    for (uint32_t i = 0; i < u; i++)
        sorted[i] = points[L[i]];
    last = sweep_some(&m, sorted, 4, 3);
    hull_chain q = hull_edges_seeing(&m, sorted, last, 3);
    svg_panel(&page, box, 4, "ties broken along the line:\nv4 sees an edge");
    draw_sweep_line(&page, box, sorted[3]);
    draw_before(&page, sorted, 4, &m, q, 3);
    label_in_order(&page, sorted, as_given, 4);

    svg_panel(&page, box, 4, "and gets its triangle");
    draw_after(&page, sorted, 4, &m, attach(&m, q, 3));
    label_in_order(&page, sorted, as_given, 4);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- A collinear beginning (E11). ---- */

static void
draw_collinear_start(FILE *file)
{
    const point2 points[] = {{0, 0}, {0, 1}, {0, 2}, {1, 0}};
    const char *const caption[] = {"Line 2: the edge v1 v2",
                                   "v3 sees nothing: it\nhangs on v2",
                                   "v4 sees both edges of\nthe path: a fan"};
    svg_box box = svg_box_of(points, 4);
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 190, 240, 2}, "A collinear beginning",
        "Three points on a vertical line and one to the right of it. The "
        "first three make a path of two edges; the last sees both and makes "
        "two triangles.");
    mesh m;
    halfedge_id last = sweep_some(&m, points, 4, 2);
    for (vertex_id v = 1; v < 4; v++) {
        svg_panel(&page, box, 4, caption[v - 1]);
        if (v > 1)
            last = attach(&m, hull_edges_seeing(&m, points, last, v), v);
        draw_after(&page, points, v + 1, &m, last);
        label_in_order(&page, points, as_given, v + 1);
    }
    svg_end(&page);
    mesh_free(&m);
}

/* ---- One point that sees nearly everything (E10). ---- */

enum { PARABOLA = 7 };

static void
draw_worst_case(FILE *file)
{
    /* Drawn at 1/8 of the height: that changes no orientation. */
    point2 points[PARABOLA + 1];
    for (int i = 0; i < PARABOLA; i++)
        points[i] = (point2){i, i * i / 8.0};
    points[PARABOLA] = (point2){PARABOLA, 0};

    svg_box box = svg_box_of(points, PARABOLA + 1);
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 350, 250, 1},
              "One point can see all but one of the hull edges",
              "Seven points on a parabola, and one to the right of its "
              "lowest point: it sees the six hull edges that the parabola's "
              "arc consists of.");
    mesh m;
    halfedge_id last = sweep_some(&m, points, PARABOLA + 1, PARABOLA);
    hull_chain q = hull_edges_seeing(&m, points, last, PARABOLA);
    uint32_t seen = 0;
    for (halfedge_id e = q.first; e != q.end; e = mesh_hull_next(&m, e))
        seen++;
    char caption[80];
    snprintf(caption, sizeof caption,
             "%d points on a parabola: v%d sees %u edges", PARABOLA,
             PARABOLA + 1, (unsigned)seen);
    svg_panel(&page, box, PARABOLA + 1, caption);
    draw_before(&page, points, PARABOLA + 1, &m, q, PARABOLA);
    label_in_order(&page, points, as_given, PARABOLA + 1);

    svg_panel(&page, box, PARABOLA + 1, "and makes as many triangles");
    draw_after(&page, points, PARABOLA + 1, &m, attach(&m, q, PARABOLA));
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Two hundred points. ---- */

enum { MANY = 200 };

static void
draw_many(FILE *file)
{
    point2 points[MANY];
    random_source source = random_from_seed(23);
    for (int i = 0; i < MANY; i++)
        points[i] = random_point(&source);
    mesh m;
    must(sweep_triangulate(points, MANY, NULL, &m), "sweep_triangulate");

    svg page;
    svg_begin(&page, file, (svg_layout){1, 1, 640, 560, 0},
              "The sweep triangulation of two hundred random points",
              "Most triangles are long and thin, and stand upright: across "
              "the direction in which the line moves.");
    svg_panel(&page, svg_box_of(points, MANY), MANY, "");
    svg_mesh(&page, points, &m);
    svg_points(&page, points, MANY, SVG_PLAIN);
    svg_end(&page);
    mesh_free(&m);
}

static const figure figures[] = {
    {"fig3_steps", draw_steps},
    {"both_sides", draw_both_sides},
    {"ties", draw_ties},
    {"collinear_start", draw_collinear_start},
    {"worst_case", draw_worst_case},
    {"sweep_200", draw_many},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
