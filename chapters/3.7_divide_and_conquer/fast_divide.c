/* fast_divide.c - divide and conquer, laid out for a machine. */
#include "chapters/3.7_divide_and_conquer/fast_divide.h"

#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/3.7_divide_and_conquer/fast_export.h"
#include "chapters/3.7_divide_and_conquer/fast_order.h"
#include "lib/memory.h"

#include <float.h>
#include <math.h>

/* ---- Whole multiples of a unit. ---- */

/* The greatest power of two of which all coordinates are multiples, and few enough of
 * them: then differences and small determinants are exact. 0 if there is none. */
static double
unit_of(const fast_site *site, uint32_t n, fast_box box)
{
    double largest = fmax(fmax(fabs(box.low[0]), fabs(box.low[1])),
                          fmax(fabs(box.high[0]), fabs(box.high[1])));
    int exponent;
    frexp(largest, &exponent);
    if (largest == 0 || exponent < -150 || exponent > 200)
        return 0;
    double unit = ldexp(1, exponent), least = ldexp(1, exponent - 44), units = 1 / unit;
    for (uint32_t i = 0; i < n && unit >= least; i++) {
        double x = site[i].x * units, y = site[i].y * units;
        while (unit >= least && ((double)(int64_t)x != x || (double)(int64_t)y != y)) {
            x *= 2;
            y *= 2;
            units *= 2;
            unit /= 2;
        }
    }
    return unit >= least ? unit : 0;
}

/* ---- The work. ---- */

static void
load(const point2 *points, uint32_t n, fast_site *site)
{
    for (uint32_t i = 0; i < n; i++)
        site[i] = (fast_site){points[i].x, points[i].y, i, NONE};
}

static void
triangulate_part(const fast_run *all, fast_site *spare, uint32_t few, double unit,
                 fast_step *s)
{
    fast_run run = *all;
    fast_box box = fast_box_around(s->from, s->count);
    fast_bounds(&run, box.high[0] - box.low[0], box.high[1] - box.low[1], unit);
    fast_worker w = {.run = &run, .pool = fast_pool_of(s->lo, s->count), .spare = spare,
                     .few = few, .random = random_from_seed(s->lo)};
    s->part = fast_divide(&w, s->from, s->lo, s->count, box);
    fast_pool_close(&run, &w.pool);
    s->pool = w.pool;
    s->duplicates = w.duplicates;
}

/* Steps written down in postfix order: the results of those that wait for a cut are
 * kept in the first places. */
static fast_step
run_cuts(fast_run *run, fast_plan *plan)
{
    uint32_t waiting = 0;
    for (uint32_t i = 0; i < plan->size; i++) {
        fast_step s = plan->step[i];
        if (s.from == NULL) {
            fast_step *a = &plan->step[waiting - 2], *b = &plan->step[waiting - 1];
            a->pool = fast_pool_join(run, a->pool, b->pool);
            a->part = fast_cut(run, &a->pool, s.axis, a->part, b->part);
            a->duplicates += b->duplicates;
            waiting--;
        } else {
            plan->step[waiting++] = s;
        }
    }
    return plan->step[0];
}

static tri_status
triangulate(const point2 *points, uint32_t n, fast_limits limits, mesh *m)
{
    fast_run run = {.site = (fast_site *)(void *)m->halfedge};
    fast_plan plan = {0};
    run.edge = memory_array((size_t)6 * n + 1, sizeof *run.edge);
    if (run.edge == NULL)
        return TRI_OUT_OF_MEMORY;
    fast_site *spare = run.site + n;
    run.cw = (halfedge_id *)(void *)spare; /* see fast_order.c take_few */
    load(points, n, run.site);
    fast_box box = fast_box_around(run.site, n);
    double unit = unit_of(run.site, n, box);
    fast_bounds(&run, box.high[0] - box.low[0], box.high[1] - box.low[1], unit);

    fast_worker planner = {.run = &run, .spare = spare, .plan = &plan,
                           .few = limits.job, .random = random_from_seed(0)};
    fast_divide(&planner, run.site, 0, n, box);
    if (planner.status == TRI_OK) {
        for (uint32_t i = 0; i < plan.size; i++)
            if (plan.step[i].from != NULL)
                triangulate_part(&run, spare, limits.few, unit, &plan.step[i]);
        fast_step all = run_cuts(&run, &plan);
        m->locations = n - all.duplicates;
        fast_export(&run, n, all.part.first[0], m);
    }
    memory_free(plan.step);
    memory_free(run.edge);
    return planner.status;
}

fast_limits
fast_limits_for(uint32_t n)
{
    fast_limits limits = {.few = 9, .job = n / 128 > 2048 ? n / 128 : 2048};
    return limits;
}

tri_status
fast_divide_with(const point2 *points, uint32_t n, fast_limits limits, mesh *out)
{
    if (n == 0)
        return mesh_init(out, 0, 0);
    tri_status status = mesh_init(out, n + 1, n + 1); /* room for each site twice */
    out->points = n;
    if (status == TRI_OK)
        status = triangulate(points, n, limits, out);
    if (status != TRI_OK)
        mesh_free(out);
    return status;
}

tri_status
fast_divide_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                        mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    if (used.trace != NULL || mesh_fits(n) != TRI_OK || mesh_fits(n + 1) != TRI_OK)
        return divide_triangulate(points, n, &used, out);
    return fast_divide_with(points, n, fast_limits_for(n), out);
}
