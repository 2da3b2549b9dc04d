/* selection.c - which exercises a handout asks, and what becomes of the others. */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>

bool
section_is_asked(const handout *h, const char *section)
{
    for (size_t i = 0; i < h->project.exercises; i++)
        if (h->project.exercise[i].role == ROLE_ASKED &&
            strcmp(h->project.exercise[i].section, section) == 0)
            return true;
    return false;
}

const char *
section_folder(const handout *h, const char *section)
{
    glob_t found;
    const char *folder = NULL;
    const char *pattern = format("%s/chapters/%s_*", h->project.root, section);
    if (glob(pattern, 0, NULL, &found) == 0)
        folder = format("%s", found.gl_pathv[0] + strlen(h->project.root) + 1);
    globfree(&found);
    return folder;
}

const char *
exercise_program(const handout *h, const exercise *e)
{
    const char *mode = exercise_key(&h->project, e, "mode");
    return strcmp(mode, "opaque") == 0 ? "opaque" : "plain";
}

bool
is_asked_in_variant(const handout *h, const exercise *e)
{
    return e->role == ROLE_ASKED &&
           has_word(exercise_key(&h->project, e, "variants"), h->variant,
                    strlen(h->variant));
}

/* A word of the request: an exercise, or all of a section. */
static bool
ask(handout *h, const char *word)
{
    bool found = false;
    for (size_t i = 0; i < h->project.exercises; i++) {
        exercise *e = &h->project.exercise[i];
        if (strcmp(e->id, word) == 0 || strcmp(e->section, word) == 0) {
            e->role = ROLE_ASKED;
            found = true;
        }
    }
    return found;
}

/* In a section that is asked, what comes before the last exercise asked is given, and
 * what comes after it is left out. */
static void
assign_roles(handout *h)
{
    project *p = &h->project;
    for (size_t i = 0; i < p->exercises; i++) {
        exercise *e = &p->exercise[i];
        if (e->role == ROLE_ASKED)
            continue;
        e->role = ROLE_GIVEN;
        for (size_t k = 0; k < i; k++)
            if (p->exercise[k].role == ROLE_ASKED &&
                strcmp(p->exercise[k].section, e->section) == 0)
                e->role = ROLE_LATER;
        for (size_t k = i + 1; k < p->exercises; k++)
            if (p->exercise[k].role == ROLE_ASKED &&
                strcmp(p->exercise[k].section, e->section) == 0)
                e->role = ROLE_GIVEN;
    }
}

void
handout_select(handout *h)
{
    const char *rest = ini_value(&h->project.assignments, h->name, "exercises"), *word;
    if (*rest == '\0')
        rest = h->name;
    while ((word = next_word(&rest)) != NULL)
        if (!ask(h, word))
            refuse("%s is no week of docs/assignments.ini, no section and no exercise",
                   word);
    assign_roles(h);
}
