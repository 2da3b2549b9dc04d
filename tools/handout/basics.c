/* basics.c - texts, files and programs. */
#include "tools/handout/basics.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- Memory: a chain of blocks, so that all is still in reach at the end. ---- */

typedef struct block {
    struct block *before;
    max_align_t bytes[];
} block;

static block *blocks;

void *
take(size_t size)
{
    block *b = calloc(1, sizeof *b + size);
    if (b == NULL)
        give_up("memory");
    b->before = blocks;
    blocks = b;
    return b->bytes;
}

/* Room doubles: it is the power of two from `count` on, and used up at each of them. */
void *
take_one_more(void *array, size_t count, size_t size)
{
    if ((count & (count - 1)) != 0)
        return array;
    void *larger = take((count == 0 ? 1 : 2 * count) * size);
    if (count > 0)
        memcpy(larger, array, count * size);
    return larger;
}

/* ---- Texts. ---- */

char *
format(const char *what, ...)
{
    va_list arguments;
    va_start(arguments, what);
    int length = vsnprintf(NULL, 0, what, arguments);
    va_end(arguments);
    char *text = take((size_t)length + 1);
    va_start(arguments, what);
    vsnprintf(text, (size_t)length + 1, what, arguments);
    va_end(arguments);
    return text;
}

char *
part_of(const char *text, size_t length)
{
    char *part = take(length + 1);
    memcpy(part, text, length);
    return part;
}

char *
replace_all(const char *from, const char *what, const char *by)
{
    const char *at = strstr(from, what);
    if (at == NULL)
        return part_of(from, strlen(from));
    return format("%.*s%s%s", (int)(at - from), from, by,
                  replace_all(at + strlen(what), what, by));
}

bool
begins_with(const char *text, const char *prefix)
{
    return strncmp(text, prefix, strlen(prefix)) == 0;
}

bool
ends_with(const char *text, const char *suffix)
{
    size_t n = strlen(text), k = strlen(suffix);
    return n >= k && strcmp(text + n - k, suffix) == 0;
}

static const char blanks[] = " \t\r\n";

char *
next_word(const char **rest)
{
    const char *word = *rest + strspn(*rest, blanks);
    size_t length = strcspn(word, blanks);
    *rest = word + length;
    return length > 0 ? part_of(word, length) : NULL;
}

bool
has_word(const char *list, const char *word, size_t length)
{
    while (*(list += strspn(list, blanks)) != '\0') {
        size_t here = strcspn(list, blanks);
        if (here == length && memcmp(list, word, length) == 0)
            return true;
        list += here;
    }
    return false;
}

/* ---- Files and programs. ---- */

char *
file_bytes(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL && (errno == ENOENT || errno == ENOTDIR))
        return NULL;
    if (file == NULL || fseek(file, 0, SEEK_END) != 0)
        give_up(path);
    long length = ftell(file);
    if (length < 0 || fseek(file, 0, SEEK_SET) != 0)
        give_up(path);
    char *bytes = take((size_t)length + 1);
    if (fread(bytes, 1, (size_t)length, file) != (size_t)length)
        give_up(path);
    fclose(file);
    if (size != NULL)
        *size = (size_t)length;
    return bytes;
}

/* What a make around us has put into the environment is meant for its own tree. */
static void
forget_surrounding_make(void)
{
    static const char *const names[] = {"MAKEFLAGS", "MFLAGS", "MAKELEVEL", "BUILD",
                                        "CFLAGS", "CC"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        unsetenv(names[k]);
}

int
run_program(const char *folder, const char *output, const char *const command[])
{
    fflush(NULL);
    pid_t child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0) {
        int out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        if (out < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0 || chdir(folder) != 0)
            _exit(127);
        forget_surrounding_make();
        execvp(command[0], (char *const *)command);
        _exit(127);
    }
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            give_up(command[0]);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* ---- Giving up. ---- */

void
refuse(const char *because, ...)
{
    va_list arguments;
    va_start(arguments, because);
    vfprintf(stderr, because, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(1);
}

void
give_up(const char *path)
{
    fprintf(stderr, "%s: %s\n", path, strerror(errno));
    exit(2);
}
