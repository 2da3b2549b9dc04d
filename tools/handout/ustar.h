/* ustar.h - archives with the same bytes for the same files: no times, no owners.
 */
#ifndef TOOLS_HANDOUT_USTAR_H
#define TOOLS_HANDOUT_USTAR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Appends a file. false: the path is too long (100 characters are not), or the
 * archive cannot be written. */
bool ustar_add(FILE *archive, const char *path, const char *bytes, size_t size,
               bool program);

/* Ends the archive. */
bool ustar_end(FILE *archive);

#endif
