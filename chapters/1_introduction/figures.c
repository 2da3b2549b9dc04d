/* figures.c - the pictures of chapter 1: half-edges, and the vertex at infinity.
 * The numbers in them are the handles of real meshes.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/figures.h"
#include "lib/svg.h"

#include <math.h>

/* ---- Pieces of pictures. ---- */

enum { SITES = 6 };

/* In the order of a sweep. The last sees two edges, and d is inside then. */
static const point2 sites[SITES] = {{0.0, 1.6}, {1.0, 3.8}, {1.4, 0.0},
                                    {2.8, 1.7}, {3.7, 3.5}, {4.7, 0.8}};

static void
draw_sites(svg *page, const point2 *points, uint32_t n)
{
    const char *const letter[] = {"a", "b", "c", "d", "e", "f"};
    svg_points(page, points, n, SVG_PLAIN);
    for (uint32_t i = 0; i < n; i++)
        svg_label(page, points[i], letter[i], SVG_STRONG);
}

static void
draw_halfedge(svg *page, const point2 *points, const mesh *m, halfedge_id e,
              const char *name, svg_style style)
{
    point2 from = points[mesh_origin(m, e)], to = points[mesh_dest(m, e)];
    svg_halfedge(page, from, to, name, style);
}

static void
draw_numbered(svg *page, const point2 *points, const mesh *m, halfedge_id e,
              uint32_t number, svg_style style)
{
    char name[16];
    snprintf(name, sizeof name, "%u", (unsigned)number);
    draw_halfedge(page, points, m, e, name, style);
}

static void
draw_edges(svg *page, const point2 *points, const mesh *m)
{
    triangle_list list;
    must(mesh_triangles(m, &list), "mesh_triangles");
    svg_triangles(page, points, list, SVG_PLAIN);
    triangle_list_free(&list);
}

/* The half-edge from a to b. Requires: there is one. */
static halfedge_id
find_edge(const mesh *m, vertex_id a, vertex_id b)
{
    halfedge_id e = mesh_leaving(m, a);
    while (mesh_dest(m, e) != b)
        e = mesh_around(m, e);
    return e;
}

/* ---- The questions. ---- */

static void
draw_questions(FILE *file)
{
    svg_box box = svg_box_of(sites, SITES);
    svg page;
    svg_begin(&page, file, (svg_layout){2, 2, 370, 330, 1},
              "Half-edges, and what one can ask about them",
              "Four views of one triangulation of six points: the numbers of "
              "all half-edges; a half-edge with its next, previous and twin; "
              "the half-edges around a vertex, counted counterclockwise; and "
              "the hull edges, counted counterclockwise.");
    mesh m;
    must(sweep_triangulate(sites, SITES, NULL, &m), "sweep_triangulate");

    svg_panel(&page, box, SITES, "every half-edge has a number");
    draw_edges(&page, sites, &m);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        if (mesh_in_triangle(&m, e))
            draw_numbered(&page, sites, &m, e, e, SVG_NEW);
    draw_sites(&page, sites, SITES);

    halfedge_id e = find_edge(&m, 3, 4);
    svg_panel(&page, box, SITES, "origin d, dest e; the apex of de is b");
    draw_edges(&page, sites, &m);
    point2 d = sites[mesh_origin(&m, e)], apex = sites[mesh_apex(&m, e)];
    svg_triangle(&page, d, sites[mesh_dest(&m, e)], apex, SVG_NEW);
    draw_halfedge(&page, sites, &m, e, "de", SVG_STRONG);
    draw_halfedge(&page, sites, &m, mesh_next(e), "next", SVG_NEW);
    draw_halfedge(&page, sites, &m, mesh_prev(e), "prev", SVG_NEW);
    draw_halfedge(&page, sites, &m, mesh_twin(&m, e), "twin", SVG_GOOD);
    draw_sites(&page, sites, SITES);
    svg_points(&page, &apex, 1, SVG_BAD);

    svg_panel(&page, box, SITES, "around d, from one that leaves it");
    draw_edges(&page, sites, &m);
    uint32_t count = 0;
    halfedge_id first = e;
    do {
        draw_numbered(&page, sites, &m, e, ++count, SVG_NEW);
        e = mesh_around(&m, e);
    } while (e != first);
    draw_sites(&page, sites, SITES);

    svg_panel(&page, box, SITES, "along the hull, from some hull edge");
    draw_edges(&page, sites, &m);
    count = 0;
    first = e = mesh_some_hull_edge(&m);
    do {
        draw_numbered(&page, sites, &m, e, ++count, SVG_NEW);
        e = mesh_hull_next(&m, e);
    } while (e != first);
    draw_sites(&page, sites, SITES);
    svg_end(&page);
    mesh_free(&m);
}

/* ---- The vertex at infinity. ---- */

static point2
direction(point2 from, point2 to)
{
    double x = to.x - from.x, y = to.y - from.y, length = sqrt(x * x + y * y);
    return (point2){x / length, y / length};
}

/* A point outside the hull, above the place where hull edge e begins: between
 * the normals of the two hull edges there, and beyond the end of a path. */
static point2
ray_end(const mesh *m, const point2 *points, halfedge_id e, double length)
{
    halfedge_id before = mesh_hull_prev(m, e);
    point2 p = points[mesh_origin(m, e)];
    point2 in = direction(points[mesh_origin(m, before)], p);
    point2 out = direction(p, points[mesh_dest(m, e)]);
    point2 normal = {in.y + out.y, -in.x - out.x};
    if (fabs(normal.x) + fabs(normal.y) < 0.001) /* the path turns back */
        normal = in;
    point2 ray = direction((point2){0, 0}, normal);
    return (point2){p.x + length * ray.x, p.y + length * ray.y};
}

static void
draw_slot(svg *page, triangle_id t, double x, double y, svg_style style)
{
    char name[16];
    snprintf(name, sizeof name, "%u", (unsigned)t);
    svg_text(page, svg_place(page, (point2){x, y}), name, style);
}

/* The triangles with their slots; those outside have two rays for sides that
 * meet at infinity. */
static void
draw_with_outside(svg *page, const point2 *points, uint32_t n, const mesh *m,
                  double length)
{
    halfedge_id first = mesh_some_hull_edge(m), e = first;
    do {
        halfedge_id next = mesh_hull_next(m, e);
        point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
        point2 over_a = ray_end(m, points, e, length);
        point2 over_b = ray_end(m, points, next, length);
        svg_triangle(page, a, b, over_b, SVG_FAINT);
        svg_triangle(page, a, over_b, over_a, SVG_FAINT);
        svg_arrow(page, a, over_a, SVG_GOOD);
        e = next;
    } while (e != first);
    svg_mesh(page, points, m);
    svg_points(page, points, n, SVG_PLAIN);
    do {
        halfedge_id next = mesh_hull_next(m, e);
        point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
        point2 over_a = ray_end(m, points, e, length);
        point2 over_b = ray_end(m, points, next, length);
        draw_slot(page, mesh_triangle_of(mesh_twin(m, e)),
                  (a.x + b.x + over_a.x + over_b.x) / 4,
                  (a.y + b.y + over_a.y + over_b.y) / 4, SVG_GOOD);
        e = next;
    } while (e != first);
    for (e = 0; e < mesh_halfedges(m); e += 3)
        if (mesh_in_triangle(m, e)) {
            point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
            point2 c = points[mesh_apex(m, e)];
            draw_slot(page, mesh_triangle_of(e), (a.x + b.x + c.x) / 3,
                      (a.y + b.y + c.y) / 3, SVG_STRONG);
        }
}

static void
draw_infinity(FILE *file)
{
    const point2 path[] = {{0, 1}, {1.5, 1.5}, {3, 2}, {4.5, 2.5}};
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 370, 350, 2},
              "The vertex at infinity",
              "Left: a triangulation whose hull vertices are joined to a "
              "vertex at infinity by rays; each hull edge has a ghost "
              "triangle outside. Right: four collinear points are a path "
              "with ghost triangles on both sides, and an inner vertex has "
              "two rays.");
    const point2 *const points[] = {sites, path};
    const uint32_t n[] = {SITES, 4};
    const svg_box box[] = {{{-1.1, -1.1}, {5.6, 4.8}},
                           {{-1.1, -0.9}, {5.6, 4.4}}};
    for (int i = 0; i < 2; i++) {
        mesh m;
        must(sweep_triangulate(points[i], n[i], NULL, &m), "sweep_triangulate");
        char caption[120];
        snprintf(caption, sizeof caption,
                 "%u locations: %u triangles, %u of them\noutside, one at "
                 "each hull edge",
                 (unsigned)m.locations, (unsigned)m.triangles,
                 (unsigned)mesh_hull_size(&m));
        svg_panel(&page, box[i], SITES, caption);
        draw_with_outside(&page, points[i], n[i], &m, 1.1);
        mesh_free(&m);
    }
    svg_end(&page);
}

/* ---- What attaching a point does to the slots. ---- */

static void
draw_join(FILE *file)
{
    mesh m;
    must(mesh_init(&m, SITES, SITES), "mesh_init");
    halfedge_id last = mesh_hull_next(&m, mesh_start(&m, 0, 1));
    for (vertex_id v = 2; v < SITES - 1; v++)
        last = attach(&m, hull_edges_seeing(&m, sites, last, v), v);

    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 370, 350, 2},
              "mesh_cover and mesh_hull_join",
              "Before and after a sixth point is attached: the ghost "
              "triangles of the hull edges it sees become triangles and keep "
              "their slots; two new slots are the ghost triangles at its own "
              "hull edges.");
    svg_box box = {{-1.1, -1.1}, {5.6, 4.8}};
    hull_chain q = hull_edges_seeing(&m, sites, last, SITES - 1);
    svg_panel(&page, box, SITES, "before: f sees the marked hull edges");
    for (halfedge_id e = q.first; e != q.end; e = mesh_hull_next(&m, e))
        svg_segment(&page, sites[mesh_origin(&m, e)], sites[mesh_dest(&m, e)],
                    SVG_MARK);
    draw_with_outside(&page, sites, SITES, &m, 1.1);
    draw_sites(&page, sites, SITES);

    attach(&m, q, SITES - 1);
    svg_panel(&page, box, SITES, "after: their slots are triangles now,\n"
                                 "and two new ones lie outside");
    draw_with_outside(&page, sites, SITES, &m, 1.1);
    draw_sites(&page, sites, SITES);
    svg_end(&page);
    mesh_free(&m);
}

static const figure figures[] = {
    {"questions", draw_questions},
    {"infinity", draw_infinity},
    {"join", draw_join},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
