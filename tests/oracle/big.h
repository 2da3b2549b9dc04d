/* big.h - integers of any size that the tests need, by schoolbook arithmetic.
 *
 * Needs: nothing; in particular nothing of lib/ and chapters/, which it judges.
 * Slow, and simple enough to be believed.
 */
#ifndef TESTS_ORACLE_BIG_H
#define TESTS_ORACLE_BIG_H

#include <stdint.h>

/* Room for products of four doubles of any magnitude: 4 * 2098 bits, and some.
 */
enum { BIG_DIGITS = 272 };

/* sign * (the sum of digit[i] * 2^(32 i)); the highest digit is not 0, and zero
 * has none. */
typedef struct big {
    int sign; /* +1, 0, -1 */
    int size;
    uint32_t digit[BIG_DIGITS];
} big;

/* The exponent of the lowest set bit of x: x is an odd multiple of 2^this.
 * Requires: x is finite and not 0. */
int big_unit(double x);

/* x / 2^unit. Requires: that is an integer. */
big big_from_double(double x, int unit);

big big_add(const big *a, const big *b);
big big_subtract(const big *a, const big *b);
big big_multiply(const big *a, const big *b);

#endif
