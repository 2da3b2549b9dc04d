/* shrink.c - from a counterexample to one that a person can draw.
 *
 * Big steps first: half of the points at a time, then quarters, down to single
 * points. Then the same number of points with coordinates from a small grid, the
 * smallest that will do; and at last each coordinate for itself. A step is kept when
 * the test still fails in the same way.
 */
#include "tests/harness/internal.h"

#include "lib/decimal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static unsigned runs_left;

static bool
try_points(const point2 *points, uint32_t n)
{
    if (runs_left == 0)
        return false;
    runs_left--;
    return still_fails(points, n);
}

/* Without points[at .. at+count). */
static void
copy_without(point2 *to, const point2 *points, uint32_t n, uint32_t at, uint32_t count)
{
    memcpy(to, points, at * sizeof *to);
    memcpy(to + at, points + at + count, (n - at - count) * sizeof *to);
}

/* Drops runs of `count` points as long as one can be dropped. */
static uint32_t
drop_runs(point2 *points, uint32_t n, uint32_t count, point2 *trial)
{
    for (uint32_t at = 0; at + count <= n;) {
        copy_without(trial, points, n, at, count);
        if (try_points(trial, n - count)) {
            n -= count;
            memcpy(points, trial, n * sizeof *points);
        } else {
            at += count;
        }
    }
    return n;
}

static uint32_t
drop_points(point2 *points, uint32_t n, point2 *trial)
{
    for (uint32_t count = n / 2; count > 1; count /= 2)
        n = drop_runs(points, n, count, trial);
    for (uint32_t before = 0; before != n;) { /* until no single point can go */
        before = n;
        n = drop_runs(points, n, 1, trial);
    }
    return n;
}

/* The points, moved and scaled so that they just fill the grid 0..side, rounded. */
static void
round_to_grid(point2 *to, const point2 *points, uint32_t n, int side)
{
    point2 low = points[0], high = points[0];
    for (uint32_t i = 1; i < n; i++) {
        low = (point2){fmin(low.x, points[i].x), fmin(low.y, points[i].y)};
        high = (point2){fmax(high.x, points[i].x), fmax(high.y, points[i].y)};
    }
    /* halved, so that the width of huge points does not overflow */
    double width = fmax(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);
    for (uint32_t i = 0; i < n; i++) {
        double x = width > 0 ? (points[i].x / 2 - low.x / 2) / width : 0;
        double y = width > 0 ? (points[i].y / 2 - low.y / 2) / width : 0;
        to[i] = (point2){floor(x * side + 0.5), floor(y * side + 0.5)};
    }
}

/* Moves all points to the smallest grid on which some drawing still fails. */
static void
redraw(point2 *points, uint32_t n, point2 *trial)
{
    enum { DRAWINGS = 60 };
    random_source source = random_from_seed(n);
    for (int side = 1; side <= 64; side = side < 4 ? side + 1 : 2 * side) {
        round_to_grid(trial, points, n, side);
        bool found = try_points(trial, n);
        for (int i = 0; !found && i < DRAWINGS && n <= 8; i++) {
            for (uint32_t j = 0; j < n; j++) {
                trial[j].x = random_below(&source, (uint32_t)side + 1);
                trial[j].y = random_below(&source, (uint32_t)side + 1);
            }
            found = try_points(trial, n);
        }
        if (found) {
            memcpy(points, trial, n * sizeof *points);
            return;
        }
    }
}

/* Fewer characters are simpler; then smaller numbers are; then positive ones. */
static bool
is_simpler(double x, double than)
{
    char text[DECIMAL_ROOM];
    int length = decimal_write(text, x), than_length = decimal_write(text, than);
    if (length != than_length)
        return length < than_length;
    return fabs(x) < fabs(than) || (fabs(x) == fabs(than) && x > than);
}

/* Replaces single coordinates by simpler ones. */
static void
simplify(point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < 2 * n; i++) {
        double *coordinate = i % 2 == 0 ? &points[i / 2].x : &points[i / 2].y;
        int exponent;
        double old = *coordinate, mantissa = frexp(old, &exponent);
        const double candidate[6] = {0, 1, 2, floor(old),
                                     ldexp(mantissa < 0 ? -0.5 : 0.5, exponent),
                                     ldexp(floor(64 * mantissa), exponent - 6)};
        for (int c = 0; c < 6; c++) {
            *coordinate = candidate[c];
            if (is_simpler(*coordinate, old) && try_points(points, n))
                break;
            *coordinate = old;
        }
    }
}

uint32_t
shrink(point2 *points, uint32_t n, unsigned runs)
{
    point2 *trial = malloc((n + 1) * sizeof *trial);
    runs_left = trial != NULL ? runs : 0;
    n = drop_points(points, n, trial);
    if (n > 0) {
        redraw(points, n, trial);
        simplify(points, n);
        n = drop_points(points, n, trial);
    }
    free(trial);
    return n;
}
