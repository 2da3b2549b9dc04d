/* Section 3.7, the comparison: the table behind its pictures counts what the algorithms
 * ask, and says what the page says.
 *
 * Hypotheses: none; the points are those of the comparison, the same everywhere. The
 * lines for up to 4096 points are counted again here; those for more by `make compare`.
 */
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char table_name[] = "chapters/3.7_divide_and_conquer/comparison.csv";

/* A line of the table. */
typedef struct line {
    char of[20], name[20];
    unsigned long n;
    double compare_along, orient2d, incircle; /* a point */
} line;

static bool
next_line(FILE *table, line *l)
{
    char text[200];
    while (fgets(text, sizeof text, table) != NULL)
        if (sscanf(text, "%19[^,],%lu,%19[^,],%lf,%lf,%lf", l->of, &l->n, l->name,
                   &l->compare_along, &l->orient2d, &l->incircle) == 6) {
            l->compare_along /= (double)l->n;
            l->orient2d /= (double)l->n;
            l->incircle /= (double)l->n;
            return true;
        }
    return false;
}

/* Looks for the line of an algorithm, of n points of a distribution. */
static bool
find(const char *name, const char *of, unsigned long n, line *l)
{
    FILE *table = fopen(table_name, "r");
    CLAIM("sec3.7.P14", table != NULL, "there is no %s", table_name);
    bool found = false;
    while (!found && next_line(table, l))
        found = l->n == n && strcmp(l->of, of) == 0 && strcmp(l->name, name) == 0;
    fclose(table);
    return found;
}

static line
asked(const char *name, const char *of, unsigned long n)
{
    line l;
    CLAIM("sec3.7.P14", find(name, of, n, &l), "no line for %s, %s, %lu points", name,
          of, n);
    return l;
}

static double
determinants(const char *name, const char *of, unsigned long n)
{
    line l = asked(name, of, n);
    return l.orient2d + l.incircle;
}

/* What is counted today stands in the table. `fast` is tuned by measurements, and only
 * held to a tenth. */
static bool
is_as_counted(const char *name, double said, double counted)
{
    if (strcmp(name, "fast") == 0)
        return fabs(said - counted) <= 0.1 * said;
    return said == counted;
}

/* P14, for all algorithms that are in the table: a new one gets its lines by
 * `make compare`. */
static void
the_table_counts_what_is_asked(void)
{
    line today, l;
    int lines = 0;
    CLAIM("sec3.7.P14", shell("$build/compare/counts 4096 >$d/counts.csv") == 0,
          "counting has failed");
    FILE *counts = fopen(in_scratch("counts.csv").text, "r");
    CLAIM("sec3.7.P14", counts != NULL, "nothing was counted");
    while (next_line(counts, &today)) {
        if (!find(today.name, today.of, today.n, &l))
            continue;
        CLAIM(
            "sec3.7.P14",
            is_as_counted(l.name, l.orient2d, today.orient2d) &&
                is_as_counted(l.name, l.incircle, today.incircle) &&
                is_as_counted(l.name, l.compare_along, today.compare_along),
            "%s, %lu points, %s: run make compare: counted are %.3f %.3f %.3f, in the "
            "table are %.3f %.3f %.3f",
            l.of, l.n, l.name, today.compare_along, today.orient2d, today.incircle,
            l.compare_along, l.orient2d, l.incircle);
        lines++;
    }
    fclose(counts);
    CLAIM("sec3.7.P14", lines >= 100, "only %d lines were counted", lines);
}

enum { FEW = 4096, MANY = 131072, DOUBLINGS = 5 };

/* P15: how the numbers of questions grow with uniform points. */
static void
how_they_grow(void)
{
    static const char *const constant[] = {"alternating", "biased", "bucketed"};
    for (int i = 0; i < 3; i++) {
        double few = determinants(constant[i], "uniform", FEW),
               many = determinants(constant[i], "uniform", MANY);
        CLAIM("sec3.7.P15", many < 1.05 * few, "%s: %.2f and %.2f", constant[i], few,
              many);
    }
    line few = asked("divide", "uniform", FEW), many = asked("divide", "uniform", MANY);
    double orient = (many.orient2d - few.orient2d) / DOUBLINGS,
           circle = (many.incircle - few.incircle) / DOUBLINGS;
    CLAIM("sec3.7.P15", orient > 1.3 && orient < 1.7 && circle > 1.8 && circle < 2.2,
          "divide: %.2f orientation and %.2f incircle tests more for each doubling",
          orient, circle);
    line small = asked("alternating", "uniform", MANY),
         grid = asked("bucketed", "uniform", MANY);
    CLAIM("sec3.7.P15",
          small.orient2d < grid.orient2d && small.incircle < grid.incircle,
          "alternating cuts ask %.2f and %.2f, the grid %.2f and %.2f", small.orient2d,
          small.incircle, grid.orient2d, grid.incircle);
}

/* P16: location is what the incremental algorithm spends its questions on. */
static void
where_they_go(void)
{
    line few = asked("walk", "uniform", FEW), many = asked("walk", "uniform", MANY),
         grid = asked("bucketed", "uniform", MANY);
    double factor = many.orient2d / few.orient2d; /* 2^(5/2) = 5.66 */
    CLAIM("sec3.7.P16", factor > 5 && factor < 6.3,
          "32 times the points, %.2f times the "
          "orientation tests",
          factor);
    CLAIM("sec3.7.P16", many.incircle == grid.incircle, "%.4f and %.4f incircle tests",
          many.incircle, grid.incircle);
    CLAIM("sec3.7.P16", many.orient2d > 0.95 * (many.orient2d + many.incircle),
          "%.0f orientation and %.0f incircle tests", many.orient2d, many.incircle);
}

/* P17: who is hurt by what is not uniform. */
static void
what_defeats_them(void)
{
    static const char *const of[] = {"uniform", "normal", "clusters",
                                     "kuzmin",  "circle", "near-line"};
    for (int i = 0; i < 5; i++) {
        double d = determinants("alternating", of[i], MANY);
        CLAIM("sec3.7.P17", d < 21, "alternating cuts, %s: %.2f tests", of[i], d);
    }
    for (int i = 0; i < 6; i++) {
        double d = determinants("biased", of[i], MANY);
        CLAIM("sec3.7.P17", d < 25, "the biased order, %s: %.2f tests", of[i], d);
    }
    double grid = determinants("bucketed", "kuzmin", MANY),
           walk = determinants("walk", "kuzmin", MANY);
    CLAIM("sec3.7.P17", grid > 0.9 * walk, "kuzmin: %.0f tests with the grid, %.0f by "
          "walking", grid, walk);
    double vertical = determinants("divide", "near-line", MANY),
           alternating = determinants("alternating", "near-line", MANY);
    CLAIM("sec3.7.P17", 4 * vertical < alternating,
          "near a line: %.2f tests with vertical "
          "cuts, %.2f with alternating ones",
          vertical, alternating);
}

static bool
is_rounded(double said, double counted)
{
    char one[40], other[40];
    snprintf(one, sizeof one, "%.1f", said);
    snprintf(other, sizeof other, "%.1f", counted);
    return strcmp(one, other) == 0;
}

/* P14 again: the tables on the page are that table, rounded. */
static void
the_page_says_the_same(void)
{
    char text[400], name[20];
    int lines = 0, sizes = 0;
    FILE *page = fopen("chapters/3.7_divide_and_conquer/README.md", "r");
    CLAIM("sec3.7.P14", page != NULL, "there is no page");
    while (fgets(text, sizeof text, page) != NULL) {
        double along, orient, circle, turning[2];
        unsigned long n;
        if (sscanf(text, "| %lu | %lf | %lf | %lf | %lf |", &n, &orient, &circle,
                   &turning[0], &turning[1]) == 5) {
            line v = asked("divide", "uniform", n),
                 a = asked("alternating", "uniform", n);
            CLAIM("sec3.7.P14",
                  is_rounded(orient, v.orient2d) && is_rounded(circle, v.incircle) &&
                      is_rounded(turning[0], a.orient2d) &&
                      is_rounded(turning[1], a.incircle),
                  "counted for %lu points are %.1f "
                  "%.1f %.1f %.1f",
                  n, v.orient2d, v.incircle, a.orient2d, a.incircle);
            sizes++;
        }
        if (sscanf(text, "| %19[a-z_] | uniform | %lf | %lf | %lf |", name, &along,
                   &orient, &circle) != 4)
            continue;
        line l = asked(name, "uniform", MANY);
        CLAIM("sec3.7.P14", is_rounded(along, l.compare_along) &&
              is_rounded(orient, l.orient2d) && is_rounded(circle, l.incircle),
              "counted for %s are %.1f %.1f %.1f", name, l.compare_along, l.orient2d,
              l.incircle);
        lines++;
    }
    fclose(page);
    CLAIM("sec3.7.P14", lines >= 6 && sizes >= 4,
          "%d and %d lines of the page are understood", lines, sizes);
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "Section 3.7: the comparison");
    test_run("the table", the_table_counts_what_is_asked);
    test_run("the page", the_page_says_the_same);
    test_run("how they grow", how_they_grow);
    test_run("where the questions go", where_they_go);
    test_run("what defeats them", what_defeats_them);
    int status = test_end((test_minima){.trials = 5});
    shell_end();
    return status;
}
