/* program.h - a student's program, seen from the checker: a process that is given a
 * case, asks questions, and answers; or does not.
 *
 * Nothing that it says is believed, and nothing that it does can hurt: what it writes
 * is bounded, and so is its time.
 */
#ifndef TOOLS_CHECKS_PROGRAM_H
#define TOOLS_CHECKS_PROGRAM_H

#include "tools/checks/plane.h"
#include "tools/checks/wire.h"

#include <sys/types.h>

/* How a case ended. */
typedef enum fate {
    FATE_ANSWERED,
    FATE_TODO,      /* the function has not been written */
    FATE_CRASH,     /* a signal: a bad pointer, ... */
    FATE_ASSERT,    /* abort(): an assertion failed */
    FATE_UNDEFINED, /* the trap of the undefined-behaviour sanitizer */
    FATE_TIMEOUT,   /* no answer within the time */
    FATE_ENDED,     /* it ended without an answer */
    FATE_MALFORMED, /* it sent something that is no message */
    FATE_FORBIDDEN  /* the jail ended it: a forbidden system call */
} fate;

enum { MOST_DRAWN = 64 }; /* random numbers in a case; more are too many */

/* What the questions of a case are about, and how many were asked. */
typedef struct questions {
    const site *at;        /* point -> where it is */
    const uint32_t *owner; /* ticket -> point, in disorder; NULL in plain mode */
    uint32_t n;
    uint64_t asked[WIRE_KINDS];

    /* WIRE_RANDOM: the k-th answer is chosen[k], or 0; below[k] is what was asked. */
    const uint32_t *chosen;
    uint32_t choices;
    uint32_t below[MOST_DRAWN];
    uint32_t drawn;
} questions;

typedef struct program {
    char **command; /* how it is started; ends with NULL */
    pid_t pid;      /* 0: it does not run */
    int to, from, chatter;
    char said[4097]; /* the last 4 KB of its standard error and output, with '\0' */
    size_t said_count;
    int status; /* of waitpid, when it has ended */
} program;

/* Sends the case and serves the questions until there is an answer; starts the program
 * if it does not run. Limits: `seconds` of wall time, WIRE_MOST_WORDS. After any fate
 * but FATE_ANSWERED the program has been ended. */
fate program_ask(program *p, const words *given, questions *q, double seconds,
                 words *answer);

/* Ends it, with everything that it started. */
void program_end(program *p);

/* A sentence about a fate, for the student. */
const char *fate_text(fate f);

/* The same in one word, for tables: "pass" is not among them. */
const char *fate_word(fate f);

/* What a property does that came out so: "fails" when there was an answer, a wrong
 * one. */
const char *fate_verb(fate f);

#endif
