/* determinants.c - as in the notes, and rounded; predicates.h is exact. */
#include "chapters/3.4_primitives/determinants.h"

double
orient2d_rounded(point2 a, point2 b, point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double
orient2d_misprinted(point2 a, point2 b, point2 c)
{
    return orient2d_rounded(a, (point2){b.x, c.y}, c);
}

static double
lift(point2 p)
{
    return p.x * p.x + p.y * p.y;
}

/* By the third column; each cofactor is an orientation determinant. */
double
incircle_lifted(point2 a, point2 b, point2 c, point2 d)
{
    double first = lift(a) * orient2d_rounded(b, c, d);
    double second = lift(b) * orient2d_rounded(a, c, d);
    double third = lift(c) * orient2d_rounded(a, b, d);
    double fourth = lift(d) * orient2d_rounded(a, b, c);
    return first - second + third - fourth;
}

double
incircle_rounded(point2 a, point2 b, point2 c, point2 d)
{
    const point2 origin = {0, 0};
    a = (point2){a.x - d.x, a.y - d.y};
    b = (point2){b.x - d.x, b.y - d.y};
    c = (point2){c.x - d.x, c.y - d.y};
    return incircle_lifted(a, b, c, origin);
}
