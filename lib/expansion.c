/* expansion.c - error-free sums and products; page 3.4 proves P7 to P10. */
#include "lib/expansion.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
#ifdef __FAST_MATH__
#error "exact sums need IEEE arithmetic: compile without -ffast-math, -Ofast"
#endif

/* ---- Two doubles. ---- */

/* With |a| >= |b|, high - a is exact, and so is what b lacks to it (P7). */
exact_pair
two_sum(double a, double b)
{
    if (fabs(a) < fabs(b)) {
        double smaller = a;
        a = b;
        b = smaller;
    }
    double high = a + b;
    return (exact_pair){high, b - (high - a)};
}

exact_pair
two_diff(double a, double b)
{
    return two_sum(a, -b);
}

/* The 53 bits of a as 26 and 26: the sign of the lower half is the missing
 * one. */
static exact_pair
split(double a)
{
    double c = 0x8000001p0 * a; /* 2^27 + 1 */
    double high = c - (c - a);
    return (exact_pair){high, a - high};
}

/* The four products of halves are exact. Taken from `high`, largest first, they
 * leave just the rounding error, and no subtraction on the way rounds (P8). */
exact_pair
two_product(double a, double b)
{
    double high = a * b;
    exact_pair s = split(a), t = split(b);
    double rest = high - s.high * t.high;
    rest = rest - s.low * t.high;
    rest = rest - s.high * t.low;
    return (exact_pair){high, s.low * t.low - rest};
}

/* ---- Many doubles. ---- */

/* Room for `size` more parts. */
static double *
take(expansion_room *room, int size)
{
    assert(size <= (int)(sizeof room->part / sizeof *room->part) - room->used);
    double *part = room->part + room->used;
    room->used += size;
    return part;
}

/* The parts of a pair: up to two, the smaller one first. */
static expansion
from_pair(expansion_room *room, exact_pair pair)
{
    double *part = take(room, (pair.low != 0) + (pair.high != 0));
    int size = 0;
    if (pair.low != 0)
        part[size++] = pair.low;
    if (pair.high != 0)
        part[size++] = pair.high;
    return (expansion){part, size};
}

expansion
expansion_difference(expansion_room *room, double a, double b)
{
    return from_pair(room, two_diff(a, b));
}

/* Of two parts, the smaller one comes first; of equal ones, that of f. */
static bool
smaller_first(expansion e, int i, expansion f, int j)
{
    if (i == e.size || j == f.size)
        return i < e.size;
    return fabs(e.part[i]) < fabs(f.part[j]);
}

/* The parts of both, smallest first, run into a total that two doubles hold:
 * what does not fit any more can no longer be changed by what follows (P9). */
expansion
expansion_plus(expansion_room *room, expansion e, expansion f)
{
    double *part = take(room, e.size + f.size);
    int size = 0, i = 0, j = 0;
    exact_pair total = {0, 0};
    while (i < e.size || j < f.size) {
        bool from_e = smaller_first(e, i, f, j);
        double least = from_e ? e.part[i++] : f.part[j++];
        exact_pair next = two_sum(least, total.low);
        if (next.low != 0)
            part[size++] = next.low;
        total = two_sum(total.high, next.high);
    }
    if (total.low != 0)
        part[size++] = total.low;
    if (total.high != 0)
        part[size++] = total.high;
    room->used -= e.size + f.size - size;
    return (expansion){part, size};
}

expansion
expansion_minus(expansion_room *room, expansion e, expansion f)
{
    double *negative = take(room, f.size);
    for (int i = 0; i < f.size; i++)
        negative[i] = -f.part[i];
    return expansion_plus(room, e, (expansion){negative, f.size});
}

/* Half of an expansion is one: the longer factor is halved until both are
 * single doubles. The depth is log2 of both sizes. */
expansion
expansion_times(expansion_room *room, expansion e, expansion f)
{
    if (e.size < f.size)
        return expansion_times(room, f, e);
    if (f.size == 0)
        return f;
    if (e.size == 1)
        return from_pair(room, two_product(e.part[0], f.part[0]));

    int before = room->used, half = e.size / 2;
    expansion lower = {e.part, half}, upper = {e.part + half, e.size - half};
    lower = expansion_times(room, lower, f);
    upper = expansion_times(room, upper, f);
    expansion sum = expansion_plus(room, lower, upper);
    for (int i = 0; i < sum.size; i++) /* move it down over its summands */
        room->part[before + i] = sum.part[i];
    room->used = before + sum.size;
    return (expansion){room->part + before, sum.size};
}

int
expansion_sign(expansion e)
{
    if (e.size == 0)
        return 0;
    return e.part[e.size - 1] > 0 ? +1 : -1;
}
