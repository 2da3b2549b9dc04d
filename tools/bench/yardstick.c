/* yardstick.c - quicksort, as plain as it can be while it is as fast as the best. */
#include "tools/bench/yardstick.h"

#include <stdbool.h>
#include <stdint.h>

enum { SHORT = 16 }; /* so many points are sorted by insertion */

static inline bool
before(point2 p, point2 q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

static inline void
exchange(point2 *p, point2 *q)
{
    point2 t = *p;
    *p = *q;
    *q = t;
}

static void
sort_short(point2 *point, size_t n)
{
    for (size_t i = 1; i < n; i++) {
        point2 p = point[i];
        size_t k = i;
        for (; k > 0 && before(p, point[k - 1]); k--)
            point[k] = point[k - 1];
        point[k] = p;
    }
}

/* A place below n. Speed is what counts here; a remainder is random enough. */
static inline size_t
some_place(uint64_t *state, size_t n)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (size_t)(*state >> 33) % n;
}

/* The median of three points at random places; they are points of the piece. */
static inline point2
pivot_of(const point2 *point, size_t n, uint64_t *state)
{
    point2 a = point[some_place(state, n)], b = point[some_place(state, n)],
           c = point[some_place(state, n)];
    if (before(b, a))
        exchange(&a, &b);
    if (before(c, a))
        return a;
    return before(c, b) ? c : b;
}

/* Exchanges points until none of point[0..k) is after the pivot and none of
 * point[k..n) before it; returns k, which is neither 0 nor n.
 *
 * Neither scan leaves the piece: the first two stop at the pivot at the latest, and
 * later ones at the points that have just been exchanged. So i < n at the end. It is
 * 0 only if nothing has been exchanged and j is 0 too: then the pivot is point[0],
 * all others are after it, and 1 will do. */
static inline size_t
partition(point2 *point, size_t n, point2 pivot)
{
    size_t i = 0, j = n;
    for (;;) {
        while (before(point[i], pivot))
            i++;
        do
            j--;
        while (before(pivot, point[j]));
        if (i >= j)
            return i > 0 ? i : 1;
        exchange(&point[i], &point[j]);
        i++;
    }
}

/* The shorter part is sorted by a call, the longer one by the loop: so the calls
 * are nested at most log2 n deep. */
static void
sort_piece(point2 *point, size_t n, uint64_t *state)
{
    while (n > SHORT) {
        size_t k = partition(point, n, pivot_of(point, n, state));
        if (k <= n - k) {
            sort_piece(point, k, state);
            point += k;
            n -= k;
        } else {
            sort_piece(point + k, n - k, state);
            n = k;
        }
    }
    sort_short(point, n);
}

void
yardstick_sort(point2 *point, size_t n)
{
    uint64_t state = 1;
    sort_piece(point, n, &state);
}
