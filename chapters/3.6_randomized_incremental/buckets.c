/* buckets.c - the points that wait, triangle by triangle. */
#include "chapters/3.6_randomized_incremental/buckets.h"

#include "lib/memory.h"
#include "lib/trace.h"

/* ---- One bucket is a list. ---- */

static void
put(buckets *b, triangle_id t, vertex_id q)
{
    b->next[q] = b->first[t];
    b->first[t] = q;
    b->home[q] = t;
}

/* Empties bucket t; returns its list. */
static vertex_id
take_all(buckets *b, triangle_id t)
{
    vertex_id list = b->first[t];
    b->first[t] = NONE;
    return list;
}

/* ---- What happens when triangles are replaced. ---- */

/* q goes to the triangle of e, unless it has become a vertex. */
static void
move(buckets *b, vertex_id q, halfedge_id e)
{
    if (mesh_leaving(b->m, q) != NONE)
        return;
    put(b, mesh_triangle_of(e), q);
    trace_report(b->m, (trace_event){TRACE_MOVE, e, q, NONE, NONE, NONE});
}

void
buckets_share(buckets *b, halfedge_id e)
{
    if (mesh_origin(b->m, e) == GHOST)
        e = mesh_twin(b->m, e);
    halfedge_id f = mesh_twin(b->m, e);
    vertex_id s = mesh_origin(b->m, e), w = mesh_dest(b->m, e);
    vertex_id right = mesh_apex(b->m, f);

    vertex_id list[2] = {take_all(b, mesh_triangle_of(e)),
                         take_all(b, mesh_triangle_of(f))};
    for (int i = 0; i < 2; i++) {
        vertex_id next;
        for (vertex_id q = list[i]; q != NONE; q = next) {
            next = b->next[q];
            move(b, q, goes_left(b->points, b->o, s, w, right, q) ? e : f);
        }
    }
}

/* Two of the three triangles are new and have empty buckets. */
void
buckets_share_three(buckets *b, halfedge_id e)
{
    halfedge_id leaving[3];
    vertex_id ray[3], list[3], next;
    for (int i = 0; i < 3; i++) {
        leaving[i] = e;
        ray[i] = mesh_dest(b->m, e);
        list[i] = take_all(b, mesh_triangle_of(e));
        e = mesh_around(b->m, e);
    }
    vertex_id s = mesh_origin(b->m, e);
    for (int i = 0; i < 3; i++) {
        for (vertex_id q = list[i]; q != NONE; q = next) {
            next = b->next[q];
            move(b, q, leaving[q != s ? goes_between(b->points, b->o, s, ray, q) : 0]);
        }
    }
}

triangle_id
buckets_find(const buckets *b, vertex_id p)
{
    return b->home[p];
}

/* ---- Beginning and end. ---- */

tri_status
buckets_init(buckets *b, mesh *m, const point2 *points, const vertex_id *order)
{
    *b = (buckets){m, points, order[0], NULL, NULL, NULL};
    uint32_t triangles = mesh_room(m) / 3;
    b->first = memory_array(triangles, sizeof *b->first);
    b->next = memory_array(m->points, sizeof *b->next);
    b->home = memory_array(m->points, sizeof *b->home);
    if (b->first == NULL || b->next == NULL || b->home == NULL) {
        buckets_free(b);
        return TRI_OUT_OF_MEMORY;
    }
    for (triangle_id t = 0; t < triangles; t++)
        b->first[t] = NONE;
    halfedge_id ab = 0; /* the first half-edge ever made */
    for (uint32_t i = 2; i < m->locations; i++)
        put(b, mesh_triangle_of(ab), order[i]);
    buckets_share(b, ab);
    return TRI_OK;
}

void
buckets_free(buckets *b)
{
    memory_free(b->first);
    memory_free(b->next);
    memory_free(b->home);
    *b = (buckets){0};
}
