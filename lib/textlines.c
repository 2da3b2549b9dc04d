/* textlines.c - a text taken apart into lines and cells. */
#include "lib/textlines.h"

#include "lib/decimal.h"

#include <stdarg.h>
#include <string.h>

static bool
is_blank(char c)
{
    return c == ' ' || c == '\t';
}

tri_status
text_lines_begin(text_lines *t, const char *bytes, size_t size,
                 text_error *error)
{
    *t = (text_lines){.next = bytes, .end = bytes + size, .error = error};
    const char *nul = size > 0 ? memchr(bytes, '\0', size) : NULL;
    if (nul != NULL) {
        t->line = 1;
        for (const char *c = bytes; c < nul; c++)
            t->line += *c == '\n';
        return text_refuse(t, "a NUL byte: this is no text (ASCII or UTF-8)");
    }
    if (size >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0)
        t->next += 3;
    return TRI_OK;
}

/* The blanks at both ends of t's line go; then, in the files that have them
 * anywhere, its comment. */
static void
trim_line(text_lines *t, text_separator separator)
{
    if (t->line_end > t->at && t->line_end[-1] == '\r')
        t->line_end--;
    while (t->at < t->line_end && is_blank(*t->at))
        t->at++;
    bool comment = t->at < t->line_end && *t->at == '#';
    const char *hash = NULL;
    if (comment || separator == TEXT_BLANKS)
        hash = memchr(t->at, '#', (size_t)(t->line_end - t->at));
    if (hash != NULL)
        t->line_end = hash;
    while (t->line_end > t->at && is_blank(t->line_end[-1]))
        t->line_end--;
}

bool
text_next_line(text_lines *t, text_separator separator)
{
    while (t->next < t->end) {
        const char *newline = memchr(t->next, '\n', (size_t)(t->end - t->next));
        t->at = t->next;
        t->line_end = newline != NULL ? newline : t->end;
        t->next = newline != NULL ? newline + 1 : t->end;
        t->line++;
        trim_line(t, separator);
        if (t->at < t->line_end)
            return true;
    }
    t->at = NULL;
    return false;
}

/* Blanks separate: the line was trimmed, so that a cell begins at t->at. */
static void
cell_before_blank(text_lines *t, text_cell *cell)
{
    const char *c = t->at;
    while (c < t->line_end && !is_blank(*c))
        c++;
    *cell = (text_cell){t->at, (size_t)(c - t->at)};
    while (c < t->line_end && is_blank(*c))
        c++;
    t->at = c < t->line_end ? c : NULL;
}

/* Commas outside quotes separate. A quote in a quoted cell is doubled, so each
 * quote may be taken to end or to begin a quoted part. */
static void
cell_before_comma(text_lines *t, text_cell *cell)
{
    const char *c = t->at;
    bool quoted = false;
    while (c < t->line_end && (quoted || *c != ',')) {
        quoted ^= *c == '"';
        c++;
    }
    const char *from = t->at, *to = c;
    while (from < to && is_blank(*from))
        from++;
    while (to > from && is_blank(to[-1]))
        to--;
    if (to - from >= 2 && *from == '"' && to[-1] == '"') {
        from++;
        to--;
    }
    *cell = (text_cell){from, (size_t)(to - from)};
    t->at = c < t->line_end ? c + 1 : NULL; /* after a comma a cell follows */
}

bool
text_next_cell(text_lines *t, text_separator separator, text_cell *cell)
{
    if (t->at == NULL)
        return false;
    if (separator == TEXT_TABLE_COMMAS)
        cell_before_comma(t, cell);
    else
        cell_before_blank(t, cell);
    return true;
}

tri_status
text_refuse(text_lines *t, const char *sentence, ...)
{
    va_list arguments;
    va_start(arguments, sentence);
    vsnprintf(t->error->text, sizeof t->error->text, sentence, arguments);
    va_end(arguments);
    t->error->line = t->line;
    return TRI_BAD_FILE;
}

tri_status
text_fail(text_error *error, tri_status status)
{
    error->line = 0;
    snprintf(error->text, sizeof error->text, "%s", tri_status_text(status));
    return status;
}

/* The beginning of a cell as it may be shown on a terminal. */
typedef struct shown_cell {
    char text[24];
} shown_cell;

static shown_cell
show(text_cell cell)
{
    shown_cell shown = {""};
    size_t room = sizeof shown.text - 4;
    for (size_t i = 0; i < cell.length && i < room; i++)
        shown.text[i] = cell.at[i] < ' ' || cell.at[i] > '~' ? '?' : cell.at[i];
    if (cell.length > room)
        strcat(shown.text, "...");
    return shown;
}

tri_status
text_double(text_lines *t, text_cell cell, double *value)
{
    switch (decimal_read(cell.at, cell.length, value)) {
    case DECIMAL_NUMBER:
        return TRI_OK;
    case DECIMAL_TOO_LARGE:
        return text_refuse(t, "\"%s\" is too large: the largest double is "
                           "about 1.797e308", show(cell).text);
    case DECIMAL_NO_NUMBER:
        break;
    }
    return text_refuse(t, "\"%s\" is no number: write a decimal such as -12.5 "
                       "or 3e-7", show(cell).text);
}

tri_status
text_whole(text_lines *t, text_cell cell, uint32_t *value)
{
    uint64_t sum = 0;
    bool whole = cell.length > 0;
    for (size_t i = 0; i < cell.length; i++) {
        whole &= cell.at[i] >= '0' && cell.at[i] <= '9';
        if (whole && sum < UINT32_MAX)
            sum = 10 * sum + (uint64_t)(cell.at[i] - '0');
    }
    if (!whole || sum >= UINT32_MAX)
        return text_refuse(t, "\"%s\" is no whole number from 0 to 4294967294",
                           show(cell).text);
    *value = (uint32_t)sum;
    return TRI_OK;
}
