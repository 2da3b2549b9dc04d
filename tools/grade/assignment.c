/* assignment.c - what was handed out, and what is made of it. */
#include "tools/grade/grade.h"

#include "tools/handout/basics.h"
#include "tools/handout/exercises.h"

#include <stdlib.h>
#include <string.h>

/* ---- assignment.ini ---- */

static void
add_properties(assignment *a, task *t, const char *points)
{
    const char *word;
    t->first = a->properties;
    while ((word = next_word(&points)) != NULL) {
        const char *colon = strchr(word, ':');
        if (colon == NULL || atoi(colon + 1) <= 0)
            refuse("assignment.ini: the points of %s are not NAME:NUMBER ...",
                   t->exercise);
        a->property = take_one_more(a->property, a->properties, sizeof *a->property);
        a->property[a->properties++] = (graded_property){
            .name = part_of(word, (size_t)(colon - word)), .points = atoi(colon + 1)};
        a->total += t->bonus ? 0 : atoi(colon + 1);
    }
    t->end = a->properties;
}

static void
add_task(assignment *a, const ini *keys, const char *id)
{
    const char *function = ini_value(keys, id, "function");
    const char *path = next_word(&function);
    if (path == NULL || strchr(id, '-') == NULL)
        refuse("assignment.ini: [%s] is no exercise with a function", id);
    task t = {.exercise = id, .path = path, .functions = function};
    t.section = part_of(id, (size_t)(strchr(id, '-') - id));
    t.title = ini_value(keys, id, "title");
    bool opaque = strcmp(ini_value(keys, id, "mode"), "opaque") == 0;
    t.mode = opaque ? "opaque" : "plain";
    t.bonus = strcmp(ini_value(keys, id, "bonus"), "yes") == 0;
    add_properties(a, &t, ini_value(keys, id, "points"));
    a->task = take_one_more(a->task, a->tasks, sizeof *a->task);
    a->task[a->tasks++] = t;
}

assignment
assignment_read(const char *folder)
{
    assignment a = {0};
    ini keys = {0};
    const char *path = format("%s/assignment.ini", folder), *last = "assignment", *word;
    if (!ini_read(&keys, path))
        refuse("%s: there is no such file; the tree that was handed out has it", path);
    a.name = ini_value(&keys, "assignment", "name");
    a.variant = ini_value(&keys, "assignment", "variant");
    const char *files = ini_value(&keys, "assignment", "files");
    while ((word = next_word(&files)) != NULL) {
        a.file = take_one_more(a.file, a.files, sizeof *a.file);
        a.file[a.files++] = word;
    }
    for (size_t i = 0; i < keys.entries; i++)
        if (strcmp(keys.entry[i].section, last) != 0) {
            last = keys.entry[i].section;
            add_task(&a, &keys, last);
        }
    a.exercises = a.tasks;
    if (a.properties > 0 && has_word(ini_value(&keys, "assignment", "files"), ANSWERS,
                                     strlen(ANSWERS)))
        answers_ask(&a, folder);
    for (size_t t = 0; t < a.tasks; t++)
        for (size_t p = a.task[t].first; p < a.task[t].end; p++)
            a.property[p].of = &a.task[t];
    if (a.properties == 0 || a.files == 0)
        refuse("%s asks nothing", path);
    return a;
}

/* ---- Compiling what all submissions have in common. ---- */

/* What a mode's programs are linked with, but for the files that students write, so
 * that nothing handed out can take the place of a function that is missing. */
static void
archive_given(const grading *g, const char *mode)
{
    const char *folder = format("%s/build/%s", g->base, mode), *left_out = "";
    char *said;
    for (size_t f = 0; f < g->asked.files; f++)
        left_out = format("%s ! -path ./%.*s.o", left_out,
                          (int)strlen(g->asked.file[f]) - 2, g->asked.file[f]);
    const char *const sh[] = {"sh", "-c",
                              format("rm -f libgiven.a && "
                                     "find ./lib ./chapters -name '*.o'%s | sort "
                                     ">given && ar qcs libgiven.a $(cat given)",
                                     left_out),
                              NULL};
    if (run(folder, sh, 60, 4000, &said, NULL) != 0)
        refuse("%s: what is given cannot be archived: %s", folder, said);
}

/* Says of a compiled tree how it was compiled. */
static const char *
stamp_of(const grading *g)
{
    return format("%s %s\n", g->compiler, GRADING_FLAGS);
}

bool
base_is_prepared(const grading *g, const char *folder)
{
    const char *stamp = file_bytes(format("%s/build/stamp", folder), NULL);
    return stamp != NULL && strcmp(stamp, stamp_of(g)) == 0;
}

void
base_prepare(const grading *g)
{
    char *said;
    if (base_is_prepared(g, g->base))
        return;
    const char *const make[] = {"make", "-s", format("CC=%s", g->compiler),
                                "CFLAGS=" GRADING_FLAGS, "programs", NULL};
    int status = run(g->base, make, 600, 8000, &said, NULL);
    if (status != 0)
        refuse("the tree that was handed out does not compile (status %d):\n%s", status,
               said);
    for (size_t t = 0; t < g->asked.exercises; t++) {
        bool before = false;
        for (size_t k = 0; k < t; k++)
            before |= strcmp(g->asked.task[k].mode, g->asked.task[t].mode) == 0;
        if (!before)
            archive_given(g, g->asked.task[t].mode);
    }
    write_file(format("%s/build/stamp", g->base), stamp_of(g), strlen(stamp_of(g)));
}
