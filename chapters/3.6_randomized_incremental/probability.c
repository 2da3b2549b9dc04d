/* probability.c - sums of exact fractions. */
#include "chapters/3.6_randomized_incremental/probability.h"

#include <assert.h>

/* ---- Exact fractions. ---- */

static const rational no_number = {0, 0};

static int64_t
absolute(int64_t a)
{
    return a < 0 ? -a : a;
}

static int64_t
greatest_common_divisor(int64_t a, int64_t b)
{
    while (b != 0) {
        int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* a * b into *product; false if it does not fit. Requires: neither is INT64_MIN. */
static bool
multiply(int64_t a, int64_t b, int64_t *product)
{
    if (a != 0 && absolute(b) > INT64_MAX / absolute(a))
        return false;
    *product = a * b;
    return true;
}

/* a + b into *sum; false if it does not fit. */
static bool
add(int64_t a, int64_t b, int64_t *sum)
{
    if (b > 0 ? a > INT64_MAX - b : a < -INT64_MAX - b)
        return false;
    *sum = a + b;
    return true;
}

rational
rational_of(int64_t num, int64_t den)
{
    if (den == 0 || num == INT64_MIN || den == INT64_MIN)
        return no_number;
    int64_t common = greatest_common_divisor(absolute(num), absolute(den));
    if (den < 0)
        common = -common;
    return (rational){num / common, den / common};
}

/* Over the least common denominator, so that no number is larger than need be. */
rational
rational_sum(rational a, rational b)
{
    if (a.den == 0 || b.den == 0)
        return no_number;
    int64_t common = greatest_common_divisor(a.den, b.den);
    int64_t left, right, num, den;
    if (!multiply(a.num, b.den / common, &left) ||
        !multiply(b.num, a.den / common, &right) || !add(left, right, &num) ||
        !multiply(a.den, b.den / common, &den))
        return no_number;
    return rational_of(num, den);
}

rational
rational_product(rational a, rational b)
{
    if (a.den == 0 || b.den == 0)
        return no_number;
    rational c = rational_of(a.num, b.den), d = rational_of(b.num, a.den);
    int64_t num, den;
    if (!multiply(c.num, d.num, &num) || !multiply(c.den, d.den, &den))
        return no_number;
    return rational_of(num, den);
}

rational
rational_quotient(rational a, rational b)
{
    return rational_product(a, rational_of(b.den, b.num));
}

bool
rational_equal(rational a, rational b)
{
    return a.den != 0 && a.den == b.den && a.num == b.num;
}

double
rational_value(rational a)
{
    return (double)a.num / (double)a.den;
}

/* ---- Probability spaces. ---- */

static const rational zero = {0, 1};

verdict
is_probability_space(probability_space S)
{
    if (S.outcomes == 0)
        return verdict_refuted("there is no outcome");
    rational sum = zero;
    for (uint32_t w = 0; w < S.outcomes; w++) {
        if (S.probability[w].den == 0 || S.probability[w].num < 0)
            return verdict_refuted("the probability of outcome %u is negative, or no "
                                   "number", (unsigned)w);
        sum = rational_sum(sum, S.probability[w]);
    }
    if (!rational_equal(sum, rational_of(1, 1)))
        return verdict_refuted("the probabilities add up to %lld/%lld",
                               (long long)sum.num, (long long)sum.den);
    return verdict_holds();
}

rational
probability_of(probability_space S, const bool *A)
{
    rational sum = zero;
    for (uint32_t w = 0; w < S.outcomes; w++)
        if (A[w])
            sum = rational_sum(sum, S.probability[w]);
    return sum;
}

rational
conditional_probability(probability_space S, const bool *A, const bool *B)
{
    rational both = zero;
    for (uint32_t w = 0; w < S.outcomes; w++)
        if (A[w] && B[w])
            both = rational_sum(both, S.probability[w]);
    return rational_quotient(both, probability_of(S, B));
}

rational
expected_value(probability_space S, const rational *R)
{
    rational sum = zero;
    for (uint32_t w = 0; w < S.outcomes; w++)
        sum = rational_sum(sum, rational_product(R[w], S.probability[w]));
    return sum;
}

/* ---- The game with three doors. ---- */

/* The car and the guess are each behind one of three doors. If they are the same,
 * one of the two others is opened, else the only one that is left. */
void
door_games(door_game outcome[DOOR_GAMES], rational probability[DOOR_GAMES])
{
    int count = 0;
    for (int car = 0; car < 3; car++)
        for (int guess = 0; guess < 3; guess++)
            for (int opened = 0; opened < 3; opened++) {
                if (opened == car || opened == guess)
                    continue;
                rational third = rational_of(1, 3);
                rational last = rational_of(1, car == guess ? 2 : 1);
                outcome[count] = (door_game){car, guess, opened};
                probability[count++] =
                    rational_product(rational_product(third, third), last);
            }
    assert(count == DOOR_GAMES);
}

bool
wins_by_switching(door_game w)
{
    return w.guess != w.car;
}
