/* fast_order.c - dividing: where to cut, down to parts of a few sites.
 *
 * Large parts are sorted into the cells of a grid, and cut where the grid was halved;
 * that costs a fixed number of steps a site, if the sites are spread evenly. A cell in
 * which there are still many sites gets a grid of its own. If that would not help, as
 * most of the sites are in one cell, the part is cut at its median. A few sites are
 * sorted, and cut in the middle again and again.
 */
#include "chapters/3.7_divide_and_conquer/fast_order.h"

#include "chapters/3.7_divide_and_conquer/fast_grid.h"
#include "lib/memory.h"

/* ---- Triangulate, or write down that it is to be done. ---- */

static tri_status
remember(fast_plan *plan, fast_step step)
{
    if (plan->size == plan->room) {
        uint32_t room = 2 * plan->room + 64;
        fast_step *more = memory_resize(plan->step, room, sizeof *more);
        if (more == NULL)
            return TRI_OUT_OF_MEMORY;
        plan->step = more;
        plan->room = room;
    }
    plan->step[plan->size++] = step;
    return TRI_OK;
}

fast_part
fast_cut(const fast_run *run, fast_pool *pool, int axis, fast_part a, fast_part b)
{
    fast_merge(run, pool, a.last[axis], b.first[axis]);
    fast_part both;
    int other = 1 - axis;
    const fast_site *s = run->site;
    both.first[axis] = a.first[axis];
    both.last[axis] = b.last[axis];
    both.first[other] = fast_before(other, &s[a.first[other]], &s[b.first[other]])
                            ? a.first[other] : b.first[other];
    both.last[other] = fast_before(other, &s[a.last[other]], &s[b.last[other]])
                           ? b.last[other] : a.last[other];
    return both;
}

/* The two parts, one before the other along the axis, become one. */
static fast_part
cut(fast_worker *w, int axis, fast_part a, fast_part b)
{
    if (w->plan == NULL)
        return fast_cut(w->run, &w->pool, axis, a, b);
    if (w->status == TRI_OK)
        w->status = remember(w->plan, (fast_step){.axis = axis});
    return a; /* nobody asks */
}

/* ---- A few sites: sorted once, and cut in the middle. ---- */

static void
sort_few(fast_site *site, uint32_t count, int axis)
{
    for (uint32_t i = 1; i < count; i++) {
        fast_site s = site[i];
        uint32_t k = i;
        for (; k > 0 && fast_before(axis, &s, &site[k - 1]); k--)
            site[k] = site[k - 1];
        site[k] = s;
    }
}

/* Of sorted sites, one for each location remains: that with the lowest index. Returns
 * how many there are. */
static uint32_t
drop_duplicates(fast_site *site, uint32_t count)
{
    uint32_t kept = 1;
    for (uint32_t i = 1; i < count; i++) {
        fast_site *last = &site[kept - 1];
        if (!fast_same_place(last, &site[i]))
            site[kept++] = site[i];
        else if (site[i].id < last->id)
            last->id = site[i].id;
    }
    for (uint32_t i = kept; i < count; i++)
        site[i].edge = NONE;
    return kept;
}

static fast_part
part_of_few(const fast_run *run, uint32_t lo, uint32_t count, int axis)
{
    int other = 1 - axis;
    fast_part p;
    p.first[axis] = p.first[other] = p.last[other] = lo;
    p.last[axis] = lo + count - 1;
    for (uint32_t i = lo + 1; i < lo + count; i++) {
        if (fast_before(other, &run->site[i], &run->site[p.first[other]]))
            p.first[other] = i;
        if (fast_before(other, &run->site[p.last[other]], &run->site[i]))
            p.last[other] = i;
    }
    return p;
}

static fast_part
divide_sorted(fast_worker *w, uint32_t lo, uint32_t count, int axis)
{
    if (count <= 3) {
        fast_few(w->run, &w->pool, lo, count);
        return part_of_few(w->run, lo, count, axis);
    }
    uint32_t half = count / 2;
    fast_part a = divide_sorted(w, lo, half, axis);
    fast_part b = divide_sorted(w, lo + half, count - half, axis);
    return cut(w, axis, a, b);
}

/* Sorts sites along the axis and triangulates them, or writes it down.
 *
 * The half-edges of sites lo and up have their run->cw where spare has had these sites.
 * That is safe: parts are taken in order, so spare holds none before lo any more, and
 * those have used up none but their own half-edges. */
static fast_part
take_few(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count, int axis)
{
    if (w->plan != NULL) {
        if (w->status == TRI_OK)
            w->status = remember(w->plan, (fast_step){.from = from, .lo = lo,
                                                      .count = count});
        return (fast_part){{0}, {0}}; /* nobody asks */
    }
    fast_site *site = w->run->site + lo; /* where they stay */
    if (from != site)
        for (uint32_t i = 0; i < count; i++)
            site[i] = from[i];
    assert(w->pool.fresh <= 6 * lo);
    sort_few(site, count, axis);
    uint32_t kept = drop_duplicates(site, count);
    w->duplicates += count - kept;
    return divide_sorted(w, lo, kept, axis);
}

/* ---- Many sites, cut at the median. ---- */

/* The sites before the pivot along the axis are moved to the front, or (with_equal)
 * those that are not behind it; returns how many. */
static uint32_t
partition(fast_site *site, uint32_t count, int axis, const fast_site pivot,
          bool with_equal)
{
    uint32_t front = 0;
    for (uint32_t i = 0; i < count; i++) {
        fast_site s = site[i];
        bool before = with_equal ? !fast_before(axis, &pivot, &s)
                                 : fast_before(axis, &s, &pivot);
        site[i] = site[front];
        site[front] = s;
        front += before;
    }
    return front;
}

/* Cuts the sites into two parts, the first before the second along the axis, and
 * neither with fewer than a quarter of the sites unless many of them coincide. Returns
 * the size of the first; 0 when all coincide. */
static uint32_t
cut_at_median(fast_worker *w, fast_site *site, uint32_t count, int axis)
{
    uint32_t lo = 0, hi = count; /* the median is among site[lo .. hi-1] */
    for (;;) {
        fast_site pivot = site[lo + random_below(&w->random, hi - lo)];
        uint32_t before = lo + partition(site + lo, hi - lo, axis, pivot, false);
        uint32_t behind = before + partition(site + before, hi - before, axis, pivot,
                                             true);
        if (before >= count - count / 4) {
            hi = before;
        } else if (behind <= count / 4) {
            lo = behind;
        } else {
            bool first = before >= count - behind;
            uint32_t balanced = before > 0 && (first || behind == count) ? before
                                                                         : behind;
            return balanced < count ? balanced : 0;
        }
    }
}

static fast_part divide_more(fast_worker *w, fast_site *from, uint32_t lo,
                             uint32_t count, int axis);

static fast_part
divide_at_median(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count,
                 fast_box box)
{
    int axis = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1;
    uint32_t half = cut_at_median(w, from, count, axis);
    if (half == 0) /* one location */
        return take_few(w, from, lo, count, axis);
    fast_part p = divide_more(w, from, lo, half, 1 - axis);
    fast_part q = divide_more(w, from + half, lo + half, count - half, 1 - axis);
    return cut(w, axis, p, q);
}

/* ---- Many sites, sorted into cells. ---- */

/* The sites of the 2^bits cells from number `first` on. With more than `many` in one
 * cell another grid might help as little: that cell is cut at its median first. */
static fast_part
divide_cells(fast_worker *w, const fast_cells *cells, fast_site *from, uint32_t lo,
             uint32_t first, int bits, uint32_t many)
{
    uint32_t begin = first > 0 ? cells->end[first - 1] : 0;
    for (;;) {
        uint32_t count = cells->end[first + (1u << bits) - 1] - begin;
        if (bits == 0 && count > many && count > w->few)
            return divide_at_median(w, from + begin, lo + begin, count,
                                    fast_box_around(from + begin, count));
        if (bits == 0)
            return divide_more(w, from + begin, lo + begin, count, 1 - cells->axis[0]);
        int axis = cells->axis[--bits];
        if (count <= w->few)
            return take_few(w, from + begin, lo + begin, count, axis);
        uint32_t second = first + (1u << bits), middle = cells->end[second - 1];
        if (middle == begin) {
            first = second;
        } else if (middle < begin + count) {
            fast_part p = divide_cells(w, cells, from, lo, first, bits, many);
            fast_part q = divide_cells(w, cells, from, lo, second, bits, many);
            return cut(w, axis, p, q);
        }
    }
}

/* Few enough cells for two or four sites in each, if they are spread evenly: to sort a
 * few is cheap. */
static int
bits_for(const fast_worker *w, uint32_t count)
{
    int bits = 1;
    while (bits < FAST_GRID_BITS && count >> bits > w->few / 2)
        bits++;
    return bits;
}

fast_part
fast_divide(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count, fast_box box)
{
    enum { TOO_FEW_FOR_A_GRID = 32 };
    if (count < TOO_FEW_FOR_A_GRID)
        return divide_at_median(w, from, lo, count, box);
    fast_box grid = w->plan != NULL ? fast_box_of_most(from, count, box) : box;
    fast_site *here = w->run->site + lo, *there = w->spare + lo;
    fast_site *to = from == here ? there : here;
    fast_cells cells;
    if (!fast_grid_sort(&cells, grid, bits_for(w, count), from, to, count,
                        w->threads))
        return divide_at_median(w, from, lo, count, box);
    return divide_cells(w, &cells, to, lo, 0, cells.bits, count / 8);
}

/* Divides what is left of a part, unless it is small; then it is sorted along the axis,
 * which is most likely its longer side. */
static fast_part
divide_more(fast_worker *w, fast_site *from, uint32_t lo, uint32_t count, int axis)
{
    if (count <= w->few)
        return take_few(w, from, lo, count, axis);
    return fast_divide(w, from, lo, count, fast_box_around(from, count));
}

/* ---- The plan. ---- */

/* Tells each step where it begins and which cut needs it. The last step of a cut's
 * second part stands before the cut, that of its first part before where the second
 * begins. */
static void
link_steps(fast_plan *plan)
{
    for (uint32_t i = 0; i < plan->size; i++) {
        fast_step *s = &plan->step[i];
        s->begin = i;
        s->cut = NONE;
        if (s->from == NULL) {
            fast_step *second = s - 1, *first = &plan->step[second->begin - 1];
            s->begin = first->begin;
            first->cut = second->cut = i;
        }
    }
}

tri_status
fast_make_plan(fast_plan *plan, fast_run *run, fast_site *spare, uint32_t n,
               fast_limits limits, fast_box box)
{
    fast_worker w = {.run = run, .spare = spare, .few = limits.job, .plan = plan,
                     .random = random_from_seed(0), .threads = limits.threads};
    if (n > limits.job)
        fast_divide(&w, run->site, 0, n, box);
    else
        take_few(&w, run->site, 0, n, 0);
    link_steps(plan);
    return w.status;
}
