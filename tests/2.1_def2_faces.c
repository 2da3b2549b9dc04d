/* Definitions 1 and 2: a k-simplex has 2^(k+1) faces, C(k+1, i+1) of dimension i.
 *
 * Hypotheses: the vertices are distinct and increase; k <= 3, so that everything
 * can be tried. Affine independence: k <= 2 and points of the plane.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "tests/harness/harness.h"

static uint32_t
binomial(uint32_t n, uint32_t k)
{
    return k == 0 ? 1 : k > n ? 0 : binomial(n - 1, k - 1) + binomial(n - 1, k);
}

static void
a_simplex_has_all_its_faces(void)
{
    for (int k = -1; k <= 3; k++) {
        simplex s = {k, {2, 3, 5, 7}}, face[16];
        uint32_t of_dimension[5] = {0};
        uint32_t faces = simplex_faces(s, face);
        CLAIM("def2.P1", faces == 1u << (k + 1), "%u faces for k = %d", faces, k);
        for (uint32_t i = 0; i < faces; i++) {
            of_dimension[face[i].dimension + 1]++;
            CLAIM("def2.P1", simplex_is_face(face[i], s), "face %u of k = %d", i, k);
            for (uint32_t j = 0; j < i; j++)
                CLAIM("def2.P1",
                      face[i].dimension != face[j].dimension ||
                          !simplex_is_face(face[i], face[j]),
                      "faces %u and %u are one", i, j);
        }
        for (int i = -1; i <= k; i++)
            CLAIM("def2.P1",
                  of_dimension[i + 1] == binomial((uint32_t)k + 1, (uint32_t)i + 1),
                  "%u faces of dimension %d for k = %d", of_dimension[i + 1], i, k);
    }
}

static void
a_triangle_has_eight_faces(void)
{
    simplex face[16];
    uint32_t faces = simplex_faces((simplex){2, {0, 1, 2}}, face);
    CLAIM("def2.P1", faces == 8, "%u faces", faces);
    CLAIM("def2.P1", face[0].dimension == -1, "the empty face is missing");
    CLAIM("def2.P1", !simplex_is_face((simplex){1, {0, 3}}, face[7]),
          "03 is no face of 012");
}

/* On small whole numbers: is p affinely independent, by the integers themselves,
 * and whichever point is taken as u0? */
static void
affine_independence_has_no_first_point(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 3);
    for (int first = 0; first < 3; first++) {
        point2 u = points[first], v = points[(first + 1) % 3],
               w = points[(first + 2) % 3];
        double det = (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
        CLAIM("def1.P1", is_affinely_independent(points, (simplex){2, {0, 1, 2}}) ==
              (det != 0), "with u0 = %d the determinant is %g", first, det);
    }
    CLAIM("def1.P1", is_affinely_independent(points, (simplex){0, {0}}), "one point");
    CLAIM("def1.P1", is_affinely_independent(points, (simplex){1, {0, 1}}),
          "two distinct points");
    CLAIM("def1.P1", !is_affinely_independent((point2[]){{1, 2}, {1, 2}},
          (simplex){1, {0, 1}}), "twice the same point");
}

static void
e1_independent_points_are_dependent_vectors(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {0, 1}};
    CLAIM("E1", is_affinely_independent(points, (simplex){2, {0, 1, 2}}), "dependent");
    /* Three vectors of the plane, one of them zero, are linearly dependent:
     * 1 * (0,0) + 0 * (1,0) + 0 * (0,1) = 0. */
    CLAIM("E1", points[0].x == 0 && points[0].y == 0, "no vector is zero");
}

static void
affine_dimensions(void)
{
    const point2 p[] = {{1, 1}, {1, 1}, {2, 2}, {3, 3}, {3, 4}};
    const int dimension[] = {-1, 0, 0, 1, 1, 2};
    for (uint32_t n = 0; n <= 5; n++)
        CLAIM("def1.P1", affine_dimension(p, n) == dimension[n], "%d for %u points",
              affine_dimension(p, n), n);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Definitions 1 and 2: simplices and their faces");
    test_run("2^(k+1) faces", a_simplex_has_all_its_faces);
    test_run("a triangle has 8 faces", a_triangle_has_eight_faces);
    test_grid_subsets("affine independence", affine_independence_has_no_first_point, 3);
    test_run("E1: vectors and points", e1_independent_points_are_dependent_vectors);
    test_run("affine dimension", affine_dimensions);
    return test_end((test_minima){.trials = 500, .largest_n = 9, .zeros = 10});
}
