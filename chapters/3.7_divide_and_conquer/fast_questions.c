/* fast_questions.c - the bounds of a part, and what to do below them. */
#include "chapters/3.7_divide_and_conquer/fast_questions.h"

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

void
fast_bounds(fast_run *run, double width, double height, double unit)
{
    double most = 0x1.01p0 * (width * width + height * height); /* squared length */
    run->sure_turn = 0x1p-51 * most + DBL_MIN;
    run->sure_circle = 0x1.1p-48 * most * most + 0x1p-998 * (1 + most);
    run->whole_turn = 0x1p53 * unit * unit;
    run->whole_circle = 0x1p27 * unit * unit;
}

/* Whole multiples of a unit, so few that no product was rounded (fast.P3): then the
 * determinant has the right sign, and 0 is 0. So grids are no trouble. */
int
fast_near_turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r, double det)
{
    point2 a = fast_at(run, p), b = fast_at(run, q), c = fast_at(run, r);
    double x = fmax(fabs(a.x - c.x), fabs(b.x - c.x));
    double y = fmax(fabs(a.y - c.y), fabs(b.y - c.y));
    if (4 * x * y < run->whole_turn)
        return (det > 0) - (det < 0);
    return cross_sign(a, c, b, c);
}

bool
fast_near_circle(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, uint32_t q,
                 double det, double lifts)
{
    if (lifts < run->whole_circle) {
        PREDICATE_COUNT(incircle);
        return det > 0;
    }
    return incircle(fast_at(run, l), fast_at(run, r), fast_at(run, p),
                    fast_at(run, q)) > 0;
}
