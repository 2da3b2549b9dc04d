/* clip.c - directions of rays, and what of the diagram is seen in a picture.
 *
 * Notes: section 3.1. Rounded: nothing is decided here. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include <math.h>

/* ---- Lines. ---- */

point2
voronoi_direction(const voronoi *d, const point2 *points, uint32_t k)
{
    point2 p = points[d->edge[k].left], q = points[d->edge[k].right];
    point2 along = {p.y - q.y, q.x - p.x};
    if (!isfinite(along.x) || !isfinite(along.y))
        along = (point2){p.y / 2 - q.y / 2, q.x / 2 - p.x / 2};
    return along;
}

static double
halfway(double p, double q)
{
    double sum = p + q;
    return isfinite(sum) ? sum / 2 : p / 2 + q / 2;
}

point2
voronoi_midpoint(const voronoi *d, const point2 *points, uint32_t k)
{
    point2 p = points[d->edge[k].left], q = points[d->edge[k].right];
    return (point2){halfway(p.x, q.x), halfway(p.y, q.y)};
}

/* ---- An edge in a box. ---- */

/* The point from + t along, for t of t[0] .. t[1]. */
typedef struct stretch {
    point2 from, along;
    double t[2];
} stretch;

/* Keeps the part where low <= from + t along <= high, for one coordinate. */
static void
keep_between(stretch *s, double from, double along, double low, double high)
{
    if (along == 0) {
        if (from < low || from > high)
            s->t[1] = -INFINITY;
        return;
    }
    double at_low = (low - from) / along, at_high = (high - from) / along;
    s->t[0] = fmax(s->t[0], fmin(at_low, at_high));
    s->t[1] = fmin(s->t[1], fmax(at_low, at_high));
}

static point2
scaled(point2 p, int exponent)
{
    return (point2){ldexp(p.x, -exponent), ldexp(p.y, -exponent)};
}

/* An exponent with which the box and everything near it is about 1: then what
 * is far enough away to overflow is not in the box. */
static int
size_of(point2 min, point2 max)
{
    int exponent;
    frexp(fmax(fmax(fabs(min.x), fabs(max.x)), fmax(fabs(min.y), fabs(max.y))),
          &exponent);
    return exponent;
}

bool
voronoi_edge_in_box(const voronoi *d, const point2 *points, const point2 *at,
                    uint32_t k, point2 min, point2 max, point2 segment[2])
{
    int unit = size_of(min, max);
    voronoi_edge edge = d->edge[k];
    stretch s = {.t = {0, INFINITY}};
    point2 direction = voronoi_direction(d, points, k);
    s.along = scaled(direction, size_of(direction, direction));
    if (edge.from != NONE) {
        s.from = scaled(at[edge.from], unit);
    } else {
        s.from = scaled(voronoi_midpoint(d, points, k), unit);
        s.t[0] = -INFINITY;
    }
    if (edge.to != NONE) {
        point2 to = scaled(at[edge.to], unit);
        s.along = (point2){to.x - s.from.x, to.y - s.from.y};
        s.t[1] = 1;
    }
    min = scaled(min, unit);
    max = scaled(max, unit);
    keep_between(&s, s.from.x, s.along.x, min.x, max.x);
    keep_between(&s, s.from.y, s.along.y, min.y, max.y);
    if (!(s.t[0] <= s.t[1]))
        return false;
    for (int i = 0; i < 2; i++) {
        point2 end = {s.from.x + s.t[i] * s.along.x,
                      s.from.y + s.t[i] * s.along.y};
        segment[i] = scaled(end, -unit);
    }
    return isfinite(s.t[0]) && isfinite(s.t[1]);
}

/* ---- A polygon and a half-plane. ---- */

/* (|xp|^2 - |xq|^2) / 2, which is linear in x: not positive in H_pq. */
static double
excess(point2 x, point2 p, point2 q)
{
    point2 middle = {halfway(p.x, q.x), halfway(p.y, q.y)};
    return (x.x - middle.x) * (q.x - p.x) + (x.y - middle.y) * (q.y - p.y);
}

/* Each corner inside is kept, and each side that crosses the bisector gives a
 * corner: a convex polygon has at most two such sides, and loses a corner
 * between them. */
uint32_t
cut_polygon(const point2 *polygon, uint32_t size, point2 p, point2 q,
            point2 *out)
{
    uint32_t kept = 0, crossings = 0; /* rounding may see more than two */
    for (uint32_t i = 0; i < size; i++) {
        point2 a = polygon[i], b = polygon[(i + 1) % size];
        double at_a = excess(a, p, q), at_b = excess(b, p, q);
        if (at_a <= 0)
            out[kept++] = a;
        bool crosses = (at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0);
        if (crosses && crossings++ < 2) {
            double t = at_a / (at_a - at_b);
            out[kept++] =
                (point2){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        }
    }
    return kept;
}
