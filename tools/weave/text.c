/* text.c - files as lines, and saying what is wrong in them. */
#include "tools/weave/text.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

static size_t said;

void
complain(const char *path, size_t line, const char *what, ...)
{
    va_list arguments;
    va_start(arguments, what);
    fprintf(stderr, "%s:%zu: ", path, line + 1);
    vfprintf(stderr, what, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    said++;
}

size_t
complaints(void)
{
    return said;
}

void
give_up(const char *path)
{
    fprintf(stderr, "weave: %s: %s\n", path, strerror(errno));
    exit(2);
}

bool
begins_with(const char *line, const char *prefix)
{
    return strncmp(line, prefix, strlen(prefix)) == 0;
}

bool
ends_with(const char *line, const char *suffix)
{
    size_t n = strlen(line), k = strlen(suffix);
    return n >= k && strcmp(line + n - k, suffix) == 0;
}

size_t
indentation(const char *line)
{
    return strspn(line, " ");
}

void
text_free(text *t)
{
    free(t->bytes);
    free(t->line);
    *t = (text){0};
}

void
text_split(text *t, size_t size)
{
    t->line = malloc((size + 1) * sizeof *t->line);
    if (t->line == NULL)
        give_up("out of memory");
    for (char *at = t->bytes, *end = at + size; at < end; at += strlen(at) + 1) {
        t->line[t->lines++] = at;
        at[strcspn(at, "\n")] = '\0';
    }
}

bool
text_read(text *t, const char *path)
{
    *t = (text){0};
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return false;
    size_t room = 0; /* text has no NUL, so getdelim finds none before the end */
    ssize_t size = getdelim(&t->bytes, &room, '\0', file);
    if (ferror(file))
        give_up(path);
    fclose(file);
    text_split(t, size > 0 ? (size_t)size : 0);
    return true;
}
