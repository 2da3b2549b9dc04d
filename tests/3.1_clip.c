/* Section 3.1: what of an edge is seen in a box, and in which direction it runs.
 *
 * Hypotheses: for the comparison with sample points, coordinates of moderate size:
 * what is drawn is rounded, and held to a millionth of the box. Nothing else is asked
 * of coordinates at the ends of the range than that numbers come out.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* ---- The direction of an edge. ---- */

/* From p to q, or half of it if that is too much. */
static point2
from_to(point2 p, point2 q)
{
    point2 whole = {q.x - p.x, q.y - p.y};
    return isfinite(whole.x) && isfinite(whole.y)
               ? whole
               : (point2){q.x / 2 - p.x / 2, q.y / 2 - p.y / 2};
}

/* So that squares neither overflow nor vanish. */
static point2
scaled_down(point2 p)
{
    int exponent;
    frexp(fmax(fabs(p.x), fabs(p.y)), &exponent);
    return (point2){ldexp(p.x, -exponent), ldexp(p.y, -exponent)};
}

static void
edges_run_between_their_sites(const point2 *points, uint32_t n)
{
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    for (uint32_t k = 0; k < d.edges; k++) {
        point2 p = points[d.edge[k].left], q = points[d.edge[k].right];
        point2 run = voronoi_direction(&d, points, k);
        point2 middle = voronoi_midpoint(&d, points, k);
        point2 along = scaled_down(run);
        point2 across = scaled_down(from_to(p, q));
        CLAIM("sec3.1.P21", isfinite(run.x) && isfinite(run.y) &&
              isfinite(middle.x) && isfinite(middle.y), "edge %u: no number", k);
        CLAIM("sec3.1.P21", (p.x <= middle.x) == (middle.x <= q.x) || middle.x == p.x ||
              middle.x == q.x, "%g is not between %g and %g", middle.x, p.x, q.x);
        CLAIM("sec3.1.P21",
              fabs(along.x * across.x + along.y * across.y) < 1e-9,
              "edge %u does not run along the bisector", k);
        /* Turned left by a quarter: left of the way from p to q. */
        CLAIM("sec3.1.P21", across.x * along.y - across.y * along.x > 0,
              "edge %u has its left site on its right", k);
    }
    voronoi_free(&d);
    mesh_free(&m);
}

/* ---- What a box shows. ---- */

/* The point at t on edge k: from its first to its second vertex for t of 0 to 1; on a
 * ray as many times its direction; on a line around the middle. */
static point2
point_of_edge(const voronoi *d, const point2 *points, const point2 *at, uint32_t k,
              double t)
{
    voronoi_edge e = d->edge[k];
    point2 from = e.from != NONE ? at[e.from] : voronoi_midpoint(d, points, k);
    point2 run = voronoi_direction(d, points, k);
    if (e.to != NONE)
        run = (point2){at[e.to].x - from.x, at[e.to].y - from.y};
    return (point2){from.x + t * run.x, from.y + t * run.y};
}

/* How far x is outside of the box; negative inside. */
static double
outside(point2 x, point2 min, point2 max)
{
    return fmax(fmax(min.x - x.x, x.x - max.x), fmax(min.y - x.y, x.y - max.y));
}

/* How far x is from the segment. */
static double
distance_from(point2 x, const point2 s[2])
{
    double ux = s[1].x - s[0].x, uy = s[1].y - s[0].y, square = ux * ux + uy * uy;
    double t = square > 0 ? ((x.x - s[0].x) * ux + (x.y - s[0].y) * uy) / square : 0;
    t = fmax(0, fmin(1, t));
    return hypot(x.x - s[0].x - t * ux, x.y - s[0].y - t * uy);
}

static void
check_edge(const voronoi *d, const point2 *points, const point2 *at, uint32_t k,
           point2 min, point2 max)
{
    const double near = 1e-6 * (max.x - min.x);
    voronoi_edge e = d->edge[k];
    point2 s[2];
    bool seen = voronoi_edge_in_box(d, points, at, k, min, max, s);
    double first = e.from != NONE ? 0 : -20, last = e.to != NONE ? 1 : 20;
    for (int i = 0; i <= 200; i++) {
        point2 x = point_of_edge(d, points, at, k, first + (last - first) * i / 200);
        if (outside(x, min, max) < -near)
            CLAIM("sec3.1.P22", seen && distance_from(x, s) < near,
                  "(%g,%g) of edge %u is in the box, and not shown", x.x, x.y, k);
    }
    for (int i = 0; seen && i < 2; i++) {
        CLAIM("sec3.1.P22", outside(s[i], min, max) < near,
              "edge %u is shown at (%g,%g), outside of the box", k, s[i].x, s[i].y);
        /* An end that is not on the frame is an end of the edge. */
        bool is_end = (e.from != NONE && distance_from(s[i], (point2[]){at[e.from],
                                                       at[e.from]}) < near) ||
                      (e.to != NONE && distance_from(s[i], (point2[]){at[e.to],
                                                     at[e.to]}) < near);
        CLAIM("sec3.1.P22", is_end || outside(s[i], min, max) > -near,
              "edge %u ends at (%g,%g), inside of the box", k, s[i].x, s[i].y);
    }
}

/* Whole sites, and a box that is drawn anywhere among them. */
static void
a_box_shows_what_is_inside(const point2 *drawn, uint32_t n)
{
    HYPOTHESIS(n > 1);
    random_source *r = test_random_source();
    point2 *points = whole_points(drawn, n, 20);
    mesh m;
    voronoi d;
    random_diagram(points, n, &m, &d);
    point2 *at = malloc((d.vertices + 1) * sizeof *at);
    CLAIM("sec3.1.P22", voronoi_vertices(&d, points, at) == TRI_OK, "no vertices");
    point2 min = {random_below(r, 20), random_below(r, 20)};
    point2 max = {min.x + 1 + random_below(r, 20), min.y + 1 + random_below(r, 20)};
    for (uint32_t k = 0; k < d.edges; k++)
        check_edge(&d, points, at, k, min, max);
    free(at);
    free(points);
    voronoi_free(&d);
    mesh_free(&m);
}

/* Boxes and sites near the ends of the range. */
static void
the_ends_of_the_range(void)
{
    const point2 wide[] = {{-DBL_MAX, 0}, {DBL_MAX, 0}};
    const point2 thin[] = {{0, 0}, {0x1p-1074, 0}};
    mesh m;
    voronoi d;
    point2 s[2];
    random_diagram(wide, 2, &m, &d);
    CLAIM("sec3.1.P22",
          voronoi_edge_in_box(&d, wide, NULL, 0, (point2){-1, -1}, (point2){1, 1}, s) &&
              s[0].x == 0 && s[1].x == 0 && fabs(s[0].y) == 1 && s[0].y == -s[1].y,
          "(%g,%g) (%g,%g)", s[0].x, s[0].y, s[1].x, s[1].y);
    CLAIM("sec3.1.P22",
          !voronoi_edge_in_box(&d, wide, NULL, 0, (point2){1, -1}, (point2){2, 1}, s),
          "a line that misses the box is shown from (%g,%g)", s[0].x, s[0].y);
    voronoi_free(&d);
    mesh_free(&m);
    random_diagram(thin, 2, &m, &d);
    CLAIM("sec3.1.P22",
          voronoi_edge_in_box(&d, thin, NULL, 0, (point2){-1, 0}, (point2){1, DBL_MAX},
                              s) && fmax(s[0].y, s[1].y) == DBL_MAX,
          "the line ends at %g", fmax(s[0].y, s[1].y));
    voronoi_free(&d);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.1: directions of edges, and what a box shows of them");
    test_random("directions", edges_run_between_their_sites, 1000, 40);
    test_near_degenerate("directions", edges_run_between_their_sites, 1000, 12);
    test_random("in a box", a_box_shows_what_is_inside, 2000, 20);
    test_run("the ends of the range", the_ends_of_the_range);
    return test_end((test_minima){.trials = 4000, .largest_n = 30});
}
