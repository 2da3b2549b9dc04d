/* driver.c - runs a fuzz target where there is no libFuzzer.
 *
 *     read_files SECONDS SEED LAST FILE...
 *
 * Changes the files at random, again and again, and gives them to the target. Each
 * text is first kept in the file LAST, so that it is there when the target fails.
 */
#include "lib/random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MOST_BYTES = 4096, MOST_FILES = 200 };

typedef struct text {
    uint8_t bytes[MOST_BYTES];
    size_t size;
} text;

static text corpus[MOST_FILES];

/* One place of the text: another byte, fewer bytes, or some of them twice. */
static void
change(text *t, random_source *r)
{
    static const char telling[] = "0123456789 \t\r\n,.#+-eEnaif\"xy";
    size_t at = random_below(r, (uint32_t)t->size + 1), rest = t->size - at;
    size_t run = 1 + random_below(r, 8);
    switch (random_below(r, 4)) {
    case 0:
        if (rest > 0)
            t->bytes[at] = (uint8_t)telling[random_below(r, sizeof telling - 1)];
        break;
    case 1:
        if (rest > 0)
            t->bytes[at] = (uint8_t)random_below(r, 256);
        break;
    case 2:
        if (rest >= run) {
            memmove(t->bytes + at, t->bytes + at + run, rest - run);
            t->size -= run;
        }
        break;
    default:
        if (rest >= run && t->size + run <= MOST_BYTES) {
            memmove(t->bytes + at + run, t->bytes + at, rest);
            t->size += run;
        }
    }
}

static void
keep(const char *path, const text *t)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(t->bytes, 1, t->size, file) != t->size ||
        fclose(file) != 0) {
        perror(path);
        exit(2);
    }
}

int
main(int argc, char **argv)
{
    if (argc < 5) {
        fprintf(stderr, "usage: %s SECONDS SEED LAST FILE...\n", argv[0]);
        return 2;
    }
    uint32_t files = 0;
    for (int i = 4; i < argc && files < MOST_FILES; i++) {
        FILE *file = fopen(argv[i], "rb");
        if (file == NULL) {
            perror(argv[i]);
            return 2;
        }
        corpus[files].size = fread(corpus[files].bytes, 1, MOST_BYTES, file);
        fclose(file);
        files++;
    }
    random_source r = random_from_seed(strtoull(argv[2], NULL, 10));
    time_t end = time(NULL) + atoi(argv[1]);
    unsigned long runs = 0;
    for (; time(NULL) < end; runs++) {
        text t = corpus[random_below(&r, files)];
        for (uint32_t changes = 1 + random_below(&r, 6); changes > 0; changes--)
            change(&t, &r);
        keep(argv[3], &t);
        LLVMFuzzerTestOneInput(t.bytes, t.size);
    }
    printf("%lu texts\n", runs);
    return runs == 0;
}
