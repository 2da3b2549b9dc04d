/* bench.c - how long do the algorithms take, compared with sorting the same
 * points, and with what others have made?
 *
 * Run it in the root of the project: `build/bench/bench --help` says how.
 */
#include "tools/bench/bench.h"

#include "lib/binary.h"
#include "lib/memory.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char usage[] =
    "usage: bench [-a] [-r RUNS] [-s SECONDS] [-t SECONDS] [-o FOLDER]\n"
    "             [SIZE | DISTRIBUTION | NAME]...\n"
    "\n"
    "Times of the algorithms, and of the peers in FOLDER/peers, on points of several\n"
    "distributions, beside those of sorting the points.\n"
    "  -a          the aims, too, when something is named; else they are there\n"
    "  -r RUNS     at most so many runs of each (5 if not given)\n"
    "  -s SECONDS  no further run of one that has taken so long in all (1.5)\n"
    "  -t SECONDS  a run is stopped after that (5)\n"
    "  -o FOLDER   for bench.csv, growth.svg and ratios.svg (build/bench)\n"
    "  SIZE        how many points: 1000 10000 100000 1000000 if none is given\n"
    "  DISTRIBUTION, NAME   only these, of those below\n"
    "\n"
    "Every run is a process of its own. All take turns. What counts is the processor\n"
    "time of the program itself (user), the least of all runs; the median and the\n"
    "time on the wall stand beside it. The memory is what is held beyond the points,\n"
    "per point. Answers are certified off the clock; for more than 100000 points,\n"
    "only those of the program's default algorithm, for more than 20000000, none.\n"
    "The aims of the project are lines PASS or FAIL at the end.\n"
    "\n"
    "Exit status: 0 all has been measured, or stopped at a limit; 1 an algorithm has\n"
    "failed or is wrong (a peer may: then its line says so); 2 the program cannot\n"
    "run.\n";

_Noreturn void
refuse(const char *sentence, const char *which)
{
    fprintf(stderr, "bench: %s %s\n`bench --help` tells more\n", sentence,
            which);
    exit(2);
}

/* ---- Small things that all parts need. ---- */

const algorithm *
subject(void)
{
    const algorithm *last = contents_find("fast");
    for (uint32_t i = 0; i < contents_count && last == NULL; i++)
        if (contents[contents_count - 1 - i].delaunay)
            last = &contents[contents_count - 1 - i];
    return last;
}

int
find_contender(const bench *b, const char *name)
{
    for (int c = 0; c < b->contenders; c++)
        if (strcmp(b->contender[c].name, name) == 0)
            return c;
    return -1;
}

static const cell *
find_cell_in_state(const bench *b, uint32_t n, const char *input,
                   const char *name, cell_state state)
{
    int c = find_contender(b, name);
    for (int s = 0; s < b->sizes && c >= 0; s++)
        for (int i = 0; i < b->inputs; i++)
            if (b->size[s] == n && strcmp(b->input[i]->name, input) == 0 &&
                b->cell[s][i][c].state == state)
                return &b->cell[s][i][c];
    return NULL;
}

const cell *
find_cell(const bench *b, uint32_t n, const char *input, const char *name)
{
    return find_cell_in_state(b, n, input, name, CELL_MEASURED);
}

bool
was_stopped(const bench *b, uint32_t n, const char *input, const char *name)
{
    return find_cell_in_state(b, n, input, name, CELL_TOO_LONG) != NULL;
}

static int
compare_numbers(const void *p, const void *q)
{
    double a = *(const double *)p, b = *(const double *)q;
    return (a > b) - (a < b);
}

summary
summarize(double *v, unsigned count)
{
    qsort(v, count, sizeof *v, compare_numbers);
    return (summary){v[0], (v[(count - 1) / 2] + v[count / 2]) / 2};
}

point2 *
make_points(const distribution *d, uint32_t n)
{
    point2 *points = memory_array(n, sizeof *points);
    if (points == NULL)
        refuse("there is no memory for", "so many points");
    random_source source = random_from_seed(1);
    d->fill(points, n, &source);
    return points;
}

void
write_point_file(const char *path, const point2 *points, uint32_t n)
{
    output o = {0};
    if (output_begin(&o, path) != TRI_OK)
        refuse("cannot write", path);
    binary_write_points(o.file, points, n);
    if (output_commit(&o) != TRI_OK)
        refuse("cannot write", path);
}

/* ---- Who takes part. ---- */

static contender *
add_contender(bench *b, const char *name)
{
    if (b->contenders == MOST_CONTENDERS)
        refuse("there are too many to compare with", name);
    contender *c = &b->contender[b->contenders++];
    *c = (contender){.algorithm = NULL};
    snprintf(c->name, sizeof c->name, "%s", name);
    return c;
}

/* The yardstick, the algorithms, the peers that are there. */
static void
find_contenders(bench *b)
{
    char pattern[300];
    glob_t files;
    add_contender(b, "yardstick")->sorts = true;
    for (uint32_t i = 0; i < contents_count; i++)
        add_contender(b, contents[i].name)->algorithm = &contents[i];
    snprintf(pattern, sizeof pattern, "%s/peers/*", b->folder);
    if (glob(pattern, 0, NULL, &files) != 0)
        return;
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i], *name = strrchr(path, '/') + 1;
        if (strchr(name, '.') != NULL || access(path, X_OK) != 0)
            continue; /* no program */
        contender *c = add_contender(b, name);
        c->sorts = strcmp(name, "std_sort") == 0;
        snprintf(c->program, sizeof c->program, "%s", path);
    }
    globfree(&files);
}

/* ---- What is asked. ---- */

/* What words have named: all of a kind if none has been. */
typedef struct named {
    bool distribution[MOST_INPUTS], contender[MOST_CONTENDERS];
    int distributions, contenders;
} named;

static bool
name_size(bench *b, const char *word)
{
    char *end;
    unsigned long n = strtoul(word, &end, 10);
    if (*end != '\0' || n < 1 || n >= UINT32_MAX || b->sizes == MOST_SIZES)
        return false;
    int at = b->sizes++;
    for (; at > 0 && b->size[at - 1] > n; at--)
        b->size[at] = b->size[at - 1];
    b->size[at] = (uint32_t)n;
    return true;
}

static void
read_word(bench *b, named *names, const char *word)
{
    if (name_size(b, word))
        return;
    for (int i = 0; distributions[i].name != NULL; i++)
        if (strcmp(distributions[i].name, word) == 0) {
            names->distribution[i] = true;
            names->distributions++;
            return;
        }
    int c = find_contender(b, word);
    if (c < 0)
        refuse("there is no size, distribution, algorithm or peer", word);
    names->contender[c] = true;
    names->contenders++;
}

/* Sorts are always there. */
static void
keep_named(bench *b, const named *names)
{
    int kept = 0;
    for (int c = 0; c < b->contenders; c++)
        if (names->contenders == 0 || names->contender[c] ||
            b->contender[c].sorts)
            b->contender[kept++] = b->contender[c];
    b->contenders = kept;
    for (int i = 0; distributions[i].name != NULL && i < MOST_INPUTS; i++)
        if (names->distributions == 0 || names->distribution[i])
            b->input[b->inputs++] = &distributions[i];
    if (b->sizes == 0)
        for (uint32_t n = 1000; n <= 1000000; n *= 10)
            b->size[b->sizes++] = n;
}

static unsigned
read_count(const char *text, unsigned long most)
{
    char *end;
    unsigned long n = strtoul(text, &end, 10);
    if (*end != '\0' || n < 1 || n > most)
        refuse("not a number that can be used:", text);
    return (unsigned)n;
}

static void
print_help(const bench *b)
{
    printf("%s\nDistributions:\n", usage);
    for (const distribution *d = distributions; d->name != NULL; d++)
        printf("  %-11s %s\n", d->name, d->summary);
    printf("\nNames (std_sort and what follows are programs in %s/peers):\n",
           b->folder);
    for (int c = 0; c < b->contenders; c++)
        printf("  %-12s %s\n", b->contender[c].name,
               b->contender[c].algorithm != NULL
                   ? b->contender[c].algorithm->summary
                   : "");
}

static void
read_arguments(bench *b, int argc, char **argv)
{
    named names = {.contenders = 0};
    bool help = false;
    for (int i = 1; i < argc; i++)
        help = help || strcmp(argv[i], "--help") == 0;
    for (int option;
         !help && (option = getopt(argc, argv, "har:s:t:o:")) != -1;)
        if (option == 'a')
            b->aims = true;
        else if (option == 'r')
            b->runs = read_count(optarg, MOST_RUNS);
        else if (option == 's')
            b->spend = read_count(optarg, 86400);
        else if (option == 't')
            b->seconds = read_count(optarg, 86400);
        else if (option == 'o')
            b->folder = optarg;
        else if (option == 'h')
            help = true;
        else
            refuse("the options are", "-a, -r, -s, -t and -o");
    find_contenders(b);
    if (help) {
        print_help(b);
        exit(0);
    }
    b->aims = b->aims || optind == argc;
    while (optind < argc)
        read_word(b, &names, argv[optind++]);
    keep_named(b, &names);
}

int
main(int argc, char **argv)
{
    static bench b = {
        .runs = 5, .spend = 1.5, .seconds = 5, .folder = "build/bench"};
    char path[400];
    bool well = true;
    read_arguments(&b, argc, argv);
    snprintf(path, sizeof path, "%s/bench.csv", b.folder);
    b.csv = fopen(path, "w");
    if (b.csv == NULL)
        refuse("cannot write", path);
    fputs(
        "distribution,points,name,state,runs,user_least,user_median,processor_least,"
        "processor_median,wall_least,wall_median,over_yardstick,"
        "over_yardstick_median,over_std_sort,over_std_sort_median,bytes_per_point,"
        "answer\n",
        b.csv);

    for (int s = 0; s < b.sizes; s++)
        for (int i = 0; i < b.inputs; i++)
            well = measure_block(&b, s, i) && well;
    for (int s = 0; s < b.sizes; s++)
        print_summary(&b, s);
    draw_plots(&b);
    if (b.aims)
        print_targets(&b);
    printf("\nall numbers: %s; plots beside it\n", path);
    return fclose(b.csv) == 0 && well ? 0 : 1;
}
