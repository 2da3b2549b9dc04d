/* submissions.c - which submissions there are, and what their names are. */
#include "tools/grade/submissions.h"

#include "tools/handout/basics.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool
is_folder(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

/* "anna" of "class/anna.tar.gz" and of "class/anna/". */
static const char *
name_of(const char *path)
{
    size_t length = strlen(path);
    while (length > 1 && path[length - 1] == '/')
        length--;
    const char *name = part_of(path, length);
    if (strcmp(name, ".") == 0)
        name = current_folder();
    if (strrchr(name, '/') != NULL && strrchr(name, '/')[1] != '\0')
        name = strrchr(name, '/') + 1;
    size_t ending = archive_ending(name);
    if (ending > 0 && strlen(name) > ending)
        return part_of(name, strlen(name) - ending);
    return name;
}

static void
add_submission(class *c, const char *name, const char *path)
{
    for (size_t i = 0; i < c->count; i++)
        if (strcmp(c->at[i].name, name) == 0) {
            if (path == NULL)
                return;
            refuse("two submissions have the name %s: %s and %s", name, c->at[i].path,
                   path);
        }
    if (strchr(name, '/') != NULL || name[0] == '.')
        refuse("%s: a submission cannot have this name", name);
    c->at = take_one_more(c->at, c->count, sizeof *c->at);
    c->at[c->count++] = (submission){.name = name, .path = path};
}

/* A folder with a file of the assignment, or an archive and nothing else, is one
 * submission; any other holds one in each entry, unless --one says that it does not. */
static bool
is_class(const assignment *a, bool one, const char *path)
{
    DIR *d;
    int entries = 0, archives = 0, folders = 0;
    if (one || !is_folder(path) || (d = opendir(path)) == NULL)
        return false;
    bool own = access(format("%s/assignment.ini", path), F_OK) == 0 ||
               has_listed_file(a, path);
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        if (e->d_name[0] == '.')
            continue;
        entries++;
        folders += is_folder(format("%s/%s", path, e->d_name));
        archives += archive_ending(e->d_name) > 0;
    }
    closedir(d);
    return !own && entries > 0 && archives + folders > 0 &&
           !(entries == 1 && archives == 1);
}

static int
by_name(const void *a, const void *b)
{
    return strcmp(((const submission *)a)->name, ((const submission *)b)->name);
}

/* The first column of the roster, without its quotes. */
static void
add_roster(class *c, const char *path)
{
    const char *line = file_bytes(path, NULL);
    if (line == NULL)
        refuse("%s: there is no such file", path);
    while (*line != '\0') {
        size_t length = strcspn(line, ",;\t\r\n"), all = strcspn(line, "\n");
        bool quoted = length > 1 && line[0] == '"' && line[length - 1] == '"';
        if (length > 0)
            add_submission(c, part_of(line + quoted, length - 2 * (size_t)quoted),
                           NULL);
        line += all + (line[all] == '\n');
    }
}

class
find_submissions(const assignment *a, char **paths, bool one, const char *roster,
                 const char *output)
{
    class c = {NULL, 0};
    bool alone = paths[0] != NULL && paths[1] == NULL && !is_class(a, one, paths[0]);
    for (char **path = paths; *path != NULL; path++) {
        DIR *d = is_class(a, one, *path) ? opendir(*path) : NULL;
        if (d == NULL && access(*path, F_OK) != 0)
            refuse("%s: %s", *path, strerror(errno));
        if (d == NULL)
            add_submission(&c, name_of(*path), from_root(*path));
        for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;)
            if (e->d_name[0] != '.')
                add_submission(&c, name_of(e->d_name),
                               from_root(format("%s/%s", *path, e->d_name)));
        if (d != NULL)
            closedir(d);
    }
    if (roster != NULL)
        add_roster(&c, roster);
    qsort(c.at, c.count, sizeof *c.at, by_name);
    for (size_t i = 0; i < c.count; i++)
        c.at[i].output =
            alone && roster == NULL ? output : format("%s/%s", output, c.at[i].name);
    return c;
}
