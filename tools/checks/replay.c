/* replay.c - flips in a list of triangles, slow and plain. */
#include "tools/checks/replay.h"
#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>
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

/* The triangle with its smallest corner in front. */
static void
turn(vertex_id t[3])
{
    while (t[0] > t[1] || t[0] > t[2]) {
        vertex_id first = t[0];
        t[0] = t[1];
        t[1] = t[2];
        t[2] = first;
    }
}

static int
compare_triangles(const void *left, const void *right)
{
    const vertex_id *s = left, *t = right;
    for (int i = 0; i < 3; i++)
        if (s[i] != t[i])
            return s[i] < t[i] ? -1 : 1;
    return 0;
}

bool
same_triangles(triangle_list s, triangle_list t)
{
    if (s.count != t.count)
        return false;
    s = copy_triangles(s);
    t = copy_triangles(t);
    for (uint32_t i = 0; i < s.count; i++) {
        turn(s.corner[i]);
        turn(t.corner[i]);
    }
    qsort(s.corner, s.count, sizeof *s.corner, compare_triangles);
    qsort(t.corner, t.count, sizeof *t.corner, compare_triangles);
    bool same =
        s.count == 0 || memcmp(s.corner, t.corner, s.count * sizeof *s.corner) == 0;
    triangle_list_free(&s);
    triangle_list_free(&t);
    return same;
}
