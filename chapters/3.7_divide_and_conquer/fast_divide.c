/* fast_divide.c - divide and conquer, laid out for a machine. */
#include "chapters/3.7_divide_and_conquer/fast_divide.h"

#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/3.7_divide_and_conquer/fast_export.h"
#include "chapters/3.7_divide_and_conquer/fast_order.h"
#include "chapters/3.7_divide_and_conquer/fast_questions.h"
#include "chapters/3.7_divide_and_conquer/fast_share.h"
#include "lib/memory.h"

#include <float.h>
#include <math.h>

/* ---- Loading: sites, their box and their unit. ---- */

/* What the tasks share. A task has a piece of the points. */
typedef struct loading {
    fast_work work;
    const point2 *points;
    uint32_t n, pieces;
    fast_site *site;
    double unit;                 /* what to begin with, and what to give up at */
    double least;
    fast_box box[FAST_MOST_THREADS];
    double unit_of[FAST_MOST_THREADS];
} loading;

static void
load_piece(fast_work *self, uint32_t piece)
{
    loading *load = (loading *)self;
    uint32_t begin = fast_begin(piece, load->pieces, load->n);
    uint32_t end = fast_begin(piece + 1, load->pieces, load->n);
    for (uint32_t i = begin; i < end; i++)
        load->site[i] = (fast_site){load->points[i].x, load->points[i].y, i, NONE};
    load->box[piece] = fast_box_around(load->site + begin, end - begin);
}

/* The greatest power of two, from `unit` down to `least`, of which all coordinates are
 * multiples; 0 if there is none. */
static void
find_unit(fast_work *self, uint32_t piece)
{
    loading *load = (loading *)self;
    uint32_t end = fast_begin(piece + 1, load->pieces, load->n);
    double unit = load->unit, units = 1 / unit;
    for (uint32_t i = fast_begin(piece, load->pieces, load->n);
         i < end && unit >= load->least; i++) {
        double x = load->site[i].x * units, y = load->site[i].y * units;
        while (unit >= load->least &&
               ((double)(int64_t)x != x || (double)(int64_t)y != y)) {
            x *= 2;
            y *= 2;
            units *= 2;
            unit /= 2;
        }
    }
    load->unit_of[piece] = unit >= load->least ? unit : 0;
}

/* A unit is of use if so few of them make up all coordinates that differences are
 * exact, and if none of its powers is too large or too small. */
static double
unit_of_all(loading *load, int exponent, uint32_t threads)
{
    if (exponent < -150 || exponent > 200)
        return 0;
    load->work.task = find_unit;
    load->unit = ldexp(1, exponent);
    load->least = ldexp(1, exponent - 44);
    fast_share(&load->work, load->pieces, threads);
    double unit = load->unit_of[0];
    for (uint32_t i = 1; i < load->pieces; i++)
        unit = fmin(unit, load->unit_of[i]);
    return unit;
}

/* Multiplies all coordinates by 2^k: no answer changes, if no bit is lost. If one would
 * be, nothing is changed and false is returned. */
static bool
scale_sites(fast_site *site, uint32_t n, int k)
{
    for (uint32_t i = 0; i < n; i++)
        if (ldexp(ldexp(site[i].x, k), -k) != site[i].x ||
            ldexp(ldexp(site[i].y, k), -k) != site[i].y)
            return false;
    for (uint32_t i = 0; i < n; i++) {
        site[i].x = ldexp(site[i].x, k);
        site[i].y = ldexp(site[i].y, k);
    }
    return true;
}

static double
largest_in(fast_box b)
{
    return fmax(fmax(fabs(b.low[0]), fabs(b.low[1])),
                fmax(fabs(b.high[0]), fabs(b.high[1])));
}

/* Fills in the sites and the bounds; returns the box around all. Sites whose products
 * would over- or underflow are brought to where they do not. */
static fast_box
load_all(fast_run *run, double *unit, const point2 *points, uint32_t n,
         uint32_t threads)
{
    loading load = {.work = {load_piece}, .points = points, .n = n, .site = run->site};
    load.pieces = threads < n ? threads : n;
    fast_share(&load.work, load.pieces, threads);
    fast_box box = load.box[0];
    for (uint32_t i = 1; i < load.pieces; i++)
        box = fast_box_join(box, load.box[i]);
    int exponent;
    frexp(largest_in(box), &exponent);
    if ((exponent < -100 || exponent > 100) && scale_sites(run->site, n, -exponent)) {
        box = fast_box_around(run->site, n);
        exponent = 0;
    }
    *unit = unit_of_all(&load, exponent, threads);
    fast_bounds(run, box.high[0] - box.low[0], box.high[1] - box.low[1], *unit);
    return box;
}

/* ---- Triangulating the parts, and merging them. ---- */

/* What the tasks share. A task has a step of the plan. */
typedef struct building {
    fast_work work;
    const fast_run *run;
    fast_plan *plan;
    fast_site *spare;
    uint32_t few;
    double unit;
} building;

static void
triangulate_part(const building *b, fast_step *s)
{
    fast_run run = *b->run;
    fast_box box = fast_box_around(s->from, s->count);
    fast_bounds(&run, box.high[0] - box.low[0], box.high[1] - box.low[1], b->unit);
    fast_worker w = {.run = &run, .pool = fast_pool_of(s->lo, s->count),
                     .spare = b->spare, .few = b->few,
                     .random = random_from_seed(s->lo), .threads = 1};
    s->part = fast_divide(&w, s->from, s->lo, s->count, box);
    fast_pool_close(&run, &w.pool);
    s->pool = w.pool;
    s->duplicates = w.duplicates;
}

static void
merge_parts(const building *b, fast_step *s)
{
    const fast_step *q = s - 1, *p = &b->plan->step[q->begin - 1];
    s->pool = fast_pool_join(b->run, p->pool, q->pool);
    s->part = fast_cut(b->run, &s->pool, s->axis, p->part, q->part);
    s->duplicates = p->duplicates + q->duplicates;
}

/* Whoever completes the second part of a cut makes the cut, and so on upwards. */
static void
build_step(fast_work *self, uint32_t number)
{
    const building *b = (const building *)self;
    fast_step *s = &b->plan->step[number];
    if (s->from == NULL)
        return; /* a cut: others will come */
    triangulate_part(b, s);
    while (s->cut != NONE) {
        s = &b->plan->step[s->cut];
        if (fast_count_up(&s->ready) == 0)
            return;
        merge_parts(b, s);
    }
}

/* ---- All. ---- */

static tri_status
triangulate(const point2 *points, uint32_t n, fast_limits limits, mesh *m)
{
    fast_run run = {.site = (fast_site *)(void *)m->halfedge};
    fast_site *spare = run.site + n;
    fast_plan plan = {0};
    run.cw = (halfedge_id *)(void *)spare; /* see fast_order.c take_few */
    run.edge = memory_array((size_t)6 * n + FAST_EXPORT_MORE, sizeof *run.edge);
    if (run.edge == NULL)
        return TRI_OUT_OF_MEMORY;

    double unit;
    fast_box box = load_all(&run, &unit, points, n, limits.threads);
    tri_status status = fast_make_plan(&plan, &run, spare, n, limits, box);
    if (status == TRI_OK) {
        building b = {.work = {build_step}, .run = &run, .plan = &plan, .spare = spare,
                      .few = limits.few, .unit = unit};
        fast_share(&b.work, plan.size, limits.threads);
        const fast_step *all = &plan.step[plan.size - 1];
        m->locations = n - all->duplicates;
        fast_export(&run, n, all->part.first[0], m, limits.threads);
    }
    memory_free(plan.step);
    memory_free(run.edge);
    return status;
}

fast_limits
fast_limits_for(uint32_t n, uint32_t threads)
{
    fast_limits limits = {.few = 9, .job = n / 128 > 2048 ? n / 128 : 2048};
    limits.threads = threads < FAST_MOST_THREADS ? threads : FAST_MOST_THREADS;
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
    return fast_divide_with(points, n, fast_limits_for(n, used.threads), out);
}
