/* formats.h - the files that `tri triangulate -o` can write.
 *
 * Needs: lib/textio.h.
 *
 * The ending of a file's name says which. Coordinates are decimals that read back
 * as the same doubles.
 */
#ifndef TOOLS_TRI_FORMATS_H
#define TOOLS_TRI_FORMATS_H

#include "lib/textio.h"

#include <stdio.h>

typedef struct format {
    const char *ending; /* of the file's name */
    /* Writes counterclockwise triangles of these points. What goes wrong in the
     * writing is remembered by the FILE. TRI_OUT_OF_MEMORY. */
    tri_status (*write)(FILE *file, const text_points *points, triangle_list list);
    const char *summary; /* a phrase for people */
} format;

extern const format formats[]; /* ended by a row without an ending */

/* The row for a file of that name, or NULL. Standard output and devices, whose names
 * have no ending, get the first row. */
const format *format_of(const char *path);

#endif
