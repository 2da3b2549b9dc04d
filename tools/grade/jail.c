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
 * `--layers` prints a line for each layer, on or off; its status is 0 if seccomp is
 * on. */
#define _GNU_SOURCE
#include "tools/grade/jail.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

const layer layers[LAYERS] = {
    {LAYER_USER, "user"}, {LAYER_LANDLOCK, "landlock"}, {LAYER_LIMITS, "limits"},
    {LAYER_SECCOMP, "seccomp"},
};

_Noreturn void
fault(const char *what)
{
    if (errno != 0)
        fprintf(stderr, "jail: %s: %s\n", what, strerror(errno));
    else
        fprintf(stderr, "jail: %s\n", what);
    exit(FAULT);
}

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
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 ||
        value > 100000) {
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
    ending e = jail_run(&j);
    if (j.report != NULL)
        report(j.report, &e);
    return end_alike(&e);
}
