/* Section 3.1: two families of local coordinates. A site p with a bounded cell
 * is a weighted mean of the sites q around it, with weights proportional to
 *
 *   l_q / |pq|   (Laplace)   l_q the length of the edge towards q,
 *   A_q          (Sibson)    A_q the area that p's cell takes from q's.
 *
 * Hypotheses: the cell of p is bounded. Here the coordinates are small whole
 * numbers, so that all weights are fractions, and the identities hold exactly.
 *
 * The exact areas come another way than those of the library: from a
 * triangulation of the sites without p, by the triangles whose circles p lies
 * in.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/memory.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"
#include "tests/oracle/big.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 9 }; /* coordinates: 0 .. 9 */

/* ---- Fractions. ---- */

typedef struct fraction {
    big over, under; /* under is not 0 */
} fraction;

static fraction
whole(double x)
{
    return (fraction){big_from_double(x, 0), big_from_double(1, 0)};
}

static fraction
times(fraction a, fraction b)
{
    return (fraction){big_multiply(&a.over, &b.over),
                      big_multiply(&a.under, &b.under)};
}

static fraction
over(fraction a, fraction b)
{
    return (fraction){big_multiply(&a.over, &b.under),
                      big_multiply(&a.under, &b.over)};
}

static bool
equal(const big *a, const big *b)
{
    return big_subtract(a, b).sign == 0;
}

static fraction
plus(fraction a, fraction b)
{
    if (equal(&a.under, &b.under))
        return (fraction){big_add(&a.over, &b.over), a.under};
    big left = big_multiply(&a.over, &b.under),
        right = big_multiply(&b.over, &a.under);
    return (fraction){big_add(&left, &right), big_multiply(&a.under, &b.under)};
}

static fraction
minus(fraction a, fraction b)
{
    b.over.sign = -b.over.sign;
    return plus(a, b);
}

/* The integer, rounded: its highest two digits and their place. */
static double
scaled_double(const big *a, int *exponent)
{
    double sum = 0;
    int low = a->size > 3 ? a->size - 3 : 0;
    for (int i = a->size; i > low; i--)
        sum = sum * 0x1p32 + a->digit[i - 1];
    *exponent = 32 * low;
    return a->sign * sum;
}

static double
rounded(fraction a)
{
    int e, f;
    double top = scaled_double(&a.over, &e),
           bottom = scaled_double(&a.under, &f);
    return ldexp(top / bottom, e - f);
}

/* ---- Exact vertices. ---- */

typedef struct exact_point {
    fraction x, y;
} exact_point;

/* The centre of the circle through three points with whole coordinates up to
 * MOST: all of its numbers are far below 2^53. */
static exact_point
centre(point2 a, point2 b, point2 c)
{
    double al = a.x * a.x + a.y * a.y, bl = b.x * b.x + b.y * b.y;
    double cl = c.x * c.x + c.y * c.y;
    double O = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    double x = al * (b.y - c.y) + bl * (c.y - a.y) + cl * (a.y - b.y);
    double y = al * (c.x - b.x) + bl * (a.x - c.x) + cl * (b.x - a.x);
    return (exact_point){over(whole(x), whole(2 * O)),
                         over(whole(y), whole(2 * O))};
}

/* a x b */
static fraction
cross(exact_point a, exact_point b)
{
    return minus(times(a.x, b.y), times(a.y, b.x));
}

/* ---- The cell of p, as sites counterclockwise. ---- */

typedef struct cell {
    uint32_t size;
    vertex_id beyond[64];
} cell;

static cell
cell_of(const voronoi *d, vertex_id p)
{
    cell c = {0};
    for (uint32_t i = d->cell_first[p]; i < d->cell_first[p + 1]; i++)
        c.beyond[c.size++] = voronoi_beyond(d, d->cell_edge[i], p);
    return c;
}

/* Claims that the sum of w_q (q - p) is 0 and that the library's weights are
 * those. */
static void
check_weights(const char *name, const point2 *points, vertex_id p, cell c,
              const fraction *weight, const double *given)
{
    fraction x = whole(0), y = whole(0), sum = whole(0);
    for (uint32_t i = 0; i < c.size; i++) {
        point2 q = points[c.beyond[i]];
        CLAIM(name, weight[i].over.sign * weight[i].under.sign > 0,
              "site %u: the weight of %u is not positive", p, c.beyond[i]);
        x = plus(x, times(weight[i], whole(q.x - points[p].x)));
        y = plus(y, times(weight[i], whole(q.y - points[p].y)));
        sum = plus(sum, weight[i]);
    }
    CLAIM(name, x.over.sign == 0 && y.over.sign == 0,
          "site %u: the sum is (%g,%g)", p, rounded(x), rounded(y));
    for (uint32_t i = 0; i < c.size; i++) {
        double exact = rounded(over(weight[i], sum));
        CLAIM(name, fabs(given[i] - exact) < 1e-12,
              "site %u: the weight of %u is %.17g, "
              "and not %.17g",
              p, c.beyond[i], exact, given[i]);
    }
}

/* ---- Laplace. ---- */

/* An edge runs at a right angle to q - p, so its vector times (q-p) turned
 * left, divided by |pq|^2, is its length by |pq|. */
static void
check_laplace(const point2 *points, const voronoi *d, vertex_id p)
{
    cell c = cell_of(d, p);
    fraction weight[64];
    double given[64];
    for (uint32_t i = 0; i < c.size; i++) {
        vertex_id before = c.beyond[(i + c.size - 1) % c.size];
        vertex_id after = c.beyond[(i + 1) % c.size];
        point2 at = points[p], q = points[c.beyond[i]];
        exact_point begin = centre(at, points[before], q),
                    end = centre(at, q, points[after]);
        double dx = q.x - at.x, dy = q.y - at.y;
        fraction along = plus(times(minus(end.x, begin.x), whole(-dy)),
                              times(minus(end.y, begin.y), whole(dx)));
        weight[i] = over(along, whole(dx * dx + dy * dy));
    }
    CLAIM("sec3.1.P15", laplace_coordinates(d, points, p, given) == TRI_OK,
          "no weights");
    check_weights("sec3.1.P15", points, p, c, weight, given);
}

/* ---- Sibson. ---- */

static bool
has_inside(const mesh *m, const point2 *points, halfedge_id e, point2 x)
{
    return mesh_in_triangle(m, e) &&
           incircle(points[mesh_origin(m, e)], points[mesh_dest(m, e)],
                    points[mesh_apex(m, e)], x) > 0;
}

/* Twice the area that p takes from q: of the polygon from where the edge
 * between them ends, over the vertices that lie in p's cell, around q, to where
 * it begins. */
static fraction
twice_taken(const mesh *without, const point2 *points, point2 p, vertex_id q,
            exact_point begin, exact_point end)
{
    fraction sum = cross(begin, end);
    exact_point last = end;
    halfedge_id e = mesh_leaving(without, q), first;
    for (uint32_t turns = 0; has_inside(without, points, e, p); turns++) {
        CLAIM("sec3.1.P16", turns < 1000, "p lies in all circles around %u", q);
        e = mesh_around(without, e);
    }
    for (first = e; !has_inside(without, points, e, p);) {
        e = mesh_around(without, e);
        CLAIM("sec3.1.P16", e != first, "p takes nothing from %u", q);
    }
    for (; has_inside(without, points, e, p); e = mesh_around(without, e)) {
        exact_point next = centre(points[mesh_origin(without, e)],
                                  points[mesh_dest(without, e)],
                                  points[mesh_apex(without, e)]);
        sum = plus(sum, cross(last, next));
        last = next;
    }
    return plus(sum, cross(last, begin));
}

static void
check_sibson(const point2 *points, uint32_t n, const voronoi *d, vertex_id p)
{
    cell c = cell_of(d, p);
    fraction weight[64], whole_cell = whole(0), taken = whole(0);
    double given[64];
    mesh without;
    point2 *others =
        malloc(n * sizeof *others); /* p becomes a copy of a neighbour */
    memcpy(others, points, n * sizeof *others);
    for (vertex_id i = 0; i < n; i++)
        if (points[i].x == points[p].x && points[i].y == points[p].y)
            others[i] = points[c.beyond[0]];
    CLAIM("sec3.1.P16", lawson_triangulate(others, n, NULL, &without) == TRI_OK,
          "no mesh");
    for (uint32_t i = 0; i < c.size; i++) {
        vertex_id before = c.beyond[(i + c.size - 1) % c.size], q = c.beyond[i];
        vertex_id after = c.beyond[(i + 1) % c.size], name = q;
        exact_point begin = centre(points[p], points[before], points[q]);
        exact_point end = centre(points[p], points[q], points[after]);
        if (mesh_leaving(&without, q) == NONE)
            name = p; /* p has a lower index than the neighbour it copies */
        weight[i] = twice_taken(&without, others, points[p], name, begin, end);
        taken = plus(taken, weight[i]);
        whole_cell = plus(whole_cell, cross(begin, end));
    }
    mesh_free(&without);
    free(others);
    CLAIM("sec3.1.P16", minus(taken, whole_cell).over.sign == 0,
          "the areas taken are %g of "
          "%g",
          rounded(taken), rounded(whole_cell));
    CLAIM("sec3.1.P16", sibson_coordinates(d, points, p, given) == TRI_OK,
          "no weights");
    check_weights("sec3.1.P16", points, p, c, weight, given);
}

/* ---- The statements. ---- */

/* Whole points, and each site among them that has a bounded cell, but for those
 * with more neighbours than the fractions have digits for. */
static void
each_bounded_site(uint32_t n, bool sibson)
{
    point2 *points = whole_points(NULL, n, MOST);
    mesh m;
    voronoi d;
    CLAIM("sec3.1.P15", lawson_triangulate(points, n, NULL, &m) == TRI_OK,
          "no mesh");
    CLAIM("sec3.1.P15", voronoi_dual(&m, points, &d) == TRI_OK, "no diagram");
    for (vertex_id p = 0; p < n; p++) {
        if (!voronoi_is_bounded(&d, p) || cell_of(&d, p).size > 8)
            continue;
        if (sibson)
            check_sibson(points, n, &d, p);
        else
            check_laplace(points, &d, p);
    }
    voronoi_free(&d);
    mesh_free(&m);
    free(points);
}

static void
laplace_coordinates_reproduce_the_site(const point2 *points, uint32_t n)
{
    (void)points;
    each_bounded_site(n, false);
}

static void
sibson_coordinates_reproduce_the_site(const point2 *points, uint32_t n)
{
    (void)points;
    each_bounded_site(n, true);
}

/* The middle of a square has four equal weights, in both families. */
static void
known_weights(void)
{
    const point2 square[] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    mesh m;
    voronoi d;
    double w[4];
    CLAIM("sec3.1.P15",
          lawson_triangulate(square, 5, NULL, &m) == TRI_OK &&
              voronoi_dual(&m, square, &d) == TRI_OK,
          "no diagram");
    CLAIM("sec3.1.P15", laplace_coordinates(&d, square, 0, w) == TRI_OK,
          "no weights");
    for (int i = 0; i < 4; i++)
        CLAIM("sec3.1.P15", w[i] == 0.25, "weight %d is %g", i, w[i]);
    CLAIM("sec3.1.P16", sibson_coordinates(&d, square, 0, w) == TRI_OK,
          "no weights");
    for (int i = 0; i < 4; i++)
        CLAIM("sec3.1.P16", w[i] == 0.25, "weight %d is %g", i, w[i]);
    memory_fail_at(1);
    tri_status status = sibson_coordinates(&d, square, 0, w);
    memory_fail_at(0);
    CLAIM("sec3.1.P16", status == TRI_OUT_OF_MEMORY, "%s",
          tri_status_text(status));
    voronoi_free(&d);
    mesh_free(&m);
}

/* Squares of areas and lengths that leave the doubles are refused. */
static void
weights_out_of_range_are_refused(void)
{
    const double s = 0x1p600, t = 0x1p-600;
    for (int small = 0; small < 2; small++) {
        double u = small ? t : s;
        const point2 points[] = {{0, 0}, {u, u}, {-u, u}, {-u, -u}, {u, -u}};
        mesh m;
        voronoi d;
        double w[4];
        CLAIM("sec3.1.P16",
              lawson_triangulate(points, 5, NULL, &m) == TRI_OK &&
                  voronoi_dual(&m, points, &d) == TRI_OK,
              "no diagram");
        tri_status status = sibson_coordinates(&d, points, 0, w);
        CLAIM("sec3.1.P16", status == TRI_OUT_OF_RANGE, "%s",
              tri_status_text(status));
        voronoi_free(&d);
        mesh_free(&m);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "3.1: local coordinates of Laplace and of Sibson");
    test_random("Laplace", laplace_coordinates_reproduce_the_site, 1500, 20);
    test_random("Sibson", sibson_coordinates_reproduce_the_site, 1500, 20);
    test_run("known weights", known_weights);
    test_run("out of range", weights_out_of_range_are_refused);
    return test_end(
        (test_minima){.trials = 3000, .largest_n = 15, .zeros = 1000});
}
