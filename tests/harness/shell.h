/* shell.h - tests that drive programs as people drive them, by the shell.
 *
 * A test program is BUILD/test/NAME and the current folder is the project's root. The
 * commands find in their environment
 *
 *     $build   the folder BUILD, from /
 *     $tri     the program BUILD/tri, or what $TRI says
 *     $d       a folder for files, of this run's own
 */
#ifndef TESTS_SHELL_H
#define TESTS_SHELL_H

#include <stdbool.h>

/* Makes the folder $d and sets the environment; before test_begin. */
void shell_begin(char **argv);

/* Removes $d with all that is in it; after test_end. */
void shell_end(void);

/* Runs a printf command. Returns its exit status, or -1 if it had none. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
int shell(const char *command, ...);

/* The name of the file $d/name. */
typedef struct file_name {
    char text[1000];
} file_name;

file_name in_scratch(const char *name);

/* The first bytes of the file $d/name, as text; "" if there is none. */
typedef struct content {
    char text[4000];
} content;

content read_scratch(const char *name);

/* Does the beginning of the file $d/name have this part? */
bool has(const char *name, const char *part);

/* Is the file $d/name a single line? */
bool one_line(const char *name);

#endif
