/* wide.c - one long integer on the stack; skip it on first reading.
 *
 * An IEEE double is taken apart by its bits: that is what <float.h> vouches for
 * below, and all that is asked of it. */
#include "chapters/3.4_primitives/wide.h"

#include <assert.h>
#include <float.h>
#include <string.h>

static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 &&
                  sizeof(double) == sizeof(uint64_t),
              "doubles are IEEE binary64");

/* A product of four integers of 53 bits has 212 bits: 7 digits. */
enum { PRODUCT_DIGITS = 7 };

/* |x| = mantissa * 2^(shift - 1074), with 0 <= shift <= 2045. */
typedef struct parts {
    uint64_t mantissa;
    unsigned shift;
    int sign;
} parts;

static parts
take_apart(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    uint64_t fraction = bits & ((UINT64_C(1) << 52) - 1);
    unsigned exponent = (unsigned)(bits >> 52) & 2047;
    assert(exponent < 2047);
    parts p = {fraction, 0, bits >> 63 ? -1 : +1};
    if (exponent > 0) { /* else x is subnormal or zero */
        p.mantissa |= UINT64_C(1) << 52;
        p.shift = exponent - 1;
    }
    return p;
}

/* product *= factor, by the method taught at school: the two digits of the
 * factor one after the other. (2^32-1)^2 + 2 (2^32-1) = 2^64-1 just fits. */
static void
multiply(uint32_t product[PRODUCT_DIGITS], uint64_t factor)
{
    uint32_t result[PRODUCT_DIGITS] = {0};
    uint64_t digit[2] = {factor & UINT32_MAX, factor >> 32};
    for (int j = 0; j < 2; j++) {
        uint64_t carry = 0;
        for (int i = 0; i + j < PRODUCT_DIGITS; i++) {
            carry += product[i] * digit[j] + result[i + j];
            result[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    memcpy(product, result, sizeof result);
}

void
wide_clear(wide *w)
{
    memset(w, 0, sizeof *w);
}

void
wide_add(wide *w, int sign, double e, double f, double g, double h)
{
    const double factor[4] = {e, f, g, h};
    uint32_t product[PRODUCT_DIGITS] = {1};
    unsigned shift = 0;
    for (int i = 0; i < 4; i++) {
        if (factor[i] == 0)
            return;
        parts p = take_apart(factor[i]);
        multiply(product, p.mantissa);
        shift += p.shift;
        sign *= p.sign;
    }

    /* Each digit of the product falls on two neighbouring digits of the sum,
     * the highest on numbers 4*2045/32 + 6 and one more: 261 and 262. */
    int64_t *digit = w->digit + shift / 32;
    for (int i = 0; i < PRODUCT_DIGITS; i++) {
        uint64_t shifted = (uint64_t)product[i] << shift % 32;
        digit[i] += sign * (int64_t)(shifted & UINT32_MAX);
        digit[i + 1] += sign * (int64_t)(shifted >> 32);
    }
}

/* From the lowest digit to the highest, what exceeds 0 .. 2^32-1 is carried on.
 * In the end the digits are a number in 0 .. 2^8448 - 1, and the last carry
 * counts 2^8448: it is 0, or -1 when the sum is negative. */
int
wide_sign(const wide *w)
{
    int64_t carry = 0;
    uint32_t any_bit = 0;
    for (int i = 0; i < WIDE_DIGITS; i++) {
        carry += w->digit[i];
        uint32_t digit = (uint32_t)carry; /* modulo 2^32 */
        any_bit |= digit;
        carry = (carry - digit) / (INT64_C(1) << 32);
    }
    return carry < 0 ? -1 : any_bit != 0;
}
