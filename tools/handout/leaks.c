/* leaks.c - no three lines in a row of a solution stand anywhere in a handout. */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"
#include "tools/handout/rewrite.h"
#include "tools/handout/scan.h"

#include <ctype.h>
#include <string.h>

/* The lines of a text that say something: with a letter in them and 12 or more
 * characters, each blank taken out. A comment's frame does not count. */
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

static bool
is_substantial(const char *squeezed_line)
{
    size_t letters = 0;
    for (const char *c = squeezed_line; *c != '\0'; c++)
        letters += isalpha((unsigned char)*c) != 0;
    return strlen(squeezed_line) >= 12 && letters >= 4;
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
            while (same < 3 && strcmp(secret->line[i + same], open->line[k + same]) == 0)
                same++;
            if (same == 3) {
                *at = k;
                return true;
            }
        }
    return false;
}

/* The file without the code of given exercises that may share lines with e. */
static const char *
without_overlap(const handout *h, const exercise *e, const tree_file *f)
{
    const char *rest = exercise_key(&h->project, e, "overlap"), *id, *text = f->bytes;
    while ((id = next_word(&rest)) != NULL) {
        const exercise *other = project_find(&h->project, id);
        if (other == NULL)
            refuse("exercises.ini: %s overlaps %s, which does not exist", e->id, id);
        if (other->role == ROLE_GIVEN && strcmp(other->path, f->path) == 0)
            text = without_exercise(text, other);
    }
    return text;
}

static void
prove_part(const handout *h, const exercise *e, const char *part, size_t length)
{
    lines secret = substantial_lines(part, length);
    for (size_t i = 0; i < h->tree.files; i++) {
        const tree_file *f = &h->tree.file[i];
        const char *text = without_overlap(h, e, f);
        lines open = substantial_lines(text, strlen(text));
        size_t at;
        if (three_in_common(&secret, &open, &at))
            refuse("%s: three lines in a row of a solution of %s stand in the handout, in "
                   "%s, after line %zu:\n  %s\n  %s\n  %s", h->name, e->id, f->path,
                   open.number[at] - 1, open.line[at], open.line[at + 1],
                   open.line[at + 2]);
    }
}

void
handout_prove_nothing_leaks(const handout *h)
{
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED && e->role != ROLE_LATER)
            continue;
        source s;
        const char *text = file_bytes(format("%s/%s", h->project.root, e->path), NULL);
        if (text == NULL || !scan(text, &s))
            refuse("%s: brackets do not match", e->path);
        for (size_t k = 0; k < s.items; k++) {
            const item *part = &s.item[k];
            const char *name = text + part->name;
            if (part->kind == ITEM_FUNCTION && (has_word(e->functions, name, part->length) ||
                                                has_word(e->helpers, name, part->length)))
                prove_part(h, e, text + part->body, part->end - part->body);
        }
    }
}
