/* rewrite.c - taking code out of a source, and putting other code in. */
#include "tools/handout/rewrite.h"

#include "tools/handout/basics.h"
#include "tools/handout/scan.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Edits. ---- */

/* text[begin .. end) becomes `by`. */
typedef struct edit {
    size_t begin, end;
    const char *by;
} edit;

typedef struct edits {
    edit *edit;
    size_t count;
} edits;

static void
add_edit(edits *list, size_t begin, size_t end, const char *by)
{
    list->edit = take_one_more(list->edit, list->count, sizeof *list->edit);
    list->edit[list->count++] = (edit){begin, end, by};
}

static int
by_place(const void *left, const void *right)
{
    const edit *a = left, *b = right;
    return (a->begin > b->begin) - (a->begin < b->begin);
}

/* The text with all edits made. Requires: they do not overlap. */
static char *
edited(const char *text, edits *list)
{
    if (list->count > 0)
        qsort(list->edit, list->count, sizeof *list->edit, by_place);
    char *result;
    size_t size, at = 0;
    FILE *out = open_memstream(&result, &size);
    if (out == NULL)
        give_up("memory");
    for (size_t i = 0; i < list->count; i++) {
        fprintf(out, "%.*s%s", (int)(list->edit[i].begin - at), text + at,
                list->edit[i].by);
        at = list->edit[i].end;
    }
    fputs(text + at, out);
    if (fclose(out) != 0)
        give_up("memory");
    char *kept = part_of(result, size);
    free(result);
    return kept;
}

/* ---- Without an exercise. ---- */

/* Behind the blank lines that follow. */
static size_t
after_blank_lines(const char *text, size_t i)
{
    size_t k = i;
    while (isspace((unsigned char)text[k])) {
        if (text[k] == '\n')
            i = k + 1;
        k++;
    }
    return i;
}

/* A contract in the header is enough for a function that has one: the comment above
 * its body says why that body is right. */
static void
cut_body(edits *list, const source *s, const item *i, const char *id)
{
    const char *stub = format("{\n    TODO(\"%s\");\n}", id);
    bool own_line = s->text[i->body - 1] == '\n';
    if (!i->is_static && i->comment < i->begin)
        add_edit(list, i->comment, i->begin, "");
    add_edit(list, i->body, i->end, own_line ? stub : format("\n%s", stub));
}

char *
without_exercise(const char *text, const exercise *e)
{
    source s;
    edits list = {0};
    if (!scan(text, &s))
        refuse("%s: brackets do not match", e->path);
    for (size_t k = 0; k < s.items; k++) {
        const item *i = &s.item[k];
        bool function = has_word(e->functions, text + i->name, i->length);
        bool helper = has_word(e->helpers, text + i->name, i->length);
        if (i->length == 0 || i->kind == ITEM_DIRECTIVE || i->kind == ITEM_OTHER)
            continue;
        if (i->kind == ITEM_FUNCTION && (function || (helper && !i->is_static)))
            cut_body(&list, &s, i, e->id);
        else if (helper && i->is_static)
            add_edit(&list, i->comment, after_blank_lines(text, i->end), "");
    }
    return edited(text, &list);
}

char *
with_todo(const char *text)
{
    source s;
    size_t last = 0;
    if (strstr(text, "\"lib/todo.h\"") != NULL)
        return part_of(text, strlen(text));
    if (!scan(text, &s))
        refuse("brackets do not match");
    for (size_t k = 0; k < s.items; k++) {
        const item *i = &s.item[k];
        const char *word = text + i->begin + 1 + strspn(text + i->begin + 1, " \t");
        if (i->kind == ITEM_DIRECTIVE && begins_with(word, "include"))
            last = i->end;
    }
    edits list = {0};
    add_edit(&list, last, last,
             last > 0 ? "\n#include \"lib/todo.h\"" : "#include \"lib/todo.h\"\n");
    return edited(text, &list);
}

/* ---- With functions of another source. ---- */

char *
functions_of(const char *reference, const exercise *e)
{
    source s;
    const char *rest = e->helpers, *name;
    char *list = part_of(e->functions, strlen(e->functions));
    if (!scan(reference, &s))
        refuse("%s: brackets do not match", e->path);
    while ((name = next_word(&rest)) != NULL) {
        const item *i = find_function(&s, name, strlen(name));
        if (i != NULL && !i->is_static)
            list = format("%s %s", list, name);
    }
    return list;
}

/* What becomes of the reference's items. */
typedef enum fate {
    NOT_NEEDED,
    THE_SAME, /* the student's source says the same in the same words */
    TAKEN,    /* under its own name, which is free */
    RENAMED
} fate;

typedef struct graft {
    source from, to;
    const char *functions, *others;
    fate *fate; /* item of `from` -> what becomes of it */
} graft;

/* Are these the same words? Blanks and comments do not count. */
static bool
same_words(const char *a, size_t a_end, size_t i, const char *b, size_t b_end, size_t k)
{
    for (;;) {
        while (i < a_end && (isspace((unsigned char)a[i]) ||
                             (a[i] == '/' && after_inert(a, i) > i)))
            i = a[i] == '/' ? after_inert(a, i) : i + 1;
        while (k < b_end && (isspace((unsigned char)b[k]) ||
                             (b[k] == '/' && after_inert(b, k) > k)))
            k = b[k] == '/' ? after_inert(b, k) : k + 1;
        if (i >= a_end || k >= b_end)
            return i >= a_end && k >= b_end;
        if (a[i++] != b[k++])
            return false;
    }
}

/* The student's item of this name; NULL if the name is free. A prototype does not
 * count. */
static const item *
namesake(const graft *g, const item *i)
{
    for (size_t k = 0; k < g->to.items; k++)
        if (g->to.item[k].kind != ITEM_PROTOTYPE &&
            item_is(&g->to, &g->to.item[k], g->from.text + i->name, i->length))
            return &g->to.item[k];
    return NULL;
}

static bool
uses(const graft *g, const item *user, const item *used)
{
    return user != used &&
           find_word(g->from.text, user->begin, user->end, g->from.text + used->name,
                     used->length) < user->end;
}

/* May the item be taken along: is it the file's own, and no exercise of its own? */
static bool
is_local(const graft *g, const item *i)
{
    if (i->length == 0 || i->kind == ITEM_PROTOTYPE)
        return false;
    if (i->kind == ITEM_FUNCTION)
        return i->is_static &&
               !has_word(g->others, g->from.text + i->name, i->length) &&
               !has_word(g->functions, g->from.text + i->name, i->length);
    return true;
}

static bool
is_wanted(const graft *g, const item *i)
{
    return i->kind == ITEM_FUNCTION &&
           has_word(g->functions, g->from.text + i->name, i->length);
}

/* Marks what the functions need, and what that needs. */
static void
find_needed(graft *g)
{
    bool more = true;
    while (more) {
        more = false;
        for (size_t u = 0; u < g->from.items; u++) {
            const item *user = &g->from.item[u];
            for (size_t k = 0; k < g->from.items; k++) {
                const item *used = &g->from.item[k];
                if ((is_wanted(g, user) || g->fate[u] != NOT_NEEDED) &&
                    g->fate[k] == NOT_NEEDED && is_local(g, used) &&
                    uses(g, user, used)) {
                    g->fate[k] = THE_SAME;
                    more = true;
                }
            }
        }
    }
}

/* An item is the same only if it stands above where it is used, and what it uses is the
 * same. */
static void
decide_fates(graft *g, size_t place)
{
    bool more = true;
    for (size_t k = 0; k < g->from.items; k++) {
        const item *i = &g->from.item[k], *there = namesake(g, i);
        if (g->fate[k] == NOT_NEEDED)
            continue;
        if (there == NULL)
            g->fate[k] = TAKEN;
        else if (there->begin > place ||
                 !same_words(g->from.text, i->end, i->begin, g->to.text, there->end,
                             there->begin))
            g->fate[k] = RENAMED;
    }
    while (more) {
        more = false;
        for (size_t u = 0; u < g->from.items; u++)
            for (size_t k = 0; k < g->from.items; k++)
                if (g->fate[u] == THE_SAME && g->fate[k] == RENAMED &&
                    uses(g, &g->from.item[u], &g->from.item[k])) {
                    g->fate[u] = RENAMED;
                    more = true;
                }
    }
}

/* Writes part of the reference with the names that its items have now. */
static void
write_renamed(FILE *out, const graft *g, size_t begin, size_t end)
{
    const char *text = g->from.text;
    for (size_t i = begin; i < end;) {
        size_t k = after_inert(text, i), length = word_length(text, i);
        if (k == i && length == 0) {
            k = i + 1;
            while (isdigit((unsigned char)text[i]) && isalnum((unsigned char)text[k]))
                k++;
        }
        for (size_t j = 0; length > 0 && j < g->from.items; j++)
            if (g->fate[j] == RENAMED &&
                item_is(&g->from, &g->from.item[j], text + i, length)) {
                fprintf(out, "reference_%s_", g->functions);
                break;
            }
        if (length > 0)
            k = i + length;
        fprintf(out, "%.*s", (int)(k - i), text + i);
        i = k;
    }
}

/* All that the function needs and that has not been written yet, then the function. */
static char *
written_out(graft *g, const item *function)
{
    char *result;
    size_t size;
    FILE *out = open_memstream(&result, &size);
    if (out == NULL)
        give_up("memory");
    for (size_t k = 0; k < g->from.items; k++) {
        const item *i = &g->from.item[k];
        if (g->fate[k] != TAKEN && g->fate[k] != RENAMED)
            continue;
        write_renamed(out, g, i->begin, i->end);
        fputs("\n\n", out);
    }
    write_renamed(out, g, function->begin, function->end);
    if (fclose(out) != 0)
        give_up("memory");
    char *kept = part_of(result, size);
    free(result);
    return kept;
}

static char *
with_function(const char *student, const char *reference, const char *name,
              const char *others, const char **missing)
{
    graft g = {.functions = name, .others = others};
    *missing = "";
    if (!scan(reference, &g.from) || !scan(student, &g.to))
        return NULL;
    const item *theirs = find_function(&g.from, name, strlen(name));
    const item *own = find_function(&g.to, name, strlen(name));
    *missing = name;
    if (theirs == NULL || own == NULL)
        return NULL;
    g.fate = take((g.from.items + 1) * sizeof *g.fate);
    find_needed(&g);
    decide_fates(&g, own->begin);
    edits list = {0};
    add_edit(&list, own->begin, own->end, written_out(&g, theirs));
    return edited(student, &list);
}

/* The includes of the reference that the student's source does not have come first. */
static char *
with_includes(const char *student, const char *reference)
{
    source from;
    char *text = part_of(student, strlen(student));
    if (!scan(reference, &from))
        return NULL;
    for (size_t k = from.items; k > 0; k--) {
        const item *i = &from.item[k - 1];
        const char *line = part_of(reference + i->begin, i->end - i->begin);
        if (i->kind == ITEM_DIRECTIVE && begins_with(line, "#include") &&
            strstr(text, line) == NULL)
            text = format("%s\n%s", line, text);
    }
    return text;
}

char *
with_functions_of(const char *student, const char *reference, const char *functions,
                  const char *others, const char **missing)
{
    const char *rest = functions, *name;
    char *text = with_includes(student, reference);
    *missing = "";
    while (text != NULL && (name = next_word(&rest)) != NULL)
        text = with_function(text, reference, name, others, missing);
    return text != NULL && strstr(text, "TODO(") != NULL ? with_todo(text) : text;
}
