/* tree.c - the files of a handout, before they are files. */
#include "tools/handout/tree.h"

#include "tools/handout/basics.h"
#include "tools/handout/ustar.h"

#include <errno.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

tree_file *
tree_find(const tree *t, const char *path)
{
    for (size_t i = 0; i < t->files; i++)
        if (strcmp(t->file[i].path, path) == 0)
            return &t->file[i];
    return NULL;
}

void
tree_put(tree *t, const char *path, const char *text)
{
    tree_file *f = tree_find(t, path);
    if (f == NULL) {
        t->file = take_one_more(t->file, t->files, sizeof *t->file);
        f = &t->file[t->files++];
    }
    *f = (tree_file){path, text, strlen(text), ends_with(path, ".sh")};
}

bool
tree_copy(tree *t, const char *root, const char *from, const char *to)
{
    size_t size;
    if (tree_find(t, to) != NULL)
        return true;
    char *bytes = file_bytes(format("%s/%s", root, from), &size);
    if (bytes == NULL)
        return false;
    tree_put(t, to, bytes);
    tree_find(t, to)->size = size;
    return true;
}

void
tree_copy_all(tree *t, const char *root, const char *pattern, const char *from,
              const char *to)
{
    glob_t found;
    int result = glob(format("%s/%s", root, pattern), 0, NULL, &found);
    if (result == GLOB_NOMATCH)
        return;
    if (result != 0)
        give_up(pattern);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *path = format("%s", found.gl_pathv[i] + strlen(root) + 1);
        struct stat s;
        if (stat(found.gl_pathv[i], &s) == 0 && S_ISREG(s.st_mode))
            tree_copy(t, root, path, format("%s%s", to, path + strlen(from)));
    }
    globfree(&found);
}

static int
by_path(const void *left, const void *right)
{
    const tree_file *a = left, *b = right;
    return strcmp(a->path, b->path);
}

void
tree_sort(tree *t)
{
    if (t->files > 0)
        qsort(t->file, t->files, sizeof *t->file, by_path);
}

/* Makes the folders on the way to the file. */
static void
make_folders(const char *path)
{
    for (const char *slash = strchr(path + 1, '/'); slash;
         slash = strchr(slash + 1, '/')) {
        const char *folder = part_of(path, (size_t)(slash - path));
        if (mkdir(folder, 0777) != 0 && errno != EEXIST)
            give_up(folder);
    }
}

void
tree_write(const tree *t, const char *folder)
{
    for (size_t i = 0; i < t->files; i++) {
        const tree_file *f = &t->file[i];
        const char *path = format("%s/%s", folder, f->path);
        make_folders(path);
        FILE *file = fopen(path, "wb");
        if (file == NULL || fwrite(f->bytes, 1, f->size, file) != f->size ||
            fclose(file) != 0)
            give_up(path);
        if (f->program && chmod(path, 0755) != 0)
            give_up(path);
    }
}

void
tree_archive(const tree *t, const char *folder, const char *path)
{
    const char *plain = part_of(path, strlen(path) - strlen(".gz"));
    FILE *archive = fopen(plain, "wb");
    if (archive == NULL)
        give_up(plain);
    for (size_t i = 0; i < t->files; i++)
        if (!ustar_add(archive, format("%s/%s", folder, t->file[i].path),
                       t->file[i].bytes, t->file[i].size, t->file[i].program))
            give_up(plain);
    if (!ustar_end(archive) || fclose(archive) != 0)
        give_up(plain);
    const char *const gzip[] = {"gzip", "-n", "-9", "-f", plain, NULL};
    if (run_program(".", "/dev/null", gzip) != 0)
        refuse("gzip cannot pack %s", plain);
}
