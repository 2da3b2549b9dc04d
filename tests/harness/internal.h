/* internal.h - what the files of the harness tell each other.
 *
 * harness.c   the test program: its tests one after the other, and the counts
 * trial.c     one trial, and the child process that runs a batch of them
 * report.c    a failure: made small, drawn, and put into words
 * shrink.c    how points are made fewer and simpler
 * generate.c  where points come from
 */
#ifndef TESTS_HARNESS_INTERNAL_H
#define TESTS_HARNESS_INTERNAL_H

#include "tests/harness/harness.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    LONGEST_NAME = 47,
    LONGEST_SENTENCE = 319,
    MOST_CLAIMS = 100
};

/* One test: where its points come from, and what is claimed about them. */
typedef struct test {
    enum { ORDINARY, NEAR_DEGENERATE, SUBSETS, PERMUTATIONS, GIVEN, CHECK } kind;
    const char *what;
    property *claims;
    void (*check)(void);
    uint32_t trials, most_points, side;
    const point2 *given;
    uint32_t n;        /* of the given points */
    long milliseconds; /* the limit for each trial */
} test;

/* What a child tells its parent, in memory that both can see. */
typedef struct tally {
    uint32_t running;              /* the trial the child is in, or died in */
    char failed[LONGEST_NAME + 1]; /* the claim that did not hold, or "" */
    char because[LONGEST_SENTENCE + 1];

    uint64_t trials, outside, largest_n; /* outside: of the hypotheses */
    uint64_t zeros, expansions, wide;    /* answers of predicates */
    uint32_t claims;
    struct {
        char name[LONGEST_NAME + 1];
        uint64_t made;
    } claim[MOST_CLAIMS];
} tally;

/* How a child ended. */
typedef struct ending {
    int status;                    /* from waitpid */
    char failed[LONGEST_NAME + 1]; /* the claim that did not hold, or "" */
    char because[LONGEST_SENTENCE + 1];
} ending;

/* The test program. */
typedef struct test_program {
    const char *name;
    char failures[200]; /* the folder for pictures */
    uint64_t seed;
    uint32_t trials_factor;
    unsigned tests;      /* begun so far */
    tally total;         /* of all batches that ended well */
    tally *shared;       /* of the child that runs, or was the last to run */
    int noise;           /* a file for what children print */
    const char *picture; /* what a child draws if it fails, or NULL */
} test_program;

extern test_program program;

/* Ends the program: the test cannot be carried out here. */
_Noreturn void give_up(const char *what);

/* ---- trial.c ---- */

/* The points of trial k; the caller frees them. */
point2 *draw_points(const test *t, uint32_t k, uint32_t *n);

/* A picture of the points, and of what test_picture and claim_verdict were given in
 * this process. */
void draw_picture(const char *path, const point2 *points, uint32_t n);

/* Runs trials begin .. end-1 in a child process; if `instead` is not NULL, on these
 * n points. The counts in *program.shared begin from the total. */
ending run_child(const test *t, uint32_t begin, uint32_t end, const point2 *instead,
                 uint32_t n);

bool ended_well(ending how);
bool was_endless(ending how);

/* ---- report.c ---- */

/* Copies what the last child printed, at most so many lines, each after `before`. */
void print_noise(FILE *to, const char *before, unsigned most_lines);

/* Where a failure of the current test is drawn. */
void picture_path(char *path, size_t room);

/* Says why trials begin .. end-1, run in one process, did not end well. */
void report_batch(const test *t, uint32_t begin, uint32_t end, ending how);

/* Does the failing test fail in the same way on these points? */
bool still_fails(const point2 *points, uint32_t n);

/* ---- shrink.c ---- */

/* Makes points[0..n) fewer and simpler as long as still_fails says so, asking at
 * most `runs` times. Returns how many points are left, at the front. */
uint32_t shrink(point2 *points, uint32_t n, unsigned runs);

/* ---- generate.c ---- */

/* A number of points up to `most`: one time in 16 fewer than four, else spread over
 * small and large, so that both are met often. */
uint32_t generate_size(random_source *source, uint32_t most);

/* n points of one of the families of test_random. */
void generate_ordinary(random_source *source, point2 *points, uint32_t n);

/* n points of one of the families of test_near_degenerate. */
void generate_near_degenerate(random_source *source, point2 *points, uint32_t n);

/* Puts the points into a random order. */
void generate_order(random_source *source, point2 *points, uint32_t n);

#endif
