/* triangulation.c - Definition 4 of the notes, certified.
 *
 * The four conditions of is_triangulation, one function each; the page proves
 * that together they are Definition 4.
 */
#include "chapters/2.1_simplicial_complexes/complex.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/sort.h"

static const point2 lexicographic = {1, 0};

/* What the four conditions look at, and what they find on the way. */
typedef struct audit {
    const point2 *points;
    uint32_t n;
    triangle_list list;
    bool *used;           /* vertex -> is it a corner of some triangle? */
    sort_item *item;      /* room to sort the points: 2n items */
    halfedge_id *twin;    /* side -> the same edge the other way, or NONE */
    halfedge_id repeated; /* a side that runs along another one, or NONE */
    vertex_id *next;      /* vertex -> the next one on the boundary, or NONE */
} audit;

/* ---- Condition 2: each triangle is counterclockwise. ---- */

static verdict
check_triangles(const audit *a)
{
    for (uint32_t t = 0; t < a->list.count; t++) {
        const vertex_id *c = a->list.corner[t];
        for (int i = 0; i < 3; i++)
            if (c[i] >= a->n)
                return verdict_refuted("triangle %u of %u has vertex %u of %u",
                                       (unsigned)t, (unsigned)a->list.count,
                                       (unsigned)c[i], (unsigned)a->n);
        if (orient2d(a->points[c[0]], a->points[c[1]], a->points[c[2]]) <= 0) {
            verdict v = verdict_refuted("triangle %u of %u is not counterclockwise",
                                        (unsigned)t, (unsigned)a->list.count);
            return verdict_with(verdict_with(verdict_with(v, c[0]), c[1]), c[2]);
        }
        a->used[c[0]] = a->used[c[1]] = a->used[c[2]] = true;
    }
    return verdict_holds();
}

/* ---- Condition 1: at each location one index is a corner. ---- */

/* Sorts all indices by location: by y, and then, keeping that order, by x. */
static void
sort_locations(const audit *a)
{
    for (uint32_t v = 0; v < a->n; v++)
        a->item[v] = (sort_item){sort_key_of(a->points[v].y), v};
    sort_by_key(a->item, a->item + a->n, a->n);
    for (uint32_t i = 0; i < a->n; i++)
        a->item[i].key = sort_key_of(a->points[a->item[i].id].x);
    sort_by_key(a->item, a->item + a->n, a->n);
}

static verdict
check_locations(const audit *a)
{
    sort_locations(a);
    for (uint32_t i = 0; i < a->n;) {
        vertex_id first = a->item[i].id, corner = NONE;
        for (; i < a->n; i++) {
            vertex_id v = a->item[i].id;
            if (compare_along(lexicographic, a->points[first], a->points[v]) != 0)
                break;
            if (a->used[v] && corner != NONE)
                return verdict_with(verdict_with(verdict_refuted(
                    "vertices %u and %u are the same point", (unsigned)corner,
                    (unsigned)v), corner), v);
            if (a->used[v])
                corner = v;
        }
        if (corner == NONE)
            return verdict_with(verdict_refuted("point %u is no vertex of any triangle",
                                                (unsigned)first), first);
    }
    return verdict_holds();
}

/* ---- Condition 3: each directed edge belongs to at most one triangle. ---- */

/* Leaves in next[] the edges without a twin, vertex -> the next on the boundary, and
 * counts them. */
static verdict
check_edges(const audit *a, uint32_t *boundary)
{
    triangle_list list = a->list;
    if (a->repeated != NONE) {
        vertex_id u = side_origin(list, a->repeated), w = side_dest(list, a->repeated);
        verdict v = verdict_refuted("two triangles lie on the left of the edge from %u "
                                    "to %u", (unsigned)u, (unsigned)w);
        return verdict_with(verdict_with(v, u), w);
    }
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        vertex_id u = side_origin(list, e);
        if (a->twin[e] != NONE)
            continue;
        if (a->next[u] != NONE)
            return verdict_with(verdict_refuted("the boundary passes through vertex %u "
                                "more than once", (unsigned)u), u);
        a->next[u] = side_dest(list, e);
        ++*boundary;
    }
    return verdict_holds();
}

/* ---- Condition 4: the boundary is a convex polygon, run through once. ---- */

/* Does the boundary go on to the left or straight ahead at v? */
static verdict
check_turn(const audit *a, vertex_id u, vertex_id v, vertex_id w)
{
    point2 p = a->points[u], q = a->points[v], r = a->points[w];
    int turn = orient2d(p, q, r);
    bool back = turn == 0 && compare_along(lexicographic, p, q) !=
                             compare_along(lexicographic, q, r);
    if (turn > 0 || (turn == 0 && !back))
        return verdict_holds();
    verdict refuted = verdict_refuted(
        "the boundary turns %s at vertex %u, from %u to %u: it is not the convex hull",
        back ? "back" : "right", (unsigned)v, (unsigned)u, (unsigned)w);
    return verdict_with(verdict_with(verdict_with(refuted, v), u), w);
}

/* There is a boundary, as the triangles have positive areas; and it goes on at each of
 * its vertices, as each triangle has one side into and one side out of each of its
 * corners, and twins cancel in pairs. */
static verdict
check_boundary(const audit *a, uint32_t boundary)
{
    uint32_t length = 0, maxima = 0;
    vertex_id start = 0;
    while (a->next[start] == NONE)
        start++;
    vertex_id u = start;
    do {
        vertex_id v = a->next[u], w = a->next[v];
        verdict turn = check_turn(a, u, v, w);
        if (!turn.holds)
            return turn;
        if (compare_along(lexicographic, a->points[u], a->points[v]) < 0 &&
            compare_along(lexicographic, a->points[w], a->points[v]) < 0)
            maxima++;
        length++;
        u = v;
    } while (u != start);
    if (length != boundary)
        return verdict_with(
            verdict_refuted("the boundary is more than one cycle: %u of its %u edges "
                            "are reached from vertex %u", (unsigned)length,
                            (unsigned)boundary, (unsigned)start), start);
    if (maxima != 1)
        return verdict_with(verdict_refuted("the boundary runs %u times around",
                                            (unsigned)maxima), start);
    return verdict_holds();
}

/* ---- Definition 4. ---- */

static verdict
check_all(const audit *a)
{
    if (a->list.count == 0) {
        simplex s = affine_basis(a->points, a->n);
        if (s.dimension < 2)
            return verdict_holds();
        const vertex_id *c = s.vertex;
        verdict v = verdict_refuted("there is no triangle, and the points %u, %u and "
                                    "%u are not collinear", (unsigned)c[0],
                                    (unsigned)c[1], (unsigned)c[2]);
        return verdict_with(verdict_with(verdict_with(v, c[0]), c[1]), c[2]);
    }
    uint32_t boundary = 0;
    verdict v = check_triangles(a);
    if (v.holds)
        v = check_locations(a);
    if (v.holds)
        v = check_edges(a, &boundary);
    if (v.holds)
        v = check_boundary(a, boundary);
    return v;
}

tri_status
is_triangulation_with_twins(const point2 *points, uint32_t n, triangle_list list,
                            verdict *out, halfedge_id **twin)
{
    audit a = {.points = points, .n = n, .list = list};
    a.used = memory_array(n, sizeof *a.used);
    a.item = memory_array(n, 2 * sizeof *a.item);
    a.twin = memory_array(list.count, 3 * sizeof *a.twin);
    a.next = memory_array(n, sizeof *a.next);
    tri_status status = TRI_OUT_OF_MEMORY;
    if (a.used != NULL && a.item != NULL && a.twin != NULL && a.next != NULL)
        status = triangle_list_twins(list, a.twin, &a.repeated);
    if (status == TRI_OK) {
        for (vertex_id v = 0; v < n; v++) {
            a.used[v] = false;
            a.next[v] = NONE;
        }
        *out = check_all(&a);
    }
    memory_free(a.used);
    memory_free(a.item);
    memory_free(a.next);
    *twin = a.twin;
    return status;
}

tri_status
is_triangulation(const point2 *points, uint32_t n, triangle_list list, verdict *out)
{
    halfedge_id *twin;
    tri_status status = is_triangulation_with_twins(points, n, list, out, &twin);
    memory_free(twin);
    return status;
}
