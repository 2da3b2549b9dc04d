/* common.c - messages, arguments and files of all commands. */
#include "tools/tri/tri.h"

#include <assert.h>
#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Unfinished files are removed, whatever ends the program. ---- */

enum { MOST_FILES = 8 }; /* written at the same time */

static const char *unfinished[MOST_FILES]; /* changes only while signals wait */

static void
remove_unfinished(void)
{
    for (int i = 0; i < MOST_FILES; i++)
        if (unfinished[i] != NULL)
            unlink(unfinished[i]);
}

/* The signal, raised again and no longer caught, ends the program as it would have. */
static void
interrupted(int signal_number)
{
    remove_unfinished();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

/* The signals by which people and systems end a program. */
static const int stopping[] = {SIGINT, SIGTERM, SIGHUP};
enum { STOPPING = sizeof stopping / sizeof stopping[0] };

/* Makes them wait (SIG_BLOCK) or come (SIG_UNBLOCK). */
static void
hold_signals(int how)
{
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < STOPPING; i++)
        sigaddset(&set, stopping[i]);
    sigprocmask(how, &set, NULL);
}

/* From now on the signals that are not ignored (nohup) remove what is unfinished. */
static void
catch_signals(void)
{
    struct sigaction catching = {.sa_handler = interrupted};
    sigemptyset(&catching.sa_mask);
    for (int i = 0; i < STOPPING; i++) {
        struct sigaction before;
        sigaction(stopping[i], NULL, &before);
        if (before.sa_handler != SIG_IGN)
            sigaction(stopping[i], &catching, NULL);
    }
}

/* In the list of unfinished files, `to` takes the place of `from`; NULL is none. */
static void
change_unfinished(const char *from, const char *to)
{
    int i = 0;
    while (i < MOST_FILES - 1 && unfinished[i] != from)
        i++;
    assert(unfinished[i] == from);
    unfinished[i] = to;
}

/* ---- Ending with a message. ---- */

_Noreturn void
die(const char *sentence, ...)
{
    va_list arguments;
    va_start(arguments, sentence);
    vfprintf(stderr, sentence, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    remove_unfinished();
    exit(EXIT_UNUSABLE);
}

_Noreturn void
die_usage(const char *name, const char *sentence, ...)
{
    va_list arguments;
    va_start(arguments, sentence);
    fprintf(stderr, "tri %s: ", name);
    vfprintf(stderr, sentence, arguments);
    va_end(arguments);
    for (const command *c = commands; c->name != NULL; c++)
        if (strcmp(c->name, name) == 0)
            fprintf(stderr, "\nusage: tri %s %s", c->name, c->usage);
    fprintf(stderr, "\n`tri help %s` tells more\n", name);
    exit(EXIT_UNUSABLE);
}

void
must(tri_status status)
{
    if (status != TRI_OK)
        die("tri: %s", tri_status_text(status));
}

/* ---- Arguments. ---- */

static void
remove_words(int *argc, char **argv, int at, int count)
{
    for (int i = at; i + count < *argc; i++)
        argv[i] = argv[i + count];
    *argc -= count;
}

const char *
take_option(int *argc, char **argv, const char *name)
{
    const char *value = NULL;
    for (int i = 1; i < *argc;) {
        if (strcmp(argv[i], name) != 0) {
            i++;
            continue;
        }
        if (i + 1 == *argc)
            die_usage(argv[0], "%s needs a value after it", name);
        if (value != NULL)
            die_usage(argv[0], "%s is given twice", name);
        value = argv[i + 1];
        remove_words(argc, argv, i, 2);
    }
    return value;
}

bool
take_flag(int *argc, char **argv, const char *name)
{
    bool found = false;
    for (int i = 1; i < *argc;) {
        if (strcmp(argv[i], name) == 0) {
            found = true;
            remove_words(argc, argv, i, 1);
        } else {
            i++;
        }
    }
    return found;
}

void
expect_words(int argc, char **argv, int least, int most)
{
    for (int i = 1; i < argc; i++)
        if (argv[i][0] == '-' && argv[i][1] != '\0')
            die_usage(argv[0], "there is no option %s", argv[i]);
    if (argc - 1 < least)
        die_usage(argv[0], "something is missing");
    if (argc - 1 > most)
        die_usage(argv[0], "%s is one word too many", argv[most + 1]);
}

/* ---- Progress. ---- */

/* Who looks at a terminal wants to be told after about a quarter of a second. */
enum { MANY_POINTS = 250000, MANY_BYTES = 20000000 };

static bool told; /* is somebody told how far the run is? */

void
tell_progress(const char *sentence, ...)
{
    if (!told)
        return;
    va_list arguments;
    va_start(arguments, sentence);
    fputs("tri: ", stderr);
    vfprintf(stderr, sentence, arguments);
    fputc('\n', stderr);
    va_end(arguments);
}

/* ---- Files. ---- */

_Noreturn static void
die_of_file(const char *path, const text_error *error)
{
    const char *name = strcmp(path, "-") == 0 ? "<stdin>" : path;
    if (error->line == 0)
        die("%s: %s", name, error->text);
    die("%s:%lu: %s", name, error->line, error->text);
}

text_points
load_points(const char *path)
{
    text_points points;
    text_error error;
    struct stat about;
    bool terminal = isatty(STDERR_FILENO) == 1;
    told = terminal && stat(path, &about) == 0 && about.st_size >= MANY_BYTES;
    tell_progress("reading %s", path);
    if (text_read_points(path, &points, &error) != TRI_OK)
        die_of_file(path, &error);
    told = terminal && points.count >= MANY_POINTS;
    tell_progress("%lu points have been read", (unsigned long)points.count);
    return points;
}

triangle_list
load_triangles(const char *path, const text_points *points)
{
    triangle_list list;
    text_error error;
    if (text_read_triangles(path, points, &list, &error) != TRI_OK)
        die_of_file(path, &error);
    return list;
}

void
check_output(const char *path)
{
    struct stat about;
    if (path == NULL || strncmp(path, "/dev/", 5) == 0)
        return;
    if (stat(path, &about) != 0)
        return;
    if (S_ISDIR(about.st_mode))
        die("%s: cannot be written: it is a folder; name a file in it", path);
    if (!S_ISREG(about.st_mode))
        die("%s: cannot be written: it is no file; redirect -o - to it", path);
}

_Noreturn static void
die_of_output(const char *path, tri_status status)
{
    if (status != TRI_CANNOT_WRITE || errno == 0)
        die("%s: %s", path, tri_status_text(status));
    die("%s: cannot be written: %s", path, strerror(errno));
}

output
begin_output(const char *path)
{
    output o;
    tell_progress("writing %s", path);
    catch_signals();
    hold_signals(SIG_BLOCK);
    errno = 0;
    tri_status status = output_begin(&o, path);
    if (status != TRI_OK)
        die_of_output(path, status);
    change_unfinished(NULL, o.beside);
    hold_signals(SIG_UNBLOCK);
    return o;
}

void
flush_output(const output *o, const char *path)
{
    errno = 0;
    if (fflush(o->file) != 0 || ferror(o->file))
        die_of_output(path, TRI_CANNOT_WRITE);
}

void
finish_output(output *o, const char *path)
{
    hold_signals(SIG_BLOCK);
    change_unfinished(o->beside, NULL); /* output_commit frees the name */
    tri_status status = output_commit(o);
    hold_signals(SIG_UNBLOCK);
    if (status != TRI_OK)
        die_of_output(strcmp(path, "-") == 0 ? "<stdout>" : path, status);
}

void
note_copies(uint32_t points, uint32_t locations)
{
    if (points > locations)
        fprintf(stderr, "tri: %lu of %lu points repeat the location of an "
                "earlier one and are left out\n",
                (unsigned long)(points - locations), (unsigned long)points);
}

void
note_degenerate(uint32_t points, uint32_t locations, uint32_t triangles)
{
    note_copies(points, locations);
    if (triangles > 0)
        return;
    if (locations < 3)
        fprintf(stderr, "tri: no triangles: fewer than 3 locations\n");
    else
        fprintf(stderr, "tri: no triangles: all points lie on one line\n");
}

uint64_t
parse_whole(const char *name, const char *what, const char *text, uint64_t most)
{
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    bool whole = text[0] >= '0' && text[0] <= '9' && *end == '\0';
    if (!whole || errno != 0 || value > most)
        die_usage(name, "%s %s: a whole number from 0 to %llu is needed",
                  what, text, (unsigned long long)most);
    return value;
}
