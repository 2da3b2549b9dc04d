/* times.c - how long does each algorithm take, compared with sorting the same points?
 *
 *     times FOLDER [MOST [DISTRIBUTION]]
 *
 * For 4096, 16384, 65536, ... points, at most MOST (262144 if not given), of each
 * distribution or of one: three runs of each algorithm of the comparison and three of
 * the yardstick, in turns, each in a process of its own (tools/bench/measure.h). The
 * ratio of the least processor times is what counts. (A thousand points, sorted again
 * and again, are known by heart to the processor, which guesses each comparison: that
 * would be no yardstick.) Prints a table with commas, writes
 * it to FOLDER/times.csv as well, and draws it: FOLDER/times.svg.
 *
 * Exit status: 0 all has been measured or given up; 1 an algorithm has failed; 2 the
 * program cannot run.
 */
#include "lib/memory.h"
#include "lib/svg_chart.h"
#include "tools/bench/measure.h"
#include "tools/compare/contestants.h"

#include <stdlib.h>
#include <string.h>

enum { RUNS = 3, MOST_SECONDS = 10, LEAST_TIMED = 4096, MOST_TIMED = 262144 };

_Noreturn static void
refuse(const char *what, const char *which)
{
    fprintf(stderr, "times: %s %s\nusage: times FOLDER [MOST [DISTRIBUTION]]\n", what,
            which);
    exit(2);
}

/* The least times of the algorithm and of the yardstick, in turns. */
static run_end
take_turns(const contestant *c, const point2 *points, uint32_t n, double *ours,
           double *sort)
{
    *ours = *sort = 1e300;
    for (int i = 0; i < RUNS; i++) {
        run a = measure(c->algorithm, &c->options, points, n, MOST_SECONDS, false);
        run b = measure(NULL, NULL, points, n, MOST_SECONDS, false);
        if (a.end != RUN_DONE)
            return a.end;
        if (b.end != RUN_DONE)
            refuse("the yardstick", "has not ended well");
        *ours = a.times.processor < *ours ? a.times.processor : *ours;
        *sort = b.times.processor < *sort ? b.times.processor : *sort;
    }
    return RUN_DONE;
}

/* One distribution: who has taken too long is not tried on more points. Returns
 * whether nothing has failed. */
static bool
print_times(FILE *csv, const char *of, uint32_t most)
{
    contestant list[MOST_CONTESTANTS];
    bool given_up[MOST_CONTESTANTS] = {false}, well = true;
    int count = contestants(list);
    for (uint32_t n = LEAST_TIMED; n <= most; n *= 4) {
        point2 *points = compared_points(of, n);
        for (int i = 0; i < count; i++) {
            double ours, sort;
            if (given_up[i] || n > list[i].algorithm->most)
                continue;
            run_end end = take_turns(&list[i], points, n, &ours, &sort);
            given_up[i] = end != RUN_DONE || ours > MOST_SECONDS / 5.0;
            well = well && end != RUN_FAILED;
            if (end != RUN_DONE)
                continue;
            FILE *const to[] = {csv, stdout};
            for (int k = 0; k < 2; k++)
                fprintf(to[k], "%s,%lu,%s,%.6f,%.6f,%.2f\n", of, (unsigned long)n,
                        list[i].name, ours, sort, ours / sort);
            fflush(stdout);
        }
        memory_free(points);
    }
    return well;
}

static FILE *
open_or_refuse(const char *folder, const char *name, const char *mode)
{
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, mode);
    if (file == NULL)
        refuse("cannot open", path);
    return file;
}

static void
draw_times(const char *folder)
{
    chart c;
    FILE *csv = open_or_refuse(folder, "times.csv", "r");
    tri_status status = chart_read(csv, "ratio", false, &c);
    fclose(csv);
    if (status != TRI_OK || c.count == 0)
        refuse("cannot draw", "times.csv");
    FILE *picture = open_or_refuse(folder, "times.svg", "w");
    svg_charts(picture, &c, "Times relative to a sort",
               "For each algorithm of the comparison its processor time, divided by "
               "that of sorting the same points, over the number of points.", "sorts");
    if (fclose(picture) != 0)
        refuse("cannot write", "times.svg");
    chart_free(&c);
}

int
main(int argc, char **argv)
{
    bool well = true;
    if (argc < 2 || argc > 4)
        refuse("wrong number of", "arguments");
    unsigned long most = argc > 2 ? strtoul(argv[2], NULL, 10) : MOST_TIMED;
    if (most < LEAST_TIMED || most > UINT32_MAX / 8)
        refuse("not a number of points that will do:", argv[2]);
    FILE *csv = open_or_refuse(argv[1], "times.csv", "w");
    static const char header[] = "distribution,points,algorithm,seconds,sort,ratio\n";
    fputs(header, csv);
    fputs(header, stdout);
    for (int d = 0; compared_distributions[d] != NULL; d++)
        if (argc < 4 || strcmp(argv[3], compared_distributions[d]) == 0)
            well = print_times(csv, compared_distributions[d], (uint32_t)most) && well;
    if (fclose(csv) != 0)
        refuse("cannot write", "times.csv");
    draw_times(argv[1]);
    return well ? 0 : 1;
}
