/* see_place.c - steps of 3.6: where is the next point, and who waits where? */
#include "tools/tri/see.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.6_randomized_incremental/walk.h"

/* ---- Finding it. ---- */

/* A walk visits triangles of today; a search of the history, those of other days. */
void
see_visit(tracer *w, const mesh *m, halfedge_id e)
{
    if (e == NONE) {
        w->arrows++;
        return;
    }
    vertex_id corner[3];
    corners_of(m, e, corner);
    for (int i = 0; i < 3; i++)
        id_list_add(&w->walk, corner[i]);
}

/* The walk was a walk to p. */
static void
write_visits(tracer *w, vertex_id p)
{
    step *s = &w->step;
    for (uint32_t i = 0; i < w->walk.count; i += 3) {
        const vertex_id *corner = w->walk.id + i;
        say(s, "the walk to %lu ", (unsigned long)p);
        if (corner[2] != NONE) {
            say(s, "%s the triangle ", i == 0 ? "begins in" : "comes to");
            say_corners(s, corner);
        } else {
            say(s, "%s ", i == 0 ? "begins at the edge" : "leaves the hull through");
            say_edge(s, corner[0], corner[1]);
        }
        show_corners(s, corner);
        id_list_add(&s->field[POINT], p);
        step_end(s, STEP_VISIT);
    }
    for (uint32_t i = 0; i < w->walk.count; i++)
        id_list_add(&s->field[VISITS], w->walk.id[i]);
    w->walk.count = 0;
}

/* p lies in the triangle of ab. If p is in line with ab it lies on the edge, between
 * its ends, or beyond the end a of the path along which all points lie. */
void
see_locate(tracer *w, const mesh *m, halfedge_id ab, vertex_id p)
{
    step *s = &w->step;
    const point2 *points = w->points;
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab), corner[3];
    bool in_line = orient2d(points[a], points[b], points[p]) == 0;
    bool between = in_line && is_same_side(points[a], points[b], points[p]) &&
                   is_same_side(points[b], points[a], points[p]);
    corners_of(m, ab, corner);
    if (in_line)
        corner[2] = NONE;
    w->divided[0] = between ? a : NONE;
    w->divided[1] = between ? b : NONE;

    write_visits(w, p);
    say(s, "%lu lies ", (unsigned long)p);
    if (in_line && !between) {
        say(s, "in line with all points so far, beyond %lu", (unsigned long)a);
    } else if (corner[2] != NONE) {
        say(s, "in the triangle ");
        say_corners(s, corner);
    } else {
        say(s, between ? "on the edge " : "outside of the hull: it sees ");
        say_edge(s, a, b);
    }
    if (w->arrows > 0) {
        say(s, "; the history tells it after ");
        say_count(s, w->arrows, "arrow");
    }
    show_corners(s, corner);
    id_list_add(&s->field[POINT], p);
    step_end(s, STEP_LOCATE);
    w->arrows = 0;
}

void
see_split(tracer *w, const mesh *m, vertex_id p)
{
    step *s = &w->step;
    join(s, m, p);
    if (w->divided[0] != NONE) {
        id_list_add_edge(&s->field[REMOVE], w->divided[0], w->divided[1]);
        say(s, "; it divides ");
        say_edge(s, w->divided[0], w->divided[1]);
    }
    step_end(s, STEP_SPLIT);
    w->newest = p;
    w->flipped = false;
}

/* ---- Those that wait. ---- */

/* The point q now waits in the triangle of e. It may have moved before, since the last
 * step: then that is forgotten. */
void
see_move(tracer *w, const mesh *m, halfedge_id e, vertex_id q)
{
    id_list *moves = &w->step.field[MOVES];
    vertex_id corner[3];
    w->pending = MORE_MOVES;
    corners_of(m, e, corner);
    uint32_t i = 0;
    while (i < moves->count && moves->id[i] != q)
        i += 4;
    if (i == moves->count)
        for (int k = 0; k < 4; k++)
            id_list_add(moves, q);
    for (uint32_t k = 0; k < 3; k++)
        moves->id[i + 1 + k] = corner[k];
}

static bool
is_same_place(const vertex_id p[3], const vertex_id q[3])
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* "2 and 4 now wait in the triangle 0, 1, 5; 3 outside, behind 0-1" */
void
write_moves(tracer *w)
{
    step *s = &w->step;
    const id_list *moves = &s->field[MOVES];
    for (uint32_t i = 0; i < moves->count; i += 4) {
        const vertex_id *here = moves->id + i + 1;
        bool said = false;
        for (uint32_t k = 0; k < i && !said; k += 4)
            said = is_same_place(moves->id + k + 1, here);
        if (said)
            continue;
        id_list points = {0};
        for (uint32_t k = i; k < moves->count; k += 4)
            if (is_same_place(moves->id + k + 1, here))
                id_list_add(&points, moves->id[k]);
        say(s, "%s", i == 0 ? "" : "; ");
        say_list(s, &points, 1);
        say(s, "%s%s ", i > 0 ? "" : points.count == 1 ? " now waits" : " now wait",
            here[2] == NONE ? " outside, behind" : " in the triangle");
        say_corners(s, here);
        id_list_free(&points);
    }
    step_end(s, STEP_MOVE);
}
