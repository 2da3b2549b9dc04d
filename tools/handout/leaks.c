/* leaks.c - no three lines in a row of a solution stand anywhere in a handout. */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"
#include "tools/handout/rewrite.h"
#include "tools/handout/scan.h"

#include <ctype.h>
#include <string.h>

/* The lines of a text that say something of how an exercise is solved. */
typedef struct lines {
    const char **line;
    size_t *number; /* in the file, from 1 */
    size_t count;
} lines;

/* The line without blanks and without a label such as // Line 4. */
static char *
squeezed(const char *line, size_t length)
{
    char *text = take(length + 1);
    size_t k = 0;
    for (size_t i = 0; i < length; i++) {
        if (line[i] == '/' && i + 1 < length && line[i + 1] == '/')
            break;
        if (!isspace((unsigned char)line[i]))
            text[k++] = line[i];
    }
    return text;
}

/* Fifteen characters, some of them letters; and what to do when memory is out is the
 * same in all functions. */
static bool
is_substantial(const char *line)
{
    static const char *const everywhere[] = {"TRI_OUT_OF_MEMORY", "TRI_OK)", "==NULL)",
                                             "memory_free("};
    size_t letters = 0;
    for (size_t k = 0; k < sizeof everywhere / sizeof *everywhere; k++)
        if (strstr(line, everywhere[k]) != NULL)
            return false;
    for (const char *c = line; *c != '\0'; c++)
        letters += isalpha((unsigned char)*c) != 0;
    return strlen(line) >= 15 && letters >= 4;
}

static lines
substantial_lines(const char *text, size_t length)
{
    lines all = {0};
    size_t number = 1;
    for (size_t i = 0; i < length;) {
        size_t end = i;
        while (end < length && text[end] != '\n')
            end++;
        char *line = squeezed(text + i, end - i);
        if (is_substantial(line)) {
            all.line = take_one_more(all.line, all.count, sizeof *all.line);
            all.number = take_one_more(all.number, all.count, sizeof *all.number);
            all.line[all.count] = line;
            all.number[all.count++] = number;
        }
        i = end + 1;
        number++;
    }
    return all;
}

/* Do three lines in a row of `secret` stand in `open`? Then *at is the first. */
static bool
three_in_common(const lines *secret, const lines *open, size_t *at)
{
    for (size_t i = 0; i + 3 <= secret->count; i++)
        for (size_t k = 0; k + 3 <= open->count; k++) {
            size_t same = 0;
            while (same < 3 &&
                   strcmp(secret->line[i + same], open->line[k + same]) == 0)
                same++;
            if (same == 3) {
                *at = k;
                return true;
            }
        }
    return false;
}

/* ---- Lines that may be shared: exercises.ini, overlap. ---- */

/* The functions with which the exercise may have lines in common. */
static const char *
overlapping(const handout *h, const exercise *e)
{
    const char *rest = exercise_key(&h->project, e, "overlap"), *word, *list = "";
    while ((word = next_word(&rest)) != NULL) {
        const exercise *other = project_find(&h->project, word);
        if (other == NULL)
            list = format("%s %s", list, word);
        else if (other->role == ROLE_GIVEN)
            list = format("%s %s %s", list, other->functions, other->helpers);
    }
    return list;
}

/* A page without its quotes of these functions. */
static const char *
without_quotes(const char *page, const char *functions)
{
    const char *text = "", *at = page, *quote, *end, *name;
    while ((quote = strstr(at, "<!-- code: ")) != NULL &&
           (end = strstr(quote, "\n```\n")) != NULL) {
        name = quote + strlen("<!-- code: ");
        name += strcspn(name, " ");
        name += strspn(name, " ");
        bool shared = has_word(functions, name, strcspn(name, " "));
        text = format("%s%.*s", text, (int)((shared ? quote : end) - at), at);
        at = end;
    }
    return format("%s%s", text, at);
}

static const char *
without_overlap(const tree_file *f, const char *functions)
{
    const exercise shared = {.id = "", .path = f->path, .functions = functions,
                             .helpers = ""};
    if (*functions != '\0' && ends_with(f->path, ".md"))
        return without_quotes(f->bytes, functions);
    if (*functions != '\0' && ends_with(f->path, ".c"))
        return without_exercise(f->bytes, &shared);
    return f->bytes;
}

/* ---- The proof. ---- */

/* What the files of the tree say, to the eyes of an exercise that shares lines with
 * these functions. */
typedef struct open_lines {
    const char *shared;
    lines *of; /* file -> its lines */
} open_lines;

static void
read_open_lines(const handout *h, const char *shared, open_lines *open)
{
    if (open->of != NULL && strcmp(open->shared, shared) == 0)
        return;
    *open = (open_lines){shared, take((h->tree.files + 1) * sizeof *open->of)};
    for (size_t i = 0; i < h->tree.files; i++) {
        const char *text = without_overlap(&h->tree.file[i], shared);
        open->of[i] = substantial_lines(text, strlen(text));
    }
}

static void
prove_part(const handout *h, const exercise *e, const open_lines *open,
           const char *part, size_t length)
{
    lines secret = substantial_lines(part, length);
    for (size_t i = 0; i < h->tree.files; i++) {
        const lines *o = &open->of[i];
        size_t at;
        if (three_in_common(&secret, o, &at))
            refuse(
                "%s: three lines in a row of a solution of %s stand in the handout, in "
                "%s, after line %zu:\n  %s\n  %s\n  %s",
                h->name, e->id, h->tree.file[i].path, o->number[at] - 1, o->line[at],
                o->line[at + 1], o->line[at + 2]);
    }
}

/* The functions of the exercise, and its helpers. */
static void
prove_exercise(const handout *h, const exercise *e, const open_lines *open)
{
    source s;
    const char *text = file_bytes(format("%s/%s", h->project.root, e->path), NULL);
    if (text == NULL || !scan(text, &s))
        refuse("%s: brackets do not match", e->path);
    for (size_t k = 0; k < s.items; k++) {
        const item *part = &s.item[k];
        const char *name = text + part->name;
        if (part->kind == ITEM_FUNCTION &&
            (has_word(e->functions, name, part->length) ||
             has_word(e->helpers, name, part->length)))
            prove_part(h, e, open, text + part->body, part->end - part->body);
    }
}

void
handout_prove_nothing_leaks(const handout *h)
{
    open_lines open = {NULL, NULL};
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role == ROLE_ASKED || e->role == ROLE_LATER) {
            read_open_lines(h, overlapping(h, e), &open);
            prove_exercise(h, e, &open);
        }
    }
}
