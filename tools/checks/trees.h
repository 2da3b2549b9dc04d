/* trees.h - (e) of what is enough to check: Euclidean minimum spanning trees. */
#ifndef TOOLS_CHECKS_TREES_H
#define TOOLS_CHECKS_TREES_H

#include "lib/verdict.h"
#include "tools/checks/plane.h"

typedef struct tree_edge {
    uint32_t a, b;
} tree_edge;

/* Does the list join all locations without a cycle? */
verdict certify_spanning(const site *points, uint32_t n, const tree_edge *edge,
                         uint32_t count);

/* Is a spanning tree as short as can be: is no pair of locations closer together than
 * the longest edge on the way between them? Enough: such a tree has the lengths that
 * Kruskal's has. Looks at all pairs, Delaunay or not. Cost: O(n^2). */
verdict certify_minimum(const site *points, uint32_t n, const tree_edge *edge,
                        uint32_t count);

#endif
