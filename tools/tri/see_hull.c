/* see_hull.c - steps of the sweep (2.3) and of the merge (3.7), outside of hulls. */
#include "tools/tri/see.h"

#include "chapters/3.4_primitives/predicates.h"

/* ---- 2.3: the first edge, and points that join the hull. ---- */

void
see_start(tracer *w, vertex_id a, vertex_id b)
{
    step *s = &w->step;
    say(s, "begin with %lu and %lu: the edge ", (unsigned long)a, (unsigned long)b);
    say_edge(s, a, b);
    id_list_add_edge(&s->field[ADD], a, b);
    id_list_add(&s->field[INSERT], a);
    id_list_add(&s->field[INSERT], b);
    step_end(s, STEP_START);
    w->flipped = false;
}

/* p has seen the edges opposite it: "no hull edge, ..." or "the hull edges 1-2 and
 * 2-5". */
static void
say_seen(step *s, const mesh *m, vertex_id p)
{
    id_list *seen = &s->field[EDGES];
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        if (mesh_in_triangle(m, e))
            id_list_add_edge(seen, mesh_dest(m, e), mesh_apex(m, e));
        e = mesh_around(m, e);
    } while (e != first);
    id_list_add(&s->field[POINT], p);
    if (seen->count == 0) {
        say(s, "no hull edge, as all points so far are in line with it");
    } else {
        say(s, "the hull edge%s ", seen->count == 2 ? "" : "s");
        say_list(s, seen, 2);
    }
}

void
see_attach(tracer *w, const mesh *m, vertex_id p)
{
    step *s = &w->step;
    say(s, "%lu comes: it sees ", (unsigned long)p);
    say_seen(s, m, p);
    step_end(s, STEP_SEE);

    join(s, m, p);
    say(s, ": it sees ");
    say_seen(s, m, p);
    step_end(s, STEP_ATTACH);
    w->flipped = false;
}

/* ---- 3.7: the merge. ---- */

void
see_bridge(tracer *w, vertex_id l, vertex_id r)
{
    step *s = &w->step;
    w->merging = true;
    w->l = l;
    w->r = r;
    say_edge(s, l, r);
    say(s,
        " is the lower tangent: no point of the two parts lies right of the line from "
        "%lu to %lu",
        (unsigned long)l, (unsigned long)r);
    id_list_add_edge(&s->field[EDGES], l, r);
    step_end(s, STEP_TANGENT);

    id_list_add_edge(&s->field[ADD], l, r);
    say(s, "join %lu and %lu by the lower tangent", (unsigned long)l, (unsigned long)r);
    step_end(s, STEP_BRIDGE);
}

/* The hull edge ab of the triangle abc goes, because of the other end of lr. */
void
see_drop(tracer *w, vertex_id a, vertex_id b, vertex_id c)
{
    step *s = &w->step;
    const vertex_id circle[3] = {a, b, c};
    bool left = a == w->l;
    vertex_id p = left ? w->r : w->l;
    id_list_add_edge(&s->field[REMOVE], a, b);
    show_circle(s, circle, p);
    say_edge(s, a, b);
    say(s, " goes: ");
    say_where(w, circle, p);
    step_end(s, left ? STEP_DROP_LEFT : STEP_DROP_RIGHT);
}

/* Does p see the hull edge from u to v? */
static bool
sees(const tracer *w, vertex_id p, vertex_id u, vertex_id v)
{
    return orient2d(w->points[u], w->points[v], w->points[p]) < 0;
}

/* There is one triangle more, on lr; its upper side is rl. One end of the edge has
 * stayed. The other candidate, if there is one, is still the hull edge behind it. */
void
see_rise(tracer *w, const mesh *m, halfedge_id rl)
{
    step *s = &w->step;
    vertex_id r = mesh_origin(m, rl), l = mesh_dest(m, rl);
    bool on_right = r != w->r;
    vertex_id winner = on_right ? r : l, stays = on_right ? l : r;
    vertex_id left_behind = on_right ? w->r : w->l;
    halfedge_id other = on_right ? mesh_hull_next(m, rl) : mesh_hull_prev(m, rl);
    vertex_id u = mesh_origin(m, other), v = mesh_dest(m, other);
    const vertex_id circle[3] = {w->l, w->r, winner};

    id_list_add_edge(&s->field[ADD], l, r);
    for (int i = 0; i < 3; i++)
        id_list_add(&s->field[TRIANGLE], circle[i]);
    say(s, "join ");
    say_edge(s, l, r);
    say(s, ": ");
    if (sees(w, left_behind, u, v)) {
        vertex_id loser = on_right ? v : u;
        show_circle(s, circle, loser);
        say_where(w, circle, loser);
    } else {
        say(s, "%lu is the only candidate, as %lu sees no hull edge at %lu",
            (unsigned long)winner, (unsigned long)left_behind, (unsigned long)stays);
    }
    step_end(s, STEP_RISE);
    w->l = l;
    w->r = r;
}

void
write_top(tracer *w)
{
    step *s = &w->step;
    w->merging = false;
    id_list_add_edge(&s->field[EDGES], w->l, w->r);
    say_edge(s, w->l, w->r);
    say(s,
        " is the upper tangent: no point of the two parts lies left of the line from "
        "%lu to %lu",
        (unsigned long)w->l, (unsigned long)w->r);
    step_end(s, STEP_TOP);
}
