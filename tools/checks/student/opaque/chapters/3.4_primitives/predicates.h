/* predicates.h - the questions of section 3.4 in opaque mode: each is sent to the
 * checker, which knows the points, answers, and counts.
 *
 * In this mode a point2 is a ticket. Its coordinates say nothing about the place of the
 * point, and are different each time. Directions alone are what they are.
 */
#ifndef CHAPTERS_3_4_PREDICATES_H
#define CHAPTERS_3_4_PREDICATES_H

#include "lib/point.h"
#include "tools/checks/wire.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define PREDICATE_COUNT(what) ((void)0)

int64_t driver_ask(wire_kind kind, const uint64_t *word, size_t count);

static inline int
ask_about(wire_kind kind, point2 a, point2 b, point2 c, point2 d, size_t points)
{
    const uint64_t word[8] = {word_of_real(a.x), word_of_real(a.y), word_of_real(b.x),
                              word_of_real(b.y), word_of_real(c.x), word_of_real(c.y),
                              word_of_real(d.x), word_of_real(d.y)};
    return (int)driver_ask(kind, word, 2 * points);
}

static inline int
orient2d(point2 a, point2 b, point2 c)
{
    return ask_about(WIRE_ORIENT, a, b, c, c, 3);
}

static inline int
compare_along(point2 d, point2 p, point2 q)
{
    return ask_about(WIRE_ALONG, d, p, q, q, 3);
}

static inline int
dot_sign(point2 p, point2 r, point2 q)
{
    return ask_about(WIRE_DOT, p, r, q, q, 3);
}

static inline int
compare_distance(point2 p, point2 q, point2 r, point2 s)
{
    return ask_about(WIRE_DISTANCE, p, q, r, s, 4);
}

static inline int
incircle(point2 a, point2 b, point2 c, point2 d)
{
    return ask_about(WIRE_INCIRCLE, a, b, c, d, 4);
}

/* (p-q) x (r-s), if the vectors end in the same point. */
static inline int
cross_sign(point2 p, point2 q, point2 r, point2 s)
{
    if (q.x != s.x || q.y != s.y)
        abort(); /* nobody asks this */
    return orient2d(p, r, q);
}

/* A point of space has no ticket: what asks this is checked in plain mode. */
static inline int
orient3d(point3 a, point3 b, point3 c, point3 d)
{
    (void)a, (void)b, (void)c, (void)d;
    abort();
}

#endif
