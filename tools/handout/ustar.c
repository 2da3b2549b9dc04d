/* ustar.c - archives as POSIX.1-1988 has them. */
#include "tools/handout/ustar.h"

#include <string.h>

enum { RECORD = 512 };

/* Where the fields of a header begin. */
enum {
    NAME = 0, MODE = 100, OWNER = 108, GROUP = 116, SIZE = 124, TIME = 136,
    CHECKSUM = 148, KIND = 156, MAGIC = 257, PREFIX = 345
};

/* The path as a prefix of at most 155 characters and a name of at most 100. */
static bool
put_path(char *header, const char *path)
{
    size_t length = strlen(path), cut = 0;
    for (size_t i = 0; length - cut > 100 && i < length; i++)
        if (path[i] == '/' && i <= 155)
            cut = i + 1;
    if (length - cut > 100)
        return false;
    if (cut > 0)
        memcpy(header + PREFIX, path, cut - 1);
    memcpy(header + NAME, path + cut, length - cut);
    return true;
}

bool
ustar_add(FILE *archive, const char *path, const char *bytes, size_t size, bool program)
{
    static const char zeros[RECORD];
    char header[RECORD] = {0};
    if (!put_path(header, path))
        return false;
    strcpy(header + MODE, program ? "0000755" : "0000644");
    strcpy(header + OWNER, "0000000");
    strcpy(header + GROUP, "0000000");
    snprintf(header + SIZE, 12, "%011lo", (unsigned long)size);
    strcpy(header + TIME, "00000000000");
    header[KIND] = '0';
    memcpy(header + MAGIC, "ustar\00000", 8);

    unsigned sum = 8 * ' '; /* the checksum counts as blanks */
    for (int i = 0; i < RECORD; i++)
        sum += (unsigned char)header[i];
    snprintf(header + CHECKSUM, 8, "%06o", sum);
    header[CHECKSUM + 7] = ' ';

    size_t padding = (RECORD - size % RECORD) % RECORD;
    return fwrite(header, 1, RECORD, archive) == RECORD &&
           fwrite(bytes, 1, size, archive) == size &&
           fwrite(zeros, 1, padding, archive) == padding;
}

bool
ustar_end(FILE *archive)
{
    static const char zeros[2 * RECORD];
    return fwrite(zeros, 1, sizeof zeros, archive) == sizeof zeros;
}
