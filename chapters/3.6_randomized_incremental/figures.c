/* figures.c - the pictures of section 3.6. What is drawn is what the code does:
 * the algorithms run under observers, and the tree and the dice are computed.
 */
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "chapters/3.6_randomized_incremental/bucket_grid.h"
#include "chapters/3.6_randomized_incremental/large_triangle.h"
#include "chapters/3.6_randomized_incremental/probability.h"
#include "chapters/figures.h"
#include "lib/random.h"
#include "lib/svg.h"

#include <math.h>
#include <stdlib.h>

/* ---- Pieces of pictures. ---- */

/* The triangles around p are hatched, and the edges at p are thick. */
static void
draw_star(svg *page, const point2 *points, const mesh *m, vertex_id p)
{
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        if (mesh_in_triangle(m, e))
            svg_triangle(page, points[p], points[mesh_dest(m, e)],
                         points[mesh_apex(m, e)], SVG_NEW);
        e = mesh_around(m, e);
    } while (e != first);
}

/* The edges to infinity, as rays away from `middle`. */
static void
draw_rays(svg *page, const point2 *points, const mesh *m, point2 middle,
          double length)
{
    halfedge_id first = mesh_some_hull_edge(m), e = first;
    do {
        point2 v = points[mesh_origin(m, e)];
        double dx = v.x - middle.x, dy = v.y - middle.y;
        double scale = length / sqrt(dx * dx + dy * dy);
        svg_segment(page, v, (point2){v.x + scale * dx, v.y + scale * dy},
                    SVG_FAINT);
        e = mesh_hull_next(m, e);
    } while (e != first);
}

static void
draw_vertices(svg *page, const point2 *points, const mesh *m)
{
    for (vertex_id v = 0; v < m->points; v++)
        svg_points(page, &points[v], 1,
                   mesh_leaving(m, v) != NONE ? SVG_PLAIN : SVG_FAINT);
}

/* The order 0, 1, 2, ... and a trace. */
static tri_options
in_order(const vertex_id *order, trace *observer)
{
    tri_options options = tri_options_default();
    options.order = order;
    options.trace = observer;
    return options;
}

static const vertex_id as_given[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

static void
fill_uniform(point2 *points, uint32_t n, uint64_t seed)
{
    random_source source = random_from_seed(seed);
    for (uint32_t i = 0; i < n; i++)
        points[i] = random_point(&source);
}

/* ---- Figure 12, executed; also used for Figure 13. ---- */

/* An observer that draws a panel for each round of the loop. */
typedef struct painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t n;
    vertex_id last; /* inserted last; NONE at first */
    uint32_t flips, flips_before;
    uint32_t skip; /* panels not to draw, from the first */
} painter;

static void
paint_round(painter *w, const mesh *m)
{
    char caption[80];
    uint32_t degree = 0;
    halfedge_id first = mesh_leaving(m, w->last), e = first;
    do {
        degree++;
        e = mesh_around(m, e);
    } while (e != first);
    if (w->last < 2 + w->skip)
        return;
    uint32_t flips = w->flips - w->flips_before;
    snprintf(caption, sizeof caption, "p%u: degree %u after %u flip%s",
             (unsigned)w->last + 1, (unsigned)degree, (unsigned)flips,
             flips == 1 ? "" : "s");
    svg_panel(w->page, svg_box_of(w->points, w->n), w->n, caption);
    draw_star(w->page, w->points, m, w->last);
    svg_mesh(w->page, w->points, m);
    draw_vertices(w->page, w->points, m);
    svg_points(w->page, &w->points[w->last], 1, SVG_NEW);
}

static int
see_round(trace *self, const mesh *m, const trace_event *event)
{
    painter *w = (painter *)self;
    if (event->kind == TRACE_LOCATE) {
        if (w->last != NONE)
            paint_round(w, m);
        w->last = event->a;
        w->flips_before = w->flips;
    }
    w->flips += event->kind == TRACE_FLIP;
    return 0;
}

static void
paint_rounds(svg *page, const point2 *points, uint32_t n, uint32_t skip)
{
    painter w = {{see_round}, page, points, n, NONE, 0, 0, skip};
    tri_options options = in_order(as_given, &w.base);
    mesh m;
    must(incremental_triangulate(points, n, &options, &m), "incremental_"
                                                           "triangulate");
    paint_round(&w, &m);
    mesh_free(&m);
}

static void
draw_steps(FILE *file)
{
    const point2 points[8] = {{2.0, 1.0}, {6.0, 1.6}, {3.4, 3.8}, {0.4, 3.0},
                              {6.6, 4.4}, {3.8, 2.2}, {4.6, 5.2}, {4.4, 0.2}};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 2, 240, 190, 1}, "Figure 12, executed",
              "Eight points are inserted one after the other. Each panel shows the "
              "Delaunay "
              "triangulation after one of them; all new triangles have it as a "
              "corner. The "
              "degrees count the edge to infinity of a hull vertex.");
    paint_rounds(&page, points, 8, 0);
    svg_end(&page);
}

static void
draw_bad_order(FILE *file)
{
    enum { n = 10 };
    point2 points[n]; /* flatter than (i, i^2), with the same flips */
    for (int i = 0; i < n; i++)
        points[i] = (point2){n - i, (n - i) * (n - i) / 12.0};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 240, 230, 1},
              "Figure 13: a bad order",
              "Points on a parabola are inserted from right to left. Each new "
              "point is joined "
              "to all points before it, so that all edges of the one before are "
              "flipped.");
    paint_rounds(&page, points, n, n - 5);
    svg_end(&page);
}

/* ---- A point outside of the hull. ---- */

/* Draws the mesh after each split and each flip of the last point. */
typedef struct outside_painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t n;
    svg_box box;
} outside_painter;

static int
see_outside(trace *self, const mesh *m, const trace_event *event)
{
    outside_painter *w = (outside_painter *)self;
    vertex_id last = w->n - 1;
    bool is_last = mesh_leaving(m, last) != NONE ||
                   (event->kind == TRACE_LOCATE && event->a == last);
    const char *caption = event->kind == TRACE_LOCATE  ? "p sees this hull edge"
                          : event->kind == TRACE_SPLIT ? "split: p is joined to "
                                                         "infinity"
                          : event->kind == TRACE_FLIP  ? "flip: a ray becomes an "
                                                         "edge"
                                                       : NULL;
    if (!is_last || caption == NULL)
        return 0;
    svg_panel(w->page, w->box, w->n, caption);
    if (event->kind == TRACE_LOCATE)
        svg_segment(w->page, w->points[mesh_origin(m, event->edge)],
                    w->points[mesh_dest(m, event->edge)], SVG_MARK);
    else
        draw_star(w->page, w->points, m, last);
    draw_rays(w->page, w->points, m, (point2){2.6, 2.0}, 1.4);
    svg_mesh(w->page, w->points, m);
    svg_points(w->page, w->points, w->n, SVG_PLAIN);
    svg_points(w->page, &w->points[last], 1, SVG_NEW);
    svg_label(w->page, w->points[last], "p", SVG_NEW);
    return 0;
}

static void
draw_outside(FILE *file)
{
    const point2 points[7] = {{0.6, 1.2}, {2.2, 0.2}, {4.2, 1.0}, {4.4, 2.8},
                              {2.4, 3.6}, {0.8, 2.8}, {5.6, 4.4}};
    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 250, 210, 1},
              "A point outside of the hull",
              "Each hull vertex has an edge to infinity, drawn as a ray. The new "
              "point lies "
              "behind a hull edge; this part of the outside is split in three, and "
              "then rays "
              "are flipped to edges as long as the point sees the next hull edge.");
    outside_painter w = {{see_outside}, &page, points, 7, {{-1, -1}, {7, 5.6}}};
    tri_options options = in_order(as_given, &w.base);
    options.locator = TRI_LOCATOR_WALK;
    mesh m;
    must(incremental_triangulate(points, 7, &options, &m), "incremental_"
                                                           "triangulate");
    svg_end(&page);
    mesh_free(&m);
}

/* ---- Figure 14: the tree of the three doors. ---- */

/* The panel's world has one unit for each leaf, and y points down from -1 on. */
static void
draw_word(svg *page, double x, double y, const char *text, svg_style style)
{
    svg_text(page, svg_place(page, (point2){x, -y}), text, style);
}

static void
draw_leaf(svg *page, door_game w, rational chance, double y)
{
    char text[64];
    snprintf(text, sizeof text, "(%c, %c, %c)   %d/%d   %s", 'A' + w.car,
             'A' + w.guess, 'A' + w.opened, (int)chance.num, (int)chance.den,
             wins_by_switching(w) ? "switching wins" : "staying wins");
    draw_word(page, 17, y, text, wins_by_switching(w) ? SVG_GOOD : SVG_PLAIN);
}

/* A branch to (x, y) from the column before, with the door and its probability. */
static void
draw_branch(svg *page, double from_y, double x, double y, int door,
            const char *chance)
{
    char text[16];
    svg_segment(page, (point2){x - 3.2, -from_y}, (point2){x - 0.8, -y}, SVG_PLAIN);
    snprintf(text, sizeof text, "%c  %s", 'A' + door, chance);
    draw_word(page, x, y, text, SVG_STRONG);
}

static void
draw_doors(FILE *file)
{
    door_game w[DOOR_GAMES];
    rational p[DOOR_GAMES];
    bool wins[DOOR_GAMES];
    char caption[80];
    door_games(w, p);
    for (int i = 0; i < DOOR_GAMES; i++)
        wins[i] = wins_by_switching(w[i]);
    rational sum = probability_of((probability_space){DOOR_GAMES, p}, wins);
    snprintf(caption, sizeof caption, "switching wins with probability %d/%d",
             (int)sum.num, (int)sum.den);
    svg page;
    svg_begin(&page, file, (svg_layout){1, 1, 640, 420, 1},
              "Figure 14: the three doors",
              "A tree of three levels: the door with the car, the door that the "
              "player "
              "guesses, the door that is opened. Its twelve leaves are the "
              "outcomes; six of "
              "them, with probability one ninth each, are won by switching.");
    svg_panel(&page, (svg_box){{0, -DOOR_GAMES}, {20, 1}}, 30, caption);
    const char *const title[4] = {"car", "guess", "opened",
                                  "outcome, its probability"};
    for (int i = 0; i < 4; i++)
        draw_word(&page, i < 3 ? 4 * i + 4 : 17, -1, title[i], SVG_PLAIN);
    double car_y = 0, guess_y = 0;
    for (int i = 0; i < DOOR_GAMES; i++) {
        bool two = w[i].guess == w[i].car; /* two doors can be opened */
        bool new_car = i == 0 || w[i].car != w[i - 1].car;
        if (new_car) {
            car_y = i + 1.5; /* four leaves */
            draw_branch(&page, 5.5, 4, car_y, w[i].car, "1/3");
        }
        if (new_car || w[i].guess != w[i - 1].guess) {
            guess_y = two ? i + 0.5 : i;
            draw_branch(&page, car_y, 8, guess_y, w[i].guess, "1/3");
        }
        draw_branch(&page, guess_y, 12, i, w[i].opened, two ? "1/2" : "1");
        draw_leaf(&page, w[i], p[i], i);
    }
    svg_end(&page);
}

/* ---- Figure 15: two dice. ---- */

static void
outline(svg *page, svg_box box, svg_style style)
{
    point2 a = box.min, b = {box.max.x, box.min.y}, c = box.max;
    point2 d = {box.min.x, box.max.y};
    svg_segment(page, a, b, style);
    svg_segment(page, b, c, style);
    svg_segment(page, c, d, style);
    svg_segment(page, d, a, style);
}

static void
draw_dice(FILE *file)
{
    rational p[36];
    bool ten[36], odd[36];
    char caption[120];
    for (int w = 0; w < 36; w++) {
        int first = w / 6 + 1, second = w % 6 + 1;
        p[w] = rational_of(1, 36);
        ten[w] = first + second == 10;
        odd[w] = first % 2 == 1 && second % 2 == 1;
    }
    probability_space S = {36, p};
    rational given = conditional_probability(S, ten, odd),
             alone = probability_of(S, ten);
    snprintf(caption, sizeof caption,
             "small squares: the sum is 10; large: both are odd\n"
             "Pr{sum 10} = %d/%d, Pr{sum 10 | both odd} = %d/%d", (int)alone.num,
             (int)alone.den, (int)given.num, (int)given.den);
    svg page;
    svg_begin(&page, file, (svg_layout){1, 1, 420, 400, 2}, "Figure 15: two dice",
              "A grid of 36 outcomes. The nine in which both dice are odd have "
              "large squares; the "
              "three whose sum is ten have small ones. One of them is in both "
              "events.");
    svg_panel(&page, (svg_box){{-0.3, -0.3}, {6.6, 6.6}}, 36, caption);
    for (int i = 1; i <= 6; i++) {
        const char digit[] = {(char)('0' + i), '\0'};
        svg_text(&page, svg_place(&page, (point2){i, 0.25}), digit, SVG_PLAIN);
        svg_text(&page, svg_place(&page, (point2){0.25, i}), digit, SVG_PLAIN);
    }
    svg_text(&page, svg_place(&page, (point2){3.5, -0.15}), "first die", SVG_PLAIN);
    svg_text(&page, svg_place(&page, (point2){0.45, 6.55}), "second die", SVG_PLAIN);
    for (int w = 0; w < 36; w++) {
        double x = w / 6 + 1, y = w % 6 + 1, r = 0.42;
        svg_box box = {{x - r, y - r}, {x + r, y + r}};
        if (odd[w])
            outline(&page, box, SVG_NEW);
        if (ten[w])
            svg_rectangle(&page,
                          (svg_box){{x - r / 2, y - r / 2}, {x + r / 2, y + r / 2}},
                          SVG_MARK);
        svg_points(&page, &(point2){x, y}, 1, ten[w] ? SVG_STRONG : SVG_PLAIN);
    }
    svg_end(&page);
}

/* ---- Figure 16: a walk, and a long one. ---- */

typedef struct walk_painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t visits;
} walk_painter;

static int
see_walk(trace *self, const mesh *m, const trace_event *event)
{
    walk_painter *w = (walk_painter *)self;
    if (event->kind != TRACE_VISIT || !mesh_in_triangle(m, event->edge))
        return 0;
    w->visits++;
    if (w->page == NULL) /* count only: the caption comes before the drawing */
        return 0;
    svg_triangle(w->page, w->points[mesh_origin(m, event->edge)],
                 w->points[mesh_dest(m, event->edge)],
                 w->points[mesh_apex(m, event->edge)], SVG_NEW);
    return 0;
}

/* A panel with the walk from vertex v to p. */
static void
draw_walk(svg *page, const point2 *points, uint32_t n, vertex_id v, point2 p)
{
    mesh m;
    char caption[64];
    must(incremental_triangulate(points, n, NULL, &m), "incremental_triangulate");
    walk_painter w = {{see_walk}, NULL, points, 0};
    m.trace = &w.base;
    straight_walk(&m, points, v, p);
    uint32_t triangles = 2 * m.locations - 2 - mesh_hull_size(&m);
    snprintf(caption, sizeof caption, "the walk visits %u of %u triangles",
             (unsigned)w.visits, (unsigned)triangles);
    svg_panel(page, svg_box_of(points, n), n, caption);
    w.page = page;
    straight_walk(&m, points, v, p);
    svg_mesh(page, points, &m);
    svg_points(page, points, n, SVG_PLAIN);
    svg_segment(page, points[v], p, SVG_STRONG);
    svg_points(page, &p, 1, SVG_NEW);
    mesh_free(&m);
}

static void
draw_walks(FILE *file)
{
    enum { n = 60, k = 5 };
    point2 points[n], strip[2 * k];
    fill_uniform(points, n, 16);
    points[0] = (point2){0.08, 0.12};
    for (int i = 0; i < k; i++) {
        strip[2 * i] = (point2){0, 4 * i};
        strip[2 * i + 1] = (point2){3, 4 * i + 2};
    }
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 320, 330, 1},
              "Figure 16: a straight walk, and a long one",
              "On the left the triangles that a segment meets among sixty random "
              "points. On "
              "the right two columns of points; a walk from bottom to top meets "
              "all "
              "triangles.");
    draw_walk(&page, points, n, 0, (point2){0.86, 0.78});
    draw_walk(&page, strip, 2 * k, 0, (point2){1.6, 4 * k - 3.4});
    svg_end(&page);
}

/* ---- Buckets: what moves when a point is inserted. ---- */

typedef struct bucket_painter {
    trace base;
    svg *page;
    const point2 *points;
    uint32_t n, round, wanted;
    bool *moved;
    vertex_id last;
} bucket_painter;

static void
paint_buckets(bucket_painter *w, const mesh *m)
{
    char caption[80];
    uint32_t moved = 0;
    for (uint32_t q = 0; q < w->n; q++)
        moved += w->moved[q];
    snprintf(
        caption, sizeof caption, "point %u inserted: %u of %u waiting points moved",
        (unsigned)w->round + 2, (unsigned)moved, (unsigned)(w->n - w->round - 2));
    svg_panel(w->page, svg_box_of(w->points, w->n), w->n, caption);
    draw_star(w->page, w->points, m, w->last);
    svg_mesh(w->page, w->points, m);
    for (uint32_t q = 0; q < w->n; q++)
        if (mesh_leaving(m, q) == NONE)
            svg_points(w->page, &w->points[q], 1,
                       w->moved[q] ? SVG_MARK : SVG_FAINT);
    for (uint32_t q = 0; q < w->n; q++)
        if (mesh_leaving(m, q) != NONE)
            svg_points(w->page, &w->points[q], 1, SVG_STRONG);
}

static int
see_buckets(trace *self, const mesh *m, const trace_event *event)
{
    bucket_painter *w = (bucket_painter *)self;
    if (event->kind == TRACE_LOCATE) {
        if (w->round == w->wanted)
            paint_buckets(w, m);
        for (uint32_t q = 0; q < w->n; q++)
            w->moved[q] = false;
        w->last = event->a;
        w->round++;
    }
    if (event->kind == TRACE_MOVE)
        w->moved[event->a] = true;
    return 0;
}

static void
draw_buckets(FILE *file)
{
    enum { n = 240 };
    const uint32_t rounds[2] = {5, 24};
    point2 points[n];
    fill_uniform(points, n, 36);
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 330, 330, 1}, "Buckets",
              "The triangulation after a few and after more insertions. The "
              "waiting points in "
              "the star of the last point have moved; all others stayed where they "
              "were.");
    for (int k = 0; k < 2; k++) {
        bool moved[n] = {false};
        bucket_painter w = {{see_buckets}, &page, points, n, 0,
                            rounds[k],     moved, NONE};
        tri_options options = tri_options_default();
        options.seed = 4;
        options.trace = &w.base;
        mesh m;
        must(incremental_triangulate(points, n, &options, &m), "incremental_"
                                                               "triangulate");
        mesh_free(&m);
    }
    svg_end(&page);
}

/* ---- The biased order. ---- */

/* The points L[0 .. count-1] and the way from each to the next. */
static void
draw_way(svg *page, const point2 *points, const vertex_id *L, uint32_t count)
{
    for (uint32_t i = 0; i + 1 < count; i++)
        svg_segment(page, points[L[i]], points[L[i + 1]], SVG_PLAIN);
    for (uint32_t i = 0; i < count; i++)
        svg_points(page, &points[L[i]], 1, SVG_PLAIN);
}

/* Where does the round begin that ends before L[end]? Where the order steps back
 * along the curve. */
static uint32_t
round_begin(const vertex_id *L, const uint32_t *rank, uint32_t end)
{
    uint32_t i = end - 1;
    while (i > 0 && rank[L[i - 1]] < rank[L[i]])
        i--;
    return i;
}

static void
draw_biased(FILE *file)
{
    enum { n = 512 };
    const uint64_t seed = 7;
    point2 points[n], strip[n];
    vertex_id curve[n], L[n];
    uint32_t rank[n], count;
    fill_uniform(points, n, 61);
    fill_uniform(strip, n, 62);
    for (uint32_t i = 0; i < n; i++) /* 16 times as crowded on one side */
        strip[i].x *= strip[i].x * strip[i].x * strip[i].x;

    svg page;
    svg_begin(&page, file, (svg_layout){3, 1, 240, 240, 1},
              "A curve along which the points of a round are inserted",
              "The curve through 512 points that crowd on the left stays in one place "
              "until it has been everywhere there. In the last two rounds of a biased "
              "order, here of evenly spread points, it is thinned out at random.");
    random_source random = random_from_seed(seed);
    must(along_curve(strip, n, &random, curve, &count), "along_curve");
    svg_panel(&page, svg_box_of(strip, n), count, "a curve through 512 points");
    draw_way(&page, strip, curve, count);

    random = random_from_seed(seed);
    must(along_curve(points, n, &random, curve, &count), "along_curve");
    for (uint32_t i = 0; i < count; i++)
        rank[curve[i]] = i;
    random = random_from_seed(seed);
    must(biased_order(points, n, &random, L, &count), "biased_order");
    uint32_t last = round_begin(L, rank, count);
    uint32_t begin[2] = {round_begin(L, rank, last), last}, end[2] = {last, count};
    for (int k = 0; k < 2; k++) {
        char caption[64];
        snprintf(caption, sizeof caption, "%s: %u points",
                 k == 0 ? "last round but one" : "last round",
                 (unsigned)(end[k] - begin[k]));
        svg_panel(&page, svg_box_of(points, n), end[k] - begin[k], caption);
        draw_way(&page, points, L + begin[k], end[k] - begin[k]);
    }
    svg_end(&page);
}

/* ---- E40: no triangle is large enough. ---- */

static void
draw_large_triangle(FILE *file)
{
    point2 points[6] = {{0, 2}, {1, 1}, {3, 0}}; /* and xyz */
    const double times[2] = {3, 6};
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 350, 320, 1},
              "A triangle that is not large enough, and one that is",
              "Three points in a flat triangle, whose circle is large. If the top "
              "corner of the "
              "surrounding triangle lies in this circle, the triangle of the three "
              "points is "
              "lost.");
    for (int k = 0; k < 2; k++) {
        triangle_list list;
        char caption[80];
        must(large_triangle_triangulate(points, 3, times[k], &list), "large_"
                                                                     "triangle");
        large_triangle(points, 3, times[k], &points[3]);
        snprintf(caption, sizeof caption, "%g boxes away: %s", times[k],
                 list.count == 0 ? "z lies in the circle, no triangle is left"
                                 : "z lies outside, the triangle is left");
        svg_panel(&page, svg_box_of(points, 6), 12, caption);
        svg_triangle(&page, points[3], points[4], points[5], SVG_FAINT);
        svg_circle(&page, points[0], points[1], points[2], SVG_PLAIN);
        svg_triangles(&page, points, list, SVG_STRONG);
        svg_points(&page, points, 3, SVG_STRONG);
        svg_points(&page, &points[3], 3, SVG_PLAIN);
        const char *const name[3] = {"x", "y", "z"};
        for (int i = 0; i < 3; i++)
            svg_label(&page, points[3 + i], name[i], SVG_PLAIN);
        triangle_list_free(&list);
    }
    svg_end(&page);
}

/* ---- A grid of buckets, and the walk from what it finds. ---- */

/* The box of the cells from `low` to `high`, both included. */
static svg_box
cells_box(const bucket_grid *g, point2 low, point2 high)
{
    double width = (g->most.x - g->least.x) / g->side,
           height = (g->most.y - g->least.y) / g->side;
    return (svg_box){{g->least.x + low.x * width, g->least.y + low.y * height},
                     {g->least.x + (high.x + 1) * width,
                      g->least.y + (high.y + 1) * height}};
}

static void
draw_outline(svg *page, svg_box box, svg_style style)
{
    const point2 corner[4] = {box.min, {box.max.x, box.min.y}, box.max,
                              {box.min.x, box.max.y}};
    for (int i = 0; i < 4; i++)
        svg_segment(page, corner[i], corner[(i + 1) % 4], style);
}

static void
draw_cells(svg *page, const bucket_grid *g)
{
    for (uint32_t i = 0; i <= g->side; i++) {
        svg_box across = cells_box(g, (point2){0, i}, (point2){g->side - 1, i}),
                along = cells_box(g, (point2){i, 0}, (point2){i, g->side - 1});
        svg_segment(page, across.min, (point2){across.max.x, across.min.y}, SVG_FAINT);
        svg_segment(page, along.min, (point2){along.min.x, along.max.y}, SVG_FAINT);
    }
}

static void
draw_grid(FILE *file)
{
    enum { n = 60 }; /* and the one that is to come */
    point2 points[n + 1];
    vertex_id order[n + 1];
    bucket_grid g;
    fill_uniform(points, n + 1, 34);
    for (vertex_id v = 0; v <= n; v++)
        order[v] = v;
    must(bucket_grid_init(&g, points, order, n + 1), "bucket_grid_init");
    for (int i = 0; i < n; i++)
        bucket_grid_add(&g);
    point2 p = points[n];
    uint32_t cell = bucket_grid_cell(&g, p);
    double x = cell % g.side, y = cell / g.side;
    vertex_id v = bucket_grid_near(&g, p);

    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 300, 300, 1}, "A grid of buckets",
        "Sixty points in a grid of cells. The cell of a new point is empty; in the "
        "ring of cells around it there are points. From one of them the walk to the "
        "new point visits a few triangles only.");
    svg_panel(&page, svg_box_of(points, n + 1), n, "an empty cell, the ring around it");
    draw_cells(&page, &g);
    draw_outline(&page, cells_box(&g, (point2){x - 1, y - 1}, (point2){x + 1, y + 1}),
                 SVG_NEW);
    draw_outline(&page, cells_box(&g, (point2){x, y}, (point2){x, y}), SVG_STRONG);
    svg_points(&page, points, n, SVG_PLAIN);
    svg_points(&page, &points[v], 1, SVG_STRONG);
    svg_points(&page, &p, 1, SVG_NEW);
    draw_walk(&page, points, n, v, p);
    svg_end(&page);
    bucket_grid_free(&g);
}

static const figure figures[] = {
    {"fig12_steps", draw_steps},
    {"outside", draw_outside},
    {"fig13_bad_order", draw_bad_order},
    {"fig14_doors", draw_doors},
    {"fig15_dice", draw_dice},
    {"fig16_walks", draw_walks},
    {"buckets", draw_buckets},
    {"biased_order", draw_biased},
    {"bucket_grid", draw_grid},
    {"large_triangle", draw_large_triangle},
};

int
main(int argc, char **argv)
{
    return draw_figures(argc, argv, figures, sizeof figures / sizeof figures[0]);
}
