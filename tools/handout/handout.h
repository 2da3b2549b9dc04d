/* handout.h - what the parts of tools/handout know of a handout. */
#ifndef TOOLS_HANDOUT_HANDOUT_H
#define TOOLS_HANDOUT_HANDOUT_H

#include "tools/handout/exercises.h"
#include "tools/handout/tree.h"

typedef struct handout {
    project project;      /* roles filled in */
    const char *name;     /* "W3", "2.3" or "2.3-b" */
    const char *variant;  /* "" if none */
    const char *student;  /* whose questions are in answers.txt; "" if nobody's */
    const char *sections; /* whose code is in the tree, in words */
    tree tree;
    const char *weave;    /* the program that fills the quotes */
    const char *signs;    /* the program that makes the instances of 3.4 */
    const char *traces;   /* the program that asks students questions of their own */
    const char *scratch;  /* a folder of our own */
} handout;

/* Which exercises are asked (selection.c). */
void handout_select(handout *h);

/* The files: the library, the sections, the checks (files.c). */
void handout_collect(handout *h);

/* The code of what is to be written is taken out, or stays for the proof (files.c). */
void handout_take_out(handout *h);

/* The files of the tree that a student edits, in words (files.c). */
const char *handout_listed(const handout *h);

/* The pages, and what is generated: README.md, assignment.ini, assignment.mk
 * (pages.c). Before weaving, the quotes that are gone give way. */
void handout_write_pages(handout *h);
void handout_weave(handout *h);

/* The questions of the student (files.c). */
void handout_ask(handout *h);

/* Sections without a checker, in words: what is asked there cannot be graded yet
 * (files.c). */
const char *handout_unchecked(const handout *h);

/* Refuses unless all that is promised is true (proof.c). */
void handout_prove(const handout *h);

/* No three lines in a row of what was taken out stand anywhere (leaks.c). */
void handout_prove_nothing_leaks(const handout *h);

/* Is the exercise asked in the handout's variant? */
bool is_asked_in_variant(const handout *h, const exercise *e);

/* Is some exercise of the section asked? */
bool section_is_asked(const handout *h, const char *section);

/* "chapters/2.3_line_sweep"; NULL if there is none. */
const char *section_folder(const handout *h, const char *section);

/* "opaque" or "plain". */
const char *exercise_program(const handout *h, const exercise *e);

#endif
