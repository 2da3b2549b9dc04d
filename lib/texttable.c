/* texttable.c - points from a table: CSV, or columns between blanks. */
#include "lib/decimal.h"
#include "lib/memory.h"
#include "lib/textlines.h"

#include <string.h>

/* What the first line says. */
typedef struct table {
    text_separator separator;
    uint64_t columns;
    uint64_t x, y; /* the columns to read, from 0 */
    bool header;
} table;

static bool
same_word(text_cell cell, const char *lower)
{
    if (cell.length != strlen(lower))
        return false;
    for (size_t i = 0; i < cell.length; i++) {
        char c = cell.at[i];
        if (c >= 'A' && c <= 'Z')
            c = (char)(c - 'A' + 'a');
        if (c != lower[i])
            return false;
    }
    return true;
}

/* Would some program take this for a number? NaN and infinity are refused, so
 * they must not pass for the names of columns here. */
static bool
looks_like_number(text_cell cell)
{
    double ignored;
    if (decimal_read(cell.at, cell.length, &ignored) != DECIMAL_NO_NUMBER)
        return true;
    if (cell.length > 0 && (*cell.at == '+' || *cell.at == '-'))
        cell = (text_cell){cell.at + 1, cell.length - 1};
    return same_word(cell, "nan") || same_word(cell, "inf") ||
           same_word(cell, "infinity");
}

/* The first line, which t has reached; a copy is read, so that a line that is
 * no header can be read again. */
static tri_status
read_first_line(text_lines t, table *tab)
{
    const uint64_t nowhere = UINT64_MAX;
    uint64_t x = nowhere, y = nowhere, lon = nowhere, lat = nowhere;
    text_cell cell;
    *tab = (table){.separator = TEXT_TABLE_BLANKS, .y = 1, .header = true};
    if (memchr(t.at, ',', (size_t)(t.line_end - t.at)) != NULL)
        tab->separator = TEXT_TABLE_COMMAS;
    for (; text_next_cell(&t, tab->separator, &cell); tab->columns++) {
        tab->header &= !looks_like_number(cell);
        if (same_word(cell, "x"))
            x = tab->columns;
        else if (same_word(cell, "y"))
            y = tab->columns;
        else if (same_word(cell, "lon"))
            lon = tab->columns;
        else if (same_word(cell, "lat"))
            lat = tab->columns;
    }
    if (tab->columns < 2)
        return text_refuse(&t, "one column, and two are needed: x and y, "
                           "separated by blanks or by a comma");
    if (tab->header && x != nowhere && y != nowhere) {
        tab->x = x;
        tab->y = y;
    } else if (tab->header && lon != nowhere && lat != nowhere) {
        tab->x = lon;
        tab->y = lat;
    }
    return TRI_OK;
}

/* The point of the line that t has reached. */
static tri_status
read_point(text_lines *t, const table *tab, point2 *p)
{
    text_cell cell;
    uint64_t column = 0;
    for (; text_next_cell(t, tab->separator, &cell); column++) {
        tri_status status = TRI_OK;
        if (column == tab->x)
            status = text_double(t, cell, &p->x);
        else if (column == tab->y)
            status = text_double(t, cell, &p->y);
        if (status != TRI_OK)
            return status;
    }
    if (column != tab->columns)
        return text_refuse(t, "columns: %llu, where the first line has %llu",
                           (unsigned long long)column,
                           (unsigned long long)tab->columns);
    return TRI_OK;
}

tri_status
text_parse_table(text_lines *t, text_points *out)
{
    table tab;
    if (!text_next_line(t, TEXT_TABLE_BLANKS)) {
        t->line = t->line > 0 ? t->line : 1;
        return text_refuse(t, "the file is empty: a point \"x y\" a line is "
                           "expected");
    }
    tri_status status = read_first_line(*t, &tab);
    if (status != TRI_OK)
        return status;
    bool more = tab.header ? text_next_line(t, tab.separator) : true;
    if (!more)
        return text_refuse(t, "there are no points after the header");

    uint32_t room = 1024;
    for (; more; more = text_next_line(t, tab.separator)) {
        if (out->count == UINT32_MAX - 1)
            return text_fail(t->error, TRI_TOO_MANY_POINTS);
        if (out->points == NULL || out->count == room) {
            room = room <= UINT32_MAX / 2 ? 2 * room : UINT32_MAX;
            point2 *grown = memory_resize(out->points, room, sizeof *grown);
            if (grown == NULL)
                return text_fail(t->error, TRI_OUT_OF_MEMORY);
            out->points = grown;
        }
        status = read_point(t, &tab, &out->points[out->count]);
        if (status != TRI_OK)
            return status;
        out->count++;
    }
    return TRI_OK;
}
