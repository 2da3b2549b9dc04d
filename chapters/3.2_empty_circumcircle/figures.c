/* figures.c - the pictures of section 3.2. What is drawn is what the code
 * finds: circles are empty, graphs have the edges and trees the lengths that
 * captions say, because the functions of this section said so.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"

#include <math.h>

/* ---- Pieces of pictures. ---- */

/* The circle around `centre` through p. */
static void
draw_circle_around(svg *page, point2 centre, point2 p, svg_style style)
{
    double x = p.x - centre.x, y = p.y - centre.y;
    svg_circle(page, p, (point2){centre.x - y, centre.y + x},
               (point2){centre.x - x, centre.y - y}, style);
}

/* The circle with diameter pq. */
static void
draw_diametral_circle(svg *page, point2 p, point2 q, svg_style style)
{
    draw_circle_around(page, (point2){(p.x + q.x) / 2, (p.y + q.y) / 2}, p,
                       style);
}

/* The two circles whose common part is the lune of pq. */
static void
draw_lune(svg *page, point2 p, point2 q, svg_style style)
{
    draw_circle_around(page, p, q, style);
    draw_circle_around(page, q, p, style);
}

static void
draw_edges(svg *page, const point2 *points, edge_list list, svg_style style)
{
    for (uint32_t i = 0; i < list.count; i++)
        svg_segment(page, points[list.ends[i][0]], points[list.ends[i][1]],
                    style);
}

static void
draw_triangle_of(svg *page, const point2 *points, const vertex_id *c,
                 svg_style style)
{
    svg_triangle(page, points[c[0]], points[c[1]], points[c[2]], style);
}

static mesh
delaunay_mesh(const point2 *points, uint32_t n)
{
    mesh m;
    must(lawson_triangulate(points, n, NULL, &m), "lawson_triangulate");
    return m;
}

/* ---- Definition 7: triangles and edges with an empty circle. ---- */

static void
draw_definition(FILE *file)
{
    const point2 points[] = {{0.3, 0.4}, {3.8, 0.2}, {2.4, 2.9},
                             {0.2, 3.2}, {4.6, 2.6}, {2.2, 4.4}};
    enum { N = sizeof points / sizeof points[0] };
    const vertex_id corner[][3] = {{0, 1, 2}, {0, 1, 5}};
    svg_box box = {{-0.7, -1.1}, {5.1, 4.9}};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 230, 250, 2},
              "Definition 7: simplices with an empty circle, and without",
              "Six sites. The circle of a first triangle has no site inside; "
              "that of a second one has. Of an edge's circles one suffices: "
              "some through its ends have sites inside, one has none.");
    for (int i = 0; i < 2; i++) {
        const vertex_id *c = corner[i];
        bool empty = has_empty_circle(points, N, c[0], c[1], c[2]);
        char caption[80];
        snprintf(caption, sizeof caption,
                 empty ? "%u %u %u is Delaunay:\nits circle is empty"
                       : "%u %u %u is not Delaunay:\nits circle is not empty",
                 (unsigned)c[0], (unsigned)c[1], (unsigned)c[2]);
        svg_panel(&page, box, N, caption);
        draw_triangle_of(&page, points, c, empty ? SVG_GOOD : SVG_BAD);
        svg_circle(&page, points[c[0]], points[c[1]], points[c[2]],
                   empty ? SVG_GOOD : SVG_BAD);
        svg_points(&page, points, N, SVG_PLAIN);
        svg_label_points(&page, points, N);
    }
    bool edge = is_delaunay_edge(points, N, 2, 3);
    svg_panel(&page, box, N,
              edge ? "2 3 is Delaunay: it has\nan empty circle, too"
                   : "2 3 is not Delaunay");
    for (vertex_id c = 0; c < N; c++)
        if (c != 2 && c != 3)
            svg_circle(&page, points[2], points[3], points[c],
                       has_empty_circle(points, N, 2, 3, c) ||
                               has_empty_circle(points, N, 3, 2, c)
                           ? SVG_GOOD
                           : SVG_FAINT);
    svg_segment(&page, points[2], points[3], edge ? SVG_GOOD : SVG_BAD);
    svg_points(&page, points, N, SVG_PLAIN);
    svg_label_points(&page, points, N);
    svg_end(&page);
}

/* ---- Cocircular sites (E21, E22). ---- */

static void
draw_square(FILE *file)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    svg_box box = {{-0.35, -0.35}, {1.35, 1.35}};
    triangle_list list;
    must(delaunay_triangles(square, 4, &list), "delaunay_triangles");
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 170, 170, 1},
              "The four Delaunay triangles of the unit square",
              "Four times the corners of a square, each time with another "
              "triangle of three of them. All four have the same circle, and "
              "no site is inside it.");
    for (uint32_t t = 0; t < list.count; t++) {
        const vertex_id *c = list.corner[t];
        char caption[40];
        snprintf(caption, sizeof caption, "%u %u %u: empty", (unsigned)c[0],
                 (unsigned)c[1], (unsigned)c[2]);
        svg_panel(&page, box, 4, caption);
        draw_triangle_of(&page, square, c, SVG_NEW);
        svg_circle(&page, square[c[0]], square[c[1]], square[c[2]], SVG_GOOD);
        svg_points(&page, square, 4, SVG_PLAIN);
        svg_label_points(&page, square, 4);
    }
    svg_end(&page);
    triangle_list_free(&list);
}

/* The sides of the cells. */
static void
draw_cells(svg *page, const point2 *points, const subdivision *s,
           svg_style style)
{
    for (uint32_t i = 0; i < s->cells; i++)
        for (uint32_t k = s->first[i]; k < s->first[i + 1]; k++) {
            uint32_t next = k + 1 < s->first[i + 1] ? k + 1 : s->first[i];
            svg_segment(page, points[s->vertex[k]], points[s->vertex[next]],
                        style);
        }
}

static void
draw_subdivision(FILE *file)
{
    /* Six sites on the circle of radius 5, and others outside. */
    const point2 points[] = {{5, 0},  {3, 4},   {-3, 4}, {-5, 0},
                             {0, -5}, {4, -3},  {-8, 5}, {8, 6},
                             {9, -4}, {-7, -6}, {2, 8},  {3, -8}};
    enum { N = sizeof points / sizeof points[0] };
    svg_box box = svg_box_of(points, N);
    triangle_list list;
    subdivision s;
    mesh m;
    must(delaunay_triangles(points, N, &list), "delaunay_triangles");
    must(brute_triangulate(points, N, NULL, &m), "brute_triangulate");
    must(delaunay_subdivision(&m, points, &s), "delaunay_subdivision");
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 250, 220, 2},
              "Overlapping Delaunay triangles, the subdivision, the fans",
              "Twelve sites, six of them on one empty circle. All triangles "
              "among these six are Delaunay, and overlap. Without the edges "
              "that cross, a hexagon is left. A fan from its lowest index "
              "triangulates it.");
    char caption[3][80];
    snprintf(caption[0], sizeof caption[0],
             "%u Delaunay triangles:\nthey overlap", (unsigned)list.count);
    snprintf(caption[1], sizeof caption[1],
             "without crossing edges:\n%u cells, the subdivision",
             (unsigned)s.cells);
    snprintf(caption[2], sizeof caption[2],
             "a fan in each cell:\na triangulation");
    for (int i = 0; i < 3; i++) {
        svg_panel(&page, box, N, caption[i]);
        svg_circle(&page, points[0], points[1], points[2], SVG_GOOD);
        if (i == 0)
            svg_triangles(&page, points, list, SVG_PLAIN);
        else if (i == 2)
            svg_mesh(&page, points, &m);
        draw_cells(&page, points, &s, i == 1 ? SVG_STRONG : SVG_PLAIN);
        svg_points(&page, points, N, SVG_PLAIN);
        svg_label_points(&page, points, N);
    }
    svg_end(&page);
    subdivision_free(&s);
    triangle_list_free(&list);
    mesh_free(&m);
}

/* ---- The chain of graphs. ---- */

static void
draw_chain(FILE *file)
{
    enum { N = 70, GRAPHS = 5 };
    point2 points[N];
    random_source source = random_from_seed(1980);
    for (int i = 0; i < N; i++)
        points[i] = random_point(&source);
    const char *const name[GRAPHS] = {
        "Delaunay", "Gabriel", "relative neighbours", "minimum spanning tree",
        "nearest neighbours"};
    mesh m = delaunay_mesh(points, N);
    edge_list list[GRAPHS];
    must(mesh_edges(&m, NULL, &list[0]), "mesh_edges");
    must(gabriel_graph(&m, points, &list[1]), "gabriel_graph");
    must(relative_neighbourhood_graph(&m, points, &list[2]), "rng");
    must(emst(&m, points, &list[3]), "emst");
    must(nearest_neighbour_graph(&m, points, &list[4]), "nng");
    svg page;
    svg_begin(&page, file, (svg_layout){3, 2, 250, 250, 1},
              "Five graphs on the same sites, each inside an earlier one",
              "Seventy random sites. The Delaunay triangulation; the Gabriel "
              "graph, which has fewer of its edges; the relative "
              "neighbourhood graph, with fewer again; and two graphs inside "
              "that: the minimum spanning tree, and the graph of nearest "
              "neighbours, which falls into pieces.");
    for (int i = 0; i < GRAPHS; i++) {
        char caption[80];
        snprintf(caption, sizeof caption, "%s: %u edges", name[i],
                 (unsigned)list[i].count);
        svg_panel(&page, svg_box_of(points, N), N, caption);
        if (i > 0)
            draw_edges(&page, points, list[0], SVG_FAINT);
        draw_edges(&page, points, list[i], i == 0 ? SVG_PLAIN : SVG_STRONG);
        svg_points(&page, points, N, SVG_PLAIN);
    }
    svg_end(&page);
    for (int i = 0; i < GRAPHS; i++)
        edge_list_free(&list[i]);
    mesh_free(&m);
}

/* ---- Theorem 2. ---- */

static void
draw_theorem(FILE *file)
{
    enum { P, Q, R, N = 9 };
    const point2 points[N] = {{1.5, 2},   {5.5, 2},   {2.6, 3},
                              {0.2, 3.1}, {-0.3, 1},  {3.4, 4.6},
                              {7.2, 3.1}, {7.6, 0.9}, {5.9, 0.2}};
    const vertex_id tree[][2] = {{P, 3}, {3, 4}, {R, 5}, {P, R},
                                 {Q, 6}, {6, 7}, {Q, 8}};
    svg_box box = {{-0.6, -0.6}, {8, 5}};
    svg page;
    svg_begin(
        &page, file, (svg_layout){3, 1, 250, 210, 2},
        "Theorem 2: a shorter tree, if a site lies in the disc of an edge",
        "A site r in the disc with diameter pq lies in the lune: it is "
        "nearer to p and to q than these are to each other. If a tree "
        "has the edge pq, it falls into two parts without it, and the "
        "edge from r to q joins them again, and is shorter.");
    const char *const caption[] = {"r in the disc of pq\nis also in the lune",
                                   "a tree with pq, and\nits two parts without",
                                   "rq joins them again,\nand is shorter"};
    for (int i = 0; i < 3; i++) {
        svg_panel(&page, box, N, caption[i]);
        if (i == 0) {
            draw_lune(&page, points[P], points[Q], SVG_FAINT);
            draw_diametral_circle(&page, points[P], points[Q], SVG_GOOD);
            svg_segment(&page, points[P], points[Q], SVG_STRONG);
            svg_segment(&page, points[P], points[R], SVG_NEW);
            svg_segment(&page, points[R], points[Q], SVG_NEW);
        } else {
            svg_segment(&page, points[P], points[Q], SVG_BAD);
            for (uint32_t k = 0; k < sizeof tree / sizeof tree[0]; k++)
                svg_segment(&page, points[tree[k][0]], points[tree[k][1]],
                            SVG_STRONG);
            if (i == 2)
                svg_segment(&page, points[R], points[Q], SVG_NEW);
        }
        svg_points(&page, points, i == 0 ? 3 : N, SVG_PLAIN);
        svg_label(&page, points[P], "p", SVG_STRONG);
        svg_label(&page, points[Q], "q", SVG_STRONG);
        svg_label(&page, points[R], "r", SVG_STRONG);
    }
    svg_end(&page);
}

/* ---- Gabriel: the closed disc, not the open one (E24). ---- */

static void
draw_open_closed(FILE *file)
{
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    svg_box box = {{-0.35, -0.35}, {1.35, 1.35}};
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 260, 260, 2},
              "With open discs the Gabriel graph of a square is not planar",
              "The unit square twice. A diagonal's circle passes through the "
              "other two corners: if sites on the circle do no harm, both "
              "diagonals are edges, and cross. If they do, four edges are "
              "left.");
    for (int closed = 0; closed < 2; closed++) {
        svg_panel(&page, box, 4,
                  closed ? "closed discs: 4 edges"
                         : "open discs: the diagonals\nare edges, and cross");
        draw_diametral_circle(&page, square[0], square[2], SVG_FAINT);
        for (vertex_id v = 0; v < 4; v++)
            for (vertex_id w = 0; w < v; w++) {
                int least = +1; /* of the other two corners, the innermost */
                for (vertex_id z = 0; z < 4; z++)
                    if (z != v && z != w)
                        least = (int)fmin(
                            least, dot_sign(square[v], square[z], square[w]));
                if (least > 0 || (!closed && least == 0))
                    svg_segment(&page, square[v], square[w],
                                least > 0 ? SVG_STRONG : SVG_BAD);
            }
        svg_points(&page, square, 4, SVG_PLAIN);
        svg_label_points(&page, square, 4);
    }
    svg_end(&page);
}

/* ---- An elimination path. ---- */

static void
draw_path(FILE *file)
{
    const point2 points[] = {{7, 0}, {6, 7}, {5, 0}, {2, 5}, {1, 3}};
    const vertex_id path[][2] = {{2, 3}, {1, 2}, {0, 1}};
    const vertex_id z = 4;
    svg_box box = {{-0.5, -1}, {9, 8}};
    mesh m = delaunay_mesh(points, 5);
    edge_list rng;
    must(relative_neighbourhood_graph(&m, points, &rng), "rng");
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 190, 200, 1},
              "An elimination path",
              "Five sites. Site 4 lies in the lune of the edge 2 3 of its own "
              "triangle, then in the lune of 1 2 behind it, then in that of "
              "0 1, although it is joined to neither of its ends. At last the "
              "relative neighbourhood graph, without these three edges.");
    for (int i = 0; i < 4; i++) {
        char caption[60] = "what is left";
        point2 p = {0, 0}, q = {0, 0};
        if (i < 3) {
            p = points[path[i][0]];
            q = points[path[i][1]];
            bool inside = compare_distance(p, points[z], p, q) < 0 &&
                          compare_distance(q, points[z], p, q) < 0;
            snprintf(caption, sizeof caption, "4 is %sin the lune of %u %u",
                     inside ? "" : "not ", (unsigned)path[i][0],
                     (unsigned)path[i][1]);
        }
        svg_panel(&page, box, 5, caption);
        if (i < 3) {
            draw_lune(&page, p, q, SVG_FAINT);
            svg_mesh(&page, points, &m);
            svg_segment(&page, p, q, SVG_BAD);
        } else {
            draw_edges(&page, points, rng, SVG_STRONG);
        }
        svg_points(&page, points, 5, SVG_PLAIN);
        svg_points(&page, &points[z], 1, SVG_NEW);
        svg_label_points(&page, points, 5);
    }
    svg_end(&page);
    edge_list_free(&rng);
    mesh_free(&m);
}

/* ---- The shortest triangulation is another one. ---- */

static double
total_length(const mesh *m, const point2 *points)
{
    double total = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        vertex_id v = mesh_origin(m, e), w = mesh_dest(m, e);
        if (v < w && w != GHOST)
            total +=
                hypot(points[v].x - points[w].x, points[v].y - points[w].y);
    }
    return total;
}

/* Flips any edge that becomes shorter, until there is none. */
static void
shorten(mesh *m, const point2 *points)
{
    for (bool again = true; again;) {
        again = false;
        for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
            if (!is_flippable(m, points, e))
                continue;
            point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
            point2 c = points[mesh_apex(m, e)];
            point2 d = points[mesh_apex(m, mesh_twin(m, e))];
            if (compare_distance(c, d, a, b) < 0) {
                flip(m, e);
                again = true;
            }
        }
    }
}

/* Of the four-point sets of a grid, not cocircular, the one whose Delaunay
 * triangulation exceeds the shortest one by the largest part. Four points have
 * at most two triangulations, a flip apart. */
static void
search_four_points(point2 best[4])
{
    enum { SIDE = 5, CELLS = SIDE * SIDE };
    double worst = 1;
    for (int a = 0; a < CELLS; a++)
        for (int b = a + 1; b < CELLS; b++)
            for (int c = b + 1; c < CELLS; c++)
                for (int d = c + 1; d < CELLS; d++) {
                    const int cell[4] = {a, b, c, d};
                    point2 p[4];
                    for (int i = 0; i < 4; i++)
                        p[i] = (point2){cell[i] % SIDE, cell[i] / SIDE};
                    if (incircle(p[0], p[1], p[2], p[3]) == 0)
                        continue; /* both may be Delaunay */
                    mesh m = delaunay_mesh(p, 4);
                    double before = total_length(&m, p);
                    shorten(&m, p);
                    double ratio = before / total_length(&m, p);
                    if (ratio > worst + 1e-9) {
                        worst = ratio;
                        for (int i = 0; i < 4; i++)
                            best[i] = p[i];
                    }
                    mesh_free(&m);
                }
}

static void
draw_delaunay_and_shorter(svg *page, const point2 *points, uint32_t n)
{
    mesh m = delaunay_mesh(points, n);
    for (int i = 0; i < 2; i++) {
        char caption[80];
        if (i == 1)
            shorten(&m, points);
        snprintf(caption, sizeof caption, "%s: length %.3f",
                 i == 0 ? "Delaunay" : "shorter", total_length(&m, points));
        svg_panel(page, svg_box_of(points, n), n, caption);
        svg_mesh(page, points, &m);
        svg_points(page, points, n, SVG_PLAIN);
    }
    mesh_free(&m);
}

static void
draw_minimum_weight(FILE *file)
{
    enum { N = 20 };
    point2 four[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}}, many[N];
    search_four_points(four);
    random_source source = random_from_seed(1972);
    for (int i = 0; i < N; i++)
        many[i] = random_point(&source);
    svg page;
    svg_begin(&page, file, (svg_layout){4, 1, 190, 190, 1},
              "The Delaunay triangulation is not the shortest one",
              "Four sites with their two triangulations, of which the one "
              "that is not Delaunay is shorter; and twenty random sites, "
              "Delaunay and after flips that shorten it.");
    draw_delaunay_and_shorter(&page, four, 4);
    draw_delaunay_and_shorter(&page, many, N);
    svg_end(&page);
}

static const figure figures[] = {
    {"def7_empty_circle", draw_definition},
    {"square", draw_square},
    {"subdivision", draw_subdivision},
    {"chain", draw_chain},
    {"thm2_exchange", draw_theorem},
    {"gabriel_closed", draw_open_closed},
    {"elimination_path", draw_path},
    {"minimum_weight", draw_minimum_weight},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures,
                        sizeof figures / sizeof figures[0]);
}
