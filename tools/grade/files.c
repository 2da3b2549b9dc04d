/* files.c - the files of a submission: only those that the assignment lists, only if
 * they are files, and only so large. */
#include "tools/grade/grade.h"

#include "tools/grade/clean.h"
#include "tools/handout/basics.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_OF_A_FILE = 1 << 20, MOST_OF_AN_ARCHIVE = 1 << 25, MOST_ENTRIES = 2000 };

/* ---- Reading one file, without following a link on the way. ---- */

/* What is read ends with a NUL. NULL: *trouble says why, or is NULL when there is no
 * such file. */
static char *
read_descriptor(int d, size_t most, size_t *size, const char **trouble)
{
    struct stat about;
    char *bytes = NULL;
    *size = 0;
    if (fstat(d, &about) != 0 || !S_ISREG(about.st_mode)) {
        *trouble = "it is not a file";
    } else if ((size_t)about.st_size > most) {
        *trouble = "it is too large";
    } else {
        ssize_t got;
        bytes = take(most + 1);
        while (*size < most && (got = read(d, bytes + *size, most - *size)) > 0)
            *size += (size_t)got;
    }
    close(d);
    return bytes;
}

/* Opens folder/path, part by part: none of the parts may be a link. */
static int
open_below(int folder, const char *path, const char **trouble)
{
    const int safely = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    int at = dup(folder);
    while (at >= 0) {
        size_t length = strcspn(path, "/");
        bool last = path[length] == '\0';
        int next =
            openat(at, part_of(path, length), last ? safely : safely | O_DIRECTORY);
        int error = errno;
        close(at);
        if (next < 0 && error != ENOENT)
            *trouble = error == ELOOP || error == ENOTDIR
                ? "it is a link, or a folder above it is one" : strerror(error);
        if (last)
            return next;
        path += length + 1;
        at = next;
    }
    return at;
}

char *
read_below(const char *folder, const char *path, size_t most, size_t *size,
           const char **trouble)
{
    *trouble = NULL;
    int top = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (top < 0)
        return NULL;
    int d = open_below(top, path, trouble);
    close(top);
    return d < 0 ? NULL : read_descriptor(d, most, size, trouble);
}

/* ---- What a submission consists of. ---- */

static bool
is_folder(const char *path)
{
    struct stat about;
    return lstat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

/* Has the folder one of the listed files, with or without its folders? */
bool
has_listed_file(const assignment *a, const char *folder)
{
    for (size_t f = 0; f < a->files; f++) {
        const char *name = strrchr(a->file[f], '/');
        if (access(format("%s/%s", folder, a->file[f]), F_OK) == 0 ||
            (name != NULL && access(format("%s%s", folder, name), F_OK) == 0))
            return true;
    }
    return false;
}

/* The only archive in the folder, or else its only entry, if that is a folder; NULL if
 * there are none or several. (What a Mac adds to a zip does not count.) */
static const char *
only_entry(const char *folder, bool packed)
{
    const char *found = NULL;
    int entries = 0;
    DIR *d = opendir(folder);
    for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        const char *path = format("%s/%s", folder, e->d_name);
        if (e->d_name[0] == '.' || strcmp(e->d_name, "__MACOSX") == 0 ||
            (packed && archive_ending(e->d_name) == 0))
            continue;
        entries++;
        found = packed || is_folder(path) ? path : NULL;
    }
    if (d != NULL)
        closedir(d);
    return entries == 1 ? found : NULL;
}

/* The archive at `path`. A tar that gzip has compressed is unpacked first. */
static archive
open_archive(const grading *g, const char *path, const char *scratch,
             const char **trouble)
{
    size_t size;
    const char *slash = strrchr(path, '/');
    const char *folder =
        slash != NULL ? part_of(path, (size_t)(slash - path) + 1) : ".";
    char *bytes = read_below(folder, slash != NULL ? slash + 1 : path,
                             MOST_OF_AN_ARCHIVE, &size, trouble);
    if (bytes == NULL && *trouble == NULL)
        *trouble = "it is not there";
    if (bytes != NULL && size > 2 && memcmp(bytes, "\x1F\x8B", 2) == 0)
        bytes = unpack(g, scratch, bytes, size, MOST_OF_AN_ARCHIVE, &size, trouble);
    archive a = bytes != NULL ? archive_read(bytes, size) : (archive){0};
    if (*trouble == NULL)
        *trouble = a.trouble;
    return a;
}

/* The folder in which the files are: the submission, or the only folder in it. */
static const char *
top_folder(const assignment *a, const char *path)
{
    for (int depth = 0; depth < 3; depth++) {
        const char *below = only_entry(path, false);
        const char *first = part_of(a->file[0], strcspn(a->file[0], "/"));
        if (below == NULL || is_folder(format("%s/%s", path, first)))
            return path;
        path = below;
    }
    return path;
}

/* ---- What is not listed: said, and not used. ---- */

/* By its path, or by its name without a folder. */
static bool
is_listed(const assignment *a, const char *path)
{
    for (size_t i = 0; i < a->files; i++) {
        const char *name = strrchr(a->file[i], '/');
        if (strcmp(a->file[i], path) == 0 ||
            (name != NULL && strcmp(name + 1, path) == 0))
            return true;
    }
    return false;
}

static bool
is_source(const char *name)
{
    size_t length = strlen(name);
    return length > 2 && name[length - 2] == '.' &&
           strchr("chCH", name[length - 1]) != NULL;
}

static bool
is_in_the_tree(const grading *g, const char *path)
{
    return access(format("%s/%s", g->base, path), F_OK) == 0;
}

typedef struct strangers {
    const char **path;
    size_t count;
    int entries; /* that have been looked at */
} strangers;

static void
add_stranger(strangers *s, const char *path)
{
    s->path = take_one_more(s->path, s->count, sizeof *s->path);
    s->path[s->count++] = clean(path, strlen(path), 300);
}

/* Finds sources below folder/path that neither the assignment lists nor the tree has.
 * The length of a name bounds the depth. */
static void
find_strangers(const grading *g, const char *folder, const char *path, strangers *s)
{
    DIR *d = opendir(format("%s/%s", folder, path));
    for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        const char *name = *path != '\0' ? format("%s/%s", path, e->d_name)
                                         : format("%s", e->d_name);
        if (e->d_name[0] == '.' || strcmp(name, "build") == 0 || strlen(name) > 300)
            continue;
        if (++s->entries > MOST_ENTRIES)
            break;
        if (is_folder(format("%s/%s", folder, name)))
            find_strangers(g, folder, name, s);
        else if (is_source(name) && !is_listed(&g->asked, name) &&
                 !is_in_the_tree(g, name))
            add_stranger(s, name);
    }
    if (d != NULL)
        closedir(d);
}

/* The same in an archive, where the tree may be below some folder. Of what leads
 * elsewhere all is named. */
static void
find_packed_strangers(const grading *g, const archive *a, strangers *s)
{
    for (size_t i = 0; i < a->files; i++) {
        const char *name = a->file[i].name;
        bool known = a->file[i].used || !is_source(name);
        for (const char *part = name;
             part != NULL && !known && !leads_elsewhere(name);) {
            known = is_in_the_tree(g, part) && !is_listed(&g->asked, part);
            part = strchr(part, '/');
            part += part != NULL;
        }
        if (leads_elsewhere(name) || !known)
            add_stranger(s, name);
    }
}

static int
by_letters(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* One sentence about the first few. */
static const char *
tell_strangers(strangers s)
{
    const char *list = "";
    if (s.count == 0)
        return "";
    qsort(s.path, s.count, sizeof *s.path, by_letters);
    for (size_t i = 0; i < s.count && i < 5; i++)
        list = format("%s%s%s", list, i > 0 ? ", " : "", s.path[i]);
    return format("In the submission, but not used: %s%s.\n", list,
                  s.count > 5 ? format(" and %zu more", s.count - 5) : "");
}

/* ---- All of it. ---- */

typedef struct submitted {
    const char *folder; /* or NULL: then it is the archive */
    archive packed;
    const char *scratch;
} submitted;

static char *
copy_of(const char *bytes, size_t size)
{
    char *copy = take(size + 1);
    memcpy(copy, bytes, size);
    return copy;
}

static char *
read_packed(const grading *g, const submitted *s, const char *path, size_t *size,
            const char **trouble)
{
    packed_file *f = archive_find(&s->packed, path, trouble);
    if (f == NULL)
        return NULL;
    f->used = true;
    *size = f->size;
    if (f->size > MOST_OF_A_FILE || (f->deflated && f->whole > MOST_OF_A_FILE))
        *trouble = "it is too large";
    else if (!f->deflated)
        return copy_of(f->bytes, f->size);
    else
        return unpack_deflated(g, s->scratch, f, MOST_OF_A_FILE, size, trouble);
    return NULL;
}

static char *
read_as(const grading *g, const submitted *s, const char *path, size_t *size,
        const char **trouble)
{
    return s->folder != NULL
               ? read_below(s->folder, path, MOST_OF_A_FILE, size, trouble)
               : read_packed(g, s, path, size, trouble);
}

/* Files may come without their folders: where one uploads them one by one. */
static char *
read_listed(const grading *g, const submitted *s, const char *path, size_t *size,
            const char **trouble)
{
    const char *name = strrchr(path, '/');
    *trouble = NULL;
    char *bytes = read_as(g, s, path, size, trouble);
    if (bytes == NULL && *trouble == NULL && name != NULL)
        bytes = read_as(g, s, name + 1, size, trouble);
    return bytes;
}

static submitted
open_submission(const grading *g, const char *path, const char *scratch,
                const char **trouble)
{
    submitted s = {.scratch = scratch,
                   .folder = is_folder(path) ? top_folder(&g->asked, path) : NULL};
    const char *packed = s.folder == NULL ? path
        : has_listed_file(&g->asked, s.folder) ? NULL : only_entry(s.folder, true);
    *trouble = NULL;
    if (packed != NULL) {
        s.folder = NULL;
        s.packed = open_archive(g, packed, scratch, trouble);
    }
    return s;
}

listed
files_collect(const grading *g, const char *path, const char *to)
{
    const assignment *a = &g->asked;
    listed l = {take(a->files * sizeof *l.trouble), ""};
    const char *trouble, *scratch = format("%s.scratch", to);
    strangers others = {0};
    make_folder(scratch);
    submitted s = open_submission(g, path, scratch, &trouble);
    if (trouble != NULL)
        l.notes = format("The submission cannot be read: %s.\n", trouble);
    for (size_t i = 0; i < a->files; i++) {
        size_t size = 0;
        char *bytes = trouble != NULL
                          ? NULL
                          : read_listed(g, &s, a->file[i], &size, &l.trouble[i]);
        if (l.trouble[i] != NULL)
            l.trouble[i] = clean(l.trouble[i], strlen(l.trouble[i]), 300);
        else if (bytes == NULL)
            l.trouble[i] = trouble != NULL ? trouble : "it was not handed in";
        if (bytes == NULL)
            bytes = file_bytes(format("%s/%s", g->base, a->file[i]), &size);
        write_file(format("%s/%s", to, a->file[i]), bytes, size);
    }
    if (s.folder != NULL)
        find_strangers(g, s.folder, "", &others);
    else
        find_packed_strangers(g, &s.packed, &others);
    l.notes = format("%s%s", l.notes, tell_strangers(others));
    return l;
}
