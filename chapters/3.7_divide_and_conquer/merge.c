/* merge.c - two Delaunay triangulations, separated by a line, become one.
 *
 * We think of the line as vertical, with the first triangulation left of it. The
 * names of the claims are those of the page.
 */
#include "chapters/3.7_divide_and_conquer/divide.h"

#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"

/* Does p see hull edge e, from u to w: is p strictly right of it? */
static bool
sees(const mesh *m, const point2 *points, vertex_id p, halfedge_id e)
{
    vertex_id u = mesh_origin(m, e), w = mesh_dest(m, e);
    return orient2d(points[u], points[w], points[p]) < 0;
}

/* ---- Steps 1 and 2: the first edge between left and right. ---- */

/* The hull edge that leaves v. At the end of a path there is one, and the last
 * vertex of a path is an end. */
static halfedge_id
hull_edge_leaving(const mesh *m, vertex_id v)
{
    halfedge_id e = mesh_leaving(m, v);
    while (!mesh_is_hull_edge(m, e))
        e = mesh_around(m, e);
    return e;
}

/* While the right end sees the hull edge that arrives at the left end, or the left
 * end the one that leaves the right end, there is something below (P1). */
hull_pair
lower_tangent(const mesh *m, const point2 *points, halfedge_id left, halfedge_id right)
{
    for (;;) {
        vertex_id l = mesh_origin(m, left), r = mesh_origin(m, right);
        if (sees(m, points, r, mesh_hull_prev(m, left)))
            left = mesh_hull_prev(m, left);
        else if (sees(m, points, l, right))
            right = mesh_hull_next(m, right);
        else
            return (hull_pair){left, right};
    }
}

/* Returns the upper side of the new edge: the hull edge from r to l. */
static halfedge_id
bridge(mesh *m, hull_pair at)
{
    halfedge_id lr = mesh_bridge(m, at.left, at.right);
    trace_report(m, (trace_event){TRACE_BRIDGE, lr, mesh_origin(m, lr),
                                  mesh_dest(m, lr), NONE, NONE});
    return mesh_twin(m, lr);
}

/* ---- Steps 3 and 4: what rises with the edge rl, and what gives way to it. ---- */

/* Does p lie strictly inside the circle of the triangle left of e, if there is one? */
static bool
circle_contains(const mesh *m, const point2 *points, halfedge_id e, vertex_id p)
{
    if (!mesh_in_triangle(m, e))
        return false;
    vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e), c = mesh_apex(m, e);
    return incircle(points[a], points[b], points[c], points[p]) > 0;
}

/* The hull edge after rl, leaving l, once the triangles behind it have gone that r
 * drives out; NONE if r does not see it. To flip a hull edge takes its triangle
 * away: it becomes an edge to the outside, and the hull has a dent. */
static halfedge_id
left_candidate(mesh *m, const point2 *points, halfedge_id rl)
{
    vertex_id r = mesh_origin(m, rl);
    for (;;) {
        halfedge_id e = mesh_hull_next(m, rl);
        if (!sees(m, points, r, e))
            return NONE;
        if (!circle_contains(m, points, e, r))
            return e;
        flip(m, e);
    }
}

/* The same on the right: the hull edge before rl, arriving at r. */
static halfedge_id
right_candidate(mesh *m, const point2 *points, halfedge_id rl)
{
    vertex_id l = mesh_dest(m, rl);
    for (;;) {
        halfedge_id e = mesh_hull_prev(m, rl);
        if (!sees(m, points, l, e))
            return NONE;
        if (!circle_contains(m, points, e, l))
            return e;
        flip(m, e);
    }
}

/* Both ends see a candidate. Which will the circle through l and r meet first, when
 * it grows upwards? The right one if it lies inside the circle with the left one. */
static bool
right_is_first(const mesh *m, const point2 *points, halfedge_id left, halfedge_id right)
{
    vertex_id l = mesh_origin(m, left), y = mesh_dest(m, left);
    vertex_id x = mesh_origin(m, right), r = mesh_dest(m, right);
    return incircle(points[l], points[r], points[y], points[x]) > 0;
}

/* ---- Steps 5 and 6: one triangle more. ---- */

/* A new triangle over hull edge e and the one before it; returns its third side, a
 * hull edge. It is a flip, too: of the edge that runs from their common vertex to
 * the outside. */
static halfedge_id
fill_notch(mesh *m, halfedge_id e)
{
    halfedge_id spoke = mesh_next(mesh_twin(m, e));
    flip(m, spoke);
    return spoke;
}

/* ---- The merge. ---- */

void
merge(mesh *m, const point2 *points, vertex_id v, vertex_id w)
{
    hull_pair lowest = lower_tangent(m, points, hull_edge_leaving(m, v),
                                     hull_edge_leaving(m, w));  // Step 1
    halfedge_id rl = bridge(m, lowest);                         // Step 2
    while (!m->cancelled) {
        halfedge_id left = left_candidate(m, points, rl);       // Step 3
        halfedge_id right = right_candidate(m, points, rl);     // Step 4
        if (left == NONE && right == NONE)                      // Step 5: upper tangent
            return;
        bool go_right = left == NONE ||
            (right != NONE && right_is_first(m, points, left, right));
        rl = fill_notch(m, go_right ? rl : left);               // Step 6: rl rises.
    }
}
