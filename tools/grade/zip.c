/* zip.c - zip archives: each file behind a head, and a directory at the end. */
#include "tools/grade/zip.h"

#include "tools/handout/basics.h"

#include <stdint.h>
#include <string.h>

/* The check sum of the format: division by a polynomial over two elements. */
static uint32_t
crc32_of(const char *bytes, size_t size)
{
    uint32_t rest = 0xFFFFFFFF;
    for (size_t i = 0; i < size; i++) {
        rest ^= (unsigned char)bytes[i];
        for (int bit = 0; bit < 8; bit++)
            rest = rest >> 1 ^ (rest & 1 ? 0xEDB88320 : 0);
    }
    return ~rest;
}

/* Numbers stand with their low byte first. */
static char *
put(char *at, unsigned bytes, uint32_t value)
{
    for (unsigned i = 0; i < bytes; i++)
        *at++ = (char)(unsigned char)(value >> 8 * i & 0xFF);
    return at;
}

enum { FIRST_OF_JANUARY_1980 = 1 << 5 | 1, MADE_BY_UNIX = 3 << 8, VERSION = 20 };

/* What the head of a file and its row in the directory have in common. */
static char *
put_common(char *at, const char *path, const char *bytes, size_t size)
{
    at = put(at, 2, VERSION);
    at = put(at, 2, 0); /* flags */
    at = put(at, 2, 0); /* stored, not compressed */
    at = put(at, 2, 0); /* midnight */
    at = put(at, 2, FIRST_OF_JANUARY_1980);
    at = put(at, 4, crc32_of(bytes, size));
    at = put(at, 4, (uint32_t)size);
    at = put(at, 4, (uint32_t)size);
    at = put(at, 2, (uint32_t)strlen(path));
    return put(at, 2, 0);
}

void
zip_add(zip *z, const char *path, const char *bytes, size_t size, bool program)
{
    char head[30], row[46];
    size_t length = strlen(path);
    uint32_t mode = program ? 0100755 : 0100644;
    char *at = put(row, 4, 0x02014B50);
    at = put_common(put(at, 2, MADE_BY_UNIX | VERSION), path, bytes, size);
    at = put(at, 4, 0); /* no comment, first disk */
    at = put(at, 2, 0); /* bytes, not a text */
    at = put(at, 4, mode << 16);
    put(at, 4, (uint32_t)ftell(z->file));

    put_common(put(head, 4, 0x04034B50), path, bytes, size);
    fwrite(head, 1, sizeof head, z->file);
    fwrite(path, 1, length, z->file);
    fwrite(bytes, 1, size, z->file);

    char *longer = take(z->directory_size + sizeof row + length);
    if (z->directory_size > 0)
        memcpy(longer, z->directory, z->directory_size);
    memcpy(longer + z->directory_size, row, sizeof row);
    memcpy(longer + z->directory_size + sizeof row, path, length);
    z->directory = longer;
    z->directory_size += sizeof row + length;
    z->entries++;
}

void
zip_end(zip *z)
{
    char end[22];
    uint32_t place = (uint32_t)ftell(z->file);
    char *at = put(put(end, 4, 0x06054B50), 4, 0);
    at = put(put(at, 2, z->entries), 2, z->entries);
    at = put(put(at, 4, (uint32_t)z->directory_size), 4, place);
    put(at, 2, 0);
    fwrite(z->directory, 1, z->directory_size, z->file);
    fwrite(end, 1, sizeof end, z->file);
}
