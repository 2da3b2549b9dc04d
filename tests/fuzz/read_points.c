/* read_points.c - a fuzz target: no text makes the reader of points misbehave.
 *
 * Whatever the bytes are, they are read or refused with a sentence; what was read is
 * finite, and reads back the same after it has been written. Built with libFuzzer
 * where there is one, else with driver.c.
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

static bool
same_number(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0; /* 0 and -0 differ */
}

/* Writes the points as a .node file and reads that. */
static void
write_and_read(text_points written)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    if (file == NULL)
        return;
    text_write_points(file, written.points, written.count, written.first);
    must(fclose(file) == 0);

    text_points read;
    text_error error;
    must(text_parse_points("a.node", text, size, &read, &error) == TRI_OK);
    must(read.count == written.count && (read.first == written.first || read.count == 0));
    for (uint32_t i = 0; i < read.count; i++)
        must(same_number(read.points[i].x, written.points[i].x) &&
             same_number(read.points[i].y, written.points[i].y));
    text_points_free(&read);
    free(text);
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"-", "a.node", "a.csv"};
    char *bytes = malloc(size + (size == 0)); /* no room for who reads beyond it */
    if (bytes == NULL)
        return 0;
    for (size_t i = 0; i < size; i++)
        bytes[i] = (char)data[i];
    for (int i = 0; i < 3; i++) {
        text_points points;
        text_error error = {0};
        tri_status status = text_parse_points(names[i], bytes, size, &points, &error);
        if (status != TRI_OK) {
            must(points.points == NULL && points.count == 0 && error.text[0] != '\0');
            continue;
        }
        for (uint32_t k = 0; k < points.count; k++)
            must(isfinite(points.points[k].x) && isfinite(points.points[k].y));
        write_and_read(points);
        text_points_free(&points);
    }
    free(bytes);
    return 0;
}
