/* tools.h - tests that run the project's tools on files that they have written.
 *
 * A test program is BUILD/test/NAME and starts in the project's root; it may go to
 * other folders.
 */
#ifndef TESTS_TOOLS_H
#define TESTS_TOOLS_H

#include <stdbool.h>

extern char build[2100];  /* the folder BUILD, from / */
extern char root[1000];   /* the folder of the project */
extern char said[200000]; /* what the last command printed */

/* Finds build and root; after test_begin. */
void tools_begin(char **argv);

/* Ends the program when something is not done that has nothing to do with the tools. */
void must(bool done, const char *what);

void write_file(const char *path, const char *bytes);

/* Runs a shell command, as if there were no make around this test; returns its exit
 * status, or -1 if it had none. */
int run(const char *command);

/* Runs a program of build. */
int run_tool(const char *name, const char *arguments);

#endif
