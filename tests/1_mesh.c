/* Chapter 1: the mesh is a sphere of triangles, at every moment that shows.
 *
 * Hypotheses: none. The meshes are those of a sweep, after each point; duplicates,
 * collinear points and 0 to 3 points are ordinary.
 *
 * An observer stops after each point that is attached. What it asserts is counted
 * from the half-edges themselves, never from the numbers that are to be checked.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

static uint32_t
used_vertices(const mesh *m)
{
    uint32_t used = 0;
    for (vertex_id v = 0; v < m->points; v++)
        used += m->leaving[v] != NONE;
    return used;
}

/* P1: as many triangles and edges as the vertices allow. */
static void
check_counts(const mesh *m, uint32_t u)
{
    uint32_t edges = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        edges += e < mesh_twin(m, e);
    CLAIM("mesh.P1", m->triangles == 2 * u - 2, "%u triangles at %u vertices",
          m->triangles, u);
    CLAIM("mesh.P1", edges == 3 * u - 3, "%u edges at %u vertices", edges, u);
}

/* P2: from each hull edge to the next, back again, and once around. */
static void
check_hull(const mesh *m)
{
    uint32_t hull_edges = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (!mesh_is_hull_edge(m, e))
            continue;
        hull_edges++;
        halfedge_id next = mesh_hull_next(m, e);
        CLAIM("mesh.P2", mesh_is_hull_edge(m, next), "%u is followed by %u", e, next);
        CLAIM("mesh.P2", mesh_origin(m, next) == mesh_dest(m, e),
              "%u ends elsewhere than %u begins", e, next);
        CLAIM("mesh.P2", mesh_hull_prev(m, next) == e, "no way back to %u", e);
    }
    halfedge_id first = mesh_some_hull_edge(m), e = first;
    uint32_t walked = 0;
    do {
        walked++;
        e = mesh_hull_next(m, e);
    } while (e != first && walked <= hull_edges);
    CLAIM("mesh.P2", walked == hull_edges, "%u steps along %u hull edges", walked,
          hull_edges);
    CLAIM("mesh.P2", mesh_hull_size(m) == hull_edges, "mesh_hull_size: %u",
          mesh_hull_size(m));
}

/* P4: the half-edges that leave v, by going around it. */
static uint32_t
check_star(const mesh *m, vertex_id v)
{
    uint32_t degree = 0;
    halfedge_id first = mesh_leaving(m, v), e = first;
    do {
        CLAIM("mesh.P4", mesh_origin(m, e) == v, "%u does not leave %u", e, v);
        degree++;
        e = mesh_around(m, e);
    } while (e != first && degree <= mesh_halfedges(m));
    uint32_t leave = 0;
    for (halfedge_id f = 0; f < mesh_halfedges(m); f++)
        leave += mesh_origin(m, f) == v;
    CLAIM("mesh.P4", degree == leave, "%u met around %u, and %u leave it", degree, v,
          leave);
    return degree;
}

static void
check_stars(const mesh *m, uint32_t u)
{
    uint32_t degrees = check_star(m, GHOST);
    for (vertex_id v = 0; v < m->points; v++)
        if (mesh_leaving(m, v) != NONE)
            degrees += check_star(m, v);
    CLAIM("mesh.P4", degrees == 6 * u - 6, "degrees add up to %u for %u vertices",
          degrees, u);
}

static void
check_mesh(const mesh *m)
{
    uint32_t u = used_vertices(m);
    check_counts(m, u);
    mesh so_far = *m; /* as if the other points did not exist */
    so_far.locations = u;
    claim_verdict("mesh.P3", mesh_check(&so_far));
    check_hull(m);
    check_stars(m, u);
}

static int
see_attached(trace *self, const mesh *m, const trace_event *event)
{
    (void)self;
    if (event->kind == TRACE_ATTACH)
        check_mesh(m);
    return 0;
}

static void
every_step_leaves_a_sphere(const point2 *points, uint32_t n)
{
    trace observer = {see_attached};
    tri_options options = tri_options_default();
    options.trace = &observer;
    mesh m;
    tri_status status = sweep_triangulate(points, n, &options, &m);
    CLAIM("mesh.P3", status == TRI_OK, "%s", tri_status_text(status));
    if (m.locations < 2)
        CLAIM("mesh.P1", m.triangles == 0 && mesh_some_hull_edge(&m) == NONE,
              "%u triangles at %u locations", m.triangles, m.locations);
    else
        check_mesh(&m);
    mesh_free(&m);
}

/* P5, on the points (x,x): they are on a line however x is rounded. */
static void
a_line_is_a_path(const point2 *points, uint32_t n)
{
    point2 *on_line = memory_array(n, sizeof *on_line);
    HYPOTHESIS(on_line != NULL);
    for (uint32_t i = 0; i < n; i++)
        on_line[i] = (point2){points[i].x, points[i].x};
    mesh m;
    tri_status status = sweep_triangulate(on_line, n, NULL, &m);
    CLAIM("mesh.P5", status == TRI_OK, "%s", tri_status_text(status));
    uint32_t u = m.locations, ends = 0;
    if (u >= 2)
        CLAIM("mesh.P5", mesh_hull_size(&m) == 2 * u - 2, "%u hull edges, u = %u",
              mesh_hull_size(&m), u);
    for (vertex_id v = 0; v < n; v++) {
        uint32_t rays = 0, degree = 0;
        halfedge_id first = mesh_leaving(&m, v), e = first;
        if (first == NONE)
            continue;
        do {
            rays += mesh_dest(&m, e) == GHOST;
            degree++;
            e = mesh_around(&m, e);
        } while (e != first);
        CLAIM("mesh.P5", degree == 2 * rays && rays <= 2,
              "%u has %u edges, %u of them to infinity", v, degree, rays);
        ends += rays == 1;
    }
    CLAIM("mesh.P5", ends == (u >= 2 ? 2 : 0), "%u ends, u = %u", ends, u);
    mesh_free(&m);
    memory_free(on_line);
}

/* The first edge by itself: nothing is attached to make it. */
static void
the_first_edge_is_a_sphere(void)
{
    mesh m;
    CLAIM("mesh.P3", mesh_init(&m, 5, 2) == TRI_OK, "no memory for two vertices");
    halfedge_id e = mesh_start(&m, 3, 1);
    CLAIM("mesh.P3", mesh_origin(&m, e) == 3 && mesh_dest(&m, e) == 1,
          "from %u to %u", mesh_origin(&m, e), mesh_dest(&m, e));
    check_mesh(&m);
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Chapter 1: the mesh is a sphere of triangles");
    test_run("the first edge", the_first_edge_is_a_sphere);
    test_random("every step", every_step_leaves_a_sphere, 2000, 40);
    test_near_degenerate("every step", every_step_leaves_a_sphere, 2000, 25);
    test_grid_subsets("every step", every_step_leaves_a_sphere, 3);
    const point2 corners[] = {{0, 0}, {2, 0}, {0, 2}, {1, 1}, {2, 2}, {1, 0}};
    test_permutations("every step", every_step_leaves_a_sphere, corners, 6);
    test_random("a path", a_line_is_a_path, 2000, 60);
    test_near_degenerate("a path", a_line_is_a_path, 1000, 40);
    return test_end((test_minima){.trials = 8000, .largest_n = 55, .zeros = 10000});
}
