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

enum { MOST_OF_A_FILE = 1 << 20, MOST_OF_AN_ARCHIVE = 1 << 23, MOST_ENTRIES = 2000 };

/* ---- Reading one file, without following a link on the way. ---- */

/* What is read ends with a NUL. NULL: *trouble says why, or is NULL when there is no such
 * file. */
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
        int next = openat(at, part_of(path, length), last ? safely : safely | O_DIRECTORY);
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

static char *
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

static bool
is_archive_name(const char *name)
{
    return ends_with(name, ".tar") || ends_with(name, ".tar.gz") || ends_with(name, ".tgz");
}

/* The only entry of the folder that is_wanted likes; NULL if there are none or several. */
static const char *
only_entry(const char *folder, bool archive)
{
    const char *found = NULL;
    int entries = 0;
    DIR *d = opendir(folder);
    for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        const char *path = format("%s/%s", folder, e->d_name);
        if (e->d_name[0] == '.' || (archive && !is_archive_name(e->d_name)))
            continue;
        entries++;
        found = archive || is_folder(path) ? path : NULL;
    }
    if (d != NULL)
        closedir(d);
    return entries == 1 ? found : NULL;
}

/* Archives are unpacked in the jail, into memory, and not further than that. */
static char *
read_archive(const grading *g, const char *path, const char *scratch, size_t *size,
             const char **trouble)
{
    const char *slash = strrchr(path, '/');
    const char *folder = slash != NULL ? part_of(path, (size_t)(slash - path) + 1) : ".";
    char *bytes = read_below(folder, slash != NULL ? slash + 1 : path, MOST_OF_AN_ARCHIVE,
                             size, trouble);
    if (bytes == NULL)
        return NULL;
    if (*size > 2 && (unsigned char)bytes[0] == 0x1F && (unsigned char)bytes[1] == 0x8B) {
        const char *packed = format("%s/packed", scratch), *work = format("%s/unpack", scratch);
        write_file(format("%s/a.gz", packed), bytes, *size);
        make_folder(work);
        command_line c = jail_compile(g, (const char *[]){packed, NULL}, work);
        command_add_words(&c, "gzip -dc");
        command_add(&c, format("%s/a.gz", packed));
        if (run(scratch, c.word, 60, MOST_OF_AN_ARCHIVE, &bytes, size) != 0)
            *trouble = "the archive cannot be unpacked: make it again with `make submit`";
    }
    if (*trouble == NULL && !archive_is_one(bytes, *size))
        *trouble = "it is no archive of `make submit`";
    return *trouble == NULL ? bytes : NULL;
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

/* ---- Sources that are not listed: said, and not used. ---- */

/* By its path, or by its name without a folder. */
static bool
is_listed(const assignment *a, const char *path)
{
    for (size_t i = 0; i < a->files; i++) {
        const char *name = strrchr(a->file[i], '/');
        if (strcmp(a->file[i], path) == 0 || (name != NULL && strcmp(name + 1, path) == 0))
            return true;
    }
    return false;
}

typedef struct strangers {
    const char **path;
    size_t count;
    int entries; /* that have been looked at */
} strangers;

/* Finds sources below folder/path that neither the assignment lists nor the tree has.
 * The length of a name bounds the depth. */
static void
find_strangers(const grading *g, const char *folder, const char *path, strangers *s)
{
    DIR *d = opendir(format("%s/%s", folder, path));
    for (struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        const char *name = *path != '\0' ? format("%s/%s", path, e->d_name)
                                         : format("%s", e->d_name);
        bool source = ends_with(name, ".c") || ends_with(name, ".h");
        if (e->d_name[0] == '.' || strcmp(name, "build") == 0 || strlen(name) > 300)
            continue;
        if (++s->entries > MOST_ENTRIES)
            break;
        if (is_folder(format("%s/%s", folder, name))) {
            find_strangers(g, folder, name, s);
        } else if (source && !is_listed(&g->asked, name) &&
                   access(format("%s/%s", g->base, name), F_OK) != 0) {
            s->path = take_one_more(s->path, s->count, sizeof *s->path);
            s->path[s->count++] = clean(name, strlen(name), 300);
        }
    }
    if (d != NULL)
        closedir(d);
}

static int
by_letters(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* One sentence about the first few. */
static const char *
tell_strangers(const grading *g, const char *folder)
{
    strangers s = {0};
    const char *list = "";
    find_strangers(g, folder, "", &s);
    if (s.count == 0)
        return "";
    qsort(s.path, s.count, sizeof *s.path, by_letters);
    for (size_t i = 0; i < s.count && i < 5; i++)
        list = format("%s%s%s", list, i > 0 ? ", " : "", s.path[i]);
    return format("Not among the files to be handed in, and not used: %s%s.\n", list,
                  s.count > 5 ? format(" and %zu more", s.count - 5) : "");
}

/* ---- All of it. ---- */

static char *
copy_of(const char *bytes, size_t size)
{
    char *copy = take(size + 1);
    memcpy(copy, bytes, size);
    return copy;
}

typedef struct source_of_files {
    const char *folder; /* or */
    char *archive;
    size_t archive_size;
} source_of_files;

/* Files may come without their folders: where one uploads them one by one. */
static char *
read_listed(const source_of_files *s, const char *path, size_t *size, const char **trouble)
{
    const char *name = strrchr(path, '/');
    *trouble = NULL;
    if (s->archive != NULL) {
        const char *found = archive_find(s->archive, s->archive_size, path, size, trouble);
        if (found == NULL && *trouble == NULL && name != NULL)
            found = archive_find(s->archive, s->archive_size, name + 1, size, trouble);
        if (found != NULL && *size > MOST_OF_A_FILE)
            *trouble = "it is too large";
        return found != NULL && *trouble == NULL ? copy_of(found, *size) : NULL;
    }
    char *bytes = read_below(s->folder, path, MOST_OF_A_FILE, size, trouble);
    if (bytes == NULL && *trouble == NULL && name != NULL)
        bytes = read_below(s->folder, name + 1, MOST_OF_A_FILE, size, trouble);
    return bytes;
}

static source_of_files
open_submission(const grading *g, const char *path, const char *scratch,
                const char **trouble)
{
    source_of_files s = {.folder = is_folder(path) ? top_folder(&g->asked, path) : NULL};
    const char *archive = s.folder != NULL ? only_entry(s.folder, true) : path;
    bool loose = s.folder != NULL &&
        access(format("%s/%s", s.folder, g->asked.file[0]), F_OK) == 0;
    *trouble = NULL;
    if (archive != NULL && !loose) {
        s.archive = read_archive(g, archive, scratch, &s.archive_size, trouble);
        if (s.archive == NULL && *trouble == NULL)
            *trouble = "it is not there";
    }
    return s;
}

listed
files_collect(const grading *g, const char *path, const char *to)
{
    const assignment *a = &g->asked;
    listed l = {take(a->files * sizeof *l.trouble), ""};
    const char *trouble, *scratch = format("%s.scratch", to);
    make_folder(scratch);
    source_of_files s = open_submission(g, path, scratch, &trouble);
    if (trouble != NULL)
        l.notes = format("The submission cannot be read: %s.\n", trouble);
    for (size_t i = 0; i < a->files; i++) {
        size_t size = 0;
        char *bytes = trouble != NULL ? NULL : read_listed(&s, a->file[i], &size, &l.trouble[i]);
        if (bytes == NULL && l.trouble[i] == NULL)
            l.trouble[i] = trouble != NULL ? trouble : "it was not handed in";
        if (bytes == NULL)
            bytes = file_bytes(format("%s/%s", g->base, a->file[i]), &size);
        write_file(format("%s/%s", to, a->file[i]), bytes, size);
    }
    if (s.folder != NULL)
        l.notes = format("%s%s", l.notes, tell_strangers(g, s.folder));
    return l;
}
