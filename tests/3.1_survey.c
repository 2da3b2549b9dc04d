/* Section 3.1, from the survey page that the notes show: a triangulation
 * without obtuse angles is Delaunay; but the Delaunay triangulation minimises
 * neither the largest angle nor the total length.
 *
 * Hypotheses: none for the first. That angles cannot grow by a flip is Theorem
 * 4's test (3.5).
 */
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <math.h>
#include <stdlib.h>

/* The scalar product of the sides of triangle t at its corner i, exact for
 * whole points up to 2^25: negative for an obtuse angle. */
static double
corner_product(const point2 *points, triangle_list list, uint32_t t, int i)
{
    point2 a = points[list.corner[t][i]];
    point2 b = points[list.corner[t][(i + 1) % 3]],
           c = points[list.corner[t][(i + 2) % 3]];
    return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
}

static bool
has_obtuse_angle(const point2 *points, triangle_list list)
{
    for (uint32_t t = 0; t < list.count; t++)
        for (int i = 0; i < 3; i++)
            if (corner_product(points, list, t, i) < 0)
                return true;
    return false;
}

static void
claim_delaunay(const point2 *points, uint32_t n, triangle_list list)
{
    verdict v;
    test_picture(list);
    CLAIM("sec3.1.P17", is_delaunay(points, n, list, &v) == TRI_OK,
          "out of memory");
    claim_verdict("sec3.1.P17", v);
}

/* Some triangulation of a few whole points: not all have an obtuse angle. */
static void
without_obtuse_angles_is_delaunay(const point2 *given, uint32_t n)
{
    (void)given;
    point2 *points = whole_points(NULL, n, 4);
    mesh m;
    triangle_list list;
    random_triangulation(points, n, &m);
    CLAIM("sec3.1.P17", mesh_triangles(&m, &list) == TRI_OK, "out of memory");
    if (!has_obtuse_angle(points, list))
        claim_delaunay(points, n, list);
    triangle_list_free(&list);
    mesh_free(&m);
    free(points);
}

/* Rectangles between random lines, each cut by a diagonal of its own choice:
 * all angles are right or acute. */
static void
rectangles_are_delaunay(const point2 *given, uint32_t n)
{
    (void)given;
    random_source *source = test_random_source();
    uint32_t columns = 2 + n % 5, rows = 2 + n / 5 % 5;
    point2 points[36];
    vertex_id corner[50][3];
    triangle_list list = {0, corner};
    double x = 0;
    for (uint32_t i = 0; i < columns; i++) {
        double y = 0;
        x += 1 + random_below(source, 1000);
        for (uint32_t k = 0; k < rows; k++) {
            y += 1 + (k * k + 7 * n) % 50;
            points[i * rows + k] = (point2){x, y};
        }
    }
    for (uint32_t i = 0; i + 1 < columns; i++)
        for (uint32_t k = 0; k + 1 < rows; k++) {
            vertex_id a = i * rows + k, b = a + rows, c = b + 1, d = a + 1;
            bool rising = random_below(source, 2) == 0;
            const vertex_id two[2][3] = {{a, b, rising ? c : d},
                                         {rising ? a : b, c, d}};
            for (int t = 0; t < 2; t++, list.count++)
                for (int j = 0; j < 3; j++)
                    corner[list.count][j] = two[t][j];
        }
    CLAIM("sec3.1.P17", !has_obtuse_angle(points, list), "an obtuse angle");
    claim_delaunay(points, columns * rows, list);
}

/* ---- What the Delaunay triangulation is not. ---- */

/* The largest angle, in degrees. */
static double
largest_angle(const point2 *points, triangle_list list)
{
    double largest = 0;
    for (uint32_t t = 0; t < list.count; t++)
        for (int i = 0; i < 3; i++) {
            point2 a = points[list.corner[t][i]],
                   b = points[list.corner[t][(i + 1) % 3]];
            point2 c = points[list.corner[t][(i + 2) % 3]];
            double cosine = corner_product(points, list, t, i) /
                            hypot(b.x - a.x, b.y - a.y) /
                            hypot(c.x - a.x, c.y - a.y);
            largest = fmax(largest, acos(cosine) * 180 / acos(-1));
        }
    return largest;
}

static void
claim_only_delaunay(const char *name, const point2 *points,
                    triangle_list delaunay, triangle_list other)
{
    verdict v, w;
    CLAIM(name,
          is_delaunay(points, 4, delaunay, &v) == TRI_OK &&
              is_delaunay(points, 4, other, &w) == TRI_OK,
          "out of memory");
    CLAIM(name, v.holds && !w.holds, "the two are not as announced");
}

static vertex_id one[2][3] = {{0, 1, 2}, {0, 2, 3}},
                 two[2][3] = {{0, 1, 3}, {1, 2, 3}};

static void
the_largest_angle_can_be_smaller(void)
{
    const point2 points[] = {{0, 0}, {2, 0}, {3, 1}, {0, 5}};
    triangle_list delaunay = {2, one}, other = {2, two};
    claim_only_delaunay("sec3.1.P18", points, delaunay, other);
    double largest = largest_angle(points, delaunay);
    double smaller = largest_angle(points, other);
    CLAIM("sec3.1.P18", fabs(largest - 135) < 1e-9, "%g degrees", largest);
    CLAIM("sec3.1.P18", smaller < 99, "%g degrees", smaller);
}

/* The sides are the same; the diagonals are (0,0)(5,4) and (4,1)(5,5). */
static void
the_length_can_be_smaller(void)
{
    const point2 points[] = {{0, 0}, {4, 1}, {5, 4}, {5, 5}};
    triangle_list delaunay = {2, one}, other = {2, two};
    claim_only_delaunay("sec3.1.P19", points, delaunay, other);
    double longer = hypot(5 - 0, 4 - 0), shorter = hypot(5 - 4, 5 - 1);
    CLAIM("sec3.1.P19", longer > shorter + 2, "%g and %g", longer, shorter);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "3.1, survey: what the Delaunay triangulation is, and is not");
    test_random("no obtuse angle", without_obtuse_angles_is_delaunay, 4000, 9);
    test_random("rectangles", rectangles_are_delaunay, 500, 40);
    test_run("the largest angle", the_largest_angle_can_be_smaller);
    test_run("the total length", the_length_can_be_smaller);
    return test_end(
        (test_minima){.trials = 4000, .largest_n = 9, .zeros = 1000});
}
