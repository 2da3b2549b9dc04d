/* contestants.h - who takes part in the comparison, and on which points.
 *
 * Needs: chapters/contents.h, tools/tri/tri.h.
 *
 * These are the rows of the table of algorithms that give Delaunay triangulations, with
 * the default options, whatever rows there are; and two that the notes speak of and
 * that differ from a row by an option: Lawson's insertion with a walk from the point
 * before, and divide and conquer with alternating cuts.
 */
#ifndef TOOLS_COMPARE_CONTESTANTS_H
#define TOOLS_COMPARE_CONTESTANTS_H

#include "tools/tri/tri.h"

enum { MOST_CONTESTANTS = 16, LEAST_POINTS = 1024, MOST_POINTS = 131072 };

typedef struct contestant {
    const char *name;
    const algorithm *algorithm;
    tri_options options;
} contestant;

/* Fills the array; returns how many there are. */
int contestants(contestant list[MOST_CONTESTANTS]);

/* The distributions of the comparison, by their names; NULL is the last. */
extern const char *const compared_distributions[];

/* n points of that distribution, seed 1, or a message and the end of the program. The
 * caller frees them. */
point2 *compared_points(const char *distribution, uint32_t n);

#endif
