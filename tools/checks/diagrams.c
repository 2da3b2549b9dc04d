/* diagrams.c - Definitions 5 and 6 as they are written. */
#include "tools/checks/diagrams.h"

/* The points with p and q equally near are the centres of the circles through both. In
 * that pencil a site c left of pq excludes all circles beyond its own on one side, and
 * a site d on the right those on the other. Something is left between them, and more
 * than one circle, exactly when d is outside of the circle of p, q and c. */
bool
share_an_edge(const site *at, uint32_t n, site p, site q)
{
    for (uint32_t i = 0; i < n; i++) {
        int side = plane_orient(p, q, at[i]);
        if (side == 0 && plane_dot(p, at[i], q) < 0)
            return false;
        for (uint32_t j = 0; side > 0 && j < n; j++)
            if (plane_orient(p, q, at[j]) < 0 &&
                plane_incircle(p, q, at[i], at[j]) >= 0)
                return false;
    }
    return true;
}

bool
circle_is_empty(const site *at, uint32_t n, site a, site b, site c)
{
    int turn = plane_orient(a, b, c);
    for (uint32_t d = 0; d < n; d++)
        if (turn * plane_incircle(a, b, c, at[d]) > 0)
            return false;
    return true;
}

/* 0: in the direction of `from`; 1: left of it; 2: behind it; 3: right of it */
static int
quarter(site p, site from, site q)
{
    int side = plane_orient(p, from, q);
    if (side != 0)
        return side > 0 ? 1 : 3;
    return plane_dot(from, p, q) > 0 ? 0 : 2;
}

bool
is_met_before(site p, site from, site q, site r)
{
    int first = quarter(p, from, q), second = quarter(p, from, r);
    return first != second ? first < second : plane_orient(p, q, r) > 0;
}
