/* expansion.h - exact sums and products of doubles, kept as sums of doubles.
 *
 * Notes: section 3.4 (its page proves every claim made here). Needs: nothing.
 *
 * A rounded sum or product loses a part that is again a double and can be
 * computed. So a real number that needs 200 bits is written as a sum of
 * doubles, an expansion: after Dekker (1971), Priest (1991), Shewchuk (1997).
 *
 * Everything here requires rounding to nearest, and no fused multiplications
 * (-ffp-contract=off): expansion.c says so to the compilers that listen.
 */
#ifndef LIB_EXPANSION_H
#define LIB_EXPANSION_H

/* A rounded result and what rounding took from it: high + low is exact, and low
 * is at most half a unit in the last place of high. */
typedef struct exact_pair {
    double high, low;
} exact_pair;

/* a + b. Exact unless high overflows; gradual underflow does no harm. */
exact_pair two_sum(double a, double b);

/* a - b. Exact unless high overflows. */
exact_pair two_diff(double a, double b);

/* a * b.
 *
 * Exact if |a|, |b| <= 2^996, |ab| < 2^1023, and a and b are multiples of
 * powers of two whose product is at least 2^-1074: then no step over- or
 * underflows. */
exact_pair two_product(double a, double b);

/* A real number: the exact sum of part[0 .. size-1], which are not zero, grow
 * in magnitude and do not overlap: the highest bit of each is below the lowest
 * bit of the next. So the last part decides the sign. Zero has no parts. */
typedef struct expansion {
    const double *part;
    int size;
} expansion;

/* Where the parts live. There is room for the largest formula of section 3.4,
 * the incircle determinant with two parts to each of its six differences:
 *
 *   12 for the differences, 3*(8+8+8+16) for the minors, 3*(8+8+16) for the
 *   lifts, 3*512 for their products, 1024 and 1536 for the sum: 4324.
 *
 * On entry: used = 0, the rest may be uninitialised. */
typedef struct expansion_room {
    double part[4324];
    int used; /* part[0 .. used-1] are taken */
} expansion_room;

/* The results below live in *room, until it is gone. Too little room is misuse
 * (an assert). They are exact if every product of two parts meets the
 * conditions of two_product, and no sum overflows. */

/* The number a - b; at most 2 parts. */
expansion expansion_difference(expansion_room *room, double a, double b);

/* e + f; at most e.size + f.size parts, in as many steps. */
expansion expansion_plus(expansion_room *room, expansion e, expansion f);

/* e - f; the same. Takes room for f.size parts more. */
expansion expansion_minus(expansion_room *room, expansion e, expansion f);

/* e * f; at most 2 * e.size * f.size parts, in at most that many steps times
 * ceil(log2(e.size)) + ceil(log2(f.size)) + 1. Works in twice the room that the
 * result needs. */
expansion expansion_times(expansion_room *room, expansion e, expansion f);

/* +1, 0 or -1. */
int expansion_sign(expansion e);

#endif
