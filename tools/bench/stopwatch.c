/* stopwatch.c - the clocks of POSIX, and what Linux says of the memory. */
#include "tools/bench/stopwatch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

/* Systems tell apart what is a program's own and what is theirs by looking a
 * few hundred times a second: a shorter time is not divided. */
static const double LEAST_SPLIT = 0.15;

static double
seconds_of(struct timeval t)
{
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* What Linux says of this process in the line that begins with `name`, in
 * bytes; -1 where there is no such file. (getrusage tells the peak in units
 * that differ between systems.) */
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

/* The most memory from now on is no longer that of what was before; false where
 * this cannot be asked for. */
static bool
forget_most_memory(void)
{
    FILE *file = fopen("/proc/self/clear_refs", "w");
    if (file == NULL)
        return false;
    bool written = fputs("5", file) >= 0;
    return fclose(file) == 0 && written;
}

static times
now(void)
{
    struct rusage used;
    struct timespec wall;
    times t = {.bytes = -1};
    if (getrusage(RUSAGE_SELF, &used) != 0 ||
        clock_gettime(CLOCK_MONOTONIC, &wall) != 0) {
        perror("bench: clock");
        exit(2);
    }
    t.user = seconds_of(used.ru_utime);
    t.processor = t.user + seconds_of(used.ru_stime);
    t.wall = (double)wall.tv_sec + 1e-9 * (double)wall.tv_nsec;
    return t;
}

stopwatch
stopwatch_start(double least, size_t most)
{
    stopwatch w = {.least = least, .most = most};
    double held = forget_most_memory() ? memory_said("VmRSS:") : -1;
    w.start = now();
    w.start.bytes = held;
    return w;
}

bool
stopwatch_again(stopwatch *w)
{
    w->rounds++;
    return w->rounds < w->most &&
           now().processor - w->start.processor < w->least;
}

times
stopwatch_stop(const stopwatch *w)
{
    times t = now();
    double rounds = (double)w->rounds;
    t.user -= w->start.user;
    t.processor -= w->start.processor;
    if (t.processor < LEAST_SPLIT)
        t.user = t.processor;
    t.user /= rounds;
    t.processor /= rounds;
    t.wall = (t.wall - w->start.wall) / rounds;
    t.bytes = w->start.bytes < 0 ? -1 : memory_said("VmHWM:") - w->start.bytes;
    return t;
}

double
stopwatch_least(size_t n)
{
    return n < 50000 ? 0.03 : 0.2;
}

size_t
stopwatch_copies(size_t n)
{
    return 1 + (size_t)(stopwatch_least(n) / 20e-9) / (n + 1);
}
