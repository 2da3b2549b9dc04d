/* 3.1.c - the properties of exercises 3.1-a to 3.1-c: Voronoi diagrams. */
#include "tools/checks/checker.h"
#include "tools/checks/diagrams.h"
#include "tools/checks/meshes.h"
#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>

/* Are these sites met one after the other, turning left around p once? */
static void
check_turning(session *s, const site *at, uint32_t p, const uint32_t *around,
              uint32_t count)
{
    for (uint32_t i = 1; i + 1 < count && !failed(s); i++)
        if (!expect(s, is_met_before(at[p], at[around[0]], at[around[i]],
                                     at[around[i + 1]]),
                    "around %lu, turning left from %lu, %lu does not come before %lu",
                    (unsigned long)p, (unsigned long)around[0],
                    (unsigned long)around[i], (unsigned long)around[i + 1])) {
            show_witness(s, p);
            show_witness(s, around[i]);
            show_witness(s, around[i + 1]);
        }
}

/* Are they all the sites that share an edge with p, one at each location? */
static void
check_neighbours(session *s, const site *at, uint32_t n, uint32_t p,
                 const uint32_t *around, uint32_t count)
{
    for (uint32_t q = 0; q < n && !failed(s); q++) {
        if (plane_same(at[p], at[q]))
            continue;
        uint32_t listed = 0;
        for (uint32_t i = 0; i < count; i++)
            listed += plane_same(at[around[i]], at[q]);
        bool shares = share_an_edge(at, n, at[p], at[q]);
        if (!expect(s, listed == shares,
                    "the regions of %lu and %lu %s an edge, and %lu is %s",
                    (unsigned long)p, (unsigned long)q,
                    shares ? "share" : "do not share", (unsigned long)q,
                    listed == 0   ? "not listed"
                    : listed == 1 ? "listed"
                                  : "listed more than once")) {
            show_witness(s, p);
            show_witness(s, q);
        }
    }
}

/* ---- 3.1-a: one region. ---- */

static void
region_is_right(session *s, const site *at, uint32_t n)
{
    if (n == 0)
        return;
    uint32_t p = random_below(trial_random(s), n);
    uint32_t *around = room_for(n, sizeof *around);
    begin_case(s, 'a', at, n);
    give_points(s);
    give_number(s, p);
    if (ask(s) && take_ok(s)) {
        uint32_t count = take_number(s, 0, n - 1, "the number of sites around");
        for (uint32_t i = 0; i < count && !failed(s); i++) {
            around[i] = take_number(s, 0, n - 1, "a site around the region");
            expect(s, failed(s) || !plane_same(at[around[i]], at[p]),
                   "%lu is listed around itself", (unsigned long)p);
            if (!failed(s))
                show_edge(s, SVG_NEW, p, around[i]);
        }
        take_end(s);
        check_neighbours(s, at, n, p, around, failed(s) ? 0 : count);
        if (!failed(s))
            check_turning(s, at, p, around, count);
    }
    free(around);
}

/* ---- 3.1-b: the dual. ---- */

enum { MOST_SITES = 32, MOST_VERTICES = 64, MOST_EDGES = 96 };

/* The answer. */
typedef struct diagram {
    uint32_t vertices, size[MOST_VERTICES], site[MOST_VERTICES][MOST_SITES];
    uint32_t edges, left[MOST_EDGES], right[MOST_EDGES], from[MOST_EDGES],
        to[MOST_EDGES];
    uint32_t cell_size[MOST_SITES], cell[MOST_SITES][MOST_EDGES];
} diagram;

static void
take_vertices(session *s, diagram *d, uint32_t n)
{
    d->vertices = take_number(s, 0, n < 3 ? 0 : 2 * n, "the number of vertices");
    for (uint32_t i = 0; i < d->vertices; i++) {
        d->size[i] = take_number(s, 3, n, "the number of sites of a vertex");
        for (uint32_t k = 0; k < d->size[i]; k++)
            d->site[i][k] = take_number(s, 0, n - 1, "a site of a vertex");
    }
}

/* A vertex, or NONE at infinity. */
static uint32_t
take_end_of_edge(session *s, const diagram *d)
{
    uint32_t end = take_number(s, 0, UINT32_MAX, "the end of an edge");
    expect(s, failed(s) || end == NONE || end < d->vertices,
           "an edge ends at vertex %lu, which there is not", (unsigned long)end);
    return end;
}

static void
take_edges_and_cells(session *s, diagram *d, uint32_t n)
{
    d->edges = take_number(s, 0, 3 * n, "the number of edges");
    for (uint32_t k = 0; k < d->edges; k++) {
        d->left[k] = take_number(s, 0, n - 1, "the site left of an edge");
        d->right[k] = take_number(s, 0, n - 1, "the site right of an edge");
        d->from[k] = take_end_of_edge(s, d);
        d->to[k] = take_end_of_edge(s, d);
    }
    for (uint32_t p = 0; p < n; p++) {
        d->cell_size[p] = take_number(s, 0, d->edges, "the number of edges of a cell");
        for (uint32_t i = 0; i < d->cell_size[p]; i++)
            d->cell[p][i] =
                take_number(s, 0, d->edges > 0 ? d->edges - 1 : 0, "an edge of a cell");
    }
    take_end(s);
}

/* Asks for the dual of a random Delaunay triangulation; false when there is no
 * answer. */
static bool
ask_dual(session *s, const site *at, uint32_t n, diagram *d)
{
    uint32_t path[MOST_SITES];
    triangle_list list = mesh_at_random(trial_random(s), at, n, true);
    keep_triangles(s, list);
    begin_case(s, 'b', at, n);
    give_points(s);
    if (list.count > 0)
        give_triangles(s, list);
    else
        give_path(s, path, path_of(at, n, path));
    if (n == 0 || !ask(s) || !take_ok(s))
        return false;
    take_vertices(s, d, n);
    take_edges_and_cells(s, d, n);
    return !failed(s);
}

/* Is this one of the sites of vertex i? */
static bool
is_on(const diagram *d, const site *at, uint32_t i, site p)
{
    for (uint32_t k = 0; k < d->size[i]; k++)
        if (plane_same(at[d->site[i][k]], p))
            return true;
    return false;
}

/* Each vertex is a circle with no site inside, all of those on it, counterclockwise. */
static void
check_circle(session *s, const site *at, uint32_t n, const diagram *d, uint32_t i)
{
    const uint32_t *v = d->site[i];
    for (uint32_t k = 0; k < d->size[i] && !failed(s); k++) {
        uint32_t a = v[k], b = v[(k + 1) % d->size[i]], c = v[(k + 2) % d->size[i]];
        expect(s, plane_orient(at[a], at[b], at[c]) > 0,
               "the sites of vertex %lu are not counterclockwise at %lu-%lu-%lu",
               (unsigned long)i, (unsigned long)a, (unsigned long)b, (unsigned long)c);
    }
    for (uint32_t p = 0; p < n && !failed(s); p++) {
        int in = plane_incircle(at[v[0]], at[v[1]], at[v[2]], at[p]);
        if (!expect(
                s, in <= 0 && (in == 0) == is_on(d, at, i, at[p]),
                "%lu is %s the circle of vertex %lu, %lu-%lu-%lu, and is %sone of its "
                "sites",
                (unsigned long)p,
                in > 0    ? "inside"
                : in == 0 ? "on"
                          : "outside",
                (unsigned long)i, (unsigned long)v[0], (unsigned long)v[1],
                (unsigned long)v[2], is_on(d, at, i, at[p]) ? "" : "not "))
            for (int w = 0; w < 4; w++)
                show_witness(s, w < 3 ? v[w] : p);
    }
}

/* Every empty circle is one vertex, and no two vertices are the same circle. */
static void
check_vertices(session *s, const site *at, uint32_t n, const diagram *d)
{
    for (uint32_t i = 0; i < d->vertices && !failed(s); i++)
        check_circle(s, at, n, d, i);
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = a + 1; b < n; b++)
            for (uint32_t c = b + 1; c < n && !failed(s); c++) {
                if (plane_orient(at[a], at[b], at[c]) == 0 ||
                    !circle_is_empty(at, n, at[a], at[b], at[c]))
                    continue;
                uint32_t times = 0;
                for (uint32_t i = 0; i < d->vertices; i++)
                    times += is_on(d, at, i, at[a]) && is_on(d, at, i, at[b]) &&
                             is_on(d, at, i, at[c]);
                expect(s, times == 1,
                       "the empty circle of %lu-%lu-%lu is %lu vertices, and not one",
                       (unsigned long)a, (unsigned long)b, (unsigned long)c,
                       (unsigned long)times);
                for (int w = 0; failed(s) && w < 3; w++)
                    show_witness(s, w == 0 ? a : w == 1 ? b : c);
            }
}

/* Is vertex i one of p, q and a third site on this side of pq? */
static bool
is_beside(const diagram *d, const site *at, uint32_t i, site p, site q, int side)
{
    bool third = false;
    for (uint32_t k = 0; k < d->size[i]; k++)
        third = third || plane_orient(p, q, at[d->site[i][k]]) == side;
    return third && is_on(d, at, i, p) && is_on(d, at, i, q);
}

/* "vertex 3", or "infinity". */
static void
name_end(uint32_t end, char text[30])
{
    snprintf(text, 30, end == NONE ? "infinity" : "vertex %lu", (unsigned long)end);
}

/* One end of an edge between p and q: the vertex with both and a third site on this
 * side of pq; infinity when there is none on that side. */
static void
check_end(session *s, const site *at, uint32_t n, const diagram *d, uint32_t k,
          uint32_t end, int side)
{
    site p = at[d->left[k]], q = at[d->right[k]];
    uint32_t wanted = NONE;
    bool any = false;
    char is[30], should[30];
    for (uint32_t c = 0; c < n; c++)
        any = any || plane_orient(p, q, at[c]) == side;
    for (uint32_t i = 0; any && i < d->vertices; i++)
        if (is_beside(d, at, i, p, q, side))
            wanted = i;
    name_end(end, is);
    name_end(wanted, should);
    if (!expect(s, any ? end != NONE && is_beside(d, at, end, p, q, side) : end == NONE,
                "the edge with %lu on its left and %lu on its right %s at %s: a wrong "
                "place, it should at %s",
                (unsigned long)d->left[k], (unsigned long)d->right[k],
                side > 0 ? "ends" : "begins", is,
                any && wanted == NONE ? "a vertex that there is not" : should)) {
        show_witness(s, d->left[k]);
        show_witness(s, d->right[k]);
    }
}

static void
check_edges(session *s, const site *at, uint32_t n, const diagram *d)
{
    for (uint32_t k = 0; k < d->edges && !failed(s); k++) {
        expect(s, !plane_same(at[d->left[k]], at[d->right[k]]),
               "edge %lu is between %lu and %lu, which coincide", (unsigned long)k,
               (unsigned long)d->left[k], (unsigned long)d->right[k]);
        check_end(s, at, n, d, k, d->from[k], -1);
        check_end(s, at, n, d, k, d->to[k], +1);
    }
    for (uint32_t p = 0; p < n; p++)
        for (uint32_t q = p + 1; q < n && !failed(s); q++) {
            if (plane_same(at[p], at[q]))
                continue;
            uint32_t times = 0;
            for (uint32_t k = 0; k < d->edges; k++)
                times += (plane_same(at[d->left[k]], at[p]) &&
                          plane_same(at[d->right[k]], at[q])) ||
                         (plane_same(at[d->left[k]], at[q]) &&
                          plane_same(at[d->right[k]], at[p]));
            bool shares = share_an_edge(at, n, at[p], at[q]);
            if (!expect(s, times == shares,
                        "%lu and %lu %s an edge, and %lu are listed", (unsigned long)p,
                        (unsigned long)q, shares ? "share" : "do not share",
                        (unsigned long)times)) {
                show_witness(s, p);
                show_witness(s, q);
            }
        }
}

/* The cell of p, turning left around it: of the copies at one location one has it. */
static void
check_cell(session *s, const site *at, uint32_t n, const diagram *d, uint32_t p)
{
    uint32_t around[MOST_EDGES], size = d->cell_size[p];
    for (uint32_t q = 0; q < n; q++)
        if (q != p && plane_same(at[p], at[q]) && d->cell_size[q] > 0 && size == 0)
            return;
    for (uint32_t i = 0; i < size && !failed(s); i++) {
        uint32_t k = d->cell[p][i];
        expect(s, d->left[k] == p || d->right[k] == p,
               "edge %lu is in the cell of %lu, and lies between %lu and %lu",
               (unsigned long)k, (unsigned long)p, (unsigned long)d->left[k],
               (unsigned long)d->right[k]);
        around[i] = d->left[k] == p ? d->right[k] : d->left[k];
    }
    if (failed(s))
        return;
    check_neighbours(s, at, n, p, around, size);
    if (!failed(s))
        check_turning(s, at, p, around, size);
}

static void
vertices_are_right(session *s, const site *at, uint32_t n)
{
    static diagram d;
    if (ask_dual(s, at, n, &d))
        check_vertices(s, at, n, &d);
}

static void
edges_are_right(session *s, const site *at, uint32_t n)
{
    static diagram d;
    if (ask_dual(s, at, n, &d))
        check_edges(s, at, n, &d);
}

static void
cells_are_right(session *s, const site *at, uint32_t n)
{
    static diagram d;
    if (ask_dual(s, at, n, &d))
        for (uint32_t p = 0; p < n && !failed(s); p++)
            check_cell(s, at, n, &d, p);
}

static void
diagram_is_right(session *s, const site *at, uint32_t n)
{
    static diagram d;
    if (!ask_dual(s, at, n, &d))
        return;
    check_vertices(s, at, n, &d);
    check_edges(s, at, n, &d);
    for (uint32_t p = 0; p < n && !failed(s); p++)
        check_cell(s, at, n, &d, p);
}

/* ---- 3.1-c: the nearest site. ---- */

/* Is no site nearer than the answer? The last point is the one that is asked about. */
static void
check_nearest(session *s, const site *at, uint32_t n, triangle_list list)
{
    uint32_t x = n - 1, start;
    uint32_t *path = room_for(n, sizeof *path);
    begin_case(s, 'c', at, n);
    give_points(s);
    if (list.count > 0) {
        start = list.corner[random_below(trial_random(s), list.count)][0];
        give_triangles(s, list);
    } else {
        uint32_t length = path_of(at, x, path);
        start = path[random_below(trial_random(s), length)];
        give_path(s, path, length);
    }
    give_number(s, x);
    give_number(s, start);
    free(path);
    if (!ask(s))
        return;
    uint32_t nearest = take_number(s, 0, x - 1, "the nearest site");
    take_end(s);
    for (uint32_t p = 0; p < x && !failed(s); p++)
        if (!expect(s, plane_length2(at[x], at[nearest]) <= plane_length2(at[x], at[p]),
                    "%lu is nearer to %lu than your %lu", (unsigned long)p,
                    (unsigned long)x, (unsigned long)nearest)) {
            show_witness(s, x);
            show_witness(s, p);
            show_witness(s, nearest);
        }
}

static void
nearest_is_right(session *s, const site *at, uint32_t n)
{
    if (n < 2)
        return;
    triangle_list list = mesh_at_random(trial_random(s), at, n - 1, true);
    keep_triangles(s, list);
    check_nearest(s, at, n, list);
}

enum { SIDE = 24 };

/* The squares of a grid, 10 apart, each cut along the same diagonal: a Delaunay
 * triangulation of 576 sites. A walk has at most 2 * 24 steps, past 6 neighbours
 * each. */
static void
walk_is_short(session *s, const site *p, uint32_t n)
{
    static site at[SIDE * SIDE + 1];
    (void)p, (void)n;
    triangle_list list = {0};
    list.corner = room_for(2 * (SIDE - 1) * (SIDE - 1), sizeof *list.corner);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        at[i] = (site){10 * (int32_t)(i % SIDE), 10 * (int32_t)(i / SIDE)};
        if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1)
            continue;
        const vertex_id lower[3] = {i, i + 1, i + SIDE + 1};
        const vertex_id upper[3] = {i, i + SIDE + 1, i + SIDE};
        for (int c = 0; c < 3; c++) {
            list.corner[list.count][c] = lower[c];
            list.corner[list.count + 1][c] = upper[c];
        }
        list.count += 2;
    }
    keep_triangles(s, list);
    at[SIDE * SIDE] = (site){(int32_t)random_below(trial_random(s), 10 * SIDE),
                             (int32_t)random_below(trial_random(s), 10 * SIDE)};
    check_nearest(s, at, SIDE * SIDE + 1, list);
    expect(
        s, asked_in_all(s) <= 12 * SIDE + 6,
        "%llu comparisons in a grid of %d x %d sites: a walk to the nearest neighbour "
        "needs at most %d",
        (unsigned long long)asked_in_all(s), SIDE, SIDE, 12 * SIDE + 6);
}

enum { DIFFERENT = CASES_GENERAL | CASES_CONVEX };

const property properties[] = {
    {"3.1-a", "region",
     "The sites around a region are those that share an edge with it, counterclockwise",
     "notes 3.1, Definition 5; page 3.1, sec3.1.P1", DIFFERENT, 24, 300, true,
     region_is_right},
    {"3.1-a", "degenerate",
     "The sites around a region are right on grids, circles and lines, too, where "
     "bisectors meet in one point, and with copies",
     "page 3.1, where it breaks", CASES_DEGENERATE, 20, 400, true, region_is_right},
    {"3.1-b", "vertices", "Each vertex is one empty circle, with all the sites on it",
     "notes 3.1, Definition 6; page 3.1, sec3.1.P5", DIFFERENT, 20, 80, true,
     vertices_are_right},
    {"3.1-b", "edges",
     "Two sites share an edge when they should, from the right vertex to the right "
     "vertex",
     "notes 3.1, the dual; voronoi.h, voronoi_edge", DIFFERENT, 20, 80, true,
     edges_are_right},
    {"3.1-b", "cells", "The cell of a site has its edges, counterclockwise",
     "voronoi.h, voronoi", DIFFERENT, 20, 80, true, cells_are_right},
    {"3.1-b", "degenerate",
     "The diagram is right on grids, circles and lines, and with copies: circles that "
     "are the same are one vertex",
     "page 3.1, sec3.1.P5", CASES_DEGENERATE, 16, 200, true, diagram_is_right},
    {"3.1-c", "nearest", "No site is nearer than the answer",
     "notes 3.1, the post-office problem; page 3.1, sec3.1.P14",
     DIFFERENT | CASES_DEGENERATE, 24, 200, true, nearest_is_right},
    {"3.1-c", "comparisons",
     "The walk goes from neighbour to neighbour, and does not look at all sites",
     "page 3.1, what it costs", CASES_FEW, 3, 20, true, walk_is_short},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
