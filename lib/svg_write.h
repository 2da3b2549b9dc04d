/* svg_write.h - numbers and texts, written as SVG wants them.
 *
 * Needs: lib/point.h. For lib/svg*.c; pictures are made with lib/svg.h.
 */
#ifndef LIB_SVG_WRITE_H
#define LIB_SVG_WRITE_H

#include "lib/point.h"

#include <stdio.h>

/* The number, rounded to hundredths, whatever the locale. No picture is larger
 * than a million; what is, or is no number, is written as a million, plus or
 * minus. */
void svg_put_number(FILE *file, double v);

/* An attribute: name="v". */
void svg_put_attribute(FILE *file, const char *name, double v);

/* A step of a path: a letter of the path language and a position. */
void svg_put_step(FILE *file, char letter, point2 p);

/* The text, in UTF-8, up to its end or to the end of its line; returns what comes after
 * that. Control characters become question marks. */
const char *svg_put_text(FILE *file, const char *text);

#endif
