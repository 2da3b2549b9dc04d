/* lib/expansion.h: sums and products lose nothing, and the parts of a result do
 * not overlap, so that the largest one has the sign.
 *
 * Hypotheses: the ranges of the contracts; all numbers here are multiples of
 * 2^-250, below 2^200.
 */
#include "lib/expansion.h"
#include "tests/harness/harness.h"
#include "tests/oracle/big.h"
#include "tests/oracle/oracle.h"

#include <math.h>
#include <stdbool.h>

/* ---- Numbers that are hard to add. ---- */

/* A double with few bits, or all of them, or all ones, next to 2^exponent. */
static double
number(random_source *source, int exponent)
{
    uint32_t kind = random_below(source, 4);
    double x = kind == 0   ? 1
               : kind == 1 ? 1 + random_unit(source)
               : kind == 2 ? 2 - ldexp(1, -(int)random_below(source, 53))
                           : 1 + ldexp(random_below(source, 8), -52);
    return ldexp(random_below(source, 2) == 0 ? x : -x, exponent);
}

/* An expansion as the formulas make them: sums of numbers of related magnitude,
 * with cancellation. At most 2 * terms parts. */
static expansion
some_expansion(random_source *source, expansion_room *room, uint32_t terms)
{
    expansion e = {room->part, 0};
    int exponent = (int)random_below(source, 40) - 20;
    for (uint32_t i = 0; i < terms; i++) {
        double a = number(source, exponent), b = number(source, exponent);
        e = expansion_plus(room, e, expansion_difference(room, a, b));
        exponent += (int)random_below(source, 80) - 45;
        if (exponent < -140 || exponent > 60)
            exponent = 0;
    }
    return e;
}

/* ---- What is claimed of a result. ---- */

enum { UNIT = -250 };

static big
value(expansion e)
{
    big sum = {0};
    for (int i = 0; i < e.size; i++) {
        big part = big_from_double(e.part[i], 2 * UNIT);
        sum = big_add(&sum, &part);
    }
    return sum;
}

/* Do the parts grow, without overlap and without zeros? */
static bool
is_expansion(expansion e)
{
    for (int i = 0; i < e.size; i++)
        if (e.part[i] == 0 ||
            (i > 0 && fabs(e.part[i - 1]) >= ldexp(1, big_unit(e.part[i]))))
            return false;
    return true;
}

/* ---- The properties. They draw their own numbers. ---- */

static void
pairs_are_exact(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    random_source *source = test_random_source();
    int exponent = (int)random_below(source, 100) - 50;
    int other = exponent + (int)random_below(source, 130) - 65;
    double a = number(source, exponent), b = number(source, other);

    exact_pair sum = two_sum(a, b), difference = two_diff(a, b);
    CLAIM("sec3.4.P7", sum.high == a + b && difference.high == a - b,
          "%a and %a: not the rounded sum", a, b);
    CLAIM("sec3.4.P7",
          oracle_sum((double[]){a, b, -sum.high, -sum.low}, 4) == 0,
          "%a + %a is not %a + %a", a, b, sum.high, sum.low);
    CLAIM("sec3.4.P7",
          oracle_sum((double[]){a, -b, -difference.high, -difference.low}, 4) ==
              0,
          "%a - %a is not %a + %a", a, b, difference.high, difference.low);
    CLAIM("sec3.4.P7", sum.high + sum.low == sum.high, "%a, %a", sum.high,
          sum.low);

    exact_pair product = two_product(a, b);
    const double parts[2] = {product.high, product.low};
    CLAIM("sec3.4.P8", product.high == a * b, "%a times %a is not rounded", a,
          b);
    CLAIM("sec3.4.P8", oracle_product_minus_sum(a, b, parts, 2) == 0,
          "%a * %a is not %a + %a", a, b, product.high, product.low);
}

/* Factors that are multiples of 2^-537 and nearly as small, or nearly 2^996. */
static void
products_are_exact_up_to_the_limits(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    random_source *source = test_random_source();
    double small = random_unit(source) * 0x1p53,
           other = random_unit(source) * 0x1p53;
    double a = ldexp(small, -537), b = ldexp(other, -537);
    exact_pair product = two_product(a, b);
    CLAIM("sec3.4.P8",
          oracle_product_minus_sum(a, b, (double[]){product.high, product.low},
                                   2) == 0,
          "%a * %a is not %a + %a", a, b, product.high, product.low);

    a = ldexp(small, 996 - 53);
    b = ldexp(other, 26 - 53);
    product = two_product(a, b);
    CLAIM("sec3.4.P8",
          oracle_product_minus_sum(a, b, (double[]){product.high, product.low},
                                   2) == 0,
          "%a * %a is not %a + %a", a, b, product.high, product.low);
}

static void
expansions_are_exact(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    random_source *source = test_random_source();
    expansion_room room;
    room.used = 0;
    expansion e = some_expansion(source, &room, random_below(source, 7));
    expansion f = some_expansion(source, &room, random_below(source, 7));
    if (random_below(source, 4) == 0) /* nearly cancelling */
        f = expansion_minus(&room, f, e);
    big value_e = value(e), value_f = value(f);
    expansion plus = expansion_plus(&room, e, f),
              minus = expansion_minus(&room, e, f);

    big sum = big_add(&value_e, &value_f), seen_sum = value(plus);
    big difference = big_subtract(&value_e, &value_f),
        seen_difference = value(minus);
    big error = big_subtract(&sum, &seen_sum);
    CLAIM("sec3.4.P9", is_expansion(plus) && is_expansion(minus),
          "parts overlap: %d and %d parts", e.size, f.size);
    CLAIM("sec3.4.P9", error.sign == 0, "wrong sum of %d and %d parts", e.size,
          f.size);
    error = big_subtract(&difference, &seen_difference);
    CLAIM("sec3.4.P9", error.sign == 0, "wrong difference: %d and %d parts",
          e.size, f.size);
    CLAIM("sec3.4.P9",
          plus.size <= e.size + f.size && minus.size <= e.size + f.size,
          "%d and %d parts became %d and %d", e.size, f.size, plus.size,
          minus.size);
    CLAIM("sec3.4.P9",
          expansion_sign(plus) == sum.sign &&
              expansion_sign(minus) == difference.sign,
          "a wrong sign");
    CLAIM("sec3.4.P9", expansion_minus(&room, e, e).size == 0,
          "e - e is not empty");
}

/* value() counts in units of 2^(2*UNIT): those of the factors together. */
static void
products_are_exact(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    random_source *source = test_random_source();
    expansion_room room;
    room.used = 0;
    expansion e = some_expansion(source, &room, random_below(source, 6));
    expansion f = some_expansion(source, &room, random_below(source, 6));
    expansion product = expansion_times(&room, e, f);
    big expected = {0};
    for (int i = 0; i < e.size; i++)
        for (int j = 0; j < f.size; j++) {
            big a = big_from_double(e.part[i], UNIT),
                b = big_from_double(f.part[j], UNIT);
            big term = big_multiply(&a, &b);
            expected = big_add(&expected, &term);
        }
    big seen = value(product), error = big_subtract(&expected, &seen);
    CLAIM("sec3.4.P10", is_expansion(product), "parts overlap: %d * %d", e.size,
          f.size);
    CLAIM("sec3.4.P10", error.sign == 0, "wrong product of %d and %d parts",
          e.size, f.size);
    CLAIM("sec3.4.P10", product.size <= 2 * e.size * f.size,
          "%d * %d became %d", e.size, f.size, product.size);
    CLAIM("sec3.4.P10", expansion_sign(product) == expected.sign,
          "a wrong sign");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/expansion: nothing is lost");
    test_random("sums and products of two doubles", pairs_are_exact, 10000, 0);
    test_random("products at the limits", products_are_exact_up_to_the_limits,
                1000, 0);
    test_random("sums of expansions", expansions_are_exact, 4000, 0);
    test_random("products of expansions", products_are_exact, 1500, 0);
    return test_end((test_minima){.trials = 16000});
}
