/* complexes.c - (a) of what is enough to check: simplicial complexes. */
#include "tools/checks/complexes.h"

#include <stddef.h>

bool
face_is_part(const face *s, const face *t)
{
    for (int i = 0; i <= s->dimension; i++) {
        bool found = false;
        for (int j = 0; j <= t->dimension; j++)
            found = found || s->vertex[i] == t->vertex[j];
        if (!found)
            return false;
    }
    return true;
}

bool
face_equals(const face *s, const face *t)
{
    return s->dimension == t->dimension && face_is_part(s, t);
}

bool
face_is_listed(const face_list *list, const face *s)
{
    for (uint32_t i = 0; i < list->count; i++)
        if (face_equals(&list->item[i], s))
            return true;
    return false;
}

/* The face of s whose vertices have their bits in the set. */
static face
part_of(const face *s, unsigned set)
{
    face part = {.dimension = -1};
    for (int i = 0; i <= s->dimension; i++)
        if ((set >> i & 1) != 0)
            part.vertex[++part.dimension] = s->vertex[i];
    return part;
}

void
faces_close(face_list *list, const face *s)
{
    for (unsigned set = 1; set < 1u << (s->dimension + 1); set++) {
        face part = part_of(s, set);
        if (list->count < MOST_SIMPLICES && !face_is_listed(list, &part))
            list->item[list->count++] = part;
    }
}

static bool
all_marked(const face *s, const bool *marked)
{
    for (int i = 0; i <= s->dimension; i++)
        if (!marked[s->vertex[i]])
            return false;
    return true;
}

static bool
is_between(site a, site x, site b)
{
    return plane_orient(a, b, x) == 0 && plane_dot(a, x, b) < 0;
}

/* Is x in the relative interior of s? */
static bool
is_inside(const site *p, const face *s, site x)
{
    const uint32_t *v = s->vertex;
    if (s->dimension == 0)
        return plane_same(p[v[0]], x);
    if (s->dimension == 1)
        return is_between(p[v[0]], x, p[v[1]]);
    int side = plane_orient(p[v[0]], p[v[1]], x);
    return side != 0 && plane_orient(p[v[1]], p[v[2]], x) == side &&
           plane_orient(p[v[2]], p[v[0]], x) == side;
}

static bool
is_flat(const site *p, const face *s)
{
    const uint32_t *v = s->vertex;
    return (s->dimension == 1 && plane_same(p[v[0]], p[v[1]])) ||
           (s->dimension == 2 && plane_orient(p[v[0]], p[v[1]], p[v[2]]) == 0);
}

/* What is wrong with s alone: it is flat, or one of its faces is missing. */
static const char *
fault_of(const site *p, const face_list *list, const face *s, const bool *marked)
{
    if (is_flat(p, s))
        return all_marked(s, marked) ? "a simplex is flat" : NULL;
    for (unsigned set = 1; set < 1u << (s->dimension + 1); set++) {
        face part = part_of(s, set);
        if (!face_is_listed(list, &part) && all_marked(&part, marked))
            return part.dimension == 0 ? "a vertex is missing" : "an edge is missing";
    }
    return NULL;
}

static bool
edges_cross(site a, site b, site c, site d)
{
    return plane_orient(a, b, c) * plane_orient(a, b, d) < 0 &&
           plane_orient(c, d, a) * plane_orient(c, d, b) < 0;
}

/* Do two listed simplices meet where they must not? */
static const char *
fault_of_two(const site *p, const face *s, const face *t)
{
    if (face_equals(s, t))
        return "a simplex is listed twice";
    if (s->dimension == 0 && !face_is_part(s, t) && is_inside(p, t, p[s->vertex[0]]))
        return t->dimension == 0   ? "two vertices coincide"
               : t->dimension == 1 ? "a vertex lies inside an edge"
                                   : "a vertex lies inside a triangle";
    if (s->dimension == 1 && t->dimension == 1 &&
        edges_cross(p[s->vertex[0]], p[s->vertex[1]], p[t->vertex[0]],
                    p[t->vertex[1]]))
        return "two edges cross";
    return NULL;
}

const char *
faces_fault(const site *points, uint32_t n, const face_list *list, const bool *marked)
{
    for (uint32_t i = 0; i < list->count; i++)
        for (int k = 0; k <= list->item[i].dimension; k++)
            if (list->item[i].vertex[k] >= n)
                return "an index is too large";
    for (uint32_t i = 0; i < list->count; i++) {
        const face *s = &list->item[i];
        const char *fault = fault_of(points, list, s, marked);
        for (uint32_t j = 0; fault == NULL && j < list->count; j++)
            if (i != j && all_marked(s, marked) && all_marked(&list->item[j], marked))
                fault = fault_of_two(points, s, &list->item[j]);
        if (fault != NULL)
            return fault;
    }
    return NULL;
}
