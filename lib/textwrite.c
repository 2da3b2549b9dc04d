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

/* Room for one more number and a separator. */
static char *
make_room(buffer *b)
{
    if (sizeof b->bytes - b->used < DECIMAL_ROOM + 1)
        flush(b);
    return b->bytes + b->used;
}

static void
put_whole(buffer *b, uint64_t number, char after)
{
    char *text = make_room(b);
    int length = decimal_write_integer(text, number);
    text[length] = after;
    b->used += (size_t)length + 1;
}

static void
put_double(buffer *b, double number, char after)
{
    char *text = make_room(b);
    int length = decimal_write(text, number);
    text[length] = after;
    b->used += (size_t)length + 1;
}

void
text_write_points(FILE *file, const point2 *points, uint32_t n, uint32_t first)
{
    buffer b;
    b.file = file;
    b.used = 0;
    put_whole(&b, n, ' ');
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
    b.file = file;
    b.used = 0;
    put_whole(&b, list.count, ' ');
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
    b.file = file;
    b.used = 0;
    put_whole(&b, list.count, ' ');
    put_whole(&b, 0, '\n');
    for (uint32_t i = 0; i < list.count; i++) {
        put_whole(&b, (uint64_t)first + i, ' ');
        put_whole(&b, (uint64_t)first + list.ends[i][0], ' ');
        put_whole(&b, (uint64_t)first + list.ends[i][1], '\n');
    }
    flush(&b);
}
