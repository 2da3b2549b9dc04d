/* files.c - which files a handout has, and what is taken out of them. */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"
#include "tools/handout/rewrite.h"

#include <stdlib.h>
#include <string.h>

/* ---- Sections: those that are asked, and what they stand on. ---- */

/* "2.3" of "chapters/2.3_line_sweep/sweep.h"; NULL if it is in no section. */
static const char *
section_of(const char *path)
{
    size_t begin = strlen("chapters/");
    if (!begins_with(path, "chapters/"))
        return NULL;
    size_t length = strspn(path + begin, "0123456789.");
    return length > 0 && path[begin + length] == '_' ? part_of(path + begin, length)
                                                     : NULL;
}

static const char *
next_include(const char **rest)
{
    static const char directive[] = "#include \"";
    const char *at = strstr(*rest, directive);
    if (at == NULL)
        return NULL;
    at += strlen(directive);
    size_t length = strcspn(at, "\"");
    *rest = at + length;
    return part_of(at, length);
}

/* Not in a handout: the program that draws the figures, and whatever solves the same
 * as the exercises, faster. */
static bool
is_left_out(const char *path)
{
    const char *name = strrchr(path, '/');
    return name != NULL &&
           (strcmp(name, "/figures.c") == 0 || begins_with(name, "/fast_"));
}

static void
collect_section(handout *h, const char *section)
{
    const char *folder = section_folder(h, section), *root = h->project.root;
    tree all = {0};
    if (folder == NULL)
        refuse("there is no folder of section %s", section);
    tree_copy_all(&all, root, format("%s/*.h", folder), "", "");
    tree_copy_all(&all, root, format("%s/*.c", folder), "", "");
    for (size_t i = 0; i < all.files; i++)
        if (!is_left_out(all.file[i].path))
            tree_put(&h->tree, all.file[i].path, all.file[i].bytes);
}

/* Is the section none that a handout may have: later than all that are asked, and not
 * the primitives on which the others stand? */
static bool
is_too_late(const handout *h, const char *section)
{
    if (strcmp(section, "3.4") == 0)
        return false;
    for (size_t i = 0; i < h->project.exercises; i++)
        if (h->project.exercise[i].role == ROLE_ASKED &&
            strcmp(h->project.exercise[i].section, section) >= 0)
            return false;
    return true;
}

/* A section comes into the tree when a file includes a header of it. */
static void
collect_included(handout *h)
{
    for (size_t i = 0; i < h->tree.files; i++) {
        const char *rest = h->tree.file[i].bytes, *path = h->tree.file[i].path,
                   *included;
        while ((included = next_include(&rest)) != NULL) {
            const char *section = section_of(included);
            if (section == NULL || tree_find(&h->tree, included) != NULL)
                continue;
            if (is_too_late(h, section))
                refuse("%s includes %s, of a section that comes later", path, included);
            collect_section(h, section);
        }
    }
}

/* ---- Folders of which a tree has what it includes, and what that consists of. ---- */

/* Does the source include headers of this folder, and does the tree have them all? */
static bool
has_all_includes(const tree *t, const char *bytes, const char *folder)
{
    const char *included;
    bool some = false;
    while ((included = next_include(&bytes)) != NULL) {
        if (!begins_with(included, folder))
            continue;
        if (tree_find(t, included) == NULL)
            return false;
        some = true;
    }
    return some;
}

/* A header brings the source of its name with it. A source without a header of its own
 * comes when all its headers have come: it is a further part of one of them. */
static void
collect_included_from(tree *t, const char *root, const char *folder)
{
    tree all = {0};
    size_t before;
    tree_copy_all(&all, root, format("%s*.[ch]", folder), "", "");
    do {
        before = t->files;
        for (size_t i = 0; i < t->files; i++) {
            const char *rest = t->file[i].bytes, *included;
            while ((included = next_include(&rest)) != NULL)
                if (begins_with(included, folder))
                    tree_copy(t, root, included, included);
        }
        for (size_t i = 0; i < all.files; i++) {
            const char *path = all.file[i].path, *bytes = all.file[i].bytes;
            const char *header = format("%.*s.h", (int)strlen(path) - 2, path);
            bool section = strspn(path + strlen(folder), "0123456789.") > 0;
            if (tree_find(&all, header) != NULL ? tree_find(t, header) != NULL
                : !section && has_all_includes(t, bytes, folder))
                tree_copy(t, root, path, path);
        }
    } while (t->files > before);
}

/* ---- The checks. ---- */

/* The instances of 3.4 come with their signs: the program that knows them needs what
 * the project has for its own tests, and stays here. */
static void
collect_signs(handout *h)
{
    const char *path = format("%s/signs", h->scratch);
    const char *const signs[] = {h->signs, "1", NULL};
    if (run_program(".", path, signs) != 0)
        refuse("%s does not run; make it first", h->signs);
    tree_put(&h->tree, "checks/3.4.instances", file_bytes(path, NULL));
}

/* A file of the project's folder tools/, which in the tree is the folder checks/. */
static void
put_check(handout *h, const tree_file *f, const char *folder)
{
    const char *bytes = replace_all(f->bytes, "tools/checks/", "checks/");
    tree_put(&h->tree, format("checks/%s", f->path + strlen(folder)),
             replace_all(bytes, "tools/handout/", "checks/"));
}

static void
collect_checks(handout *h)
{
    const char *root = h->project.root;
    tree checks = {0}, archive = {0};
    tree_copy(&checks, root, "tools/checks/checker.c", "tools/checks/checker.c");
    tree_copy_all(&checks, root, "tools/checks/student/[a-z]*.[ch]", "", "");
    tree_copy_all(&checks, root, "tools/checks/student/opaque/*/*.h", "", "");
    tree_copy_all(&checks, root, "tools/checks/student/opaque/*/*/*.h", "", "");
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        const char *own = format("tools/checks/%s.c", e->section);
        const char *student = format("tools/checks/student/%s.c", e->section);
        if (e->role == ROLE_ASKED) {
            tree_copy(&checks, root, own, own);
            tree_copy(&checks, root, student, student);
        }
    }
    collect_included_from(&checks, root, "tools/checks/");
    for (size_t i = 0; i < checks.files; i++)
        put_check(h, &checks.file[i], "tools/checks/");
    tree_copy_all(&archive, root, "tools/handout/ustar.[ch]", "", "");
    for (size_t i = 0; i < archive.files; i++)
        put_check(h, &archive.file[i], "tools/handout/");
    if (section_is_asked(h, "3.4") && tree_find(&h->tree, "checks/3.4.c") != NULL)
        collect_signs(h);
}

const char *
handout_unchecked(const handout *h)
{
    const char *list = "", *last = "";
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED || strcmp(e->section, last) == 0)
            continue;
        last = e->section;
        if (tree_find(&h->tree, format("checks/%s.c", last)) == NULL ||
            tree_find(&h->tree, format("checks/student/%s.c", last)) == NULL)
            list = format("%s%s%s", list, *list != '\0' ? " " : "", last);
    }
    return list;
}

/* ---- All of them. ---- */

/* The sections that are in the tree; the notes' order is that of their names. */
static const char *
sections_of(const tree *t)
{
    const char *list = "";
    for (size_t i = 0; i < t->files; i++) {
        const char *section = section_of(t->file[i].path);
        if (section != NULL && !has_word(list, section, strlen(section)))
            list = format("%s%s%s", list, *list != '\0' ? " " : "", section);
    }
    return list;
}

void
handout_collect(handout *h)
{
    for (size_t i = 0; i < h->project.exercises; i++)
        if (h->project.exercise[i].role == ROLE_ASKED)
            collect_section(h, h->project.exercise[i].section);
    collect_included(h);
    collect_checks(h);
    collect_included_from(&h->tree, h->project.root, "lib/");
    tree_copy_all(&h->tree, h->project.root, "tools/handout/student/Makefile",
                  "tools/handout/student/", "");
    tree_copy_all(&h->tree, h->project.root, "tools/handout/student/*/*",
                  "tools/handout/student/", "");
    tree_copy(&h->tree, h->project.root, "docs/LICENSE", "docs/LICENSE");
    tree_sort(&h->tree);
    h->sections = sections_of(&h->tree);
    for (size_t i = 0; i < h->project.exercises; i++) {
        exercise *e = &h->project.exercise[i];
        if (!has_word(h->sections, e->section, strlen(e->section)))
            e->role = ROLE_ABSENT;
    }
}

void
handout_take_out(handout *h)
{
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role != ROLE_ASKED && e->role != ROLE_LATER)
            continue;
        const tree_file *f = tree_find(&h->tree, e->path);
        if (f == NULL)
            refuse("%s: there is no %s", e->id, e->path);
        tree_put(&h->tree, e->path, with_todo(without_exercise(f->bytes, e)));
    }
}

void
handout_ask(handout *h)
{
    const char *path = format("%s/answers", h->scratch), *rest = h->sections, *section;
    const char **command = take(20 * sizeof *command);
    size_t words = 0;
    command[words++] = h->traces;
    command[words++] = h->student;
    while ((section = next_word(&rest)) != NULL && words < 19)
        if (section_is_asked(h, section))
            command[words++] = section;
    int status = run_program(".", path, command);
    if (status != 0)
        refuse("%s: there are no questions for %s%s", h->name, h->student,
               status == 1 ? ": no section asked has any" :
               format(": %s", file_bytes(path, NULL)));
    tree_put(&h->tree, "answers.txt", file_bytes(path, NULL));
}

const char *
handout_listed(const handout *h)
{
    const char *list = "";
    for (size_t i = 0; i < h->project.exercises; i++) {
        const exercise *e = &h->project.exercise[i];
        if (e->role == ROLE_ASKED && !has_word(list, e->path, strlen(e->path)))
            list = format("%s%s%s", list, *list != '\0' ? " " : "", e->path);
    }
    return *h->student == '\0' ? list : format("%s answers.txt", list);
}
