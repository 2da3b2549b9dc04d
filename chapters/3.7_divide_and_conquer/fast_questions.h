/* fast_questions.h - orientation and incircle, as fast_merge.c asks them; no program
 * includes it.
 *
 * Notes: sections 3.4 and 3.7. Needs: fast_parts.h, predicates.h.
 *
 * A question is tried in rounded arithmetic. The answer stands when the determinant
 * exceeds what roundings can have changed for any sites in the box of a part (page 3.7,
 * fast.P2). The bound is computed once for the part, and not for each question as in
 * predicates.h: there is nothing left to do but the determinant. Else fast_questions.c
 * looks closer.
 */
#ifndef CHAPTERS_3_7_FAST_QUESTIONS_H
#define CHAPTERS_3_7_FAST_QUESTIONS_H

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.7_divide_and_conquer/fast_parts.h"

/* Fills in the sure bounds, for sites in a box of that width and height; and the whole
 * ones, for coordinates that are whole multiples of the unit (0: of no unit). */
void fast_bounds(fast_run *run, double width, double height, double unit);

/* The sign of orient2d, when `det`, which is it but for roundings, is not sure. */
int fast_near_turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r, double det);

/* Does q lie strictly inside the circle of l, r and p, when `det` is not sure? */
bool fast_near_circle(const fast_run *run, uint32_t l, uint32_t r, uint32_t p,
                      uint32_t q, double det);

static inline point2
fast_at(const fast_run *run, uint32_t site)
{
    return (point2){run->site[site].x, run->site[site].y};
}

/* The sign of orient2d. */
static inline int
fast_turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r)
{
    point2 a = fast_at(run, p), b = fast_at(run, q), c = fast_at(run, r);
    double det = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    PREDICATE_COUNT(orient2d);
    if (det > run->sure_turn)
        return +1;
    if (det < -run->sure_turn)
        return -1;
    return fast_near_turn(run, p, q, r, det);
}

/* ---- Questions about the rising edge lr. ---- */

/* How a site sees the edge from l to r: the dot and the cross product of the vectors to
 * both ends. Their quotient is the cotangent of the angle under which it sees lr. */
typedef struct fast_view {
    double dot, turn;
} fast_view;

static inline fast_view
fast_look(const fast_run *run, uint32_t p, uint32_t l, uint32_t r)
{
    point2 eye = fast_at(run, p), a = fast_at(run, l), b = fast_at(run, r);
    double ax = a.x - eye.x, ay = a.y - eye.y, bx = b.x - eye.x, by = b.y - eye.y;
    return (fast_view){ax * bx + ay * by, ax * by - ay * bx};
}

/* Is p strictly left of the line from l to r? */
static inline bool
fast_is_above(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, fast_view ps)
{
    PREDICATE_COUNT(orient2d);
    if (ps.turn > run->sure_turn)
        return true;
    if (ps.turn < -run->sure_turn)
        return false;
    return fast_near_turn(run, l, r, p, ps.turn) > 0;
}

/* Does q lie strictly inside the circle of l, r and p? From there it sees lr under a
 * larger angle than p does, with a smaller cotangent; multiplied by the cross products,
 * their difference is the incircle determinant (fast.P2). Requires: p is above lr. */
static inline bool
fast_is_inside(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, uint32_t q,
               fast_view ps, fast_view qs)
{
    PREDICATE_COUNT(incircle);
    double det = ps.dot * qs.turn - qs.dot * ps.turn;
    if (det > run->sure_circle)
        return true;
    if (det < -run->sure_circle)
        return false;
    return fast_near_circle(run, l, r, p, q, det);
}

#endif
