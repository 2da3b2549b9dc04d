/* big.c - schoolbook arithmetic. Too little room is an assert. */
#include "tests/oracle/big.h"

#include <assert.h>
#include <math.h>

int
big_unit(double x)
{
    int exponent;
    double fraction = frexp(x, &exponent);
    while (fraction != floor(fraction)) {
        fraction *= 2;
        exponent--;
    }
    return exponent;
}

big
big_from_double(double x, int unit)
{
    big result = {0};
    if (x == 0)
        return result;
    int exponent = big_unit(x), at = exponent - unit;
    uint64_t bits = (uint64_t)ldexp(frexp(fabs(x), &exponent), 53);
    while (bits % 2 == 0) /* now |x| = bits * 2^(at + unit) */
        bits /= 2;
    assert(at >= 0 && at / 32 + 3 <= BIG_DIGITS);
    result.sign = x > 0 ? +1 : -1;
    for (int i = 0; i < 53; i++)
        if (bits >> i & 1) {
            result.size = (at + i) / 32 + 1;
            result.digit[(at + i) / 32] |= UINT32_C(1) << (at + i) % 32;
        }
    return result;
}

/* The sign of |a| - |b|. */
static int
compare_magnitudes(const big *a, const big *b)
{
    if (a->size != b->size)
        return a->size > b->size ? +1 : -1;
    for (int i = a->size; i > 0; i--)
        if (a->digit[i - 1] != b->digit[i - 1])
            return a->digit[i - 1] > b->digit[i - 1] ? +1 : -1;
    return 0;
}

static uint32_t
digit_of(const big *a, int i)
{
    return i < a->size ? a->digit[i] : 0;
}

/* sign * (|a| + |b|) */
static big
add_magnitudes(const big *a, const big *b, int sign)
{
    big sum = {.sign = sign};
    uint64_t carry = 0;
    for (int i = 0; i < a->size || i < b->size || carry != 0; i++) {
        assert(i < BIG_DIGITS);
        carry += (uint64_t)digit_of(a, i) + digit_of(b, i);
        sum.digit[i] = (uint32_t)carry;
        sum.size = i + 1;
        carry >>= 32;
    }
    return sum;
}

/* sign * (|a| - |b|). Requires: |a| > |b|. */
static big
subtract_magnitudes(const big *a, const big *b, int sign)
{
    big rest = {.sign = sign};
    int64_t borrow = 0;
    for (int i = 0; i < a->size; i++) {
        int64_t digit = (int64_t)a->digit[i] - digit_of(b, i) - borrow;
        borrow = digit < 0;
        rest.digit[i] = (uint32_t)(digit + borrow * (INT64_C(1) << 32));
        if (rest.digit[i] != 0)
            rest.size = i + 1;
    }
    assert(borrow == 0);
    return rest;
}

big
big_add(const big *a, const big *b)
{
    if (a->sign == 0)
        return *b;
    if (b->sign == 0)
        return *a;
    if (a->sign == b->sign)
        return add_magnitudes(a, b, a->sign);
    int order = compare_magnitudes(a, b);
    if (order == 0)
        return (big){0};
    return order > 0 ? subtract_magnitudes(a, b, a->sign)
                     : subtract_magnitudes(b, a, b->sign);
}

big
big_subtract(const big *a, const big *b)
{
    big negative = *b;
    negative.sign = -b->sign;
    return big_add(a, &negative);
}

big
big_multiply(const big *a, const big *b)
{
    big product = {.sign = a->sign * b->sign};
    if (product.sign == 0)
        return product;
    assert(a->size + b->size <= BIG_DIGITS);
    for (int i = 0; i < a->size; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < b->size; j++) {
            carry += (uint64_t)a->digit[i] * b->digit[j] + product.digit[i + j];
            product.digit[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        product.digit[i + b->size] = (uint32_t)carry;
    }
    product.size = a->size + b->size;
    if (product.digit[product.size - 1] == 0)
        product.size--;
    return product;
}
