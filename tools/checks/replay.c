/* replay.c - flips in a list of triangles, slow and plain. */
#include "tools/checks/replay.h"
#include "tools/checks/room.h"

#include <string.h>

/* The side from a to b, or NONE. */
static halfedge_id
find_side(triangle_list list, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        if (side_origin(list, e) == a && side_dest(list, e) == b)
            return e;
    return NONE;
}

bool
find_quadrilateral(triangle_list list, vertex_id a, vertex_id b, quadrilateral *found)
{
    halfedge_id ab = find_side(list, a, b), ba = find_side(list, b, a);
    if (ab == NONE || ba == NONE)
        return false;
    *found = (quadrilateral){ab, ba, a, b, side_apex(list, ab), side_apex(list, ba)};
    return true;
}

bool
is_strictly_convex(const site *p, const quadrilateral *q)
{
    return plane_orient(p[q->c], p[q->d], p[q->b]) > 0 &&
           plane_orient(p[q->d], p[q->c], p[q->a]) > 0;
}

void
replay_flip(triangle_list list, const quadrilateral *q)
{
    const vertex_id dca[3] = {q->d, q->c, q->a}, cdb[3] = {q->c, q->d, q->b};
    memcpy(list.corner[q->ab / 3], dca, sizeof dca);
    memcpy(list.corner[q->ba / 3], cdb, sizeof cdb);
}

triangle_list
copy_triangles(triangle_list list)
{
    triangle_list copy = {.count = list.count};
    copy.corner = room_for(list.count, sizeof *copy.corner);
    if (list.count > 0)
        memcpy(copy.corner, list.corner, list.count * sizeof *list.corner);
    return copy;
}

triangle_id
missing_triangle(triangle_list t, triangle_list in)
{
    for (triangle_id i = 0; i < t.count; i++) {
        bool found = false;
        for (halfedge_id e = 0; e < 3 * in.count && !found; e++)
            found = side_origin(in, e) == t.corner[i][0] &&
                    side_dest(in, e) == t.corner[i][1] &&
                    side_apex(in, e) == t.corner[i][2];
        if (!found)
            return i;
    }
    return NONE;
}
