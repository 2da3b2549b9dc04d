/* viva.c - a conversation: what a student has written, and one planted bug.
 *
 * Points certify code, not who wrote it. Whoever wrote these functions can say why
 * they are right, and what goes wrong when a line is changed.
 */
#include "tools/grade/grade.h"

#include "tools/grade/clean.h"
#include "tools/handout/basics.h"
#include "tools/handout/scan.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

/* The same for the same name, and for another name another. */
static uint64_t
number_of(const char *id)
{
    uint64_t number = 14695981039346656037u;
    for (const char *c = id; *c != '\0'; c++)
        number = (number ^ (unsigned char)*c) * 1099511628211u;
    return number ^ number >> 32;
}

static void
print_function(const char *text, const item *i)
{
    printf("%s\n\n", clean(text + i->comment, i->end - i->comment, 20000));
}

/* ---- The student's functions. ---- */

/* Those of task t, from the file below `sources`. */
static void
print_own(const task *t, const char *sources)
{
    source s;
    const char *text = file_bytes(format("%s/%s", sources, t->path), NULL), *word;
    const char *functions = t->functions;
    printf("---- %s: %s (%s) ----\n\n", t->exercise, t->title, t->path);
    bool readable = text != NULL && scan(text, &s);
    while ((word = next_word(&functions)) != NULL) {
        const item *i = readable ? find_function(&s, word, strlen(word)) : NULL;
        if (i != NULL)
            print_function(text, i);
        else
            printf("(there is no function %s)\n\n", word);
    }
}

/* ---- The planted bug: tests/mutants, of the sections that are asked. ---- */

/* The rest of the next line that begins with `key`; NULL if there is none. */
static const char *
value_of(const char *text, const char *key, const char **behind)
{
    size_t length = strlen(key);
    for (const char *line = text; line != NULL && *line != '\0';) {
        const char *end = line + strcspn(line, "\n");
        if (strncmp(line, key, length) == 0) {
            line += length;
            line += strspn(line, " ");
            if (behind != NULL)
                *behind = end;
            return part_of(line, line < end ? (size_t)(end - line) : 0);
        }
        line = *end == '\n' ? end + 1 : NULL;
    }
    return NULL;
}

static bool
is_of_assignment(const assignment *a, const char *mutant)
{
    const char *path = value_of(mutant, "file:", NULL);
    for (size_t t = 0; path != NULL && t < a->tasks; t++)
        if (begins_with(path, format("chapters/%s_", a->task[t].section)))
            return true;
    return false;
}

/* The source with the bug in it, and where the last of the changes is. */
static const char *
plant(const char *mutant, const char *text, size_t *place)
{
    const char *from, *to, *rest = mutant;
    while ((from = value_of(rest, "replace:", &rest)) != NULL) {
        to = value_of(rest, "with:", NULL);
        const char *at = strstr(text, from);
        if (at == NULL)
            return NULL;
        *place = (size_t)(at - text);
        text = format("%.*s%s%s", (int)*place, text, to != NULL ? to : "",
                      at + strlen(from));
    }
    return text;
}

static void
print_bug(const char *project, const char *mutant)
{
    source s;
    size_t place = 0;
    const char *path = value_of(mutant, "file:", NULL);
    const char *text = file_bytes(format("%s/%s", project, path), NULL);
    text = text != NULL ? plant(mutant, text, &place) : NULL;
    if (text == NULL || !scan(text, &s))
        refuse("%s: the bug cannot be planted", path);
    printf("---- Somebody writes this in %s. Which statement fails, and why? ----\n\n",
           path);
    for (size_t i = 0; i < s.items; i++)
        if (s.item[i].comment <= place && place < s.item[i].end)
            print_function(text, &s.item[i]);
    printf("---- For the examiner ----\n\n%s; it is caught by %s (%s).\n",
           value_of(mutant, "bug:", NULL), value_of(mutant, "killed by:", NULL),
           value_of(mutant, "run:", NULL));
}

static const char *
choose_bug(const assignment *a, const char *project, uint64_t number)
{
    glob_t files;
    const char **mutant = NULL;
    size_t count = 0;
    if (glob(format("%s/tests/mutants/*.mutant", project), 0, NULL, &files) != 0)
        refuse("tests/mutants: no bugs are there; run it in the root of the project");
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *text = file_bytes(files.gl_pathv[i], NULL);
        if (text == NULL || !is_of_assignment(a, text))
            continue;
        mutant = take_one_more(mutant, count, sizeof *mutant);
        mutant[count++] = text;
    }
    globfree(&files);
    if (count == 0)
        refuse("tests/mutants has no bug for %s", a->name);
    return mutant[number % count];
}

void
viva(const grading *g, const char *id, const char *path)
{
    const assignment *a = &g->asked;
    const char *sources = format("%s/viva", g->work);
    uint64_t number = number_of(id);
    listed l = files_collect(g, path, sources);
    printf("%s, %s\n\n", clean(id, strlen(id), 200), a->name);
    for (size_t f = 0; f < a->files; f++)
        if (l.trouble[f] != NULL)
            printf("%s is not theirs: %s.\n\n", a->file[f], l.trouble[f]);
    size_t count = a->exercises;
    size_t shown = count < 3 ? count : 3, first = number / 997 % count;
    for (size_t t = 0; t < count; t++)
        if ((t + count - first) % count < shown)
            print_own(&a->task[t], sources);
    print_bug(g->project, choose_bug(a, g->project, number));
}
