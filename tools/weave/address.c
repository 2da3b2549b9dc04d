/* address.c - where a name stands in a source. */
#include "tools/weave/address.h"

#include <ctype.h>
#include <string.h>

/* ---- Reading a line of C. ---- */

static bool
is_word_character(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* What follows the word at the beginning of the line; NULL if it is another. */
static const char *
after_word(const char *line, const char *word)
{
    size_t k = strlen(word);
    if (!begins_with(line, word) || is_word_character(line[k]))
        return NULL;
    return line + k;
}

static bool
is_blank(const char *line)
{
    return line[indentation(line)] == '\0';
}

/* ---- Addresses. ---- */

/* The line after the first one from i on that begins with a closing brace. */
static size_t
block_end(const text *source, size_t i)
{
    while (i < source->lines && source->line[i][0] != '}')
        i++;
    return i < source->lines ? i + 1 : i;
}

/* The first line of the comment that ends just above line i; i if there is none. */
static size_t
comment_above(const text *source, size_t i)
{
    if (i == 0 || !ends_with(source->line[i - 1], "*/"))
        return i;
    size_t k = i - 1;
    while (k > 0 && !begins_with(source->line[k], "/*"))
        k--;
    return k;
}

/* A function named at line i: is it a body, or a prototype, which comes with its
 * contract, the comment above it? The return type may stand on the line before. */
static range
function_at(const text *source, size_t i)
{
    range r = {i, i};
    if (i > 0 && is_word_character(source->line[i - 1][0]) &&
        strpbrk(source->line[i - 1], ";{") == NULL)
        r.first--;
    while (r.end < source->lines && strpbrk(source->line[r.end], ";{") == NULL)
        r.end++;
    if (r.end < source->lines && strchr(source->line[r.end], '{') == NULL)
        return (range){comment_above(source, r.first), r.end + 1};
    r.end = block_end(source, r.end);
    return r;
}

/* Is NAME( a word of this line that other words stand before, as in the
 * prototypes of a header? */
static bool
is_prototype_of(const char *line, const char *name)
{
    if (!is_word_character(line[0]) || begins_with(line, "typedef"))
        return false;
    for (const char *at = strstr(line, name); at; at = strstr(at + 1, name)) {
        const char *rest = after_word(at, name);
        if (at > line && !is_word_character(at[-1]) && rest && *rest == '(')
            return true;
    }
    return false;
}

/* Does the thing called name begin at line i? Then *r is where it stands. */
static bool
address_at(const text *source, bool header, size_t i, const char *name, range *r)
{
    const char *line = source->line[i], *rest = after_word(line, name);
    if ((rest && *rest == '(') || (header && is_prototype_of(line, name))) {
        *r = function_at(source, i);
        return true;
    }
    *r = (range){i, i + 1};
    if (begins_with(line, "#define ") && after_word(line + 8, name)) {
        while (r->end < source->lines && ends_with(source->line[r->end - 1], "\\"))
            r->end++;
        return true;
    }
    if (begins_with(line, "typedef "))
        line += 8;
    rest = begins_with(line, "struct ") ? after_word(line + 7, name)
           : begins_with(line, "enum ") ? after_word(line + 5, name) : NULL;
    if (rest == NULL || strchr(rest, '{') == NULL)
        return false;
    if (strchr(rest, '}') == NULL)
        r->end = block_end(source, i);
    return true;
}

/* ---- Labels. ---- */

/* The text of the line's label, "Line 5: push ac ..."; NULL if it has none. */
static const char *
label_of(const char *line)
{
    const char *comment = strstr(line, "// ");
    if (comment == NULL)
        return NULL;
    comment += 3;
    bool known = begins_with(comment, "Line ") || begins_with(comment, "Lines ") ||
                 begins_with(comment, "Step ");
    return known ? comment : NULL;
}

/* The end of what the label of line i labels: the next label that is not inside it,
 * or the end of its block. Blank lines before that are left out. */
static size_t
label_end(const text *source, size_t i, size_t limit)
{
    size_t depth = indentation(source->line[i]), end = i + 1;
    for (size_t k = i + 1; k < limit; k++) {
        const char *line = source->line[k];
        if (is_blank(line))
            continue;
        if (indentation(line) < depth || (indentation(line) == depth && label_of(line)))
            break;
        end = k + 1;
    }
    return end;
}

/* Narrows *r to the label, "Line 1" being neither "Line 10" nor "Lines 1-2". Returns
 * how often it stands there. */
static size_t
narrow_to_label(const text *source, const char *label, range *r)
{
    size_t found = 0;
    range whole = *r;
    for (size_t i = whole.first; i < whole.end; i++) {
        const char *here = label_of(source->line[i]);
        const char *rest = here ? after_word(here, label) : NULL;
        if (rest == NULL || *rest == '-')
            continue;
        found++;
        *r = (range){i, label_end(source, i, whole.end)};
    }
    return found;
}

/* ---- The two together. ---- */

bool
address_find(const text *source, const address *a, const char *page, size_t line,
             range *out)
{
    *out = (range){0, source->lines};
    if (a->name[0] == '\0')
        return true;
    size_t found = 0;
    bool header = ends_with(a->path, ".h");
    for (size_t i = 0; i < source->lines; i++) {
        range r;
        if (!address_at(source, header, i, a->name, &r))
            continue;
        if (found++ > 0)
            complain(page, line, "%s stands twice in %s, lines %zu and %zu; rename one",
                     a->name, a->path, out->first + 1, r.first + 1);
        *out = r;
    }
    if (found == 0)
        complain(page, line, "%s has no %s at column 0; correct the name here", a->path,
                 a->name);
    if (found != 1 || a->label[0] == '\0')
        return found == 1;
    found = narrow_to_label(source, a->label, out);
    if (found != 1)
        complain(page, line, "%s %s has the label \"%s\" %zu times, not once", a->path,
                 a->name, a->label, found);
    return found == 1;
}
