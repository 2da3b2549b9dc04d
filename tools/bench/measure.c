/* measure.c - one run of an algorithm, in a process of its own. */
#include "tools/bench/measure.h"

#include "lib/memory.h"
#include "tools/bench/yardstick.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Processor time of this process. */
static double
processor_seconds(void)
{
    struct timespec t;
    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) != 0) {
        perror("bench: clock_gettime");
        exit(2);
    }
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* What Linux says of this process in the line that begins with `name`, in bytes;
 * -1 where there is no such file. (getrusage tells the peak in units that differ
 * between systems.) */
static double
memory_said(const char *name)
{
    double kilobytes = -1;
    char line[256];
    FILE *file = fopen("/proc/self/status", "r");
    if (file == NULL)
        return -1;
    while (fgets(line, sizeof line, file) != NULL)
        if (strncmp(line, name, strlen(name)) == 0)
            kilobytes = strtod(line + strlen(name), NULL);
    fclose(file);
    return kilobytes < 0 ? -1 : 1024 * kilobytes;
}

/* A yardstick that does not sort would measure nothing. */
static bool
is_sorted(const point2 *p, uint32_t n)
{
    for (uint32_t i = 1; i < n; i++)
        if (p[i].x < p[i - 1].x || (p[i].x == p[i - 1].x && p[i].y < p[i - 1].y))
            return false;
    return true;
}

/* Some clocks of processor time tick every hundredth of a second: short work is
 * done again until it has taken LEAST_SECONDS. Sorting needs a new copy each time, and
 * all are made before the clock starts; there are COPIED_POINTS to sort. */
static const double LEAST_SECONDS = 0.3;
enum { COPIED_POINTS = 4000000 };

/* What the child does. */
static run
run_here(const algorithm *a, const point2 *points, uint32_t n)
{
    run r = {.end = RUN_FAILED};
    mesh m = {0};
    size_t rounds = 0, most = 1 + COPIED_POINTS / n;
    point2 *copy = memory_array(most * n, sizeof *copy);
    if (copy == NULL) {
        fprintf(stderr, "bench: %s\n", tri_status_text(TRI_OUT_OF_MEMORY));
        return r;
    }
    for (size_t i = 0; i < most; i++)
        memcpy(copy + i * n, points, n * sizeof *copy);

    double held = memory_said("VmRSS:");
    double start = processor_seconds(), passed;
    do {
        tri_status status = TRI_OK;
        if (a == NULL)
            yardstick_sort(copy + rounds * n, n);
        else
            status = a->triangulate(copy + rounds * n, n, NULL, &m);
        mesh_free(&m);
        if (status != TRI_OK) {
            fprintf(stderr, "bench: %s: %s\n", a->name, tri_status_text(status));
            return r;
        }
        rounds++;
        passed = processor_seconds() - start;
    } while (rounds < most && passed < LEAST_SECONDS);
    if (a == NULL && !is_sorted(copy, n)) {
        fprintf(stderr, "bench: the yardstick does not sort\n");
        return r;
    }
    r.end = RUN_DONE;
    r.seconds = passed / (double)rounds;
    r.bytes = held < 0 ? -1 : memory_said("VmHWM:") - held;
    return r;
}

_Noreturn static void
give_up(const char *what)
{
    fprintf(stderr, "bench: %s: %s\n", what, strerror(errno));
    exit(2);
}

/* Why did the child end, from which nothing was heard? */
static run_end
silent_end(pid_t child)
{
    int status;
    if (waitpid(child, &status, 0) != child)
        give_up("waitpid");
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return RUN_TOO_LONG;
    if (WIFSIGNALED(status))
        fprintf(stderr, "bench: stopped by signal %d\n", WTERMSIG(status));
    return RUN_FAILED;
}

run
measure(const algorithm *a, const point2 *points, uint32_t n, unsigned seconds)
{
    int ends[2];
    run r = {.end = RUN_FAILED};
    if (pipe(ends) != 0)
        give_up("pipe");
    pid_t child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0) {
        struct rlimit limit = {seconds, seconds + 1}; /* the signal, then the end */
        setrlimit(RLIMIT_CPU, &limit);
        r = run_here(a, points, n);
        _exit(write(ends[1], &r, sizeof r) == sizeof r ? 0 : 2);
    }
    close(ends[1]);
    bool heard = read(ends[0], &r, sizeof r) == sizeof r;
    close(ends[0]);
    run_end end = silent_end(child);
    if (!heard)
        r.end = end;
    return r;
}
