/* cases.h - families of point sets on which a student's function is tried.
 *
 * Coordinates lie in -4096 .. 4096 (plane.h). The same source of random numbers draws
 * the same points everywhere.
 */
#ifndef TOOLS_CHECKS_CASES_H
#define TOOLS_CHECKS_CASES_H

#include "lib/random.h"
#include "tools/checks/plane.h"

/* Families, to be added up. */
enum {
    CASES_GENERAL = 1,     /* in the whole range; as good as never three collinear */
    CASES_GRID = 2,        /* on a small grid: ties of all kinds, no two points equal */
    CASES_COCIRCULAR = 4,  /* many on one circle */
    CASES_COLLINEAR = 8,   /* all on one line */
    CASES_DUPLICATES = 16, /* on a small grid, many of them equal */
    CASES_FEW = 32,        /* none, one, two or three points */
    CASES_CONVEX = 64,     /* all on the hull, on a parabola */
    CASES_DEGENERATE =
        CASES_GRID | CASES_COCIRCULAR | CASES_COLLINEAR | CASES_DUPLICATES | CASES_FEW
};

/* Draws one of the families, at most `most` points of it, in random order; returns how
 * many. Requires: room for `most` points; most >= 3. */
uint32_t
cases_draw(random_source *source, unsigned families, uint32_t most, site *points);

/* In random order. */
void cases_shuffle(random_source *source, site *points, uint32_t n);

/* The lowest index at each location, in increasing order; returns how many
 * locations. */
uint32_t cases_locations(const site *points, uint32_t n, uint32_t *lowest);

/* Do all points lie on one line (or are there fewer than three locations)? */
bool cases_are_collinear(const site *points, uint32_t n);

#endif
