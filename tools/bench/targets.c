/* targets.c - what the project wants to reach, and whether it has been seen. */
#include "tools/bench/graphs.h"
#include "tools/bench/hard.h"
#include "tools/bench/pair.h"

#include "lib/memory.h"

#include <string.h>

/* ---- Lines. ---- */

static void
print_line(bool passes, const char *what, double seen, const char *aim,
           double limit)
{
    printf("%s  %-58s %6.2f  (%s %.2f)\n", passes ? "PASS" : "FAIL", what, seen,
           aim, limit);
}

static void
at_most(const char *what, double seen, double limit)
{
    print_line(seen <= limit, what, seen, "at most", limit);
}

static void
at_least(const char *what, double seen, double limit)
{
    print_line(seen >= limit, what, seen, "at least", limit);
}

static void
not_seen(const char *what)
{
    printf("----  %-58s not measured\n", what);
}

/* How many times the user time of `slow` is that of `fast`; 0 when not
 * measured. */
static double
times_as_long(const bench *b, uint32_t n, const char *input, const char *slow,
              const char *fast)
{
    const cell *s = find_cell(b, n, input, slow),
               *f = find_cell(b, n, input, fast);
    return s != NULL && f != NULL ? s->user.least / f->user.least : 0;
}

/* ---- Seen in the table. ---- */

static const char *const seven[] = {"uniform", "normal", "clusters", "grid",
                                    "circle",  "kuzmin", "near-line"};
enum { SEVEN = sizeof seven / sizeof seven[0] };

/* A peer that was stopped has taken at least as long as it was allowed. */
static void
compare_with_cgal(const bench *b, uint32_t n)
{
    char what[100];
    for (int i = 0; i < SEVEN; i++) {
        double ratio = times_as_long(b, n, seven[i], "cgal", subject()->name);
        const cell *ours = find_cell(b, n, seven[i], subject()->name);
        if (ratio == 0 && ours != NULL && was_stopped(b, n, seven[i], "cgal"))
            ratio = b->seconds / ours->user.least;
        snprintf(what, sizeof what, "%s %lu: CGAL's time over ours", seven[i],
                 (unsigned long)n);
        if (ratio == 0)
            not_seen(what);
        else
            at_least(what, ratio, i == 0 ? 2.3 : 1);
    }
}

static void
compare_with_sorting(const bench *b, uint32_t n)
{
    char what[100];
    double ratio = times_as_long(b, n, "uniform", subject()->name, "std_sort");
    snprintf(what, sizeof what, "uniform %lu: ours over std::sort",
             (unsigned long)n);
    if (ratio == 0)
        not_seen(what);
    else
        at_most(what, ratio, 3.4);
}

static void
compare_with_uniform(const bench *b, uint32_t n)
{
    static const char *const input[] = {"grid", "near-line"};
    char what[100];
    const cell *uniform = find_cell(b, n, "uniform", subject()->name);
    for (int i = 0; i < 2; i++) {
        const cell *c = find_cell(b, n, input[i], subject()->name);
        snprintf(what, sizeof what, "%s %lu: over uniform", input[i],
                 (unsigned long)n);
        if (c == NULL || uniform == NULL)
            not_seen(what);
        else
            at_most(what, c->user.least / uniform->user.least, 1);
    }
}

static void
look_at_memory(const bench *b)
{
    static const char what[] =
        "bytes a point, the most on all inputs from 100000 points";
    double most = -1;
    for (int s = 0; s < b->sizes; s++)
        for (int i = 0; i < b->inputs && b->size[s] >= 100000; i++) {
            const cell *c = find_cell(b, b->size[s], b->input[i]->name,
                                      subject()->name);
            if (c != NULL && c->bytes_per_point > most)
                most = c->bytes_per_point;
        }
    if (most < 0)
        not_seen(what);
    else
        at_most(what, most, 128);
}

static void
look_at_table(const bench *b)
{
    for (uint32_t n = 100000; n <= 1000000; n *= 10) {
        compare_with_cgal(b, n);
        compare_with_sorting(b, n);
        compare_with_uniform(b, n);
    }
    double biased = times_as_long(b, 1000000, "uniform", "biased", "yardstick");
    if (biased == 0)
        not_seen("uniform 1000000: biased over the yardstick");
    else
        at_most("uniform 1000000: biased over the yardstick", biased, 12);
    double sort = times_as_long(b, 1000000, "uniform", "yardstick", "std_sort");
    if (sort == 0)
        not_seen("uniform 1000000: the yardstick over std::sort");
    else
        at_most("uniform 1000000: the yardstick over std::sort", sort, 1.15);
    look_at_memory(b);
}

/* ---- Measured for the purpose. ---- */

/* The whole program, from a text of a million points to an .ele file, and the
 * work in memory, in turns. */
static void
compare_with_text(const bench *b)
{
    enum { RUNS = 3 };
    static const char what[] =
        "uniform 1000000: text to .ele, over the work in memory";
    const uint32_t n = 1000000;
    char tri[400], in[400], out[400], said[400];
    snprintf(tri, sizeof tri, "%s/../tri", b->folder);
    snprintf(in, sizeof in, "%s/points.node", b->folder);
    snprintf(out, sizeof out, "%s/points.ele", b->folder);
    snprintf(said, sizeof said, "%s/said.txt", b->folder);
    point2 *points = make_points(&distributions[0], n);
    output o = {0};
    if (output_begin(&o, in) != TRI_OK)
        refuse("cannot write", in);
    text_write_points(o.file, points, n, 0);
    if (output_commit(&o) != TRI_OK)
        refuse("cannot write", in);
    const char *const words[] =
        {tri, "triangulate", "--algorithm", subject()->name, "-o", out,
         in,  NULL};
    double text[RUNS], memory[RUNS];
    bool well = true;
    for (int k = 0; k < RUNS; k++) {
        run program = measure_program(words, said, b->seconds);
        run call = measure(subject(), NULL, points, n, b->seconds, false);
        well = well && program.end == RUN_DONE && call.end == RUN_DONE;
        text[k] = program.times.user;
        memory[k] = call.times.user;
    }
    memory_free(points);
    remove(in);
    remove(out);
    if (well)
        at_most(what,
                summarize(text, RUNS).least / summarize(memory, RUNS).least, 3);
    else
        not_seen(what);
}

static void
look_at_hard_inputs(const bench *b)
{
    enum { POINTS = 100000 };
    hard_result result[HARD_INPUTS];
    char what[100];
    measure_hard(b, POINTS, result);
    print_hard(result, POINTS);
    printf("\n");
    for (int k = 1; k < HARD_INPUTS; k++) {
        snprintf(what, sizeof what, "%s %d: over uniform",
                 result[k].input->name, POINTS);
        if (result[k].end == RUN_DONE && result[0].end == RUN_DONE)
            at_most(what, result[k].seconds / result[0].seconds, 3);
        else
            printf("FAIL  %-58s stopped, or wrong\n", what);
    }
}

/* Each graph on uniform points, and on the other inputs the dearest of the four. */
static void
look_at_graphs(const bench *b)
{
    const uint32_t n = 1000000;
    char what[100];
    for (const distribution *d = distributions; d->name != NULL; d++) {
        double ratio[GRAPHS];
        if (!measure_graphs(b, d, n, ratio)) {
            printf("FAIL  the graphs of %lu points of %s: stopped\n",
                   (unsigned long)n, d->name);
            continue;
        }
        bool uniform = d == distributions; /* the first */
        int dearest = 0;
        for (int g = 0; g < GRAPHS; g++)
            dearest = ratio[g] > ratio[dearest] ? g : dearest;
        for (int g = 0; g < GRAPHS; g++) {
            snprintf(what, sizeof what, "%s %lu: %s, triangulated, over sorting",
                     d->name, (unsigned long)n, graph_name[g]);
            if (uniform || g == dearest)
                at_most(what, ratio[g], uniform ? 12 : 30);
        }
    }
}

/* ---- All of them. ---- */

void
print_targets(const bench *b)
{
    look_at_hard_inputs(b);
    look_at_table(b);
    look_at_graphs(b);
    compare_with_text(b);
    compare_threads(b);
}
