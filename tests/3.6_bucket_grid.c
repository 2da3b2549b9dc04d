/* Sections 3.6 and 3.7: a grid of buckets finds a vertex near a point, so that the walk
 * to the point is short.
 *
 * Hypotheses: none for what is found; that it is near, so that n points take O(n)
 * together, is said of evenly spread points only.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.6_randomized_incremental/bucket_grid.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

/* ---- The grid. ---- */

/* So many columns or rows lie between two cells. */
static uint32_t
rings_between(const bucket_grid *g, uint32_t a, uint32_t b)
{
    uint32_t ax = a % g->side, ay = a / g->side, bx = b % g->side, by = b / g->side;
    uint32_t columns = ax > bx ? ax - bx : bx - ax, rows = ay > by ? ay - by : by - ay;
    return columns > rows ? columns : rows;
}

/* P1: the vertex that is found for p has come, and lies in the cell of p or in the
 * nearest ring in which a vertex lies: here all that have come are asked. */
static uint32_t
check_near(const bucket_grid *g, point2 p)
{
    uint32_t cells = g->side * g->side, here = bucket_grid_cell(g, p),
             nearest = g->side;
    vertex_id v = bucket_grid_near(g, p);
    bool has_come = false;
    CLAIM("grid.P1", here < cells, "cell %u of %u", here, cells);
    for (uint32_t i = 0; i < g->count; i++) {
        point2 q = g->points[g->order[i]];
        uint32_t rings = rings_between(g, here, bucket_grid_cell(g, q));
        nearest = rings < nearest ? rings : nearest;
        has_come = has_come || g->order[i] == v;
    }
    CLAIM("grid.P1", has_come, "%u is found, and has not come", v);
    uint32_t found = rings_between(g, here, bucket_grid_cell(g, g->points[v]));
    CLAIM("grid.P1", found == nearest, "found in ring %u, the nearest is %u", found,
          nearest);
    return found;
}

/* P2: so many cells for the vertices, and so many vertices put into a cell again. */
static void
the_grid_grows_with_the_vertices(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    bucket_grid g;
    uint32_t u, again = 0, side = 1;
    vertex_id *L = malloc(n * sizeof *L);
    CLAIM("grid.P1", sort_along(points, n, (point2){1, 0}, L, &u) == TRI_OK,
          "no memory");
    shuffle(L, u, test_random_source());
    CLAIM("grid.P1", bucket_grid_init(&g, points, L, u) == TRI_OK, "no memory");
    for (uint32_t i = 0; i < u; i++) {
        bucket_grid_add(&g);
        again += g.side != side ? g.count : 0;
        side = g.side;
        uint32_t cells = side * side;
        CLAIM("grid.P2", g.count == i + 1 && g.count <= 2 * cells &&
              (cells == 1 || cells < 2 * g.count), "%u vertices in %u cells", g.count,
              cells);
        CLAIM("grid.P2", 2 * again <= 3 * g.count, "%u vertices, %u moves", g.count,
              again);
        check_near(&g, points[L[random_below(test_random_source(), u)]]);
    }
    bucket_grid_free(&g);
    free(L);
}

/* P1: points scaled by a power of two are in the same cells, also if their differences
 * are no finite numbers then. */
static void
scaled_points_have_the_same_cells(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    HYPOTHESIS(n > 0);
    point2 *points = whole_points(NULL, n, 1000);
    point2 *huge = malloc(n * sizeof *huge);
    vertex_id *L = malloc(n * sizeof *L);
    for (uint32_t i = 0; i < n; i++) {
        L[i] = i;
        points[i].x -= 500;
        points[i].y -= 500;
        huge[i] = (point2){points[i].x * 0x1p1015, points[i].y * 0x1p1015};
    }
    bucket_grid g, h;
    CLAIM("grid.P1", bucket_grid_init(&g, points, L, n) == TRI_OK &&
          bucket_grid_init(&h, huge, L, n) == TRI_OK, "no memory");
    uint32_t differ = 0;
    for (uint32_t i = 0; i < n; i++) {
        bucket_grid_add(&g);
        bucket_grid_add(&h);
    }
    for (uint32_t i = 0; i < n; i++)
        differ += bucket_grid_cell(&g, points[i]) != bucket_grid_cell(&h, huge[i]);
    bucket_grid_free(&g);
    bucket_grid_free(&h);
    free(L);
    free(huge);
    free(points);
    CLAIM("grid.P1", differ == 0, "%u of %u points are in other cells", differ, n);
}

/* ---- With Figure 12. ---- */

typedef struct walker {
    trace observer; /* first: see lib/trace.h */
    uint64_t visits;
    uint32_t flips;
} walker;

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    ((walker *)self)->visits += event->kind == TRACE_VISIT;
    ((walker *)self)->flips += event->kind == TRACE_FLIP;
    return 0;
}

/* P3: the locator decides where the walk begins, and not where it ends: the result is
 * Delaunay. */
static void
it_is_figure_12(const point2 *points, uint32_t n)
{
    tri_options options = tri_options_default();
    options.seed = random_bits(test_random_source());
    mesh m;
    triangle_list list;
    verdict v;
    CLAIM("grid.P3", bucketed_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    claim_verdict("grid.P3", mesh_check(&m));
    CLAIM("grid.P3", mesh_triangles(&m, &list) == TRI_OK, "no list");
    test_picture(list);
    CLAIM("grid.P3", is_delaunay(points, n, list, &v) == TRI_OK, "out of memory");
    claim_verdict("grid.P3", v);
    triangle_list_free(&list);
    mesh_free(&m);
}

/* P3: where no four sites are cocircular each triangulation on the way is unique, and
 * so are the flips of an order. */
static void
uniform_points_have_the_same_flips(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    random_source *r = test_random_source();
    point2 *points = malloc((n + 1) * sizeof *points);
    for (uint32_t i = 0; i < n; i++)
        points[i] = random_point(r);
    walker grid = {.observer = {see}}, waiting = {.observer = {see}};
    tri_options options = tri_options_default();
    mesh m;
    options.seed = random_bits(r);
    options.trace = &grid.observer;
    tri_status one = bucketed_triangulate(points, n, &options, &m);
    mesh_free(&m);
    options.trace = &waiting.observer;
    tri_status other = incremental_triangulate(points, n, &options, &m);
    mesh_free(&m);
    free(points);
    CLAIM("grid.P3", one == TRI_OK && other == TRI_OK && grid.flips == waiting.flips,
          "%u and %u flips", grid.flips, waiting.flips);
}

/* ---- How near is near? ---- */

static double
visits_for_each(const point2 *points, uint32_t n, bool grid)
{
    walker w = {.observer = {see}};
    tri_options options = tri_options_default();
    options.trace = &w.observer;
    options.locator = TRI_LOCATOR_WALK;
    mesh m;
    tri_status status = (grid ? bucketed_triangulate : incremental_triangulate)(
        points, n, &options, &m);
    CLAIM("grid.P4", status == TRI_OK, "%s", tri_status_text(status));
    mesh_free(&m);
    return (double)w.visits / n;
}

/* The cells that are looked at for each point, at most. */
static double
cells_for_each(const point2 *points, uint32_t n)
{
    bucket_grid g;
    vertex_id *L = malloc(n * sizeof *L);
    for (uint32_t i = 0; i < n; i++)
        L[i] = i;
    CLAIM("grid.P4", bucket_grid_init(&g, points, L, n) == TRI_OK, "no memory");
    double cells = 0;
    bucket_grid_add(&g);
    for (uint32_t i = 1; i < n; i++) {
        vertex_id v = bucket_grid_near(&g, points[i]);
        double r = rings_between(&g, bucket_grid_cell(&g, points[i]),
                                 bucket_grid_cell(&g, points[v]));
        cells += (2 * r + 1) * (2 * r + 1);
        bucket_grid_add(&g);
    }
    bucket_grid_free(&g);
    free(L);
    return cells / n;
}

/* P4: evenly spread, few cells and few triangles, however many points there are.
 * P5: and a square that is tiny beside the distance of one point is one bucket. */
static void
near_for_even_points_only(void)
{
    enum { few = 1024, many = 16384 };
    point2 *points = malloc(many * sizeof *points);
    random_source *r = test_random_source();
    for (int i = 0; i < many; i++)
        points[i] = random_point(r);
    double few_visits = visits_for_each(points, few, true),
           visits = visits_for_each(points, many, true),
           cells = cells_for_each(points, many);
    double by_walk = visits_for_each(points, many, false);
    points[0] = (point2){1e6, 1e6};
    double few_in_one = visits_for_each(points, few, true),
           in_one = visits_for_each(points, many, true);
    free(points);
    CLAIM("grid.P4", visits < 5 && visits < 1.1 * few_visits && 10 * visits < by_walk,
          "%.2f and %.2f triangles; %.2f without a grid", few_visits, visits, by_walk);
    CLAIM("grid.P4", cells < 5, "%.2f cells", cells);
    CLAIM("grid.P5", in_one > 3 * few_in_one && 2 * in_one > by_walk,
          "%.2f and %.2f triangles", few_in_one, in_one);
}

/* ---- Refusals, and memory that runs out. ---- */

static int
see_and_stop(trace *self, const mesh *m, const trace_event *event)
{
    (void)self;
    return event->kind == TRACE_FLIP && m->triangles >= 30;
}

static void
it_can_be_stopped_and_refused(void)
{
    point2 points[50];
    for (int i = 0; i < 50; i++)
        points[i] = (point2){i % 7, i * i % 11};
    trace stop = {see_and_stop};
    tri_options options = tri_options_default();
    mesh m;
    options.trace = &stop;
    CLAIM("grid.P3", bucketed_triangulate(points, 50, &options, &m) == TRI_CANCELLED &&
          m.halfedge == NULL, "the observer could not stop it");
    options.trace = NULL;
    tri_status status = TRI_OUT_OF_MEMORY;
    unsigned long k = 1;
    for (; status == TRI_OUT_OF_MEMORY; k++) {
        memory_fail_at(k);
        status = bucketed_triangulate(points, 50, &options, &m);
        memory_fail_at(0);
        CLAIM("grid.P3", status == TRI_OK || m.halfedge == NULL, "allocation %lu", k);
    }
    CLAIM("grid.P3", status == TRI_OK && k > 5, "allocation %lu: %s", k,
          tri_status_text(status));
    mesh_free(&m);
    options.size--;
    CLAIM("grid.P3", bucketed_triangulate(points, 50, &options, &m) == TRI_BAD_OPTION,
          "options of another version were accepted");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6: a grid of buckets");
    test_random("the grid", the_grid_grows_with_the_vertices, 1000, 150);
    test_near_degenerate("the grid", the_grid_grows_with_the_vertices, 1000, 60);
    test_random("scaled points", scaled_points_have_the_same_cells, 500, 100);
    test_random("Figure 12", it_is_figure_12, 1000, 120);
    test_near_degenerate("Figure 12", it_is_figure_12, 2000, 40);
    test_grid_subsets("Figure 12", it_is_figure_12, 4);
    test_random("the flips", uniform_points_have_the_same_flips, 300, 300);
    test_run("how near", near_for_even_points_only);
    test_run("stopped, refused, out of memory", it_can_be_stopped_and_refused);
    return test_end((test_minima){.trials = 60000, .largest_n = 250, .zeros = 10000,
                                  .expansions = 1000, .wide = 1000});
}
