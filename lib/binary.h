/* binary.h - files of points as their bits.
 *
 * Needs: lib/textio.h, whose readers of points take such files too.
 *
 *     bytes 0 to 7     89 54 52 49 0D 0A 1A 0A: tells the kind of file
 *     bytes 8 to 11    the version, 1
 *     bytes 12 to 15   how many points follow
 *     then, for each   x and y, as IEEE 754 doubles of 8 bytes
 *
 * All numbers have their lowest byte first (little-endian), whatever the machine, and
 * nothing follows the last point. Points are numbered from 0; all must be finite.
 */
#ifndef LIB_BINARY_H
#define LIB_BINARY_H

#include "lib/textio.h"

#include <stdbool.h>

/* Does it begin like such a file? */
bool binary_begins(const char *bytes, size_t size);

/* Reads the file's bytes. Requires: binary_begins.
 * TRI_BAD_FILE, TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *out is zeroed and *error
 * says why. Memory: 16 bytes a point. */
tri_status binary_parse_points(const char *bytes, size_t size, text_points *out,
                               text_error *error);

/* Writes such a file. What fails is remembered by the FILE, as in textio.h.
 * Requires: coordinates are finite. */
void binary_write_points(FILE *file, const point2 *points, uint32_t n);

#endif
