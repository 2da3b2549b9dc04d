/* Theorem 4: among all triangulations of a point set, the Delaunay triangulation
 * maximises the minimum angle.
 *
 * Hypotheses: none in the theorem. Here the coordinates are whole numbers up to
 * 1000, so that angles are compared exactly (see harness/angles.h).
 */
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/angles.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

/* ---- Angles. ---- */

static bool
at_least(angle large, angle small)
{
    return compare_angles(large, small) >= 0;
}

static angle
smaller(angle s, angle t)
{
    return at_least(s, t) ? t : s;
}

/* The smallest angle of the triangulation. Requires: there is a triangle. */
static angle
minimum_angle(const mesh *m, const point2 *points)
{
    angle least = {-1, 0}; /* a half turn: larger than every angle */
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_in_triangle(m, e))
            least = smaller(least, angle_at(points[mesh_origin(m, e)],
                                            points[mesh_dest(m, e)],
                                            points[mesh_apex(m, e)]));
    return least;
}

/* ---- The proof, at every flip. ---- */

typedef struct watcher {
    trace observer; /* first: see lib/trace.h */
    const point2 *points;
} watcher;

static int
see_six_angles(trace *self, const mesh *m, const trace_event *f)
{
    (void)m;
    const point2 *p = ((watcher *)self)->points;
    if (f->kind != TRACE_FLIP)
        return 0;
    point2 a = p[f->a], b = p[f->b], c = p[f->c], d = p[f->d];
    /* With the names of Figure 11. Old: in abc and in bad. */
    angle alpha1 = angle_at(a, b, c), beta1 = angle_at(b, a, c),
          gamma = angle_at(c, a, b);
    angle alpha2 = angle_at(a, b, d), beta2 = angle_at(b, a, d),
          delta = angle_at(d, a, b);
    /* New: in cdb and in dca. */
    angle gamma1 = angle_at(c, b, d), delta1 = angle_at(d, b, c),
          beta = angle_at(b, c, d);
    angle gamma2 = angle_at(c, a, d), delta2 = angle_at(d, a, c),
          alpha = angle_at(a, c, d);
    CLAIM("thm4.P1", at_least(gamma1, alpha2), "gamma1 < alpha2 when %u %u is flipped",
          f->a, f->b);
    CLAIM("thm4.P1", at_least(delta1, alpha1), "delta1 < alpha1 at %u %u", f->a, f->b);
    CLAIM("thm4.P1", at_least(gamma2, beta2), "gamma2 < beta2 at %u %u", f->a, f->b);
    CLAIM("thm4.P1", at_least(delta2, beta1), "delta2 < beta1 at %u %u", f->a, f->b);
    CLAIM("thm4.P1", at_least(alpha, alpha1), "alpha < alpha1 at %u %u", f->a, f->b);
    CLAIM("thm4.P1", at_least(beta, beta1), "beta < beta1 at %u %u", f->a, f->b);
    angle before = smaller(smaller(smaller(alpha1, beta1), smaller(alpha2, beta2)),
                           smaller(gamma, delta));
    angle after = smaller(smaller(smaller(gamma1, delta1), smaller(gamma2, delta2)),
                          smaller(alpha, beta));
    CLAIM("thm4.P2", at_least(after, before), "a smaller angle after flipping %u %u",
          f->a, f->b);
    return 0;
}

/* The lifted surface over the two triangles, as a tetrahedron below it: the lift of
 * whole numbers up to 1000 is exact. */
static int
see_the_surface_sink(trace *self, const mesh *m, const trace_event *f)
{
    const point2 *p = ((watcher *)self)->points;
    if (f->kind != TRACE_FLIP)
        return 0;
    point3 lift[4];
    const vertex_id v[4] = {f->a, f->b, f->c, f->d};
    for (int i = 0; i < 4; i++) {
        point2 q = p[v[i]];
        lift[i] = (point3){q.x, q.y, q.x * q.x + q.y * q.y};
    }
    CLAIM("fig10.P3", orient3d(lift[0], lift[1], lift[2], lift[3]) > 0,
          "the tetrahedron %u %u %u %u lies above the surface", v[0], v[1], v[2], v[3]);
    (void)m;
    return 0;
}

/* Lawson's flips on a triangulation of whole points, watched. */
static void
flip_watched(mesh *m, watcher *w)
{
    edge_stack L;
    CLAIM("thm4.P2", edge_stack_init(&L, m) == TRI_OK, "out of memory");
    m->trace = &w->observer;
    push_all_edges(&L);
    lawson_flip(&L, w->points);
    edge_stack_free(&L);
    m->trace = NULL;
}

/* ---- The statements. ---- */

static void
no_flip_makes_a_smaller_angle(const point2 *drawn, uint32_t n)
{
    point2 *points = whole_points(drawn, n,
                                  random_below(test_random_source(), 2) ? 1000 : 12);
    watcher angles = {{see_six_angles}, points},
            surface = {{see_the_surface_sink}, points};
    for (int which = 0; which < 2; which++) {
        mesh m;
        random_triangulation(points, n, &m);
        angle before = minimum_angle(&m, points);
        flip_watched(&m, which == 0 ? &angles : &surface);
        angle after = minimum_angle(&m, points);
        mesh_free(&m);
        CLAIM("thm4.P3", at_least(after, before),
              "the minimum angle was larger before");
    }
    free(points);
}

/* E39: flips among cocircular sites keep the minimum angle, so every Delaunay
 * triangulation has the same one. */
static void
e39_ties_share_the_minimum(const point2 *points, uint32_t n)
{
    mesh m;
    CLAIM("E39", lawson_triangulate(points, n, NULL, &m) == TRI_OK, "no mesh");
    angle least = minimum_angle(&m, points);
    uint32_t ties = 0;
    for (int i = 0; i < 1000; i++) {
        halfedge_id e = random_below(test_random_source(), mesh_halfedges(&m));
        if (!mesh_is_interior(&m, e) || !is_flippable(&m, points, e) ||
            incircle(points[mesh_origin(&m, e)], points[mesh_dest(&m, e)],
                     points[mesh_apex(&m, e)],
                     points[mesh_apex(&m, mesh_twin(&m, e))]) != 0)
            continue;
        flip(&m, e);
        ties++;
        angle now = minimum_angle(&m, points);
        CLAIM("E39", at_least(now, least) && at_least(least, now), "after %u ties",
              ties);
    }
    mesh_free(&m);
    CLAIM("E39", ties > 100, "only %u ties", ties);
}

int
main(int argc, char **argv)
{
    const point2 circle[] = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-5, 0}, {0, -5}};
    test_begin(argc, argv, "Theorem 4: Delaunay maximises the minimum angle");
    test_random("no flip makes a smaller angle", no_flip_makes_a_smaller_angle, 4000,
                40);
    test_points("E39: ties share the minimum", e39_ties_share_the_minimum, circle, 6);
    return test_end((test_minima){.trials = 4000, .largest_n = 30, .zeros = 1000});
}
