/* wire.c - messages between a checker and a student's program. */
#include "tools/checks/wire.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void
words_put(words *w, uint64_t word)
{
    if (w->count == w->room) {
        size_t room = w->room < 64 ? 64 : 2 * w->room;
        uint64_t *moved = realloc(w->word, room * sizeof *moved);
        if (moved == NULL) {
            fputs("out of memory\n", stderr);
            exit(1);
        }
        w->word = moved;
        w->room = room;
    }
    w->word[w->count++] = word;
}

void
words_put_real(words *w, double x)
{
    words_put(w, word_of_real(x));
}

void
words_clear(words *w)
{
    w->count = 0;
}

void
words_free(words *w)
{
    free(w->word);
    *w = (words){0};
}

uint64_t
word_of_real(double x)
{
    uint64_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

double
real_of_word(uint64_t word)
{
    double x;
    memcpy(&x, &word, sizeof x);
    return x;
}

static bool
write_bytes(int to, const void *bytes, size_t count)
{
    const char *next = bytes;
    while (count > 0) {
        ssize_t written = write(to, next, count);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        next += written;
        count -= (size_t)written;
    }
    return true;
}

bool
wire_write(int to, wire_kind kind, const uint64_t *word, size_t count)
{
    uint64_t buffer[16] = {(uint64_t)kind, count};
    if (count <= 14) { /* short ones, all questions among them, in one piece */
        if (count > 0)
            memcpy(buffer + 2, word, count * sizeof *word);
        return write_bytes(to, buffer, (2 + count) * sizeof *word);
    }
    return write_bytes(to, buffer, 2 * sizeof *word) &&
           write_bytes(to, word, count * sizeof *word);
}

bool
wire_read_bytes(int from, void *bytes, size_t count)
{
    char *next = bytes;
    while (count > 0) {
        ssize_t got = read(from, next, count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        next += got;
        count -= (size_t)got;
    }
    return true;
}
