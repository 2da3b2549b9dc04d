/* output.h - a file that appears whole, or not at all.
 *
 * Needs: lib/status.h.
 *
 * What is written goes to a new file in the same folder and takes the name of
 * `path` at the end, in one step (rename). Until then, and for ever when
 * something fails, an old file of that name is what it was.
 */
#ifndef LIB_OUTPUT_H
#define LIB_OUTPUT_H

#include "lib/status.h"

#include <stdio.h>

typedef struct output {
    FILE *file;   /* write here; NULL when nothing is open */
    char *path;   /* the name that the file will get; NULL for standard output */
    char *beside; /* the name that it has until then; NULL: written in place */
} output;

/* Opens a file beside `path`; "-" means standard output.
 *
 * What exists and is no regular file, such as /dev/full, cannot be replaced and
 * is written in place. The new file's name is path, a dot, a number and ".part".
 * TRI_CANNOT_WRITE, TRI_OUT_OF_MEMORY: *o is zeroed and nothing has changed;
 * errno tells more.
 */
tri_status output_begin(output *o, const char *path);

/* Flushes, looks for any error since output_begin, closes and renames onto path;
 * *o is zeroed in either case.
 * TRI_CANNOT_WRITE: the new file is removed, the old one is intact; errno tells
 * more when the last write was the one that failed.
 */
tri_status output_commit(output *o);

/* Removes the file beside, when the work came to nothing, and zeroes *o; a zeroed
 * struct is accepted. */
void output_discard(output *o);

#endif
