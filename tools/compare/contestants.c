/* contestants.c - who takes part in the comparison, and on which points. */
#include "tools/compare/contestants.h"

#include "lib/memory.h"

#include <stdlib.h>
#include <string.h>

const char *const compared_distributions[] = {"uniform", "normal",   "clusters",
                                              "kuzmin",  "circle", "near-line", NULL};

int
contestants(contestant list[MOST_CONTESTANTS])
{
    int count = 0;
    for (uint32_t i = 0; i < contents_count && count + 2 <= MOST_CONTESTANTS; i++) {
        const algorithm *a = &contents[i];
        contestant row = {a->name, a, tri_options_default()}, other = row;
        if (!a->delaunay || a->most < LEAST_POINTS)
            continue;
        if (strcmp(a->name, "incremental") == 0) {
            other.name = "walk";
            other.options.locator = TRI_LOCATOR_WALK;
            list[count++] = other;
        }
        list[count++] = row;
        if (strcmp(a->name, "divide") == 0) {
            other.name = "alternating";
            other.options.cuts = TRI_CUTS_ALTERNATING;
            list[count++] = other;
        }
    }
    return count;
}

point2 *
compared_points(const char *name, uint32_t n)
{
    point2 *points = memory_array(n, sizeof *points);
    const distribution *d = distributions;
    while (d->name != NULL && strcmp(d->name, name) != 0)
        d++;
    if (points == NULL || d->name == NULL) {
        fprintf(stderr, "compare: no points of the distribution %s\n", name);
        exit(2);
    }
    random_source source = random_from_seed(1);
    d->fill(points, n, &source);
    return points;
}
