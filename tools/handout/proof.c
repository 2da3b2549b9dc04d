/* proof.c - a handout is not written before what it promises has been seen to be true.
 *
 *   it compiles without a word from the compiler;
 *   untouched, no property of any exercise holds: they all say todo;
 *   with the reference put back, all of them hold.
 *
 * And nothing of a solution is left (leaks.c).
 */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"

#include <stdlib.h>
#include <string.h>

/* make, silent: what it says is a warning or an error. */
static void
prove_compiles(const handout *h, const char *folder)
{
    const char *said = format("%s/make.txt", h->scratch);
    const char *const make[] = {"make", "-s", NULL};
    int status = run_program(folder, said, make);
    const char *text = file_bytes(said, NULL);
    if (status != 0 || *text != '\0')
        refuse("%s: the tree does not compile without warnings:\n%s", h->name, text);
}

/* How the property came out: the second column of its line; "" if it has none. */
static const char *
result_of(const char *table, const char *property)
{
    size_t length = strlen(property);
    for (const char *line = table; line != NULL && *line != '\0';) {
        if (strncmp(line, property, length) == 0 && line[length] == '\t')
            return part_of(line + length + 1, strcspn(line + length + 1, "\t\n"));
        line = strchr(line, '\n');
        line = line != NULL ? line + 1 : NULL;
    }
    return "";
}

/* Each property of the exercise comes out as `wanted`; but what solves the exercise
 * does not solve a variant of it. */
static void
prove_exercise(const handout *h, const exercise *e, const char *folder,
               const char *wanted)
{
    const char *said = format("%s/check.txt", h->scratch);
    const char *const make[] = {"make", "-s", "check", format("EX=%s", e->id), NULL};
    int status = run_program(folder, said, make);
    const char *table = file_bytes(
        format("%s/build/feedback/%s/properties.tsv", folder, e->id), NULL);
    const char *rest = exercise_key(&h->project, e, "points"), *word;
    bool all = true;
    while ((word = next_word(&rest)) != NULL)
        all &= strcmp(result_of(table, part_of(word, strcspn(word, ":"))), wanted) == 0;
    bool passes = strcmp(wanted, "pass") == 0;
    if (passes && is_asked_in_variant(h, e)) {
        if (all)
            refuse("%s: the reference solves %s, so %s is no variant", h->name, e->id,
                   h->variant);
        return;
    }
    if (!all || (status == 0) != passes)
        refuse("%s: not each property of %s (%s) comes out as %s:\n%s", h->name, e->id,
               exercise_key(&h->project, e, "points"), wanted, file_bytes(said, NULL));
}

static void
prove_tree(const handout *h, const tree *t, const char *folder, const char *wanted)
{
    tree_write(t, folder);
    prove_compiles(h, folder);
    const char *missing = handout_unchecked(h);
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role == ROLE_ASKED && !has_word(missing, e->section, strlen(e->section)))
            prove_exercise(h, e, folder, wanted);
    }
}

/* The project's own files, for the place of those with TODOs. */
static tree
solutions(const handout *h)
{
    tree t = {0};
    for (size_t k = 0; k < h->project.exercises; k++) {
        const exercise *e = &h->project.exercise[k];
        if (e->role >= ROLE_LATER && tree_find(&h->tree, e->path) != NULL)
            tree_put(&t, e->path,
                     file_bytes(format("%s/%s", h->project.root, e->path), NULL));
    }
    return t;
}

/* The second tree is made of the first: the rest of it has been compiled. */
void
handout_prove(const handout *h)
{
    const char *folder = format("%s/proof", h->scratch);
    tree reference = solutions(h);
    prove_tree(h, &h->tree, folder, "todo");
    prove_tree(h, &reference, folder, "pass");
}
