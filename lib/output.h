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
    char *path;   /* the name it will get; NULL for standard output */
    char *beside; /* the name it has until then; NULL: in place */
} output;

/* Opens a file beside `path`; "-" means standard output.
 *
 * A path below /dev/ names a device, not to be replaced by a file: it is
 * written in place. The file beside is called PATH.NUMBER.part.
 * TRI_CANNOT_WRITE, TRI_OUT_OF_MEMORY: *o is zeroed and nothing has changed;
 * errno may tell more.
 */
tri_status output_begin(output *o, const char *path);

/* Flushes, looks for any error since output_begin, closes, renames onto path;
 * *o is zeroed in either case. Requires: output_begin gave TRI_OK.
 * TRI_CANNOT_WRITE: the new file is removed, the old one is intact; errno may
 * tell more.
 */
tri_status output_commit(output *o);

#endif
