/* lifting.c - the lifting map as it is printed, in rounded arithmetic. */
#include "chapters/3.3_lifting_map/lifting.h"

point3
lift(point2 p)
{
    return (point3){p.x, p.y, p.x * p.x + p.y * p.y};
}

/* orient3d calls that side "below" from which a, b, c turn clockwise. Seen from
 * below they do so when they turn counterclockwise in the plane. */
int
below_plane_rounded(point2 a, point2 b, point2 c, point2 d)
{
    return orient2d(a, b, c) * orient3d(lift(a), lift(b), lift(c), lift(d));
}
