/* decimal.h - doubles as decimal text, whatever the locale.
 *
 * Needs: nothing.
 *
 * What is written reads back as the same double, -0 and subnormals included.
 */
#ifndef LIB_DECIMAL_H
#define LIB_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The longest text that decimal_write makes, its closing NUL included. */
#define DECIMAL_ROOM 32

typedef enum decimal_result {
    DECIMAL_NUMBER,
    DECIMAL_NO_NUMBER, /* not of the form below */
    DECIMAL_TOO_LARGE  /* of that form, and rounded it would be infinite */
} decimal_result;

/* Reads the whole of text[0..length) as [+-]digits[.digits][e[+-]digits], where
 * the digits on one side of the point may be missing; *value is the double
 * nearest to it.
 *
 * No hexadecimals, no words (nan, inf), no spaces.
 * Cost: O(length).
 */
decimal_result decimal_read(const char *text, size_t length, double *value);

/* Whole numbers below 2^53 in full, others with the fewest of 15, 16 and 17
 * digits that read back as `value`; returns the number of characters, without the
 * closing NUL.
 * Requires: value is finite, room for DECIMAL_ROOM characters. */
int decimal_write(char *text, double value);

/* The same for a whole number. */
int decimal_write_integer(char *text, uint64_t value);

#endif
