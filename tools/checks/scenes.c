/* scenes.c - points, a mesh, and one point more. */
#include "tools/checks/scenes.h"

#include "tools/checks/room.h"

#include <stdio.h>
#include <stdlib.h>

void
forget_scene(scene *sc)
{
    free(sc->before.path);
    triangle_list_free(&sc->around.list);
    sc->before = (piece){0};
}

bool
set_scene(session *s, scene *sc, uint32_t p, const site *at, uint32_t n)
{
    uint32_t *others = room_for(n, sizeof *others), count = 0;
    for (uint32_t i = 0; i < n; i++)
        if (!plane_same(at[i], at[p]))
            others[count++] = i;
    sc->p = p;
    sc->before = piece_at_random(trial_random(s), at, others, count, false);
    free(others);
    sc->around =
        sphere_of(at, n, sc->before.list, sc->before.path, sc->before.length, 1);
    bool enough = sc->before.list.count > 0 || sc->before.length > 1;
    if (!enough)
        forget_scene(sc);
    return enough;
}

void
give_scene(session *s, const scene *sc)
{
    keep_triangles(s, sc->before.list);
    give_points(s);
    if (sc->before.list.count > 0)
        give_triangles(s, sc->before.list);
    else
        give_path(s, sc->before.path, sc->before.length);
    show_path(s, sc->before.path, sc->before.length);
}

void
show_triangle(session *s, svg_style style, vertex_id infinity, vertex_id a, vertex_id b,
              vertex_id c)
{
    const uint32_t corner[3] = {a, b, c};
    if (a != infinity && b != infinity && c != infinity)
        show_face(s, style, corner, 3);
    else
        show_edge(s, style, a == infinity ? c : a, b == infinity ? c : b);
}

void
show_triangle_of(session *s, svg_style style, const scene *sc, halfedge_id e)
{
    triangle_list list = sc->around.list;
    show_triangle(s, style, sc->around.infinity, side_origin(list, e),
                  side_dest(list, e), side_apex(list, e));
}

static const char *const spot_names[] = {"nowhere", "in a triangle", "on an edge",
                                         "beyond the end of a path"};

const char *
spot_name(spot how)
{
    return spot_names[how];
}

name
name_of_triangle(vertex_id infinity, vertex_id a, vertex_id b, vertex_id c)
{
    name n;
    unsigned long p = a, q = b, r = c;
    if (a != infinity && b != infinity && c != infinity)
        snprintf(n.text, sizeof n.text, "triangle %lu-%lu-%lu", p, q, r);
    else
        snprintf(n.text, sizeof n.text, "the outside of %lu-%lu",
                 a == infinity ? r : b == infinity ? p : q,
                 a == infinity ? q : b == infinity ? r : p);
    return n;
}

name
name_of_edge(vertex_id infinity, vertex_id a, vertex_id b)
{
    name n;
    if (a != infinity && b != infinity)
        snprintf(n.text, sizeof n.text, "%lu-%lu", (unsigned long)a, (unsigned long)b);
    else
        snprintf(n.text, sizeof n.text, "the edge from %lu to infinity",
                 (unsigned long)(a == infinity ? b : a));
    return n;
}

name
name_of(const scene *sc, halfedge_id e)
{
    triangle_list list = sc->around.list;
    return name_of_triangle(sc->around.infinity, side_origin(list, e),
                            side_dest(list, e), side_apex(list, e));
}
