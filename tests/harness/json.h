/* json.h - reads JSON, and refuses whatever is not (RFC 8259).
 *
 * Needs: nothing. For tests of programs that write it. Stricter than the standard in
 * two things: characters beyond ASCII must be escaped, and no two members of an object
 * have the same name.
 */
#ifndef TESTS_JSON_H
#define TESTS_JSON_H

#include <stdbool.h>
#include <stddef.h>

typedef enum json_kind {
    JSON_NULL, JSON_FALSE, JSON_TRUE, JSON_NUMBER, JSON_STRING, JSON_ARRAY, JSON_OBJECT
} json_kind;

typedef struct json {
    json_kind kind;
    const char *name;  /* of a member of an object; else NULL */
    double number;     /* JSON_NUMBER */
    const char *text;  /* JSON_STRING; escapes \u are question marks */
    size_t count;      /* JSON_ARRAY, JSON_OBJECT: how many there are */
    struct json *item; /* ... and these are they */
} json;

/* Reads the whole text, whose letters it uses up: strings stay where they are. NULL if
 * it is not JSON, or memory is out; *wrong says why and *at where. */
json *json_read(char *text, size_t length, const char **wrong, size_t *at);

/* NULL is accepted. */
void json_free(json *value);

/* The member of that name; NULL if there is none, or if it is no object or NULL. */
const json *json_member(const json *object, const char *name);

#endif
