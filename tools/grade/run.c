/* run.c - running programs, and the files around them. */
#include "tools/grade/grade.h"

#include "tools/handout/basics.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- One program, and what it says. ---- */

static long
milliseconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (long)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

/* In the child: a group of its own, so that all of it can be ended. */
_Noreturn static void
become(const char *folder, const char *const command[], int output)
{
    setpgid(0, 0);
    int nothing = open("/dev/null", O_RDONLY);
    if (nothing < 0 || dup2(nothing, 0) < 0 || dup2(output, 1) < 0 ||
        dup2(output, 2) < 0 || chdir(folder) != 0)
        _exit(127);
    for (int d = 3; d < 64; d++)
        close(d);
    execvp(command[0], (char *const *)command);
    perror(command[0]);
    _exit(127);
}

/* Reads until the other end is closed; false when the time was over before. */
static bool
listen_until(long end, int from, size_t most, char *said, size_t *size)
{
    char lost[4096];
    for (;;) {
        long left = end - milliseconds();
        struct pollfd p = {.fd = from, .events = POLLIN};
        if (left <= 0)
            return false;
        if (poll(&p, 1, left < 1000 ? (int)left : 1000) <= 0)
            continue;
        bool room = *size < most;
        ssize_t got = room ? read(from, said + *size, most - *size)
                           : read(from, lost, sizeof lost);
        if (got == 0 || (got < 0 && errno != EINTR))
            return true;
        if (got > 0 && room)
            *size += (size_t)got;
    }
}

static volatile pid_t running; /* 0: nothing */

void
run_end(void)
{
    if (running != 0)
        kill(-running, SIGKILL);
}

int
run(const char *folder, const char *const command[], unsigned seconds, size_t most,
    char **said, size_t *said_size)
{
    int ends[2], status;
    size_t size = 0;
    char *text = take(most + 1);
    if (pipe(ends) != 0)
        give_up("pipe");
    pid_t child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0)
        become(folder, command, ends[1]);
    setpgid(child, child);
    running = child;
    close(ends[1]);
    bool in_time =
        listen_until(milliseconds() + 1000L * seconds, ends[0], most, text, &size);
    close(ends[0]);
    if (!in_time)
        kill(-child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    kill(-child, SIGKILL); /* what it may have left behind */
    running = 0;
    *said = text;
    if (said_size != NULL)
        *said_size = size;
    if (!in_time)
        return RUN_TOO_LONG;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void
command_add(command_line *c, const char *word)
{
    c->word = take_one_more(c->word, c->words, sizeof *c->word);
    c->word[c->words++] = word;
    c->word = take_one_more(c->word, c->words, sizeof *c->word);
    c->word[c->words] = NULL;
}

void
command_add_words(command_line *c, const char *words)
{
    const char *word;
    while ((word = next_word(&words)) != NULL)
        command_add(c, word);
}

command_line
jail_compile(const grading *g, const char *const reads[], const char *writes)
{
    command_line c = {NULL, 0};
    command_add(&c, format("%s/jail", g->tools));
    command_add_words(&c, "compile --wall 60");
    if (g->required)
        command_add(&c, "--require-sandbox");
    for (; *reads != NULL; reads++) {
        command_add(&c, "-r");
        command_add(&c, *reads);
    }
    command_add(&c, "-w");
    command_add(&c, writes);
    command_add(&c, "--");
    return c;
}

/* ---- Files. ---- */

void
make_folder(const char *path)
{
    for (const char *slash = strchr(path + 1, '/'); slash != NULL;
         slash = strchr(slash + 1, '/'))
        mkdir(part_of(path, (size_t)(slash - path)), 0755);
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        give_up(path);
}

void
remove_folder(const char *path)
{
    const char *const rm[] = {"rm", "-rf", path, NULL};
    char *said;
    run("/", rm, 60, 1000, &said, NULL);
}

void
write_file(const char *path, const char *bytes, size_t size)
{
    const char *slash = strrchr(path, '/');
    if (slash != NULL && slash > path)
        make_folder(part_of(path, (size_t)(slash - path)));
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        give_up(path);
}

const char *
current_folder(void)
{
    char here[4096];
    if (getcwd(here, sizeof here) == NULL)
        give_up("getcwd");
    return format("%s", here);
}

const char *
from_root(const char *path)
{
    return *path == '/' ? path : format("%s/%s", current_folder(), path);
}
