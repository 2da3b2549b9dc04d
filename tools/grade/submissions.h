/* submissions.h - which submissions there are, and what their names are.
 */
#ifndef TOOLS_GRADE_SUBMISSIONS_H
#define TOOLS_GRADE_SUBMISSIONS_H

#include "tools/grade/grade.h"

typedef struct submission {
    const char *name, *path; /* path NULL: on the roster, and nothing handed in */
    const char *output;      /* the folder of its results */
} submission;

typedef struct class {
    submission *at;
    size_t count;
} class;

/* Those that the paths (ended by NULL) lead to, and those on the roster, if there is
 * one, in the order of their names. `one`: each path is a submission, however it looks.
 * Results go to `output` if there is one path, to a submission, and below it
 * otherwise. */
class find_submissions(const assignment *a, char **paths, bool one, const char *roster,
                       const char *output);

#endif
