/* sphere.c - splits and flips in a list of triangles, slow and plain. */
#include "tools/checks/sphere.h"

#include "tools/checks/certify.h"
#include "tools/checks/room.h"

#include <stdlib.h>

static void
add(triangle_list *list, vertex_id a, vertex_id b, vertex_id c)
{
    vertex_id *corner = list->corner[list->count++];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

sphere
sphere_of(const site *at, uint32_t n, triangle_list list, const uint32_t *path,
          uint32_t count, uint32_t more)
{
    sphere s = {at, n, {0}, list.count == 0};
    size_t most = 2 * ((size_t)n + more + 2);
    s.list.corner = room_for(most, sizeof *s.list.corner);
    halfedge_id *twin = room_for(3 * (size_t)list.count, sizeof *twin);
    certify_twins(list, twin);
    for (uint32_t t = 0; t < list.count; t++)
        add(&s.list, list.corner[t][0], list.corner[t][1], list.corner[t][2]);
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        if (twin[e] == NONE)
            add(&s.list, side_dest(list, e), side_origin(list, e), n);
    free(twin);
    for (uint32_t i = 1; s.flat && i < count; i++) {
        add(&s.list, path[i - 1], path[i], n);
        add(&s.list, path[i], path[i - 1], n);
    }
    return s;
}

halfedge_id
sphere_side(const sphere *s, vertex_id a, vertex_id b, vertex_id c)
{
    for (halfedge_id e = 0; e < 3 * s->list.count; e++)
        if (side_origin(s->list, e) == a && side_dest(s->list, e) == b &&
            side_apex(s->list, e) == c)
            return e;
    return NONE;
}

/* The side from a to b. On a path a side to infinity has a namesake: not for these. */
static halfedge_id
side_from(const sphere *s, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < 3 * s->list.count; e++)
        if (side_origin(s->list, e) == a && side_dest(s->list, e) == b)
            return e;
    return NONE;
}

/* The next side of the same triangle. */
static halfedge_id
next_side(halfedge_id e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* The side of the triangle whose apex is at infinity; NONE if there is none. */
static halfedge_id
side_to_outside(const sphere *s, halfedge_id e)
{
    for (int i = 0; i < 3; i++) {
        if (side_apex(s->list, e) == s->infinity)
            return e;
        e = next_side(e);
    }
    return NONE;
}

/* On which side of e does p lie? Requires: no end is at infinity. */
static int
turn_at(const sphere *s, halfedge_id e, uint32_t p)
{
    return plane_orient(s->at[side_origin(s->list, e)], s->at[side_dest(s->list, e)],
                        s->at[p]);
}

/* p is in line with side e, of the outside. */
static spot
spot_in_line(const sphere *s, uint32_t p, halfedge_id *e)
{
    vertex_id a = side_origin(s->list, *e), b = side_dest(s->list, *e);
    if (plane_dot(s->at[a], s->at[p], s->at[b]) < 0)
        return SPOT_EDGE;
    bool behind_b = plane_dot(s->at[a], s->at[b], s->at[p]) < 0;
    vertex_id end = behind_b ? b : a;
    if (!s->flat || sphere_degree(s, end) != 2)
        return SPOT_NOWHERE;
    *e = behind_b ? side_from(s, b, a) : *e;
    return SPOT_BEYOND;
}

spot
sphere_spot(const sphere *s, uint32_t p, halfedge_id *e)
{
    halfedge_id outer = side_to_outside(s, *e);
    if (outer != NONE) {
        int turn = turn_at(s, outer, p);
        if (turn != 0)
            return turn > 0 ? SPOT_TRIANGLE : SPOT_NOWHERE;
        *e = outer;
        return spot_in_line(s, p, e);
    }
    halfedge_id on = NONE, side = *e;
    for (int i = 0; i < 3; i++, side = next_side(side)) {
        int turn = turn_at(s, side, p);
        if (turn < 0)
            return SPOT_NOWHERE;
        on = turn == 0 ? side : on;
    }
    if (on == NONE)
        return SPOT_TRIANGLE;
    *e = on;
    return SPOT_EDGE;
}

static void
replace(sphere *s, halfedge_id e, vertex_id a, vertex_id b, vertex_id c)
{
    vertex_id *corner = s->list.corner[e / 3];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

void
sphere_split(sphere *s, spot at, halfedge_id e, vertex_id p)
{
    vertex_id a = side_origin(s->list, e), b = side_dest(s->list, e);
    vertex_id c = side_apex(s->list, e), far = s->infinity;
    if (at == SPOT_BEYOND) {
        add(&s->list, a, p, far);
        add(&s->list, p, a, far);
        return;
    }
    if (at == SPOT_EDGE) {
        halfedge_id other = side_from(s, b, a);
        vertex_id d = side_apex(s->list, other);
        replace(s, other, b, p, d);
        add(&s->list, p, a, d);
        replace(s, e, a, p, c);
        add(&s->list, p, b, c);
        return;
    }
    replace(s, e, a, b, p);
    add(&s->list, b, c, p);
    add(&s->list, c, a, p);
    s->flat = false;
}

/* Is the triangle counterclockwise, or one of the outside? */
static bool
is_upright(const sphere *s, vertex_id a, vertex_id b, vertex_id c)
{
    if (a == s->infinity || b == s->infinity || c == s->infinity)
        return true;
    return plane_orient(s->at[a], s->at[b], s->at[c]) > 0;
}

/* An edge between a path and infinity is there twice, above and below. The one to be
 * flipped is the one where the new triangle is not turned over. */
bool
sphere_flip(sphere *s, vertex_id a, vertex_id b, vertex_id p)
{
    halfedge_id ab = sphere_side(s, a, b, p);
    if (ab == NONE) {
        vertex_id other = a;
        a = b;
        b = other;
        ab = sphere_side(s, a, b, p);
    }
    for (halfedge_id ba = 0; ab != NONE && ba < 3 * s->list.count; ba++) {
        vertex_id d = side_apex(s->list, ba);
        if (side_origin(s->list, ba) == b && side_dest(s->list, ba) == a &&
            d != s->infinity && is_upright(s, a, d, p) && is_upright(s, d, b, p)) {
            replace(s, ab, a, d, p);
            replace(s, ba, d, b, p);
            return true;
        }
    }
    return false;
}

bool
sphere_has(const sphere *s, triangle_id t, uint32_t p)
{
    halfedge_id outer = side_to_outside(s, 3 * t);
    if (s->flat) {
        halfedge_id e = outer;
        return sphere_spot(s, p, &e) != SPOT_NOWHERE;
    }
    if (outer != NONE)
        return turn_at(s, outer, p) >= 0;
    return turn_at(s, 3 * t, p) >= 0 && turn_at(s, 3 * t + 1, p) >= 0 &&
           turn_at(s, 3 * t + 2, p) >= 0;
}

uint32_t
sphere_degree(const sphere *s, vertex_id v)
{
    uint32_t degree = 0;
    for (halfedge_id e = 0; e < 3 * s->list.count; e++)
        degree += side_origin(s->list, e) == v;
    return degree;
}

triangle_list
sphere_triangles(const sphere *s)
{
    triangle_list list = {0};
    list.corner = room_for(s->list.count, sizeof *list.corner);
    for (triangle_id t = 0; t < s->list.count; t++)
        if (side_to_outside(s, 3 * t) == NONE)
            add(&list, s->list.corner[t][0], s->list.corner[t][1],
                s->list.corner[t][2]);
    return list;
}
