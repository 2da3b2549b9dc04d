/* exact.c - the signs that the filters of predicates.h cannot vouch for.
 *
 * Notes: section 3.4. Three steps, from cheap to certain; each is exact when it
 * answers:
 *
 *   Step 1  the order of the coordinates alone, or two points that coincide
 *   Step 2  expansions, when no product can leave their range
 *   Step 3  one wide integer, for every finite double
 */
#include "chapters/3.4_primitives/predicates.h"

#include "chapters/3.4_primitives/wide.h"
#include "lib/expansion.h"

#include <stdbool.h>

#ifdef TRI_COUNTED
_Thread_local predicate_counts predicate_count;
#endif

/* The sign of x - y. */
static int
compare(double x, double y)
{
    return (x > y) - (x < y);
}

static bool
equal2(point2 p, point2 q)
{
    return p.x == q.x && p.y == q.y;
}

static bool
equal3(point3 p, point3 q)
{
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

/* The point of the plane below p. */
static point2
below(point3 p)
{
    return (point2){p.x, p.y};
}

/* An answer, noted in the counted build when it is 0. */
static int
answer(int sign)
{
    if (sign == 0)
        PREDICATE_COUNT(zeros);
    return sign;
}

/* Is a coordinate in the range of expansions? Then it is a multiple of 2^-252,
 * and so are the differences, which are at most 2^241. Products of four are
 * multiples of 2^-1008 and their sums far below 2^1023: the conditions of
 * two_product, with room to spare. */
static bool
is_moderate(double x)
{
    return x == 0 || (fabs(x) >= 0x1p-200 && fabs(x) <= 0x1p240);
}

static bool
moderate(const point2 p[4])
{
    bool all = true;
    for (int i = 0; i < 4; i++)
        all = all && is_moderate(p[i].x) && is_moderate(p[i].y);
    return all;
}

/* ---- Step 2: the determinants of the differences, as expansions. ---- */

/* A row of a determinant. */
typedef struct row {
    expansion x, y, z;
} row;

/* The vector from q to p, without the z. */
static row
vector(expansion_room *room, point2 p, point2 q)
{
    return (row){.x = expansion_difference(room, p.x, q.x),
                 .y = expansion_difference(room, p.y, q.y)};
}

/* | u.x u.y |
 * | v.x v.y | */
static expansion
det2(expansion_room *room, row u, row v)
{
    expansion left = expansion_times(room, u.x, v.y);
    expansion right = expansion_times(room, u.y, v.x);
    return expansion_minus(room, left, right);
}

/* | u.x u.y u.z |
 * | v.x v.y v.z |  by its last column.
 * | w.x w.y w.z | */
static expansion
det3(expansion_room *room, row u, row v, row w)
{
    expansion first = expansion_times(room, u.z, det2(room, v, w));
    expansion second = expansion_times(room, v.z, det2(room, w, u));
    expansion third = expansion_times(room, w.z, det2(room, u, v));
    return expansion_plus(room, expansion_plus(room, first, second), third);
}

/* The vector from d to a, lifted to the paraboloid. */
static row
lifted(expansion_room *room, point2 a, point2 d)
{
    row v = vector(room, a, d);
    v.z = expansion_plus(room, expansion_times(room, v.x, v.x),
                         expansion_times(room, v.y, v.y));
    return v;
}

static row
vector3(expansion_room *room, point3 p, point3 q)
{
    return (row){.x = expansion_difference(room, p.x, q.x),
                 .y = expansion_difference(room, p.y, q.y),
                 .z = expansion_difference(room, p.z, q.z)};
}

/* ---- Step 3: the same determinants, written out as monomials. ---- */

/* w += sign * e f | p.x p.y |
 *                 | q.x q.y | */
static void
add_det2(wide *w, int sign, double e, double f, point2 p, point2 q)
{
    wide_add(w, +sign, e, f, p.x, q.y);
    wide_add(w, -sign, e, f, p.y, q.x);
}

/* w += sign * e f | a.x a.y 1 |
 *                 | b.x b.y 1 |
 *                 | c.x c.y 1 | */
static void
add_orient2d(wide *w, int sign, double e, double f, point2 a, point2 b,
             point2 c)
{
    add_det2(w, sign, e, f, a, b);
    add_det2(w, sign, e, f, b, c);
    add_det2(w, sign, e, f, c, a);
}

/* w += sign * (p.x^2 + p.y^2) * the determinant above */
static void
add_lift(wide *w, int sign, point2 p, point2 a, point2 b, point2 c)
{
    add_orient2d(w, sign, p.x, p.x, a, b, c);
    add_orient2d(w, sign, p.y, p.y, a, b, c);
}

/* w += sign * (p - q)^2 */
static void
add_square(wide *w, int sign, double p, double q)
{
    wide_add(w, +sign, 1, 1, p, p);
    wide_add(w, -sign, 1, 2, p, q);
    wide_add(w, +sign, 1, 1, q, q);
}

/* ---- The four tests. ---- */

/* A product's sign is known from the order of the coordinates, so only two
 * products of the same sign need arithmetic. The order alone decides orient2d for
 * three points on a line parallel to an axis, and when c is a or b. */
int
cross_sign_exact(point2 p, point2 q, point2 r, point2 s)
{
    int left = compare(p.x, q.x) * compare(r.y, s.y);
    int right = compare(p.y, q.y) * compare(r.x, s.x);
    if (left != right || left == 0) { // Step 1
        PREDICATE_COUNT(signs);
        return answer(compare(left, right));
    }
    const point2 given[4] = {p, q, r, s};
    if (moderate(given)) { // Step 2
        PREDICATE_COUNT(expansions);
        expansion_room room;
        room.used = 0;
        row qp = vector(&room, p, q), sr = vector(&room, r, s);
        return answer(expansion_sign(det2(&room, qp, sr)));
    }
    PREDICATE_COUNT(wide); // Step 3
    wide w;
    wide_clear(&w);
    add_det2(&w, +1, 1, 1, p, r);
    add_det2(&w, -1, 1, 1, p, s);
    add_det2(&w, -1, 1, 1, q, r);
    add_det2(&w, +1, 1, 1, q, s);
    return answer(wide_sign(&w));
}

/* Two distances of which one is 0 need no arithmetic. */
int
compare_distance_exact(point2 p, point2 q, point2 r, point2 s)
{
    if (equal2(p, q) || equal2(r, s)) { // Step 1
        PREDICATE_COUNT(signs);
        return answer(equal2(r, s) - equal2(p, q));
    }
    const point2 given[4] = {p, q, r, s};
    if (moderate(given)) { // Step 2
        PREDICATE_COUNT(expansions);
        expansion_room room;
        room.used = 0;
        row pq = lifted(&room, p, q), rs = lifted(&room, r, s);
        return answer(expansion_sign(expansion_minus(&room, pq.z, rs.z)));
    }
    PREDICATE_COUNT(wide); // Step 3
    wide w;
    wide_clear(&w);
    add_square(&w, +1, p.x, q.x);
    add_square(&w, +1, p.y, q.y);
    add_square(&w, -1, r.x, s.x);
    add_square(&w, -1, r.y, s.y);
    return answer(wide_sign(&w));
}

/* Two equal rows make a determinant zero. The four terms of Step 3 are the
 * 4 x 4 determinant of the notes, by its third column. */
int
incircle_exact(point2 a, point2 b, point2 c, point2 d)
{
    if (equal2(a, d) || equal2(b, d) || equal2(c, d) || equal2(a, b) ||
        equal2(b, c) || equal2(c, a)) { // Step 1
        PREDICATE_COUNT(signs);
        return answer(0);
    }
    const point2 given[4] = {a, b, c, d};
    if (moderate(given)) { // Step 2
        PREDICATE_COUNT(expansions);
        expansion_room room;
        room.used = 0;
        row da = lifted(&room, a, d), db = lifted(&room, b, d);
        row dc = lifted(&room, c, d);
        return answer(expansion_sign(det3(&room, da, db, dc)));
    }
    PREDICATE_COUNT(wide); // Step 3
    wide w;
    wide_clear(&w);
    add_lift(&w, +1, a, b, c, d);
    add_lift(&w, -1, b, a, c, d);
    add_lift(&w, +1, c, a, b, d);
    add_lift(&w, -1, d, a, b, c);
    return answer(wide_sign(&w));
}

/* The same with z in the place of the lift. */
int
orient3d_exact(point3 a, point3 b, point3 c, point3 d)
{
    if (equal3(a, d) || equal3(b, d) || equal3(c, d) || equal3(a, b) ||
        equal3(b, c) || equal3(c, a)) { // Step 1
        PREDICATE_COUNT(signs);
        return answer(0);
    }
    const point2 given[4] = {below(a), below(b), below(c), below(d)};
    const point2 heights[4] = {{a.z, b.z}, {c.z, d.z}};
    if (moderate(given) && moderate(heights)) { // Step 2
        PREDICATE_COUNT(expansions);
        expansion_room room;
        room.used = 0;
        row da = vector3(&room, a, d), db = vector3(&room, b, d);
        row dc = vector3(&room, c, d);
        return answer(expansion_sign(det3(&room, da, db, dc)));
    }
    PREDICATE_COUNT(wide); // Step 3
    wide w;
    wide_clear(&w);
    add_orient2d(&w, +1, a.z, 1, below(b), below(c), below(d));
    add_orient2d(&w, -1, b.z, 1, below(a), below(c), below(d));
    add_orient2d(&w, +1, c.z, 1, below(a), below(b), below(d));
    add_orient2d(&w, -1, d.z, 1, below(a), below(b), below(c));
    return answer(wide_sign(&w));
}
