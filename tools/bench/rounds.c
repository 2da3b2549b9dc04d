/* rounds.c - all contenders on one set of points, in turns: A B C A B C. What
 * slows the machine down slows down all of them. */
#include "tools/bench/bench.h"

#include "lib/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Measuring. ---- */

/* For more points only the answer of the subject is certified: it takes time,
 * and the tests look at the others. For still more not even that: a certificate
 * takes some 200 bytes a point. */
enum { MOST_CERTIFIED = 100000, MOST_OF_SUBJECT = 20000000 };

/* The times of all runs of one cell. */
typedef struct samples {
    double user[MOST_RUNS], processor[MOST_RUNS], wall[MOST_RUNS];
    double spent;
} samples;

/* Is there no hope that it ends in time? Sorting points is n log n, and all
 * that is done here takes at least as long. */
static bool
is_hopeless(const bench *b, int s, int i, int c)
{
    if (s == 0)
        return false;
    const cell *before = &b->cell[s - 1][i][c];
    double n = b->size[s], less = b->size[s - 1];
    double growth = n * log(n) / (less * log(less));
    return before->state == CELL_TOO_LONG || before->state == CELL_HOPELESS ||
           (before->state == CELL_MEASURED &&
            growth * before->processor.least > b->seconds);
}

static cell_state
state_before(const bench *b, int s, int i, int c)
{
    const algorithm *a = b->contender[c].algorithm;
    if (a != NULL && b->size[s] > a->most)
        return CELL_TOO_MANY;
    return is_hopeless(b, s, i, c) ? CELL_HOPELESS : CELL_MEASURED;
}

/* The slow ones are run once, the fast ones as often as has been asked for. The
 * sorts are run in every round, beside those that are compared with them. */
static bool
wants_run(const bench *b, const contender *who, const cell *c, const samples *v)
{
    return c->state == CELL_MEASURED &&
           (who->sorts || c->runs == 0 || v->spent < b->spend);
}

static void
run_once(const bench *b, const contender *who, const point2 *points, uint32_t n,
         const char *path, cell *c, samples *v)
{
    bool first = c->runs == 0;
    uint32_t most =
        who->algorithm == subject() ? MOST_OF_SUBJECT : MOST_CERTIFIED;
    bool certify = first && n <= most;
    run r = who->program[0] != '\0'
                ? measure_peer(who->program, path, b->seconds, certify)
                : measure(who->algorithm, NULL, points, n, b->seconds, certify);
    if (r.end != RUN_DONE) {
        c->state = r.end == RUN_TOO_LONG ? CELL_TOO_LONG : CELL_FAILED;
        return;
    }
    if (first)
        c->answer = r.answer;
    if (r.times.bytes / n > c->bytes_per_point)
        c->bytes_per_point = r.times.bytes / n;
    v->user[c->runs] = r.times.user;
    v->processor[c->runs] = r.times.processor;
    v->wall[c->runs++] = r.times.wall;
    double least = stopwatch_least(n);
    v->spent += r.times.processor > least ? r.times.processor : least;
}

/* ---- Printing. ---- */

static const char *
name_of_state(cell_state state)
{
    static const char *const name[] = {
        "", "measured", "not run: slow by design",
        "not run: too slow at the size before", "stopped at the limit", "failed"};
    return name[state];
}

/* Over what c has taken, or 0 when that has not been measured. */
static double
over(const bench *b, int s, int i, const char *sort, double seconds,
     bool median)
{
    int c = find_contender(b, sort);
    if (c < 0 || b->cell[s][i][c].state != CELL_MEASURED)
        return 0;
    const summary *u = &b->cell[s][i][c].user;
    return seconds / (median ? u->median : u->least);
}

static void
print_number(double value, const char *form, const char *missing)
{
    if (value > 0)
        printf(form, value);
    else
        printf("%s", missing);
}

static void
print_row(const bench *b, int s, int i, int k)
{
    const cell *c = &b->cell[s][i][k];
    printf("  %-12s", b->contender[k].name);
    if (c->state != CELL_MEASURED) {
        printf(" %s\n", name_of_state(c->state));
        return;
    }
    printf(" %9.3f %9.3f %9.3f %4u", 1e3 * c->user.least, 1e3 * c->user.median,
           1e3 * c->wall.least, c->runs);
    print_number(over(b, s, i, "yardstick", c->user.least, false), " %9.2f",
                 "         -");
    print_number(over(b, s, i, "std_sort", c->user.least, false), " %9.2f",
                 "         -");
    if (b->contender[k].sorts) /* in place */
        printf("      - ");
    else
        print_number(c->bytes_per_point, " %6.0f ", "      - ");
    printf(" %s\n", c->answer.text);
}

static void
write_csv_row(const bench *b, int s, int i, int k)
{
    const cell *c = &b->cell[s][i][k];
    fprintf(b->csv, "%s,%lu,%s,%s,%u", b->input[i]->name,
            (unsigned long)b->size[s], b->contender[k].name,
            name_of_state(c->state), c->runs);
    if (c->state == CELL_MEASURED) {
        fprintf(b->csv, ",%.9f,%.9f,%.9f,%.9f,%.9f,%.9f", c->user.least,
                c->user.median, c->processor.least, c->processor.median,
                c->wall.least, c->wall.median);
        for (int k2 = 0; k2 < 4; k2++)
            fprintf(b->csv, ",%.4f",
                    over(b, s, i, k2 < 2 ? "yardstick" : "std_sort",
                         k2 % 2 == 0 ? c->user.least : c->user.median,
                         k2 % 2 != 0));
        fprintf(b->csv, ",%.1f,\"%s\"\n", c->bytes_per_point, c->answer.text);
    } else {
        fputs(",,,,,,,,,,,,\n", b->csv);
    }
    fflush(b->csv);
}

/* Sums up, prints and writes; false when one of ours is not right. */
static bool
close_block(bench *b, int s, int i, samples *v)
{
    bool well = true;
    cell *row = b->cell[s][i];
    for (int c = 0; c < b->contenders; c++) {
        bool peer = b->contender[c].program[0] != '\0';
        if (row[c].state == CELL_MEASURED) {
            row[c].user = summarize(v[c].user, row[c].runs);
            row[c].processor = summarize(v[c].processor, row[c].runs);
            row[c].wall = summarize(v[c].wall, row[c].runs);
            well = well && (peer || row[c].answer.right);
        }
        well = well && (peer || row[c].state != CELL_FAILED);
    }
    printf("\n%s, %lu points\n  %-12s %9s %9s %9s %4s %9s %9s %6s\n",
           b->input[i]->name, (unsigned long)b->size[s], "", "user ms",
           "median", "wall ms", "runs", "/yardst.", "/std_sort", "bytes");
    for (int c = 0; c < b->contenders; c++) {
        print_row(b, s, i, c);
        write_csv_row(b, s, i, c);
    }
    fflush(stdout);
    return well;
}

bool
measure_block(bench *b, int s, int i)
{
    static samples v[MOST_CONTENDERS];
    char path[400];
    uint32_t n = b->size[s];
    cell *row = b->cell[s][i];
    point2 *points = make_points(b->input[i], n);
    snprintf(path, sizeof path, "%s/points.bin", b->folder);
    write_point_file(path, points, n);
    for (int c = 0; c < b->contenders; c++) {
        v[c].spent = 0;
        row[c] = (cell){.state = state_before(b, s, i, c),
                        .bytes_per_point = -1};
    }
    for (unsigned round = 0; round < b->runs; round++)
        for (int c = 0; c < b->contenders; c++)
            if (wants_run(b, &b->contender[c], &row[c], &v[c]))
                run_once(b, &b->contender[c], points, n, path, &row[c], &v[c]);
    memory_free(points);

    return close_block(b, s, i, v);
}

/* ---- The ratios of all distributions. ---- */

/* How wide the column of a contender is. */
static int
width_of(const contender *c)
{
    int length = (int)strlen(c->name);
    return length > 8 ? length : 8;
}

/* Has it been measured on any input of this size? */
static bool
has_column(const bench *b, int s, int c)
{
    bool found = false;
    for (int i = 0; i < b->inputs; i++)
        found = found || b->cell[s][i][c].state == CELL_MEASURED;
    return found;
}

void
print_summary(const bench *b, int s)
{
    printf("\n%lu points: user time over that of the yardstick, least of all runs",
           (unsigned long)b->size[s]);
    printf("\n%-11s", "");
    for (int c = 1; c < b->contenders; c++)
        if (has_column(b, s, c))
            printf(" %*s", width_of(&b->contender[c]), b->contender[c].name);
    for (int i = 0; i < b->inputs; i++) {
        printf("\n%-11s", b->input[i]->name);
        for (int c = 1; c < b->contenders; c++) {
            if (!has_column(b, s, c))
                continue;
            const cell *k = &b->cell[s][i][c];
            int width = width_of(&b->contender[c]);
            double ratio = over(b, s, i, "yardstick", k->user.least, false);
            const char *mark = k->answer.right ? "" : "!";
            if (k->state == CELL_MEASURED)
                printf(" %*.2f%s", width - (int)strlen(mark), ratio, mark);
            else
                printf(" %*s", width, k->state == CELL_FAILED ? "failed" : "-");
        }
    }
    printf("\n(! the answer is not right; - not run, or stopped: see above)\n");
}
