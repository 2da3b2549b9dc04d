/* generate.c - tri generate. */
#include "tools/tri/tri.h"

#include "lib/memory.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static uint64_t
parse_whole(const char *what, const char *text, uint64_t most)
{
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    bool whole = text[0] >= '0' && text[0] <= '9' && *end == '\0';
    if (!whole || errno != 0 || value > most)
        die_usage("generate", "%s %s: a whole number from 0 to %llu is needed",
                  what, text, (unsigned long long)most);
    return value;
}

static const distribution *
find_distribution(const char *name)
{
    for (const distribution *d = distributions; d->name != NULL; d++)
        if (strcmp(d->name, name) == 0)
            return d;
    die_usage("generate", "there is no distribution %s", name);
}

int
command_generate(int argc, char **argv)
{
    const char *path = take_option(&argc, argv, "-o");
    const char *seed = take_option(&argc, argv, "--seed");
    expect_words(argc, argv, 2, 2);
    if (path == NULL)
        path = "-";
    const distribution *d = find_distribution(argv[1]);
    uint32_t n = (uint32_t)parse_whole("N", argv[2], UINT32_MAX - 1);
    random_source source = random_from_seed(
        seed != NULL ? parse_whole("--seed", seed, UINT64_MAX) : 1);
    check_output(path);

    point2 *points = memory_array(n, sizeof *points);
    if (points == NULL)
        must(TRI_OUT_OF_MEMORY);
    d->fill(points, n, &source);
    output o = begin_output(path);
    text_write_points(o.file, points, n, 0);
    finish_output(&o, path);
    memory_free(points);
    return EXIT_HOLDS;
}
