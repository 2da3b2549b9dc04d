/* questions.h - first steps of an algorithm on seven points that a name gives.
 *
 * The points are in general position, so each answer is the only one, but for the
 * witness, of which every right one counts.
 */
#ifndef TOOLS_HANDOUT_QUESTIONS_H
#define TOOLS_HANDOUT_QUESTIONS_H

#include "lib/mesh.h"

enum { POINTS = 7, ROOM = 400 };

/* What a section asks, and what is right. */
typedef struct questions {
    point2 points[POINTS];
    char given[ROOM];             /* what is needed besides the points */
    char order[ROOM], seen[ROOM]; /* 2.3 */
    char stack[ROOM];             /* 3.5 */
    mesh broken;                  /* 3.5: what a LawsonFlip without line 5 leaves */
    char link[ROOM];              /* 3.6 */
} questions;

/* Has the section any? */
bool questions_exist(const char *section);

/* Those of this student. The caller frees `broken`. Requires: they exist. */
questions questions_ask(const char *id, const char *section);

/* Do v[0] and v[1] have an edge in `broken` with v[2] and v[3] opposite, and is it not
 * locally Delaunay? */
bool is_witness(const questions *q, const unsigned v[4]);

/* Each edge of the list, as 3-4, is written from its lower end. */
void write_from_lower_ends(char *edges);

#endif
