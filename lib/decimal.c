/* decimal.c - reading by exact short cuts where they are exact, else by strtod;
 * writing by snprintf, and reading back to see that nothing is lost. */
#include "lib/decimal.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading. ---- */

/* A halfway point between two doubles has at most 767 significant digits, so
 * the digits after that many matter only by being all zero or not. */
#define MOST_DIGITS 768

/* The number is (-1)^negative * digits * 10^exponent. */
typedef struct decimal {
    bool negative;
    int64_t exponent;
    uint64_t leading; /* the first digits, as far as they fit below 2^53 ... */
    bool all_leading; /* ... and whether these are all the digits there are */
    uint32_t count;   /* significant digits kept in `digit` */
    bool cut;         /* a digit other than 0 was not kept */
    char digit[MOST_DIGITS];
} decimal;

static bool
is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* One more digit, before the point or after it. */
static void
take_digit(decimal *d, char c, bool fraction)
{
    if (d->count == 0 && c == '0') {
        d->exponent -= fraction; /* a leading zero only moves the point */
        return;
    }
    if (d->count < MOST_DIGITS) {
        d->digit[d->count++] = c;
        d->exponent -= fraction;
    } else {
        d->cut |= c != '0';
        d->exponent += !fraction;
    }
    /* 9007199254740991 = 2^53 - 1 */
    uint64_t leading = 10 * d->leading + (uint64_t)(c - '0');
    if (d->all_leading && leading <= 9007199254740991u)
        d->leading = leading;
    else
        d->all_leading = false;
}

/* Reads text[0..length), which must be a whole exponent, and adds it. It stays
 * below 10^15: digits that could make up for more would not fit into memory. */
static bool
take_exponent(decimal *d, const char *text, size_t length)
{
    size_t i = 0;
    int sign = 1;
    if (i < length && (text[i] == '+' || text[i] == '-'))
        sign = text[i++] == '-' ? -1 : 1;
    if (i == length)
        return false;
    int64_t exponent = 0;
    for (; i < length; i++) {
        if (!is_digit(text[i]))
            return false;
        if (exponent < 100000000000000)
            exponent = 10 * exponent + (text[i] - '0');
    }
    d->exponent += sign * exponent;
    return true;
}

/* Takes the text apart; false when it has not the form of a number. */
static bool
parse(decimal *d, const char *text, size_t length)
{
    size_t i = 0;
    if (i < length && (text[i] == '+' || text[i] == '-'))
        d->negative = text[i++] == '-';
    bool fraction = false, any_digit = false;
    for (; i < length; i++) {
        if (is_digit(text[i])) {
            take_digit(d, text[i], fraction);
            any_digit = true;
        } else if (text[i] == '.' && !fraction) {
            fraction = true;
        } else {
            break;
        }
    }
    if (!any_digit)
        return false;
    if (i == length)
        return true;
    return (text[i] == 'e' || text[i] == 'E') &&
           take_exponent(d, text + i + 1, length - i - 1);
}

/* Both operands are doubles without error, so the one operation rounds once. */
static double
scale_exactly(uint64_t leading, int64_t exponent)
{
    static const double power[] = {
        1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    return exponent < 0 ? (double)leading / power[-exponent]
                        : (double)leading * power[exponent];
}

/* strtod sees digits and an exponent, and no point: that depends on the locale.
 * For more digits than are kept, a 1 stands for the rest. */
static double
ask_strtod(const decimal *d)
{
    char text[MOST_DIGITS + 32];
    uint32_t length = 0;
    for (uint32_t i = 0; i < d->count; i++)
        text[length++] = d->digit[i];
    int64_t exponent = d->exponent;
    if (d->cut) {
        text[length++] = '1';
        exponent--;
    }
    text[length++] = 'e';
    if (exponent < 0)
        text[length++] = '-';
    decimal_write_integer(text + length, (uint64_t)llabs(exponent));
    return strtod(text, NULL);
}

decimal_result
decimal_read(const char *text, size_t length, double *value)
{
    decimal d;
    d.negative = d.cut = false;
    d.exponent = 0;
    d.leading = 0;
    d.all_leading = true;
    d.count = 0; /* and digit[] is not filled: most numbers are short */
    if (!parse(&d, text, length))
        return DECIMAL_NO_NUMBER;

    double size;
    if (d.count == 0)
        size = 0;
    else if (d.all_leading && d.exponent >= -22 && d.exponent <= 22)
        size = scale_exactly(d.leading, d.exponent);
    else
        size = ask_strtod(&d);
    if (isinf(size))
        return DECIMAL_TOO_LARGE;
    *value = d.negative ? -size : size;
    return DECIMAL_NUMBER;
}

/* ---- Writing. ---- */

/* The digits of 0 .. 99, two each: half as many divisions. */
static const char pairs[] =
    "00010203040506070809101112131415161718192021222324"
    "25262728293031323334353637383940414243444546474849"
    "50515253545556575859606162636465666768697071727374"
    "75767778798081828384858687888990919293949596979899";

int
decimal_write_integer(char *text, uint64_t value)
{
    int length = 1; /* at most 20: then `power` would be 10^20, which is too large */
    for (uint64_t power = 10; length < 20 && value >= power; power *= 10)
        length++;
    int at = length;
    text[at] = '\0';
    for (; value >= 10; value /= 100) {
        at -= 2;
        memcpy(text + at, pairs + 2 * (value % 100), 2);
    }
    if (at > 0)
        text[0] = (char)('0' + value);
    return length;
}

/* printf's %g, with a point in place of whatever the locale puts between the
 * digits (which may be more than one character). */
static int
write_digits(char *text, double value, int digits)
{
    char printed[64];
    snprintf(printed, sizeof printed, "%.*g", digits, value);
    int length = 0;
    bool between = false;
    for (const char *c = printed; *c != '\0'; c++) {
        bool ours = is_digit(*c) || *c == '-' || *c == '+' || *c == 'e';
        if (ours)
            text[length++] = *c;
        else if (!between)
            text[length++] = '.';
        between = !ours;
    }
    text[length] = '\0';
    return length;
}

int
decimal_write(char *text, double value)
{
    assert(isfinite(value));
    /* Whole numbers are frequent, and quick; -0 keeps its sign below. */
    if (fabs(value) < 0x1p53 && value == floor(value) && !signbit(value))
        return decimal_write_integer(text, (uint64_t)value);

    for (int digits = 15;; digits++) {
        int length = write_digits(text, value, digits);
        double back = 0;
        if (digits == 17 ||
            (decimal_read(text, (size_t)length, &back) == DECIMAL_NUMBER &&
             back == value))
            return length;
    }
}
