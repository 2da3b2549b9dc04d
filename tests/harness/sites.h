/* sites.h - a few points with small integer coordinates, and what a triangulation of
 * them is, written down slowly: for tests of the certifiers of tools/checks.
 */
#ifndef TESTS_HARNESS_SITES_H
#define TESTS_HARNESS_SITES_H

#include "lib/triangles.h"
#include "tests/harness/harness.h"
#include "tools/checks/plane.h"

enum { MOST = 16, MOST_LIST = 64 };

/* ---- Points. ---- */

typedef struct problem {
    site at[MOST];
    uint32_t n;
} problem;

static inline problem
problem_of(const point2 *points, uint32_t n)
{
    problem p = {.n = n};
    for (uint32_t i = 0; i < n; i++)
        p.at[i] = (site){(int32_t)points[i].x, (int32_t)points[i].y};
    return p;
}

static inline uint32_t
some(uint32_t below)
{
    return random_below(test_random_source(), below);
}

/* Points of a 4 x 4 grid, some of them twice. */
static inline problem
some_problem(uint32_t most)
{
    problem p = {.n = 3 + some(most - 2)};
    for (uint32_t i = 0; i < p.n; i++)
        p.at[i] = (site){(int32_t)some(4), (int32_t)some(4)};
    return p;
}

/* Twice the area of abc, positive when it is counterclockwise. */
static inline int64_t
area(site a, site b, site c)
{
    return (int64_t)(b.x - a.x) * (c.y - a.y) - (int64_t)(b.y - a.y) * (c.x - a.x);
}

static inline bool
same(site p, site q)
{
    return p.x == q.x && p.y == q.y;
}

/* ---- Definition 4. ---- */

/* Is q on the segment from p to r, ends included? */
static inline bool
is_on_segment(site p, site q, site r)
{
    return area(p, q, r) == 0 && (int64_t)(p.x - q.x) * (r.x - q.x) +
        (int64_t)(p.y - q.y) * (r.y - q.y) <= 0;
}

/* Twice the area of the convex hull: the sum along its edges, each of them from corner
 * to corner. */
static inline int64_t
area_of_hull(const problem *p)
{
    int64_t sum = 0;
    for (uint32_t i = 0; i < p->n; i++)
        for (uint32_t j = 0; j < p->n; j++) {
            site a = p->at[i], b = p->at[j];
            bool edge = !same(a, b);
            for (uint32_t k = 0; k < p->n; k++) {
                int64_t side = area(a, b, p->at[k]);
                edge =
                    edge && (side > 0 || (side == 0 && is_on_segment(a, p->at[k], b)));
                edge = edge && (k >= i || !same(p->at[k], a)); /* copies: the lowest */
                edge = edge && (k >= j || !same(p->at[k], b));
            }
            if (edge)
                sum += area((site){0, 0}, a, b);
        }
    return sum;
}

/* Is there a line through two of the corners with one triangle on either side? (If not,
 * they have interior points in common.) */
static inline bool
are_apart(const site *s, const site *t)
{
    for (int i = 0; i < 3; i++) {
        bool apart_s = true, apart_t = true;
        for (int k = 0; k < 3; k++) {
            apart_s = apart_s && area(s[i], s[(i + 1) % 3], t[k]) <= 0;
            apart_t = apart_t && area(t[i], t[(i + 1) % 3], s[k]) <= 0;
        }
        if (apart_s || apart_t)
            return true;
    }
    return false;
}

static inline void
corners_of(const problem *p, triangle_list list, uint32_t t, site corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = p->at[list.corner[t][i]];
}

/* Counterclockwise triangles that have no interior point in common, have the corners
 * that they should and no other point, and together have the area of the hull. */
static inline bool
is_triangulation_slowly(const problem *p, triangle_list list)
{
    bool used[MOST] = {false};
    site s[3], t[3];
    int64_t sum = 0;
    for (uint32_t k = 0; k < list.count; k++) {
        corners_of(p, list, k, s);
        if (area(s[0], s[1], s[2]) <= 0)
            return false;
        sum += area(s[0], s[1], s[2]);
        for (int i = 0; i < 3; i++)
            used[list.corner[k][i]] = true;
        for (uint32_t i = 0; i < p->n; i++)
            if (area(s[0], s[1], p->at[i]) >= 0 && area(s[1], s[2], p->at[i]) >= 0 &&
                area(s[2], s[0], p->at[i]) >= 0 && !same(p->at[i], s[0]) &&
                !same(p->at[i], s[1]) && !same(p->at[i], s[2]))
                return false;
        for (uint32_t l = 0; l < k; l++) {
            corners_of(p, list, l, t);
            if (!are_apart(s, t))
                return false;
        }
    }
    for (uint32_t i = 0; i < p->n && list.count > 0; i++) {
        uint32_t indices = 0;
        for (uint32_t k = 0; k < p->n; k++)
            indices += used[k] && same(p->at[k], p->at[i]);
        if (indices != 1)
            return false;
    }
    return sum == area_of_hull(p);
}

#endif
