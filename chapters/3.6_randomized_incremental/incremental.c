/* incremental.c - Figure 12 of the notes: IncrementalFlip. */
#include "chapters/3.6_randomized_incremental/incremental.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* ---- Definition 9 with a vertex at infinity. ---- */

bool
circle_contains(const point2 *points, vertex_id a, vertex_id b, vertex_id c,
                vertex_id q)
{
    if (a == GHOST)
        return orient2d(points[b], points[c], points[q]) > 0;
    if (b == GHOST)
        return orient2d(points[c], points[a], points[q]) > 0;
    if (c == GHOST)
        return orient2d(points[a], points[b], points[q]) > 0;
    return incircle(points[a], points[b], points[c], points[q]) > 0;
}

/* No circle contains the point at infinity, so ab is right if that is opposite. */
bool
is_locally_delaunay_at_infinity(const mesh *m, const point2 *points, halfedge_id ab)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, mesh_twin(m, ab));
    if (c == GHOST || d == GHOST)
        return true;
    return !circle_contains(points, b, a, d, c);
}

/* ---- Line 4: the split. ---- */

static void
split_triangle(mesh *m, halfedge_id ab, vertex_id p)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab), c = mesh_apex(m, ab);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), ac = mesh_twin(m, mesh_prev(ab));

    mesh_set_triangle(m, ab, a, b, p);
    halfedge_id bc = mesh_add_triangle(m, b, c, p);
    halfedge_id ca = mesh_add_triangle(m, c, a, p);
    mesh_link(m, bc, cb);
    mesh_link(m, ca, ac);
    mesh_link(m, mesh_next(ab), mesh_prev(bc)); /* bp and pb */
    mesh_link(m, mesh_next(bc), mesh_prev(ca)); /* cp and pc */
    mesh_link(m, mesh_next(ca), mesh_prev(ab)); /* ap and pa */
}

static void
split_edge(mesh *m, halfedge_id ab, vertex_id p)
{
    halfedge_id ba = mesh_twin(m, ab);
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), da = mesh_twin(m, mesh_next(ba));

    halfedge_id ap = ab, bp = ba;
    mesh_set_triangle(m, ap, a, p, c);
    mesh_set_triangle(m, bp, b, p, d);
    halfedge_id pb = mesh_add_triangle(m, p, b, c);
    halfedge_id pa = mesh_add_triangle(m, p, a, d);
    mesh_link(m, ap, pa);
    mesh_link(m, bp, pb);
    mesh_link(m, mesh_next(pb), cb);
    mesh_link(m, mesh_next(pa), da);
    mesh_link(m, mesh_next(ap), mesh_prev(pb)); /* pc and cp */
    mesh_link(m, mesh_next(bp), mesh_prev(pa)); /* pd and dp */
}

void
split(mesh *m, place at, vertex_id p)
{
    switch (at.kind) {
    case PLACE_TRIANGLE:
        split_triangle(m, at.e, p);
        break;
    case PLACE_EDGE:
        split_edge(m, at.e, p);
        break;
    case PLACE_BEYOND:
        mesh_hull_join(m, at.e, at.e, p);
        break;
    }
    trace_report(m, (trace_event){TRACE_SPLIT, mesh_leaving(m, p), p, NONE, NONE,
                                  NONE});
}

/* ---- Lines 5 and 6: around the new vertex. ---- */

/* The edges opposite p: three after a split, four if p was put on an edge. */
static void
push_link_of(edge_stack *L, vertex_id p)
{
    halfedge_id first = mesh_leaving(L->m, p), e = first;
    do {
        edge_stack_push(L, mesh_next(e));
        e = mesh_around(L->m, e);
    } while (e != first);
}

/* Figure 10, when all edges on the stack are opposite the same new vertex p: each entry
 * ab has p for its apex. Then ab becomes dp, and of the four edges around it ad and db
 * are opposite p. The other two end at p and need no look (page 3.6, fig12.P3). */
static void
lawson_flip_around(edge_stack *L, const point2 *points, locator *T)
{
    mesh *D = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {
        if (is_locally_delaunay_at_infinity(D, points, ab))
            continue;
        flip(D, ab);
        locator_flip(T, ab);
        edge_stack_push(L, mesh_prev(ab));               /* ad */
        edge_stack_push(L, mesh_next(mesh_twin(D, ab))); /* db */
    }
}

/* ---- Figure 12. ---- */

/* Lines 2 to 7, with T and L to work with. Two points are there already: line 1. */
static void
insert_all(mesh *D, const point2 *points, const vertex_id *order, locator *T,
           edge_stack *L)
{
    for (uint32_t i = 2; i < D->locations; i++) {   // Line 2
        if (D->cancelled || T->status != TRI_OK)
            return;
        vertex_id p = order[i];
        place tau = locate(T, p);                   // Line 3
        split(D, tau, p);                           // Line 4
        locator_split(T, tau, p);
        push_link_of(L, p);                         // Line 5
        lawson_flip_around(L, points, T);           // Line 6
    }                                               // Line 7
}

/* Line 8 removes nothing: mesh_triangles leaves out what ends at infinity. */
static tri_status
incremental_flip(mesh *D, const point2 *points, const vertex_id *order,
                 tri_locator kind)
{
    if (D->locations < 2)
        return TRI_OK;
    start(D, order[0], order[1]);                   // Line 1: it stands for xyz.
    edge_stack L = {0};
    locator T;
    tri_status status = locator_init(&T, kind, D, points, order);
    if (status == TRI_OK)
        status = edge_stack_init(&L, D);
    if (status == TRI_OK) {
        insert_all(D, points, order, &T, &L);
        status = T.status;
    }
    edge_stack_free(&L);
    locator_free(&T);
    return status;
}

tri_status
insert_in_order(const point2 *points, uint32_t n, const vertex_id *order,
                uint32_t count, const tri_options *options, mesh *out)
{
    tri_status status = mesh_init(out, n, count);
    if (status != TRI_OK)
        return status;
    out->trace = options->trace;
    return mesh_finish(out, incremental_flip(out, points, order, options->locator));
}

/* ---- The order. ---- */

void
shuffle(vertex_id *L, uint32_t count, random_source *random)
{
    for (uint32_t i = count; i > 1; i--) { /* L[i-1] will be one of the first i */
        uint32_t j = random_below(random, i);
        vertex_id chosen = L[j];
        L[j] = L[i - 1];
        L[i - 1] = chosen;
    }
}

/* Puts L[0 .. count-1] into the given order, in which there may be others, too.
 * TRI_BAD_OPTION if that is not a permutation of 0 .. n-1. */
static tri_status
order_as_given(const vertex_id *given, uint32_t n, vertex_id *L, uint32_t count)
{
    bool *seen = memory_array(n, 2 * sizeof *seen);
    if (seen == NULL)
        return TRI_OUT_OF_MEMORY;
    bool *wanted = seen + n;
    for (vertex_id v = 0; v < n; v++)
        seen[v] = wanted[v] = false;
    for (uint32_t i = 0; i < count; i++)
        wanted[L[i]] = true;
    tri_status status = TRI_OK;
    uint32_t k = 0;
    for (uint32_t i = 0; i < n && status == TRI_OK; i++) {
        if (given[i] >= n || seen[given[i]]) {
            status = TRI_BAD_OPTION;
        } else {
            seen[given[i]] = true;
            if (wanted[given[i]])
                L[k++] = given[i];
        }
    }
    memory_free(seen);
    return status;
}

tri_status
incremental_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                        mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    vertex_id *L = memory_array(n, sizeof *L);
    if (L == NULL)
        return TRI_OUT_OF_MEMORY;

    uint32_t locations;
    status = sort_along(points, n, (point2){1, 0}, L, &locations);
    if (status == TRI_OK) {
        random_source random = random_from_seed(used.seed);
        if (used.order == NULL)
            shuffle(L, locations, &random);
        else
            status = order_as_given(used.order, n, L, locations);
    }
    if (status == TRI_OK)
        status = insert_in_order(points, n, L, locations, &used, out);
    memory_free(L);
    return status;
}
