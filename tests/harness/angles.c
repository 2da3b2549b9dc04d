/* angles.c - dot and cross products of whole numbers. */
#include "tests/harness/angles.h"

angle
angle_at(point2 q, point2 p, point2 r)
{
    double px = p.x - q.x, py = p.y - q.y, rx = r.x - q.x, ry = r.y - q.y;
    double cross = px * ry - py * rx;
    return (angle){px * rx + py * ry, cross < 0 ? -cross : cross};
}

int
compare_angles(angle s, angle t)
{
    double left = t.dot * s.cross, right = s.dot * t.cross;
    return (left > right) - (left < right);
}
