/* clean.h - texts of strangers, made fit to be printed.
 *
 * A student's program, its compiler's messages and file names are full of what a
 * stranger chose. What is left of them here is plain text, in UTF-8: no sequence that
 * moves a cursor or renames a terminal, no character that turns the direction of
 * writing.
 */
#ifndef TOOLS_GRADE_CLEAN_H
#define TOOLS_GRADE_CLEAN_H

#include <stddef.h>
#include <stdio.h>

/* The text, at most about `most` bytes of it; what is no UTF-8 becomes '?'. */
char *clean(const char *bytes, size_t size, size_t most);

/* A clean text as JSON, with its quotes; fit to stand in a page of HTML, too. */
void print_json(FILE *file, const char *text);

/* A clean text in XML, between tags or quotes. */
void print_xml(FILE *file, const char *text);

/* A clean text as a cell of CSV; no program will take it for a formula. */
void print_csv(FILE *file, const char *text);

#endif
