/* trees.c - spanning trees, and short ones. */
#include "tools/checks/trees.h"

#include "tools/checks/cases.h"
#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>

static uint32_t
root_of(const uint32_t *parent, uint32_t v)
{
    while (parent[v] != v)
        v = parent[v];
    return v;
}

/* Copies of one point belong together from the start. */
static uint32_t *
classes_of(const site *points, uint32_t n)
{
    uint32_t *parent = room_for(n, sizeof *parent);
    for (uint32_t i = 0; i < n; i++) {
        parent[i] = i;
        for (uint32_t j = 0; j < i && parent[i] == i; j++)
            if (plane_same(points[i], points[j]))
                parent[i] = j;
    }
    return parent;
}

static verdict
about_edge(verdict v, tree_edge e)
{
    return verdict_with(verdict_with(v, e.a), e.b);
}

verdict
certify_spanning(const site *points, uint32_t n, const tree_edge *edge, uint32_t count)
{
    verdict v = verdict_holds();
    uint32_t *parent = classes_of(points, n), *lowest = room_for(n, sizeof *lowest);
    uint32_t locations = cases_locations(points, n, lowest);
    for (uint32_t k = 0; v.holds && k < count; k++) {
        uint32_t a = root_of(parent, edge[k].a), b = root_of(parent, edge[k].b);
        if (a == b)
            v = about_edge(verdict_refuted("edge %lu-%lu closes a cycle",
                                           (unsigned long)edge[k].a,
                                           (unsigned long)edge[k].b),
                           edge[k]);
        parent[a] = b;
    }
    if (v.holds && count + 1 != locations && (count > 0 || locations > 0))
        v = verdict_refuted("%lu edges for %lu locations", (unsigned long)count,
                            (unsigned long)locations);
    free(parent);
    free(lowest);
    return v;
}

/* The edge of the longest length on each way from `from`: longest[v], or -1. */
static void
walk_from(const site *points, uint32_t n, const tree_edge *edge, uint32_t count,
          uint32_t from, int64_t *longest)
{
    for (uint32_t v = 0; v < n; v++)
        longest[v] = plane_same(points[v], points[from]) ? 0 : -1;
    for (bool grown = true; grown;) { /* a tree of small depth, or a few more rounds */
        grown = false;
        for (uint32_t k = 0; k < count; k++) {
            int64_t length = plane_length2(points[edge[k].a], points[edge[k].b]);
            int64_t a = longest[edge[k].a], b = longest[edge[k].b];
            if ((a < 0) == (b < 0))
                continue;
            int64_t there = a < 0 ? b : a;
            uint32_t next = a < 0 ? edge[k].a : edge[k].b;
            for (uint32_t v = 0; v < n; v++) /* and at its copies */
                if (plane_same(points[v], points[next]))
                    longest[v] = there > length ? there : length;
            grown = true;
        }
    }
}

verdict
certify_minimum(const site *points, uint32_t n, const tree_edge *edge, uint32_t count)
{
    verdict v = verdict_holds();
    int64_t *longest = room_for(n, sizeof *longest);
    for (uint32_t p = 0; v.holds && p < n; p++) {
        walk_from(points, n, edge, count, p, longest);
        for (uint32_t q = p + 1; v.holds && q < n; q++)
            if (plane_length2(points[p], points[q]) < longest[q])
                v = about_edge(
                    verdict_refuted("%lu and %lu are closer together than the longest "
                                    "edge on the way between them in the tree",
                                    (unsigned long)p, (unsigned long)q),
                    (tree_edge){p, q});
    }
    free(longest);
    return v;
}
