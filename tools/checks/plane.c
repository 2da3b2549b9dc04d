/* plane.c - the determinants of the notes in 64-bit integers.
 *
 * Differences are below 2^14, squares below 2^28, so that a product of two
 * differences and a lift stays below 2^57, and a sum of six of them below 2^60.
 */
#include "tools/checks/plane.h"

static int
sign_of(int64_t x)
{
    return (x > 0) - (x < 0);
}

bool
plane_same(site p, site q)
{
    return p.x == q.x && p.y == q.y;
}

int
plane_orient(site a, site b, site c)
{
    int64_t acx = a.x - c.x, acy = a.y - c.y;
    int64_t bcx = b.x - c.x, bcy = b.y - c.y;
    return sign_of(acx * bcy - acy * bcx);
}

int
plane_incircle(site a, site b, site c, site d)
{
    int64_t ax = a.x - d.x, ay = a.y - d.y;
    int64_t bx = b.x - d.x, by = b.y - d.y;
    int64_t cx = c.x - d.x, cy = c.y - d.y;
    int64_t a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    return sign_of(a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) +
                   c2 * (ax * by - ay * bx));
}

int64_t
plane_length2(site p, site q)
{
    int64_t x = p.x - q.x, y = p.y - q.y;
    return x * x + y * y;
}

int
plane_along(site d, site p, site q)
{
    int64_t x = p.x - q.x, y = p.y - q.y;
    int met = sign_of(x * d.x + y * d.y);
    return met != 0 ? met : sign_of(y * d.x - x * d.y);
}

int
plane_dot(site p, site r, site q)
{
    int64_t prx = p.x - r.x, pry = p.y - r.y;
    int64_t qrx = q.x - r.x, qry = q.y - r.y;
    return sign_of(prx * qrx + pry * qry);
}
