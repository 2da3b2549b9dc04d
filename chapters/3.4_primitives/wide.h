/* wide.h - a sum of products of four doubles, exact for every finite double.
 *
 * Notes: section 3.4; skip it on first reading. Needs: nothing.
 *
 * Every finite double is an integer times 2^-1074, so a product of four is an
 * integer times 2^-4296, and below 2^4096. One integer of 264 digits of 32 bits
 * holds the sum of any determinant's products: schoolbook arithmetic, without a
 * rounding to think about.
 */
#ifndef CHAPTERS_3_4_WIDE_H
#define CHAPTERS_3_4_WIDE_H

#include <stdint.h>

#define WIDE_DIGITS 264

/* The integer sum of digit[i] * 2^(32 i). A digit may have any value for a
 * while: carries wait for wide_sign. */
typedef struct wide {
    int64_t digit[WIDE_DIGITS];
} wide;

/* Zero. */
void wide_clear(wide *w);

/* Adds sign * e * f * g * h. For fewer factors, write 1 for the others.
 *
 * Requires: sign is +1 or -1; the factors are finite; at most 64 products since
 * wide_clear, so that nothing can overflow. */
void wide_add(wide *w, int sign, double e, double f, double g, double h);

/* +1, 0 or -1. Settles the carries, and leaves *w as it was. */
int wide_sign(const wide *w);

#endif
