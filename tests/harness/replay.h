/* replay.h - what tri trace has written, read and run again without geometry.
 *
 * Needs: harness.h, shell.h, json.h, chapters/contents.h.
 */
#ifndef TESTS_REPLAY_H
#define TESTS_REPLAY_H

#include "chapters/contents.h"
#include "tests/harness/json.h"

#include <stdbool.h>
#include <stdint.h>

enum { REPLAY_POINTS = 64 }; /* at most */

/* An algorithm and what it is told: in C, and as words of a command. */
typedef struct watched_run {
    const algorithm *algorithm;
    tri_options options;
    char words[300];
} watched_run;

/* The algorithm with random options, in a trial. */
watched_run random_run(const algorithm *a);

/* What `tri trace` says of the points; fails the trial unless it is JSON. Free it with
 * replay_free. */
typedef struct replay {
    json *root;
    char *text;
    const json *steps; /* an array */
    uint32_t next;     /* the first step that has not been run */
    uint32_t n;
    bool is_vertex[REPLAY_POINTS];
    bool edge[REPLAY_POINTS][REPLAY_POINTS]; /* both ways */
    uint32_t on_stack;
    vertex_id stack[REPLAY_POINTS * REPLAY_POINTS][2];
} replay;

void replay_begin(replay *r, const watched_run *run, const point2 *points, uint32_t n);
void replay_free(replay *r);

/* The next step, before it is run; NULL after the last. */
const json *replay_peek(const replay *r);

/* Runs it. Fails the trial if an edge that vanishes is not there, if one that appears
 * has been there, if an end of an edge is no vertex; or if what is on the stack is not
 * there, is put there twice, or is taken from elsewhere than the top. */
void replay_step(replay *r);

/* ---- Parts of a step. ---- */

/* The string of that name; fails the trial if there is none. */
const char *step_text(const json *step, const char *name);

/* How many items the list of that name has; 0 if there is none. */
uint32_t step_count(const json *step, const char *name);

/* Point j of item i of a list of lists, NONE if there is none; fails the trial if it is
 * no point. */
vertex_id step_id(const replay *r, const json *step, const char *name, uint32_t i,
                  uint32_t j);

/* The same for item i of a list of points, or for a single point and i = 0. */
vertex_id step_point(const replay *r, const json *step, const char *name, uint32_t i);

#endif
