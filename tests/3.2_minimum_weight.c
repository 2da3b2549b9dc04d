/* The Delaunay triangulation is not the one of the smallest total length.
 *
 * Hypotheses: none. Four sites in convex position have two triangulations,
 * which differ in one diagonal; so two lengths are to be compared, which is
 * done exactly.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/start.h"

/* The half-edge along which the triangulation of four points can be flipped,
 * NONE if there is none. */
static halfedge_id
diagonal(const mesh *m, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (is_flippable(m, points, e))
            return e;
    return NONE;
}

/* Is the Delaunay diagonal of the four points longer than the other one,
 * shorter, or is there no choice (0)? */
static int
compare_diagonals(const point2 *points)
{
    mesh m = random_delaunay(points, 4);
    halfedge_id e = diagonal(&m, points);
    int sign = 0;
    if (e != NONE &&
        incircle(points[0], points[1], points[2], points[3]) != 0) {
        vertex_id a = mesh_origin(&m, e), b = mesh_dest(&m, e);
        vertex_id c = mesh_apex(&m, e), d = mesh_apex(&m, mesh_twin(&m, e));
        sign = compare_distance(points[a], points[b], points[c], points[d]);
    }
    mesh_free(&m);
    return sign;
}

/* Searches the four-point sets of the 4 x 4 grid: both answers occur. */
static void
either_diagonal_can_be_the_shorter_one(void)
{
    enum { SIDE = 4, CELLS = SIDE * SIDE };
    uint32_t longer = 0, shorter = 0;
    for (int a = 0; a < CELLS; a++)
        for (int b = a + 1; b < CELLS; b++)
            for (int c = b + 1; c < CELLS; c++)
                for (int d = c + 1; d < CELLS; d++) {
                    const int cell[4] = {a, b, c, d};
                    point2 p[4];
                    for (int i = 0; i < 4; i++)
                        p[i] = (point2){cell[i] % SIDE, cell[i] / SIDE};
                    int sign = compare_diagonals(p);
                    longer += sign > 0;
                    shorter += sign < 0;
                }
    CLAIM("weight.P1", longer > 0, "Delaunay is the shortest on %u sets",
          shorter);
    CLAIM("weight.P1", shorter > longer, "longer %u times, shorter %u times",
          longer, shorter);
}

/* One of them, as drawn on the page. */
static void
four_sites_suffice(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {3, 1}, {3, 4}};
    CLAIM("weight.P1", compare_diagonals(points) > 0,
          "the Delaunay diagonal is shorter");
}

/* The circle decides, not the length: if a and b saw the other diagonal cd under
 * acute angles, its disc would be free, and it would be Delaunay instead of ab,
 * however long it is. */
static void
the_rule_is_the_circle_not_the_length(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 4);
    for (uint32_t i = 0; i + 4 <= n; i++) {
        const point2 *p = points + i;
        mesh m = random_delaunay(p, 4);
        halfedge_id e = diagonal(&m, p);
        if (e != NONE) {
            point2 a = p[mesh_origin(&m, e)], b = p[mesh_dest(&m, e)];
            point2 c = p[mesh_apex(&m, e)],
                   d = p[mesh_apex(&m, mesh_twin(&m, e))];
            CLAIM("weight.P2", dot_sign(c, a, d) <= 0 || dot_sign(c, b, d) <= 0,
                  "both angles over the other diagonal are acute, edge %u", e);
        }
        mesh_free(&m);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Delaunay is not the triangulation of minimum weight");
    test_run("either diagonal", either_diagonal_can_be_the_shorter_one);
    test_run("four sites", four_sites_suffice);
    test_random("circles, not lengths", the_rule_is_the_circle_not_the_length,
                1000, 40);
    test_near_degenerate("circles, not lengths",
                         the_rule_is_the_circle_not_the_length, 500, 20);
    return test_end((test_minima){.trials = 1400,
                                  .largest_n = 38,
                                  .zeros = 1000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
