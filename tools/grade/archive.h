/* archive.h - reading archives that strangers have made: tar and zip.
 *
 * Nothing is unpacked. An archive in memory becomes a list of its files, and those that
 * are wanted are taken out one by one. So links, devices, names that lead elsewhere and
 * a million small files are only bytes that are stepped over.
 */
#ifndef TOOLS_GRADE_ARCHIVE_H
#define TOOLS_GRADE_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct packed_file {
    const char *name;
    const char *trouble; /* NULL: it can be used; or why not */
    const char *bytes;   /* in the archive */
    size_t size;         /* of these bytes */
    bool deflated;       /* zip: they are compressed, into `size` of `whole` bytes */
    uint32_t whole, checksum;
    bool used;           /* for those who read it */
} packed_file;

typedef struct archive {
    packed_file *file;
    size_t files;
    const char *trouble; /* NULL, or why it cannot be read */
} archive;

/* A tar or zip archive, by its bytes, which stay where they are. Folders are not
 * listed. */
archive archive_read(const char *bytes, size_t size);

/* The file whose name is `path`, or ends with it after a slash: of several the one that
 * is nearest to the top. NULL: there is none; then *trouble may say why. It is never
 * one whose name leads out of the archive. */
packed_file *archive_find(const archive *a, const char *path, const char **trouble);

/* How long the ending of an archive's name is: of .tar, .tar.gz, .tgz, .zip; 0: it has
 * none. */
size_t archive_ending(const char *name);

/* Does the name begin with a slash, or does it climb? */
bool leads_elsewhere(const char *name);

#endif
