/* exercises.h - what chapters/SECTION/exercises.ini and docs/assignments.ini say.
 *
 * docs/grading.md explains the keys.
 */
#ifndef TOOLS_HANDOUT_EXERCISES_H
#define TOOLS_HANDOUT_EXERCISES_H

#include <stdbool.h>
#include <stddef.h>

/* A file of keys: lines `[name]`, then `key = value`. */
typedef struct ini_entry {
    const char *section, *key, *value;
} ini_entry;

typedef struct ini {
    ini_entry *entry;
    size_t entries;
} ini;

/* Appends the entries of the file; false if there is none. */
bool ini_read(ini *all, const char *path);

/* The value; "" if there is no such key. */
const char *ini_value(const ini *all, const char *section, const char *key);

/* What becomes of an exercise in a handout. */
typedef enum exercise_role {
    ROLE_ABSENT, /* its section is not in the tree */
    ROLE_GIVEN,  /* the tree has its code */
    ROLE_LATER,  /* its code is left out, and it is not asked for yet */
    ROLE_ASKED   /* its code is left out, and is to be written */
} exercise_role;

typedef struct exercise {
    const char *id;        /* "2.3-b" */
    const char *section;   /* "2.3" */
    const char *folder;    /* "chapters/2.3_line_sweep" */
    const char *path;      /* the file of its functions */
    const char *functions; /* words */
    const char *helpers;   /* words */
    exercise_role role;
} exercise;

typedef struct project {
    const char *root;
    ini keys;              /* of all exercises.ini */
    ini assignments;
    exercise *exercise;    /* in the order of the notes */
    size_t exercises;
} project;

/* Reads the tree at `root`; refuses what is not as docs/grading.md says. */
project project_read(const char *root);

const exercise *project_find(const project *p, const char *id);

/* A key of an exercise. */
const char *exercise_key(const project *p, const exercise *e, const char *key);

/* The sum of its points. */
int exercise_points(const project *p, const exercise *e);

#endif
