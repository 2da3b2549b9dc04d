/* binary.c - points as their bits: for programs that have no time for decimals. */
#include "lib/binary.h"

#include "lib/memory.h"
#include "lib/textlines.h"

#include <math.h>
#include <string.h>

/* The first byte is in no text (it begins no character of UTF-8), and the ends of lines
 * show whether the file was changed on its way as if it were one. */
static const unsigned char magic[8] = {0x89, 'T', 'R', 'I', '\r', '\n', 0x1a, '\n'};

enum { VERSION = 1, HEADER = 16, EACH = 16 }; /* bytes: the header, a point */

/* ---- Numbers, whatever the order of bytes in this machine's. ---- */

static void
put(unsigned char *to, uint64_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        to[i] = (unsigned char)(number >> 8 * i & 255);
}

static uint64_t
get(const unsigned char *from, int bytes)
{
    uint64_t number = 0;
    for (int i = 0; i < bytes; i++)
        number |= (uint64_t)from[i] << 8 * i;
    return number;
}

static void
put_double(unsigned char *to, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    put(to, bits, 8);
}

static double
get_double(const unsigned char *from)
{
    double x;
    uint64_t bits = get(from, 8);
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* ---- Files. ---- */

bool
binary_begins(const char *bytes, size_t size)
{
    return size >= sizeof magic && memcmp(bytes, magic, sizeof magic) == 0;
}

/* What is wrong is nowhere in a line: the whole file is meant. */
static tri_status
refuse(text_lines *t, const char *sentence, uint64_t number)
{
    t->line = 0;
    return text_refuse(t, sentence, (unsigned long long)number);
}

tri_status
binary_parse_points(const char *bytes, size_t size, text_points *out,
                    text_error *error)
{
    text_lines t = {.error = error};
    const unsigned char *from = (const unsigned char *)bytes;
    *out = (text_points){0};
    if (size < HEADER)
        return refuse(&t, "binary points: cut off in the header, after %llu bytes",
                      size);
    uint64_t version = get(from + 8, 4), count = get(from + 12, 4);
    if (version != VERSION)
        return refuse(&t, "binary points of version %llu: only version 1 can be read",
                      version);
    if (size != HEADER + EACH * count)
        return refuse(&t, "binary points: the file has not the length of the %llu "
                      "points that it promises", count);
    if (count == UINT32_MAX)
        return text_fail(error, TRI_TOO_MANY_POINTS);

    point2 *points = memory_array((size_t)count, sizeof *points);
    if (points == NULL)
        return text_fail(error, TRI_OUT_OF_MEMORY);
    for (uint64_t i = 0; i < count; i++) {
        from = (const unsigned char *)bytes + HEADER + EACH * i;
        points[i] = (point2){get_double(from), get_double(from + 8)};
        if (!isfinite(points[i].x) || !isfinite(points[i].y)) {
            memory_free(points);
            return refuse(&t, "binary points: point %llu (from 0) is not finite", i);
        }
    }
    *out = (text_points){(uint32_t)count, 0, points};
    return TRI_OK;
}

void
binary_write_points(FILE *file, const point2 *points, uint32_t n)
{
    unsigned char header[HEADER], bytes[EACH * 1024];
    memcpy(header, magic, sizeof magic);
    put(header + 8, VERSION, 4);
    put(header + 12, n, 4);
    fwrite(header, 1, sizeof header, file);
    size_t used = 0;
    for (uint32_t i = 0; i < n; i++) {
        put_double(bytes + used, points[i].x);
        put_double(bytes + used + 8, points[i].y);
        used += EACH;
        if (used == sizeof bytes || i + 1 == n) {
            fwrite(bytes, 1, used, file);
            used = 0;
        }
    }
}
