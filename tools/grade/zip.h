/* zip.h - zip archives, not compressed, with the same bytes for the same files.
 */
#ifndef TOOLS_GRADE_ZIP_H
#define TOOLS_GRADE_ZIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct zip {
    FILE *file;
    char *directory; /* what will stand at the end */
    size_t directory_size;
    unsigned entries;
} zip;

/* Appends a file; `program`: it may be executed. */
void zip_add(zip *z, const char *path, const char *bytes, size_t size, bool program);

/* Writes the directory. Errors show in ferror(z->file). */
void zip_end(zip *z);

#endif
