/* textlines.h - a text taken apart into lines and cells; for textio's readers.
 *
 * Needs: lib/textio.h.
 */
#ifndef LIB_TEXTLINES_H
#define LIB_TEXTLINES_H

#include "lib/textio.h"

#include <stdbool.h>

/* A piece of the text. */
typedef struct text_cell {
    const char *at;
    size_t length;
} text_cell;

/* Where reading stands. */
typedef struct text_lines {
    const char *next, *end;    /* the lines that are still to come */
    const char *at, *line_end; /* the cells to come in this line; NULL: none */
    unsigned long line;        /* its number, from 1 */
    text_error *error;         /* filled by text_refuse */
} text_lines;

/* How cells are separated. */
typedef enum text_separator {
    TEXT_BLANKS,       /* a # begins a comment anywhere */
    TEXT_TABLE_BLANKS, /* a # begins a comment at the beginning of a line */
    TEXT_TABLE_COMMAS  /* the same; cells may stand in "quotes" */
} text_separator;

/* Before the first line. A byte order mark is skipped; TRI_BAD_FILE when there
 * is a NUL byte. */
tri_status text_lines_begin(text_lines *t, const char *bytes, size_t size,
                            text_error *error);

/* Goes to the next line that holds more than blanks and a comment; false at the
 * end of the text. */
bool text_next_line(text_lines *t, text_separator separator);

/* The next cell of the line, without blanks and quotes around it; false after
 * the last one. */
bool text_next_cell(text_lines *t, text_separator separator, text_cell *cell);

/* Fills the error with the line and a printf sentence; returns TRI_BAD_FILE. */
#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
tri_status text_refuse(text_lines *t, const char *sentence, ...);

/* Fills the error with the status's own sentence, and returns the status. */
tri_status text_fail(text_error *error, tri_status status);

/* The cell as a double: TRI_OK, or why it is none. */
tri_status text_double(text_lines *t, text_cell cell, double *value);

/* The cell as a whole number of 0 .. 2^32-2: TRI_OK, or why it is none. */
tri_status text_whole(text_lines *t, text_cell cell, uint32_t *value);

/* The readers of a .node file and of a table. The caller frees *out, also when
 * they fail. */
tri_status text_parse_node(text_lines *t, text_points *out);
tri_status text_parse_table(text_lines *t, text_points *out);

#endif
