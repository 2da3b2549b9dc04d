/* exercises.c - what exercises.ini and assignments.ini say. */
#include "tools/handout/exercises.h"

#include "tools/handout/basics.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>

/* ---- Files of keys. ---- */

/* The text without blanks around it. */
static char *
trimmed(const char *begin, const char *end)
{
    while (begin < end && strchr(" \t\r", *begin) != NULL)
        begin++;
    while (begin < end && strchr(" \t\r", end[-1]) != NULL)
        end--;
    return part_of(begin, (size_t)(end - begin));
}

bool
ini_read(ini *all, const char *path)
{
    const char *bytes = file_bytes(path, NULL), *section = "";
    if (bytes == NULL)
        return false;
    for (size_t line = 1; *bytes != '\0'; line++) {
        const char *end = bytes + strcspn(bytes, "\n");
        const char *equals = memchr(bytes, '=', (size_t)(end - bytes));
        if (*bytes == '[' && end > bytes + 1 && end[-1] == ']') {
            section = part_of(bytes + 1, (size_t)(end - bytes) - 2);
        } else if (equals != NULL && *bytes != '#') {
            all->entry = take_one_more(all->entry, all->entries, sizeof *all->entry);
            all->entry[all->entries++] =
                (ini_entry){section, trimmed(bytes, equals), trimmed(equals + 1, end)};
        } else if (*bytes != '#' && bytes + strspn(bytes, " \t\r") < end) {
            refuse("%s:%zu: this is neither [name] nor key = value", path, line);
        }
        bytes = *end == '\n' ? end + 1 : end;
    }
    return true;
}

const char *
ini_value(const ini *all, const char *section, const char *key)
{
    for (size_t i = 0; i < all->entries; i++)
        if (strcmp(all->entry[i].section, section) == 0 &&
            strcmp(all->entry[i].key, key) == 0)
            return all->entry[i].value;
    return "";
}

/* ---- Exercises. ---- */

const char *
exercise_key(const project *p, const exercise *e, const char *key)
{
    return ini_value(&p->keys, e->id, key);
}

int
exercise_points(const project *p, const exercise *e)
{
    const char *rest = exercise_key(p, e, "points"), *word;
    int sum = 0;
    while ((word = next_word(&rest)) != NULL)
        sum += strchr(word, ':') != NULL ? atoi(strchr(word, ':') + 1) : 0;
    return sum;
}

const exercise *
project_find(const project *p, const char *id)
{
    for (size_t i = 0; i < p->exercises; i++)
        if (strcmp(p->exercise[i].id, id) == 0)
            return &p->exercise[i];
    return NULL;
}

static void
add_exercise(project *p, const char *id, const char *folder)
{
    exercise e = {.id = id, .folder = folder};
    const char *rest = ini_value(&p->keys, id, "function");
    const char *dash = strchr(id, '-');
    e.path = next_word(&rest);
    if (dash == NULL || e.path == NULL)
        refuse("%s/exercises.ini: [%s] is no number of an exercise with a function",
               folder, id);
    e.section = part_of(id, (size_t)(dash - id));
    e.functions = rest;
    e.helpers = ini_value(&p->keys, id, "helpers");
    p->exercise = take_one_more(p->exercise, p->exercises, sizeof *p->exercise);
    p->exercise[p->exercises++] = e;
}

static void
read_section(project *p, const char *path)
{
    size_t before = p->keys.entries;
    ini_read(&p->keys, path);
    const char *inside = path + strlen(p->root) + 1, *last = "";
    const char *folder = part_of(inside, strlen(inside) - strlen("/exercises.ini"));
    for (size_t i = before; i < p->keys.entries; i++) {
        const char *id = p->keys.entry[i].section;
        if (strcmp(id, last) != 0)
            add_exercise(p, id, folder);
        last = id;
    }
}

project
project_read(const char *root)
{
    project p = {.root = root};
    glob_t found;
    if (glob(format("%s/chapters/*/exercises.ini", root), 0, NULL, &found) != 0)
        refuse("%s is not the root of the project: it has no chapters/*/exercises.ini",
               root);
    for (size_t i = 0; i < found.gl_pathc; i++)
        read_section(&p, format("%s", found.gl_pathv[i]));
    globfree(&found);
    ini_read(&p.assignments, format("%s/docs/assignments.ini", root));
    return p;
}
