/* Definitions 1 and 2: a k-simplex has 2^(k+1) faces, C(k+1, i+1) of dimension i.
 *
 * Hypotheses: the vertices are distinct and increase; k <= 3, so that everything
 * can be tried. Affine independence: k <= 2 and points of the plane.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"
#include "tests/harness/harness.h"
#include "tests/oracle/oracle.h"

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

/* Looks at all pairs and triples, with big integers. */
static int
dimension_by_all_triples(const point2 *p, uint32_t n)
{
    int dimension = n > 0 ? 0 : -1;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < i; j++) {
            if (dimension == 0 && (p[i].x != p[j].x || p[i].y != p[j].y))
                dimension = 1;
            for (uint32_t k = 0; k < j && dimension < 2; k++)
                if (oracle_orient2d(p[i], p[j], p[k]) != 0)
                    dimension = 2;
        }
    return dimension;
}

static void
a_basis_spans_all_points(const point2 *p, uint32_t n)
{
    int dimension = dimension_by_all_triples(p, n);
    simplex basis = affine_basis(p, n);
    const vertex_id *v = basis.vertex;
    CLAIM("def1.P2", affine_dimension(p, n) == dimension, "%d, and not %d",
          affine_dimension(p, n), dimension);
    CLAIM("def1.P2", basis.dimension == dimension, "a basis of %d points",
          basis.dimension + 1);
    for (int i = 0; i <= dimension; i++)
        CLAIM("def1.P2", v[i] < n && (i == 0 || v[i - 1] < v[i]), "point %u", v[i]);
    if (dimension == 1)
        CLAIM("def1.P2", p[v[0]].x != p[v[1]].x || p[v[0]].y != p[v[1]].y,
              "%u and %u are one point", v[0], v[1]);
    if (dimension == 2)
        CLAIM("def1.P2", oracle_orient2d(p[v[0]], p[v[1]], p[v[2]]) != 0,
              "%u, %u and %u are collinear", v[0], v[1], v[2]);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Definitions 1 and 2: simplices and their faces");
    test_run("2^(k+1) faces", a_simplex_has_all_its_faces);
    test_run("a triangle has 8 faces", a_triangle_has_eight_faces);
    test_grid_subsets("affine independence", affine_independence_has_no_first_point, 3);
    test_run("E1: vectors and points", e1_independent_points_are_dependent_vectors);
    test_random("affine basis", a_basis_spans_all_points, 2000, 12);
    test_near_degenerate("affine basis", a_basis_spans_all_points, 2000, 8);
    test_grid_subsets("affine basis", a_basis_spans_all_points, 3);
    return test_end((test_minima){.trials = 5000, .largest_n = 12, .zeros = 1000,
                                  .expansions = 100, .wide = 100});
}
