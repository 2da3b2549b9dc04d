/* Section 3.6.4: a straight walk, buckets and the history graph find the triangle.
 *
 * Hypotheses: the walk needs a triangulation, Delaunay or not, and a point that is
 * no vertex; buckets and history need nothing. Points may lie on edges, in line
 * with edges and with the hull, and outside.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- The walk. ---- */

typedef struct walker {
    trace observer; /* first: see lib/trace.h */
    bool *visited;  /* by triangle */
    uint32_t visits;
    uint32_t again; /* triangles visited more than once */
    const point2 *points;
    point2 from, to;
    uint32_t missed; /* visited triangles that the segment does not meet */
} walker;

/* Does the segment from `from` to `to` meet the triangle of e? They do if the
 * corners are not all strictly on one side of its line, nor both its ends strictly
 * beyond one side. */
static bool
segment_meets(const mesh *m, const point2 *points, halfedge_id e, point2 from,
              point2 to)
{
    int left = 0, right = 0;
    for (int i = 0; i < 3; i++) {
        vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
        int side = orient2d(from, to, points[a]);
        left += side > 0;
        right += side < 0;
        if (orient2d(points[a], points[b], from) < 0 &&
            orient2d(points[a], points[b], to) < 0)
            return false;
        e = mesh_next(e);
    }
    return left < 3 && right < 3;
}

static int
see_visit(trace *self, const mesh *m, const trace_event *event)
{
    walker *w = (walker *)self;
    if (event->kind != TRACE_VISIT)
        return 0;
    triangle_id t = mesh_triangle_of(event->edge);
    w->again += w->visited[t];
    w->visited[t] = true;
    w->visits++;
    if (w->points != NULL && mesh_in_triangle(m, event->edge))
        w->missed += !segment_meets(m, w->points, event->edge, w->from, w->to);
    return 0;
}

/* Is that the place of p? Says what is wrong, or NULL. */
static const char *
wrong_place(const mesh *m, const point2 *points, place at, point2 p)
{
    point2 a = points[mesh_origin(m, at.e)];
    if (at.kind == PLACE_BEYOND) { /* the path ends at a, p is in line behind it */
        point2 before = points[mesh_dest(m, at.e)];
        return !mesh_is_hull_edge(m, at.e) ||
                       mesh_hull_prev(m, at.e) != mesh_twin(m, at.e) ||
                       orient2d(before, a, p) != 0 || is_same_side(a, before, p)
                   ? "not beyond the end of the path"
                   : NULL;
    }
    if (at.kind == PLACE_EDGE) {
        point2 b = points[mesh_dest(m, at.e)];
        return orient2d(a, b, p) != 0 || !is_same_side(a, b, p) ||
                       !is_same_side(b, a, p)
                   ? "not on that edge"
                   : NULL;
    }
    halfedge_id e = at.e;
    for (int i = 0; i < 3; i++) {
        vertex_id from = mesh_origin(m, e), to = mesh_dest(m, e);
        if (from != GHOST && to != GHOST &&
            orient2d(points[from], points[to], p) <= 0)
            return "not inside that triangle";
        e = mesh_next(e);
    }
    return NULL;
}

/* Removes one of the points, triangulates the others in any way, and walks to it
 * from every vertex. */
static void
the_walk_finds_the_place(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    uint32_t u = n - 1;
    point2 p = points[u];
    mesh m;
    random_triangulation(points, u, &m);
    bool is_vertex = m.triangles == 0;
    for (vertex_id v = 0; v < u && !is_vertex; v++)
        is_vertex = points[v].x == p.x && points[v].y == p.y;
    for (vertex_id v = 0; v < u && !is_vertex; v++) {
        if (mesh_leaving(&m, v) == NONE)
            continue;
        walker w = {
            .observer = {see_visit}, .points = points, .from = points[v], .to = p};
        w.visited = calloc(m.triangles, sizeof *w.visited);
        m.trace = &w.observer;
        place at = straight_walk(&m, points, v, p);
        free(w.visited);
        const char *wrong = wrong_place(&m, points, at, p);
        CLAIM("walk.P1", wrong == NULL, "from %u: %s", v, wrong);
        CLAIM("walk.P2", w.again == 0, "%u triangles visited again", w.again);
        CLAIM("walk.P2", w.missed == 0, "%u triangles are not on the way",
              w.missed);
    }
    mesh_free(&m);
}

/* P3: a walk asks 2 tests for each visited triangle and each at its first vertex,
 * and at most 3 in the last triangle; where it runs along the hull, 3 for each
 * triangle at a vertex on the way. Counted when nobody else asks. */
static void
the_walk_is_cheap(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 4 && affine_dimension(points, n - 1) == 2);
    point2 p = points[n - 1];
    mesh m;
    random_triangulation(points, n - 1, &m);
    vertex_id v = mesh_origin(&m, mesh_some_hull_edge(&m));
    bool is_vertex = false, in_line = false;
    uint64_t at_v = degree(&m, v), on_the_way = at_v;
    for (vertex_id w = 0; w + 1 < n; w++) {
        is_vertex = is_vertex || (points[w].x == p.x && points[w].y == p.y);
        if (w == v || mesh_leaving(&m, w) == NONE ||
            orient2d(points[v], points[w], p) != 0)
            continue;
        in_line = true;
        if (is_same_side(points[v], points[w], p) &&
            !is_same_side(points[w], points[v], p))
            on_the_way += degree(&m, w);
    }
    if (!is_vertex) {
        walker w = {.observer = {see_visit}};
        w.visited = calloc(m.triangles, sizeof *w.visited);
        m.trace = &w.observer;
        uint64_t before = predicate_count.orient2d;
        straight_walk(&m, points, v, p);
        uint64_t tests = predicate_count.orient2d - before;
        free(w.visited);
        CLAIM("walk.P3",
              tests <= (in_line ? 3 * on_the_way : 2 * at_v) + 2 * w.visits + 3,
              "%u tests, degree %u, %u visits", (unsigned)tests, (unsigned)at_v,
              w.visits);
    }
    mesh_free(&m);
}

/* E51: (0,4i), (3,4i+2) and a vertex below them to begin at: a walk along x = 3/2. */
static void
e51_a_walk_can_meet_every_triangle(void)
{
    for (uint32_t k = 2; k <= 200; k += 33) {
        uint32_t n = 2 * k + 1;
        point2 *points = malloc(n * sizeof *points);
        for (uint32_t i = 0; i < k; i++) {
            points[2 * i] = (point2){0, 4 * i};
            points[2 * i + 1] = (point2){3, 4 * i + 2};
        }
        points[n - 1] = (point2){1.5, -1};
        mesh m;
        CLAIM("E51", lawson_triangulate(points, n - 1, NULL, &m) == TRI_OK,
              "no mesh");
        uint32_t strip = 2 * (n - 1) - 2 - mesh_hull_size(&m);
        mesh_free(&m);
        CLAIM("E51", lawson_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
        walker w = {.observer = {see_visit}};
        w.visited = calloc(m.triangles, sizeof *w.visited);
        m.trace = &w.observer;
        straight_walk(&m, points, n - 1, (point2){1.5, 4 * k});
        uint32_t met = 0;
        for (halfedge_id e = 0; e < mesh_halfedges(&m); e += 3) {
            bool in_strip = mesh_in_triangle(&m, e);
            for (halfedge_id f = e; f < e + 3; f++)
                in_strip = in_strip && mesh_origin(&m, f) != n - 1;
            met += in_strip && w.visited[e / 3];
        }
        free(w.visited);
        mesh_free(&m);
        free(points);
        CLAIM("E51", strip == 2 * k - 2 && met == strip && w.again == 0,
              "m = %u: %u triangles, %u met", k, strip, met);
    }
}

/* E51: the same two columns, then 2k points alternately below and above them: each of
 * these walks goes from one end to the other. */
static void
e51_all_walks_can_be_long(void)
{
    enum { k = 50, n = 4 * k };
    point2 points[n];
    vertex_id order[n];
    for (uint32_t i = 0; i < k; i++) {
        points[2 * i] = (point2){0, 4 * i};
        points[2 * i + 1] = (point2){3, 4 * i + 2};
        points[2 * k + 2 * i] = (point2){1.5, -1.0 - i};
        points[2 * k + 2 * i + 1] = (point2){1.5, 4 * k + 1.0 + i};
    }
    for (uint32_t i = 0; i < n; i++)
        order[i] = i;
    bool visited[2 * n] = {false};
    walker w = {.observer = {see_visit}, .visited = visited};
    tri_options options = tri_options_default();
    options.order = order;
    options.locator = TRI_LOCATOR_WALK;
    options.trace = &w.observer;
    mesh m;
    CLAIM("E51", incremental_triangulate(points, n, &options, &m) == TRI_OK,
          "no mesh");
    mesh_free(&m);
    CLAIM("E51", w.visits >= (2 * k - 1) * (2 * k - 2), "%u visits for %d points",
          w.visits, n);
}

/* ---- Buckets and history. ---- */

/* Counts, for each point, the moves or visits before it is inserted; and looks
 * where points wait. */
typedef struct counter {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
    uint32_t *steps; /* point -> moves or visits */
    uint32_t
        *last_pair;    /* point -> the insertion of its last move, counted from 1 */
    uint32_t inserted; /* after the first edge */
    uint64_t first_moves; /* onto the two sides of the first edge */
    uint64_t moves, pairs;
    uint64_t
        inside;   /* pairs after which the point waits in a triangle, not outside */
    double *hull; /* i -> hull edges after the insertion of point i; or NULL */
} counter;

/* P1: q waits in a triangle that contains it, or with a hull edge that it sees or
 * that it is in line with. */
static void
check_waiting(const mesh *m, const point2 *points, vertex_id q, halfedge_id e)
{
    for (int i = 0; i < 3; i++) {
        vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
        CLAIM("buckets.P1",
              a == GHOST || b == GHOST ||
                  orient2d(points[a], points[b], points[q]) >= 0,
              "%u waits in a triangle at %u %u and lies right of it", q, a, b);
        e = mesh_next(e);
    }
}

static int
see_steps(trace *self, const mesh *m, const trace_event *event)
{
    counter *c = (counter *)self;
    c->inserted += event->kind == TRACE_SPLIT;
    if (event->kind == TRACE_MOVE ||
        (event->kind == TRACE_VISIT && event->a != NONE))
        c->steps[event->a]++;
    if (event->kind != TRACE_MOVE)
        return 0;
    if (c->points != NULL)
        check_waiting(m, c->points, event->a, event->edge);
    if (c->inserted == 0) {
        c->first_moves++;
        return 0;
    }
    c->moves++;
    c->pairs += c->last_pair[event->a] != c->inserted;
    c->last_pair[event->a] = c->inserted;
    return 0;
}

/* Looks at D_i, i = inserted + 2, before the next point is put into it. */
static int
see_rounds(trace *self, const mesh *m, const trace_event *event)
{
    counter *c = (counter *)self;
    if (event->kind == TRACE_MOVE && c->inserted > 0)
        c->steps[event->a] = mesh_in_triangle(m, event->edge) ? c->inserted : 0;
    if (event->kind == TRACE_LOCATE && c->inserted > 0) {
        for (vertex_id q = 0; q < m->points; q++)
            c->inside += c->steps[q] == c->inserted;
        c->hull[c->inserted + 2] = mesh_hull_size(m);
    }
    if (event->kind == TRACE_MOVE || event->kind == TRACE_SPLIT) {
        uint32_t steps = c->steps[event->a];
        see_steps(self, m, event);
        c->steps[event->a] = steps;
    }
    return 0;
}

static void
count_steps(const point2 *points, uint32_t n, tri_locator kind, uint64_t seed,
            counter *c)
{
    c->observer.see = c->hull != NULL ? see_rounds : see_steps;
    c->steps = calloc(n + 1, sizeof *c->steps);
    c->last_pair = calloc(n + 1, sizeof *c->last_pair);
    tri_options options = tri_options_default();
    options.locator = kind;
    options.seed = seed;
    options.trace = &c->observer;
    mesh m;
    tri_status status = incremental_triangulate(points, n, &options, &m);
    mesh_free(&m);
    free(c->last_pair);
    CLAIM("buckets.P1", status == TRI_OK, "%s", tri_status_text(status));
}

/* P1, and P2: the history graph makes each point take the same steps, later. */
static void
buckets_and_history_do_the_same(const point2 *points, uint32_t n)
{
    uint64_t seed = random_bits(test_random_source());
    counter now = {.points = points}, later = {0};
    count_steps(points, n, TRI_LOCATOR_BUCKETS, seed, &now);
    count_steps(points, n, TRI_LOCATOR_HISTORY, seed, &later);
    vertex_id differs = NONE;
    for (vertex_id q = 0; q < n; q++)
        if (now.steps[q] != later.steps[q])
            differs = q;
    uint32_t a = differs != NONE ? now.steps[differs] : 0;
    uint32_t b = differs != NONE ? later.steps[differs] : 0;
    free(now.steps);
    free(later.steps);
    CLAIM("buckets.P2", differs == NONE, "point %u: %u moves, %u nodes", differs, a,
          b);
}

/* ---- The mean number of moves, over many orders. ---- */

typedef struct sample {
    double sum, squares;
    uint32_t count;
} sample;

static void
sample_add(sample *s, double x)
{
    s->sum += x;
    s->squares += x * x;
    s->count++;
}

static double
sample_mean(const sample *s)
{
    return s->sum / s->count;
}

/* Four standard errors of the mean: it is missed by more once in 16,000 times. */
static double
sample_error(const sample *s)
{
    double mean = sample_mean(s), variance = s->squares / s->count - mean * mean;
    return 4 * sqrt(variance / s->count);
}

/* The sum over i = 3 .. n-1 of (n-i) 3/i (1 - h/(i+1)), h the mean number of hull
 * vertices of i+1 points. Of i+1 points each is as likely as another to be the one
 * that waits, so h/(i+1) is the probability that it waits outside of the others'
 * hull. */
static double
expected_inside(uint32_t n, const double *hull, uint32_t orders)
{
    double sum = 0;
    for (uint32_t i = 3; i + 2 < n; i++)
        sum += 3.0 * (n - i) / i * (1 - hull[i + 1] / orders / (i + 1));
    return sum;
}

static void
the_number_of_moves_is_as_expected(void)
{
    enum { n = 1000, orders = 150 };
    point2 points[n];
    double hull[n + 1], sizes[n + 1] = {0}, harmonic = 0;
    random_source *r = test_random_source();
    for (int i = 0; i < n; i++) {
        points[i] = (point2){random_unit(r), random_unit(r)};
        harmonic += 1.0 / (i + 1);
    }
    sample pairs = {0}, ratio = {0}, inside = {0};
    for (int k = 0; k < orders; k++) {
        counter c = {.hull = hull};
        count_steps(points, n, TRI_LOCATOR_BUCKETS, random_bits(r), &c);
        free(c.steps);
        for (int i = 3; i < n; i++)
            sizes[i] += hull[i];
        sample_add(&pairs, (double)(c.first_moves + c.pairs));
        sample_add(&ratio, (double)c.moves / (double)c.pairs);
        sample_add(&inside, (double)c.inside);
        CLAIM("E48", c.first_moves == n - 2,
              "%u points move at the second insertion", (unsigned)c.first_moves);
    }
    double bound = 3 * n * harmonic - 3 * n,
           expected = expected_inside(n, sizes, orders);
    printf("# (point, insertion) pairs: %.0f +- %.0f, at most %.1f expected\n"
           "# of these in triangles: %.0f +- %.0f, %.0f expected\n# moves for "
           "each: %.3f +- %.3f\n",
           sample_mean(&pairs), sample_error(&pairs), bound, sample_mean(&inside),
           sample_error(&inside), expected, sample_mean(&ratio),
           sample_error(&ratio));
    fflush(stdout);
    CLAIM("buckets.P3",
          fabs(sample_mean(&inside) - expected) < sample_error(&inside),
          "%.1f +- %.1f pairs, %.1f expected", sample_mean(&inside),
          sample_error(&inside), expected);
    CLAIM("buckets.P4", sample_mean(&pairs) - sample_error(&pairs) <= bound,
          "%.1f pairs", sample_mean(&pairs));
    CLAIM("E50",
          fabs(bound - 19456.4) < 0.1 && fabs(3 * n * log(n) - 20723.3) < 0.1,
          "the sum is %.1f", bound);
    CLAIM("E49",
          sample_mean(&ratio) - sample_error(&ratio) > 1.2 &&
              sample_mean(&ratio) + sample_error(&ratio) < 1.4,
          "%.3f +- %.3f moves for each pair", sample_mean(&ratio),
          sample_error(&ratio));
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Section 3.6.4: walk, buckets and history find the triangle");
    test_random("the walk", the_walk_finds_the_place, 1500, 40);
    test_near_degenerate("the walk", the_walk_finds_the_place, 3000, 20);
    test_grid_subsets("the walk", the_walk_finds_the_place, 3);
    test_random("the cost of a walk", the_walk_is_cheap, 1000, 100);
    test_grid_subsets("the cost of a walk", the_walk_is_cheap, 4);
    test_run("E51: a walk can be long", e51_a_walk_can_meet_every_triangle);
    test_run("E51: all walks can be long", e51_all_walks_can_be_long);
    test_random("buckets and history", buckets_and_history_do_the_same, 1000, 100);
    test_near_degenerate("buckets and history", buckets_and_history_do_the_same,
                         2000, 30);
    test_grid_subsets("buckets and history", buckets_and_history_do_the_same, 4);
    test_run("the number of moves", the_number_of_moves_is_as_expected);
    return test_end((test_minima){.trials = 60000,
                                  .largest_n = 90,
                                  .zeros = 100000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
