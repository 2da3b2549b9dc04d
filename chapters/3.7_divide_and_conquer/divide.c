/* divide.c - dividing the points, by vertical or by alternating cuts. */
#include "chapters/3.7_divide_and_conquer/divide.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/random.h"

/* ---- Vertical cuts: Lee and Schachter. ---- */

/* Up to three points in order: whatever triangulates them is Delaunay. */
static void
triangulate_few(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count < 2)
        return;
    halfedge_id last = start(m, L[0], L[1]);
    if (count == 3)
        attach(m, hull_edges_seeing(m, points, last, L[2]), L[2]);
}

/* Triangulates L[0 .. count-1], which are in order. Four or more points are divided
 * into halves of two or more, so that merge finds an edge on each side. */
static void
divide(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count <= 3) {                                       // Step 1
        triangulate_few(m, points, L, count);
        return;
    }
    uint32_t half = count / 2;
    divide(m, points, L, half);                             // Step 2
    divide(m, points, L + half, count - half);              // Step 3
    if (!m->cancelled)
        merge(m, points, L[half - 1], L[half]);             // Step 4
}

/* ---- Alternating cuts: Dwyer. ---- */

static void
swap(vertex_id *p, vertex_id *q)
{
    vertex_id old = *p;
    *p = *q;
    *q = old;
}

/* Moves the points that come before pivot = L[place] in front of it and the others
 * behind it; returns where the pivot is then. */
static uint32_t
partition(const point2 *points, vertex_id *L, uint32_t count, uint32_t place, point2 d)
{
    vertex_id pivot = L[place];
    uint32_t before = 0;
    swap(&L[place], &L[count - 1]);
    for (uint32_t i = 0; i < count - 1; i++)
        if (compare_along(d, points[L[i]], points[pivot]) < 0)
            swap(&L[i], &L[before++]);
    swap(&L[before], &L[count - 1]);
    return before;
}

void
select_along(const point2 *points, vertex_id *L, uint32_t count, uint32_t k, point2 d,
             random_source *random)
{
    while (count > 1) {
        uint32_t place = partition(points, L, count, random_below(random, count), d);
        if (k <= place) {
            count = k == place ? 0 : place;
        } else {
            L += place + 1;
            count -= place + 1;
            k -= place + 1;
        }
    }
}

/* Triangulates L[0 .. count-1], in whatever order they are. Where the halves meet
 * is known before they are divided along the other axis and put in disorder. */
static void
divide_in_turn(mesh *m, const point2 *points, vertex_id *L, uint32_t count, point2 d,
               random_source *random)
{
    if (count <= 3) {
        for (uint32_t i = 0; i + 1 < count; i++)
            select_along(points, L + i, count - i, 0, d, random);
        triangulate_few(m, points, L, count);
        return;
    }
    uint32_t half = count / 2;
    select_along(points, L, count, half, d, random);
    select_along(points, L, half, half - 1, d, random);
    vertex_id v = L[half - 1], w = L[half];
    const point2 across = {-d.y, d.x};
    divide_in_turn(m, points, L, half, across, random);
    divide_in_turn(m, points, L + half, count - half, across, random);
    if (!m->cancelled)
        merge(m, points, v, w);
}

/* ---- Both. ---- */

tri_status
divide_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                   mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    vertex_id *L = memory_array(n, sizeof *L);
    if (L == NULL)
        return TRI_OUT_OF_MEMORY;

    uint32_t locations;
    status = sort_along(points, n, used.direction, L, &locations);
    if (status == TRI_OK)
        status = mesh_init(out, n, locations);
    if (status == TRI_OK) {
        out->trace = used.trace;
        random_source random = random_from_seed(0);
        if (used.cuts == TRI_CUTS_VERTICAL)
            divide(out, points, L, locations);
        else
            divide_in_turn(out, points, L, locations, used.direction, &random);
    }
    memory_free(L);
    return mesh_finish(out, status);
}
