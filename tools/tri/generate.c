/* generate.c - tri generate. */
#include "tools/tri/tri.h"

#include "lib/binary.h"
#include "lib/memory.h"

#include <stdlib.h>
#include <string.h>

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
    bool binary = take_flag(&argc, argv, "--binary");
    expect_words(argc, argv, 2, 2);
    if (path == NULL)
        path = "-";
    const distribution *d = find_distribution(argv[1]);
    uint32_t n = (uint32_t)parse_whole(argv[0], "N", argv[2], UINT32_MAX - 1);
    random_source source = random_from_seed(
        seed != NULL ? parse_whole(argv[0], "--seed", seed, UINT64_MAX) : 1);
    check_output(path);

    point2 *points = memory_array(n, sizeof *points);
    if (points == NULL)
        must(TRI_OUT_OF_MEMORY);
    d->fill(points, n, &source);
    output o = begin_output(path);
    if (binary)
        binary_write_points(o.file, points, n);
    else
        text_write_points(o.file, points, n, 0);
    finish_output(&o, path);
    memory_free(points);
    return EXIT_HOLDS;
}
