/* main.c - the program tri: triangulates, checks, draws and makes points. */
#include "tools/tri/tri.h"

#include "chapters/contents.h"
#include "tools/tri/formats.h"

#include <signal.h>
#include <string.h>

const command commands[] = {
    {"triangulate", command_triangulate,
     "[--algorithm NAME] [OPTIONS] [-o FILE] [--svg FILE] [--stats] IN",
     "Triangulates the points of IN.\n"
     "  --algorithm NAME   one of those below\n"
     "  --direction DX,DY  the order of the points in 2.3, 3.5 and 3.7: along\n"
     "                     it (1,0 if not given)\n"
     "  --cuts WORD        3.7: vertical (if not given) or alternating\n"
     "  --locator WORD     3.6: walk, buckets (if not given), history, grid\n"
     "  --seed N           3.6: names the random order (0 if not given)\n"
     "  --threads N        fast: how many work at once (1 if not given); the\n"
     "                     result is the same\n"
     "  -o FILE            the triangles, written as the ending of FILE says\n"
     "  --svg FILE         a picture\n"
     "  --stats            lines `name value` on standard output\n"
     "With none of the last three, the triangles go to standard output, as .ele.\n"},
    {"check", command_check, "[--delaunay] POINTS TRIANGLES",
     "Is TRIANGLES a triangulation of POINTS (a Delaunay triangulation)?\n"
     "Exit status: 0 it is; 1 it is not, see the witness; 2 unusable.\n"},
    {"hull", command_hull, "[-o OUT.edge] IN",
     "The boundary of the convex hull, counterclockwise, as edges between\n"
     "neighbouring points; those inside hull edges are included.\n"},
    {"voronoi", command_voronoi, "[-o OUT] [--per-triangle] [--svg FILE] IN",
     "The Voronoi diagram of the points of IN: OUT.v.node has the vertices, and\n"
     "OUT.v.edge the edges, each between two of them. A ray has one vertex, -1\n"
     "and its direction; a line (of collinear points) -1, -1, a point of it and\n"
     "its direction. Coordinates are rounded once, to the nearest double.\n"
     "  --per-triangle     a vertex for each triangle of OUT.ele, and an edge for\n"
     "                     each of OUT.edge, perhaps of length 0\n"
     "  --svg FILE         a picture\n"},
    {"flipgraph", command_flipgraph, "[--svg FILE] IN",
     "All triangulations of the points of IN (at most 64 points, and a million\n"
     "triangulations), and the flips between them: how many there are, how far apart\n"
     "two can be (up to 50,000 triangulations; beyond that, a bound), how many are\n"
     "Delaunay.\n"
     "  --svg FILE         a picture of at most 64 triangulations\n"},
    {"emst", command_graph, "[-o OUT.edge] IN",
     "A shortest tree that connects the points of IN, shortest edges first.\n"},
    {"gabriel", command_graph, "[-o OUT.edge] IN",
     "The Gabriel graph: edges with no other point in the disc, or on the circle,\n"
     "of which they are the diameter.\n"},
    {"rng", command_graph, "[-o OUT.edge] IN",
     "The relative neighbourhood graph: edges such that no point is nearer to both\n"
     "ends than these are to each other.\n"},
    {"nng", command_graph, "[-o OUT.edge] IN",
     "The edges from each point to its nearest one; of several, to all of them.\n"},
    {"trace", command_trace, "--algorithm NAME [OPTIONS] [-o FILE.json] IN",
     "Each step of the algorithm on the points of IN (at most 10,000 points, and a\n"
     "million steps), as JSON: for pictures that move. The format: docs/trace.md.\n"
     "  --algorithm NAME   one of those of `tri help triangulate` that report steps\n"
     "  OPTIONS            --direction, --cuts, --locator, --seed as there\n"},
    {"generate", command_generate, "DISTRIBUTION N [--seed S] [--binary] [-o OUT.node]",
     "Makes N points, the same bytes everywhere. The seed is 1 by default.\n"
     "  --binary           as bits, not as text\n"},
    {"draw", command_draw, "POINTS [TRIANGLES] [-o FILE.svg]",
     "Draws points, and triangles.\n"},
    {"help", command_help, "[COMMAND]", "What you are reading.\n"},
    {NULL, NULL, NULL, NULL},
};

static const char files[] =
    "Files: .node, .ele and .edge of Shewchuk's Triangle; points also as\n"
    "lines `x y` or CSV, perhaps with a header (columns x,y or lon,lat, else\n"
    "the first two), or as bits (of generate --binary). `-` is standard input or "
    "output, and so is no -o.\n"
    "Exit status: 0 done, 1 refuted (check), 2 unusable input or arguments.\n";

static void
print_commands(FILE *file)
{
    fprintf(file, "usage:\n");
    for (const command *c = commands; c->name != NULL; c++)
        fprintf(file, "  tri %s %s\n", c->name, c->usage);
    fprintf(file, "  tri --version\n\n%s", files);
}

static void
print_formats(void)
{
    printf("\nEndings of FILE:\n");
    for (const format *f = formats; f->ending != NULL; f++)
        printf("  %-10s %s\n", f->ending, f->summary);
}

static void
print_algorithms(void)
{
    printf("\nAlgorithms, and the section of the notes (if not given: %s):\n",
           default_algorithm()->name);
    for (uint32_t i = 0; i < contents_count; i++) {
        const algorithm *a = &contents[i];
        printf("  %-11s %s  %-13s  %s", a->name, a->section,
               a->delaunay ? "Delaunay" : "triangulation", a->summary);
        if (a->most < UINT32_MAX)
            printf(" (slow beyond %lu points)", (unsigned long)a->most);
        putchar('\n');
    }
}

int
command_help(int argc, char **argv)
{
    expect_words(argc, argv, 0, 1);
    if (argc == 1) {
        print_commands(stdout);
        return EXIT_HOLDS;
    }
    for (const command *c = commands; c->name != NULL; c++) {
        if (strcmp(c->name, argv[1]) != 0)
            continue;
        printf("usage: tri %s %s\n\n%s", c->name, c->usage, c->help);
        if (c->run == command_triangulate) {
            print_formats();
            print_algorithms();
        }
        if (c->run == command_generate) {
            printf("\nDistributions:\n");
            for (const distribution *d = distributions; d->name != NULL; d++)
                printf("  %-10s %s\n", d->name, d->summary);
        }
        return EXIT_HOLDS;
    }
    die_usage("help", "there is no command %s", argv[1]);
}

static int
run(int argc, char **argv)
{
    if (argc < 2) {
        print_commands(stderr);
        return EXIT_UNUSABLE;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("tri 1.0\n");
        return EXIT_HOLDS;
    }
    for (const command *c = commands; c->name != NULL; c++)
        if (strcmp(argv[1], c->name) == 0)
            return c->run(argc - 1, argv + 1);
    fprintf(stderr, "tri: there is no command %s\n\n", argv[1]);
    print_commands(stderr);
    return EXIT_UNUSABLE;
}

int
main(int argc, char **argv)
{
    /* A reader who leaves early is an error of writing like any other. */
    signal(SIGPIPE, SIG_IGN);
    int status = run(argc, argv);
    if (fflush(stdout) != 0 || ferror(stdout))
        die("<stdout>: cannot be written");
    return status;
}
