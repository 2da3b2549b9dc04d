/* rewrite.h - taking code out of a source, and putting other code in.
 */
#ifndef TOOLS_HANDOUT_REWRITE_H
#define TOOLS_HANDOUT_REWRITE_H

#include "tools/handout/exercises.h"

/* The source without the exercise: the bodies of its functions become
 * { TODO("2.3-b"); }, and its helpers go, with their comments and prototypes. A helper
 * that is not static has its contract in a header: it, too, is left to be written. */
char *without_exercise(const char *text, const exercise *e);

/* `text` with `#include "lib/todo.h"` after its last include, if it has none. */
char *with_todo(const char *text);

/* What is to be written in the exercise: its functions, and the helpers that are not
 * static. */
char *functions_of(const char *reference, const exercise *e);

/* The student's source with the functions of the reference's in the place of its own.
 *
 * They bring the static functions, types, macros and includes with them that they need,
 * but none of the functions `others`. What the student has in the same words is used;
 * what they have in other words is left to them, and the reference's is called
 * reference_FUNCTION_NAME.
 * NULL: a function is not there, and *missing is its name; or some brackets do not
 * match, and *missing is empty. */
char *with_functions_of(const char *student, const char *reference,
                        const char *functions, const char *others,
                        const char **missing);

#endif
