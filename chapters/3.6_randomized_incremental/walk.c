/* walk.c - the straight walk. */
#include "chapters/3.6_randomized_incremental/walk.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/trace.h"

/* ---- On a line, and at the hull. ---- */

bool
is_same_side(point2 s, point2 p, point2 q)
{
    const point2 d = {1, 0}; /* any direction orders the points of a line */
    return compare_along(d, p, s) == compare_along(d, q, s);
}

halfedge_id
hull_edge_of(const mesh *m, halfedge_id e)
{
    while (mesh_apex(m, e) != GHOST)
        e = mesh_next(e);
    return mesh_twin(m, e);
}

bool
lies_beyond(const mesh *m, const point2 *points, halfedge_id e, point2 p)
{
    return orient2d(points[mesh_origin(m, e)], points[mesh_dest(m, e)], p) < 0;
}

/* ---- Step 1: at the vertex where the walk begins. ---- */

/* Does the walk from a to p leave vertex b on its right? If b lies on the way it
 * does not: we walk a hair to the right of all vertices in the way (walk.P1). */
static bool
is_right(const point2 *points, point2 a, point2 p, vertex_id b)
{
    return orient2d(a, p, points[b]) < 0;
}

/* The edge opposite v that the walk to p crosses, if it gets so far; or a hull edge
 * at v that p sees. NONE if p is in line with the hull edge that leaves v. */
static halfedge_id
first_edge(const mesh *m, const point2 *points, vertex_id v, point2 p)
{
    halfedge_id first = mesh_leaving(m, v), e = first;
    do {
        if (!mesh_in_triangle(m, e)) {
            halfedge_id hull = hull_edge_of(m, e);
            if (lies_beyond(m, points, hull, p))
                return hull;
        } else if (is_right(points, points[v], p, mesh_dest(m, e)) &&
                   !is_right(points, points[v], p, mesh_apex(m, e))) {
            return mesh_next(e);
        }
        e = mesh_around(m, e);
    } while (e != first);
    return NONE;
}

/* The edge from v towards p, which lies on that line; NONE at the end of a path. */
static halfedge_id
edge_towards(const mesh *m, const point2 *points, vertex_id v, point2 p)
{
    halfedge_id first = mesh_leaving(m, v), e = first;
    do {
        vertex_id a = mesh_dest(m, e);
        if (a != GHOST && orient2d(points[v], points[a], p) == 0 &&
            is_same_side(points[v], points[a], p))
            return e;
        e = mesh_around(m, e);
    } while (e != first);
    return NONE;
}

/* Two edges leave the end v of a path; one of them goes to infinity. */
static halfedge_id
hull_edge_leaving_end(const mesh *m, vertex_id v)
{
    halfedge_id e = mesh_leaving(m, v);
    return mesh_dest(m, e) == GHOST ? mesh_around(m, e) : e;
}

/* ---- Step 3: in the last triangle. ---- */

place
place_in_triangle(const mesh *m, const point2 *points, halfedge_id e, point2 p)
{
    for (int side = 0; side < 3; side++) {
        if (orient2d(points[mesh_origin(m, e)], points[mesh_dest(m, e)], p) == 0)
            return (place){PLACE_EDGE, e};
        e = mesh_next(e);
    }
    return (place){PLACE_TRIANGLE, e};
}

/* ---- The walk. ---- */

static void
report_visit(mesh *m, halfedge_id e)
{
    trace_report(m, (trace_event){TRACE_VISIT, e, NONE, NONE, NONE, NONE});
}

place
straight_walk(mesh *m, const point2 *points, vertex_id v, point2 p)
{
    halfedge_id e;
    while ((e = first_edge(m, points, v, p)) == NONE) {   // Step 1: from v, or
        e = edge_towards(m, points, v, p);                // along the hull.
        if (e == NONE)
            return (place){PLACE_BEYOND, hull_edge_leaving_end(m, v)};
        if (!is_same_side(points[mesh_dest(m, e)], points[v], p))
            v = mesh_dest(m, e);
        else
            return (place){PLACE_EDGE, e};
    }
    point2 start = points[v];
    report_visit(m, e);
    while (lies_beyond(m, points, e, p)) {             // Step 2: p is beyond e.
        e = mesh_twin(m, e);
        report_visit(m, e);
        if (mesh_apex(m, e) == GHOST)
            return (place){PLACE_TRIANGLE, e};
        bool right = is_right(points, start, p, mesh_apex(m, e));
        e = right ? mesh_prev(e) : mesh_next(e);
    }
    return place_in_triangle(m, points, e, p);            // Step 3
}
