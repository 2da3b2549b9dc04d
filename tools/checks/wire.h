/* wire.h - what a checker and a student's program say to each other.
 *
 * A message is a kind, a length, and that many words of 64 bits, in the order of the
 * machine: both ends are processes on one machine. The program reads from descriptor
 * 3 and writes to descriptor 4; its standard output and error are its own.
 *
 *     checker: CASE exercise, data ...      here is a case
 *     program: ORIENT a b c                 (opaque mode) where is c?
 *     checker: SIGN s
 *     program: ANSWER data ...              my answer
 *
 * Nothing in a message from the program is believed: the checker reads each word
 * with the range in which it must lie.
 */
#ifndef TOOLS_CHECKS_WIRE_H
#define TOOLS_CHECKS_WIRE_H

#include "lib/point.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { WIRE_FROM_CHECKER = 3, WIRE_TO_CHECKER = 4 };

enum { WIRE_MOST_WORDS = 1 << 17 }; /* no message is longer: 1 MB */

typedef enum wire_kind {
    WIRE_CASE,     /* to the program: the letter of the exercise, the data */
    WIRE_ANSWER,   /* from the program: the data */
    WIRE_TODO,     /* from the program: the function has not been written yet */
    WIRE_SIGN,     /* to the program: the answer to a question, as int64 */
    WIRE_ORIENT,   /* questions; each point is two words, the bits of two doubles */
    WIRE_INCIRCLE,
    WIRE_ALONG,    /* a direction and two points */
    WIRE_DISTANCE, /* p q r s: compare |pq| and |rs| */
    WIRE_DOT,
    WIRE_RANDOM,   /* a number below this one, please */
    WIRE_KINDS
} wire_kind;

/* A growing row of words. */
typedef struct words {
    uint64_t *word;
    size_t count, room;
} words;

/* Appends a word; ends the process when there is no memory. */
void words_put(words *w, uint64_t word);
void words_put_real(words *w, double x);
void words_clear(words *w);
void words_free(words *w);

/* A double and the word of its bits. */
uint64_t word_of_real(double x);
double real_of_word(uint64_t word);

/* Writes a message. false: the other end is gone. */
bool wire_write(int to, wire_kind kind, const uint64_t *word, size_t count);

/* Reads exactly so many bytes. false: end, or an error. */
bool wire_read_bytes(int from, void *bytes, size_t count);

#endif
