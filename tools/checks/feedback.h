/* feedback.h - what a student is told of a property that does not hold.
 */
#ifndef TOOLS_CHECKS_FEEDBACK_H
#define TOOLS_CHECKS_FEEDBACK_H

#include "tools/checks/session.h"

#include <stdio.h>

enum { CHECKER_FAULT = 1 }; /* exit status: the checker itself has failed */

/* What was asked for on the command line (checker.c). */
typedef struct request {
    const char *exercise, *property, *variant, *instances, *feedback;
    const char *again, *again_case; /* commands that run it again */
    const char *points;             /* of --case, or NULL */
    uint64_t seed;
} request;

enum { MOST_POINTS = 1000 };

typedef struct failure {
    const property *of;
    uint64_t seed;
    fate end;
    site points[MOST_POINTS];
    uint32_t n;
    bool is_a_case; /* it fails with --case and its points, whatever else was drawn */
} failure;

/* Reports the failure of the session's last trial: to standard output, and, if there is
 * a folder for it, as a text, a picture and a line of the table. */
void
feedback_failure(const session *s, const failure *f, const request *r, FILE *table);

/* A file to be written; whatever goes wrong ends the checker. */
FILE *feedback_open(const char *path);
void feedback_close(FILE *file, const char *path);

/* The points as letters on a grid, each line behind a margin, if they are few and no
 * two would share a place (sketch.c). */
void sketch_print(FILE *file, const char *margin, const site *points, uint32_t n);

#endif
