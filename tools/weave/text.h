/* text.h - files as lines, and saying what is wrong in them. */
#ifndef TOOLS_WEAVE_TEXT_H
#define TOOLS_WEAVE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct text {
    char *bytes; /* the file, with a NUL in place of each newline */
    char **line; /* line[0 .. lines-1] point into it */
    size_t lines;
} text;

/* Some lines of a text: from `first` up to and without `end`, counted from 0. */
typedef struct range {
    size_t first, end;
} range;

/* The whole file; false when it cannot be opened. */
bool text_read(text *t, const char *path);

/* Finds the lines of t->bytes[0 .. size-1], which a NUL follows. */
void text_split(text *t, size_t size);

/* Frees the text and zeroes *t; a zeroed text is accepted. */
void text_free(text *t);

bool begins_with(const char *line, const char *prefix);
bool ends_with(const char *line, const char *suffix);

/* How many spaces the line begins with. */
size_t indentation(const char *line);

/* One line on standard error, `path:line: ...`: what is wrong and what to do. Lines
 * are counted from 0 here and from 1 for people. */
void complain(const char *path, size_t line, const char *what, ...);

/* How often that has happened. */
size_t complaints(void);

/* Ends the program with status 2: the system refuses something. */
void give_up(const char *path);

#endif
