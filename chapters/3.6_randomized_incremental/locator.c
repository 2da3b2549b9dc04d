/* locator.c - walk, buckets, history or grid: whom to ask and whom to tell. */
#include "chapters/3.6_randomized_incremental/locator.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/trace.h"

#include <assert.h>

/* The two ends of the first edge have come already. */
static tri_status
grid_begin(bucket_grid *g, const point2 *points, const vertex_id *order, uint32_t count)
{
    tri_status status = bucket_grid_init(g, points, order, count);
    if (status != TRI_OK)
        return status;
    bucket_grid_add(g);
    bucket_grid_add(g);
    return TRI_OK;
}

tri_status
locator_init(locator *T, tri_locator kind, mesh *m, const point2 *points,
             const vertex_id *order)
{
    *T = (locator){.kind = kind, .m = m, .points = points, .last = order[0]};
    if (kind == TRI_LOCATOR_BUCKETS)
        T->status = buckets_init(&T->waiting, m, points, order);
    else if (kind == TRI_LOCATOR_HISTORY)
        T->status = history_init(&T->past, m, points, order);
    else if (kind == TRI_LOCATOR_GRID)
        T->status = grid_begin(&T->near, points, order, m->locations);
    return T->status;
}

void
locator_free(locator *T)
{
    buckets_free(&T->waiting);
    history_free(&T->past);
    bucket_grid_free(&T->near);
    *T = (locator){0};
}

/* ---- Asking. ---- */

/* The place of p, which waits with the ghost triangle of hull edge xy: it sees xy,
 * or is in line with it, and then lies on it, or beyond an end (buckets.P1). */
static place
place_outside(const mesh *m, const point2 *points, halfedge_id xy, point2 p)
{
    if (lies_beyond(m, points, xy, p))
        return (place){PLACE_TRIANGLE, mesh_twin(m, xy)};
    point2 x = points[mesh_origin(m, xy)], y = points[mesh_dest(m, xy)];
    bool beyond_x = !is_same_side(x, y, p), beyond_y = !is_same_side(y, x, p);
    if (!beyond_x && !beyond_y)
        return (place){PLACE_EDGE, xy};
    halfedge_id e = beyond_y ? mesh_hull_next(m, xy) : mesh_hull_prev(m, xy);
    if (e == mesh_twin(m, xy)) /* the path ends here */
        return (place){PLACE_BEYOND, beyond_y ? e : xy};
    return (place){PLACE_TRIANGLE, mesh_twin(m, e)};
}

static place
place_in(const mesh *m, const point2 *points, triangle_id t, point2 p)
{
    halfedge_id e = 3 * t;
    if (mesh_in_triangle(m, e))
        return place_in_triangle(m, points, e, p);
    return place_outside(m, points, hull_edge_of(m, e), p);
}

static place
find(locator *T, vertex_id p)
{
    point2 at = T->points[p];
    switch (T->kind) {
    case TRI_LOCATOR_BUCKETS:
        return place_in(T->m, T->points, buckets_find(&T->waiting, p), at);
    case TRI_LOCATOR_HISTORY:
        return place_in(T->m, T->points, history_find(&T->past, p), at);
    case TRI_LOCATOR_GRID:
        return straight_walk(T->m, T->points, bucket_grid_near(&T->near, at), at);
    case TRI_LOCATOR_WALK:
        break;
    }
    return straight_walk(T->m, T->points, T->last, at);
}

place
locate(locator *T, vertex_id p)
{
    assert(T->status == TRI_OK);
    place at = find(T, p);
    T->last = p;
    trace_report(T->m, (trace_event){TRACE_LOCATE, at.e, p, NONE, NONE, NONE});
    return at;
}

/* ---- Telling. ---- */

/* The triangles on both sides of e have taken the place of others. */
static void
share(locator *T, halfedge_id e)
{
    if (T->kind == TRI_LOCATOR_BUCKETS)
        buckets_share(&T->waiting, e);
    else if (T->kind == TRI_LOCATOR_HISTORY && T->status == TRI_OK)
        T->status = history_share(&T->past, e);
}

static void
share_three(locator *T, halfedge_id e)
{
    if (T->kind == TRI_LOCATOR_BUCKETS)
        buckets_share_three(&T->waiting, e);
    else if (T->kind == TRI_LOCATOR_HISTORY && T->status == TRI_OK)
        T->status = history_share_three(&T->past, e);
}

/* Points beyond the end of a hull edge, in line with it, have waited with it; if p
 * has prolonged that line, they belong to what is behind p's edge now. */
static void
share_in_line(locator *T, vertex_id p)
{
    const mesh *m = T->m;
    halfedge_id first = mesh_leaving(m, p), e = first;
    do {
        halfedge_id link = mesh_next(e);
        if (mesh_origin(m, link) == GHOST || mesh_dest(m, link) == GHOST) {
            halfedge_id xy = hull_edge_of(m, mesh_twin(m, link));
            if (orient2d(T->points[mesh_origin(m, xy)], T->points[mesh_dest(m, xy)],
                         T->points[p]) == 0)
                share(T, link);
        }
        e = mesh_around(m, e);
    } while (e != first);
}

void
locator_split(locator *T, place at, vertex_id p)
{
    if (T->kind == TRI_LOCATOR_GRID)
        bucket_grid_add(&T->near);
    if (T->kind != TRI_LOCATOR_BUCKETS && T->kind != TRI_LOCATOR_HISTORY)
        return;
    switch (at.kind) {
    case PLACE_TRIANGLE: /* e, from a to b, has p for its apex now */
        share_three(T, mesh_prev(at.e));
        share_in_line(T, p);
        break;
    case PLACE_EDGE: /* e leads from a to p now */
        share(T, mesh_next(at.e));
        share(T, mesh_around(T->m, mesh_twin(T->m, at.e)));
        break;
    case PLACE_BEYOND:
        share_in_line(T, p);
        break;
    }
}

void
locator_flip(locator *T, halfedge_id e)
{
    share(T, e);
}
