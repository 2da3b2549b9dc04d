/* mesh.h - a triangulation in the plane, kept as a sphere of triangles.
 *
 * Notes: definition 4, drawn in chapters/1_introduction. Needs: lib/triangles.h,
 * lib/verdict.h.
 *
 * A triangle is three consecutive half-edges. A half-edge runs along one side of
 * a triangle, with the triangle on its left:
 *
 *                 c                 origin(ab) = a      next(ab) = bc
 *               /   ^               dest(ab)   = b      prev(ab) = ca
 *             /       \             apex(ab)   = c      twin(ab) = ba, in the
 *           v           \                                 triangle on the right
 *          a ----------> b
 *
 * Outside the convex hull there is one more vertex, GHOST, joined to every hull
 * edge. So every half-edge has a twin, and u >= 1 locations always make
 * 2u-2 triangles and 3u-3 edges, ghosts included, collinear locations too: they are
 * a path, and each edge of the path has a ghost triangle on both sides.
 *
 * A hull edge is a half-edge with a ghost triangle on its right: the hull lies to
 * its left, so the hull edges run counterclockwise. A path is run along twice,
 * there and back.
 *
 * The caller owns the points; the mesh holds their indices and knows no
 * coordinates. The arrays are filled by the verbs at the end of this file.
 */
#ifndef LIB_MESH_H
#define LIB_MESH_H

#include "lib/point.h"
#include "lib/status.h"
#include "lib/triangles.h"
#include "lib/verdict.h"

#include <assert.h>
#include <stdbool.h>
#include <stdint.h>

#define GHOST UINT32_MAX /* the vertex at infinity; no point has this index */

/* The most locations u for which 6u fits into 32 bits: 6u-6 half-edges and NONE. */
#define MESH_MOST_LOCATIONS 715827882u

typedef struct mesh_halfedge {
    vertex_id origin;
    halfedge_id twin;
} mesh_halfedge;

struct trace; /* trace.h */

typedef struct mesh {
    uint32_t points;         /* n: vertices are numbered 0 .. n-1 */
    uint32_t locations;      /* u: distinct among them; each has one vertex */
    uint32_t triangles;      /* made so far, ghosts included; 2u-2 at the end */
    mesh_halfedge *halfedge; /* half-edge -> origin and twin */
    halfedge_id *leaving;    /* vertex -> a half-edge leaving it, NONE if unused */
    halfedge_id ghost_leaving;
    struct trace *trace; /* who watches, or NULL */
    bool cancelled;      /* the observer asked to stop */
} mesh;

/* ---- Ten questions: the vocabulary in which the chapters speak. ---- */

/* The next half-edge around the same triangle, counterclockwise. */
static inline halfedge_id
mesh_next(halfedge_id e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* The previous half-edge around the same triangle. */
static inline halfedge_id
mesh_prev(halfedge_id e)
{
    return e % 3 == 0 ? e + 2 : e - 1;
}

/* The same edge in the other direction, in the triangle on the other side. */
static inline halfedge_id
mesh_twin(const mesh *m, halfedge_id e)
{
    return m->halfedge[e].twin;
}

/* The vertex that e leaves. */
static inline vertex_id
mesh_origin(const mesh *m, halfedge_id e)
{
    return m->halfedge[e].origin;
}

/* The vertex that e enters. */
static inline vertex_id
mesh_dest(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, mesh_next(e));
}

/* The third vertex of e's triangle. */
static inline vertex_id
mesh_apex(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, mesh_prev(e));
}

/* A half-edge that leaves v; NONE when v is unused (a duplicate, or a single
 * location, which has no edges). */
static inline halfedge_id
mesh_leaving(const mesh *m, vertex_id v)
{
    return v == GHOST ? m->ghost_leaving : m->leaving[v];
}

/* The next half-edge with the same origin, counterclockwise. Repeating it runs
 * once around the star of the origin; their mesh_next are its link. */
static inline halfedge_id
mesh_around(const mesh *m, halfedge_id e)
{
    return mesh_twin(m, mesh_prev(e));
}

/* The hull edge after hull edge e, counterclockwise: it begins where e ends. */
static inline halfedge_id
mesh_hull_next(const mesh *m, halfedge_id e)
{
    halfedge_id to_ghost = mesh_twin(m, mesh_prev(mesh_twin(m, e)));
    return mesh_twin(m, mesh_prev(to_ghost));
}

/* The hull edge before hull edge e: it ends where e begins. */
static inline halfedge_id
mesh_hull_prev(const mesh *m, halfedge_id e)
{
    halfedge_id from_ghost = mesh_twin(m, mesh_next(mesh_twin(m, e)));
    return mesh_twin(m, mesh_next(from_ghost));
}

/* ---- What kind of thing is this? ---- */

/* The triangle of which e is a side. */
static inline triangle_id
mesh_triangle_of(halfedge_id e)
{
    return e / 3;
}

/* Are all three corners of e's triangle points? If not, it is a ghost triangle:
 * a piece of the outside of the hull. */
static inline bool
mesh_in_triangle(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, e) != GHOST && mesh_dest(m, e) != GHOST &&
           mesh_apex(m, e) != GHOST;
}

/* Is e shared by two triangles, so that it lies inside the hull? */
static inline bool
mesh_is_interior(const mesh *m, halfedge_id e)
{
    return mesh_in_triangle(m, e) && mesh_in_triangle(m, mesh_twin(m, e));
}

/* Is the outside on the right of e? */
static inline bool
mesh_is_hull_edge(const mesh *m, halfedge_id e)
{
    return mesh_apex(m, mesh_twin(m, e)) == GHOST;
}

/* Some hull edge; NONE when there is no edge at all. */
halfedge_id mesh_some_hull_edge(const mesh *m);

/* How many hull edges there are: h of the notes; on a path, each edge twice. */
uint32_t mesh_hull_size(const mesh *m);

/* How many half-edges have been made; they are numbered 0 .. this-1. */
static inline halfedge_id
mesh_halfedges(const mesh *m)
{
    return 3 * m->triangles;
}

/* How many half-edges there is room for: as many as there will be at the end. */
static inline halfedge_id
mesh_room(const mesh *m)
{
    return m->locations > 1 ? 6 * m->locations - 6 : 0;
}

/* ---- Making and changing. ---- */

/* TRI_TOO_MANY_POINTS when handles for u locations do not fit into 32 bits. */
tri_status mesh_fits(uint32_t locations);

/* An empty mesh over `points` points with room for `locations` of them.
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS: *m is zeroed. Cost: O(points). */
tri_status mesh_init(mesh *m, uint32_t points, uint32_t locations);

/* Frees the arrays and zeroes *m; a zeroed mesh is accepted. */
void mesh_free(mesh *m);

/* What an algorithm ends with: nobody watches *m any longer. Returns the status, or
 * TRI_CANCELLED where the observer has stopped what would be TRI_OK; on any other than
 * TRI_OK *m is freed. */
tri_status mesh_finish(mesh *m, tri_status status);

/* A new triangle in the next free slot; returns the half-edge from a to b. Its
 * sides are not linked yet. Requires: room. */
halfedge_id mesh_add_triangle(mesh *m, vertex_id a, vertex_id b, vertex_id c);

/* From now on e leaves v. */
static inline void
mesh_set_origin(mesh *m, halfedge_id e, vertex_id v)
{
    m->halfedge[e].origin = v;
    if (v == GHOST)
        m->ghost_leaving = e;
    else
        m->leaving[v] = e;
}

/* The triangle of e becomes abc, with e leading from a to b. */
static inline void
mesh_set_triangle(mesh *m, halfedge_id e, vertex_id a, vertex_id b, vertex_id c)
{
    mesh_set_origin(m, e, a);
    mesh_set_origin(m, mesh_next(e), b);
    mesh_set_origin(m, mesh_prev(e), c);
}

/* e and f become twins. */
static inline void
mesh_link(mesh *m, halfedge_id e, halfedge_id f)
{
    m->halfedge[e].twin = f;
    m->halfedge[f].twin = e;
}

/* An edge of its own: a path from a to b, with the outside on both sides of it.
 * Returns the half-edge from a to b. Requires: room. */
halfedge_id mesh_start(mesh *m, vertex_id a, vertex_id b);

/* An edge between two triangulations, which makes them one: it joins the vertices
 * a and b where hull edges e and f begin. The two hulls
 *
 *     ... ---> a --e--> ...        and        ... ---> b --f--> ...
 *
 * become one, which runs along the new edge there and back:
 *
 *     ... ---> a ------> b --f--> ... ---> b ------> a --e--> ...
 *
 * Returns the half-edge from a to b; its twin is the hull edge before e.
 * Requires: room; e and f belong to different triangulations. */
halfedge_id mesh_bridge(mesh *m, halfedge_id e, halfedge_id f);

/* The outside of hull edge e, from a to b, becomes the triangle b a p.
 * Until mesh_hull_join has been called mesh_hull_next and mesh_hull_prev still follow
 * the old hull, and e is no hull edge any more. */
void mesh_cover(mesh *m, halfedge_id e, vertex_id p);

/* From now on the hull runs from where hull edge `first` begins to p, and from p
 * to where hull edge `end` begins.
 *
 *      ...  u ------- p ------- w --end--> ...      u = origin of first
 *            \first ...        /                    w = origin of end
 *
 * Requires: the hull edges from `first` up to and without `end` have been covered
 * with p; there may be none (first == end), then p hangs on one edge.
 * Returns the hull edge from p to w. */
halfedge_id mesh_hull_join(mesh *m, halfedge_id first, halfedge_id end, vertex_id p);

/* ---- Certifying and handing out. ---- */

/* Is *m a sphere of triangles as described above: twins that agree on their ends,
 * no triangle with a repeated corner, u used vertices, one cycle of triangles
 * around each of them and around GHOST, 2u-2 triangles in all? These make a closed
 * surface with v-e+f = 2. (That it is in one piece and lies flat in the plane is
 * for is_triangulation, 2.1, to say.)
 * Cost: O(n). Asks no predicate. */
verdict mesh_check(const mesh *m);

/* The triangles of *m, without the ghosts, in the order of their slots.
 * TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status mesh_triangles(const mesh *m, triangle_list *out);

#endif
