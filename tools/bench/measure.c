/* measure.c - a run is a child process; what it has seen comes back through a
 * pipe. */
#include "tools/bench/measure.h"

#include "lib/memory.h"
#include "tools/bench/yardstick.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- What the child does. ---- */

/* A sort needs a new copy of the points for each round; all are made before the
 * clock starts. */
static run
sort_here(const point2 *points, uint32_t n)
{
    run r = {.end = RUN_FAILED};
    size_t most = stopwatch_copies(n), round = 0;
    point2 *copy = memory_array(most * n, sizeof *copy);
    if (copy == NULL) {
        fprintf(stderr, "bench: %s\n", tri_status_text(TRI_OUT_OF_MEMORY));
        return r;
    }
    for (size_t i = 0; i < most; i++)
        memcpy(copy + i * n, points, n * sizeof *copy);
    stopwatch w = stopwatch_start(stopwatch_least(n), most);
    do {
        yardstick_sort(copy + round++ * n, n);
    } while (stopwatch_again(&w));
    r.times = stopwatch_stop(&w);
    r.answer = certify_sorted(copy, n);
    r.end = RUN_DONE;
    return r;
}

/* The mesh of a round is freed in the next one: the last one is there to be
 * certified. */
static run
triangulate_here(const algorithm *a, const tri_options *options,
                 const point2 *points, uint32_t n, bool certify)
{
    run r = {.end = RUN_FAILED, .answer = {.right = true}};
    mesh m = {0};
    tri_status status;
    stopwatch w = stopwatch_start(stopwatch_least(n), SIZE_MAX);
    do {
        mesh_free(&m);
        status = a->triangulate(points, n, options, &m);
    } while (status == TRI_OK && stopwatch_again(&w));
    if (status == TRI_OK) {
        r.times = stopwatch_stop(&w);
        r.end = RUN_DONE;
        triangle_list list;
        if (certify && (status = mesh_triangles(&m, &list)) == TRI_OK)
            r.answer = certify_triangles(points, n, list, a->delaunay);
    }
    if (status != TRI_OK)
        fprintf(stderr, "bench: %s: %s\n", a->name, tri_status_text(status));
    return r;
}

/* ---- Processes. ---- */

_Noreturn static void
give_up(const char *what)
{
    fprintf(stderr, "bench: %s: %s\n", what, strerror(errno));
    exit(2);
}

/* The child gets a limit on its processor time, and one on the wall for those
 * that wait for something. What it writes into *to_parent can be read from the
 * result. */
static int
begin_child(pid_t *child, unsigned seconds, int *to_parent)
{
    int ends[2];
    fflush(NULL); /* or both would write what is in the buffers */
    if (pipe(ends) != 0)
        give_up("pipe");
    *child = fork();
    if (*child < 0)
        give_up("fork");
    if (*child == 0) {
        struct rlimit limit = {seconds,
                               seconds + 1}; /* the signal, then the end */
        setrlimit(RLIMIT_CPU, &limit);
        alarm(10 * seconds);
        close(ends[0]);
        *to_parent = ends[1];
        return -1;
    }
    close(ends[1]);
    return ends[0];
}

/* How has the child ended? */
static run_end
end_of(pid_t child)
{
    int status;
    while (waitpid(child, &status, 0) != child)
        if (errno != EINTR)
            give_up("waitpid");
    if (WIFSIGNALED(status) &&
        (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGALRM))
        return RUN_TOO_LONG;
    if (WIFSIGNALED(status))
        fprintf(stderr, "bench: stopped by signal %d\n", WTERMSIG(status));
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? RUN_DONE
                                                         : RUN_FAILED;
}

/* All that the child writes, up to `room` bytes. */
static size_t
read_all(int from, char *bytes, size_t room)
{
    size_t size = 0;
    ssize_t more;
    while (size < room && (more = read(from, bytes + size, room - size)) != 0) {
        if (more > 0)
            size += (size_t)more;
        else if (errno != EINTR)
            give_up("read");
    }
    close(from);
    return size;
}

run
measure(const algorithm *a, const tri_options *options, const point2 *points,
        uint32_t n, unsigned seconds, bool certify)
{
    run r;
    pid_t child;
    int to_parent;
    int from = begin_child(&child, seconds, &to_parent);
    if (from < 0) {
        r = a == NULL ? sort_here(points, n)
                      : triangulate_here(a, options, points, n, certify);
        _exit(write(to_parent, &r, sizeof r) == sizeof r ? 0 : 2);
    }
    bool heard = read_all(from, (char *)&r, sizeof r) == sizeof r;
    run_end end = end_of(child);
    return heard && end == RUN_DONE ? r : (run){.end = heard ? r.end : end};
}

/* Reads `user processor wall bytes right text`, the line of a peer. */
static bool
read_line(const char *line, run *r)
{
    int right, length = 0;
    int found = sscanf(line, "%lf %lf %lf %lf %d %n", &r->times.user,
                       &r->times.processor, &r->times.wall, &r->times.bytes,
                       &right, &length);
    if (found != 5 || length == 0 || line[strlen(line) - 1] != '\n')
        return false;
    r->answer.right = right != 0;
    snprintf(r->answer.text, sizeof r->answer.text, "%.*s",
             (int)strcspn(line + length, "\n"), line + length);
    return r->times.user >= 0 && r->times.wall > 0;
}

run
measure_peer(const char *program, const char *points, unsigned seconds,
             bool certify)
{
    char line[400];
    pid_t child;
    int to_parent;
    int from = begin_child(&child, seconds, &to_parent);
    if (from < 0) {
        if (dup2(to_parent, STDOUT_FILENO) >= 0)
            execl(program, program, points, certify ? "certify" : (char *)NULL,
                  (char *)NULL);
        _exit(2);
    }
    line[read_all(from, line, sizeof line - 1)] = '\0';
    run r = {.end = end_of(child)};
    if (r.end != RUN_DONE || read_line(line, &r))
        return r;
    fprintf(stderr, "bench: %s has not said what it has done\n", program);
    return (run){.end = RUN_FAILED};
}

static times
times_of_children(void)
{
    struct rusage used;
    struct timespec wall;
    if (getrusage(RUSAGE_CHILDREN, &used) != 0 ||
        clock_gettime(CLOCK_MONOTONIC, &wall) != 0)
        give_up("clock");
    times t = {.bytes = -1};
    t.user = (double)used.ru_utime.tv_sec +
             1e-6 * (double)used.ru_utime.tv_usec;
    t.processor = t.user + (double)used.ru_stime.tv_sec +
                  1e-6 * (double)used.ru_stime.tv_usec;
    t.wall = (double)wall.tv_sec + 1e-9 * (double)wall.tv_nsec;
    return t;
}

run
measure_program(const char *const *arguments, const char *said,
                unsigned seconds)
{
    char ignored[1];
    pid_t child;
    int to_parent;
    times before = times_of_children();
    int from = begin_child(&child, seconds, &to_parent);
    if (from < 0) {
        int file = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        close(to_parent);
        if (file >= 0 && dup2(file, STDOUT_FILENO) >= 0 &&
            dup2(file, STDERR_FILENO) >= 0)
            execvp(arguments[0], (char *const *)(uintptr_t)arguments);
        _exit(2);
    }
    read_all(from, ignored, sizeof ignored);
    run r = {.end = end_of(child), .times = times_of_children()};
    r.times.user -= before.user;
    r.times.processor -= before.processor;
    r.times.wall -= before.wall;
    return r;
}
