/* svg_pictures.c - labels that keep clear; pictures of meshes and verdicts. */
#include "lib/svg.h"

#include "lib/svg_write.h"

#include <math.h>

/* ---- Labels. ---- */

static double
distance_to_segment(point2 p, point2 a, point2 b)
{
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    double t = length2 > 0 ? fmin(fmax(along / length2, 0), 1) : 0;
    point2 foot = {a.x + t * dx, a.y + t * dy};
    return sqrt((p.x - foot.x) * (p.x - foot.x) +
                (p.y - foot.y) * (p.y - foot.y));
}

static double
cross(point2 a, point2 b, point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* How much white there is between two inks; negative when they overlap. */
static double
gap_between(svg_ink p, svg_ink q)
{
    bool crossing = cross(p.a, p.b, q.a) * cross(p.a, p.b, q.b) < 0 &&
                    cross(q.a, q.b, p.a) * cross(q.a, q.b, p.b) < 0;
    double near_q = fmin(distance_to_segment(p.a, q.a, q.b),
                         distance_to_segment(p.b, q.a, q.b));
    double near_p = fmin(distance_to_segment(q.a, p.a, p.b),
                         distance_to_segment(q.b, p.a, p.b));
    return (crossing ? 0 : fmin(near_p, near_q)) - p.radius - q.radius;
}

/* The least gap between a label and other ink or the panel's border. */
static double
room_for(const svg *page, svg_ink label)
{
    double right = page->layout.width - label.b.x;
    double below = page->layout.height - label.b.y;
    double room = fmin(fmin(label.a.x, right), fmin(label.a.y, below));
    room -= label.radius;
    uint32_t n = page->inks < SVG_REMEMBERED ? page->inks : SVG_REMEMBERED;
    for (uint32_t i = 0; i < n; i++)
        room = fmin(room, gap_between(label, page->ink[i]));
    return room;
}

void
svg_label(svg *page, point2 at, const char *text, svg_style style)
{
    static const point2 direction[] = {
        {0.7, -0.7},   {1, 0},        {0, -1},        {-0.7, -0.7},
        {0.7, 0.7},    {-1, 0},       {0, 1},         {-0.7, 0.7},
        {0.92, -0.38}, {0.38, -0.92}, {-0.38, -0.92}, {-0.92, -0.38},
        {-0.92, 0.38}, {-0.38, 0.92}, {0.38, 0.92},   {0.92, 0.38}};
    const double radius = 6, enough = 3;
    double half_length = fmax(svg_text_width(text) / 2 - radius, 0);
    point2 p = svg_place(page, at);
    svg_ink best = {p, p, radius};
    double most = -1e9;
    for (int i = 0; i < 48; i++) { /* all directions, then again further away */
        point2 d = direction[i % 16];
        double away = 10 + 5.0 * (i / 16);
        double x = p.x + d.x * (away + half_length), y = p.y + d.y * away;
        svg_ink label = {{x - half_length, y}, {x + half_length, y}, radius};
        double room = fmin(room_for(page, label), enough) - i / 16;
        if (room > most) {
            most = room;
            best = label;
        }
    }
    point2 middle = {best.a.x / 2 + best.b.x / 2, best.a.y};
    svg_text(page, middle, text, style);
}

static void
label_number(svg *page, point2 at, vertex_id v)
{
    char number[16];
    snprintf(number, sizeof number, "%u", (unsigned)v);
    svg_label(page, at, number, SVG_STRONG);
}

void
svg_label_points(svg *page, const point2 *points, uint32_t n)
{
    for (vertex_id v = 0; v < n; v++)
        label_number(page, points[v], v);
}

/* ---- Whole pictures. ---- */

/* Up to so many points carry their numbers. */
enum { MOST_NUMBERS = 50 };

void
svg_mesh(svg *page, const point2 *points, const mesh *m)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
        if (a == GHOST || b == GHOST || e > mesh_twin(m, e))
            continue; /* the edge has been drawn from its other side */
        svg_segment(page, points[a], points[b],
                    mesh_is_interior(m, e) ? SVG_PLAIN : SVG_STRONG);
    }
}

void
svg_triangulation(svg *page, const point2 *points, uint32_t n,
                  triangle_list list)
{
    svg_triangles(page, points, list, SVG_PLAIN);
    svg_points(page, points, n, SVG_PLAIN);
    if (n <= MOST_NUMBERS)
        svg_label_points(page, points, n);
}

void
svg_verdict(svg *page, const point2 *points, uint32_t n, triangle_list list,
            const verdict *v)
{
    svg_triangles(page, points, list, SVG_PLAIN);
    svg_points(page, points, n, SVG_PLAIN);
    int witnesses = v->holds ? 0 : v->witnesses;
    point2 w[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    for (int i = 0; i < witnesses; i++)
        w[i] = points[v->witness[i]];
    double em = page->em; /* witnesses can be seen among any number of points */
    page->em = fmax(em, 8);
    fputs("<g", page->file);
    svg_put_attribute(page->file, "font-size", page->em);
    fputs(">\n", page->file);
    if (witnesses == 3)
        svg_triangle(page, w[0], w[1], w[2], SVG_BAD);
    if (witnesses == 4)
        svg_circle(page, w[0], w[1], w[2], SVG_BAD);
    if (witnesses == 2 || witnesses == 4)
        svg_segment(page, w[0], w[1], SVG_BAD);
    for (int i = 0; i < witnesses; i++)
        svg_points(page, &w[i], 1, SVG_BAD);
    if (n <= MOST_NUMBERS)
        svg_label_points(page, points, n);
    else
        for (int i = 0; i < witnesses; i++)
            label_number(page, w[i], v->witness[i]);
    fputs("</g>\n", page->file);
    page->em = em;
}
