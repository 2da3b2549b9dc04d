/* bench.h - what is measured, and what has been seen.
 *
 * Needs: tools/bench/measure.h, tools/tri/tri.h.
 */
#ifndef TOOLS_BENCH_H
#define TOOLS_BENCH_H

#include "tools/bench/measure.h"
#include "tools/tri/tri.h"

#include <stdio.h>

enum { MOST_RUNS = 99, MOST_SIZES = 8, MOST_INPUTS = 16, MOST_CONTENDERS = 24 };

/* Who is measured: the yardstick, an algorithm of contents, or a peer. */
typedef struct contender {
    char name[32];
    const algorithm *algorithm; /* NULL: not ours */
    char program[300];          /* of a peer; empty: not a peer */
    bool sorts; /* yardstick and std_sort: what others are compared with */
} contender;

typedef struct summary {
    double least, median;
} summary;

typedef enum cell_state {
    CELL_EMPTY, /* nobody has asked for it */
    CELL_MEASURED,
    CELL_TOO_MANY, /* not run: slow by design, as contents says */
    CELL_HOPELESS, /* not run: too slow at the size before */
    CELL_TOO_LONG, /* stopped at the limit */
    CELL_FAILED    /* ended otherwise */
} cell_state;

/* One contender on one input. */
typedef struct cell {
    cell_state state;
    unsigned runs;
    summary user, processor, wall; /* seconds */
    double bytes_per_point; /* the most of all runs; negative: not known */
    answer answer;
} cell;

typedef struct bench {
    unsigned runs;    /* of a cell, at most */
    unsigned seconds; /* the limit of a run */
    double spend; /* no further run when a cell's have taken this together */
    const char *folder;
    bool aims;                            /* shall be looked at, too */
    contender contender[MOST_CONTENDERS]; /* the yardstick first */
    int contenders;
    const distribution *input[MOST_INPUTS];
    int inputs;
    uint32_t size[MOST_SIZES]; /* ascending */
    int sizes;
    cell cell[MOST_SIZES][MOST_INPUTS][MOST_CONTENDERS];
    FILE *csv;
} bench;

/* ---- bench.c ---- */

/* Prints a sentence and what it speaks of; exits with status 2. */
_Noreturn void refuse(const char *sentence, const char *which);

/* What people get who do not ask for any: `fast`, or the last Delaunay row. */
const algorithm *subject(void);

/* The place of a name among the contenders, or -1. */
int find_contender(const bench *b, const char *name);

/* The cell if it has been measured, or NULL, for any name. */
const cell *find_cell(const bench *b, uint32_t n, const char *input,
                      const char *name);

/* Was it run, and stopped at the limit? */
bool was_stopped(const bench *b, uint32_t n, const char *input,
                 const char *name);

/* The least and the median of count > 0 numbers, which are sorted. */
summary summarize(double *v, unsigned count);

/* n points of the input, the same in every run; the caller frees them. */
point2 *make_points(const distribution *d, uint32_t n);

/* Writes them as bits (lib/binary.h), which other programs read in no time. */
void write_point_file(const char *path, const point2 *points, uint32_t n);

/* ---- rounds.c ---- */

/* Measures all contenders on n = b->size[s] points of input i, in turns, and
 * prints what it sees. False: one of ours has failed, or is wrong. */
bool measure_block(bench *b, int s, int i);

/* Ratios to the yardstick: a line for each input, a column for each name. */
void print_summary(const bench *b, int s);

/* ---- targets.c ---- */

/* Measures what is left, and prints a line PASS or FAIL for each aim. */
void print_targets(const bench *b);

/* ---- plots.c ---- */

/* Draws folder/growth.svg and folder/ratios.svg. */
void draw_plots(const bench *b);

#endif
