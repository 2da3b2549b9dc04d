/* json.c - a reader of JSON by recursive descent. */
#include "tests/harness/json.h"

#include "lib/decimal.h"

#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 8 };

typedef struct reader {
    char *text;
    size_t length, at;
    const char *wrong; /* NULL so far */
} reader;

static bool
fail(reader *r, const char *wrong)
{
    if (r->wrong == NULL)
        r->wrong = wrong;
    return false;
}

/* The next character, or 0 at the end. */
static char
peek(const reader *r)
{
    return r->at < r->length ? r->text[r->at] : '\0';
}

static void
skip_blanks(reader *r)
{
    while (r->at < r->length && strchr(" \t\r\n", r->text[r->at]) != NULL &&
           r->text[r->at] != '\0')
        r->at++;
}

static bool
take(reader *r, char c, const char *wrong)
{
    if (r->at >= r->length || r->text[r->at] != c)
        return fail(r, wrong);
    r->at++;
    return true;
}

/* ---- Words, numbers, strings. ---- */

static bool
read_word(reader *r, json *value)
{
    static const struct {
        const char *word;
        json_kind kind;
    } words[] = {{"null", JSON_NULL}, {"true", JSON_TRUE}, {"false", JSON_FALSE}};
    for (size_t i = 0; i < 3; i++) {
        size_t length = strlen(words[i].word);
        if (r->length - r->at >= length &&
            memcmp(r->text + r->at, words[i].word, length) == 0) {
            r->at += length;
            value->kind = words[i].kind;
            return true;
        }
    }
    return fail(r, "a value is missing");
}

static bool
skip_digits(reader *r)
{
    size_t from = r->at;
    while (peek(r) >= '0' && peek(r) <= '9')
        r->at++;
    return r->at > from || fail(r, "a digit is missing");
}

static bool
read_number(reader *r, json *value)
{
    size_t from = r->at;
    if (peek(r) == '-')
        r->at++;
    bool zero = peek(r) == '0';
    size_t first = r->at;
    if (!skip_digits(r))
        return false;
    if (zero && r->at > first + 1)
        return fail(r, "a number begins with 0");
    if (peek(r) == '.') {
        r->at++;
        if (!skip_digits(r))
            return false;
    }
    if (peek(r) == 'e' || peek(r) == 'E') {
        r->at++;
        if (peek(r) == '+' || peek(r) == '-')
            r->at++;
        if (!skip_digits(r))
            return false;
    }
    value->kind = JSON_NUMBER;
    if (decimal_read(r->text + from, r->at - from, &value->number) != DECIMAL_NUMBER)
        return fail(r, "the number is too large");
    return true;
}

/* The character of an escape, whose backslash has been read. */
static bool
read_escape(reader *r, char *c)
{
    static const char letters[] = "\"\\/bfnrt", meant[] = "\"\\/\b\f\n\r\t";
    char letter = peek(r);
    const char *found = letter != '\0' ? strchr(letters, letter) : NULL;
    r->at++;
    if (found != NULL) {
        *c = meant[found - letters];
        return true;
    }
    if (letter != 'u')
        return fail(r, "there is no such escape");
    for (int i = 0; i < 4; i++, r->at++)
        if (peek(r) == '\0' || strchr("0123456789abcdefABCDEF", peek(r)) == NULL)
            return fail(r, "four hexadecimal digits are missing");
    *c = '?';
    return true;
}

static const char *
read_string(reader *r)
{
    if (!take(r, '"', "a string is missing"))
        return NULL;
    char *begin = r->text + r->at, *end = begin;
    while (r->at < r->length && peek(r) != '"') {
        char c = r->text[r->at++];
        if ((unsigned char)c < ' ' || (unsigned char)c > 126) {
            fail(r, "a character that must be escaped");
            return NULL;
        }
        if (c == '\\' && !read_escape(r, &c))
            return NULL;
        *end++ = c;
    }
    if (!take(r, '"', "a string does not end"))
        return NULL;
    *end = '\0';
    return begin;
}

/* ---- Arrays and objects. ---- */

static bool read_value(reader *r, json *value, int depth);

static json *
add_item(reader *r, json *value)
{
    if ((value->count & (value->count - 1)) == 0) { /* 0, a power of two: it is full */
        size_t room = value->count == 0 ? 1 : 2 * value->count;
        json *item = realloc(value->item, room * sizeof *item);
        if (item == NULL) {
            fail(r, "memory is out");
            return NULL;
        }
        value->item = item;
    }
    json *added = &value->item[value->count++];
    *added = (json){.kind = JSON_NULL};
    return added;
}

static bool
read_member(reader *r, json *object, int depth)
{
    const char *name = read_string(r);
    if (name == NULL)
        return false;
    if (json_member(object, name) != NULL)
        return fail(r, "a name stands twice");
    json *item = add_item(r, object);
    if (item == NULL)
        return false;
    item->name = name;
    skip_blanks(r);
    return take(r, ':', "a colon is missing") && read_value(r, item, depth + 1);
}

static bool
read_items(reader *r, json *value, int depth)
{
    bool object = peek(r) == '{';
    char end = object ? '}' : ']';
    value->kind = object ? JSON_OBJECT : JSON_ARRAY;
    if (depth == DEEPEST)
        return fail(r, "this is too deep");
    r->at++;
    skip_blanks(r);
    if (peek(r) == end) {
        r->at++;
        return true;
    }
    for (;;) {
        skip_blanks(r);
        if (object) {
            if (!read_member(r, value, depth))
                return false;
        } else {
            json *item = add_item(r, value);
            if (item == NULL || !read_value(r, item, depth + 1))
                return false;
        }
        if (peek(r) == end) {
            r->at++;
            return true;
        }
        if (!take(r, ',', "a comma is missing"))
            return false;
    }
}

/* A value and the blanks around it. */
static bool
read_value(reader *r, json *value, int depth)
{
    bool good;
    skip_blanks(r);
    char c = peek(r);
    if (c == '{' || c == '[') {
        good = read_items(r, value, depth);
    } else if (c == '"') {
        value->kind = JSON_STRING;
        value->text = read_string(r);
        good = value->text != NULL;
    } else if (c == '-' || (c >= '0' && c <= '9')) {
        good = read_number(r, value);
    } else {
        good = read_word(r, value);
    }
    skip_blanks(r);
    return good;
}

/* ---- The whole. ---- */

json *
json_read(char *text, size_t length, const char **wrong, size_t *at)
{
    reader r = {.text = text, .length = length};
    json *value = calloc(1, sizeof *value);
    if (value == NULL)
        fail(&r, "memory is out");
    else if (read_value(&r, value, 0) && r.at < length)
        fail(&r, "something follows");
    *wrong = r.wrong;
    *at = r.at;
    if (r.wrong == NULL)
        return value;
    json_free(value);
    return NULL;
}

static void
free_items(json *value)
{
    for (size_t i = 0; i < value->count; i++)
        free_items(&value->item[i]);
    free(value->item);
}

void
json_free(json *value)
{
    if (value != NULL)
        free_items(value);
    free(value);
}

const json *
json_member(const json *object, const char *name)
{
    if (object == NULL || object->kind != JSON_OBJECT)
        return NULL;
    for (size_t i = 0; i < object->count; i++)
        if (strcmp(object->item[i].name, name) == 0)
            return &object->item[i];
    return NULL;
}
