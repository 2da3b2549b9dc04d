/* lib/mesh: mesh_check refutes every kind of damage, and sizes are checked.
 *
 * Hypotheses: none. A mesh of 2.3 is damaged in one field at a time.
 */
#include "lib/mesh.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

#include <string.h>

static mesh
some_mesh(const point2 *points, uint32_t n)
{
    mesh m;
    tri_status status = sweep_triangulate(points, n, NULL, &m);
    CLAIM("mesh_check", status == TRI_OK, "%s", tri_status_text(status));
    return m;
}

static void
expect_refuted(const mesh *m, const char *damage)
{
    verdict v = mesh_check(m);
    CLAIM("mesh_check", !v.holds, "it holds after damage to %s", damage);
    CLAIM("mesh_check", strlen(v.because) > 10, "no sentence after damage to %s",
          damage);
    for (int i = 0; i < v.witnesses; i++)
        CLAIM("mesh_check", v.witness[i] < m->points, "witness %u is no point",
              (unsigned)v.witness[i]);
}

/* Any number but the present one: often the next, or one that names nothing. */
static uint32_t
another(uint32_t present, uint32_t below)
{
    random_source *r = test_random_source();
    const uint32_t choice[4] = {present + 1, present - 1, NONE, random_below(r, below)};
    uint32_t number;
    do
        number = random_below(r, 2) == 0 ? random_below(r, below)
                                         : choice[random_below(r, 4)];
    while (number == present);
    return number;
}

static void
a_sound_mesh_holds(const point2 *points, uint32_t n)
{
    mesh m = some_mesh(points, n);
    claim_verdict("mesh_check", mesh_check(&m));
    mesh_free(&m);
}

static void
damage_to_half_edges_is_seen(const point2 *points, uint32_t n)
{
    mesh m = some_mesh(points, n);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++) {
        mesh_halfedge sound = m.halfedge[e];
        m.halfedge[e].origin = another(sound.origin, m.points + 2);
        expect_refuted(&m, "an origin");
        m.halfedge[e] = sound;
        m.halfedge[e].twin = another(sound.twin, mesh_halfedges(&m) + 2);
        expect_refuted(&m, "a twin");
        m.halfedge[e] = sound;
    }
    claim_verdict("mesh_check", mesh_check(&m)); /* all damage is repaired */
    mesh_free(&m);
}

/* A half-edge that does not leave v; or none at all, if v has one. */
static void
damage_to_vertices_is_seen(const point2 *points, uint32_t n)
{
    mesh m = some_mesh(points, n);
    for (vertex_id v = 0; v < m.points; v++) {
        halfedge_id sound = m.leaving[v];
        halfedge_id wrong = another(sound, mesh_halfedges(&m) + 2);
        if (wrong >= mesh_halfedges(&m) || mesh_origin(&m, wrong) != v) {
            m.leaving[v] = wrong;
            expect_refuted(&m, "the half-edge kept for a vertex");
        }
        m.leaving[v] = sound;
    }
    halfedge_id sound = m.ghost_leaving;
    halfedge_id wrong = another(sound, mesh_halfedges(&m) + 2);
    if (m.locations > 1 &&
        (wrong >= mesh_halfedges(&m) || mesh_origin(&m, wrong) != GHOST)) {
        m.ghost_leaving = wrong;
        expect_refuted(&m, "the half-edge kept for GHOST");
    }
    m.ghost_leaving = sound;
    claim_verdict("mesh_check", mesh_check(&m));
    mesh_free(&m);
}

static void
damage_to_counts_is_seen(const point2 *points, uint32_t n)
{
    mesh m = some_mesh(points, n);
    bool has_triangles = m.triangles > 0;
    if (!has_triangles)
        mesh_free(&m);
    HYPOTHESIS(has_triangles);
    m.triangles--;
    expect_refuted(&m, "the number of triangles");
    m.triangles++;
    m.locations--;
    expect_refuted(&m, "the number of locations");
    m.locations += 2;
    expect_refuted(&m, "the number of locations");
    mesh_free(&m);
}

/* On a path an inner vertex has two edges to GHOST. Exchanging them leaves all ends
 * right, but tears the star of the vertex into two. */
static void
a_star_in_two_pieces_is_seen(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {2, 0}};
    mesh m = some_mesh(points, 3);
    halfedge_id to_ghost[2], found = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        if (mesh_origin(&m, e) == 1 && mesh_dest(&m, e) == GHOST && found < 2)
            to_ghost[found++] = e;
    CLAIM("mesh_check", found == 2, "the inner vertex has %u edges to GHOST", found);
    halfedge_id twin[2] = {mesh_twin(&m, to_ghost[0]), mesh_twin(&m, to_ghost[1])};
    mesh_link(&m, to_ghost[0], twin[1]);
    mesh_link(&m, to_ghost[1], twin[0]);
    expect_refuted(&m, "two parallel edges");
    mesh_free(&m);
}

/* A mesh of u locations and these triangles, glued along their edges; 0 is GHOST and
 * v > 0 is point v-1. It need not be a sphere. */
static mesh
glue(uint32_t u, vertex_id (*corner)[3], uint32_t count)
{
    mesh m;
    CLAIM("mesh_init", mesh_init(&m, 10, 10) == TRI_OK, "no mesh");
    for (uint32_t t = 0; t < count; t++) /* 0 - 1 is GHOST */
        mesh_add_triangle(&m, corner[t][0] - 1, corner[t][1] - 1, corner[t][2] - 1);
    m.locations = u;
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        for (halfedge_id f = 0; f < e; f++)
            if (mesh_origin(&m, e) == mesh_dest(&m, f) &&
                mesh_origin(&m, f) == mesh_dest(&m, e))
                mesh_link(&m, e, f);
    return m;
}

/* Surfaces that are locally as they must be. A sphere with u = 3 locations and GHOST
 * is a tetrahedron; two of them, with 8 triangles and 8 vertices, have the number of
 * triangles for u = 5. The torus of Moebius has 7 vertices, as if u = 6. */
static void
other_surfaces_are_seen(void)
{
    vertex_id spheres[8][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1},
                               {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {7, 6, 5}};
    vertex_id torus[14][3];
    for (uint32_t i = 0; i < 7; i++)
        for (uint32_t k = 0; k < 3; k++) {
            torus[2 * i][k] = (i + (const uint32_t[]){0, 1, 3}[k]) % 7;
            torus[2 * i + 1][k] = (i + (const uint32_t[]){0, 3, 2}[k]) % 7;
        }
    mesh m = glue(3, spheres, 4);
    claim_verdict("mesh_check", mesh_check(&m));
    mesh_free(&m);
    m = glue(5, spheres, 8);
    expect_refuted(&m, "a sphere: there are two");
    mesh_free(&m);
    m = glue(6, torus, 14);
    expect_refuted(&m, "a sphere: it is a torus");
    mesh_free(&m);
}

static bool
is_zeroed(const mesh *m)
{
    return m->halfedge == NULL && m->leaving == NULL && m->points == 0 &&
           m->locations == 0 && m->triangles == 0 && m->trace == NULL;
}

static void
sizes_are_checked(void)
{
    const uint64_t most = MESH_MOST_LOCATIONS;
    CLAIM("mesh_fits", 6 * most <= UINT32_MAX && 6 * (most + 1) > UINT32_MAX,
          "%llu is not the largest u for which 6u fits", (unsigned long long)most);
    CLAIM("mesh_fits", mesh_fits(715827882u) == TRI_OK, "715827882 is refused");
    CLAIM("mesh_fits", mesh_fits(715827883u) == TRI_TOO_MANY_POINTS, "715827883 fits");
    CLAIM("mesh_fits", mesh_fits(UINT32_MAX) == TRI_TOO_MANY_POINTS, "2^32-1 fits");
    mesh m;
    CLAIM("mesh_init", mesh_init(&m, UINT32_MAX, 715827883u) == TRI_TOO_MANY_POINTS &&
          is_zeroed(&m), "715827883 locations are not refused");
    mesh_free(&m); /* a zeroed mesh is accepted */
    CLAIM("mesh_init", mesh_init(&m, 0, 0) == TRI_OK, "no points are refused");
    mesh_free(&m);
    CLAIM("mesh_free", is_zeroed(&m), "something is left");
}

/* In mesh_init and in mesh_triangles, for every k. */
static void
memory_may_run_out(void)
{
    tri_status status = TRI_OUT_OF_MEMORY;
    mesh m;
    unsigned long k = 0;
    while (status != TRI_OK) {
        memory_fail_at(++k);
        status = mesh_init(&m, 10, 10);
        memory_fail_at(0);
        CLAIM("mesh_init", status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
              is_zeroed(&m)), "allocation %lu: %s", k, tri_status_text(status));
    }
    CLAIM("mesh_init", k == 3, "%lu allocations", k - 1);
    triangle_list list;
    memory_fail_at(1);
    status = mesh_triangles(&m, &list);
    memory_fail_at(0);
    CLAIM("mesh_triangles", status == TRI_OUT_OF_MEMORY && list.corner == NULL &&
          list.count == 0, "%s", tri_status_text(status));
    mesh_free(&m);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/mesh: damage is seen, sizes are checked");
    test_random("a sound mesh holds", a_sound_mesh_holds, 2000, 100);
    test_near_degenerate("a sound mesh holds", a_sound_mesh_holds, 1000, 60);
    test_random("damage to half-edges is seen", damage_to_half_edges_is_seen, 1000, 25);
    test_random("damage to vertices is seen", damage_to_vertices_is_seen, 2000, 25);
    test_random("damage to counts is seen", damage_to_counts_is_seen, 500, 25);
    test_run("a star in two pieces is seen", a_star_in_two_pieces_is_seen);
    test_run("other surfaces are seen", other_surfaces_are_seen);
    test_run("sizes are checked", sizes_are_checked);
    test_run("memory may run out", memory_may_run_out);
    return test_end((test_minima){.trials = 6000, .largest_n = 90});
}
