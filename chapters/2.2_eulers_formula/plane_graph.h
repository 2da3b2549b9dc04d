/* plane_graph.h - a graph drawn in the plane without crossings, and its dual.
 *
 * Notes: section 2.2. Needs: lib/mesh.h, 3.4 (to sort edges around a vertex).
 *
 * Edge k is kept as two half-edges, 2k and 2k+1, one in each direction. Of the
 * drawing only one thing is remembered: which half-edge comes next when one walks
 * along a face with the face on one's left.
 *
 *          w <---------- b            origin(h) = a      dest(h) = b
 *                       /^
 *       the face       / | h          At each vertex turn as far left as you can;
 *       left of h     /  |            at a dead end turn back:
 *                    c   a            next(ab) = bc, next(bc) = cb, next(cb) = bw
 *
 * Loops and parallel edges are allowed: the dual of a simple graph may have them.
 */
#ifndef CHAPTERS_2_2_PLANE_GRAPH_H
#define CHAPTERS_2_2_PLANE_GRAPH_H

#include "lib/mesh.h"

typedef uint32_t face_id;

typedef struct plane_graph {
    uint32_t vertices;    /* v: they are numbered 0 .. v-1 */
    uint32_t edges;       /* e: edge k has the half-edges 2k and 2k+1 */
    vertex_id *origin;    /* half-edge -> the vertex it leaves */
    halfedge_id *next;    /* half-edge -> the next one along the face on its left */
    halfedge_id *leaving; /* vertex -> a half-edge that leaves it, NONE if isolated */
    halfedge_id outside;  /* has the outer face on its left; NONE: not known */
} plane_graph;

/* The two ends of an edge. */
typedef struct edge_ends {
    vertex_id a, b;
} edge_ends;

/* The same edge in the other direction. */
static inline halfedge_id
graph_twin(halfedge_id h)
{
    return h ^ 1u;
}

/* The vertex that h enters. */
static inline vertex_id
graph_dest(const plane_graph *g, halfedge_id h)
{
    return g->origin[graph_twin(h)];
}

/* The next half-edge with the same origin, clockwise. Between the two lies the face
 * on the right of h, and its walk comes back to the origin along h's twin. */
static inline halfedge_id
graph_clockwise(const plane_graph *g, halfedge_id h)
{
    return g->next[graph_twin(h)];
}

/* ---- Where plane graphs come from. ---- */

/* The vertices and edges of a triangulation; vertex i of the graph is the i-th
 * location that the mesh uses. Its faces are the triangles and the outside.
 * Cost: O(n). TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status graph_from_mesh(const mesh *m, plane_graph *out);

/* The graph that is drawn with straight edges between some of n points.
 *
 * Requires: the drawing has no crossings, that is, the points and edges are a
 * simplicial complex (2.1). Other drawings, too, get the cyclic order of the edges
 * around each vertex right; but that is not the order of a plane graph.
 * Cost: O(n + e d) for vertices of degree at most d.
 * TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS (too many edges): *out is zeroed.
 */
tri_status graph_from_drawing(const point2 *points, uint32_t n, const edge_ends *edge,
                              uint32_t edges, plane_graph *out);

/* Frees the arrays and zeroes *g; a zeroed graph is accepted. */
void graph_free(plane_graph *g);

/* ---- Faces. ---- */

/* Walks once around every face and numbers the walks: left[h] is the walk that h
 * belongs to. An isolated vertex is a walk without half-edges, numbered last.
 *
 * In a connected graph the walks are the faces: returns f. Otherwise each component
 * has its own walk around the face that it shares with others (page 2.2, P1).
 * Requires: room for 2e entries in left. Cost: O(v+e). Source: notes 2.2, "faces".
 */
uint32_t graph_trace_faces(const plane_graph *g, face_id *left);

/* The dual graph G*: a vertex for each face of G, and for each half-edge h of G the
 * half-edge h of G*, which crosses it from the face on its left to the one on its
 * right. One dual edge for each edge, whether or not the two faces are distinct, or
 * adjacent already: docs/errata.md, E4.
 *
 * If G is not connected, *out holds the duals of its components side by side.
 * Cost: O(v+e). TRI_OUT_OF_MEMORY: *out is zeroed. Source: notes 2.2, proof of
 * Theorem 1.
 */
tri_status graph_dual(const plane_graph *g, plane_graph *out);

#endif
