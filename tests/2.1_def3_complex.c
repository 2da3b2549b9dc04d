/* Definition 3: is_complex accepts exactly the simplicial complexes.
 *
 * Hypotheses: small whole coordinates, so that this file can decide Definition 3
 * by itself: two simplices meet in a common face exactly when the corners of
 * their intersection are common vertices, and those corners are found here with
 * integers.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"

/* ---- Definition 3 by brute force, with integers. ---- */

static int
turn(point2 a, point2 b, point2 c)
{
    double det = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (det > 0) - (det < 0);
}

/* Is x in the closed simplex s? By signs only: no wedge of s excludes it. */
static bool
in_closed(const point2 *p, simplex s, point2 x)
{
    point2 a = p[s.vertex[0]];
    if (s.dimension == 0)
        return a.x == x.x && a.y == x.y;
    point2 b = p[s.vertex[1]];
    if (s.dimension == 1)
        return turn(a, b, x) == 0 &&
               (x.x - a.x) * (x.x - b.x) + (x.y - a.y) * (x.y - b.y) <= 0;
    point2 c = p[s.vertex[2]];
    int t = turn(a, b, c);
    return turn(a, b, x) * t >= 0 && turn(b, c, x) * t >= 0 && turn(c, a, x) * t >= 0;
}

static bool
properly_cross(point2 a, point2 b, point2 c, point2 d)
{
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

static bool
meet_in_a_common_face(const point2 *p, simplex s, simplex t)
{
    for (int i = 0; i <= s.dimension; i++)
        if (in_closed(p, t, p[s.vertex[i]]) &&
            !simplex_is_face((simplex){0, {s.vertex[i]}}, t))
            return false;
    for (int i = 0; i <= s.dimension; i++)
        for (int j = 0; j < i; j++)
            for (int k = 0; k <= t.dimension; k++)
                for (int l = 0; l < k; l++)
                    if (properly_cross(p[s.vertex[i]], p[s.vertex[j]],
                                       p[t.vertex[k]], p[t.vertex[l]]))
                        return false;
    return true;
}

static bool
is_complex_by_definition(const point2 *p, simplex_list list)
{
    for (uint32_t i = 0; i < list.count; i++) {
        simplex s = list.simplex[i], face[16];
        const vertex_id *v = s.vertex;
        if (s.dimension == 2 && turn(p[v[0]], p[v[1]], p[v[2]]) == 0)
            return false;
        uint32_t faces = simplex_faces(s, face);
        for (uint32_t j = 1; j < faces; j++) {
            uint32_t found = 0;
            for (uint32_t k = 0; k < list.count; k++)
                found += list.simplex[k].dimension == face[j].dimension &&
                         simplex_is_face(face[j], list.simplex[k]);
            if (found != 1)
                return false;
        }
        for (uint32_t j = 0; j < i; j++)
            if (!meet_in_a_common_face(p, s, list.simplex[j]) ||
                !meet_in_a_common_face(p, list.simplex[j], s))
                return false;
    }
    return true;
}

/* ---- Random lists: the closure of a few simplices, often with a fault. ---- */

static simplex
random_simplex(random_source *r, uint32_t n)
{
    simplex s = {.dimension = (int)random_below(r, 3)};
    do {
        for (int i = 0; i <= s.dimension; i++)
            s.vertex[i] = random_below(r, n);
    } while ((s.dimension > 0 && s.vertex[0] >= s.vertex[1]) ||
             (s.dimension > 1 && s.vertex[1] >= s.vertex[2]));
    return s;
}

static void
accepts_exactly_the_complexes(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    random_source *r = test_random_source();
    for (int repeat = 0; repeat < 20; repeat++) {
        simplex some[4];
        simplex_list few = {1 + random_below(r, 4), some}, list;
        for (uint32_t i = 0; i < few.count; i++)
            some[i] = random_simplex(r, n);
        CLAIM("def3.P1", simplex_closure(few, &list) == TRI_OK, "out of memory");
        if (random_below(r, 4) == 0) { /* a face is lost */
            list.count--;
            list.simplex[random_below(r, list.count + 1)] = list.simplex[list.count];
        }
        bool expected = is_complex_by_definition(points, list);
        verdict v = is_complex(points, n, list);
        simplex_list_free(&list);
        CLAIM("def3.P1", v.holds == expected, "is_complex says %s (%s)",
              v.holds ? "yes" : "no", v.because);
        CLAIM("def3.P1", v.holds || v.witnesses > 0, "no witness for: %s", v.because);
    }
}

/* A point is in |K| exactly when it is in a closed simplex of the list, and then in the
 * interior of the carrier: in the carrier, and in no closed smaller face of it. */
static void
the_underlying_space_is_the_union(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    random_source *r = test_random_source();
    simplex some[2] = {random_simplex(r, n), random_simplex(r, n)};
    simplex_list list = {2, some};
    for (int i = 0; i < 2; i++)
        HYPOTHESIS(is_affinely_independent(points, some[i]));
    for (int x = -1; x < 8; x++)
        for (int y = -1; y < 8; y++) {
            point2 q = {x * 0.5, y * 0.5};
            simplex s, face[16];
            bool contains = underlying_space_contains(points, list, q, &s);
            CLAIM("def3.P2", contains == (in_closed(points, some[0], q) ||
                                          in_closed(points, some[1], q)),
                  "the point (%g,%g)", q.x, q.y);
            for (uint32_t i = 1; contains && i < simplex_faces(s, face); i++)
                CLAIM("def3.P2", in_closed(points, face[i], q) ==
                      (face[i].dimension == s.dimension),
                      "the point (%g,%g) and face %u of its carrier", q.x, q.y, i);
        }
}

/* The carrier is the only simplex of a complex with the point in its interior; so it
 * does not matter which simplices come first. */
static void
a_complex_has_one_carrier(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    random_source *r = test_random_source();
    simplex some[2] = {random_simplex(r, n), random_simplex(r, n)};
    simplex_list list;
    CLAIM("def3.P2", simplex_closure((simplex_list){2, some}, &list) == TRI_OK,
          "out of memory");
    bool complex = is_complex(points, n, list).holds;
    for (int x = -1; x < 8 && complex; x++)
        for (int y = -1; y < 8; y++) {
            point2 q = {x * 0.5, y * 0.5};
            simplex s, t;
            bool contains = underlying_space_contains(points, list, q, &s);
            for (uint32_t i = 0; contains && i < list.count; i++) {
                simplex_list rest = {list.count - i, list.simplex + i};
                if (underlying_space_contains(points, rest, q, &t))
                    CLAIM("def3.P2",
                          s.dimension == t.dimension && simplex_is_face(s, t),
                          "two carriers of (%g,%g)", q.x, q.y);
            }
        }
    simplex_list_free(&list);
}

/* ---- Single cases. ---- */

static void
closures(void)
{
    simplex two[] = {{2, {0, 1, 2}}, {2, {1, 2, 3}}};
    simplex_list list, given = {2, two};
    CLAIM("def3.P1", simplex_closure(given, &list) == TRI_OK, "out of memory");
    CLAIM("def3.P1", list.count == 11, "%u simplices", list.count);
    CLAIM("def3.P1", complex_dimension(list) == 2, "dimension %d",
          complex_dimension(list));
    simplex_list_free(&list);
    CLAIM("def3.P1", complex_dimension(list) == -1, "an empty list has a dimension");
    memory_fail_at(1);
    CLAIM("def3.P1",
          simplex_closure(given, &list) == TRI_OUT_OF_MEMORY && !list.simplex,
          "no memory, and no status");
    memory_fail_at(0);
}

static void
e2_the_intersection_must_be_a_common_face(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
    simplex some[] = {{2, {0, 1, 2}}, {0, {3}}};
    simplex_list list;
    CLAIM("E2", simplex_closure((simplex_list){2, some}, &list) == TRI_OK, "memory");
    /* As printed: every intersection is in K. The loose vertex meets the triangle in
     * itself, and is listed; all other pairs are faces of one triangle. */
    CLAIM("E2", list.count == 8 && in_closed(points, some[0], points[3]),
          "the example is not what it was");
    verdict v = is_complex(points, 4, list);
    simplex_list_free(&list);
    CLAIM("E2", !v.holds && v.witness[0] == 3, "accepted, or the wrong witness");
}

static void
bad_lists_are_refuted(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
    simplex out_of_range[] = {{0, {4}}},
            unordered[] = {{0, {1}}, {0, {0}}, {1, {1, 0}}};
    simplex solid[] = {{3, {0, 1, 2, 3}}}, same[] = {{0, {0}}, {0, {3}}};
    simplex twice[] = {{0, {0}}, {0, {1}}, {1, {0, 1}}, {1, {0, 1}}};
    CLAIM("def3.P1", !is_complex(points, 4, (simplex_list){1, out_of_range}).holds,
          "range");
    CLAIM("def3.P1", !is_complex(points, 4, (simplex_list){3, unordered}).holds,
          "order");
    CLAIM("def3.P1", !is_complex(points, 4, (simplex_list){1, solid}).holds,
          "dimension 3");
    CLAIM("def3.P1", !is_complex(points, 4, (simplex_list){2, same}).holds,
          "one location");
    CLAIM("def3.P1", is_complex(points, 4, (simplex_list){3, twice}).holds, "an edge");
    CLAIM("def3.P1", !is_complex(points, 4, (simplex_list){4, twice}).holds,
          "an edge, twice");
    CLAIM("def3.P1", is_complex(points, 4, (simplex_list){0, NULL}).holds, "empty");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Definition 3: simplicial complexes");
    test_grid_subsets("exactly the complexes", accepts_exactly_the_complexes, 3);
    test_grid_subsets("the underlying space", the_underlying_space_is_the_union, 3);
    test_grid_subsets("one carrier", a_complex_has_one_carrier, 3);
    test_run("closures", closures);
    test_run("E2: a face of both", e2_the_intersection_must_be_a_common_face);
    test_run("bad lists", bad_lists_are_refuted);
    return test_end((test_minima){.trials = 1000, .largest_n = 9, .zeros = 1000});
}
