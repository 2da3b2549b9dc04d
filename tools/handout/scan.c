/* scan.c - the top level of a C source. */
#include "tools/handout/scan.h"

#include "tools/handout/basics.h"

#include <ctype.h>
#include <string.h>

/* ---- Words, comments, literals, directives. ---- */

size_t
word_length(const char *text, size_t i)
{
    size_t k = i;
    while (isalnum((unsigned char)text[k]) || text[k] == '_')
        k++;
    return isdigit((unsigned char)text[i]) ? 0 : k - i;
}

static size_t
after_literal(const char *text, size_t i)
{
    char quote = text[i++];
    while (text[i] != '\0' && text[i] != quote && text[i] != '\n')
        i += text[i] == '\\' && text[i + 1] != '\0' ? 2 : 1;
    return text[i] == quote ? i + 1 : i;
}

static size_t
after_line(const char *text, size_t i)
{
    return i + strcspn(text + i, "\n");
}

size_t
after_inert(const char *text, size_t i)
{
    if (text[i] == '"' || text[i] == '\'')
        return after_literal(text, i);
    if (text[i] == '/' && text[i + 1] == '/')
        return after_line(text, i);
    if (text[i] == '/' && text[i + 1] == '*') {
        const char *close = strstr(text + i + 2, "*/");
        return close != NULL ? (size_t)(close - text) + 2 : i + strlen(text + i);
    }
    return i;
}

static bool
is_comment(const char *text, size_t i)
{
    return text[i] == '/' && (text[i + 1] == '/' || text[i + 1] == '*');
}

/* Is i the first character of its line that is no blank? */
static bool
begins_line(const char *text, size_t i)
{
    while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t'))
        i--;
    return i == 0 || text[i - 1] == '\n';
}

/* Behind the directive at i, its continued lines and its comments included. */
static size_t
after_directive(const char *text, size_t i)
{
    while (text[i] != '\0' && text[i] != '\n') {
        size_t k = after_inert(text, i);
        if (k > i)
            i = k;
        else
            i += text[i] == '\\' && text[i + 1] != '\0' ? 2 : 1;
    }
    return i;
}

/* The word behind the # of a directive. */
static const char *
directive_word(const char *text, size_t i)
{
    return text + i + 1 + strspn(text + i + 1, " \t");
}

/* Behind a part that is switched off, which begins with the #if 0 at i: before its
 * #else or #endif. */
static size_t
after_switched_off(const char *text, size_t i)
{
    int depth = 0;
    for (; text[i] != '\0'; i = after_line(text, i) + 1) {
        size_t k = i + strspn(text + i, " \t");
        if (text[k] != '#') {
            if (text[after_line(text, i)] == '\0')
                break;
            continue;
        }
        const char *word = directive_word(text, k);
        if (depth == 1 && (begins_with(word, "endif") || begins_with(word, "el")))
            return i;
        depth += begins_with(word, "if") - begins_with(word, "endif");
        if (text[after_line(text, i)] == '\0')
            break;
    }
    return i + strlen(text + i);
}

/* Behind whatever is not code at i: a comment, a literal, a directive, a part that is
 * switched off; else i. */
static size_t
after_other(const char *text, size_t i)
{
    if (text[i] != '#' || !begins_line(text, i))
        return after_inert(text, i);
    const char *word = directive_word(text, i);
    if (begins_with(word, "if 0") && !isalnum((unsigned char)word[4]))
        return after_switched_off(text, i);
    return after_directive(text, i);
}

size_t
find_word(const char *text, size_t begin, size_t end, const char *word, size_t length)
{
    size_t i = begin;
    while (i < end) {
        size_t k = after_inert(text, i), here = word_length(text, i);
        if (k > i)
            i = k;
        else if (here == length && memcmp(text + i, word, length) == 0)
            return i;
        else if (isalnum((unsigned char)text[i]))
            while (isalnum((unsigned char)text[i]) || text[i] == '_')
                i++;
        else
            i++;
    }
    return end;
}

/* ---- One item. ---- */

/* Words that may stand before a bracket and name nothing. */
static bool
is_attribute(const char *word, size_t length)
{
    static const char *const known =
        "__attribute__ __attribute _Alignas _Static_assert "
        "__declspec __asm__ asm _Pragma";
    return has_word(known, word, length);
}

typedef struct position {
    const char *text;
    size_t at;
    int depth;         /* of brackets of all kinds */
    size_t word, length; /* the last word outside of brackets */
    bool is_typedef, assigned;
    bool has_parameters; /* a name with a bracket behind it: a function */
} position;

/* A word outside of brackets. */
static void
see_word(position *p, item *out, size_t length)
{
    const char *word = p->text + p->at;
    if (length == 6 && memcmp(word, "static", 6) == 0)
        out->is_static = true;
    if (length == 7 && memcmp(word, "typedef", 7) == 0)
        p->is_typedef = true;
    p->word = p->at;
    p->length = length;
    if (!p->has_parameters && !p->assigned && !is_attribute(word, length)) {
        out->name = p->at;
        out->length = length;
    }
}

/* An opening bracket outside of others: does it begin parameters, or a body? */
static void
see_bracket(position *p, item *out)
{
    char c = p->text[p->at];
    if (c == '(' && p->is_typedef && p->text[p->at + 1] == '*') {
        out->name = p->at + 2;
        out->length = word_length(p->text, out->name);
        p->has_parameters = true;
    } else if (c == '(' && p->length > 0 && !p->assigned &&
               !is_attribute(p->text + p->word, p->length)) {
        p->has_parameters = true;
    } else if (c == '[') {
        p->assigned = true; /* an array: its name has been seen */
    } else if (c == '{' && p->has_parameters && !p->assigned && !p->is_typedef) {
        out->kind = ITEM_FUNCTION;
        out->body = p->at;
    }
}

/* Reads the declaration or definition that begins at p->at; false: it never ends. */
static bool
scan_item(position *p, item *out)
{
    *out = (item){.kind = ITEM_OTHER, .comment = p->at, .begin = p->at};
    for (;;) {
        size_t i = p->at, k = after_other(p->text, i), length = word_length(p->text, i);
        char c = p->text[i];
        if (c == '\0')
            return false;
        if (k > i) {
            p->at = k;
            continue;
        }
        if (length > 0) {
            if (p->depth == 0)
                see_word(p, out, length);
            p->at += length;
            continue;
        }
        if (p->depth == 0 && strchr("([{", c) != NULL)
            see_bracket(p, out);
        if (p->depth == 0 && c == '=')
            p->assigned = true;
        p->depth += (strchr("([{", c) != NULL) - (strchr(")]}", c) != NULL);
        p->at++;
        if (p->depth < 0)
            return false;
        if (p->depth == 0 && ((c == '}' && out->kind == ITEM_FUNCTION) || c == ';'))
            break;
    }
    out->end = p->at;
    if (out->kind == ITEM_OTHER && p->has_parameters && !p->is_typedef && !p->assigned)
        out->kind = ITEM_PROTOTYPE;
    return true;
}

static item
scan_directive(const char *text, size_t i)
{
    item d = {.kind = ITEM_DIRECTIVE, .comment = i, .begin = i,
              .end = after_other(text, i)};
    size_t k = (size_t)(directive_word(text, i) - text);
    if (begins_with(text + k, "define")) {
        k += 6;
        k += strspn(text + k, " \t");
        d.name = k;
        d.length = word_length(text, k);
    }
    return d;
}

/* ---- All items. ---- */

/* How many newlines stand in text[begin .. end)? */
static size_t
newlines(const char *text, size_t begin, size_t end)
{
    size_t count = 0;
    for (size_t i = begin; i < end; i++)
        count += text[i] == '\n';
    return count;
}

static void
append(source *s, item i)
{
    s->item = take_one_more(s->item, s->items, sizeof *s->item);
    s->item[s->items++] = i;
}

bool
scan(const char *text, source *out)
{
    *out = (source){.text = text};
    size_t i = 0, comment = 0, comment_end = 0;
    bool above = false; /* is there a comment right above? */
    while (text[i] != '\0') {
        size_t last = out->items > 0 ? out->item[out->items - 1].end : 0;
        bool own_line = out->items == 0 || newlines(text, last, i) > 0;
        if (isspace((unsigned char)text[i]) || text[i] == ';') {
            i++;
            continue;
        }
        if (above && newlines(text, comment_end, i) > 1)
            above = false;
        if (is_comment(text, i)) {
            if (!above)
                comment = i;
            above = own_line;
            i = comment_end = after_inert(text, i);
            continue;
        }
        item next;
        if (text[i] == '#' && begins_line(text, i)) {
            next = scan_directive(text, i);
        } else {
            position p = {.text = text, .at = i};
            if (!scan_item(&p, &next))
                return false;
        }
        if (above)
            next.comment = comment;
        above = false;
        append(out, next);
        i = next.end;
    }
    return true;
}

bool
item_is(const source *s, const item *i, const char *name, size_t length)
{
    return i->length == length && length > 0 &&
           memcmp(s->text + i->name, name, length) == 0;
}

const item *
find_function(const source *s, const char *name, size_t length)
{
    for (size_t k = 0; k < s->items; k++)
        if (s->item[k].kind == ITEM_FUNCTION && item_is(s, &s->item[k], name, length))
            return &s->item[k];
    return NULL;
}
