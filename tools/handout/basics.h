/* basics.h - texts, files and programs, for tools that live a second.
 *
 * What these functions return is kept until the program ends, so nothing is freed. Any
 * failure of the system ends the program with status 2 and a sentence.
 */
#ifndef TOOLS_HANDOUT_BASICS_H
#define TOOLS_HANDOUT_BASICS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Zeroed bytes. */
void *take(size_t size);

/* An array that grows: room for one item more after the first `count`. */
void *take_one_more(void *array, size_t count, size_t size);

/* A printf text. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
char *format(const char *what, ...);

/* The first `length` characters of the text. */
char *part_of(const char *text, size_t length);

/* `from` with each occurrence of `what` replaced. */
char *replace_all(const char *from, const char *what, const char *by);

bool begins_with(const char *text, const char *prefix);
bool ends_with(const char *text, const char *suffix);

/* Lists of words with blanks between them. The word after *rest, which moves on; NULL
 * when there is none. */
char *next_word(const char **rest);
bool has_word(const char *list, const char *word, size_t length);

/* The file's bytes, followed by a NUL; NULL if there is no such file. */
char *file_bytes(const char *path, size_t *size);

/* Runs a program in a folder, its output and errors in a file. Returns its exit status;
 * 128 and more when a signal has ended it. A make that it is, or starts, begins
 * anew. */
int run_program(const char *folder, const char *output, const char *const command[]);

/* Ends the program with status 2, or 1: the project or the request is wrong. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
_Noreturn void refuse(const char *because, ...);
_Noreturn void give_up(const char *path); /* says what errno says */

#endif
