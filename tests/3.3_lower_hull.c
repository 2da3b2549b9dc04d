/* Section 3.3: the lower faces of the convex hull of the lifted sites,
 * projected, are a Delaunay triangulation.
 *
 * Hypotheses: none. The notes' "general position" is not needed: cocircular
 * sites lie in one facet, which is cut into triangles, and sites whose lifted
 * hull is flat (E26) are triangulated otherwise.
 *
 * The hull is built point by point, in a random order, and after each point it
 * is compared with what a convex hull is.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.3_lifting_map/lifting.h"
#include "chapters/3.3_lifting_map/lower_hull.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>

/* ---- The convex hull is an intersection of half-planes. ---- */

/* (p-v).(q-v); exact for small whole coordinates. */
static double
dot_at(point2 v, point2 p, point2 q)
{
    return (p.x - v.x) * (q.x - v.x) + (p.y - v.y) * (q.y - v.y);
}

/* Is x in the triangle of a, b, c, which may be a segment or a point? */
static bool
in_triangle(point2 a, point2 b, point2 c, point2 x)
{
    int turn = orient2d(a, b, c);
    int ab = orient2d(a, b, x), bc = orient2d(b, c, x), ca = orient2d(c, a, x);
    if (turn != 0)
        return ab * turn >= 0 && bc * turn >= 0 && ca * turn >= 0;
    bool between =
        dot_at(x, a, b) <= 0 || dot_at(x, b, c) <= 0 || dot_at(x, c, a) <= 0;
    return ab == 0 && bc == 0 && ca == 0 && between;
}

/* Is x in the triangle of some three of the points? */
static bool
in_hull(const point2 *p, uint32_t n, point2 x)
{
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = 0; b <= a; b++)
            for (uint32_t c = 0; c <= b; c++)
                if (in_triangle(p[a], p[b], p[c], x))
                    return true;
    return false;
}

/* Is x outside of a half-plane that holds all points? Those of the proof are
 * asked: left of a line through two points, or bounded by a line at one point,
 * across the direction to x. */
static bool
cut_off(const point2 *p, uint32_t n, point2 x)
{
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = 0; b < n; b++) {
            bool beside = orient2d(p[a], p[b], x) < 0;
            bool at = dot_at(p[a], x, x) > 0;
            for (uint32_t c = 0; c < n; c++) {
                beside = beside && orient2d(p[a], p[b], p[c]) >= 0;
                at = at && dot_at(p[a], p[c], x) <= 0;
            }
            if (beside || at)
                return true;
        }
    return false;
}

static void
half_planes(const point2 *points, uint32_t n)
{
    (void)points;
    HYPOTHESIS(n > 0);
    point2 *p = whole_points(NULL, n, 7), *x = whole_points(NULL, 1, 7);
    bool in = in_hull(p, n, *x), out = cut_off(p, n, *x);
    CLAIM("halfspace.P1", in == !out, "(%g,%g) is %s the hull and %s", x->x,
          x->y, in ? "in" : "not in", out ? "cut off" : "not cut off");
    free(x);
    free(p);
}

/* ---- The hull in space, step by step. ---- */

/* The distinct locations in a random order. */
static vertex_id *
shuffled(const point2 *points, uint32_t n, uint32_t *locations)
{
    vertex_id *L = malloc((n + 1) * sizeof *L);
    CLAIM("lower.P1",
          sort_along(points, n, (point2){1, 0}, L, locations) == TRI_OK,
          "out of memory");
    for (uint32_t i = *locations; i > 1; i--) {
        uint32_t k = random_below(test_random_source(), i);
        vertex_id v = L[k];
        L[k] = L[i - 1];
        L[i - 1] = v;
    }
    return L;
}

static int
side_of_face(const lifted_hull *H, triangle_id t, vertex_id p)
{
    const vertex_id *c = H->faces.corner[t];
    return orient3d_lifted(H->points[c[0]], H->points[c[1]], H->points[c[2]],
                           H->points[p]);
}

static uint32_t
faces_at(const lifted_hull *H, vertex_id p)
{
    uint32_t faces = 0;
    for (halfedge_id e = 0; e < 3 * H->faces.count; e++)
        faces += side_origin(H->faces, e) == p;
    return faces;
}

/* A closed surface: sides in pairs, one cycle of faces around each vertex. */
static void
check_closed(const lifted_hull *H, const vertex_id *in, uint32_t v)
{
    for (halfedge_id e = 0; e < 3 * H->faces.count; e++) {
        halfedge_id f = H->twin[e];
        CLAIM("lower.P1",
              H->twin[f] == e && e / 3 != f / 3 &&
                  side_origin(H->faces, e) == side_dest(H->faces, f) &&
                  side_dest(H->faces, e) == side_origin(H->faces, f),
              "sides %u and %u are no twins", e, f);
    }
    for (uint32_t i = 0; i < v; i++) {
        halfedge_id first = 0;
        while (side_origin(H->faces, first) != in[i])
            if (++first == 3 * H->faces.count)
                CLAIM("lower.P1", false, "%u is on no face", in[i]);
        uint32_t around = 0;
        halfedge_id e = first;
        do {
            e = H->twin[e % 3 == 0 ? e + 2 : e - 1];
            around++;
        } while (e != first);
        CLAIM("lower.P1", around == faces_at(H, in[i]),
              "%u of %u faces around %u", around, faces_at(H, in[i]), in[i]);
    }
}

/* The v sites in[] have been added, in[v-1] last, and it saw `seen` faces. */
static void
check_step(const lifted_hull *H, const vertex_id *in, uint32_t v, uint32_t seen)
{
    CLAIM("lower.P2", H->faces.count == 2 * v - 4, "%u faces, %u vertices",
          H->faces.count, v);
    CLAIM("lower.P2", faces_at(H, in[v - 1]) == seen + 2,
          "%u faces seen, %u made", seen, faces_at(H, in[v - 1]));
    check_closed(H, in, v);
    for (triangle_id t = 0; t < H->faces.count; t++)
        for (uint32_t i = 0; i < v; i++)
            CLAIM("lower.P1", side_of_face(H, t, in[i]) <= 0,
                  "%u is outside of face %u", in[i], t);
}

static void
add_and_check(lifted_hull *H, vertex_id *in, uint32_t *v, vertex_id p)
{
    uint32_t seen = 0;
    for (triangle_id t = 0; t < H->faces.count; t++)
        seen += side_of_face(H, t, p) > 0;
    CLAIM("lower.P2", 0 < seen && seen < H->faces.count,
          "%u sees %u of %u faces", p, seen, H->faces.count);
    lifted_hull_add(H, p);
    in[(*v)++] = p;
    check_step(H, in, *v, seen);
}

static void
every_step_is_a_hull(const point2 *points, uint32_t n)
{
    uint32_t u, off = 3, v = 3;
    vertex_id *L = shuffled(points, n, &u), *in = malloc((n + 3) * sizeof *in);
    while (off < u && orient3d_lifted(points[L[0]], points[L[1]], points[L[2]],
                                      points[L[off]]) == 0)
        off++;
    lifted_hull H = {0};
    if (off < u) {
        CLAIM("lower.P1",
              lifted_hull_start(&H, points, n, u, L[0], L[1], L[2]) == TRI_OK,
              "out of memory");
        for (int i = 0; i < 3; i++)
            in[i] = L[i];
        add_and_check(&H, in, &v, L[off]);
        for (uint32_t i = 3; i < u; i++)
            if (i != off)
                add_and_check(&H, in, &v, L[i]);
    }
    lifted_hull_free(&H);
    free(in);
    free(L);
}

/* ---- Its lower and its upper side. ---- */

/* P3: without gaps and overlaps, in facets with many corners, too. P4: the
 * circles are empty. P7: the questions that were asked. */
static void
the_lower_side_is_delaunay(const point2 *points, uint32_t n)
{
    uint32_t u;
    vertex_id *L = shuffled(points, n, &u);
    lifted_hull H;
    triangle_list lower;
    verdict v = verdict_holds();
    uint64_t before = predicate_count.incircle;
    CLAIM("lower.P7", lifted_hull_of(&H, points, n, L, u) == TRI_OK,
          "out of memory");
    uint64_t asked = predicate_count.incircle - before;
    if (u >= 3 && H.faces.count > 0) {
        uint64_t faces = (uint64_t)(u - 2) * (u - 3);
        CLAIM("lower.P7", faces < asked && asked <= faces + u - 3,
              "%llu questions for %u locations", (unsigned long long)asked, u);
    }
    CLAIM("lower.P3", lower_faces(&H, &lower) == TRI_OK, "out of memory");
    test_picture(lower);
    if (H.faces.count > 0) {
        CLAIM("lower.P3", is_triangulation(points, n, lower, &v) == TRI_OK,
              "no memory");
        claim_verdict("lower.P3", v);
        for (uint32_t t = 0; t < lower.count; t++)
            for (vertex_id p = 0; p < n; p++) {
                const vertex_id *c = lower.corner[t];
                CLAIM("lower.P4",
                      incircle(points[c[0]], points[c[1]], points[c[2]],
                               points[p]) <= 0,
                      "%u is in the circle of %u %u %u", p, c[0], c[1], c[2]);
            }
    }
    triangle_list_free(&lower);
    lifted_hull_free(&H);
    free(L);
}

/* The algorithm as a whole, certified by the check of another section. */
static void
lift_triangulates(const point2 *points, uint32_t n)
{
    mesh m;
    triangle_list list;
    verdict v;
    tri_options options = tri_options_default();
    options.direction = random_direction();
    tri_status status = lift_triangulate(points, n, &options, &m);
    CLAIM("lower.P4", status == TRI_OK, "%s", tri_status_text(status));
    claim_verdict("lower.P4", mesh_check(&m));
    CLAIM("lower.P4", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM("lower.P4", is_delaunay(points, n, list, &v) == TRI_OK,
          "out of memory");
    claim_verdict("lower.P4", v);
    for (vertex_id p = 0; p < n;
         p++) /* the lowest index at a location is used */
        for (vertex_id q = 0; q < p; q++)
            if (points[p].x == points[q].x && points[p].y == points[q].y)
                CLAIM("lower.P4", mesh_leaving(&m, p) == NONE, "%u is %u again",
                      p, q);
    triangle_list_free(&list);
    mesh_free(&m);
}

/* Upper faces: the circle of each holds all sites, and they triangulate the
 * hull of those that are their corners. */
static void
the_upper_side_is_farthest(const point2 *points, uint32_t n)
{
    uint32_t u, corners = 0;
    vertex_id *L = shuffled(points, n, &u);
    lifted_hull H;
    triangle_list upper;
    CLAIM("upper.P1",
          lifted_hull_of(&H, points, n, L, u) == TRI_OK &&
              upper_faces(&H, &upper) == TRI_OK,
          "out of memory");
    CLAIM("upper.P1", (upper.count > 0) == (H.faces.count > 0),
          "no upper faces");
    point2 *corner = malloc((n + 1) * sizeof *corner);
    vertex_id *place =
        malloc((n + 1) * sizeof *place); /* point -> its place there */
    for (vertex_id p = 0; p < n; p++)
        place[p] = NONE;
    for (uint32_t t = 0; t < upper.count; t++)
        for (int i = 0; i < 3; i++) {
            vertex_id *c = &upper.corner[t][i];
            if (place[*c] == NONE) {
                place[*c] = corners;
                corner[corners++] = points[*c];
            }
            *c = place[*c];
        }
    verdict v = verdict_holds();
    CLAIM("upper.P1", is_triangulation(corner, corners, upper, &v) == TRI_OK,
          "no memory");
    for (uint32_t t = 0; t < upper.count; t++)
        for (vertex_id p = 0; p < n; p++) {
            const vertex_id *c = upper.corner[t];
            CLAIM("upper.P1",
                  incircle(corner[c[0]], corner[c[1]], corner[c[2]],
                           points[p]) >= 0,
                  "%u is outside of the circle of an upper face", p);
        }
    triangle_list_free(&upper);
    lifted_hull_free(&H);
    free(place);
    free(corner);
    free(L);
    claim_verdict("upper.P1", v);
}

/* ---- Flat hulls. ---- */

/* The first three sites and p on one circle or one line, by whole numbers: with
 * a = 0, the determinant of the columns x, y, x^2+y^2 of b, c, p. */
static bool
with_the_first_three(const point2 *q, const vertex_id *L, vertex_id p)
{
    point2 a = q[L[0]];
    int64_t row[3][3];
    const vertex_id v[3] = {L[1], L[2], p};
    for (int i = 0; i < 3; i++) {
        int64_t x = (int64_t)(q[v[i]].x - a.x), y = (int64_t)(q[v[i]].y - a.y);
        row[i][0] = x;
        row[i][1] = y;
        row[i][2] = x * x + y * y;
    }
    int64_t det = 0;
    for (int i = 0; i < 3; i++) {
        const int64_t *s = row[(i + 1) % 3], *t = row[(i + 2) % 3];
        det += row[i][2] * (s[0] * t[1] - s[1] * t[0]);
    }
    return det == 0;
}

static void
flat_is_cocircular_or_collinear(const point2 *points, uint32_t n)
{
    (void)points;
    uint32_t u;
    point2 *p = whole_points(NULL, n, 3);
    vertex_id *L = shuffled(p, n, &u);
    bool together = true;
    for (uint32_t i = 3; i < u; i++)
        together = together && with_the_first_three(p, L, L[i]);
    lifted_hull H;
    CLAIM("lower.P5", lifted_hull_of(&H, p, n, L, u) == TRI_OK,
          "out of memory");
    bool flat = H.faces.count == 0;
    lifted_hull_free(&H);
    CLAIM("lower.P5", flat == together, "%u locations: the hull is %sflat", u,
          flat ? "" : "not ");
    lift_triangulates(p, n);
    free(L);
    free(p);
}

/* All twelve whole points of a circle, and the square. */
static void
e26_flat(void)
{
    const point2 circle[] = {{5, 0},  {4, 3},  {3, 4},   {0, 5},   {-3, 4},
                             {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5},
                             {3, -4}, {4, -3}, {0, 0}};
    const point2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const vertex_id L[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    lifted_hull H;
    CLAIM("E26",
          lifted_hull_of(&H, square, 4, L, 4) == TRI_OK && H.faces.count == 0,
          "the square's hull has %u faces", H.faces.count);
    CLAIM("E26",
          lifted_hull_of(&H, circle, 13, L, 12) == TRI_OK && H.faces.count == 0,
          "the circle's hull has %u faces", H.faces.count);
    CLAIM("E26",
          lifted_hull_of(&H, circle, 13, L, 13) == TRI_OK &&
              H.faces.count == 22,
          "with its centre it has %u faces", H.faces.count);
    lifted_hull_free(&H);
    mesh m;
    CLAIM("E26", lift_triangulate(square, 4, NULL, &m) == TRI_OK, "no mesh");
    CLAIM("E26", m.triangles == 6 && mesh_hull_size(&m) == 4,
          "%u triangles, %u outside", m.triangles - mesh_hull_size(&m),
          mesh_hull_size(&m));
    mesh_free(&m);
    lift_triangulates(square, 4);
    lift_triangulates(circle, 12);
    lift_triangulates(circle, 13);
}

/* ---- The check. ---- */

/* Some triangulation, of which a part is Delaunay. Looking at single edges must
 * say what looking at all sites and all triangles says. */
static void
the_check_is_enough(const point2 *points, uint32_t n)
{
    mesh m;
    triangle_list list;
    verdict v;
    random_triangulation(points, n, &m);
    if (random_below(test_random_source(), 2) == 0) {
        mesh_free(&m);
        CLAIM("lower.P6", lift_triangulate(points, n, NULL, &m) == TRI_OK,
              "no mesh");
    }
    CLAIM("lower.P6", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    test_picture(list);
    CLAIM("lower.P6", is_lower_hull(points, n, list, &v) == TRI_OK,
          "out of memory");
    bool below = false;
    for (uint32_t t = 0; t < list.count; t++)
        for (vertex_id p = 0; p < n; p++) {
            const vertex_id *c = list.corner[t];
            below = below || orient3d_lifted(points[c[0]], points[c[1]],
                                             points[c[2]], points[p]) > 0;
        }
    CLAIM("lower.P6", v.holds == !below, "the check says %s",
          v.holds ? "yes" : v.because);
    if (!v.holds) { /* the witness is one */
        const vertex_id *w = v.witness;
        CLAIM("lower.P6",
              v.witnesses == 4 &&
                  orient3d_lifted(points[w[0]], points[w[1]], points[w[2]],
                                  points[w[3]]) *
                          orient2d(points[w[0]], points[w[1]], points[w[2]]) >
                      0,
              "no witness: %s", v.because);
    }
    if (list.count > 0) { /* what is no triangulation is no lower hull */
        list.count--;
        CLAIM("lower.P6",
              is_lower_hull(points, n, list, &v) == TRI_OK && !v.holds,
              "a triangle may be missing");
    }
    triangle_list_free(&list);
    mesh_free(&m);
}

/* ---- Refusals, and memory that runs out. ---- */

static int
never_called(trace *self, const mesh *m, const trace_event *event)
{
    (void)self;
    (void)m;
    return event != NULL; /* stops the run */
}

/* Also where the hull is flat and the sweep does the work. */
static void
nothing_is_reported(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.25}};
    trace watching = {never_called};
    tri_options options = tri_options_default();
    options.trace = &watching;
    for (uint32_t n = 4; n <= 5; n++) {
        mesh m;
        tri_status status = lift_triangulate(points, n, &options, &m);
        CLAIM("lower.P5", status == TRI_OK, "%u sites: %s", n, tri_status_text(status));
        mesh_free(&m);
    }
}

static void
refused_or_out_of_memory(void)
{
    point2 points[40];
    for (int i = 0; i < 40; i++)
        points[i] = (point2){i % 7, i * i % 11};
    mesh m;
    tri_options options = tri_options_default();
    options.direction = (point2){0, 0};
    CLAIM("lower.P4",
          lift_triangulate(points, 40, &options, &m) == TRI_BAD_OPTION &&
              m.halfedge == NULL,
          "a zero direction was accepted");
    tri_status status = TRI_OUT_OF_MEMORY;
    unsigned long k;
    for (k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = lift_triangulate(points, 40, NULL, &m);
        memory_fail_at(0);
        CLAIM("lower.P4",
              status == TRI_OK ||
                  (status == TRI_OUT_OF_MEMORY && m.halfedge == NULL),
              "allocation %lu: %s", k, tri_status_text(status));
    }
    CLAIM("lower.P4", k > 10, "only %lu allocations could fail", k - 2);

    triangle_list list;
    verdict v;
    CLAIM("lower.P6", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    mesh_free(&m);
    status = TRI_OUT_OF_MEMORY;
    for (k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = is_lower_hull(points, 40, list, &v);
        memory_fail_at(0);
        CLAIM("lower.P6", status == TRI_OK || status == TRI_OUT_OF_MEMORY, "%s",
              tri_status_text(status));
    }
    claim_verdict("lower.P6", v);
    triangle_list_free(&list);
    lifted_hull H;
    CLAIM("lower.P1",
          lifted_hull_start(&H, points, 40, UINT32_MAX, 0, 1, 2) ==
                  TRI_TOO_MANY_POINTS &&
              H.faces.corner == NULL,
          "room for 2^32 - 1 locations");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Delaunay is the lower hull of the lifted sites, projected");
    test_random("the hull as an intersection of half-planes", half_planes, 6000,
                9);
    test_random("the hull in space, at every step", every_step_is_a_hull, 1000,
                30);
    test_near_degenerate("the hull in space, at every step",
                         every_step_is_a_hull, 1500, 12);
    test_grid_subsets("the hull in space, at every step", every_step_is_a_hull,
                      3);
    test_random("its lower side", the_lower_side_is_delaunay, 1500, 60);
    test_near_degenerate("its lower side", the_lower_side_is_delaunay, 1500,
                         20);
    test_random("its upper side", the_upper_side_is_farthest, 1500, 60);
    test_near_degenerate("its upper side", the_upper_side_is_farthest, 1500,
                         20);
    test_random("lift_triangulate", lift_triangulates, 1500, 120);
    test_near_degenerate("lift_triangulate", lift_triangulates, 1500, 40);
    test_grid_subsets("lift_triangulate", lift_triangulates, 4);
    test_random("flat hulls", flat_is_cocircular_or_collinear, 4000, 12);
    test_run("E26: the square and the circle", e26_flat);
    test_random("is_lower_hull", the_check_is_enough, 1500, 30);
    test_near_degenerate("is_lower_hull", the_check_is_enough, 1500, 15);
    test_run("nothing is reported", nothing_is_reported);
    test_run("refused, out of memory", refused_or_out_of_memory);
    return test_end((test_minima){.trials = 80000,
                                  .largest_n = 100,
                                  .zeros = 100000,
                                  .expansions = 100000,
                                  .wide = 10000});
}
