/* jail.h - what the parts of the jail know of each other: the process inside, which
 * puts on the layers and becomes the program, and the one outside, which waits for its
 * end and tells how it came.
 *
 * Needs: tools/grade/confine.h.
 */
#ifndef TOOLS_GRADE_JAIL_H
#define TOOLS_GRADE_JAIL_H

#include "tools/grade/confine.h"

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

enum { FAULT = 125, MOST_OPENINGS = 40 };

typedef struct jail {
    bool compile; /* compile, not run */
    const char *report;
    double wall_seconds;
    limits most;
    bool required;
    int layers;                  /* that are wanted */
    opening open[MOST_OPENINGS]; /* for compile */
    size_t openings;
    const char *output;          /* for compile: the folder to write to */
    char **command;
    int binary;                  /* for run: the program, in memory */
} jail;

/* The layers and their names, from the outermost to the innermost. */
typedef struct layer {
    int bit;
    const char *name;
} layer;

enum { LAYERS = 4 };
extern const layer layers[LAYERS];

/* Ends the jail with status FAULT, and says what errno says, unless it is 0. */
_Noreturn void fault(const char *what);

/* ---- Inside (inside.c). ---- */

enum { BINARY = 5, TELL = 6 }; /* descriptors, closed when the program begins */

/* What the process has to say to the jail outside, until it is the program. */
typedef struct message {
    int layers;    /* that are on */
    int error;     /* errno, if it could not become the program */
    char what[60]; /* and at what it failed */
} message;

/* Puts on the layers and becomes the program; `outside` is the process that waits,
 * `tell` where messages go. */
_Noreturn void jail_inside(const jail *j, pid_t outside, int tell);

/* Descriptors 0 to 4 that nobody has given lead nowhere, so that no file of the jail's
 * gets one of these numbers. */
void fill_descriptors(void);

/* ---- Outside (outside.c). ---- */

typedef struct ending {
    int status;         /* of wait */
    bool late;          /* its time was over */
    int stopped;        /* a signal that the jail got */
    struct rusage used;
    long wall_ms;
    bool said_anything; /* before it was the program */
    message said;       /* and the last of it */
} ending;

/* The binary in memory, sealed: what is run is what was read, and no path leads to
 * it. */
int load_binary(const char *path);

/* Starts the process inside and waits for its end. */
ending jail_run(const jail *j);

/* Adds its line to the file of --report. */
void report(const char *path, const ending *e);

/* Ends the jail as the program ended. */
int end_alike(const ending *e);

#endif
