/* read_files.c - a fuzz target: no text makes the readers of files misbehave.
 *
 * Whatever the bytes are, they are read or refused with a sentence, as points, as
 * triangles and as edges; what was read is finite and in range, and reads back the same
 * after it has been written. Built with libFuzzer where there is one, else with
 * driver.c.
 */
#include "lib/textio.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Stops the program, which is how a fuzzer learns of a failure. */
static void
must(bool holds)
{
    if (!holds)
        abort();
}

/* A refusal says why, and leaves nothing behind. */
static void
must_refuse(const text_error *error, const void *array, uint32_t count)
{
    must(array == NULL && count == 0 && error->text[0] != '\0');
}

/* A text that is being written. */
typedef struct memory_file {
    FILE *file;
    char *text;
    size_t size;
} memory_file;

static void
begin_writing(memory_file *m)
{
    m->file = open_memstream(&m->text, &m->size);
    must(m->file != NULL);
}

static void
end_writing(memory_file *m)
{
    must(fclose(m->file) == 0);
}

/* ---- Points. ---- */

static bool
same_number(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0; /* 0 and -0 differ */
}

static void
write_and_read_points(text_points written)
{
    memory_file m;
    text_points read;
    text_error error;
    begin_writing(&m);
    text_write_points(m.file, written.points, written.count, written.first);
    end_writing(&m);
    must(text_parse_points("a.node", m.text, m.size, &read, &error) == TRI_OK);
    must(read.count == written.count &&
         (read.first == written.first || read.count == 0));
    for (uint32_t i = 0; i < read.count; i++)
        must(same_number(read.points[i].x, written.points[i].x) &&
             same_number(read.points[i].y, written.points[i].y));
    text_points_free(&read);
    free(m.text);
}

static void
try_points(const char *name, const char *bytes, size_t size)
{
    text_points points;
    text_error error = {0};
    if (text_parse_points(name, bytes, size, &points, &error) != TRI_OK) {
        must_refuse(&error, points.points, points.count);
        return;
    }
    for (uint32_t i = 0; i < points.count; i++)
        must(isfinite(points.points[i].x) && isfinite(points.points[i].y));
    write_and_read_points(points);
    text_points_free(&points);
}

/* ---- Triangles and edges, among these points. ---- */

static const text_points among[] = {{.count = 0, .first = 0},
                                    {.count = 4, .first = 0},
                                    {.count = 4, .first = 1},
                                    {.count = UINT32_MAX, .first = 0}};

static void
try_triangles(const char *bytes, size_t size, const text_points *points)
{
    triangle_list list, read;
    text_error error = {0};
    if (text_parse_triangles(bytes, size, points, &list, &error) != TRI_OK) {
        must_refuse(&error, list.corner, list.count);
        return;
    }
    for (uint32_t i = 0; i < list.count; i++)
        for (int k = 0; k < 3; k++)
            must(list.corner[i][k] < points->count);
    memory_file m;
    begin_writing(&m);
    text_write_triangles(m.file, list, points->first);
    end_writing(&m);
    must(text_parse_triangles(m.text, m.size, points, &read, &error) == TRI_OK);
    must(read.count == list.count &&
         memcmp(read.corner, list.corner, list.count * sizeof *list.corner) == 0);
    free(m.text);
    triangle_list_free(&read);
    triangle_list_free(&list);
}

static void
try_edges(const char *bytes, size_t size, const text_points *points)
{
    edge_list list, read;
    text_error error = {0};
    if (text_parse_edges(bytes, size, points, &list, &error) != TRI_OK) {
        must_refuse(&error, list.ends, list.count);
        return;
    }
    for (uint32_t i = 0; i < list.count; i++)
        for (int k = 0; k < 2; k++)
            must(list.ends[i][k] < points->count);
    memory_file m;
    begin_writing(&m);
    text_write_edges(m.file, list, points->first);
    end_writing(&m);
    must(text_parse_edges(m.text, m.size, points, &read, &error) == TRI_OK);
    must(read.count == list.count &&
         memcmp(read.ends, list.ends, list.count * sizeof *list.ends) == 0);
    free(m.text);
    edge_list_free(&read);
    edge_list_free(&list);
}

/* ---- All of them. ---- */

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"-", "a.node", "a.csv"};
    char *bytes = malloc(size + (size == 0)); /* no room for who reads beyond it */
    must(bytes != NULL);
    for (size_t i = 0; i < size; i++)
        bytes[i] = (char)data[i];
    for (int i = 0; i < 3; i++)
        try_points(names[i], bytes, size);
    for (size_t i = 0; i < sizeof among / sizeof among[0]; i++) {
        try_triangles(bytes, size, &among[i]);
        try_edges(bytes, size, &among[i]);
    }
    free(bytes);
    return 0;
}
