/* Definition 5: the Voronoi region of a site is the intersection of its
 * half-planes; it has at most n-1 edges, and the regions cover the plane.
 *
 * Hypotheses: none. Sites may be cocircular, collinear or repeated.
 *
 * Whether a bisector carries an edge is decided a second time from the
 * definition alone, by the oracle, for each pair of sites and without building
 * anything.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/oracle/oracle.h"

static bool
same_place(point2 p, point2 q)
{
    return p.x == q.x && p.y == q.y;
}

/* Does a piece of the bisector of p and q belong to both regions? Each site r
 * on the left of pq leaves of it the part before the centre of p, q, r, each s
 * on the right the part after the centre of p, q, s; a site between p and q
 * leaves nothing. Some piece is left exactly when each s is strictly outside
 * the circle of each r. */
static bool
share_an_edge(const point2 *points, uint32_t n, point2 p, point2 q)
{
    for (uint32_t i = 0; i < n; i++) {
        point2 r = points[i];
        int side = oracle_orient2d(p, q, r);
        bool elsewhere = !same_place(r, p) && !same_place(r, q);
        if (side == 0 && elsewhere && oracle_compare_distance(p, r, p, q) < 0 &&
            oracle_compare_distance(q, r, p, q) < 0)
            return false;
        for (uint32_t k = 0; k < n && side > 0; k++)
            if (oracle_orient2d(p, q, points[k]) < 0 &&
                oracle_incircle(p, q, r, points[k]) >= 0)
                return false;
    }
    return true;
}

/* The lowest index at q's location. */
static vertex_id
first_at(const point2 *points, vertex_id q)
{
    vertex_id first = 0;
    while (!same_place(points[first], points[q]))
        first++;
    return first;
}

static bool
is_listed(const voronoi_region *r, vertex_id q)
{
    for (uint32_t i = 0; i < r->size; i++)
        if (r->neighbour[i] == q)
            return true;
    return false;
}

/* P1 and P2: the listed sites are those that carry an edge, counterclockwise: p
 * sees all of them within one turn, and gaps of half a turn only where they may
 * be. */
static void
regions_are_what_the_definition_says(const point2 *points, uint32_t n)
{
    for (vertex_id p = 0; p < n; p++) {
        voronoi_region r;
        CLAIM("sec3.1.P1", voronoi_region_of(points, n, p, &r) == TRI_OK,
              "no region");
        for (vertex_id q = 0; q < n; q++) {
            if (same_place(points[p], points[q]))
                continue;
            bool listed = is_listed(&r, q);
            bool carries = first_at(points, q) == q &&
                           share_an_edge(points, n, points[p], points[q]);
            CLAIM("sec3.1.P1", listed == carries,
                  "the bisector of %u and %u carries %s "
                  "edge of the region of %u",
                  p, q, carries ? "an" : "no", p);
        }
        CLAIM("sec3.1.P1", r.size < n || n == 0, "%u edges, %u sites", r.size,
              n);
        voronoi_region_free(&r);
    }
}

/* Counterclockwise, in one turn: the angles between consecutive sites, of which
 * those of half a turn and more are gaps, add up to one turn. There are at most
 * two gaps; an unbounded region begins after one. */
static void
regions_are_listed_counterclockwise(const point2 *points, uint32_t n)
{
    for (vertex_id p = 0; p < n; p++) {
        voronoi_region r;
        CLAIM("sec3.1.P2", voronoi_region_of(points, n, p, &r) == TRI_OK,
              "no region");
        uint32_t gaps = 0, first_gap = 0;
        for (uint32_t i = 0; i < r.size; i++) {
            vertex_id a = r.neighbour[i], b = r.neighbour[(i + 1) % r.size];
            if (oracle_orient2d(points[p], points[a], points[b]) <= 0) {
                gaps++;
                first_gap = i;
            }
            /* No other listed site is between a and b. */
            for (uint32_t k = 0; k < r.size; k++) {
                point2 c = points[r.neighbour[k]];
                bool between =
                    oracle_orient2d(points[p], points[a], points[b]) > 0 &&
                    oracle_orient2d(points[p], points[a], c) > 0 &&
                    oracle_orient2d(points[p], c, points[b]) > 0;
                CLAIM("sec3.1.P2", !between,
                      "%u lies between %u and %u, seen from %u", r.neighbour[k],
                      a, b, p);
            }
        }
        CLAIM("sec3.1.P2", gaps <= 2 && (gaps != 2 || r.size == 2),
              "the region of %u has %u gaps", p, gaps);
        CLAIM("sec3.1.P2", gaps != 1 || first_gap + 1 == r.size,
              "the list of %u does not begin after its gap", p);
        for (uint32_t i = 1; i < r.size && gaps != 1; i++)
            CLAIM("sec3.1.P2", r.neighbour[0] < r.neighbour[i],
                  "the list of %u does not begin with its lowest index", p);
        voronoi_region_free(&r);
    }
}

/* P3: a point x belongs to the regions of the sites nearest to it, and to no
 * other: the listed half-planes say the same as all of them. */
static void
regions_cover_the_plane(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n >= 1);
    random_source *source = test_random_source();
    point2 x = points[random_below(source, n)],
           y = points[random_below(source, n)];
    if (random_below(source, 2) == 0) /* often on a bisector, or close to one */
        x = (point2){x.x / 2 + y.x / 2, x.y / 2 + y.y / 2};
    else
        x.x = y.x;
    uint32_t regions = 0;
    for (vertex_id p = 0; p < n; p++) {
        bool nearest = true, in_region = true;
        voronoi_region r;
        CLAIM("sec3.1.P3", voronoi_region_of(points, n, p, &r) == TRI_OK,
              "no region");
        for (vertex_id q = 0; q < n; q++)
            nearest = nearest &&
                      oracle_compare_distance(x, points[p], x, points[q]) <= 0;
        for (uint32_t i = 0; i < r.size; i++)
            in_region = in_region &&
                        oracle_compare_distance(x, points[p], x,
                                                points[r.neighbour[i]]) <= 0;
        CLAIM("sec3.1.P3", nearest == in_region,
              "(%g,%g) is%s in the region of %u", x.x, x.y,
              in_region ? "" : " not", p);
        regions += in_region;
        voronoi_region_free(&r);
    }
    CLAIM("sec3.1.P3", regions >= 1, "(%g,%g) is in no region", x.x, x.y);
}

/* The centre of n-1 points on a circle has them all for neighbours. */
static void
all_others_can_be_neighbours(void)
{
    const point2 points[] = {{0, 0},  {5, 0},  {4, 3},  {3, 4},   {0, 5},
                             {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4},
                             {0, -5}, {3, -4}, {4, -3}};
    voronoi_region r;
    CLAIM("sec3.1.P1", voronoi_region_of(points, 13, 0, &r) == TRI_OK,
          "no region");
    CLAIM("sec3.1.P1", r.size == 12, "%u of 12 edges", r.size);
    voronoi_region_free(&r);
}

static void
nothing_leaks(void)
{
    const point2 points[] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {3, 2}};
    voronoi_region r;
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        memory_fail_at(k);
        status = voronoi_region_of(points, 5, 3, &r);
        memory_fail_at(0);
        CLAIM("sec3.1.P1",
              status == TRI_OK || (status == TRI_OUT_OF_MEMORY &&
                                   r.neighbour == NULL && r.size == 0),
              "allocation %lu: %s", k, tri_status_text(status));
    }
    voronoi_region_free(&r);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "Definition 5: a region is an intersection of half-planes");
    test_random("from the definition", regions_are_what_the_definition_says,
                800, 10);
    test_near_degenerate("from the definition",
                         regions_are_what_the_definition_says, 250, 8);
    test_grid_subsets("from the definition",
                      regions_are_what_the_definition_says, 3);
    test_random("counterclockwise", regions_are_listed_counterclockwise, 1000,
                25);
    test_near_degenerate("counterclockwise",
                         regions_are_listed_counterclockwise, 400, 12);
    test_grid_subsets("counterclockwise", regions_are_listed_counterclockwise,
                      3);
    test_random("they cover the plane", regions_cover_the_plane, 800, 20);
    test_near_degenerate("they cover the plane", regions_cover_the_plane, 400,
                         12);
    test_run("n-1 edges", all_others_can_be_neighbours);
    test_run("out of memory", nothing_leaks);
    return test_end((test_minima){.trials = 4000,
                                  .largest_n = 20,
                                  .zeros = 10000,
                                  .expansions = 1000,
                                  .wide = 1000});
}
