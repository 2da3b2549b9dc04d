/* jail.c - runs a program of a stranger so that it can harm nobody.
 *
 *     jail run [OPTIONS] -- BINARY [ARGUMENT...]
 *     jail compile [OPTIONS] [-r PATH]... -w FOLDER -- COMMAND [ARGUMENT...]
 *     jail --layers
 *
 * `run` is for a student's program, linked statically. It keeps descriptors 1 to 4 (3
 * and 4 are the checker's questions and answers) and nothing else: it cannot open,
 * create or execute a file, see another process, or make another system call than
 * those in filter.c. `compile` is for a compiler, linker or unpacker: it can read the
 * system's programs, libraries and headers and each PATH, and write below FOLDER. (That
 * some other file exists it can find out, but not what is in it.)
 *
 * The jail ends as the program did: with its exit status, or by its signal; by SIGXCPU
 * when its time was over; with status 125 when the jail itself could not be made.
 *
 *     --report FILE      adds a line: exit N, signal N, time, or fault SENTENCE; then
 *                        the milliseconds of computing and of waiting, the kilobytes
 *                        of memory, and the layers that were on; separated by tabs
 *     --cpu N, --wall N  seconds of computing (10, compile: 30), of waiting (60)
 *     --memory N         megabytes of address space (512, compile: 2048)
 *     --file N           compile: megabytes that a file may have (64)
 *     --require-sandbox  no run without seccomp, no compilation that could read what
 *                        it should not (without Landlock and not as root)
 *     --without LAYER    leaves a layer out, to see what the others hold
 *
 * `--layers` prints a line for each layer, on or off; its status is 0 if seccomp is on.
 */
#define _GNU_SOURCE
#include <stdio.h>

#ifndef __linux__

int
main(void)
{
    fputs("jail: needs Linux; grade on Linux, or in a container or virtual machine\n",
          stderr);
    return 125;
}

#else

#include "tools/grade/confine.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { FAULT = 125, MOST_OPENINGS = 40 };

typedef struct jail {
    bool compile; /* compile, not run */
    const char *report;
    double wall_seconds;
    limits most;
    bool required;
    int layers;                  /* that are wanted */
    opening open[MOST_OPENINGS]; /* for compile */
    size_t openings;
    const char *output;          /* for compile: the folder to write to */
    char **command;
    int binary;                  /* for run: the program, in memory */
} jail;

_Noreturn static void
fault(const char *what)
{
    if (errno != 0)
        fprintf(stderr, "jail: %s: %s\n", what, strerror(errno));
    else
        fprintf(stderr, "jail: %s\n", what);
    exit(FAULT);
}

static const struct {
    int bit;
    const char *name;
} layers[] = {
    {LAYER_USER, "user"}, {LAYER_LANDLOCK, "landlock"}, {LAYER_LIMITS, "limits"},
    {LAYER_SECCOMP, "seccomp"},
};
enum { LAYERS = sizeof layers / sizeof layers[0] };

/* ---- What was asked for. ---- */

/* What compilers need of a system; those that are elsewhere are named by -r. Of /etc
 * only what the linker reads, so that no name of a person is there to include. */
static const opening of_the_system[] = {
    {"/usr", false}, {"/bin", false}, {"/lib", false}, {"/lib64", false},
    {"/lib32", false}, {"/etc/alternatives", false}, {"/etc/ld.so.cache", false},
    {"/dev/null", true},
};

static void
allow(jail *j, const char *path, bool write)
{
    errno = 0;
    if (j->openings == MOST_OPENINGS)
        fault("too many -r");
    j->open[j->openings++] = (opening){path, write};
}

/* Seconds, perhaps with a fraction. */
static double
seconds(const char *text)
{
    char *end;
    double value = strtod(text, &end);
    errno = 0;
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || !(value <= 100000))
        fault("a number of seconds is needed after an option");
    return value;
}

static int
bit_of_layer(const char *name)
{
    errno = 0;
    for (size_t i = 0; i < LAYERS; i++)
        if (strcmp(name, layers[i].name) == 0)
            return layers[i].bit;
    fault("the layers are user, landlock, limits and seccomp");
}

static unsigned
whole(const char *text)
{
    char *end;
    errno = 0;
    unsigned long value = strtoul(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || value > 100000) {
        errno = 0;
        fault("a whole number from 0 to 100000 is needed after an option");
    }
    return (unsigned)value;
}

/* The option at argv[0] and its value; how many words these are. */
static int
read_option(jail *j, char **argv)
{
    const char *name = argv[0], *value = argv[1];
    if (strcmp(name, "--require-sandbox") == 0) {
        j->required = true;
        return 1;
    }
    errno = 0;
    if (value == NULL)
        fault("an option without a value; the command stands after --");
    if (strcmp(name, "--report") == 0)
        j->report = value;
    else if (strcmp(name, "--cpu") == 0)
        j->most.cpu_seconds = whole(value);
    else if (strcmp(name, "--wall") == 0)
        j->wall_seconds = seconds(value);
    else if (strcmp(name, "--memory") == 0)
        j->most.megabytes = whole(value);
    else if (strcmp(name, "--without") == 0)
        j->layers &= ~bit_of_layer(value);
    else if (j->compile && strcmp(name, "--file") == 0)
        j->most.file_megabytes = whole(value);
    else if (j->compile && strcmp(name, "-r") == 0)
        allow(j, value, false);
    else if (j->compile && strcmp(name, "-w") == 0)
        allow(j, j->output = value, true);
    else
        fault("there is no such option; the head of tools/grade/jail.c lists them");
    return 2;
}

static jail
read_arguments(char **argv)
{
    jail j = {.wall_seconds = 60, .layers = ~0, .binary = -1};
    j.compile = strcmp(argv[1], "compile") == 0;
    if (j.compile) {
        j.most = (limits){.cpu_seconds = 30, .megabytes = 2048, .file_megabytes = 64,
                          .files = 256};
        for (size_t i = 0; i < sizeof of_the_system / sizeof of_the_system[0]; i++)
            allow(&j, of_the_system[i].path, of_the_system[i].write);
    } else {
        j.most = (limits){.cpu_seconds = 10, .megabytes = 512, .files = 5,
                          .alone = true};
    }
    argv += 2;
    while (*argv != NULL && strcmp(*argv, "--") != 0)
        argv += read_option(&j, argv);
    errno = 0;
    if (*argv == NULL || argv[1] == NULL)
        fault("no command; it stands after --");
    if (j.compile && j.output == NULL)
        fault("no folder to write to; name it by -w");
    j.command = argv + 1;
    return j;
}

/* ---- Inside: what the process does before it is the program. ---- */

enum { BINARY = 5, TELL = 6 }; /* descriptors, closed when the program begins */

/* What the process has to say to the jail outside, until it is the program. */
typedef struct message {
    int layers;    /* that are on */
    int error;     /* errno, if it could not become the program */
    char what[60]; /* and at what it failed */
} message;

_Noreturn static void
tell_fault(message m, const char *what)
{
    m.error = errno;
    snprintf(m.what, sizeof m.what, "%s", what);
    if (write(TELL, &m, sizeof m) != sizeof m)
        _exit(FAULT);
    _exit(FAULT);
}

/* Descriptors 0 to 4 that nobody has given lead nowhere, so that no file of the jail's
 * gets one of these numbers. */
static void
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
_Noreturn static void
inside(const jail *j, pid_t outside, int tell)
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

/* ---- Outside. ---- */

/* The binary in memory, sealed: what is run is what was read, and no path leads to it. */
static int
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

typedef struct ending {
    int status;         /* of wait */
    bool late;          /* its time was over */
    int stopped;        /* a signal that the jail got */
    struct rusage used;
    long wall_ms;
    bool said_anything; /* before it was the program */
    message said;       /* and the last of it */
} ending;

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

static ending
run(const jail *j)
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
        inside(j, self, tell[1]);
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
    if (killed && cpu_ms(&e.used) >= 1000L * j->most.cpu_seconds)
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

static void
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

/* Ends the jail as the program ended. */
static int
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

/* ---- Which layers are there? A child puts them on, and says what it has got. ---- */

static int
print_layers(void)
{
    int tell[2], on = 0;
    if (pipe(tell) != 0)
        fault("pipe");
    pid_t child = fork();
    if (child == 0) {
        on |= confine_user() ? LAYER_USER : 0;
        confine_privileges();
        on |= confine_landlock(NULL, 0) ? LAYER_LANDLOCK : 0;
        on |= confine_limits((limits){10, 512, 0, 64, true}) ? LAYER_LIMITS : 0;
        on |= confine_seccomp(BINARY, getpid()) ? LAYER_SECCOMP : 0;
        bool told = write(tell[1], &on, sizeof on) == sizeof on;
        _exit(told ? 0 : FAULT);
    }
    close(tell[1]);
    if (child < 0 || read(tell[0], &on, sizeof on) != sizeof on)
        fault("no layer could be tried");
    waitpid(child, NULL, 0);
    for (size_t i = 0; i < LAYERS; i++) {
        printf("%-9s %s", layers[i].name, on & layers[i].bit ? "on" : "off");
        if (layers[i].bit == LAYER_LANDLOCK && landlock_version() > 0)
            printf(" (version %d)", landlock_version());
        if (layers[i].bit == LAYER_USER && geteuid() != 0)
            printf(" (not root: programs run as you)");
        putchar('\n');
    }
    return on & LAYER_SECCOMP ? 0 : 1;
}

int
main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--layers") == 0)
        return print_layers();
    if (argc < 3 || (strcmp(argv[1], "run") != 0 && strcmp(argv[1], "compile") != 0)) {
        fputs("usage: jail run [OPTIONS] -- BINARY [ARGUMENT...]\n"
              "       jail compile [OPTIONS] [-r PATH]... -w FOLDER -- COMMAND "
              "[ARGUMENT...]\n"
              "       jail --layers\n", stderr);
        return FAULT;
    }
    jail j = read_arguments(argv);
    fill_descriptors();
    if (!j.compile)
        j.binary = load_binary(j.command[0]);
    else if (geteuid() == 0 && chown(j.output, JAIL_USER, JAIL_USER) != 0)
        fault(j.output);
    ending e = run(&j);
    if (j.report != NULL)
        report(j.report, &e);
    return end_alike(&e);
}

#endif
