/* counts.c - how many questions does each algorithm ask?
 *
 *     counts [MOST]
 *
 * Prints a table with commas: for 1024, 2048, 4096, ... points, at most MOST (131072
 * if not given), of each distribution, the questions that each algorithm of the
 * comparison asks. One that asks more than 1000 for each point is not tried on more
 * points. The numbers are the same on every machine. The program is linked with the
 * counted library.
 *
 * Exit status: 0 all has been counted; 1 an algorithm has failed; 2 the program
 * cannot run.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "tools/compare/contestants.h"

#include <stdlib.h>

enum { TOO_MANY = 1000 };

/* Prints a line of the table, or ends the program; were the questions few enough? */
static bool
print_counts(const char *of, const contestant *c, const point2 *points, uint32_t n)
{
    mesh m;
    predicate_count = (predicate_counts){0};
    tri_status status = c->algorithm->triangulate(points, n, &c->options, &m);
    mesh_free(&m);
    if (status != TRI_OK) {
        fprintf(stderr, "counts: %s: %s\n", c->name, tri_status_text(status));
        exit(1);
    }
    predicate_counts asked = predicate_count;
    printf("%s,%lu,%s,%llu,%llu,%llu\n", of, (unsigned long)n, c->name,
           (unsigned long long)asked.compare_along,
           (unsigned long long)asked.orient2d, (unsigned long long)asked.incircle);
    fflush(stdout);
    return asked.compare_along + asked.orient2d + asked.incircle <=
           TOO_MANY * (uint64_t)n;
}

/* All algorithms on one distribution. */
static void
print_distribution(const char *of, unsigned long most)
{
    contestant list[MOST_CONTESTANTS];
    bool given_up[MOST_CONTESTANTS] = {false};
    int count = contestants(list);
    for (uint32_t n = LEAST_POINTS; n <= most && n <= MOST_POINTS; n *= 2) {
        point2 *points = compared_points(of, n);
        for (int i = 0; i < count; i++)
            if (!given_up[i] && n <= list[i].algorithm->most)
                given_up[i] = !print_counts(of, &list[i], points, n);
        memory_free(points);
    }
}

int
main(int argc, char **argv)
{
    unsigned long most = argc == 2 ? strtoul(argv[1], NULL, 10) : MOST_POINTS;
    if (argc > 2 || most < LEAST_POINTS) {
        fprintf(stderr, "usage: counts [MOST]\nMOST is at least %d\n", LEAST_POINTS);
        return 2;
    }
    puts("distribution,points,algorithm,compare_along,orient2d,incircle");
    for (int d = 0; compared_distributions[d] != NULL; d++)
        print_distribution(compared_distributions[d], most);
    return 0;
}
