/* watch.c - progress and statistics. */
#include "tools/tri/watch.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static double
now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- The observer. ---- */

typedef struct watcher {
    trace base;
    uint64_t events, flips;
    bool terminal;
    double next_line; /* when to write about progress again */
} watcher;

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    watcher *w = (watcher *)self;
    w->flips += event->kind == TRACE_FLIP;
    /* The clock is asked rarely, as asking takes longer than counting. */
    if (w->terminal && ++w->events % 65536 == 0 && now() > w->next_line) {
        fprintf(stderr, "\rtri: %lu triangles, %" PRIu64 " flips ",
                (unsigned long)m->triangles, w->flips);
        w->next_line = now() + 0.25;
    }
    return 0;
}

static tri_status
run(const algorithm *a, const point2 *points, uint32_t n, tri_options options,
    watcher *w, mesh *m)
{
    double begin = now();
    *w = (watcher){.base = {see}, .terminal = isatty(STDERR_FILENO) == 1};
    w->next_line = begin + 1;
    if (a->steps != NULL) /* else it reports nothing, or would take another way */
        options.trace = &w->base;
    tri_status status = a->triangulate(points, n, &options, m);
    if (w->terminal && w->next_line > begin + 1)
        fputc('\n', stderr);
    return status;
}

/* ---- Statistics. ---- */

/* Short runs are repeated for so long, and the shortest counts: other programs
 * can only make a run longer. */
#define SECONDS_TO_MEASURE 0.1

static tri_status
seconds_to_run(const algorithm *a, const point2 *points, uint32_t n,
               const tri_options *options, double *shortest)
{
    double first = now();
    *shortest = HUGE_VAL;
    do {
        mesh m;
        double begin = now();
        tri_status status = a->triangulate(points, n, options, &m);
        double seconds = now() - begin;
        if (status != TRI_OK)
            return status;
        mesh_free(&m);
        if (seconds < *shortest)
            *shortest = seconds;
    } while (now() - first < SECONDS_TO_MEASURE);
    return TRI_OK;
}

static int
compare_points(const void *p, const void *q)
{
    const point2 *a = p, *b = q;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return (a->y > b->y) - (a->y < b->y);
}

static tri_status
seconds_to_sort(const point2 *points, uint32_t n, double *shortest)
{
    double first = now();
    point2 *copy = memory_array(n, sizeof *copy);
    if (copy == NULL)
        return TRI_OUT_OF_MEMORY;
    *shortest = HUGE_VAL;
    do {
        if (n > 0)
            memcpy(copy, points, n * sizeof *copy);
        double begin = now();
        qsort(copy, n, sizeof *copy, compare_points);
        double seconds = now() - begin;
        if (seconds < *shortest)
            *shortest = seconds;
    } while (now() - first < SECONDS_TO_MEASURE);
    memory_free(copy);
    return TRI_OK;
}

static void
print_count(const char *name, uint64_t value)
{
    printf("%s %" PRIu64 "\n", name, value);
}

#ifdef TRI_COUNTED
static void
print_predicates(predicate_counts c)
{
    print_count("orient2d", c.orient2d);
    print_count("incircle", c.incircle);
    print_count("orient3d", c.orient3d);
    print_count("compare_along", c.compare_along);
    print_count("compare_distance", c.compare_distance);
    print_count("dot_sign", c.dot_sign);
    print_count("decided_by_signs", c.signs);
    print_count("decided_by_expansions", c.expansions);
    print_count("decided_by_wide", c.wide);
    print_count("zeros", c.zeros);
}
#endif

static tri_status
print_sizes(const mesh *m, uint32_t n, uint64_t flips)
{
    triangle_list list;
    vertex_id *hull = memory_array(m->locations, sizeof *hull);
    if (hull == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = mesh_triangles(m, &list);
    if (status == TRI_OK) {
        print_count("points", n);
        print_count("locations", m->locations);
        print_count("duplicates", n - m->locations);
        print_count("hull", hull_vertices(m, hull));
        print_count("triangles", list.count);
        print_count("flips", flips);
        triangle_list_free(&list);
    }
    memory_free(hull);
    return status;
}

tri_status
run_watched(const algorithm *a, const point2 *points, uint32_t n,
            tri_options options, bool stats, mesh *m)
{
    watcher w;
    if (!stats) {
        if (isatty(STDERR_FILENO) == 1)
            return run(a, points, n, options, &w, m);
        return a->triangulate(points, n, &options, m);
    }
    double seconds, sorting;
    *m = (mesh){0};
    tri_status status = seconds_to_run(a, points, n, &options, &seconds);
    if (status == TRI_OK)
        status = seconds_to_sort(points, n, &sorting);
    if (status != TRI_OK)
        return status;
#ifdef TRI_COUNTED
    predicate_count = (predicate_counts){0};
#endif
    status = run(a, points, n, options, &w, m);
    if (status != TRI_OK)
        return status;
#ifdef TRI_COUNTED
    predicate_counts counts = predicate_count;
#endif
    status = print_sizes(m, n, w.flips);
#ifdef TRI_COUNTED
    print_predicates(counts);
#endif
    printf("seconds %.6f\n", seconds);
    printf("seconds_to_sort %.6f\n", sorting);
    printf("ratio %.2f\n", seconds / sorting);
    if (status != TRI_OK)
        mesh_free(m);
    return status;
}
