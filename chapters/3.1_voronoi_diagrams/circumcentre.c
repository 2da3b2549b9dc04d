/* circumcentre.c - where the vertices are: an exact quotient, rounded once.
 *
 * Notes: section 3.1; skip it on first reading. Nothing is decided by what is
 * computed here.
 *
 * With |a|^2 for a.x^2 + a.y^2 the centre of the circle through a, b, c has
 *
 *          |a|^2 (b.y - c.y) + |b|^2 (c.y - a.y) + |c|^2 (a.y - b.y)      N
 *     x = ----------------------------------------------------------- =  ---
 *                         2 orient2d(a, b, c)                             2 O
 *
 * and y is the x of the mirrored triangle. No double is computed from N and O:
 * the right one is found by comparing, exactly, as in a guessing game.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.4_primitives/wide.h"
#include "lib/expansion.h"

#include <string.h>

/* ---- The doubles from 0 up, numbered. ---- */

/* Doubles that are not negative have the order of their bits as integers. */
static uint64_t
number_of(double x)
{
    uint64_t number;
    memcpy(&number, &x, sizeof number);
    return number;
}

static double
double_of(uint64_t number)
{
    double x;
    memcpy(&x, &number, sizeof x);
    return x;
}

/* The number of the largest double; after it comes infinity. */
#define LAST (UINT64_C(0x7fefffffffffffff))

/* ---- The exact question. ---- */

/* The quotient N / 2O for one triangle. If its coordinates are in range of
 * expansions, `exact` is set, and N and O are known. */
typedef struct quotient {
    point2 a, b, c;
    int sign_of_O;
    bool exact;
    expansion N, O;
    expansion_room *room; /* where N, O and what is made of them live */
} quotient;

/* Coordinates are multiples of 2^-152 and at most 2^100. Then N is a multiple
 * of 2^-456 and below 2^304, O of 2^-304 and 2^203, so unless N is 0 the
 * quotient is between 2^-660 and 2^609; products of it with O stay in range of
 * two_product. */
static bool
in_range(point2 p)
{
    bool x = p.x == 0 || (fabs(p.x) >= 0x1p-100 && fabs(p.x) <= 0x1p100);
    bool y = p.y == 0 || (fabs(p.y) >= 0x1p-100 && fabs(p.y) <= 0x1p100);
    return x && y;
}

static expansion
product(expansion_room *room, double p, double q)
{
    return expansion_times(room, expansion_difference(room, p, 0),
                           expansion_difference(room, q, 0));
}

/* |a|^2 (b.y - c.y) */
static expansion
term(expansion_room *room, point2 a, point2 b, point2 c)
{
    expansion square =
        expansion_plus(room, product(room, a.x, a.x), product(room, a.y, a.y));
    return expansion_times(room, square, expansion_difference(room, b.y, c.y));
}

static void
expand(quotient *t)
{
    expansion_room *room = t->room;
    t->N = expansion_plus(room, term(room, t->a, t->b, t->c),
                          expansion_plus(room, term(room, t->b, t->c, t->a),
                                         term(room, t->c, t->a, t->b)));
    expansion left =
        expansion_times(room, expansion_difference(room, t->a.x, t->c.x),
                        expansion_difference(room, t->b.y, t->c.y));
    expansion right =
        expansion_times(room, expansion_difference(room, t->a.y, t->c.y),
                        expansion_difference(room, t->b.x, t->c.x));
    t->O = expansion_minus(room, left, right);
}

/* The sign of N - (p + q) O: by expansions. */
static int
sign_by_expansions(const quotient *t, double p, double q)
{
    expansion_room *room = t->room;
    int used = room->used;
    expansion sum = expansion_plus(room, expansion_difference(room, p, 0),
                                   expansion_difference(room, q, 0));
    expansion rest =
        expansion_minus(room, t->N, expansion_times(room, sum, t->O));
    room->used = used;
    return expansion_sign(rest);
}

/* w += |a|^2 (b.y - c.y) - q (a.x b.y - a.y b.x) */
static void
add_terms(wide *w, point2 a, point2 b, point2 c, double p, double q)
{
    wide_add(w, +1, a.x, a.x, b.y, 1);
    wide_add(w, +1, a.y, a.y, b.y, 1);
    wide_add(w, -1, a.x, a.x, c.y, 1);
    wide_add(w, -1, a.y, a.y, c.y, 1);
    wide_add(w, -1, p, a.x, b.y, 1);
    wide_add(w, +1, p, a.y, b.x, 1);
    wide_add(w, -1, q, a.x, b.y, 1);
    wide_add(w, +1, q, a.y, b.x, 1);
}

/* The same sign by one wide integer. */
static int
sign_by_wide(const quotient *t, double p, double q)
{
    wide w;
    wide_clear(&w);
    add_terms(&w, t->a, t->b, t->c, p, q);
    add_terms(&w, t->b, t->c, t->a, p, q);
    add_terms(&w, t->c, t->a, t->b, p, q);
    return wide_sign(&w);
}

/* Is the quotient larger (+1) or smaller (-1) than (p+q)/2, or that (0)? */
static int
compare_with(const quotient *t, double p, double q)
{
    int sign = t->exact ? sign_by_expansions(t, p, q) : sign_by_wide(t, p, q);
    return sign * t->sign_of_O;
}

/* Is the quotient's magnitude at least the double with this number? Every one
 * is at least 0, and none is infinite. */
static bool
at_least(const quotient *t, int sign, uint64_t number)
{
    if (number == 0 || number > LAST)
        return number == 0;
    double q = sign * double_of(number);
    return sign * compare_with(t, q, q) >= 0;
}

/* ---- The answer. ---- */

/* The sum of the parts, rounded. */
static double
estimate(expansion e)
{
    double sum = 0;
    for (int i = 0; i < e.size; i++)
        sum += e.part[i];
    return sum;
}

/* Where to begin the search: any number will do, a good one makes it short. */
static uint64_t
guess(const quotient *t)
{
    point2 a = t->a, b = t->b, c = t->c;
    double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
    double N = (ax * ax + ay * ay) * by - (bx * bx + by * by) * ay;
    double x = c.x + N / (ax * by - ay * bx) / 2;
    if (t->exact)
        x = estimate(t->N) / estimate(t->O) / 2;
    return isfinite(x) ? number_of(fabs(x)) : 0;
}

/* The number of the largest double that is at most the quotient's magnitude:
 * from the guess by steps that double, and back by halves. */
static uint64_t
search(const quotient *t, int sign)
{
    uint64_t low = guess(t), high = low + 1, step;
    for (step = 1; !at_least(t, sign, low); step *= 2) {
        high = low;
        low = low > step ? low - step : 0;
    }
    for (step = 1; at_least(t, sign, high); step *= 2) {
        low = high;
        high = high < LAST - step ? high + step : LAST + 1;
    }
    while (high - low > 1) {
        uint64_t middle = low + (high - low) / 2;
        if (at_least(t, sign, middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The quotient rounded to nearest. Half way between two doubles, the one with
 * the even number has the even last bit. */
static tri_status
rounded(const quotient *t, double *x)
{
    int sign = compare_with(t, 0, 0);
    if (sign == 0) { /* frequent: sites that lie symmetrically about an axis */
        *x = 0;
        return TRI_OK;
    }
    uint64_t low = search(t, sign);
    if (low == LAST) {
        *x = sign * double_of(LAST);
        return compare_with(t, *x, *x) == 0 ? TRI_OK : TRI_OUT_OF_RANGE;
    }
    double below = sign * double_of(low), above = sign * double_of(low + 1);
    int half = sign * compare_with(t, below, above);
    *x = half > 0 || (half == 0 && low % 2 == 1) ? above : below;
    *x += 0.0; /* what rounds to -0 is 0 */
    return TRI_OK;
}

static tri_status
centre_x(point2 a, point2 b, point2 c, double *x)
{
    expansion_room room;
    room.used = 0;
    quotient t = {.a = a, .b = b, .c = c, .room = &room};
    t.sign_of_O = orient2d(a, b, c);
    t.exact = in_range(a) && in_range(b) && in_range(c);
    if (t.exact)
        expand(&t);
    return rounded(&t, x);
}

tri_status
circumcentre(point2 a, point2 b, point2 c, point2 *out)
{
    point2 ma = {a.y, a.x}, mb = {b.y, b.x}, mc = {c.y, c.x};
    assert(orient2d(a, b, c) != 0);
    tri_status status = centre_x(a, b, c, &out->x);
    if (status == TRI_OK)
        status = centre_x(ma, mb, mc, &out->y);
    if (status != TRI_OK)
        *out = (point2){0, 0};
    return status;
}

tri_status
voronoi_vertices(const voronoi *d, const point2 *points, point2 *at)
{
    for (uint32_t v = 0; v < d->vertices; v++) {
        const vertex_id *site = d->vertex_site + d->vertex_first[v];
        tri_status status = circumcentre(points[site[0]], points[site[1]],
                                         points[site[2]], &at[v]);
        if (status != TRI_OK)
            return status;
    }
    return TRI_OK;
}
