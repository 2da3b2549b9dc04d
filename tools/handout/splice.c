/* splice.c - one source from two: the student's, with exercises of the reference.
 *
 *     splice REFERENCE STUDENT EXERCISE...          EXERCISE... as in the reference
 *     splice --only REFERENCE STUDENT EXERCISE...   all but EXERCISE... as there
 *
 * REFERENCE and STUDENT are roots of trees; the first has the exercises.ini. All the
 * exercises belong to one file; what results from the two versions of it is
 * printed. So one mistake is not punished twice: 2.3-c can be tried with the
 * reference's 2.3-b.
 *
 * Exit status: 0 printed; 1 it cannot be done, standard error says why; 2 the program
 * cannot run.
 */
#include "tools/handout/basics.h"
#include "tools/handout/exercises.h"
#include "tools/handout/rewrite.h"
#include "tools/handout/scan.h"

#include <stdlib.h>
#include <string.h>

/* The functions that belong to an exercise of this file. */
static const char *
all_functions(const project *p, const char *path, const char *reference)
{
    const char *list = "";
    for (size_t i = 0; i < p->exercises; i++)
        if (strcmp(p->exercise[i].path, path) == 0)
            list = format("%s %s", list, functions_of(reference, &p->exercise[i]));
    return list;
}

/* All functions of the reference that have a contract, but these. The static ones that
 * are no exercise come along where they are needed. */
static const char *
all_but(const char *reference, const char *exercises, const char *these)
{
    source s;
    const char *list = "";
    if (!scan(reference, &s))
        refuse("the reference's brackets do not match");
    for (size_t k = 0; k < s.items; k++) {
        const item *i = &s.item[k];
        const char *name = reference + i->name;
        if (i->kind == ITEM_FUNCTION && !has_word(these, name, i->length) &&
            (!i->is_static || has_word(exercises, name, i->length)))
            list = format("%s %.*s", list, (int)i->length, name);
    }
    return list;
}

typedef struct request {
    project project;
    bool only;
    const char *path;     /* of the file */
    char **exercise;      /* ends with NULL */
    const char *reference, *student; /* the two texts */
    const char *student_root;
} request;

static const exercise *
exercise_of(const project *p, const char *id)
{
    const exercise *e = project_find(p, id);
    if (e == NULL)
        refuse("there is no exercise %s", id);
    return e;
}

static request
parse(int argc, char **argv)
{
    bool only = argc > 1 && strcmp(argv[1], "--only") == 0;
    if (argc - only < 4) {
        fputs("usage: splice [--only] REFERENCE STUDENT EXERCISE...\n", stderr);
        exit(2);
    }
    char **given = argv + 1 + only;
    request r = {.only = only, .exercise = given + 2, .student_root = given[1]};
    r.project = project_read(given[0]);
    r.path = exercise_of(&r.project, r.exercise[0])->path;
    r.reference = file_bytes(format("%s/%s", given[0], r.path), NULL);
    r.student = file_bytes(format("%s/%s", given[1], r.path), NULL);
    if (r.reference == NULL || r.student == NULL)
        refuse("there is no %s/%s", given[r.reference != NULL], r.path);
    return r;
}

int
main(int argc, char **argv)
{
    request r = parse(argc, argv);
    const char *functions = "", *missing;
    for (char **id = r.exercise; *id != NULL; id++) {
        const exercise *e = exercise_of(&r.project, *id);
        if (strcmp(r.path, e->path) != 0)
            refuse("%s is in %s, not in %s", *id, e->path, r.path);
        functions = format("%s %s", functions, functions_of(r.reference, e));
    }
    const char *others = all_functions(&r.project, r.path, r.reference);
    if (r.only)
        functions = all_but(r.reference, others, functions);
    const char *result = with_functions_of(r.student, r.reference, functions, others,
                                           &missing);
    if (result == NULL && *missing == '\0')
        refuse("%s/%s: brackets do not match", r.student_root, r.path);
    if (result == NULL)
        refuse("%s/%s: there is no function %s", r.student_root, r.path, missing);
    fputs(result, stdout);
    return fflush(stdout) == 0 ? 0 : 2;
}
