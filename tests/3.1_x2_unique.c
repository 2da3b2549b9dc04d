/* Exercise of section 3.1: in general position the Delaunay triangulation is
 * unique; and the errata about general position, E17 to E19.
 *
 * Hypotheses: no four sites lie on an empty circle, for uniqueness. Other
 * inputs are tried as well: nothing is claimed of them.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/oracle.h"

#include <string.h>

/* ---- Uniqueness. ---- */

/* Without four cocircular sites around an empty circle, two Delaunay
 * triangulations, however they came about, have the same triangles. The lists
 * are compared as sets. */
static void
general_position_means_unique(const point2 *points, uint32_t n)
{
    mesh m[2];
    voronoi d;
    triangle_list list[2];
    random_diagram(points, n, &m[0], &d);
    bool general = d.vertex_first[d.vertices] == 3 * d.vertices;
    voronoi_free(&d);
    random_triangulation(points, n,
                         &m[1]); /* and then flips in a random order */
    edge_stack L;
    CLAIM("sec3.1.P12", edge_stack_init(&L, &m[1]) == TRI_OK, "out of memory");
    push_all_edges(&L);
    lawson_flip(&L, points);
    edge_stack_free(&L);
    for (int i = 0; i < 2; i++)
        CLAIM("sec3.1.P12", mesh_triangles(&m[i], &list[i]) == TRI_OK,
              "out of memory");
    bool same = list[0].count == list[1].count;
    for (uint32_t t = 0; t < list[0].count; t++)
        same = same && has_triangle(list[1], list[0].corner[t]);
    CLAIM("sec3.1.P12", same || !general,
          "two different Delaunay triangulations");
    for (int i = 0; i < 2; i++) {
        triangle_list_free(&list[i]);
        mesh_free(&m[i]);
    }
}

/* ---- Errata. ---- */

/* How many triangulations of these points are Delaunay: all ways to choose
 * triangles among the counterclockwise ones, for at most 8 points and few
 * triangles. */
static uint32_t
count_delaunay(const point2 *points, uint32_t n)
{
    vertex_id triple[56][3], chosen[20][3];
    uint32_t triples = 0, found = 0, wanted = 0;
    mesh m;
    triangle_list list;
    CLAIM("E17",
          lawson_triangulate(points, n, NULL, &m) == TRI_OK &&
              mesh_triangles(&m, &list) == TRI_OK,
          "no triangulation");
    wanted = list.count;
    triangle_list_free(&list);
    mesh_free(&m);
    for (vertex_id a = 0; a < n; a++)
        for (vertex_id b = a + 1; b < n; b++)
            for (vertex_id c = a + 1; c < n; c++)
                if (orient2d(points[a], points[b], points[c]) > 0)
                    memcpy(triple[triples++], (vertex_id[3]){a, b, c},
                           sizeof *triple);
    for (uint32_t set = 0; set < 1u << triples; set++) {
        uint32_t size = 0;
        for (uint32_t i = 0; i < triples && size <= wanted; i++)
            if (set >> i & 1)
                memcpy(chosen[size++], triple[i], sizeof *chosen);
        verdict v;
        if (size != wanted)
            continue;
        CLAIM("E17",
              is_delaunay(points, n, (triangle_list){size, chosen}, &v) ==
                  TRI_OK,
              "out of memory");
        found += v.holds;
    }
    return found;
}

static void
e17_only_empty_circles_matter(void)
{
    const point2 square[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {0, 0}};
    CLAIM("E17", incircle(square[0], square[1], square[2], square[3]) == 0,
          "the corners are not cocircular");
    uint32_t with_centre = count_delaunay(square, 5),
             without = count_delaunay(square, 4);
    CLAIM("E17", with_centre == 1, "%u Delaunay triangulations", with_centre);
    CLAIM("E17", without == 2, "without the centre, %u", without);
}

static void
e18_grids_are_not_random(void)
{
    point2 points[9];
    uint32_t quadruples = 0, cocircular = 0;
    for (uint32_t i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    for (uint32_t a = 0; a < 9; a++)
        for (uint32_t b = a + 1; b < 9; b++)
            for (uint32_t c = b + 1; c < 9; c++)
                for (uint32_t d = c + 1; d < 9; d++) {
                    bool circle =
                        orient2d(points[a], points[b], points[c]) != 0;
                    quadruples++;
                    cocircular +=
                        circle && oracle_incircle(points[a], points[b],
                                                  points[c], points[d]) == 0;
                }
    CLAIM("E18", quadruples == 126 && cocircular == 14, "%u of %u quadruples",
          cocircular, quadruples);
}

/* (1,0), moved up by ever less, leaves the hull boundary, and its cell is
 * bounded; moved down it becomes a corner of the hull. Only unmoved it is in
 * the hull edge. */
static void
e19_perturbing_moves_the_hull(void)
{
    for (int i = 0; i <= 60; i++) {
        double tiny = i < 60 ? 1.0 / (double)(UINT64_C(1) << i) / 4 : 0x1p-1074;
        for (int sign = -1; sign <= 1; sign++) {
            const point2 points[] = {{0, 0}, {1, sign * tiny}, {2, 0}, {1, 2}};
            mesh m;
            voronoi d;
            CLAIM("E19",
                  lawson_triangulate(points, 4, NULL, &m) == TRI_OK &&
                      voronoi_dual(&m, points, &d) == TRI_OK,
                  "no diagram");
            uint32_t h = mesh_hull_size(&m);
            CLAIM("E19", h == (sign > 0 ? 3 : 4), "moved by %g: h = %u",
                  sign * tiny, h);
            CLAIM("E19", voronoi_is_bounded(&d, 1) == (sign > 0), "moved by %g",
                  sign * tiny);
            voronoi_free(&d);
            mesh_free(&m);
        }
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "3.1: in general position the Delaunay triangulation is unique");
    test_random("uniqueness", general_position_means_unique, 1500, 30);
    test_near_degenerate("uniqueness", general_position_means_unique, 1000, 20);
    test_run("E17: only empty circles matter", e17_only_empty_circles_matter);
    test_run("E18: grids", e18_grids_are_not_random);
    test_run("E19: perturbation", e19_perturbing_moves_the_hull);
    return test_end(
        (test_minima){.trials = 2000, .largest_n = 25, .zeros = 1000});
}
