/* flip_picture.c - a flip graph as a picture. */
#include "chapters/3.5_edge_flips/flip_picture.h"

#include "lib/random.h"

#include <assert.h>
#include <math.h>

/* How often are places looked for, and how long? More is hardly better. */
enum { STARTS = 30, ROUNDS = 120 };

typedef struct layout {
    const flip_graph *g;
    uint32_t distance[FLIP_PICTURE_MOST_NODES][FLIP_PICTURE_MOST_NODES];
    point2 at[FLIP_PICTURE_MOST_NODES]; /* a flip is about 1 long */
    double size;                        /* of a little triangulation */
} layout;

/* ---- Where the nodes stand. ---- */

static double
distance_between(point2 p, point2 q)
{
    return sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
}

/* Moves a node to the mean of the places that the others want it to have: in
 * the direction where it is, as far away as it is in the graph. Near ones count
 * more. */
static void
move_node(layout *l, uint32_t node)
{
    point2 p = l->at[node], sum = {0, 0};
    double weights = 0;
    for (uint32_t other = 0; other < l->g->nodes; other++) {
        point2 q = l->at[other];
        double length = distance_between(p, q);
        double wanted = l->distance[node][other];
        if (other == node || !(length > 0))
            continue;
        double weight = 1 / (wanted * wanted), stretch = wanted / length;
        sum.x += weight * (q.x + stretch * (p.x - q.x));
        sum.y += weight * (q.y + stretch * (p.y - q.y));
        weights += weight;
    }
    if (weights > 0)
        l->at[node] = (point2){sum.x / weights, sum.y / weights};
}

static void
place_nodes(layout *l, random_source *source)
{
    for (uint32_t node = 0; node < l->g->nodes; node++) {
        double x = random_unit(source), y = random_unit(source);
        l->at[node] = (point2){x, y};
    }
    for (int round = 0; round < ROUNDS; round++)
        for (uint32_t node = 0; node < l->g->nodes; node++)
            move_node(l, node);
}

static double
distance_to_segment(point2 p, point2 a, point2 b)
{
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    double t = length2 > 0 ? fmin(fmax(along / length2, 0), 1) : 0;
    return distance_between(p, (point2){a.x + t * dx, a.y + t * dy});
}

/* The least distance between a node and a flip that does not concern it. */
static double
clearance(const layout *l)
{
    const flip_graph *g = l->g;
    double least = HUGE_VAL;
    for (uint32_t a = 0; a < g->nodes; a++)
        for (size_t i = g->first[a]; i < g->first[a + 1]; i++) {
            uint32_t b = g->neighbour[i];
            for (uint32_t node = 0; node < g->nodes; node++) {
                if (node == a || node == b)
                    continue;
                point2 p = l->at[node];
                double away = distance_to_segment(p, l->at[a], l->at[b]);
                least = fmin(least, away);
            }
        }
    return least;
}

/* As large as can be without touching: neighbours leave room for each other. */
static double
size_of_nodes(const layout *l)
{
    double nearest = 0.5;
    for (uint32_t a = 0; a < l->g->nodes; a++)
        for (uint32_t b = 0; b < a; b++)
            nearest = fmin(nearest, distance_between(l->at[a], l->at[b]));
    return fmax(0.75 * nearest, 0.15);
}

/* Of several layouts the clearest. */
static void
lay_out(layout *l)
{
    layout best = *l;
    double clearest = -1;
    random_source source = random_from_seed(1);
    for (int start = 0; start < STARTS; start++) {
        place_nodes(l, &source);
        double clear = clearance(l);
        if (clear > clearest) {
            clearest = clear;
            best = *l;
        }
    }
    *l = best;
    l->size = size_of_nodes(l);
}

/* ---- Drawing. ---- */

/* Where p of the box stands in the little picture around `centre`. Halves of
 * coordinates do not overflow when subtracted. */
static point2
shrunk(svg_box box, point2 p, point2 centre, double size)
{
    double width = box.max.x / 2 - box.min.x / 2;
    double height = box.max.y / 2 - box.min.y / 2;
    double larger = fmax(width, height);
    if (!(larger > 0))
        return centre;
    double x = (p.x / 2 - box.min.x / 2 - width / 2) / larger;
    double y = (p.y / 2 - box.min.y / 2 - height / 2) / larger;
    return (point2){centre.x + size * x, centre.y + size * y};
}

static void
draw_node(svg *page, const layout *l, const point2 *points, uint32_t node)
{
    const flip_graph *g = l->g;
    svg_box box = svg_box_of(points, g->points);
    svg_style style = g->is_delaunay[node] ? SVG_STRONG : SVG_PLAIN;
    for (vertex_id b = 0; b < g->points; b++) {
        point2 to = shrunk(box, points[b], l->at[node], l->size);
        svg_points(page, &to, 1, SVG_FAINT);
        for (vertex_id a = 0; a < b; a++) {
            point2 from = shrunk(box, points[a], l->at[node], l->size);
            if (flip_graph_has_edge(g, node, a, b))
                svg_segment(page, from, to, style);
        }
    }
}

/* A line between two nodes, from the border of one to that of the other. */
static void
draw_flip(svg *page, const layout *l, uint32_t a, uint32_t b)
{
    point2 from = l->at[a], to = l->at[b];
    double length = distance_between(from, to), radius = 0.7 * l->size;
    if (!(length > 2 * radius))
        return;
    double dx = (to.x - from.x) / length * radius;
    double dy = (to.y - from.y) / length * radius;
    svg_segment(page, (point2){from.x + dx, from.y + dy},
                (point2){to.x - dx, to.y - dy}, SVG_NEW);
}

void
flip_graph_draw(const flip_graph *g, const point2 *points, FILE *file,
                const char *title)
{
    assert(g->nodes <= FLIP_PICTURE_MOST_NODES);
    layout l = {.g = g};
    uint32_t order[FLIP_PICTURE_MOST_NODES], farthest = 0;
    for (uint32_t node = 0; node < g->nodes; node++) {
        flip_graph_distances(g, node, l.distance[node], order);
        uint32_t far = l.distance[node][order[g->nodes - 1]];
        farthest = far > farthest ? far : farthest;
    }
    lay_out(&l);

    svg page;
    char caption[120];
    svg_box box = svg_box_of(l.at, g->nodes);
    box = (svg_box){{box.min.x - l.size, box.min.y - l.size},
                    {box.max.x + l.size, box.max.y + l.size}};
    double width = fmin(220 + 120 * (box.max.x - box.min.x), 1200);
    double height = width * (box.max.y - box.min.y) / (box.max.x - box.min.x);
    snprintf(caption, sizeof caption,
             "triangulations: %lu, flips: %lu, diameter: %lu",
             (unsigned long)g->nodes, (unsigned long)flip_graph_flips(g),
             (unsigned long)farthest);
    svg_begin(&page, file, (svg_layout){1, 1, width, height, 1}, title,
              caption);
    svg_panel(&page, box, 200 + 6 * g->nodes, caption);
    for (uint32_t a = 0; a < g->nodes; a++)
        for (size_t i = g->first[a]; i < g->first[a + 1]; i++)
            if (a < g->neighbour[i])
                draw_flip(&page, &l, a, g->neighbour[i]);
    for (uint32_t node = 0; node < g->nodes; node++)
        draw_node(&page, &l, points, node);
    svg_end(&page);
}
