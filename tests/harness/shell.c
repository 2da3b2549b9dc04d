/* shell.c - tests that drive programs by the shell. */
#include "tests/harness/shell.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char scratch[900]; /* what $d is */

void
shell_begin(char **argv)
{
    char here[300] = "", build[600], program[620];
    const char *slash = strrchr(argv[0], '/');
    const char *name = slash != NULL ? slash + 1 : argv[0];
    int length = slash != NULL ? (int)(slash - argv[0]) : 1;
    if (argv[0][0] != '/' && getcwd(here, sizeof here - 1) != NULL)
        strcat(here, "/");
    snprintf(build, sizeof build, "%s%.*s/..", here, length, slash ? argv[0] : ".");
    snprintf(program, sizeof program, "%s/tri", build);
    snprintf(scratch, sizeof scratch, "%s/test/%s.XXXXXX", build, name);
    if (mkdtemp(scratch) == NULL) {
        perror(scratch);
        exit(2);
    }
    setenv("build", build, 1);
    setenv("tri", getenv("TRI") != NULL ? getenv("TRI") : program, 1);
    setenv("d", scratch, 1);
}

void
shell_end(void)
{
    if (shell("rm -r \"$d\"") != 0)
        perror(scratch);
}

int
shell(const char *command, ...)
{
    char text[4000];
    va_list arguments;
    va_start(arguments, command);
    vsnprintf(text, sizeof text, command, arguments);
    va_end(arguments);
    int status = system(text);
    return status != -1 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

file_name
in_scratch(const char *name)
{
    file_name path;
    snprintf(path.text, sizeof path.text, "%s/%s", scratch, name);
    return path;
}

content
read_scratch(const char *name)
{
    content c = {""};
    FILE *file = fopen(in_scratch(name).text, "rb");
    if (file != NULL) {
        c.text[fread(c.text, 1, sizeof c.text - 1, file)] = '\0';
        fclose(file);
    }
    return c;
}

bool
has(const char *name, const char *part)
{
    return strstr(read_scratch(name).text, part) != NULL;
}

bool
one_line(const char *name)
{
    content c = read_scratch(name);
    const char *newline = strchr(c.text, '\n');
    return newline != NULL && newline[1] == '\0';
}
