/* scan.h - the top level of a C source: which functions it has, and where they stand.
 *
 * Not a parser: it follows comments, literals, directives and brackets, and that is
 * enough to find each definition whatever style its braces are in.
 */
#ifndef TOOLS_HANDOUT_SCAN_H
#define TOOLS_HANDOUT_SCAN_H

#include <stdbool.h>
#include <stddef.h>

typedef enum item_kind {
    ITEM_FUNCTION,  /* with its body */
    ITEM_PROTOTYPE,
    ITEM_DIRECTIVE, /* a line that begins with #, and its continuations */
    ITEM_OTHER      /* a type, a variable */
} item_kind;

/* The places are offsets into the text. */
typedef struct item {
    item_kind kind;
    size_t comment; /* where the comment begins that stands right above; else = begin */
    size_t begin;
    size_t body;    /* of a function: its opening brace */
    size_t end;     /* behind the last character; a newline may follow */
    size_t name, length; /* what is declared; #define: the macro; length 0: nothing */
    bool is_static;
} item;

typedef struct source {
    const char *text; /* the caller's */
    item *item;
    size_t items;
} source;

/* false when something is opened in the text and never closed. */
bool scan(const char *text, source *out);

/* The definition of a function; NULL if there is none. */
const item *find_function(const source *s, const char *name, size_t length);

/* Does item i declare this name? */
bool item_is(const source *s, const item *i, const char *name, size_t length);

/* Does the word stand in text[begin .. end), outside of comments and literals? Returns
 * the first place from `begin` on, or `end`. */
size_t find_word(const char *text, size_t begin, size_t end, const char *word,
                 size_t length);

/* The identifier that begins at i; 0 if none does. */
size_t word_length(const char *text, size_t i);

/* Behind the comment or the literal that begins at i; i if none does. */
size_t after_inert(const char *text, size_t i);

#endif
