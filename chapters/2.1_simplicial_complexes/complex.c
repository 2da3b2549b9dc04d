/* complex.c - Definitions 1 to 3 of the notes, as questions about lists of indices. */
#include "chapters/2.1_simplicial_complexes/complex.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

#include <assert.h>

static const point2 lexicographic = {1, 0};

/* Do p and q coincide? */
static bool
same_location(point2 p, point2 q)
{
    return compare_along(lexicographic, p, q) == 0;
}

/* ---- Definitions 1 and 2. ---- */

bool
is_affinely_independent(const point2 *points, simplex s)
{
    const vertex_id *v = s.vertex;
    assert(s.dimension <= 2);
    if (s.dimension == 1)
        return !same_location(points[v[0]], points[v[1]]);
    if (s.dimension == 2)
        return orient2d(points[v[0]], points[v[1]], points[v[2]]) != 0;
    return true;
}

simplex
affine_basis(const point2 *points, uint32_t n)
{
    simplex basis = {.dimension = -1};
    for (vertex_id v = 0; v < n && basis.dimension < 2; v++) {
        basis.vertex[++basis.dimension] = v;
        if (!is_affinely_independent(points, basis))
            basis.dimension--;
    }
    return basis;
}

int
affine_dimension(const point2 *points, uint32_t n)
{
    return affine_basis(points, n).dimension;
}

uint32_t
simplex_faces(simplex s, simplex *face)
{
    /* A face is a subset of the vertices; bit i of `subset` says whether vertex i
     * is in it. So there are 2^(k+1) of them, and sum C(k+1,i+1) is that too. */
    uint32_t count = 1u << (s.dimension + 1);
    for (uint32_t subset = 0; subset < count; subset++) {
        face[subset] = (simplex){.dimension = -1};
        for (int i = 0; i <= s.dimension; i++)
            if (subset >> i & 1)
                face[subset].vertex[++face[subset].dimension] = s.vertex[i];
    }
    return count;
}

static bool
has_vertex(simplex s, vertex_id v)
{
    for (int i = 0; i <= s.dimension; i++)
        if (s.vertex[i] == v)
            return true;
    return false;
}

bool
simplex_is_face(simplex tau, simplex sigma)
{
    for (int i = 0; i <= tau.dimension; i++)
        if (!has_vertex(sigma, tau.vertex[i]))
            return false;
    return true;
}

/* ---- Definition 3. ---- */

static bool
is_listed(simplex_list list, simplex s)
{
    for (uint32_t i = 0; i < list.count; i++)
        if (list.simplex[i].dimension == s.dimension &&
            simplex_is_face(s, list.simplex[i]))
            return true;
    return false;
}

tri_status
simplex_closure(simplex_list list, simplex_list *out)
{
    *out = (simplex_list){
        .simplex = memory_array(list.count, 16 * sizeof *out->simplex)};
    if (out->simplex == NULL)
        return TRI_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < list.count; i++) {
        simplex face[16];
        uint32_t faces = simplex_faces(list.simplex[i], face);
        for (uint32_t j = 1; j < faces; j++) /* 0 is the empty face */
            if (!is_listed(*out, face[j]))
                out->simplex[out->count++] = face[j];
    }
    return TRI_OK;
}

void
simplex_list_free(simplex_list *list)
{
    memory_free(list->simplex);
    *list = (simplex_list){0};
}

int
complex_dimension(simplex_list list)
{
    int dimension = -1;
    for (uint32_t i = 0; i < list.count; i++)
        if (list.simplex[i].dimension > dimension)
            dimension = list.simplex[i].dimension;
    return dimension;
}

/* Is x strictly between a and b, on the segment that joins them? */
static bool
inside_edge(point2 a, point2 b, point2 x)
{
    return orient2d(a, b, x) == 0 &&
           compare_along(lexicographic, a, x) * compare_along(lexicographic, x, b) > 0;
}

/* Is x in the interior of the triangle abc, which may turn either way but is not flat?
 * It is on no line of a side, then, for it cannot be on all three. */
static bool
inside_triangle(point2 a, point2 b, point2 c, point2 x)
{
    int side = orient2d(a, b, x);
    return orient2d(b, c, x) == side && orient2d(c, a, x) == side;
}

/* Is x in the interior of s (of a vertex: is it the vertex)? */
static bool
inside_simplex(const point2 *points, simplex s, point2 x)
{
    const vertex_id *v = s.vertex;
    if (s.dimension == 0)
        return same_location(points[v[0]], x);
    if (s.dimension == 1)
        return inside_edge(points[v[0]], points[v[1]], x);
    if (s.dimension == 2)
        return inside_triangle(points[v[0]], points[v[1]], points[v[2]], x);
    return false;
}

bool
underlying_space_contains(const point2 *points, simplex_list list, point2 x,
                          simplex *carrier)
{
    /* A closed simplex is the union of the interiors of its faces. */
    for (uint32_t i = 0; i < list.count; i++) {
        simplex face[16];
        uint32_t faces = simplex_faces(list.simplex[i], face);
        for (uint32_t j = 1; j < faces; j++) {
            *carrier = face[j];
            if (inside_simplex(points, *carrier, x))
                return true;
        }
    }
    return false;
}

/* Do ab and cd cross, in one point that is inside both? */
static bool
edges_cross(point2 a, point2 b, point2 c, point2 d)
{
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 &&
           orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

static verdict
with_vertices(verdict refuted, simplex s)
{
    for (int i = 0; i <= s.dimension; i++)
        refuted = verdict_with(refuted, s.vertex[i]);
    return refuted;
}

/* Is simplex i by itself a simplex of the plane, with its faces in the list? */
static verdict
check_simplex(const point2 *points, uint32_t n, simplex_list list, uint32_t i)
{
    simplex s = list.simplex[i];
    if (s.dimension < 0 || s.dimension > 2)
        return verdict_refuted("simplex %u has dimension %d", (unsigned)i, s.dimension);
    for (int j = 0; j <= s.dimension; j++) {
        if (s.vertex[j] >= n)
            return verdict_refuted("simplex %u has vertex %u of %u", (unsigned)i,
                                   (unsigned)s.vertex[j], (unsigned)n);
        if (j > 0 && s.vertex[j - 1] >= s.vertex[j])
            return with_vertices(verdict_refuted("the vertices of simplex %u do not "
                                 "increase", (unsigned)i), s);
    }
    if (!is_affinely_independent(points, s))
        return with_vertices(verdict_refuted("the vertices of simplex %u are not "
                             "affinely independent", (unsigned)i), s);
    simplex face[16];
    uint32_t faces = simplex_faces(s, face);
    for (uint32_t j = 1; j < faces; j++)
        if (!is_listed(list, face[j]))
            return with_vertices(
                verdict_refuted("a face of dimension %d of simplex %u is missing",
                                face[j].dimension, (unsigned)i), face[j]);
    return verdict_holds();
}

/* Do the simplices s and t meet only where Definition 3 lets them? Vertices and
 * edges are compared with everything, and that is enough (def3.P1). */
static verdict
check_pair(const point2 *points, simplex s, simplex t)
{
    if (s.dimension == t.dimension && simplex_is_face(s, t))
        return with_vertices(
            verdict_refuted("a simplex of dimension %d is listed twice", s.dimension),
            s);
    if (s.dimension == 0 && inside_simplex(points, t, points[s.vertex[0]]))
        return with_vertices(with_vertices(verdict_refuted("vertex %u lies inside a "
                             "simplex of dimension %d", (unsigned)s.vertex[0],
                             t.dimension), s), t);
    if (s.dimension == 1 && t.dimension == 1 &&
        edges_cross(points[s.vertex[0]], points[s.vertex[1]],
                    points[t.vertex[0]], points[t.vertex[1]]))
        return with_vertices(with_vertices(verdict_refuted("two edges cross"), s), t);
    return verdict_holds();
}

verdict
is_complex(const point2 *points, uint32_t n, simplex_list list)
{
    for (uint32_t i = 0; i < list.count; i++) {
        verdict v = check_simplex(points, n, list, i);
        if (!v.holds)
            return v;
    }
    for (uint32_t i = 0; i < list.count; i++) {
        for (uint32_t j = 0; j < list.count; j++) {
            if (i == j)
                continue;
            verdict v = check_pair(points, list.simplex[i], list.simplex[j]);
            if (!v.holds)
                return v;
        }
    }
    return verdict_holds();
}
