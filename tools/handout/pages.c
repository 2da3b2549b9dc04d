/* pages.c - what a student reads: pages without the solutions, and what is
 * generated. */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"
#include "tools/handout/rewrite.h"

#include <stdlib.h>
#include <string.h>

/* ---- Pages: quotes and references whose target is not in the tree give way. ---- */

/* The exercise, asked or later, that has taken this name out of the file; NULL if
 * none. */
static const exercise *
taken_out(const handout *h, const char *path, const char *name, bool *helper)
{
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if ((e->role != ROLE_ASKED && e->role != ROLE_LATER) ||
            strcmp(e->path, path) != 0)
            continue;
        *helper = has_word(e->helpers, name, strlen(name));
        if (*helper || has_word(e->functions, name, strlen(name)))
            return e;
    }
    return NULL;
}

/* What stands in the place of the quote with this address; NULL if it can stay. */
static const char *
instead_of_quote(const handout *h, const char *line)
{
    char path[256] = "", name[128] = "", label[128] = "";
    int fields =
        sscanf(line, "<!-- code: %255s %127s \"%127[^\"]\"", path, name, label);
    if (fields < 1)
        return NULL;
    if (tree_find(&h->tree, path) == NULL)
        return format("*(This code is in `%s`, which is not in your tree.)*", path);
    bool helper = false;
    const exercise *e = fields >= 2 ? taken_out(h, path, name, &helper) : NULL;
    if (e != NULL && (helper || fields == 3))
        return format("*(Exercise %s: yours to write.)*", e->id);
    return NULL;
}

/* The path that a link in this page leads to, from the root of the tree. */
static const char *
target_path(const char *page, const char *target)
{
    const char *slash = strrchr(page, '/');
    const char *folder = slash != NULL ? part_of(page, (size_t)(slash - page)) : "";
    while (begins_with(target, "../")) {
        const char *up = strrchr(folder, '/');
        folder = up != NULL ? part_of(folder, (size_t)(up - folder)) : "";
        target += 3;
    }
    return *folder != '\0' ? format("%s/%s", folder, target) : target;
}

/* Writes the line; a link that leads nowhere becomes its text, and a picture that is
 * not there goes. */
static void
write_line(FILE *out, const handout *h, const char *page, const char *line)
{
    const char *bracket;
    while ((bracket = strchr(line, '[')) != NULL) {
        size_t text = strcspn(bracket, "]");
        const char *target =
            strncmp(bracket + text, "](", 2) == 0 ? bracket + text + 2 : "";
        size_t length = strcspn(target, ")");
        bool picture = bracket > line && bracket[-1] == '!';
        if (target[length] == '\0') { /* no link */
            fprintf(out, "%.*s", (int)(bracket + 1 - line), line);
            line = bracket + 1;
            continue;
        }
        const char *path = target_path(page, part_of(target, strcspn(target, ")# ")));
        bool there = memchr(target, ':', length) != NULL || *target == '#' ||
                     tree_find(&h->tree, path) != NULL;
        fprintf(out, "%.*s", (int)(bracket - line) - (picture && !there), line);
        if (there)
            fprintf(out, "%.*s", (int)(target + length + 1 - bracket), bracket);
        else if (!picture)
            fprintf(out, "%.*s", (int)text - 1, bracket + 1);
        line = target + length + 1;
    }
    fprintf(out, "%s\n", line);
}

static char *
rewritten_page(const handout *h, const char *page, const char *bytes)
{
    char *result;
    size_t size;
    FILE *out = open_memstream(&result, &size);
    if (out == NULL)
        give_up("memory");
    bool skipping = false; /* in a quote that gives way */
    for (const char *line = bytes; *line != '\0'; line += strcspn(line, "\n") + 1) {
        const char *text = part_of(line, strcspn(line, "\n"));
        const char *instead = instead_of_quote(h, text);
        if (skipping) {
            skipping = strcmp(text, "```") != 0;
        } else if (instead != NULL) {
            fprintf(out, "%s\n", instead);
            skipping = true;
        } else {
            write_line(out, h, page, text);
        }
        if (line[strcspn(line, "\n")] == '\0')
            break;
    }
    if (fclose(out) != 0)
        give_up("memory");
    char *kept = part_of(result, size);
    free(result);
    return kept;
}

/* The pages of the sections that are asked, with their pictures. */
static void
write_section_pages(handout *h)
{
    const char *last = "";
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED || strcmp(last, e->folder) == 0)
            continue;
        last = e->folder;
        const char *page = format("%s/README.md", e->folder);
        tree_copy_all(&h->tree, h->project.root, format("%s/figures/*.svg", e->folder),
                      "", "");
        tree_copy(&h->tree, h->project.root, page, page);
        tree_file *f = tree_find(&h->tree, page);
        if (f != NULL)
            tree_put(&h->tree, page, rewritten_page(h, page, f->bytes));
    }
}

void
handout_weave(handout *h)
{
    const char *folder = format("%s/woven", h->scratch);
    const char *said = format("%s/weave.txt", h->scratch);
    const char *const weave[] = {h->weave, NULL};
    tree_write(&h->tree, folder);
    if (run_program(folder, said, weave) != 0)
        refuse("weave cannot fill the quotes of the pages:\n%s",
               file_bytes(said, NULL));
    for (size_t i = 0; i < h->tree.files; i++) {
        const char *path = h->tree.file[i].path;
        if (ends_with(path, "README.md"))
            tree_put(&h->tree, path, file_bytes(format("%s/%s", folder, path), NULL));
    }
}

/* ---- README.md, assignment.ini, assignment.mk. ---- */

/* "order 1, comparisons 1" */
static const char *
list_of_properties(const handout *h, const exercise *e)
{
    const char *rest = exercise_key(&h->project, e, "points"), *word, *list = "";
    while ((word = next_word(&rest)) != NULL)
        list = format("%s%s%s", list, *list != '\0' ? ", " : "",
                      replace_all(word, ":", " "));
    return list;
}

/* "`sweep`, with `attach`": the functions that are checked, and what has been taken out
 * with them, in case they need it. */
static const char *
list_of_functions(const handout *h, const exercise *e)
{
    const char *list = "", *name;
    const char *source = file_bytes(format("%s/%s", h->project.root, e->path), NULL);
    const char *rest = functions_of(source, e);
    while ((name = next_word(&rest)) != NULL) {
        bool checked = has_word(e->functions, name, strlen(name));
        list = format("%s%s`%s`", list,
                      *list == '\0' ? "" : checked ? ", " : ", with ", name);
    }
    return list;
}

static const char *
list_of_exercises(const handout *h)
{
    const char *list = "| | | to be written | points | stars | hours | needs |\n"
                       "|---|---|---|---|---|---|---|\n";
    int sum = 0;
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED)
            continue;
        int points = exercise_points(&h->project, e);
        bool bonus = strcmp(exercise_key(&h->project, e, "bonus"), "yes") == 0;
        sum += bonus ? 0 : points;
        list = format("%s| **%s** | %s | %s | %d%s: %s | %s | %s | %s |\n", list, e->id,
                      exercise_key(&h->project, e, "title"), list_of_functions(h, e),
                      points, bonus ? " (bonus)" : "", list_of_properties(h, e),
                      exercise_key(&h->project, e, "stars"),
                      exercise_key(&h->project, e, "hours"),
                      exercise_key(&h->project, e, "needs"));
    }
    return format("%s\n%d points in all. One star is easy, four are hard.", list, sum);
}

/* What opaque mode means, if it comes up. */
static const char *
opaque_text(const handout *h)
{
    const char *list = "";
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role == ROLE_ASKED && strcmp(exercise_program(h, e), "opaque") == 0)
            list = format("%s%s%s", list, *list != '\0' ? ", " : "", e->id);
    }
    return *list == '\0' ? ""
                         : format("In %s the predicates (`orient2d`, `incircle`, ...) "
                                  "are answered by the checker, which also counts "
                                  "them. Then the\n"
                                  "coordinates of the points say nothing: ask, do "
                                  "not compute.\n\n",
                                  list);
}

static const char *
first_asked(const handout *h)
{
    size_t i = 0;
    while (h->project.exercise[i].role != ROLE_ASKED)
        i++;
    return h->project.exercise[i].id;
}

static const char *
list_of_files(const handout *h)
{
    const char *rest = handout_listed(h), *word, *list = "";
    while ((word = next_word(&rest)) != NULL)
        if (ends_with(word, ".c"))
            list = format("%s- [%s](%s)\n", list, word, word);
    return part_of(list, strlen(list) - 1);
}

static const char *
list_of_pages(const handout *h)
{
    const char *list = "", *last = "";
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        const char *page = format("%s/README.md", e->folder);
        if (e->role != ROLE_ASKED || strcmp(last, e->folder) == 0 ||
            tree_find(&h->tree, page) == NULL)
            continue;
        last = e->folder;
        list =
            format("%s%s[%s](%s)", list, *list != '\0' ? ", " : "", e->section, page);
    }
    return *list == '\0'
               ? ""
               : format("The pages\nof the sections (%s) have the ideas, the proofs "
                        "and the pictures. Where they speak of other sections,\nof "
                        "tests, of `build/tri` or of `make` with the number of a "
                        "section, they mean the tree from which yours was taken.",
                        list);
}

static const char *
title_of(const handout *h)
{
    const char *title = ini_value(&h->project.assignments, h->name, "title");
    const exercise *e = project_find(&h->project, h->name);
    if (*title != '\0')
        return format("%s: %s", h->name, title);
    if (e != NULL)
        return format("Exercise %s: %s", h->name,
                      exercise_key(&h->project, e, "title"));
    return format("The exercises of section %s", h->name);
}

static const char *
variant_text(const handout *h)
{
    if (*h->variant == '\0')
        return "";
    const char *asked = "",
               *text = ini_value(&h->project.assignments, h->variant, "text");
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (is_asked_in_variant(h, e))
            asked = format("%s%s%s", asked, *asked != '\0' ? ", " : "", e->id);
    }
    if (*text == '\0')
        refuse("docs/assignments.ini has no variant %s", h->variant);
    if (*asked == '\0')
        refuse("no exercise of %s is asked in the variant %s", h->name, h->variant);
    return format(
        "## This is a variant\n\nIn %s: %s\n\nWhere the pages and the contracts "
        "say something else, this paragraph is right.\n\n",
        asked, text);
}

static const char *
answers_text(const handout *h)
{
    return *h->student == '\0' ? ""
                               : "\n`answers.txt` asks for first steps of the "
                                 "algorithms, by hand, on seven points of "
                                 "your own. Fill it in; it is handed in\nwith the rest "
                                 "and is worth a fifth of all points.\n";
}

static void
write_readme(handout *h)
{
    tree_copy(&h->tree, h->project.root, "tools/handout/student/README.md",
              "README.md");
    const char *text = tree_find(&h->tree, "README.md")->bytes;
    text = replace_all(text, "@TITLE@", title_of(h));
    text = replace_all(text, "@EXERCISES@", list_of_exercises(h));
    text = replace_all(text, "@FILES@", list_of_files(h));
    text = replace_all(text, "@PAGES@", list_of_pages(h));
    text = replace_all(text, "@FIRST@", first_asked(h));
    text = replace_all(text, "@VARIANT@", variant_text(h));
    text = replace_all(text, "@OPAQUE@", opaque_text(h));
    text = replace_all(text, "@ANSWERS@", answers_text(h));
    tree_put(&h->tree, "README.md", text);
}

/* What the grader and the student's make need to know of the exercises. The names of
 * the reference's helpers are no business of theirs. */
static void
write_assignment(handout *h)
{
    const char *text =
        format("# What is asked. Written with the tree; do not edit.\n\n"
               "[assignment]\nname = %s\nvariant = %s\nstudent = %s\nfiles = %s\n",
               h->name, h->variant, h->student, handout_listed(h));
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED)
            continue;
        text = format("%s\n[%s]\n", text, e->id);
        for (size_t k = 0; k < h->project.keys.entries; k++) {
            const ini_entry *entry = &h->project.keys.entry[k];
            if (strcmp(entry->section, e->id) == 0 &&
                strcmp(entry->key, "helpers") != 0 &&
                strcmp(entry->key, "overlap") != 0)
                text = format("%s%s = %s\n", text, entry->key, entry->value);
        }
    }
    tree_put(&h->tree, "assignment.ini", text);
}

static void
write_make(handout *h)
{
    const char *checked = "", *programs = "", *checkers = "", *which = "";
    const char *missing = handout_unchecked(h);
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED || has_word(missing, e->section, strlen(e->section)))
            continue;
        const char *program = format("$(BUILD)/%s/program_%s", exercise_program(h, e),
                                     e->section);
        const char *checker = format("$(BUILD)/checker_%s", e->section);
        checked = format("%s %s", checked, e->id);
        which = format("%sPROGRAM_%s = %s\n", which, e->id, program);
        if (!has_word(programs, program, strlen(program)))
            programs = format("%s %s", programs, program);
        if (!has_word(checkers, checker, strlen(checker)))
            checkers = format("%s %s", checkers, checker);
    }
    tree_put(&h->tree, "assignment.mk",
             format("# What is asked, for make. Written with the tree; do not edit.\n"
                    "EXERCISES =%s\nFILES = %s\nVARIANT = %s\nPROGRAMS =%s\n"
                    "CHECKERS =%s\n%s",
                    checked, handout_listed(h), h->variant, programs, checkers, which));
}

void
handout_write_pages(handout *h)
{
    write_section_pages(h);
    write_readme(h);
    write_assignment(h);
    write_make(h);
    tree_sort(&h->tree);
}
