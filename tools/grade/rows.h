/* rows.h - the table of a class, with a row for each submission (--csv).
 *
 * A worker leaves its row as a file; when all have ended, the files are put together.
 */
#ifndef TOOLS_GRADE_ROWS_H
#define TOOLS_GRADE_ROWS_H

#include "tools/grade/submissions.h"

/* Leaves the row of s, which was graded so, or where the grader has failed. */
void row_leave(const grading *g, const submission *s, const result *r);

/* Writes the rows of all, in the order of the class, below their heads.
 *
 * Requires: each has been left. */
void rows_join(const grading *g, const class *c, const char *path);

#endif
