/* fast_grid.c - sites sorted into the cells of a grid. */
#include "chapters/3.7_divide_and_conquer/fast_grid.h"

#include "chapters/3.7_divide_and_conquer/fast_share.h"
#include "lib/memory.h"
#include "lib/sort.h"

#include <float.h>
#include <string.h>

fast_box
fast_box_around(const fast_site *site, uint32_t count)
{
    fast_box b = {{site[0].x, site[0].y}, {site[0].x, site[0].y}};
    for (uint32_t i = 1; i < count; i++) {
        double x = site[i].x, y = site[i].y;
        b.low[0] = x < b.low[0] ? x : b.low[0];
        b.low[1] = y < b.low[1] ? y : b.low[1];
        b.high[0] = x > b.high[0] ? x : b.high[0];
        b.high[1] = y > b.high[1] ? y : b.high[1];
    }
    return b;
}

fast_box
fast_box_join(fast_box a, fast_box b)
{
    for (int k = 0; k < 2; k++) {
        a.low[k] = a.low[k] < b.low[k] ? a.low[k] : b.low[k];
        a.high[k] = a.high[k] > b.high[k] ? a.high[k] : b.high[k];
    }
    return a;
}

/* ---- The box of most sites, from a sample. ---- */

enum { SAMPLE = 512 };

/* Narrows the box along an axis to the middle 7/8 of the sample and 1/8 of their
 * extent on both sides: uniform sites lose nothing. */
static void
narrow(fast_box *b, int axis, const fast_site *site, uint32_t count)
{
    sort_item item[2 * SAMPLE];
    uint32_t step = count / SAMPLE;
    for (uint32_t i = 0; i < SAMPLE; i++) {
        const fast_site *s = &site[(size_t)i * step];
        item[i] = (sort_item){sort_key_of(axis == 0 ? s->x : s->y), i * step};
    }
    sort_by_key(item, item + SAMPLE, SAMPLE);
    const fast_site *p = &site[item[SAMPLE / 16].id];
    const fast_site *q = &site[item[SAMPLE - SAMPLE / 16].id];
    double low = axis == 0 ? p->x : p->y, high = axis == 0 ? q->x : q->y;
    double more = (high - low) / 8;
    if (low - more > b->low[axis])
        b->low[axis] = low - more;
    if (high + more < b->high[axis])
        b->high[axis] = high + more;
}

fast_box
fast_box_of_most(const fast_site *site, uint32_t count, fast_box all)
{
    if (count >= SAMPLE) {
        narrow(&all, 0, site, count);
        narrow(&all, 1, site, count);
    }
    return all;
}

/* ---- The grid. ---- */

/* How to find a site's cell. */
typedef struct grid {
    double low[2], scale[2], most[2];    /* coordinate -> column and row */
    uint16_t spread[2][FAST_GRID_CELLS]; /* column, row -> their bits of the number */
} grid;

/* The numbers of all columns (or rows), whose bits go to the given places. */
static void
spread_bits(uint16_t *spread, const int *place, int bits)
{
    spread[0] = 0;
    for (int b = 0; b < bits; b++)
        for (int i = 0; i < 1 << b; i++)
            spread[(1 << b) + i] = (uint16_t)(spread[i] | 1 << place[b]);
}

static bool
plan(grid *g, fast_cells *cells, fast_box box, int bits)
{
    double size[2], left[2];
    for (int k = 0; k < 2; k++)
        left[k] = size[k] = box.high[k] - box.low[k];
    double longer = size[0] >= size[1] ? size[0] : size[1];
    if (!(longer >= 0x1p-900 && longer <= 0x1p900))
        return false;

    int place[2][FAST_GRID_BITS], used[2] = {0, 0};
    cells->bits = bits;
    for (int b = bits - 1; b >= 0; b--) {
        int k = left[0] >= left[1] ? 0 : 1;
        left[k] /= 2;
        cells->axis[b] = (unsigned char)k;
    }
    for (int b = 0; b < bits; b++)
        place[cells->axis[b]][used[cells->axis[b]]++] = b;
    for (int k = 0; k < 2; k++) {
        g->low[k] = box.low[k];
        g->scale[k] = used[k] > 0 ? (1 << used[k]) / size[k] : 0;
        g->most[k] = (1 << used[k]) - 1;
        spread_bits(g->spread[k], place[k], used[k]);
    }
    return true;
}

/* Which column (or row)? */
static inline uint32_t
column(const grid *g, int axis, double x)
{
    double c = (x - g->low[axis]) * g->scale[axis];
    c = c < g->most[axis] ? c : g->most[axis];
    c = c > 0 ? c : 0;
    return (uint32_t)(int32_t)c;
}

/* Sets from[].edge to the cells of the sites, and counts how many are in each. */
static void
count_cells(const grid *g, fast_site *from, uint32_t count, uint32_t *in_cell)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t c = (uint32_t)g->spread[0][column(g, 0, from[i].x)] |
                     g->spread[1][column(g, 1, from[i].y)];
        from[i].edge = c;
        in_cell[c]++;
    }
}

/* Moves the sites; the next one of cell c goes to to[place[c]]. */
static void
move_to_cells(const fast_site *from, uint32_t count, fast_site *to, uint32_t *place)
{
    for (uint32_t i = 0; i < count; i++)
        to[place[from[i].edge]++] = from[i];
}

/* ---- The same by several threads. ---- */

/* What the tasks share. A task has a piece of the sites and a counter for each cell. */
typedef struct sorting {
    fast_work work;
    const grid *grid;
    fast_site *from, *to;
    uint32_t count, pieces, cells;
    uint32_t *counter; /* those of piece 0 first */
} sorting;

static void
count_piece(fast_work *self, uint32_t piece)
{
    sorting *s = (sorting *)self;
    uint32_t begin = fast_begin(piece, s->pieces, s->count);
    uint32_t end = fast_begin(piece + 1, s->pieces, s->count);
    uint32_t *counter = s->counter + (size_t)piece * s->cells;
    memset(counter, 0, s->cells * sizeof *counter);
    count_cells(s->grid, s->from + begin, end - begin, counter);
}

static void
move_piece(fast_work *self, uint32_t piece)
{
    sorting *s = (sorting *)self;
    uint32_t begin = fast_begin(piece, s->pieces, s->count);
    uint32_t end = fast_begin(piece + 1, s->pieces, s->count);
    move_to_cells(s->from + begin, end - begin, s->to,
                  s->counter + (size_t)piece * s->cells);
}

/* Where each piece begins in each cell: so the order is that of one thread. */
static void
add_up(sorting *s, fast_cells *cells)
{
    uint32_t sum = 0;
    for (uint32_t c = 0; c < s->cells; c++) {
        for (uint32_t piece = 0; piece < s->pieces; piece++) {
            uint32_t *counter = &s->counter[(size_t)piece * s->cells + c];
            uint32_t here = *counter;
            *counter = sum;
            sum += here;
        }
        cells->end[c] = sum;
    }
}

bool
fast_grid_sort(fast_cells *cells, fast_box box, int bits, fast_site *from,
               fast_site *to, uint32_t count, uint32_t threads)
{
    grid g;
    if (!plan(&g, cells, box, bits))
        return false;
    sorting s = {.work = {count_piece}, .grid = &g, .from = from, .to = to,
                 .count = count, .pieces = threads, .cells = 1u << bits};
    uint32_t *more = NULL, own[FAST_GRID_CELLS];
    if (threads > 1)
        more = memory_array((size_t)threads << bits, sizeof *more);
    s.counter = more;
    if (more == NULL) {
        s.counter = own;
        s.pieces = 1;
    }
    fast_share(&s.work, s.pieces, s.pieces);
    add_up(&s, cells);
    s.work.task = move_piece;
    fast_share(&s.work, s.pieces, s.pieces);
    memory_free(more);
    return true;
}
