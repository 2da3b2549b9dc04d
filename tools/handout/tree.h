/* tree.h - the files of a handout, before they are files.
 */
#ifndef TOOLS_HANDOUT_TREE_H
#define TOOLS_HANDOUT_TREE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct tree_file {
    const char *path; /* from the root of the tree */
    const char *bytes;
    size_t size;
    bool program;     /* may be run: a script */
} tree_file;

typedef struct tree {
    tree_file *file;
    size_t files;
} tree;

/* The file at this path; NULL if there is none. */
tree_file *tree_find(const tree *t, const char *path);

/* A text at this path, instead of what is there. */
void tree_put(tree *t, const char *path, const char *text);

/* The project's file, if there is one and the tree has none there yet. Returns whether
 * the tree has one now. */
bool tree_copy(tree *t, const char *root, const char *from, const char *to);

/* The same for all files that match the pattern; `from` at the beginning of their
 * paths becomes `to`. */
void tree_copy_all(tree *t, const char *root, const char *pattern, const char *from,
                   const char *to);

/* Writes the files into a folder, which is made. */
void tree_write(const tree *t, const char *folder);

/* Writes them into an archive, DIR.tar.gz, in a folder of that name. */
void tree_archive(const tree *t, const char *folder, const char *path);

/* Sorts the files by their paths. */
void tree_sort(tree *t);

#endif
