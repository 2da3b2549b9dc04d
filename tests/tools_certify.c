/* What is enough to check is enough: the certifiers of triangulations and of hulls
 * accept what the definitions accept.
 *
 * Hypotheses: none but small integers. They are asked about every answer that there is
 * to a few points of a small grid, where ties of all kinds come up, and about good
 * answers that are broken in some way. The definitions are written down once more,
 * slowly: with areas and all subsets.
 */
#include "tests/harness/sites.h"
#include "tools/checks/cases.h"
#include "tools/checks/certify.h"
#include "tools/checks/diagrams.h"
#include "tools/checks/lifted.h"
#include "tools/checks/meshes.h"

#include <stdlib.h>
#include <string.h>

/* Definition 7, for all points and all triangles: not only neighbours. */
static bool
is_delaunay_slowly(const problem *p, triangle_list list)
{
    site s[3];
    for (uint32_t k = 0; k < list.count; k++) {
        corners_of(p, list, k, s);
        if (!circle_is_empty(p->at, p->n, s[0], s[1], s[2]))
            return false;
    }
    return is_triangulation_slowly(p, list);
}

static void
compare_lists(const problem *p, triangle_list list)
{
    bool right = is_triangulation_slowly(p, list);
    verdict v = certify_triangulation(p->at, p->n, list);
    CLAIM("certify.triangulation", v.holds == right,
          "%u points, %u triangles: %s, and %s", (unsigned)p->n, (unsigned)list.count,
          v.holds ? "accepted" : v.because,
          right ? "they are a triangulation" : "they are not");
    right = right && is_delaunay_slowly(p, list);
    v = certify_delaunay(p->at, p->n, list);
    CLAIM("certify.delaunay", v.holds == right, "%u points, %u triangles: %s, and %s",
          (unsigned)p->n, (unsigned)list.count, v.holds ? "accepted" : v.because,
          right ? "they are Delaunay" : "they are not");
}

/* Every set of triangles on four or five points, each counterclockwise (or flat). */
static void
every_list_of_triangles(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n <= 5);
    problem p = problem_of(points, n);
    vertex_id all[10][3], chosen[10][3];
    uint32_t triangles = 0;
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = a + 1; b < n; b++)
            for (uint32_t c = b + 1; c < n; c++) {
                bool turn = area(p.at[a], p.at[b], p.at[c]) < 0;
                const vertex_id abc[3] = {a, turn ? c : b, turn ? b : c};
                memcpy(all[triangles++], abc, sizeof abc);
            }
    for (uint32_t set = 0; set < 1u << triangles; set++) {
        triangle_list list = {.corner = chosen};
        for (uint32_t t = 0; t < triangles; t++)
            if ((set >> t & 1) != 0)
                memcpy(chosen[list.count++], all[t], sizeof all[t]);
        compare_lists(&p, list);
    }
}

/* ---- Good triangulations, broken. ---- */

static void
flip_over(triangle_list list, uint32_t t)
{
    vertex_id b = list.corner[t][1];
    list.corner[t][1] = list.corner[t][2];
    list.corner[t][2] = b;
}

/* Two neighbours abc and bad become dca and cdb, whatever they look like: the counts of
 * Euler's formula stay what they were. */
static void
exchange_diagonal(triangle_list list)
{
    halfedge_id twin[3 * MOST_LIST];
    certify_twins(list, twin);
    halfedge_id e = some(3 * list.count), f = twin[e];
    if (f == NONE)
        return;
    vertex_id a = side_origin(list, e), b = side_dest(list, e);
    vertex_id c = side_apex(list, e), d = side_apex(list, f);
    const vertex_id dca[3] = {d, c, a}, cdb[3] = {c, d, b};
    memcpy(list.corner[e / 3], dca, sizeof dca);
    memcpy(list.corner[f / 3], cdb, sizeof cdb);
}

/* Spoils the list in one of seven ways; sometimes it is as good as before. */
static void
break_list(triangle_list *list, uint32_t n)
{
    uint32_t t = some(list->count);
    switch (some(7)) {
    case 0: /* drop */
        memcpy(list->corner[t], list->corner[list->count - 1], sizeof list->corner[t]);
        list->count--;
        break;
    case 1: /* duplicate */
        memcpy(list->corner[list->count++], list->corner[t], sizeof list->corner[t]);
        break;
    case 2: flip_over(*list, t); break;
    case 3: list->corner[t][some(3)] = some(n); break;
    case 4: /* any other triangle on top */
        for (int i = 0; i < 3; i++)
            list->corner[list->count][i] = some(n);
        list->count++;
        break;
    default: exchange_diagonal(*list); break;
    }
}

/* A triangulation is accepted; broken once or twice, it is what the definition says. */
static void
broken_triangulations(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    problem p = some_problem(MOST - 4);
    vertex_id corner[MOST_LIST][3];
    triangle_list good = mesh_at_random(test_random_source(), p.at, p.n, some(2) == 0);
    compare_lists(&p, good);
    CLAIM("certify.accepts", certify_triangulation(p.at, p.n, good).holds, "%u points",
          (unsigned)p.n);
    for (int trial = 0; trial < 20 && good.count > 0; trial++) {
        triangle_list list = {good.count, corner};
        memcpy(corner, good.corner, good.count * sizeof *corner);
        for (uint32_t times = 1 + some(2); times > 0 && list.count > 0; times--)
            break_list(&list, p.n);
        compare_lists(&p, list);
    }
    triangle_list_free(&good);
}

/* A star of five triangles around a point: each directed side once, all triangles
 * counterclockwise, v - e + f = 1, a boundary that only turns left; and it winds
 * twice. */
static void
the_pentagram_is_refused(void)
{
    problem p = {{{0, -10}, {10, -3}, {6, 8}, {-6, 8}, {-10, -3}, {0, 0}}, 6};
    vertex_id corner[5][3];
    triangle_list list = {5, corner};
    uint32_t star[5];
    for (uint32_t i = 0; i < 5; i++) {
        const vertex_id t[3] = {i, (i + 2) % 5, 5};
        memcpy(corner[i], t, sizeof t);
        star[i] = 2 * i % 5;
        CLAIM("certify.pentagram", area(p.at[t[0]], p.at[t[1]], p.at[t[2]]) > 0,
              "triangle %u is not counterclockwise", (unsigned)i);
    }
    verdict v = certify_triangulation(p.at, p.n, list);
    CLAIM("certify.pentagram", !v.holds && strstr(v.because, "2 times") != NULL, "%s",
          v.holds ? "accepted" : v.because);
    v = certify_hull(p.at, p.n, star, 5);
    CLAIM("certify.pentagram", !v.holds && strstr(v.because, "2 times") != NULL, "%s",
          v.holds ? "accepted" : v.because);
}

/* ---- Hulls. ---- */

/* The point after a on the hull: the nearest such that none is right of the way
 * there. */
static uint32_t
next_on_hull(const problem *p, uint32_t a)
{
    for (uint32_t b = 0; b < p->n; b++) {
        bool good = !same(p->at[a], p->at[b]);
        for (uint32_t k = 0; good && k < p->n; k++) {
            int64_t side = area(p->at[a], p->at[b], p->at[k]);
            bool between = side == 0 && is_on_segment(p->at[a], p->at[k], p->at[b]) &&
                !same(p->at[k], p->at[a]) && !same(p->at[k], p->at[b]);
            good = side >= 0 && !between;
        }
        if (good)
            return b;
    }
    return NONE;
}

/* Follows the hull once around and compares. */
static bool
is_hull_slowly(const problem *p, const vertex_id *hull, uint32_t count)
{
    uint32_t a = count > 0 ? hull[0] : NONE, start = a;
    for (uint32_t i = 0; i < count; i++) {
        if (a == NONE || !same(p->at[a], p->at[hull[i]]))
            return false;
        a = next_on_hull(p, a);
        bool around = a != NONE && same(p->at[a], p->at[start]);
        if (around != (i + 1 == count))
            return false;
    }
    return count > 0;
}

/* Collinear points: all locations, from one end to the other. */
static bool
is_path_slowly(const problem *p, const vertex_id *path, uint32_t count)
{
    uint32_t lowest[MOST];
    if (count != cases_locations(p->at, p->n, lowest))
        return false;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = i + 2; k < count; k++)
            for (uint32_t j = i + 1; j < k; j++)
                if (!is_on_segment(p->at[path[i]], p->at[path[j]], p->at[path[k]]))
                    return false;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; k < i; k++)
            if (same(p->at[path[i]], p->at[path[k]]))
                return false;
    return true;
}

static void
compare_hull(const problem *p, const vertex_id *hull, uint32_t count)
{
    bool right = cases_are_collinear(p->at, p->n) ? is_path_slowly(p, hull, count)
                                                  : is_hull_slowly(p, hull, count);
    verdict v = certify_hull(p->at, p->n, hull, count);
    CLAIM("certify.hull", v.holds == right, "%u vertices, from %u on: %s, and %s",
          (unsigned)count, count > 0 ? (unsigned)hull[0] : 0,
          v.holds ? "accepted" : v.because,
          right ? "they are the hull" : "they are not");
}

/* Every row of at most five different points is, or is not, the hull. */
static void
every_row_of_points(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n <= 6);
    problem p = problem_of(points, n);
    uint32_t rows = 1;
    for (uint32_t i = 0; i < n; i++)
        rows *= n + 1;
    for (uint32_t code = 0; code < rows; code++) { /* the digits; n ends the row */
        vertex_id row[MOST];
        uint32_t count = 0, rest = code;
        bool ended = false, good = true;
        for (uint32_t i = 0; i < n; i++, rest /= n + 1) {
            uint32_t digit = rest % (n + 1);
            good = good && (!ended || digit == n);
            ended = ended || digit == n;
            for (uint32_t k = 0; k < count; k++)
                good = good && (ended || row[k] != digit || code % 7 == 0);
            if (!ended)
                row[count++] = digit;
        }
        if (good)
            compare_hull(&p, row, count);
    }
}

/* ---- The hull of the lifted points. ---- */

static int64_t
height(site p)
{
    return (int64_t)p.x * p.x + (int64_t)p.y * p.y;
}

/* Positive: the lifted d is outside of the plane of a, b, c, which are seen
 * counterclockwise from outside. */
static int64_t
outside(site a, site b, site c, site d)
{
    return area(d, b, c) * (height(a) - height(d)) +
           area(a, d, c) * (height(b) - height(d)) +
           area(a, b, d) * (height(c) - height(d));
}

/* The corners of face t in a coordinate plane where it has an area,
 * counterclockwise. */
static void
flatten(const problem *p, triangle_list faces, uint32_t t, const site like[3],
        site seen[3])
{
    for (int i = 0; i < 3; i++) {
        site q = p->at[faces.corner[t][i]];
        int32_t z = (int32_t)height(q);
        seen[i] = area(like[0], like[1], like[2]) != 0       ? q
                  : like[0].x != like[1].x || like[0].x != like[2].x ? (site){q.x, z}
                                                             : (site){q.y, z};
    }
    if (area(seen[0], seen[1], seen[2]) < 0) {
        site other = seen[1];
        seen[1] = seen[2];
        seen[2] = other;
    }
}

/* 2n - 4 faces, each on the hull and seen from outside, and none over another. There is
 * no room for more: the k points of a facet are in convex position, so that at most
 * k - 2 triangles lie beside each other in it, and by Euler's formula these are 2n - 4
 * together. Requires: no two points coincide. */
static bool
is_lifted_hull_slowly(const problem *p, triangle_list faces)
{
    bool flat = true;
    for (uint32_t i = 3; i < p->n; i++)
        flat = flat && outside(p->at[0], p->at[1], p->at[2], p->at[i]) == 0;
    if (flat || faces.count != 2 * p->n - 4)
        return flat && faces.count == 0;
    for (uint32_t k = 0; k < faces.count; k++) {
        const vertex_id *c = faces.corner[k];
        site f[3], s[3], t[3];
        corners_of(p, faces, k, f);
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
            return false;
        for (uint32_t i = 0; i < p->n; i++)
            if (outside(f[0], f[1], f[2], p->at[i]) > 0)
                return false;
        for (uint32_t l = 0; l < k; l++) {
            bool one_plane = true;
            for (int i = 0; i < 3; i++)
                one_plane = one_plane && outside(f[0], f[1], f[2],
                                                 p->at[faces.corner[l][i]]) == 0;
            flatten(p, faces, k, f, s);
            flatten(p, faces, l, f, t);
            if (one_plane && !are_apart(s, t))
                return false;
        }
    }
    return true;
}

static bool
compare_lifted(const problem *p, triangle_list faces)
{
    bool right = is_lifted_hull_slowly(p, faces);
    verdict v = certify_lifted_hull(p->at, p->n, faces);
    CLAIM("certify.lifted", v.holds == right, "%u points, %u faces: %s, and %s",
          (unsigned)p->n, (unsigned)faces.count, v.holds ? "accepted" : v.because,
          right ? "they are the hull" : "they are not");
    return right;
}

/* Faces with no point outside, drawn at random as long as they lie beside each other:
 * the hull, when there are enough. */
static void
some_lifted_hulls(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    problem p = problem_of(points, n);
    uint32_t lowest[MOST];
    HYPOTHESIS(cases_locations(p.at, n, lowest) == n);
    vertex_id corner[MOST_LIST][3];
    triangle_list faces = {0, corner};
    for (uint32_t trial = 0; trial < 4000 && faces.count < 2 * n - 4; trial++) {
        vertex_id *c = corner[faces.count];
        bool right = true;
        for (int i = 0; i < 3; i++)
            c[i] = some(n);
        for (uint32_t i = 0; i < n; i++)
            right = right && outside(p.at[c[0]], p.at[c[1]], p.at[c[2]], p.at[i]) <= 0;
        right = right && c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
        for (uint32_t t = 0; right && t < faces.count; t++) {
            site f[3], s[3], q[3];
            triangle_list both = {faces.count + 1, corner};
            corners_of(&p, both, faces.count, f);
            flatten(&p, both, faces.count, f, s);
            flatten(&p, both, t, f, q);
            bool one_plane = true;
            for (int i = 0; i < 3; i++)
                one_plane = one_plane &&
                            outside(f[0], f[1], f[2], p.at[corner[t][i]]) == 0;
            right = !one_plane || are_apart(s, q);
        }
        faces.count += right;
    }
    compare_lifted(&p, faces);
    for (int change = 0; change < 20 && faces.count > 0; change++) {
        vertex_id other[MOST_LIST][3];
        triangle_list broken = {faces.count, other};
        memcpy(other, corner, sizeof other);
        break_list(&broken, n);
        compare_lifted(&p, broken);
    }
    for (faces.count = 0; faces.count < 2 * n - 4; faces.count++) { /* no area */
        corner[faces.count][0] = corner[faces.count][1] = faces.count % n;
        corner[faces.count][2] = (faces.count + 1 + faces.count / n) % n;
    }
    compare_lifted(&p, faces);
    faces.count = 0;
    compare_lifted(&p, faces);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "What is enough to check is enough: triangulations and hulls");
    test_grid_subsets("every list of triangles", every_list_of_triangles, 3);
    test_random("broken triangulations", broken_triangulations, 1500, 5);
    test_run("the pentagram is refused", the_pentagram_is_refused);
    test_grid_subsets("every row of points is the hull or not", every_row_of_points, 3);
    test_grid_subsets("hulls of lifted points", some_lifted_hulls, 3);
    return test_end((test_minima){.trials = 2000, .largest_n = 5});
}
