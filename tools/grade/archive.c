/* archive.c - reading archives that strangers have made: tar and zip. */
#include "tools/grade/archive.h"

#include "tools/handout/basics.h"

#include <string.h>

enum { MOST_FILES = 10000 };

static const char damaged[] =
    "the archive is damaged: make it again with `make submit`";

static void
add_file(archive *a, packed_file f)
{
    if (ends_with(f.name, "/")) /* a folder */
        return;
    if (begins_with(f.name, "./"))
        f.name += 2;
    if (a->files == MOST_FILES) {
        a->trouble = format("the archive has more than %d files", MOST_FILES);
        return;
    }
    a->file = take_one_more(a->file, a->files, sizeof *a->file);
    a->file[a->files++] = f;
}

/* ---- tar: before each file a block with its name, size, type (POSIX ustar). ---- */

enum { BLOCK = 512 };
enum { NAME = 0, SIZE = 124, CHECKSUM = 148, TYPE = 156, MAGIC = 257, PREFIX = 345 };

/* An octal number with blanks or NULs around it; false when it is none. */
static bool
octal(const char *field, size_t width, size_t *value)
{
    size_t i = 0;
    *value = 0;
    while (i < width && field[i] == ' ')
        i++;
    if (i == width || field[i] < '0' || field[i] > '7')
        return false;
    for (; i < width && field[i] >= '0' && field[i] <= '7'; i++)
        *value = *value << 3 | (size_t)(field[i] - '0');
    return i == width || field[i] == ' ' || field[i] == '\0';
}

/* The sum of the header's bytes, its own field counted as blanks. */
static bool
is_header(const char *block)
{
    size_t sum = 0, said;
    for (size_t i = 0; i < BLOCK; i++)
        sum += i >= CHECKSUM && i < CHECKSUM + 8 ? ' ' : (unsigned char)block[i];
    return octal(block + CHECKSUM, 8, &said) && sum == said;
}

/* PREFIX/NAME, as text. A longer name stands elsewhere and is not looked for: no file
 * that is handed in has one. */
static const char *
name_in(const char *block)
{
    const char *name = part_of(block + NAME, strnlen(block + NAME, 100));
    if (strncmp(block + MAGIC, "ustar", 5) != 0 || block[PREFIX] == '\0')
        return name;
    return format("%.155s/%s", block + PREFIX, name);
}

static const char *
trouble_with_type(char type)
{
    return type == '0' || type == '\0'  ? NULL
           : type == '1' || type == '2' ? "it is a link, and not a file"
                                        : "it is a device or a pipe, and not a file";
}

static void
read_tar(archive *a, const char *bytes, size_t size)
{
    for (size_t at = 0;
         a->trouble == NULL && at + BLOCK <= size && is_header(bytes + at);) {
        const char *header = bytes + at;
        char type = header[TYPE];
        size_t length, room = size - at - BLOCK;
        if (!octal(header + SIZE, 12, &length) || length > room) {
            a->trouble = damaged;
            return;
        }
        bool is_said_of_others =
            type == 'x' || type == 'g' || type == 'L' || type == 'K';
        if (type != '5' && !is_said_of_others)
            add_file(a, (packed_file){.name = name_in(header),
                                      .bytes = header + BLOCK,
                                      .size = length,
                                      .trouble = trouble_with_type(type)});
        size_t padded = (length + BLOCK - 1) / BLOCK * BLOCK;
        at += BLOCK + (padded <= room ? padded : room);
    }
}

/* ---- zip: at the end a directory with a row for each file. ---- */

enum { ROW = 46, HEAD = 30, END = 22 };
enum { ROW_MARK = 0x02014B50, HEAD_MARK = 0x04034B50, END_MARK = 0x06054B50 };
enum { STORED = 0, DEFLATED = 8, ENCRYPTED = 1 };
enum { FILE_TYPE = 0170000, REGULAR = 0100000, LINK = 0120000 }; /* of a mode of Unix */

/* A number of 2 or 4 bytes, the low one first. */
static uint32_t
number(const char *at, int bytes)
{
    uint32_t value = 0;
    for (int i = bytes; i-- > 0;)
        value = value << 8 | (unsigned char)at[i];
    return value;
}

/* Where the last record is, which says where the directory is; behind it there is only
 * a comment, of at most 64 KB. NULL: it is no zip. */
static const char *
end_of_zip(const char *bytes, size_t size)
{
    for (size_t comment = 0; comment <= UINT16_MAX && size >= END + comment;
         comment++) {
        const char *at = bytes + size - END - comment;
        if (number(at, 4) == END_MARK && number(at + 20, 2) == comment)
            return at;
    }
    return NULL;
}

/* Some programs of Windows write backslashes. */
static const char *
name_of_row(const char *row)
{
    char *name = part_of(row + ROW, number(row + 28, 2));
    for (char *c = name; *c != '\0'; c++)
        if (*c == '\\')
            *c = '/';
    return name;
}

/* The file of a row, which says all about it but where its bytes begin: behind its
 * head. */
static packed_file
file_of_row(const char *bytes, size_t size, const char *row)
{
    packed_file f = {.name = name_of_row(row), .whole = number(row + 24, 4),
                     .checksum = number(row + 16, 4), .size = number(row + 20, 4)};
    uint32_t method = number(row + 10, 2), type = number(row + 38, 4) >> 16 & FILE_TYPE;
    size_t at = number(row + 42, 4);
    f.deflated = method == DEFLATED;
    if (number(row + 8, 2) & ENCRYPTED)
        f.trouble = "it is encrypted";
    else if (type == LINK)
        f.trouble = "it is a link, and not a file";
    else if (type != 0 && type != REGULAR)
        f.trouble = "it is a device or a pipe, and not a file";
    else if (method != STORED && method != DEFLATED)
        f.trouble = "it is compressed in a way that is not known here";
    if (size < HEAD || at > size - HEAD || number(bytes + at, 4) != HEAD_MARK) {
        f.trouble = damaged;
        return f;
    }
    at += HEAD + number(bytes + at + 26, 2) + number(bytes + at + 28, 2);
    if (at > size || f.size > size - at || (method == STORED && f.size != f.whole))
        f.trouble = damaged;
    else
        f.bytes = bytes + at;
    return f;
}

static void
read_zip(archive *a, const char *bytes, size_t size, const char *end)
{
    size_t rows = number(end + 10, 2), at = number(end + 16, 4);
    for (size_t i = 0; i < rows && a->trouble == NULL; i++) {
        if (size < ROW || at > size - ROW || number(bytes + at, 4) != ROW_MARK) {
            a->trouble = damaged;
            return;
        }
        const char *row = bytes + at;
        at += ROW + number(row + 28, 2) + number(row + 30, 2) + number(row + 32, 2);
        if (at > size) {
            a->trouble = damaged;
            return;
        }
        if (number(row + 28, 2) == strlen(name_of_row(row)))
            add_file(a, file_of_row(bytes, size, row));
    }
}

/* ---- Either. ---- */

archive
archive_read(const char *bytes, size_t size)
{
    archive a = {0};
    const char *end = end_of_zip(bytes, size);
    if (size >= BLOCK && is_header(bytes))
        read_tar(&a, bytes, size);
    else if (end != NULL)
        read_zip(&a, bytes, size, end);
    else
        a.trouble = "it is no archive: neither tar nor zip";
    if (a.trouble != NULL)
        a.files = 0;
    return a;
}

size_t
archive_ending(const char *name)
{
    static const char *const endings[] = {".tar", ".tar.gz", ".tgz", ".zip"};
    for (int i = 0; i < 4; i++)
        if (ends_with(name, endings[i]))
            return strlen(endings[i]);
    return 0;
}

bool
leads_elsewhere(const char *name)
{
    if (*name == '/')
        return true;
    for (; *name != '\0'; name += strcspn(name, "/"), name += *name == '/')
        if (strcspn(name, "/") == 2 && strncmp(name, "..", 2) == 0)
            return true;
    return false;
}

static bool
ends_with_path(const char *name, const char *path)
{
    size_t n = strlen(name), p = strlen(path);
    return ends_with(name, path) && (n == p || name[n - p - 1] == '/');
}

static size_t
depth_of(const char *name)
{
    size_t slashes = 0;
    for (; *name != '\0'; name++)
        slashes += *name == '/';
    return slashes;
}

packed_file *
archive_find(const archive *a, const char *path, const char **trouble)
{
    packed_file *best = NULL, *twin = NULL;
    for (size_t i = 0; i < a->files; i++) {
        packed_file *f = &a->file[i];
        if (leads_elsewhere(f->name) || !ends_with_path(f->name, path))
            continue;
        if (best == NULL || depth_of(f->name) < depth_of(best->name)) {
            best = f;
            twin = NULL;
        } else if (depth_of(f->name) == depth_of(best->name)) {
            twin = f;
        }
    }
    if (twin != NULL)
        *trouble =
            format("the archive has it twice: as %s and as %s", best->name, twin->name);
    else if (best != NULL)
        *trouble = best->trouble;
    return best != NULL && *trouble == NULL ? best : NULL;
}
