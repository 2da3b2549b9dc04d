/* tools.c - tests that run the project's tools on files that they have written. */
#include "tests/harness/tools.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

char build[2100], root[1000], said[200000];

void
tools_begin(char **argv)
{
    must(getcwd(root, sizeof root) != NULL, ".");
    snprintf(build, sizeof build, "%s%s%s", argv[0][0] == '/' ? "" : root,
             argv[0][0] == '/' ? "" : "/", argv[0]);
    for (int level = 0; level < 2; level++)
        *strrchr(build, '/') = '\0';
}

void
must(bool done, const char *what)
{
    if (!done) {
        perror(what);
        abort();
    }
}

void
write_file(const char *path, const char *bytes)
{
    FILE *file = fopen(path, "w");
    must(file != NULL && fputs(bytes, file) >= 0 && fclose(file) == 0, path);
}

int
run(const char *command)
{
    static char line[13000];
    snprintf(line, sizeof line, "unset MAKEFLAGS MFLAGS MAKELEVEL BUILD CFLAGS\n"
             "{ %.12900s\n} 2>&1", command);
    FILE *pipe = popen(line, "r");
    must(pipe != NULL, line);
    said[fread(said, 1, sizeof said - 1, pipe)] = '\0';
    int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int
run_tool(const char *name, const char *arguments)
{
    char command[5000];
    snprintf(command, sizeof command, "'%s/%s' %s", build, name, arguments);
    return run(command);
}
