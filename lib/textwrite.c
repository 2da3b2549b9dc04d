/* textwrite.c - writing the files of Triangle. */
#include "lib/decimal.h"
#include "lib/textio.h"

/* Text on its way to a file: printf a number takes longer than finding it. */
typedef struct buffer {
    FILE *file;
    size_t used;
    char bytes[65536];
} buffer;

static void
flush(buffer *b)
{
    fwrite(b->bytes, 1, b->used, b->file);
    b->used = 0;
}

static void
make_room(buffer *b)
{
    if (sizeof b->bytes - b->used < DECIMAL_ROOM + 1)
        flush(b);
}

static void
put_whole(buffer *b, uint64_t number, char after)
{
    make_room(b);
    b->used += (size_t)decimal_write_integer(b->bytes + b->used, number);
    b->bytes[b->used++] = after;
}

static void
put_double(buffer *b, double number, char after)
{
    make_room(b);
    b->used += (size_t)decimal_write(b->bytes + b->used, number);
    b->bytes[b->used++] = after;
}

/* The first line begins with the number of items. */
static void
begin(buffer *b, FILE *file, uint32_t count)
{
    b->file = file;
    b->used = 0; /* bytes[] need not be filled */
    put_whole(b, count, ' ');
}

void
text_write_points(FILE *file, const point2 *points, uint32_t n, uint32_t first)
{
    buffer b;
    begin(&b, file, n);
    put_whole(&b, 2, ' ');
    put_whole(&b, 0, ' ');
    put_whole(&b, 0, '\n');
    for (uint32_t i = 0; i < n; i++) {
        put_whole(&b, (uint64_t)first + i, ' ');
        put_double(&b, points[i].x, ' ');
        put_double(&b, points[i].y, '\n');
    }
    flush(&b);
}

void
text_write_triangles(FILE *file, triangle_list list, uint32_t first)
{
    buffer b;
    begin(&b, file, list.count);
    put_whole(&b, 3, ' ');
    put_whole(&b, 0, '\n');
    for (uint32_t i = 0; i < list.count; i++) {
        put_whole(&b, (uint64_t)first + i, ' ');
        put_whole(&b, (uint64_t)first + list.corner[i][0], ' ');
        put_whole(&b, (uint64_t)first + list.corner[i][1], ' ');
        put_whole(&b, (uint64_t)first + list.corner[i][2], '\n');
    }
    flush(&b);
}

void
text_write_edges(FILE *file, edge_list list, uint32_t first)
{
    buffer b;
    begin(&b, file, list.count);
    put_whole(&b, 0, '\n');
    for (uint32_t i = 0; i < list.count; i++) {
        put_whole(&b, (uint64_t)first + i, ' ');
        put_whole(&b, (uint64_t)first + list.ends[i][0], ' ');
        put_whole(&b, (uint64_t)first + list.ends[i][1], '\n');
    }
    flush(&b);
}
