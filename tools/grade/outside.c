/* outside.c - the process that waits for the end of the one in the jail. */
#define _GNU_SOURCE
#include "tools/grade/jail.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

int
load_binary(const char *path)
{
    const unsigned may_execute = 0x10; /* MFD_EXEC, from Linux 6.3 */
    int from = open(path, O_RDONLY | O_CLOEXEC);
    if (from < 0)
        fault(path);
    int to = memfd_create("program", MFD_CLOEXEC | MFD_ALLOW_SEALING | may_execute);
    if (to < 0)
        to = memfd_create("program", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (to < 0)
        fault("memfd_create");
    static char bytes[1 << 16];
    ssize_t n;
    while ((n = read(from, bytes, sizeof bytes)) > 0)
        if (write(to, bytes, (size_t)n) != n)
            fault("copying the program");
    if (n < 0 || fcntl(to, F_ADD_SEALS, F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW |
                       F_SEAL_WRITE) != 0)
        fault(path);
    close(from);
    return to;
}

static long
milliseconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (long)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

/* The signals that the jail waits for: its child has ended, or people and programs
 * want the jail to end. */
static sigset_t
awaited(void)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGHUP);
    return set;
}

/* Waits for the end of the child, at most until its time is over. */
static void
supervise(pid_t child, double most, ending *e)
{
    const sigset_t set = awaited();
    long began = milliseconds(), end = began + (long)(1000 * most);
    while (wait4(child, &e->status, WNOHANG, &e->used) == 0) {
        long left = end - milliseconds();
        e->late = left <= 0;
        struct timespec t = {left / 1000, left % 1000 * 1000000};
        int s = e->late ? 0 : sigtimedwait(&set, NULL, &t);
        e->stopped = s > 0 && s != SIGCHLD ? s : 0;
        if (e->late || e->stopped != 0) {
            kill(-child, SIGKILL);
            kill(child, SIGKILL);
            wait4(child, &e->status, 0, &e->used);
            break;
        }
    }
    kill(-child, SIGKILL); /* what a compiler has started and left */
    e->wall_ms = milliseconds() - began;
}

static long
cpu_ms(const struct rusage *used)
{
    return (long)(used->ru_utime.tv_sec + used->ru_stime.tv_sec) * 1000 +
        (used->ru_utime.tv_usec + used->ru_stime.tv_usec) / 1000;
}

ending
jail_run(const jail *j)
{
    ending e = {0};
    int tell[2];
    const sigset_t set = awaited();
    pid_t self = getpid();
    sigprocmask(SIG_BLOCK, &set, NULL);
    if (pipe2(tell, O_CLOEXEC) != 0)
        fault("pipe");
    pid_t child = fork();
    if (child < 0)
        fault("fork");
    if (child == 0)
        jail_inside(j, self, tell[1]);
    close(tell[1]);
    if (!j->compile) { /* or the checker would wait for the end of what it reads */
        close(3);
        close(4);
    }
    message m;
    while (read(tell[0], &m, sizeof m) == sizeof m)
        e.said = m, e.said_anything = true;
    supervise(child, j->wall_seconds, &e);
    /* The second limit of time kills without a word. */
    bool killed = WIFSIGNALED(e.status) && WTERMSIG(e.status) == SIGKILL;
    if (killed && cpu_ms(&e.used) >= 1000L * (long)j->most.cpu_seconds)
        e.late = true;
    if (WIFSIGNALED(e.status) && WTERMSIG(e.status) == SIGXCPU)
        e.late = true;
    return e;
}

static bool
is_fault(const ending *e)
{
    return e->said.what[0] != '\0' || !e->said_anything;
}

void
report(const char *path, const ending *e)
{
    FILE *file = fopen(path, "a");
    if (file == NULL)
        fault(path);
    if (is_fault(e))
        fprintf(file, "fault %s: %s", e->said.what, strerror(e->said.error));
    else if (e->late)
        fprintf(file, "time");
    else if (WIFSIGNALED(e->status))
        fprintf(file, "signal %d", WTERMSIG(e->status));
    else
        fprintf(file, "exit %d", WEXITSTATUS(e->status));
    fprintf(file, "\t%ld\t%ld\t%ld\t", cpu_ms(&e->used), e->wall_ms, e->used.ru_maxrss);
    for (size_t i = 0; i < LAYERS; i++)
        if (e->said.layers & layers[i].bit)
            fprintf(file, " %s", layers[i].name);
    putc('\n', file);
    if (fclose(file) != 0)
        fault(path);
}

int
end_alike(const ending *e)
{
    sigset_t none;
    sigemptyset(&none);
    int by = e->stopped != 0 ? e->stopped : e->late ? SIGXCPU
        : WIFSIGNALED(e->status) ? WTERMSIG(e->status) : 0;
    if (is_fault(e)) {
        errno = e->said.error;
        fault(e->said.what);
    }
    if (by == 0)
        return WEXITSTATUS(e->status);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    signal(by, SIG_DFL);
    sigprocmask(SIG_SETMASK, &none, NULL);
    raise(by);
    return FAULT;
}
