/* textio.c - whole files, and which kind of file it is. The kinds themselves:
 * textitems.c, texttable.c; writing: textwrite.c. */
#include "lib/textio.h"

#include "lib/binary.h"
#include "lib/memory.h"
#include "lib/textlines.h"

#include <errno.h>
#include <string.h>

/* ---- A whole file. ---- */

static tri_status
fail_to_read(text_error *error)
{
    const char *reason = errno != 0 ? strerror(errno) : "unknown reason";
    error->line = 0;
    snprintf(error->text, sizeof error->text, "cannot be read: %s", reason);
    return TRI_CANNOT_READ;
}

/* Reads to the end; the array doubles, so a byte is copied about once more. */
static tri_status
read_stream(FILE *file, char **bytes, size_t *size, text_error *error)
{
    size_t room = 0;
    do {
        if (*size == room) {
            room = room > 0 ? 2 * room : 65536;
            char *more = memory_resize(*bytes, room, 1);
            if (more == NULL)
                return text_fail(error, TRI_OUT_OF_MEMORY);
            *bytes = more;
        }
        *size += fread(*bytes + *size, 1, room - *size, file);
    } while (*size == room);
    return ferror(file) ? fail_to_read(error) : TRI_OK;
}

/* The caller frees *bytes, also when this fails. */
static tri_status
read_whole(const char *path, char **bytes, size_t *size, text_error *error)
{
    *bytes = NULL;
    *size = 0;
    errno = 0;
    if (strcmp(path, "-") == 0)
        return read_stream(stdin, bytes, size, error);
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return fail_to_read(error);
    tri_status status = read_stream(file, bytes, size, error);
    fclose(file);
    return status;
}

/* ---- Points: which kind of file is it? ---- */

static bool
ends_in(const char *name, const char *ending)
{
    size_t length = strlen(name), tail = strlen(ending);
    return length >= tail && strcmp(name + length - tail, ending) == 0;
}

/* Is the first line of four whole numbers, the second of them 2? */
static bool
begins_like_node(text_lines t)
{
    text_error ignored;
    text_cell cell;
    uint32_t value[4];
    int count = 0;
    t.error = &ignored;
    text_next_line(&t, TEXT_BLANKS);
    while (text_next_cell(&t, TEXT_BLANKS, &cell))
        if (count == 4 || text_whole(&t, cell, &value[count++]) != TRI_OK)
            return false;
    return count == 4 && value[1] == 2;
}

tri_status
text_parse_points(const char *name, const char *bytes, size_t size,
                  text_points *out, text_error *error)
{
    if (binary_begins(bytes, size))
        return binary_parse_points(bytes, size, out, error);
    *out = (text_points){0};
    text_lines t;
    tri_status status = text_lines_begin(&t, bytes, size, error);
    if (status != TRI_OK)
        return status;
    bool node = ends_in(name, ".node") ||
                (!ends_in(name, ".csv") && begins_like_node(t));
    status = node ? text_parse_node(&t, out) : text_parse_table(&t, out);
    if (status != TRI_OK)
        text_points_free(out);
    return status;
}

tri_status
text_read_points(const char *path, text_points *out, text_error *error)
{
    *out = (text_points){0};
    char *bytes;
    size_t size;
    tri_status status = read_whole(path, &bytes, &size, error);
    if (status == TRI_OK)
        status = text_parse_points(path, bytes, size, out, error);
    memory_free(bytes);
    return status;
}

void
text_points_free(text_points *points)
{
    memory_free(points->points);
    *points = (text_points){0};
}

/* ---- Triangles and edges. ---- */

tri_status
text_read_triangles(const char *path, const text_points *points,
                    triangle_list *out, text_error *error)
{
    *out = (triangle_list){0};
    char *bytes;
    size_t size;
    tri_status status = read_whole(path, &bytes, &size, error);
    if (status == TRI_OK)
        status = text_parse_triangles(bytes, size, points, out, error);
    memory_free(bytes);
    return status;
}

tri_status
text_read_edges(const char *path, const text_points *points, edge_list *out,
                text_error *error)
{
    *out = (edge_list){0};
    char *bytes;
    size_t size;
    tri_status status = read_whole(path, &bytes, &size, error);
    if (status == TRI_OK)
        status = text_parse_edges(bytes, size, points, out, error);
    memory_free(bytes);
    return status;
}
