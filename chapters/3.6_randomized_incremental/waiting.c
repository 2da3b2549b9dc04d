/* waiting.c - where a waiting point goes, as signs of orientations. */
#include "chapters/3.6_randomized_incremental/waiting.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/walk.h"

/* On which side of the ray from s to w does q lie? A ray to infinity leads away from
 * o. If s is o itself the answer is 0: then q may go to either side. */
static int
side_of_ray(const point2 *points, vertex_id o, vertex_id s, vertex_id w, vertex_id q)
{
    if (w == GHOST)
        return orient2d(points[o], points[s], points[q]);
    return orient2d(points[s], points[w], points[q]);
}

bool
goes_left(const point2 *points, vertex_id o, vertex_id s, vertex_id w, vertex_id right,
          vertex_id q)
{
    int side = side_of_ray(points, o, s, w, q);
    if (side != 0 || w != GHOST)
        return side >= 0;
    bool towards_right = orient2d(points[s], points[right], points[q]) == 0 &&
                         is_same_side(points[s], points[right], points[q]);
    return !towards_right;
}

int
goes_between(const point2 *points, vertex_id o, vertex_id s, const vertex_id ray[3],
             vertex_id q)
{
    int side[3];
    for (int i = 0; i < 3; i++)
        side[i] = side_of_ray(points, o, s, ray[i], q);
    for (int i = 0; i < 2; i++)
        if (side[i] >= 0 && side[i + 1] <= 0)
            return i;
    return 2;
}
