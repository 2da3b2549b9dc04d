/* textio.h - points, triangles and edges as text files.
 *
 * Needs: lib/triangles.h, lib/edges.h, lib/decimal.h.
 *
 * Files of Shewchuk's Triangle (1996): everything after a # is a comment, empty
 * lines do not count, and items are numbered consecutively, from 0 or from 1.
 *
 *     .node   first line: how many points, 2, attributes, boundary markers
 *             each line:  number, x, y, the attributes, the marker
 *     .ele    first line: how many triangles, 3, attributes
 *             each line:  number, three points, the attributes
 *     .edge   first line: how many edges, boundary markers
 *             each line:  number, two points, the marker
 *
 * What a first line leaves out at its end is 2, 3 or 0. Attributes and markers
 * must be numbers, and are not kept.
 *
 * Tables: a point a line, columns separated by commas (CSV, with "quotes") if
 * the first line has one, else by blanks. Every line has as many columns as
 * the first. A first line in which no cell is a number is a header: the columns
 * named x and y, or lon and lat, are read, in whatever case; without such names
 * the first two are. Lines that begin with a # are comments.
 *
 * A name that ends in .node or .csv says which of the two a file of points is.
 * Otherwise its first line does: four whole numbers without commas, the second
 * of them 2, begin a .node file, anything else a table.
 *
 * Points may also come as bits, without decimals (lib/binary.h), under any name.
 *
 * Numbers are decimals and rounded to the nearest double; the locale does not
 * matter. Lines end in LF or CRLF and may be of any length.
 */
#ifndef LIB_TEXTIO_H
#define LIB_TEXTIO_H

#include "lib/edges.h"
#include "lib/point.h"
#include "lib/status.h"
#include "lib/triangles.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Why a file was refused: `file:line: text` is what a person wants to see. */
typedef struct text_error {
    unsigned long line; /* from 1; 0 when the file as a whole is meant */
    char text[160];     /* what is wrong and what to do, no full stop */
} text_error;

/* The points of a file. */
typedef struct text_points {
    uint32_t count;
    uint32_t first; /* the number of points[0] in the file: 0 or 1 */
    point2 *points;
} text_points;

/* Reads a file; "-" is standard input.
 *
 * Memory: at most 20 times the size of the file, whatever counts it claims.
 * TRI_CANNOT_READ, TRI_BAD_FILE, TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *out
 * is zeroed and *error says why. A file is read to its end or refused.
 */
tri_status text_read_points(const char *path, text_points *out,
                            text_error *error);

/* The same for triangles and edges among the given points: theirs are the
 * numbers that may occur. In the list, the first point is 0. */
tri_status text_read_triangles(const char *path, const text_points *points,
                               triangle_list *out, text_error *error);
tri_status text_read_edges(const char *path, const text_points *points,
                           edge_list *out, text_error *error);

/* The same for a text in memory; the name is only asked for its ending. */
tri_status text_parse_points(const char *name, const char *bytes, size_t size,
                             text_points *out, text_error *error);
tri_status text_parse_triangles(const char *bytes, size_t size,
                                const text_points *points, triangle_list *out,
                                text_error *error);
tri_status text_parse_edges(const char *bytes, size_t size,
                            const text_points *points, edge_list *out,
                            text_error *error);

/* Frees the array and zeroes *points; a zeroed struct is accepted. */
void text_points_free(text_points *points);

/* Write a file whose items, and points, are numbered from `first` on. What
 * fails is remembered by the FILE: ferror tells, and output_commit (output.h).
 * Requires: coordinates are finite. */
void text_write_points(FILE *file, const point2 *points, uint32_t n,
                       uint32_t first);
void text_write_triangles(FILE *file, triangle_list list, uint32_t first);
void text_write_edges(FILE *file, edge_list list, uint32_t first);

#endif
