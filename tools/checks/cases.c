/* cases.c - families of point sets with small integer coordinates. */
#include "tools/checks/cases.h"

#include <assert.h>

static int32_t
integer(random_source *source, int32_t low, int32_t high)
{
    return low + (int32_t)random_below(source, (uint32_t)(high - low + 1));
}

static bool
is_among(site p, const site *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        if (plane_same(p, points[i]))
            return true;
    return false;
}

void
cases_shuffle(random_source *source, site *points, uint32_t n)
{
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_below(source, i);
        site chosen = points[j];
        points[j] = points[i - 1];
        points[i - 1] = chosen;
    }
}

static void
anywhere(random_source *source, site *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        points[i].x = integer(source, -PLANE_REACH, PLANE_REACH);
        points[i].y = integer(source, -PLANE_REACH, PLANE_REACH);
    }
}

/* Different points of the smallest square grid that has twice as many. */
static void
on_a_grid(random_source *source, site *points, uint32_t n)
{
    int32_t side = 2;
    while ((uint32_t)(side * side) < 2 * n)
        side++;
    for (uint32_t i = 0; i < n; i++)
        do {
            points[i].x = integer(source, 0, side - 1);
            points[i].y = integer(source, 0, side - 1);
        } while (is_among(points[i], points, i));
}

/* Half of them on the circle with radius 65 around the origin, as far as its 36
 * integer points go; the others on a grid inside. */
static void
around_a_circle(random_source *source, site *points, uint32_t n)
{
    static const site on_circle[5] = {{65, 0}, {16, 63}, {25, 60}, {33, 56}, {39, 52}};
    for (uint32_t i = 0; i < n; i++)
        do {
            site p = on_circle[random_below(source, 5)];
            if (random_below(source, 2) == 0)
                p = (site){p.y, p.x};
            if (i >= 24 || random_below(source, 3) == 0)
                p = (site){integer(source, 0, 64), integer(source, 0, 64)};
            p.x = random_below(source, 2) == 0 ? p.x : -p.x;
            p.y = random_below(source, 2) == 0 ? p.y : -p.y;
            points[i] = p;
        } while (is_among(points[i], points, i));
}

static void
on_a_line(random_source *source, site *points, uint32_t n)
{
    site d = {0, 0};
    while (d.x == 0 && d.y == 0)
        d = (site){integer(source, -3, 3), integer(source, -3, 3)};
    int32_t side = 2 * (int32_t)n < 1300 ? 2 * (int32_t)n : 1300;
    for (uint32_t i = 0; i < n; i++) {
        int32_t t = integer(source, -side / 2, side / 2);
        points[i] = (site){t * d.x, t * d.y};
    }
}

static void
with_duplicates(random_source *source, site *points, uint32_t n)
{
    int32_t side = 1;
    while ((uint32_t)(side * side) < n / 2)
        side++;
    for (uint32_t i = 0; i < n; i++) {
        points[i].x = integer(source, 0, side);
        points[i].y = integer(source, 0, side);
    }
}

/* (t, t^2 / 4096), which is strictly convex for even steps of t that are large enough;
 * for many points (t, t^2) around t = 0. */
static void
on_a_parabola(site *points, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        int32_t t = (int32_t)i - (int32_t)(n / 2);
        points[i] = (site){t, t * t};
    }
}

uint32_t
cases_draw(random_source *source, unsigned families, uint32_t most, site *points)
{
    assert(most >= 3 && families != 0);
    unsigned family;
    do
        family = 1u << random_below(source, 7);
    while ((families & family) == 0);

    uint32_t limit = most;
    while (limit > 8 && random_below(source, 2) == 0)
        limit /= 2;
    uint32_t n = family == CASES_FEW ? random_below(source, 4)
                                     : 3 + random_below(source, limit - 2);
    if (family == CASES_CONVEX && n > 120)
        n = 120;
    if (family == CASES_GENERAL)
        anywhere(source, points, n);
    else if (family == CASES_GRID)
        on_a_grid(source, points, n);
    else if (family == CASES_COCIRCULAR)
        around_a_circle(source, points, n);
    else if (family == CASES_COLLINEAR)
        on_a_line(source, points, n);
    else if (family == CASES_CONVEX)
        on_a_parabola(points, n);
    else
        with_duplicates(source, points, n);
    cases_shuffle(source, points, n);
    return n;
}

uint32_t
cases_locations(const site *points, uint32_t n, uint32_t *lowest)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < n; i++)
        if (!is_among(points[i], points, i))
            lowest[count++] = i;
    return count;
}

bool
cases_are_collinear(const site *points, uint32_t n)
{
    uint32_t other = 0;
    while (other < n && plane_same(points[other], points[0]))
        other++;
    for (uint32_t i = other; i < n; i++)
        if (plane_orient(points[0], points[other], points[i]) != 0)
            return false;
    return true;
}
