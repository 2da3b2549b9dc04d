/* figures.c - the pictures of section 3.5. What is drawn is what the code does:
 * Figure 10 runs under an observer, and captions say what the tests answered.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flip_picture.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"

#include <math.h>

/* ---- Pieces of pictures. ---- */

/* The half-edge from a to b. Requires: there is one. */
static halfedge_id
find_edge(const mesh *m, vertex_id a, vertex_id b)
{
    halfedge_id e = mesh_leaving(m, a);
    while (mesh_dest(m, e) != b)
        e = mesh_around(m, e);
    return e;
}

/* The four corners around an edge ab: a, b, the apex c of ab and the apex d of
 * ba. */
typedef struct quadrilateral {
    point2 a, b, c, d;
} quadrilateral;

static quadrilateral
around(const mesh *m, const point2 *points, halfedge_id ab)
{
    return (quadrilateral){points[mesh_origin(m, ab)], points[mesh_dest(m, ab)],
                           points[mesh_apex(m, ab)],
                           points[mesh_apex(m, mesh_twin(m, ab))]};
}

static void
label_abcd(svg *page, quadrilateral q)
{
    svg_label(page, q.a, "a", SVG_STRONG);
    svg_label(page, q.b, "b", SVG_STRONG);
    svg_label(page, q.c, "c", SVG_STRONG);
    svg_label(page, q.d, "d", SVG_STRONG);
}

/* The quadrilateral of Figures 9 and 11: a below b, c to the left and d to the
 * right, so that a sweep makes the edge ab. */
enum { C, A, B, D };
static const point2 d_inside[4] = {{0.4, 1.6}, {2, 0}, {2, 4}, {3.9, 1.2}};
static const point2 d_outside[4] = {{0.4, 1.6}, {2, 0}, {2, 4}, {5.6, 2.2}};

/* ---- Figure 9: locally Delaunay, and not. ---- */

static void
draw_definition(FILE *file)
{
    const point2 *const sites[] = {d_outside, d_inside};
    svg_box box = {{0.2, -0.2}, {5.7, 4.2}};
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 330, 270, 1},
              "Definition 9: locally Delaunay, and not",
              "Two triangles abc and abd share the edge ab. On the left d "
              "lies outside the circle through a, b and c; on the right it "
              "lies inside.");
    for (int i = 0; i < 2; i++) {
        const point2 *points = sites[i];
        mesh m;
        must(sweep_triangulate(points, 4, NULL, &m), "sweep_triangulate");
        halfedge_id ab = find_edge(&m, A, B);
        bool good = is_locally_delaunay(&m, points, ab);
        quadrilateral q = around(&m, points, ab);
        svg_panel(&page, box, 8,
                  good ? "ab is locally Delaunay: d is not inside"
                       : "ab is not locally Delaunay: d is inside");
        svg_circle(&page, q.a, q.b, q.c, good ? SVG_GOOD : SVG_BAD);
        svg_mesh(&page, points, &m);
        svg_segment(&page, q.a, q.b, good ? SVG_GOOD : SVG_BAD);
        svg_points(&page, points, 4, SVG_PLAIN);
        svg_points(&page, &q.d, 1, good ? SVG_NEW : SVG_BAD);
        label_abcd(&page, q);
        mesh_free(&m);
    }
    svg_end(&page);
}

/* ---- The flip, half-edge by half-edge. ---- */

static void
draw_halfedges(svg *page, const point2 *points, const mesh *m, halfedge_id e,
               svg_style style)
{
    const char letter[] = {[A] = 'a', [B] = 'b', [C] = 'c', [D] = 'd'};
    for (int i = 0; i < 3; i++, e = mesh_next(e)) {
        char name[32];
        vertex_id from = mesh_origin(m, e), to = mesh_dest(m, e);
        snprintf(name, sizeof name, "%u: %c%c", (unsigned)e, letter[from],
                 letter[to]);
        svg_halfedge(page, points[from], points[to], name, style);
    }
}

static void
draw_flip(FILE *file)
{
    const point2 points[4] = {{0, 2}, {1.6, 0}, {2.4, 4}, {4, 2}};
    svg_box box = svg_box_of(points, 4);
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 350, 350, 1}, "The flip",
        "The two triangles of a quadrilateral before and after a flip. Each "
        "half-edge keeps its number and turns one place counterclockwise: "
        "the one from a to b then leads from d to c.");
    mesh m;
    must(sweep_triangulate(points, 4, NULL, &m), "sweep_triangulate");
    halfedge_id ab = find_edge(&m, A, B), ba = mesh_twin(&m, ab);
    for (int i = 0; i < 2; i++) {
        svg_panel(&page, box, 4,
                  i == 0 ? "before: triangles abc and bad"
                         : "after: triangles dca and cdb");
        triangle_list list;
        must(mesh_triangles(&m, &list), "mesh_triangles");
        svg_triangles(&page, points, list, SVG_PLAIN);
        triangle_list_free(&list);
        svg_points(&page, points, 4, SVG_PLAIN);
        draw_halfedges(&page, points, &m, ab, SVG_NEW);
        draw_halfedges(&page, points, &m, ba, SVG_GOOD);
        svg_label(&page, points[A], "a", SVG_STRONG);
        svg_label(&page, points[B], "b", SVG_STRONG);
        svg_label(&page, points[C], "c", SVG_STRONG);
        svg_label(&page, points[D], "d", SVG_STRONG);
        if (i == 0)
            flip(&m, ab);
    }
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Figure 11: six angles. ---- */

/* In degrees, for people: the smallest angle of the triangles in the list. */
static double
smallest_angle(const point2 *points, const mesh *m)
{
    double smallest = 180;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (!mesh_in_triangle(m, e))
            continue;
        point2 o = points[mesh_origin(m, e)];
        point2 p = points[mesh_dest(m, e)], q = points[mesh_apex(m, e)];
        double px = p.x - o.x, py = p.y - o.y, qx = q.x - o.x, qy = q.y - o.y;
        double angle = atan2(px * qy - py * qx, px * qx + py * qy);
        smallest = fmin(smallest, angle * 57.29577951308232);
    }
    return smallest;
}

static void
draw_angles(FILE *file)
{
    const point2 *p = d_inside;
    point2 a = p[A], b = p[B], c = p[C], d = p[D];
    svg_box box = svg_box_of(p, 4);
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 370, 370, 2},
        "Figure 11: a flip changes six angles",
        "Before the flip of ab the angles of the two triangles are alpha 1, "
        "beta 1, gamma 1 + gamma 2 and alpha 2, beta 2, delta 1 + delta 2; "
        "afterwards they are gamma 1, delta 1, beta 1 + beta 2 and gamma 2, "
        "delta 2, alpha 1 + alpha 2.");
    mesh m;
    must(sweep_triangulate(p, 4, NULL, &m), "sweep_triangulate");
    for (int i = 0; i < 2; i++) {
        char caption[120];
        snprintf(caption, sizeof caption, "%s\nthe smallest has %.0f degrees",
                 i == 0 ? "six old angles:" : "six new angles:",
                 smallest_angle(p, &m));
        svg_panel(&page, box, 4, caption);
        svg_mesh(&page, p, &m);
        svg_points(&page, p, 4, SVG_PLAIN);
        if (i == 0) {
            svg_angle(&page, a, b, c, "\316\2611", SVG_NEW);
            svg_angle(&page, b, c, a, "\316\2621", SVG_NEW);
            svg_angle(&page, c, a, b, "\316\2631+\316\2632", SVG_NEW);
            svg_angle(&page, a, d, b, "\316\2612", SVG_GOOD);
            svg_angle(&page, b, a, d, "\316\2622", SVG_GOOD);
            svg_angle(&page, d, b, a, "\316\2641+\316\2642", SVG_GOOD);
            flip(&m, find_edge(&m, A, B));
        } else {
            svg_angle(&page, c, d, b, "\316\2631", SVG_NEW);
            svg_angle(&page, d, b, c, "\316\2641", SVG_NEW);
            svg_angle(&page, b, c, d, "\316\2621+\316\2622", SVG_NEW);
            svg_angle(&page, c, a, d, "\316\2632", SVG_GOOD);
            svg_angle(&page, d, c, a, "\316\2642", SVG_GOOD);
            svg_angle(&page, a, d, c, "\316\2611+\316\2612", SVG_GOOD);
        }
        label_abcd(&page, (quadrilateral){a, b, c, d});
    }
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Figure 10, executed. ---- */

enum { STEPS_POINTS = 10, MOST_EDGES = 3 * STEPS_POINTS };

static const point2 steps_points[STEPS_POINTS] = {
    {3.5, 0.2}, {4.8, 5.5}, {1.5, 5.9}, {2.3, 4.1}, {6.1, 0.4},
    {3.9, 3.6}, {6.4, 3.3}, {0.7, 2.9}, {8.3, 2.7}, {1.1, 0.6}};

/* An observer that keeps a copy of the stack and draws a panel for each flip,
 * after line 5: that is, when the next edge is taken from the stack. */
typedef struct flip_painter {
    trace base;
    svg *page;
    const point2 *points;
    svg_box box;
    halfedge_id stack[MOST_EDGES];
    uint32_t size, flips;
    bool flipped;
    trace_event last_flip;
} flip_painter;

/* The last few entries of the stack, as the numbers of their ends. */
static void
describe_stack(const flip_painter *painter, const mesh *m, char *text,
               size_t room)
{
    size_t used = (size_t)snprintf(text, room, "L:");
    uint32_t first = painter->size > 5 ? painter->size - 5 : 0;
    if (first > 0)
        used += (size_t)snprintf(text + used, room - used, " %u more,",
                                 (unsigned)first);
    for (uint32_t i = first; i < painter->size; i++)
        used += (size_t)snprintf(text + used, room - used, " %u-%u",
                                 (unsigned)mesh_origin(m, painter->stack[i]),
                                 (unsigned)mesh_dest(m, painter->stack[i]));
    if (painter->size == 0)
        snprintf(text + used, room - used, " empty");
}

static void
paint_flip(flip_painter *painter, const mesh *m)
{
    svg *page = painter->page;
    const point2 *p = painter->points;
    const trace_event *f = &painter->last_flip;
    char stack[100], caption[160];
    describe_stack(painter, m, stack, sizeof stack);
    snprintf(caption, sizeof caption, "flip %u: %u-%u becomes %u-%u\n%s",
             (unsigned)++painter->flips, (unsigned)f->a, (unsigned)f->b,
             (unsigned)f->c, (unsigned)f->d, stack);
    svg_panel(page, painter->box, STEPS_POINTS, caption);
    svg_triangle(page, p[f->d], p[f->c], p[f->a], SVG_NEW);
    svg_triangle(page, p[f->c], p[f->d], p[f->b], SVG_NEW);
    svg_circle(page, p[f->a], p[f->b], p[f->c], SVG_FAINT);
    svg_mesh(page, p, m);
    svg_segment(page, p[f->a], p[f->b], SVG_BAD);
    svg_segment(page, p[f->c], p[f->d], SVG_NEW);
    svg_points(page, p, STEPS_POINTS, SVG_PLAIN);
    const vertex_id corner[] = {f->a, f->b, f->c, f->d};
    for (int i = 0; i < 4; i++) {
        char name[16];
        snprintf(name, sizeof name, "%u", (unsigned)corner[i]);
        svg_label(page, p[corner[i]], name, SVG_STRONG);
    }
}

static int
see_step(trace *self, const mesh *m, const trace_event *event)
{
    flip_painter *painter = (flip_painter *)self;
    if (event->kind == TRACE_PUSH) {
        painter->stack[painter->size++] = event->edge;
    } else if (event->kind == TRACE_FLIP) {
        painter->flipped = true;
        painter->last_flip = *event;
    } else if (event->kind == TRACE_POP) {
        if (painter->flipped)
            paint_flip(painter, m);
        painter->flipped = false;
        painter->size--;
    }
    return 0;
}

static void
draw_steps(FILE *file)
{
    const point2 *points = steps_points;
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 3, 260, 200, 2}, "Figure 10, executed",
        "The flips that lead from a sweep triangulation of ten points to "
        "their Delaunay triangulation. Each panel shows the edge that was "
        "removed, the circle through it and one apex, which contains the "
        "other apex, the new edge, and the stack after line 5.");
    mesh m;
    must(sweep_triangulate(points, STEPS_POINTS, NULL, &m),
         "sweep_triangulate");
    flip_painter painter = {.base = {see_step},
                            .page = &page,
                            .points = points,
                            .box = svg_box_of(points, STEPS_POINTS)};
    m.trace = &painter.base;
    edge_stack L;
    must(edge_stack_init(&L, &m), "edge_stack_init");
    push_all_edges(&L);

    char stack[100], caption[160];
    describe_stack(&painter, &m, stack, sizeof stack);
    snprintf(caption, sizeof caption, "a sweep; all %u inner edges in L\n%s",
             (unsigned)painter.size, stack);
    svg_panel(&page, painter.box, STEPS_POINTS, caption);
    svg_mesh(&page, points, &m);
    svg_points(&page, points, STEPS_POINTS, SVG_PLAIN);
    svg_label_points(&page, points, STEPS_POINTS);

    lawson_flip(&L, points);
    edge_stack_free(&L);
    svg_panel(&page, painter.box, STEPS_POINTS, "line 7: Delaunay\nL: empty");
    svg_mesh(&page, points, &m);
    svg_points(&page, points, STEPS_POINTS, SVG_PLAIN);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- The proof of Theorem 3: a segment, and the power of its end. ---- */

/* The side through which the segment from x to s leaves the triangle of e; NONE
 * if it ends in there. Requires: it meets no vertex but s, and the triangle. */
static halfedge_id
way_out(const mesh *m, const point2 *points, halfedge_id e, point2 x, point2 s)
{
    for (int i = 0; i < 3; i++) {
        if (orient2d(x, s, points[mesh_origin(m, e)]) < 0 &&
            orient2d(x, s, points[mesh_dest(m, e)]) > 0)
            return e;
        e = mesh_next(e);
    }
    return NONE;
}

/* A point inside the triangle of e. */
static point2
centroid(const mesh *m, const point2 *points, halfedge_id e)
{
    point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
    point2 c = points[mesh_apex(m, e)];
    return (point2){(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

static double
square_distance(point2 p, point2 q)
{
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

/* The power of s with respect to the circle of a, b, c, for people: no -0. */
static double
power_to_a_tenth(point2 a, point2 b, point2 c, point2 s)
{
    point2 centre;
    must(circumcentre(a, b, c, &centre), "circumcentre");
    double power = square_distance(s, centre) - square_distance(a, centre);
    return round(power * 10) / 10 + 0.0;
}

static void
draw_lemma(FILE *file)
{
    const point2 *p = steps_points;
    const point2 s = p[2];
    const svg_box box = {{0, -0.2}, {8.8, 6.9}};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 2, 260, 190, 2},
              "The power of a site falls from triangle to triangle",
              "A segment leads from a point x in a Delaunay triangle to a site s, "
              "through four more triangles. Each panel shows one of them with its "
              "circle. The power of s with respect to these circles becomes smaller "
              "and smaller, and is zero for the last one, which has its corner at s.");
    mesh m;
    must(lawson_triangulate(p, STEPS_POINTS, NULL, &m), "lawson_triangulate");

    halfedge_id e = find_edge(&m, 8, 6);
    quadrilateral q = around(&m, p, way_out(&m, p, e, centroid(&m, p, e), s));
    svg_panel(&page, box, STEPS_POINTS,
              "two circles: their powers are\nequal on the line of the edge");
    svg_circle(&page, q.a, q.b, q.c, SVG_GOOD);
    svg_circle(&page, q.a, q.b, q.d, SVG_GOOD);
    svg_mesh(&page, p, &m);
    svg_segment(&page, (point2){3 * q.a.x - 2 * q.b.x, 3 * q.a.y - 2 * q.b.y},
                (point2){3 * q.b.x - 2 * q.a.x, 3 * q.b.y - 2 * q.a.y}, SVG_FAINT);
    svg_segment(&page, q.a, q.b, SVG_NEW);
    svg_points(&page, p, STEPS_POINTS, SVG_PLAIN);

    const point2 x = centroid(&m, p, e);
    for (int i = 0; e != NONE; i++) {
        q = around(&m, p, e);
        char caption[80];
        snprintf(caption, sizeof caption, "t%d: the power of s is %.1f", i,
                 power_to_a_tenth(q.a, q.b, q.c, s));
        svg_panel(&page, box, STEPS_POINTS, caption);
        svg_triangle(&page, q.a, q.b, q.c, SVG_NEW);
        svg_circle(&page, q.a, q.b, q.c, SVG_GOOD);
        svg_mesh(&page, p, &m);
        svg_segment(&page, x, s, SVG_STRONG);
        svg_points(&page, p, STEPS_POINTS, SVG_PLAIN);
        svg_points(&page, &s, 1, SVG_STRONG);
        svg_label(&page, x, "x", SVG_STRONG);
        svg_label(&page, s, "s", SVG_STRONG);
        halfedge_id out = way_out(&m, p, e, x, s);
        e = out == NONE ? NONE : mesh_twin(&m, out);
    }
    svg_end(&page);
    mesh_free(&m);
}

/* ---- The ladder. ---- */

enum { RUNGS = 5, LADDER_POINTS = 2 * RUNGS + 2 };

typedef struct flip_counter {
    trace base;
    uint32_t flips;
} flip_counter;

static int
count_flip(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    ((flip_counter *)self)->flips += event->kind == TRACE_FLIP;
    return 0;
}

/* Two panels: a sweep along d with the caption `before`, and what Figure 10 makes of
 * it, with `after` and the number of flips. */
static void
draw_before_and_after(svg *page, const point2 *points, uint32_t n, point2 d,
                      const char *before, const char *after)
{
    flip_counter counter = {{count_flip}, 0};
    tri_options options = tri_options_default();
    options.direction = d;
    options.trace = &counter.base;
    mesh swept, flipped;
    must(sweep_triangulate(points, n, &options, &swept), before);
    must(lawson_triangulate(points, n, &options, &flipped), before);
    char caption[100];
    snprintf(caption, sizeof caption, "%s%u flips later", after,
             (unsigned)counter.flips);
    for (int i = 0; i < 2; i++) {
        svg_panel(page, svg_box_of(points, n), n, i == 0 ? before : caption);
        svg_mesh(page, points, i == 0 ? &swept : &flipped);
        svg_points(page, points, n, SVG_PLAIN);
    }
    mesh_free(&swept);
    mesh_free(&flipped);
}

static void
draw_ladder(FILE *file)
{
    point2 points[LADDER_POINTS];
    for (int i = 0; i <= RUNGS; i++) {
        points[i] = (point2){i, 0};
        points[RUNGS + 1 + i] = (point2){RUNGS + i, 1};
    }
    /* A line moving up, and a little to the left, meets the upper points from
     * the right: the first sees all lower edges, each later one the edge to
     * (0,0). */
    const point2 up = {-1, 100};
    svg page;
    svg_begin(
        &page, file, (svg_layout){1, 2, 640, 110, 1},
        "A triangulation that is far from Delaunay",
        "Points on two parallel lines. First all lower edges are joined to "
        "the rightmost upper point and all upper edges to the leftmost lower "
        "one; in the Delaunay triangulation neighbours are joined.");
    char before[80];
    snprintf(before, sizeof before, "the ladder with m = %d", RUNGS);
    draw_before_and_after(&page, points, LADDER_POINTS, up, before,
                          "its Delaunay triangulation, m\302\262 = ");
    svg_end(&page);
}

/* ---- Nothing can be flipped (E34). ---- */

static void
draw_not_flippable(FILE *file)
{
    const point2 points[] = {{0, 0}, {3, 0}, {0, 3}, {1, 1}};
    svg_box box = svg_box_of(points, 4);
    mesh m;
    must(sweep_triangulate(points, 4, NULL, &m), "sweep_triangulate");
    uint32_t interior = 0, flippable = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        if (mesh_is_interior(&m, e) && e < mesh_twin(&m, e)) {
            interior++;
            flippable += is_flippable(&m, points, e);
        }
    char caption[80];
    snprintf(caption, sizeof caption, "%u inner edges,\n%u of them flippable",
             (unsigned)interior, (unsigned)flippable);

    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 280, 260, 2},
        "Not every edge can be flipped",
        "A triangle with a point inside, joined to its three corners. The "
        "two triangles at an inner edge make a quadrilateral with a reflex "
        "corner; its other diagonal is a side of the big triangle.");
    svg_panel(&page, box, 4, caption);
    svg_mesh(&page, points, &m);
    svg_points(&page, points, 4, SVG_PLAIN);
    svg_label_points(&page, points, 4);

    halfedge_id ab = find_edge(&m, 0, 3);
    quadrilateral q = around(&m, points, ab);
    svg_panel(&page, box, 4,
              "abc and abd: not convex at b;\ncd would leave their union");
    svg_triangle(&page, q.a, q.b, q.c, SVG_BAD);
    svg_triangle(&page, q.b, q.a, q.d, SVG_BAD);
    svg_mesh(&page, points, &m);
    svg_segment(&page, q.c, q.d, SVG_BAD);
    svg_points(&page, points, 4, SVG_PLAIN);
    label_abcd(&page, q);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Locally Delaunay and not Delaunay (E36). ---- */

static void
draw_local_only(FILE *file)
{
    const point2 points[] = {{1, 1}, {0, 3}, {0, 2}, {2, 2}, {1, 0}};
    svg_box box = {{-0.6, -0.1}, {3.1, 4.1}};
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 240, 270, 2},
        "Locally Delaunay is not Delaunay",
        "Five points. The edge 0-1 is locally Delaunay: of its two triangles "
        "neither circle contains the other's apex. But a circle through 0, 1 "
        "and 2 contains 3, so no circle through 0 and 1 is empty, and the "
        "Delaunay triangulation has no such edge.");
    mesh m;
    must(sweep_triangulate(points, 5, NULL, &m), "sweep_triangulate");
    halfedge_id ab = find_edge(&m, 0, 1);
    bool local = is_locally_delaunay(&m, points, ab);
    quadrilateral q = around(&m, points, ab);
    svg_panel(&page, box, 5,
              local ? "0-1 is locally Delaunay:\n3 and 4 are not inside"
                    : "0-1 is not locally Delaunay");
    svg_circle(&page, q.a, q.b, q.c, SVG_GOOD);
    svg_circle(&page, q.a, q.b, q.d, SVG_GOOD);
    svg_mesh(&page, points, &m);
    svg_segment(&page, q.a, q.b, SVG_GOOD);
    svg_points(&page, points, 5, SVG_PLAIN);
    svg_label_points(&page, points, 5);

    bool contains = incircle(points[0], points[1], points[2], points[3]) > 0;
    svg_panel(&page, box, 5,
              contains
                  ? "0-1 is not Delaunay: the\ncircle of 0, 1, 2 contains 3"
                  : "3 is not inside the circle of 0, 1, 2");
    svg_circle(&page, points[0], points[1], points[2], SVG_BAD);
    svg_mesh(&page, points, &m);
    svg_segment(&page, q.a, q.b, SVG_BAD);
    svg_points(&page, points, 5, SVG_PLAIN);
    svg_points(&page, &points[3], 1, SVG_BAD);
    svg_label_points(&page, points, 5);
    mesh_free(&m);

    must(lawson_triangulate(points, 5, NULL, &m), "lawson_triangulate");
    svg_panel(&page, box, 5, "the Delaunay triangulation");
    svg_mesh(&page, points, &m);
    svg_points(&page, points, 5, SVG_PLAIN);
    svg_label_points(&page, points, 5);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Two hundred points, before and after. ---- */

enum { MANY = 200 };

static void
draw_many(FILE *file)
{
    point2 points[MANY];
    random_source source = random_from_seed(23);
    for (int i = 0; i < MANY; i++)
        points[i] = random_point(&source);

    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 400, 400, 1},
              "Two hundred random points, before and after Figure 10",
              "The same points twice: triangulated by a sweep, with long "
              "thin triangles, and after all flips, with small angles "
              "avoided and neighbours joined.");
    draw_before_and_after(&page, points, MANY, (point2){1, 0}, "a sweep", "");
    svg_end(&page);
}

/* ---- Flip graphs. ---- */

static void
draw_graph_of(FILE *file, const point2 *points, uint32_t n, const char *title)
{
    flip_graph g;
    must(flip_graph_build(points, n, NULL, &g), title);
    flip_graph_draw(&g, points, file, title);
    flip_graph_free(&g);
}

static void
draw_hexagon(FILE *file)
{
    const point2 points[] = {{10, 0}, {5, 9}, {-5, 8}, {-10, 0}, {-4, -9}, {5, -8}};
    draw_graph_of(file, points, 6, "The flip graph of a convex hexagon");
}

static void
draw_grid(FILE *file)
{
    point2 points[9];
    for (int i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    draw_graph_of(file, points, 9, "The flip graph of the 3x3 grid");
}

static const figure figures[] = {
    {"fig9_locally_delaunay", draw_definition},
    {"flip", draw_flip},
    {"fig11_six_angles", draw_angles},
    {"fig10_steps", draw_steps},
    {"thm3_power", draw_lemma},
    {"ladder", draw_ladder},
    {"nothing_flippable", draw_not_flippable},
    {"local_not_global", draw_local_only},
    {"before_after_200", draw_many},
    {"flip_graph_hexagon", draw_hexagon},
    {"flip_graph_grid", draw_grid},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
