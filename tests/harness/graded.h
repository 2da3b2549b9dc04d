/* graded.h - tests that hand something in and read what the grader writes.
 *
 * What they hand in is $d/class/NAME/..., and results are in $d/graded/NAME/: the texts
 * are kept until the process ends. Needs: shell.h, json.h.
 */
#ifndef TESTS_GRADED_H
#define TESTS_GRADED_H

#include "tests/harness/json.h"

#include <stdbool.h>
#include <stddef.h>

/* The file in which exercises 2.3-a to 2.3-d are solved. */
#define SWEEP "chapters/2.3_line_sweep/sweep.c"

/* Makes $d/class/NAME/SWEEP: the reference, with headers, and with this line added to
 * hull_edges_seeing. */
bool write_submission(const char *name, const char *line);

/* Where programs cannot be linked statically, or if `status` says that the class has
 * not been graded, it is printed as the outcome of the whole test, which ends. */
void graded_or_end(int status);

/* The whole file $d/name; "" if there is none. The same, read as JSON; NULL if it is
 * none. */
const char *whole(const char *name);
const json *read_json(const char *name);

/* These accept NULL and values of another kind. */
const json *item_of(const json *array, size_t k);
const char *text_of(const json *value); /* "(no text)" */
int number_of(const json *value);       /* -1 unless it is a whole number */

/* graded/NAME/results.json as text, and its test k: how it came out, in a word, and its
 * score. */
const char *results_of(const char *name);
const json *test_of(const char *name, size_t k);
const char *result_of(const json *test);
const char *word_of(const char *name, size_t k);
int score_of(const char *name, size_t k);

#endif
