/* figures.c - the pictures of section 2.2. The trees, the walks and the numbers in the
 * captions come from the code; only how far curves swing out is chosen by eye.
 */
#include "chapters/2.2_eulers_formula/euler.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/figures.h"
#include "lib/svg.h"

/* ---- Pieces of pictures. ---- */

static point2
middle(point2 a, point2 b)
{
    return (point2){(a.x + b.x) / 2, (a.y + b.y) / 2};
}

static svg_box
wider(svg_box box, double by)
{
    return (svg_box){{box.min.x - by, box.min.y - by},
                     {box.max.x + by, box.max.y + by}};
}

/* The cubic curve from a to b that sets out towards c and arrives from d. */
static void
draw_curve(svg *page, point2 a, point2 c, point2 d, point2 b, svg_style style)
{
    enum { PIECES = 48 };
    point2 last = a;
    for (int i = 1; i <= PIECES; i++) {
        double t = (double)i / PIECES, s = 1 - t;
        double wa = s * s * s, wc = 3 * s * s * t, wd = 3 * s * t * t, wb = t * t * t;
        point2 p = {wa * a.x + wc * c.x + wd * d.x + wb * b.x,
                    wa * a.y + wc * c.y + wd * d.y + wb * b.y};
        svg_segment(page, last, p, style);
        last = p;
    }
}

static void
draw_edge(svg *page, const plane_graph *g, const point2 *points, uint32_t k,
          svg_style style)
{
    svg_segment(page, points[g->origin[2 * k]], points[g->origin[2 * k + 1]], style);
}

static void
draw_edges(svg *page, const plane_graph *g, const point2 *points, svg_style style)
{
    for (uint32_t k = 0; k < g->edges; k++)
        draw_edge(page, g, points, k, style);
}

/* The mean of the corners that the walk of h passes. */
static point2
face_centre(const plane_graph *g, const point2 *points, halfedge_id h)
{
    point2 sum = {0, 0};
    double corners = 0;
    halfedge_id s = h;
    do {
        sum.x += points[g->origin[s]].x;
        sum.y += points[g->origin[s]].y;
        corners++;
        s = g->next[s];
    } while (s != h);
    return (point2){sum.x / corners, sum.y / corners};
}

static plane_graph
drawing(const point2 *points, uint32_t n, const edge_ends *edge, uint32_t edges)
{
    plane_graph g;
    must(graph_from_drawing(points, n, edge, edges, &g), "graph_from_drawing");
    return g;
}

static euler_counts
counts_of(const plane_graph *g)
{
    euler_counts c;
    must(euler_count(g, &c), "euler_count");
    return c;
}

/* ---- Figure 2: the two trees. ---- */

enum { TREES_POINTS = 13, MOST_EDGES = 3 * TREES_POINTS };

static const point2 trees_points[TREES_POINTS] = {
    {0.3, 2.1}, {1.4, 0.4}, {3.6, 0.2}, {5.6, 1.1}, {6.0, 3.0}, {4.5, 4.6}, {2.2, 4.7},
    {1.9, 2.9}, {2.9, 1.5}, {4.3, 2.0}, {3.5, 3.3}, {0.8, 3.8}, {4.9, 3.1}};

/* The triangulation, which edges are in which tree, and where the faces are. The outer
 * face is drawn as a frame. */
typedef struct two_trees {
    plane_graph g;
    edge_part part[MOST_EDGES];
    face_id left[2 * MOST_EDGES];
    svg_box frame;
} two_trees;

static two_trees
make_trees(void)
{
    two_trees t;
    mesh m;
    must(lawson_triangulate(trees_points, TREES_POINTS, NULL, &m),
         "lawson_triangulate");
    must(graph_from_mesh(&m, &t.g), "graph_from_mesh");
    must(tree_and_cotree(&t.g, t.part), "tree_and_cotree");
    graph_trace_faces(&t.g, t.left);
    t.frame = wider(svg_box_of(trees_points, TREES_POINTS), 0.6);
    mesh_free(&m);
    return t;
}

/* Where the way from p in this direction meets the frame. */
static point2
meet_frame(svg_box frame, point2 p, point2 direction)
{
    double x = direction.x > 0 ? frame.max.x - p.x : frame.min.x - p.x;
    double y = direction.y > 0 ? frame.max.y - p.y : frame.min.y - p.y;
    double along_x = direction.x != 0 ? x / direction.x : 1e9;
    double along_y = direction.y != 0 ? y / direction.y : 1e9;
    double t = along_x < along_y ? along_x : along_y;
    return (point2){p.x + t * direction.x, p.y + t * direction.y};
}

/* Half of the dual edge across h: from the middle of h into the face left of it. */
static void
draw_half_of_dual_edge(svg *page, const two_trees *t, halfedge_id h)
{
    point2 a = trees_points[t->g.origin[h]], b = trees_points[graph_dest(&t->g, h)];
    point2 from = middle(a, b), to;
    if (t->left[h] == t->left[t->g.outside])
        to = meet_frame(t->frame, from, (point2){a.y - b.y, b.x - a.x});
    else
        to = face_centre(&t->g, trees_points, h);
    svg_segment(page, from, to, SVG_NEW);
}

static void
draw_tree(svg *page, const two_trees *t)
{
    for (uint32_t k = 0; k < t->g.edges; k++)
        if (t->part[k] == IN_TREE)
            draw_edge(page, &t->g, trees_points, k, SVG_STRONG);
    svg_points(page, trees_points, TREES_POINTS, SVG_PLAIN);
}

static void
draw_frame(svg *page, svg_box frame)
{
    point2 corner[] = {frame.min, {frame.max.x, frame.min.y}, frame.max,
                       {frame.min.x, frame.max.y}};
    for (int i = 0; i < 4; i++)
        svg_segment(page, corner[i], corner[(i + 1) % 4], SVG_NEW);
}

static void
draw_cotree(svg *page, const two_trees *t)
{
    draw_frame(page, t->frame);
    for (uint32_t k = 0; k < t->g.edges; k++)
        if (t->part[k] == IN_COTREE) {
            draw_half_of_dual_edge(page, t, 2 * k);
            draw_half_of_dual_edge(page, t, 2 * k + 1);
        }
    for (halfedge_id h = 0; h < 2 * t->g.edges; h++)
        if (t->left[h] != t->left[t->g.outside]) {
            point2 centre = face_centre(&t->g, trees_points, h);
            svg_points(page, &centre, 1, SVG_NEW);
        }
}

static uint32_t
count_part(const two_trees *t, edge_part part)
{
    uint32_t edges = 0;
    for (uint32_t k = 0; k < t->g.edges; k++)
        edges += t->part[k] == part;
    return edges;
}

static void
draw_trees(FILE *file)
{
    two_trees t = make_trees();
    euler_counts c = counts_of(&t.g);
    uint32_t tree = count_part(&t, IN_TREE), cotree = count_part(&t, IN_COTREE);
    svg_box box = wider(t.frame, 0.2);
    char caption[96];
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 270, 230, 2}, "Figure 2, executed",
        "Left, a triangulation of thirteen points with a spanning tree of thick "
        "edges. Middle, the dual edges that cross the other edges; they join a dot "
        "in each triangle to each other and to the frame, which stands for the outer "
        "face. Right, both: the trees wind around each other and never cross.");
    snprintf(caption, sizeof caption, "T: %u vertices,\n%u edges", (unsigned)c.v,
             (unsigned)tree);
    svg_panel(&page, box, TREES_POINTS, caption);
    draw_edges(&page, &t.g, trees_points, SVG_PLAIN);
    draw_tree(&page, &t);

    snprintf(caption, sizeof caption,
             "(G-T)*: %u faces, the frame\none of them, %u edges", (unsigned)c.f,
             (unsigned)cotree);
    svg_panel(&page, box, TREES_POINTS, caption);
    draw_edges(&page, &t.g, trees_points, SVG_FAINT);
    draw_cotree(&page, &t);

    snprintf(caption, sizeof caption, "every edge once:\n%u + %u = %u", (unsigned)tree,
             (unsigned)cotree, (unsigned)c.e);
    svg_panel(&page, box, TREES_POINTS, caption);
    draw_edges(&page, &t.g, trees_points, SVG_FAINT);
    draw_cotree(&page, &t);
    draw_tree(&page, &t);
    svg_end(&page);
    graph_free(&t.g);
}

/* ---- Walking around faces. ---- */

/* Arrows along the walk of h, numbered in its order. */
static void
draw_walk(svg *page, const plane_graph *g, const point2 *points, halfedge_id h,
          svg_style style)
{
    uint32_t step = 1;
    halfedge_id s = h;
    do {
        char name[16];
        snprintf(name, sizeof name, "%u", (unsigned)step++);
        svg_halfedge(page, points[g->origin[s]], points[graph_dest(g, s)], name, style);
        s = g->next[s];
    } while (s != h);
}

static void
draw_walks(FILE *file)
{
    const point2 points[] = {{0, 0}, {4, 0}, {4.4, 3}, {0.4, 3}, {2, 1.6}, {6, 1.5}};
    const edge_ends edge[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}};
    plane_graph g = drawing(points, 6, edge, 6);
    euler_counts c = counts_of(&g);
    halfedge_id inside = 0; /* of 0 1: the square is on its left */
    svg_box box = wider(svg_box_of(points, 6), 0.6);
    char caption[96];
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 380, 230, 1}, "Faces are walks",
        "A quadrilateral with one dead end inside and one outside. Left, the walk "
        "around the inner face; right, the walk around the outer face. Each walk "
        "passes its dead end on both sides.");
    svg_panel(&page, box, 6, "the inner face on one's left: 6 steps");
    draw_edges(&page, &g, points, SVG_PLAIN);
    draw_walk(&page, &g, points, inside, SVG_NEW);
    svg_points(&page, points, 6, SVG_PLAIN);
    snprintf(caption, sizeof caption, "the outer face: h = %u;  %u - %u + %u = 2",
             (unsigned)c.h, (unsigned)c.v, (unsigned)c.e, (unsigned)c.f);
    svg_panel(&page, box, 6, caption);
    draw_edges(&page, &g, points, SVG_PLAIN);
    draw_walk(&page, &g, points, g.outside, SVG_NEW);
    svg_points(&page, points, 6, SVG_PLAIN);
    svg_end(&page);
    graph_free(&g);
}

/* ---- K4 and K5. ---- */

static void
draw_complete(FILE *file)
{
    const point2 square[] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
    const point2 points[] = {{0, 0}, {4, 0}, {2, 3.4}, {2, 1.25}, {2.4, 0.45}};
    const edge_ends edge[] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3},
                              {0, 4}, {1, 4}, {3, 4}}; /* K4, then to 4; 2 4 is left */
    plane_graph k4 = drawing(points, 4, edge, 6), k5 = drawing(points, 5, edge, 9);
    euler_counts c4 = counts_of(&k4), c5 = counts_of(&k5);
    char caption[96];
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 250, 230, 2}, "K4 is planar, K5 is not",
              "Left, K4 as a square with two diagonals that cross. Middle, K4 as a "
              "triangle with the fourth vertex inside. Right, K5 without one edge: all "
              "faces are triangles, and the tenth edge has to cross another.");
    svg_panel(&page, wider(svg_box_of(square, 4), 0.4), 4, "K4, drawn with a crossing");
    draw_edges(&page, &k4, square, SVG_PLAIN);
    svg_points(&page, square, 4, SVG_PLAIN);
    svg_label_points(&page, square, 4);

    snprintf(caption, sizeof caption, "K4, drawn without:\n%u - %u + %u = 2",
             (unsigned)c4.v, (unsigned)c4.e, (unsigned)c4.f);
    svg_panel(&page, wider(svg_box_of(points, 4), 0.4), 4, caption);
    draw_edges(&page, &k4, points, SVG_PLAIN);
    svg_points(&page, points, 4, SVG_PLAIN);
    svg_label_points(&page, points, 4);

    snprintf(caption, sizeof caption,
             "K5 but one edge: e = %u = 3v-6,\nand 2 4 must cross", (unsigned)c5.e);
    svg_panel(&page, wider(svg_box_of(points, 5), 0.4), 5, caption);
    svg_segment(&page, points[2], points[4], SVG_BAD);
    draw_edges(&page, &k5, points, SVG_PLAIN);
    svg_points(&page, points, 5, SVG_PLAIN);
    svg_label_points(&page, points, 5);
    svg_end(&page);
    graph_free(&k4);
    graph_free(&k5);
}

/* ---- Duals that are not simple (E4). ---- */

static void
draw_duals(FILE *file)
{
    const point2 k2[] = {{0, 0}, {3, 0}}, outer2 = {1.5, 1.5};
    const point2 triangle[] = {{0, 0}, {3, 0}, {1.5, 2.6}}, inner = {1.5, 0.9};
    const point2 outer3 = {4.6, 1.3};
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 330, 240, 2},
        "Duals with loops and parallel edges",
        "Left, a single edge has the same face on both sides: the "
        "dual is one vertex with a loop. Right, the two faces of a triangle share "
        "three edges: the dual is two vertices with three parallel edges.");
    svg_panel(&page, (svg_box){{-0.7, -1.6}, {5, 2.1}}, 4,
              "K2: one face, and the dual edge\nis a loop");
    svg_segment(&page, k2[0], k2[1], SVG_STRONG);
    draw_curve(&page, outer2, (point2){1.2, -4}, (point2){7, -0.4}, outer2, SVG_NEW);
    svg_points(&page, k2, 2, SVG_PLAIN);
    svg_points(&page, &outer2, 1, SVG_NEW);

    svg_panel(&page, (svg_box){{-0.9, -1.2}, {5.1, 3.6}}, 5,
              "a triangle: two faces, and three\ndual edges join them");
    for (int i = 0; i < 3; i++)
        svg_segment(&page, triangle[i], triangle[(i + 1) % 3], SVG_STRONG);
    draw_curve(&page, inner, (point2){1.5, -1.7}, (point2){3.6, -1}, outer3, SVG_NEW);
    draw_curve(&page, inner, (point2){2.4, 1.5}, (point2){3.6, 1.6}, outer3, SVG_NEW);
    draw_curve(&page, inner, (point2){-2.4, 3.2}, (point2){3.4, 5.2}, outer3, SVG_NEW);
    svg_points(&page, triangle, 3, SVG_PLAIN);
    svg_points(&page, &inner, 1, SVG_NEW);
    svg_points(&page, &outer3, 1, SVG_NEW);
    svg_end(&page);
}

/* ---- Maximal among straight-line graphs only (E6). ---- */

static void
draw_maximal(FILE *file)
{
    const point2 square[] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
    const edge_ends edge[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
    plane_graph g = drawing(square, 4, edge, 5);
    euler_counts c = counts_of(&g);
    svg_box box = {{-0.6, -0.6}, {5, 5}};
    char caption[96];
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 280, 240, 2}, "Maximal, but not maximal "
              "planar", "Left, a square with one diagonal: the other diagonal crosses "
              "it. Right, the same two vertices joined by a curve around the outside.");
    snprintf(caption, sizeof caption,
             "e = %u, h = %u, and no other\nstraight edge fits", (unsigned)c.e,
             (unsigned)c.h);
    svg_panel(&page, box, 4, caption);
    svg_segment(&page, square[1], square[3], SVG_BAD);
    draw_edges(&page, &g, square, SVG_PLAIN);
    svg_points(&page, square, 4, SVG_PLAIN);
    svg_label_points(&page, square, 4);
    snprintf(caption, sizeof caption, "a curve does: e = %u = 3v-6", (unsigned)c.e + 1);
    svg_panel(&page, box, 4, caption);
    draw_edges(&page, &g, square, SVG_PLAIN);
    draw_curve(&page, square[1], (point2){7, 2}, (point2){2, 7}, square[3], SVG_GOOD);
    svg_points(&page, square, 4, SVG_PLAIN);
    svg_label_points(&page, square, 4);
    svg_end(&page);
    graph_free(&g);
}

static const figure figures[] = {
    {"fig2_trees", draw_trees},
    {"walks", draw_walks},
    {"k4_k5", draw_complete},
    {"duals", draw_duals},
    {"maximal", draw_maximal},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures, sizeof figures / sizeof figures[0]);
}
