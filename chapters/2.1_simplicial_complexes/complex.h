/* complex.h - simplices, their faces, complexes, and what a triangulation is.
 *
 * Notes: section 2.1, Definitions 1 to 4. Needs: 3.4 (which side of a line a point
 * lies on), lib/mesh.h, lib/verdict.h. Exercises: 2.1-a to 2.1-c.
 */
#ifndef CHAPTERS_2_1_COMPLEX_H
#define CHAPTERS_2_1_COMPLEX_H

#include "lib/triangles.h"
#include "lib/verdict.h"

/* A k-simplex as the set of its vertices (Definition 1). The dimension is -1 for
 * the empty face, and at most 3: faces are counted in space too. */
typedef struct simplex {
    int dimension;
    vertex_id vertex[4]; /* dimension + 1 of them, in increasing order */
} simplex;

typedef struct simplex_list {
    uint32_t count;
    struct simplex *simplex;
} simplex_list;

/* ---- Definitions 1 and 2: simplices and faces. ---- */

/* Is a set of k+1 points, k <= 2, affinely independent?
 *
 *   k = -1, 0  always        k = 1  the two differ        k = 2  not collinear
 *
 * Source: notes 2.1; it is an equivalence: docs/errata.md, E1.
 */
bool is_affinely_independent(const point2 *points, simplex s);

/* An affine basis of n points: affinely independent ones whose affine space, the
 * smallest, holds all. Each is the first that is not in the space of those before.
 * Cost: at most n orientation tests. Source: notes 2.1. */
simplex affine_basis(const point2 *points, uint32_t n);

/* The dimension of that space: -1 for no point, 0 for one location, 1 for collinear
 * points, else 2. */
int affine_dimension(const point2 *points, uint32_t n);

/* All faces of s, the empty one and s itself included; returns 2^(k+1), how many
 * there are. Requires: room for them (16 always suffice).
 * Source: notes 2.1, Definition 2 and the exercise below it. */
uint32_t simplex_faces(simplex s, simplex *face);

/* Is tau a face of sigma: are tau's vertices among sigma's? */
bool simplex_is_face(simplex tau, simplex sigma);

/* ---- Definition 3: simplicial complexes. ---- */

/* The smallest set that contains the listed simplices and their faces, each once;
 * the empty face is left out, as it belongs to every complex.
 * Cost: O(m^2). TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status simplex_closure(simplex_list list, simplex_list *out);

/* Frees the array and zeroes *list; a zeroed list is accepted. */
void simplex_list_free(simplex_list *list);

/* The largest dimension in the list; -1 when it is empty. */
int complex_dimension(simplex_list list);

/* Does some listed simplex contain x: is x in the underlying space |K|?
 *
 * Then *carrier is a face of a listed simplex that has x in its interior: of a complex
 * the only one (page 2.1, def3.P2).
 * Requires: each listed simplex is affinely independent. */
bool underlying_space_contains(const point2 *points, simplex_list list, point2 x,
                               simplex *carrier);

/* Is the list a simplicial complex in the plane (Definition 3)?
 *
 * It holds exactly when the simplices have distinct vertices below n and are
 * affinely independent, none is listed twice, each non-empty face is listed, no
 * two vertices coincide, no vertex lies inside an edge or a triangle, and no two
 * edges cross (page 2.1, def3.P1: that is enough).
 * Refuted: the vertices to look at. Cost: O(m^2) for m simplices.
 * Source: notes 2.1; "a face of both" for "in K": docs/errata.md, E2.
 */
verdict is_complex(const point2 *points, uint32_t n, simplex_list list);

/* ---- Definition 4: triangulations. ---- */

/* Is the list a triangulation of the n points that uses each location once?
 *
 * It holds exactly when
 *   1. at each location one index is a corner of some triangle and the others are not;
 *   2. each triangle is counterclockwise;
 *   3. each directed edge belongs to at most one triangle;
 *   4. the edges without a twin make one cycle that nowhere turns right or back,
 *      with one lexicographic maximum
 * (page 2.1, def4.P1 to def4.P4: that is enough). Collinear points have the empty
 * list and no other: docs/errata.md, E3.
 * Refuted: the vertices to look at. Cost: O(n + triangles); at most one orientation
 * test a triangle and a hull edge, 2 comparisons a point and 4 a hull edge; for the
 * empty list, one test a point. TRI_OUT_OF_MEMORY, TRI_TOO_MANY_POINTS (see
 * triangle_list_twins): *out says nothing.
 */
tri_status is_triangulation(const point2 *points, uint32_t n, triangle_list list,
                            verdict *out);

/* The same, for those who go on from triangle to triangle: if it holds, *twin is what
 * triangle_list_twins says of the list. The caller frees it by memory_free, whatever
 * the answer is. */
tri_status is_triangulation_with_twins(const point2 *points, uint32_t n,
                                       triangle_list list, verdict *out,
                                       halfedge_id **twin);

#endif
