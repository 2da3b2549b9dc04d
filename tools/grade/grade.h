/* grade.h - what the parts of the grader know of each other.
 *
 * A submission is marked in a process of its own: it reads the listed files, compiles
 * them in the jail, and lets the checkers of the handout's tree ask the program, which
 * runs in the jail. Nothing of a student's runs, or is believed, in the grader.
 */
#ifndef TOOLS_GRADE_GRADE_H
#define TOOLS_GRADE_GRADE_H

#include "tools/grade/archive.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- What is asked: assignment.ini of the tree that was handed out. ---- */

typedef struct task {
    const char *exercise; /* "2.3-b" */
    const char *section;  /* "2.3" */
    const char *title;
    const char *mode;     /* "opaque" or "plain" */
    const char *path;     /* the file of its functions */
    const char *functions;
    bool bonus;           /* its points are not in the total */
    size_t first, end;    /* its properties */
} task;

typedef struct graded_property {
    const char *name;
    int points;
    const task *of;
} graded_property;

typedef struct assignment {
    const char *name, *variant;
    const char **file;    /* what a student hands in */
    size_t files;
    task *task;
    size_t tasks;
    size_t exercises; /* the first tasks; the others are questions of a student's own */
    graded_property *property;
    size_t properties;
    int total;
} assignment;

/* Reads FOLDER/assignment.ini; refuses what is none. */
assignment assignment_read(const char *folder);

#define ANSWERS "answers.txt"

/* Adds the questions of FOLDER/answers.txt, a task for each section: a fifth of the
 * total is theirs (answers.c). */
void answers_ask(assignment *a, const char *folder);

/* ---- How a grading is done. ---- */

enum { PUBLIC_SEED = 1 }; /* of what students check themselves */

typedef struct grading {
    assignment asked;
    const char *work;     /* a folder of our own, from / */
    const char *base;     /* in it: the tree, compiled */
    const char *tools;    /* where jail and splice are, from / */
    const char *project;  /* --viva, --pack: the project's root, from / */
    const char *reference; /* --supply: a copy of its chapters, and splice; or NULL */
    const char *compiler;
    uint64_t seed;
    bool required;        /* --require-sandbox */
    const char *formats;  /* words */
} grading;

/* The flags of every compilation: undefined behaviour ends the program, and it needs
 * nothing of the system to run. */
#define GRADING_FLAGS \
    "-O1 -w -static -fsanitize=undefined -fsanitize-undefined-trap-on-error"

/* Compiles the checkers and what the students' files are linked with, if g->base is not
 * such a tree already. */
void base_prepare(const grading *g);
bool base_is_prepared(const grading *g, const char *folder);

/* ---- What came out. ---- */

typedef struct mark {
    const char *word;     /* pass, fail, todo, ... or refused, uncompiled, ungraded */
    const char *sentence;
    const char *text;     /* all that is to be said of it, without its picture */
    const char *picture;  /* below the folder of results, or NULL */
} mark;

typedef struct result {
    const char *name;     /* of the submission */
    const char *fault;    /* of the grader: then no mark counts; or NULL */
    const char *notes;    /* sentences about the submission as a whole */
    mark *mark;           /* of each property */
} result;

/* All 0, for the reason given. */
result result_nothing(const assignment *a, const char *name, const char *because);

bool mark_earned(const mark *m);
int result_score(const assignment *a, const result *r);

/* Marks a submission, a folder or an archive, in the folder g->work/SCRATCH (mark.c).
 * Pictures of failures go to OUTPUT/feedback. */
result mark_submission(const grading *g, const char *name, const char *path,
                       const char *scratch, const char *output);

/* Marks the questions of task t: SCRATCH/src/answers.txt is the file of student
 * `id`. */
void answers_mark(const grading *g, const task *t, const char *id, const char *scratch,
                  result *r);

/* Writes the files of the formats that were asked for into the folder (formats.c). Each
 * appears whole, in the place of an older one. */
void formats_write(const grading *g, const result *r, const char *folder);

/* The first of these words that names no format; NULL if all do. */
const char *formats_check(const char *list);

/* ---- The listed files (files.c). ---- */

typedef struct listed {
    const char **trouble; /* of each listed file: NULL, or why it is not used */
    const char *notes;    /* sentences */
} listed;

/* Finds the listed files of a submission and copies them below `to`; those that are not
 * there, or are none, as they were handed out. */
listed files_collect(const grading *g, const char *path, const char *to);

/* Has the folder one of the listed files, with or without its folders? */
bool has_listed_file(const assignment *a, const char *folder);

/* Opens folder/path, where none of the parts of `path` may be a link, and reads it: at
 * most `most` bytes, and a NUL. NULL: *trouble says why, or is NULL when there is no
 * such file. */
char *read_below(const char *folder, const char *path, size_t most, size_t *size,
                 const char **trouble);

/* ---- What gzip has compressed (unpack.c). ---- */

/* Decompresses in the jail, in folders below `scratch`. NULL: *trouble says why; that
 * there are more than `most` bytes, for example. */
char *unpack(const grading *g, const char *scratch, const char *bytes, size_t size,
             size_t most, size_t *unpacked_size, const char **trouble);

/* The same for a file in a zip archive. */
char *unpack_deflated(const grading *g, const char *scratch, const packed_file *f,
                      size_t most, size_t *unpacked_size, const char **trouble);

/* ---- Running programs (run.c). ---- */

enum { RUN_TOO_LONG = -1 };

/* Runs a program in a folder, with its output and errors in *said: the first `most`
 * bytes, of which there are *said_size. Returns its exit status, 128 + its signal, or
 * RUN_TOO_LONG: then it has been ended. */
int run(const char *folder, const char *const command[], unsigned seconds, size_t most,
        char **said, size_t *said_size);

/* Ends what `run` runs just now: when the grader is interrupted. */
void run_end(void);

/* A command that grows. */
typedef struct command_line {
    const char **word; /* ends with NULL */
    size_t words;
} command_line;

void command_add(command_line *c, const char *word);
void command_add_words(command_line *c, const char *words);

/* `jail compile` that reads the folders (ended by NULL) and writes one; what is to be
 * run follows. */
command_line
jail_compile(const grading *g, const char *const reads[], const char *writes);

const char *current_folder(void);
const char *from_root(const char *path); /* the same place, from / */
void make_folder(const char *path);     /* with those above it */
void remove_folder(const char *path);   /* with all that is in it */
void write_file(const char *path, const char *bytes, size_t size);

/* ---- Other things to do than to grade. ---- */

/* A conversation: three functions of the student's, and one planted bug (viva.c). */
void viva(const grading *g, const char *id, const char *path);

/* Writes an archive for Gradescope (pack.c). */
void pack_gradescope(const char *project, const char *base, const char *seed_file,
                     const char *output);

#endif
