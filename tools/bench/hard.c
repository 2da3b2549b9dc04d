/* hard.c - inputs of which one might be afraid, and what they cost. */
#include "tools/bench/hard.h"

#include "lib/memory.h"

#include <stdlib.h>

/* ---- The inputs. ---- */

static void
fill_copies(point2 *points, uint32_t n, random_source *source)
{
    point2 p = random_point(source);
    for (uint32_t i = 0; i < n; i++)
        points[i] = p;
}

static void
fill_sorted_line(point2 *points, uint32_t n, random_source *source)
{
    (void)source;
    for (uint32_t i = 0; i < n; i++)
        points[i] = (point2){i, i};
}

static void
fill_shuffled_line(point2 *points, uint32_t n, random_source *source)
{
    fill_sorted_line(points, n, source);
    shuffle_points(points, n, source);
}

static void
fill_tenfold(point2 *points, uint32_t n, random_source *source)
{
    uint32_t places = n / 10 + 1;
    for (uint32_t i = 0; i < n; i++)
        points[i] = i < places ? random_point(source)
                               : points[random_below(source, places)];
}

static void
fill_integers(point2 *points, uint32_t n, random_source *source)
{
    for (uint32_t i = 0; i < n; i++) {
        points[i].x = random_below(source, 1000);
        points[i].y = random_below(source, 1000);
    }
}

static void
fill_scaled(point2 *points, uint32_t n, random_source *source, double scale)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 p = random_point(source);
        points[i] = (point2){scale * p.x, scale * p.y};
    }
}

static void
fill_huge(point2 *points, uint32_t n, random_source *source)
{
    fill_scaled(points, n, source, 1e300);
}

static void
fill_subnormal(point2 *points, uint32_t n, random_source *source)
{
    fill_scaled(points, n, source, 0x1p-1040);
}

const distribution hard_inputs[] = {
    {"copies", fill_copies, "one point, again and again"},
    {"sorted", fill_sorted_line, "(i,i), in their order along the line"},
    {"shuffled", fill_shuffled_line, "(i,i), in random order"},
    {"tenfold", fill_tenfold, "uniform, each location about ten times"},
    {"integers", fill_integers, "x and y integers, uniform in 0 .. 999"},
    {"huge", fill_huge, "x and y uniform in [0,1e300)"},
    {"subnormal", fill_subnormal, "x and y uniform in [0,2^-1040)"},
    {NULL, NULL, NULL},
};

/* ---- What they cost. ---- */

/* The counts that the program `tiers` prints. */
static bool
count_tiers(const bench *b, const char *path, tier_counts *t)
{
    char call[1000], line[400];
    snprintf(call, sizeof call, "'%s/tiers' %s '%s'", b->folder,
             subject()->name, path);
    fflush(NULL);
    FILE *pipe = popen(call, "r");
    if (pipe == NULL)
        return false;
    bool found = fgets(line, sizeof line, pipe) != NULL &&
                 sscanf(line, "%lf %lf %lf %lf %lf %lf %lf", &t->orient2d,
                        &t->incircle, &t->others, &t->signs, &t->expansions,
                        &t->wide, &t->zeros) == 7;
    return pclose(pipe) == 0 && found;
}

/* Where the filters of 3.4 decide nothing, a certificate takes seconds. */
enum { MOST_SECONDS = 60 };

/* A first run, which is certified; then the counts. */
static void
begin_hard(const bench *b, const char *path, const point2 *points, uint32_t n,
           hard_result *h)
{
    run r = measure(subject(), NULL, points, n, MOST_SECONDS, true);
    h->end = r.end == RUN_DONE && !r.answer.right ? RUN_FAILED : r.end;
    h->seconds = r.times.user;
    write_point_file(path, points, n);
    h->counted = h->end == RUN_DONE && count_tiers(b, path, &h->tiers);
}

/* Uniform points are measured in the same rounds: result[0] is theirs. */
void
measure_hard(const bench *b, uint32_t n, hard_result *result)
{
    enum { ROUNDS = 3 };
    char path[400];
    snprintf(path, sizeof path, "%s/points.bin", b->folder);
    result[0] = (hard_result){.input = &distributions[0]};
    for (int k = 1; k < HARD_INPUTS; k++)
        result[k] = (hard_result){.input = &hard_inputs[k - 1]};
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < HARD_INPUTS; k++) {
            hard_result *h = &result[k];
            point2 *points = make_points(h->input, n);
            if (round == 0) {
                begin_hard(b, path, points, n, h);
            } else if (h->end == RUN_DONE) {
                run r =
                    measure(subject(), NULL, points, n, MOST_SECONDS, false);
                if (r.end == RUN_DONE && r.times.user < h->seconds)
                    h->seconds = r.times.user;
            }
            memory_free(points);
        }
}

void
print_hard(const hard_result *result, uint32_t n)
{
    printf("\n%s: %lu points; time over that of uniform ones; for each point, the\n"
           "orientation and incircle tests, and the determinants that the filter\n"
           "left to the signs of products, to expansions, to wide numbers; those\n"
           "that were 0:\n%-10s %6s %8s %8s %8s %10s %8s %8s\n",
           subject()->name, (unsigned long)n, "", "time", "orient.", "incircle",
           "signs", "expansions", "wide", "zeros");
    for (int k = 0; k < HARD_INPUTS; k++) {
        const hard_result *h = &result[k];
        const tier_counts *t = &h->tiers;
        printf("%-10s ", h->input->name);
        if (h->end != RUN_DONE)
            printf("%s\n",
                   h->end == RUN_TOO_LONG ? "stopped at the limit" : "failed");
        else if (!h->counted)
            printf("%6.2f not counted\n", h->seconds / result[0].seconds);
        else
            printf("%6.2f %8.3f %8.3f %8.3f %10.3f %8.3f %8.3f\n",
                   h->seconds / result[0].seconds, t->orient2d / n,
                   t->incircle / n, t->signs / n, t->expansions / n,
                   t->wide / n, t->zeros / n);
    }
}
