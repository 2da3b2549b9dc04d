/* inside.c - what the process in the jail does before it is the program. */
#define _GNU_SOURCE
#include "tools/grade/jail.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

_Noreturn static void
tell_fault(message m, const char *what)
{
    m.error = errno;
    snprintf(m.what, sizeof m.what, "%s", what);
    if (write(TELL, &m, sizeof m) != sizeof m)
        _exit(FAULT);
    _exit(FAULT);
}

void
fill_descriptors(void)
{
    int d;
    do
        d = open("/dev/null", O_RDWR | O_CLOEXEC);
    while (d >= 0 && d < BINARY);
    if (d < 0)
        fault("/dev/null");
    close(d);
}

/* Descriptors from `first` on are closed; an old kernel has no call for it. */
static void
close_from(int first)
{
#ifdef SYS_close_range
    if (syscall(SYS_close_range, (unsigned)first, ~0U, 0) == 0)
        return;
#endif
    for (long d = first, end = sysconf(_SC_OPEN_MAX); d < end; d++)
        close((int)d);
}

/* Nothing to read, what was kept, the binary and the jail's ear. */
static bool
arrange_descriptors(bool compile, int binary, int tell)
{
    int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    int spare_tell = fcntl(tell, F_DUPFD_CLOEXEC, 10);
    int spare_binary = compile ? -1 : fcntl(binary, F_DUPFD_CLOEXEC, 10);
    if (nothing < 0 || spare_tell < 0 || dup2(nothing, 0) < 0 ||
        dup3(spare_tell, TELL, O_CLOEXEC) < 0)
        return false;
    if (!compile)
        return dup3(spare_binary, BINARY, O_CLOEXEC) >= 0;
    close(3);
    close(4);
    close(BINARY);
    return true;
}

/* No signal is blocked or ignored, but for one: output into a file that may not grow
 * is lost, which is no reason to die. */
static void
reset_signals(void)
{
    sigset_t none;
    sigemptyset(&none);
    for (int s = 1; s < 32; s++)
        signal(s, SIG_DFL);
    signal(SIGXFSZ, SIG_IGN);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/* The program ends when the jail does, however that ends. */
static bool
die_with(pid_t outside)
{
    return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == outside;
}

_Noreturn static void
become_compiler(const jail *j, message m)
{
    static char path[] = "PATH=/usr/local/bin:/usr/bin:/bin", locale[] = "LC_ALL=C";
    char folder[4096];
    snprintf(folder, sizeof folder, "TMPDIR=%s", j->output);
    environ = (char *[]){path, locale, folder, NULL};
    if (write(TELL, &m, sizeof m) == sizeof m)
        execvp(j->command[0], j->command);
    tell_fault(m, j->command[0]);
}

_Noreturn static void
become_program(const jail *j, message m)
{
    char *no_environment[] = {NULL};
    if (write(TELL, &m, sizeof m) == sizeof m)
        syscall(SYS_execveat, BINARY, "", j->command, no_environment, AT_EMPTY_PATH);
    tell_fault(m, "it cannot be executed (is it linked statically?)");
}

/* Puts on the layers, from the outermost to the innermost. Landlock needs a further
 * descriptor and so comes before the limits. */
_Noreturn void
jail_inside(const jail *j, pid_t outside, int tell)
{
    message m = {0};
    bool arranged = arrange_descriptors(j->compile, j->binary, tell);
    setsid();
    close_from(TELL + 1);
    reset_signals();
    if ((j->layers & LAYER_USER) && confine_user())
        m.layers |= LAYER_USER;
    if (!arranged || !die_with(outside) || !confine_privileges())
        tell_fault(m, "preparing");
    if ((j->layers & LAYER_LANDLOCK) && confine_landlock(j->open, j->openings))
        m.layers |= LAYER_LANDLOCK;
    if ((j->layers & LAYER_LIMITS) && confine_limits(j->most))
        m.layers |= LAYER_LIMITS;
    if ((j->layers & LAYER_SECCOMP) && !j->compile && confine_seccomp(BINARY, getpid()))
        m.layers |= LAYER_SECCOMP;

    errno = 0;
    int enough = j->compile ? LAYER_USER | LAYER_LANDLOCK : LAYER_SECCOMP;
    if (j->required && (m.layers & enough) == 0)
        tell_fault(m, j->compile ? "the sandbox has neither Landlock nor a user of its "
                   "own" : "the sandbox has no seccomp");
    if (j->compile)
        become_compiler(j, m);
    become_program(j, m);
}
