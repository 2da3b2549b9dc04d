/* figures.c - the pictures of section 3.1. The notes show a photograph (Figure
 * 4) and two pages of a survey (Figures 5 and 6): their content is drawn again
 * from our own runs.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/figures.h"
#include "lib/memory.h"
#include "lib/random.h"
#include "lib/svg.h"

#include <math.h>

/* ---- Pieces of pictures. ---- */

/* A triangulation, its dual, and where the vertices are. */
typedef struct diagram {
    mesh m;
    voronoi d;
    point2 *at;
} diagram;

static diagram
build(const point2 *points, uint32_t n)
{
    diagram g;
    must(lawson_triangulate(points, n, NULL, &g.m), "lawson_triangulate");
    must(voronoi_dual(&g.m, points, &g.d), "voronoi_dual");
    g.at = memory_array(g.d.vertices, sizeof *g.at);
    must(g.at != NULL ? voronoi_vertices(&g.d, points, g.at)
                      : TRI_OUT_OF_MEMORY,
         "vertices");
    return g;
}

static void
discard(diagram *g)
{
    memory_free(g->at);
    voronoi_free(&g->d);
    mesh_free(&g->m);
}

static svg_box
wider(svg_box box, double by)
{
    return (svg_box){{box.min.x - by, box.min.y - by},
                     {box.max.x + by, box.max.y + by}};
}

static void
draw_diagram(svg *page, const diagram *g, const point2 *points, svg_box box,
             svg_style style)
{
    for (uint32_t k = 0; k < g->d.edges; k++) {
        point2 s[2];
        if (voronoi_edge_in_box(&g->d, points, g->at, k, box.min, box.max, s))
            svg_segment(page, s[0], s[1], style);
    }
}

/* The diagram thick and the triangulation thin. */
static void
draw_both(svg *page, const diagram *g, const point2 *points, uint32_t n,
          svg_box box)
{
    triangle_list list;
    must(mesh_triangles(&g->m, &list), "mesh_triangles");
    draw_diagram(page, g, points, box, SVG_STRONG);
    svg_triangles(page, points, list, SVG_PLAIN);
    svg_points(page, points, n, SVG_PLAIN);
    svg_points(page, g->at, g->d.vertices, SVG_NEW);
    triangle_list_free(&list);
}

/* A polygon, and room for every cut. */
enum { MOST_CORNERS = 64 };
typedef struct shape {
    uint32_t size;
    point2 corner[MOST_CORNERS];
} shape;

static shape
shape_of_box(svg_box box)
{
    return (shape){
        4, {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}};
}

static void
cut_shape(shape *s, point2 p, point2 q)
{
    shape out;
    out.size = cut_polygon(s->corner, s->size, p, q, out.corner);
    *s = out;
}

static void
draw_shape(svg *page, const shape *s, svg_style style)
{
    for (uint32_t i = 1; i + 1 < s->size; i++)
        svg_triangle(page, s->corner[0], s->corner[i], s->corner[i + 1], style);
}

/* The part of p's cell in the box. */
static shape
cell_in_box(const diagram *g, const point2 *points, svg_box box, vertex_id p)
{
    shape s = shape_of_box(box);
    for (uint32_t i = g->d.cell_first[p]; i < g->d.cell_first[p + 1]; i++)
        cut_shape(&s, points[p],
                  points[voronoi_beyond(&g->d, g->d.cell_edge[i], p)]);
    return s;
}

/* ---- Figure 4: a pattern. ---- */

/* Sites that crowd in the middle, like the pieces of a pane around a shot. */
static void
draw_pattern(FILE *file)
{
    enum { SITES = 400 };
    point2 points[SITES];
    random_source source = random_from_seed(1908);
    for (int i = 0; i < SITES;) {
        double x = 2 * random_unit(&source) - 1,
               y = 2 * random_unit(&source) - 1;
        double r = sqrt(x * x + y * y);
        if (r > 0 && r < 1)
            points[i++] = (point2){x * r, y * r};
    }
    svg page;
    diagram g = build(points, SITES);
    svg_box box = {{-0.75, -0.55}, {0.75, 0.55}};
    svg_begin(&page, file, (svg_layout){1, 1, 600, 440, 0}, "A Voronoi pattern",
              "The cells of four hundred random sites, which crowd in the "
              "middle: they "
              "look like a pane of glass that has been shot at.");
    svg_panel(&page, box, SITES / 4, "");
    draw_diagram(&page, &g, points, box, SVG_PLAIN);
    svg_end(&page);
    discard(&g);
}

/* ---- Figures 5 and 6: eight sites. ---- */

static const point2 eight[8] = {{1.0, 1.2}, {3.6, 0.4}, {6.2, 1.4}, {2.5, 2.8},
                                {4.6, 2.6}, {0.6, 4.4}, {3.6, 4.8}, {6.4, 4.2}};

static void
draw_eight_sites(FILE *file)
{
    svg page;
    diagram g = build(eight, 8);
    svg_box box = wider(svg_box_of(eight, 8), 1.2);
    shape cell = cell_in_box(&g, eight, box, 4);
    svg_begin(&page, file, (svg_layout){1, 1, 480, 420, 1},
              "Figure 5: eight sites",
              "The Voronoi diagram of eight sites. The cell of site 4 is "
              "shaded: every "
              "point of it is at least as near to 4 as to any other site.");
    char caption[80];
    snprintf(caption, sizeof caption, "%u cells, %u vertices, %u edges",
             (unsigned)g.d.cells, (unsigned)g.d.vertices, (unsigned)g.d.edges);
    svg_panel(&page, box, 8, caption);
    draw_shape(&page, &cell, SVG_NEW);
    draw_diagram(&page, &g, eight, box, SVG_STRONG);
    svg_points(&page, eight, 8, SVG_PLAIN);
    svg_label_points(&page, eight, 8);
    svg_end(&page);
    discard(&g);
}

static void
draw_dual(FILE *file)
{
    svg page;
    diagram g = build(eight, 8);
    svg_box box = wider(svg_box_of(eight, 8), 1.2);
    const voronoi_edge *e = g.d.edge;
    while (e->left != 3 && e->right != 3)
        e++;
    const vertex_id *s = g.d.vertex_site + g.d.vertex_first[e->from];
    svg_begin(
        &page, file, (svg_layout){2, 1, 380, 340, 1},
        "Figure 6: the dual is the Delaunay triangulation",
        "Left: sites whose cells share an edge are joined. Right: a vertex is "
        "the "
        "centre of the circle through its three sites, and no site is inside.");
    svg_panel(&page, box, 8, "an edge for an edge, a vertex for a triangle");
    draw_diagram(&page, &g, eight, box, SVG_FAINT);
    svg_mesh(&page, eight, &g.m);
    svg_points(&page, eight, 8, SVG_PLAIN);
    svg_points(&page, g.at, g.d.vertices, SVG_NEW);
    svg_panel(&page, box, 8, "the circle of a vertex is empty");
    draw_diagram(&page, &g, eight, box, SVG_PLAIN);
    svg_circle(&page, eight[s[0]], eight[s[1]], eight[s[2]], SVG_NEW);
    svg_triangle(&page, eight[s[0]], eight[s[1]], eight[s[2]], SVG_PLAIN);
    svg_points(&page, eight, 8, SVG_PLAIN);
    for (int i = 0; i < 3; i++)
        svg_segment(&page, g.at[e->from], eight[s[i]], SVG_FAINT);
    svg_points(&page, &g.at[e->from], 1, SVG_NEW);
    svg_end(&page);
    discard(&g);
}

/* ---- Definition 5: a region, half-plane by half-plane. ---- */

/* The last of the first n sites, and what it does to the region of site 0. */
static void
draw_half_plane(svg *page, const point2 *points, uint32_t n, uint32_t all,
                svg_box box)
{
    char caption[80];
    voronoi_region before, now;
    must(voronoi_region_of(points, n - 1, 0, &before), "voronoi_region_of");
    must(voronoi_region_of(points, n, 0, &now), "voronoi_region_of");
    bool cuts = false;
    for (uint32_t i = 0; i < now.size; i++)
        cuts = cuts || now.neighbour[i] == n - 1;
    int gone = (int)before.size + 1 - (int)now.size;
    if (!cuts)
        snprintf(caption, sizeof caption, "%u cuts nothing off",
                 (unsigned)n - 1);
    else if (gone == 0)
        snprintf(caption, sizeof caption, "%u cuts off a piece",
                 (unsigned)n - 1);
    else
        snprintf(caption, sizeof caption,
                 "%u cuts off %d edge%s and adds one", (unsigned)n - 1,
                 gone, gone == 1 ? "" : "s");

    shape region = shape_of_box(box), lost = region;
    for (uint32_t i = 0; i < before.size; i++)
        cut_shape(&lost, points[0], points[before.neighbour[i]]);
    for (uint32_t i = 0; i < now.size; i++)
        cut_shape(&region, points[0], points[now.neighbour[i]]);
    svg_panel(page, box, all, caption);
    draw_shape(page, &lost, SVG_PLAIN);
    draw_shape(page, &region, SVG_NEW);
    svg_segment(page, points[0], points[n - 1], SVG_FAINT);
    voronoi_edge bisector = {0, n - 1, NONE, NONE};
    const voronoi line = {.edges = 1, .edge = &bisector};
    point2 s[2];
    if (voronoi_edge_in_box(&line, points, NULL, 0, box.min, box.max, s))
        svg_segment(page, s[0], s[1], cuts ? SVG_STRONG : SVG_BAD);
    svg_points(page, points, n, SVG_PLAIN);
    svg_points(page, &points[n - 1], 1, SVG_STRONG);
    svg_label_points(page, points, n);
    voronoi_region_free(&before);
    voronoi_region_free(&now);
}

static void
draw_half_planes(FILE *file)
{
    static const point2 points[] = {{3, 2.4},   {5.4, 3.4}, {1.2, 3.8},
                                    {2.4, 0.2}, {5.4, 1.2}, {6.6, 0.4},
                                    {1, 1.8},   {4, 2.2}};
    enum { SITES = sizeof points / sizeof *points };
    svg page;
    svg_box box = wider(svg_box_of(points, SITES), 0.5);
    svg_begin(&page, file, (svg_layout){4, 2, 220, 200, 1},
              "Definition 5, executed: the region of site 0, half-plane by "
              "half-plane",
              "Each panel adds a site and its bisector with site 0. What was "
              "the region and "
              "is no more is grey; the region is hatched.");
    svg_panel(&page, box, SITES, "alone, 0 has the whole plane");
    shape plane = shape_of_box(box);
    draw_shape(&page, &plane, SVG_NEW);
    svg_points(&page, points, 1, SVG_PLAIN);
    svg_label_points(&page, points, 1);
    for (uint32_t n = 2; n <= SITES; n++)
        draw_half_plane(&page, points, n, SITES, box);
    svg_end(&page);
}

/* ---- Degenerate sites. ---- */

/* One panel: the diagram of some sites, and a Delaunay triangulation. */
static void
draw_panel(svg *page, const point2 *points, uint32_t n, svg_box box,
           const char *caption)
{
    diagram g = build(points, n);
    char text[120];
    snprintf(text, sizeof text, "%s: v = %u, e = %u", caption,
             (unsigned)g.d.vertices, (unsigned)g.d.edges);
    svg_panel(page, box, n, text);
    draw_both(page, &g, points, n, box);
    discard(&g);
}

static void
draw_degenerate(FILE *file)
{
    static const point2 line[] = {{0, 2}, {3, 3}, {4.5, 3.5}, {7.5, 4.5}};
    static const point2 circle[] = {{5, 0},   {3, 4},  {0, 5}, {-4, 3},
                                    {-4, -3}, {0, -5}, {4, -3}};
    point2 grid[16];
    for (int i = 0; i < 16; i++)
        grid[i] = (point2){i % 4, i / 4};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 250, 220, 1},
              "Collinear and cocircular sites",
              "Collinear sites have parallel lines for edges, and no vertex. "
              "Sites on one "
              "empty circle share one vertex, and a grid has a vertex for each "
              "square. "
              "Thin: one of the triangulations.");
    draw_panel(&page, line, 4, (svg_box){{-1, 0}, {8.5, 6.5}}, "collinear");
    draw_panel(&page, circle, 7, (svg_box){{-8, -6.5}, {8, 6.5}}, "cocircular");
    draw_panel(&page, grid, 16, (svg_box){{-0.8, -0.6}, {3.8, 3.6}},
               "4 x 4 grid");
    svg_end(&page);
}

/* The square has two Delaunay triangulations, with the same diagram; with a
 * site inside its circle it has one. */
static void
draw_ambiguity(FILE *file)
{
    static const point2 square[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}};
    svg_box box = {{-1.9, -1.7}, {1.9, 1.7}};
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 240, 210, 1},
        "Where the dual is ambiguous, and where it is not",
        "The corners of a square have one Voronoi diagram and two Delaunay "
        "triangulations. With a fifth site in the middle the corners are still "
        "cocircular, and the triangulation is unique.");
    diagram g = build(square, 4);
    for (int i = 0; i < 2; i++) {
        svg_panel(&page, box, 5,
                  i == 0 ? "one diagonal ..." : "... or the other");
        svg_circle(&page, square[0], square[1], square[2], SVG_FAINT);
        draw_both(&page, &g, square, 4, box);
        halfedge_id e = 0;
        while (!mesh_is_interior(&g.m, e))
            e++;
        flip(&g.m, e);
    }
    discard(&g);
    g = build(square, 5);
    svg_panel(&page, box, 5, "the circle is not empty: no choice");
    svg_circle(&page, square[0], square[1], square[2], SVG_FAINT);
    draw_both(&page, &g, square, 5, box);
    discard(&g);
    svg_end(&page);
}

static void
draw_perturbed(FILE *file)
{
    svg_box box = {{-1.2, -1.5}, {3.2, 2.5}};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 240, 220, 1},
              "A perturbation changes what is true",
              "The middle one of the lower sites lies in the hull edge and has "
              "an unbounded cell. "
              "Moved up a little, it is inside the hull and its cell is "
              "bounded; moved "
              "down, it is a corner of the hull.");
    for (int i = 0; i < 3; i++) {
        const double up[] = {0, 0.4, -0.4};
        static const char *const caption[] = {"as given", "moved up",
                                              "moved down"};
        const point2 points[] = {{0, 0}, {1, up[i]}, {2, 0}, {1, 2}};
        diagram g = build(points, 4);
        shape cell = cell_in_box(&g, points, box, 1);
        char text[80];
        snprintf(text, sizeof text, "%s: %s cell, h = %u", caption[i],
                 voronoi_is_bounded(&g.d, 1) ? "bounded" : "unbounded",
                 (unsigned)mesh_hull_size(&g.m));
        svg_panel(&page, box, 4, text);
        draw_shape(&page, &cell, SVG_NEW);
        draw_both(&page, &g, points, 4, box);
        discard(&g);
    }
    svg_end(&page);
}

/* ---- Walking, and local coordinates. ---- */

static void
draw_walk(FILE *file)
{
    enum { SITES = 60 };
    point2 points[SITES], x = {0.86, 0.83};
    random_source source = random_from_seed(5);
    for (int i = 0; i < SITES; i++)
        points[i] = random_point(&source);
    diagram g = build(points, SITES);
    svg_box box = wider(svg_box_of(points, SITES), 0.04);
    vertex_id start = 0;
    for (vertex_id v = 0; v < SITES; v++)
        if (points[v].x + points[v].y < points[start].x + points[start].y)
            start = v;
    uint32_t visited;
    vertex_id end = nearest_site(&g.m, points, x, start, &visited);
    shape cell = cell_in_box(&g, points, box, end);
    char caption[80];
    snprintf(caption, sizeof caption, "%u comparisons among %d sites",
             (unsigned)visited, SITES);
    svg page;
    svg_begin(&page, file, (svg_layout){1, 1, 480, 440, 1},
              "A walk to the nearest site",
              "From site to site, always to the neighbour that is nearest to "
              "the cross, "
              "until no neighbour is nearer: then the cross lies in that "
              "site's cell.");
    svg_panel(&page, box, SITES, caption);
    draw_shape(&page, &cell, SVG_NEW);
    draw_diagram(&page, &g, points, box, SVG_PLAIN);
    svg_points(&page, points, SITES, SVG_PLAIN);
    for (vertex_id p = start;
         p != end;) { /* one step: p and its neighbours only */
        vertex_id next = p;
        halfedge_id e = mesh_leaving(&g.m, p);
        do {
            vertex_id q = mesh_dest(&g.m, e);
            if (q < SITES &&
                hypot(points[q].x - x.x, points[q].y - x.y) <
                    hypot(points[next].x - x.x, points[next].y - x.y))
                next = q;
            e = mesh_around(&g.m, e);
        } while (e != mesh_leaving(&g.m, p));
        svg_arrow(&page, points[p], points[next], SVG_STRONG);
        p = next;
    }
    svg_points(&page, &x, 1, SVG_BAD);
    svg_label(&page, x, "x", SVG_BAD);
    svg_end(&page);
    discard(&g);
}

static void
draw_sibson(FILE *file)
{
    static const point2 points[] = {{3.2, 2.6}, {1, 1},     {4.4, 0.6},
                                    {6, 2.8},   {4.2, 4.8}, {1.2, 4.2},
                                    {-1, 2.6},  {7.4, 5.6}, {7.2, -0.4}};
    enum { SITES = sizeof points / sizeof *points };
    svg_box box = {{-1.2, -0.6}, {7.6, 5.8}};
    diagram with = build(points, SITES), without = build(points + 1, SITES - 1);
    uint32_t first = with.d.cell_first[0], size = with.d.cell_first[1] - first;
    double weight[MOST_CORNERS];
    must(sibson_coordinates(&with.d, points, 0, weight), "sibson_coordinates");
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 340, 290, 1},
        "Sibson's local coordinates",
        "Left: the cells without site p. Right: the cell of p takes a piece "
        "from "
        "each neighbour; its share of the area is that neighbour's weight.");
    svg_panel(&page, box, SITES, "before p comes");
    draw_diagram(&page, &without, points + 1, box, SVG_PLAIN);
    svg_points(&page, points + 1, SITES - 1, SVG_PLAIN);
    svg_points(&page, points, 1, SVG_FAINT);
    svg_panel(&page, box, SITES, "p takes these shares");
    for (uint32_t i = 0; i < size; i++) {
        vertex_id q = voronoi_beyond(&with.d, with.d.cell_edge[first + i], 0);
        shape piece = cell_in_box(&with, points, box, 0);
        for (uint32_t k = 0; k < size; k++) {
            vertex_id r =
                voronoi_beyond(&with.d, with.d.cell_edge[first + k], 0);
            if (r != q)
                cut_shape(&piece, points[q], points[r]);
        }
        bool odd_one_out = i == size - 1 && size % 2 == 1; /* beside the first */
        draw_shape(&page, &piece,
                   odd_one_out ? SVG_GOOD : i % 2 == 0 ? SVG_NEW : SVG_PLAIN);
    }
    draw_diagram(&page, &without, points + 1, box, SVG_FAINT);
    draw_diagram(&page, &with, points, box, SVG_STRONG);
    svg_points(&page, points, SITES, SVG_PLAIN);
    svg_label(&page, points[0], "p", SVG_PLAIN);
    for (uint32_t i = 0; i < size; i++) {
        char share[16];
        vertex_id q = voronoi_beyond(&with.d, with.d.cell_edge[first + i], 0);
        snprintf(share, sizeof share, "%.3f", weight[i]);
        svg_label(&page, points[q], share, SVG_PLAIN);
    }
    svg_end(&page);
    discard(&with);
    discard(&without);
}

/* Two triangles of four sites: 012 and 023, or 013 and 123. */
static void
draw_two_triangles(svg *page, const point2 *p, bool with_02, const char *caption)
{
    vertex_id one[2][3] = {{0, 1, 2}, {0, 2, 3}}, two[2][3] = {{0, 1, 3}, {1, 2, 3}};
    svg_panel(page, wider(svg_box_of(p, 4), 0.6), 4, caption);
    svg_triangles(page, p, (triangle_list){2, with_02 ? one : two}, SVG_PLAIN);
    svg_segment(page, p[with_02 ? 0 : 1], p[with_02 ? 2 : 3], SVG_NEW);
    svg_points(page, p, 4, SVG_PLAIN);
    svg_label_points(page, p, 4);
}

/* P17 to P19 of the page. */
static void
draw_survey(FILE *file)
{
    static const point2 angle[] = {{0, 0}, {2, 0}, {3, 1}, {0, 5}};
    static const point2 length[] = {{0, 0}, {4, 1}, {5, 4}, {5, 5}};
    static const point2 acute[] = {{0, 0}, {4, 0}, {5.5, 3.5}, {2, 3}, {-1.5, 3.5},
                                   {2, 6.5}};
    vertex_id corner[][3] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {2, 5, 3}, {3, 5, 4}};
    triangle_list list = {sizeof corner / sizeof corner[0], corner};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 2, 240, 210, 2},
              "What the Delaunay triangulation is not, and what it is",
              "Four sites whose Delaunay triangulation has an angle of 135 degrees; "
              "with the other diagonal the largest is 98. Four sites whose Delaunay "
              "diagonal is the longer one. A triangulation without obtuse angles, "
              "whose circles are empty.");
    draw_two_triangles(&page, angle, true, "Delaunay:\nan angle of 135 degrees");
    svg_angle(&page, angle[1], angle[2], angle[0], "135", SVG_BAD);
    draw_two_triangles(&page, angle, false, "not Delaunay:\nthe largest angle is 98");
    svg_angle(&page, angle[2], angle[3], angle[1], "98", SVG_GOOD);
    svg_panel(&page, wider(svg_box_of(acute, 6), 0.6), 6,
              "no obtuse angle:\nall circles are empty");
    for (uint32_t t = 0; t < list.count; t++)
        svg_circle(&page, acute[corner[t][0]], acute[corner[t][1]],
                   acute[corner[t][2]], SVG_FAINT);
    svg_triangles(&page, acute, list, SVG_PLAIN);
    svg_points(&page, acute, 6, SVG_PLAIN);
    draw_two_triangles(&page, length, true, "Delaunay:\nthe longer diagonal, 6.4");
    draw_two_triangles(&page, length, false, "not Delaunay:\nthe shorter one, 4.1");
    svg_end(&page);
}

static const figure figures[] = {
    {"fig4_pattern", draw_pattern},  {"fig5_eight_sites", draw_eight_sites},
    {"fig6_dual", draw_dual},        {"half_planes", draw_half_planes},
    {"degenerate", draw_degenerate}, {"ambiguity", draw_ambiguity},
    {"perturbed", draw_perturbed},   {"walk", draw_walk},
    {"sibson", draw_sibson},         {"survey", draw_survey},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
