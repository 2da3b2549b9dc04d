/* peer.h - what another library's program does here: the same work, on the same
 * clock.
 *
 * Needs: lib/triangles.h.
 *
 * A peer is a program in build/bench/peers/, called as `PEER POINTS [certify]`:
 * it reads the file of points, does its work for as long as the stopwatch
 * wants, and prints
 *
 *     user processor wall bytes right text
 *
 * in one line: the times and the memory of one round, and when asked to
 * certify, 1 or 0 and a phrase about its answer (else 1 and nothing). main.c
 * does all that; the three functions below are what is the peer's own. Any
 * program that prints such a line can be put there.
 */
#ifndef TOOLS_BENCH_PEER_H
#define TOOLS_BENCH_PEER_H

#include "lib/triangles.h"

#include <stdbool.h>
#include <stddef.h>

/* Off the clock: the points as the peer wants them, for at most `rounds`
 * rounds. */
bool peer_prepare(const point2 *points, uint32_t n, size_t rounds);

/* On the clock: triangulates (or sorts) them; what the round before has made is
 * freed. */
bool peer_round(void);

/* What the last round has made. */
typedef struct peer_answer {
    point2 *points; /* if the given ones had to be rounded: what they became */
    triangle_list list; /* of the triangles */
    bool sorted; /* the peer sorts: points are sorted, and there is no list */
} peer_answer;

/* Off the clock. The arrays are made by memory_array. False: there is no
 * answer. */
bool peer_result(peer_answer *out);

#endif
