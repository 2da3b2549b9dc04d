/* flips.h - from any triangulation to the Delaunay triangulation, edge by edge.
 *
 * Notes: section 3.5, Definition 9, Figure 10. Needs: 2.3 (a triangulation to begin
 * with), 3.4, lib/mesh.h. Exercises: 3.5-a to 3.5-c.
 */
#ifndef CHAPTERS_3_5_FLIPS_H
#define CHAPTERS_3_5_FLIPS_H

#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/steps.h"

/* Is ab locally Delaunay (Definition 9)?
 *
 *   true   ab belongs to one triangle only, or to abc and abd and d does not lie
 *          strictly inside the circumcircle of abc
 *   false  d lies strictly inside it
 *
 * Requires: ab is an edge, between two points. Cost: at most 1 incircle test.
 * Source: notes 3.5, Definition 9; "not inside" for "outside": docs/errata.md, E32.
 */
bool is_locally_delaunay(const mesh *m, const point2 *points, halfedge_id ab);

/* Can ab be flipped: is it shared by two triangles abc and abd whose union is a
 * strictly convex quadrilateral?
 *
 * Cost: at most 2 orientation tests. Source: notes 3.5.1; docs/errata.md, E34.
 */
bool is_flippable(const mesh *m, const point2 *points, halfedge_id ab);

/* Flips ab to cd: the triangles abc and bad become dca and cdb.
 *
 *              c                        c           before   after
 *            /   \                    / ^ \         ab       dc
 *          /       \                /   |   \       bc       ca
 *        /           \     flip   /     |     \     ca       ad
 *       a ----------> b   =====> a      |      b    ba       cd
 *        \           /            \     |     /     ad       db
 *          \       /                \   |   /       db       bc
 *            \   /                    \ | /
 *              d                        d
 *
 * Every half-edge of the two triangles is still one of them, turned one place
 * counterclockwise: the half-edge that led from a to b leads from d to c, and so
 * on down the table. All other half-edges stay. Four flips restore everything.
 * Requires: is_flippable. Cost: O(1), no test.
 * Source: notes 3.5.1, line 4 of Figure 10.
 */
void flip(mesh *m, halfedge_id ab);

/* The stack L of edges that may not be locally Delaunay. An edge is kept as a
 * half-edge and is on the stack at most once in each direction. */
typedef struct edge_stack {
    mesh *m;            /* the triangulation whose edges these are */
    halfedge_id *entry; /* entry[0 .. size-1]; room for every half-edge */
    uint32_t size;
    bool *on_stack; /* half-edge -> is it an entry? */
} edge_stack;

/* An empty stack for the edges of *m, those to come included.
 * TRI_OUT_OF_MEMORY: *L is zeroed. */
tri_status edge_stack_init(edge_stack *L, mesh *m);

/* Frees the arrays and zeroes *L; a zeroed stack is accepted. */
void edge_stack_free(edge_stack *L);

/* Puts ab on the stack, unless it (in either direction) is there. */
void edge_stack_push(edge_stack *L, halfedge_id ab);

/* Takes the last edge into *ab; false when there is none, or when the observer
 * wants to stop. */
bool edge_stack_pop(edge_stack *L, halfedge_id *ab);

/* Puts every edge of K on the stack that two triangles share. */
void push_all_edges(edge_stack *L);

/* Line 5 of Figure 10: puts the four edges around the flipped edge on the stack. */
void push_link(edge_stack *L, halfedge_id cd);

/* Figure 10: flips until no edge on the stack, nor any that a flip puts there, is
 * not locally Delaunay.
 *
 * If every edge of *L->m that is not locally Delaunay is on the stack, then *L->m is
 * Delaunay afterwards (Theorem 3).
 * Cost: at most C(u,2) flips; at most one incircle test for each edge taken from the
 * stack.
 */
void lawson_flip(edge_stack *L, const point2 *points);

/* A Delaunay triangulation: Figure 3, then Figure 10 on all of its edges.
 * Statuses and conventions: lib/options.h. Cost: O(n^2). */
tri_status lawson_triangulate(const point2 *points, uint32_t n,
                              const tri_options *options, mesh *out);

/* Is the list a Delaunay triangulation of the points (each location used once)?
 *
 * Holds exactly when is_triangulation (2.1) does and no two neighbours abc, abd
 * have d strictly inside the circle of abc (Theorem 3: that is enough).
 * Refuted: the four points a, b, c, d, or the witness of is_triangulation.
 * Cost: O(n + triangles); that of is_triangulation, and an incircle test an inner
 * edge. TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS (as there): *out says nothing.
 */
tri_status is_delaunay(const point2 *points, uint32_t n, triangle_list list,
                       verdict *out);

/* Which line of Figure 10 is run in each step. */
extern const figure_steps lawson_steps;

#endif
