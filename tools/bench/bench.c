/* bench.c - how long do the algorithms take, compared with sorting the same points?
 *
 *     bench [-r RUNS] [-t SECONDS] [-o FOLDER] [N | DISTRIBUTION | ALGORITHM]...
 *
 * Words that are left out mean: 5 runs, at most 30 seconds each, build/bench; 100000
 * and 1000000 points, all distributions of `tri generate`, all algorithms that can
 * be waited for. Run it in the root of the project.
 *
 * Every run is a process of its own. An algorithm and the yardstick take turns,
 * A B A B, so that a machine that becomes slower is slower for both. A number in
 * the table is the time of the algorithm over that of the sort: the least of each,
 * then the median of each. FOLDER/bench.csv has the times themselves.
 *
 * Exit status: 0 all has been measured or stopped at the limit; 1 an algorithm has
 * failed; 2 the program cannot run.
 */
#include "lib/memory.h"
#include "tools/bench/measure.h"
#include "tools/tri/tri.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_RUNS = 99, MOST_SIZES = 8, MOST_ALGORITHMS = 16 };

static const char usage[] =
    "usage: bench [-r RUNS] [-t SECONDS] [-o FOLDER] "
    "[N | DISTRIBUTION | ALGORITHM]...\n";

typedef struct plan {
    unsigned runs, seconds;
    const char *folder;
    uint32_t size[MOST_SIZES];
    int sizes;
    const distribution *only_distribution; /* NULL: all */
    const algorithm *only_algorithm;       /* NULL: all */
    FILE *csv;
} plan;

_Noreturn static void
refuse(const char *what, const char *which)
{
    fprintf(stderr, "bench: %s %s\n%s", what, which, usage);
    exit(2);
}

/* ---- Least and median. ---- */

typedef struct summary {
    double least, median;
} summary;

static int
compare_numbers(const void *p, const void *q)
{
    double a = *(const double *)p, b = *(const double *)q;
    return (a > b) - (a < b);
}

static summary
summarize(double *v, unsigned count)
{
    qsort(v, count, sizeof *v, compare_numbers);
    return (summary){v[0], (v[(count - 1) / 2] + v[count / 2]) / 2};
}

/* ---- One algorithm on one set of points. ---- */

typedef struct cell {
    run_end end;
    summary ours, sort;
    double bytes_per_point; /* the most of all runs; negative when not known */
} cell;

static cell
measure_turns(const plan *p, const algorithm *a, const point2 *points, uint32_t n)
{
    double ours[MOST_RUNS], sort[MOST_RUNS];
    cell c = {.end = RUN_DONE, .bytes_per_point = -1};
    for (unsigned i = 0; i < p->runs; i++) {
        run r = measure(a, points, n, p->seconds);
        if (r.end != RUN_DONE)
            return (cell){.end = r.end, .bytes_per_point = -1};
        ours[i] = r.seconds;
        if (r.bytes / n > c.bytes_per_point)
            c.bytes_per_point = r.bytes / n;
        r = measure(NULL, points, n, p->seconds);
        if (r.end != RUN_DONE)
            refuse("the yardstick has not ended well:", "more seconds?");
        sort[i] = r.seconds;
    }
    c.ours = summarize(ours, p->runs);
    c.sort = summarize(sort, p->runs);
    return c;
}

/* The row's share of the table: two ratios, and all there is in bench.csv. */
static void
print_cell(const plan *p, const char *of, const algorithm *a, uint32_t n,
           const cell *c)
{
    char text[32];
    static const char *const ends[] = {"done", "too long", "failed"};
    fprintf(p->csv, "%s,%lu,%s,%s,%u", of, (unsigned long)n, a->name, ends[c->end],
            p->runs);
    if (c->end == RUN_DONE) {
        double least = c->ours.least / c->sort.least;
        double median = c->ours.median / c->sort.median;
        snprintf(text, sizeof text, "%.2f %.2f", least, median);
        fprintf(p->csv, ",%.6f,%.6f,%.6f,%.6f,%.3f,%.3f,", c->ours.least,
                c->ours.median, c->sort.least, c->sort.median, least, median);
        if (c->bytes_per_point >= 0)
            fprintf(p->csv, "%.0f", c->bytes_per_point);
    } else {
        if (c->end == RUN_TOO_LONG)
            snprintf(text, sizeof text, "over %u s", p->seconds);
        else
            snprintf(text, sizeof text, "failed");
        fputs(",,,,,,,", p->csv);
    }
    fputc('\n', p->csv);
    fflush(p->csv);
    printf(" %15s", text);
    fflush(stdout);
}

/* ---- One table for each number of points. ---- */

/* The algorithms that can be waited for with n points; returns how many. */
static int
choose_columns(const plan *p, uint32_t n, const algorithm **column)
{
    int columns = 0;
    for (uint32_t i = 0; i < contents_count && columns < MOST_ALGORITHMS; i++)
        if (n <= contents[i].most && (p->only_algorithm == NULL ||
                                      p->only_algorithm == &contents[i]))
            column[columns++] = &contents[i];
    return columns;
}

/* Returns whether nothing has failed. */
static bool
print_table(const plan *p, uint32_t n)
{
    const algorithm *column[MOST_ALGORITHMS];
    double bytes[MOST_ALGORITHMS];
    bool well = true;
    int columns = choose_columns(p, n, column);
    point2 *points = memory_array(n, sizeof *points);
    if (points == NULL)
        refuse("there is no memory for", "so many points");

    printf("\n%lu points\n%-11s", (unsigned long)n, "");
    for (int k = 0; k < columns; k++) {
        bytes[k] = -1;
        printf(" %15s", column[k]->name);
    }
    for (const distribution *d = distributions; d->name != NULL; d++) {
        if (p->only_distribution != NULL && p->only_distribution != d)
            continue;
        random_source source = random_from_seed(1);
        d->fill(points, n, &source);
        printf("\n%-11s", d->name);
        for (int k = 0; k < columns; k++) {
            cell c = measure_turns(p, column[k], points, n);
            print_cell(p, d->name, column[k], n, &c);
            well = well && c.end != RUN_FAILED;
            if (c.bytes_per_point > bytes[k])
                bytes[k] = c.bytes_per_point;
        }
    }
    printf("\n%-11s", "bytes/point");
    for (int k = 0; k < columns; k++)
        if (bytes[k] >= 0)
            printf(" %15.0f", bytes[k]);
        else
            printf(" %15s", "-");
    putchar('\n');
    memory_free(points);
    return well;
}

/* ---- What is asked. ---- */

/* Reads a word that is no option into the plan. */
static void
read_word(plan *p, const char *word)
{
    char *end;
    unsigned long n = strtoul(word, &end, 10);
    if (*end == '\0' && n >= 1 && n < UINT32_MAX && p->sizes < MOST_SIZES) {
        p->size[p->sizes++] = (uint32_t)n;
        return;
    }
    for (const distribution *d = distributions; d->name != NULL; d++)
        if (strcmp(d->name, word) == 0) {
            p->only_distribution = d;
            return;
        }
    p->only_algorithm = contents_find(word);
    if (p->only_algorithm == NULL)
        refuse("there is no size, distribution or algorithm", word);
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

static plan
read_plan(int argc, char **argv)
{
    plan p = {.runs = 5, .seconds = 30, .folder = "build/bench"};
    for (int option; (option = getopt(argc, argv, "r:t:o:")) != -1;)
        if (option == 'r')
            p.runs = read_count(optarg, MOST_RUNS);
        else if (option == 't')
            p.seconds = read_count(optarg, 86400);
        else if (option == 'o')
            p.folder = optarg;
        else
            refuse("the options are", "-r, -t and -o");
    while (optind < argc)
        read_word(&p, argv[optind++]);
    if (p.sizes == 0) {
        p.size[p.sizes++] = 100000;
        p.size[p.sizes++] = 1000000;
    }
    return p;
}

int
main(int argc, char **argv)
{
    char path[512];
    bool well = true;
    plan p = read_plan(argc, argv);
    snprintf(path, sizeof path, "%s/bench.csv", p.folder);
    p.csv = fopen(path, "w");
    if (p.csv == NULL)
        refuse("cannot write", path);
    fputs("distribution,points,algorithm,end,runs,least,median,sort_least,"
          "sort_median,ratio,ratio_of_medians,bytes_per_point\n", p.csv);

    printf("%u runs each; processor time over that of the yardstick: least, median\n",
           p.runs);
    for (int i = 0; i < p.sizes; i++)
        well = print_table(&p, p.size[i]) && well;
    printf("\nthe times themselves: %s\n", path);
    return fclose(p.csv) == 0 && well ? 0 : 1;
}
