/* textitems.c - the files of Triangle: .node, .ele and .edge. */
#include "lib/decimal.h"
#include "lib/memory.h"
#include "lib/textlines.h"

/* ---- What .node, .ele and .edge have in common. ---- */

/* The first line: at least one whole number, at most `most`; those that are
 * missing keep the value that value[] has. */
static tri_status
read_first_line(text_lines *t, const char *what, uint32_t *value, int most)
{
    if (!text_next_line(t, TEXT_BLANKS)) {
        t->line = t->line > 0 ? t->line : 1;
        return text_refuse(t, "the file is empty: the first line says how many "
                           "%s there are", what);
    }
    text_cell cell;
    for (int i = 0; text_next_cell(t, TEXT_BLANKS, &cell); i++) {
        if (i == most)
            return text_refuse(t, "more than %d numbers on line one", most);
        tri_status status = text_whole(t, cell, &value[i]);
        if (status != TRI_OK)
            return status;
    }
    return TRI_OK;
}

/* No array is made for more items than the file can hold, a byte for each. */
static tri_status
refuse_absurd_count(text_lines *t, const char *what, uint32_t count)
{
    if (count <= (uint64_t)(t->end - t->next))
        return TRI_OK;
    return text_refuse(t, "%lu %s are promised: the file is too short for them",
                       (unsigned long)count, what);
}

/* The line of item i of `count`, up to and with its number. The number of the
 * first one is put into *first. */
static tri_status
read_number(text_lines *t, const char *what, uint32_t i, uint32_t count,
            uint32_t *first)
{
    if (!text_next_line(t, TEXT_BLANKS))
        return text_refuse(t, "the file ends after %lu of %lu %s",
                           (unsigned long)i, (unsigned long)count, what);
    text_cell cell = {NULL, 0};
    uint32_t number;
    text_next_cell(t, TEXT_BLANKS, &cell);
    tri_status status = text_whole(t, cell, &number);
    if (status != TRI_OK)
        return status;
    if (i == 0 && number > 1)
        return text_refuse(t, "%s are numbered from 0 or 1, not from %lu", what,
                           (unsigned long)number);
    if (i == 0)
        *first = number;
    uint64_t expected = (uint64_t)*first + i;
    if (number != expected)
        return text_refuse(t, "number %lu %s: %llu is expected here",
                           (unsigned long)number,
                           number < expected ? "comes twice" : "comes early",
                           (unsigned long long)expected);
    return TRI_OK;
}

/* What is left of an item's line: `numbers` attributes and markers. */
static tri_status
skip_numbers(text_lines *t, uint64_t numbers)
{
    text_cell cell;
    double ignored;
    uint64_t found = 0;
    while (text_next_cell(t, TEXT_BLANKS, &cell)) {
        if (found++ == numbers)
            return text_refuse(t, "more columns than the first line says");
        tri_status status = text_double(t, cell, &ignored);
        if (status != TRI_OK)
            return status;
    }
    if (found < numbers)
        return text_refuse(t, "columns missing at the end: %llu",
                           (unsigned long long)(numbers - found));
    return TRI_OK;
}

static tri_status
refuse_more_lines(text_lines *t, const char *what, uint32_t count)
{
    if (!text_next_line(t, TEXT_BLANKS))
        return TRI_OK;
    return text_refuse(t, "one more line than the %lu %s that were promised",
                       (unsigned long)count, what);
}

/* ---- Points. ---- */

static tri_status
read_coordinate(text_lines *t, double *value)
{
    text_cell cell;
    if (!text_next_cell(t, TEXT_BLANKS, &cell))
        return text_refuse(t, "a column is missing: a line is number, x, y");
    return text_double(t, cell, value);
}

tri_status
text_parse_node(text_lines *t, text_points *out)
{
    uint32_t header[4] = {0, 2, 0, 0}; /* points, 2, attributes, markers */
    tri_status status = read_first_line(t, "points", header, 4);
    if (status == TRI_OK && header[1] != 2)
        return text_refuse(t, "dimension %lu: only the plane, 2, can be read",
                           (unsigned long)header[1]);
    if (status == TRI_OK)
        status = refuse_absurd_count(t, "points", header[0]);
    if (status != TRI_OK)
        return status;

    out->count = header[0];
    out->points = memory_array(out->count, sizeof *out->points);
    if (out->points == NULL)
        return text_fail(t->error, TRI_OUT_OF_MEMORY);
    for (uint32_t i = 0; i < out->count && status == TRI_OK; i++) {
        status = read_number(t, "points", i, out->count, &out->first);
        if (status == TRI_OK)
            status = read_coordinate(t, &out->points[i].x);
        if (status == TRI_OK)
            status = read_coordinate(t, &out->points[i].y);
        if (status == TRI_OK)
            status = skip_numbers(t, (uint64_t)header[2] + header[3]);
    }
    if (status == TRI_OK)
        status = refuse_more_lines(t, "points", out->count);
    return status;
}

/* ---- Triangles and edges: items that name `width` points each. ---- */

static tri_status
read_vertex(text_lines *t, const text_points *points, vertex_id *v)
{
    text_cell cell;
    uint32_t number;
    if (!text_next_cell(t, TEXT_BLANKS, &cell))
        return text_refuse(t, "a column is missing: a point is named here");
    tri_status status = text_whole(t, cell, &number);
    if (status != TRI_OK)
        return status;
    if (number < points->first || number - points->first >= points->count)
        return text_refuse(t, "there is no point %lu: there are %lu, numbered "
                           "from %lu", (unsigned long)number,
                           (unsigned long)points->count,
                           (unsigned long)points->first);
    *v = number - points->first;
    return TRI_OK;
}

/* Reads the items after the first line into *vertices, `width` to an item. When
 * this fails nothing is allocated. */
static tri_status
parse_items(text_lines *t, const char *what, uint32_t count, size_t width,
            uint32_t attributes, const text_points *points,
            vertex_id **vertices)
{
    *vertices = NULL;
    tri_status status = refuse_absurd_count(t, what, count);
    if (status != TRI_OK)
        return status;
    vertex_id *v = memory_array(count, width * sizeof *v);
    if (v == NULL)
        return text_fail(t->error, TRI_OUT_OF_MEMORY);
    uint32_t first = 0;
    for (uint32_t i = 0; i < count && status == TRI_OK; i++) {
        status = read_number(t, what, i, count, &first);
        for (size_t k = 0; k < width && status == TRI_OK; k++)
            status = read_vertex(t, points, &v[i * width + k]);
        if (status == TRI_OK)
            status = skip_numbers(t, attributes);
    }
    if (status == TRI_OK)
        status = refuse_more_lines(t, what, count);
    if (status == TRI_OK)
        *vertices = v;
    else
        memory_free(v);
    return status;
}

tri_status
text_parse_triangles(const char *bytes, size_t size, const text_points *points,
                     triangle_list *out, text_error *error)
{
    *out = (triangle_list){0};
    text_lines t;
    uint32_t header[3] = {0, 3, 0}; /* triangles, points in each, attributes */
    tri_status status = text_lines_begin(&t, bytes, size, error);
    if (status == TRI_OK)
        status = read_first_line(&t, "triangles", header, 3);
    if (status == TRI_OK && header[1] != 3)
        status = text_refuse(&t, "%lu points in a triangle: only 3 can be read",
                             (unsigned long)header[1]);
    vertex_id *corners = NULL;
    if (status == TRI_OK)
        status = parse_items(&t, "triangles", header[0], 3, header[2], points,
                             &corners);
    if (status == TRI_OK)
        *out = (triangle_list){header[0], (vertex_id(*)[3])corners};
    return status;
}

tri_status
text_parse_edges(const char *bytes, size_t size, const text_points *points,
                 edge_list *out, text_error *error)
{
    *out = (edge_list){0};
    text_lines t;
    uint32_t header[2] = {0, 0}; /* edges, markers */
    tri_status status = text_lines_begin(&t, bytes, size, error);
    if (status == TRI_OK)
        status = read_first_line(&t, "edges", header, 2);
    vertex_id *ends = NULL;
    if (status == TRI_OK)
        status = parse_items(&t, "edges", header[0], 2, header[1], points,
                             &ends);
    if (status == TRI_OK)
        *out = (edge_list){header[0], (vertex_id(*)[2])ends};
    return status;
}

