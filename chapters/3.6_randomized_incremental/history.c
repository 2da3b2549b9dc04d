/* history.c - the history graph. */
#include "chapters/3.6_randomized_incremental/history.h"

#include "lib/memory.h"
#include "lib/trace.h"

/* ---- Nodes. ---- */

/* Room for three more. Doubling, so that a node is copied twice on average. */
static tri_status
make_room(history *h)
{
    if (h->count + 3 <= h->room)
        return TRI_OK;
    if (h->room > UINT32_MAX / 2)
        return TRI_OUT_OF_MEMORY;
    uint32_t room = 2 * h->room;
    history_node *node = memory_resize(h->node, room, sizeof *node);
    if (node == NULL)
        return TRI_OUT_OF_MEMORY;
    h->node = node;
    h->room = room;
    return TRI_OK;
}

/* A node for triangle t of today. Requires: room. */
static uint32_t
add_leaf(history *h, triangle_id t)
{
    h->node[h->count] = (history_node){.children = 0, .child = {t, NONE, NONE}};
    h->today[t] = h->count;
    return h->count++;
}

/* ---- What happens when triangles are replaced. ---- */

tri_status
history_share(history *h, halfedge_id e)
{
    tri_status status = make_room(h);
    if (status != TRI_OK)
        return status;
    if (mesh_origin(h->m, e) == GHOST)
        e = mesh_twin(h->m, e);
    halfedge_id f = mesh_twin(h->m, e);
    triangle_id t[2] = {mesh_triangle_of(e), mesh_triangle_of(f)};
    uint32_t before[2] = {h->today[t[0]], h->today[t[1]]};

    history_node divided = {.children = 2, .at = mesh_origin(h->m, e),
                            .ray = {mesh_dest(h->m, e), mesh_apex(h->m, f), NONE}};
    for (int i = 0; i < 2; i++)
        divided.child[i] = add_leaf(h, t[i]);
    for (int i = 0; i < 2; i++)
        if (before[i] != NONE)
            h->node[before[i]] = divided;
    return TRI_OK;
}

/* Two of the three triangles are new and have no node yet. */
tri_status
history_share_three(history *h, halfedge_id e)
{
    tri_status status = make_room(h);
    if (status != TRI_OK)
        return status;
    history_node divided = {.children = 3, .at = mesh_origin(h->m, e)};
    uint32_t before = NONE;
    for (int i = 0; i < 3; i++) {
        triangle_id t = mesh_triangle_of(e);
        if (h->today[t] != NONE)
            before = h->today[t];
        divided.ray[i] = mesh_dest(h->m, e);
        divided.child[i] = add_leaf(h, t);
        e = mesh_around(h->m, e);
    }
    h->node[before] = divided;
    return TRI_OK;
}

/* ---- Looking up. ---- */

triangle_id
history_find(const history *h, vertex_id q)
{
    const history_node *node = &h->node[0];
    while (node->children > 0) {
        int i = node->children == 3
            ? goes_between(h->points, h->o, node->at, node->ray, q)
            : !goes_left(h->points, h->o, node->at, node->ray[0], node->ray[1], q);
        node = &h->node[node->child[i]];
        trace_report(h->m, (trace_event){TRACE_VISIT, NONE, q, NONE, NONE, NONE});
    }
    return node->child[0];
}

/* ---- Beginning and end. ---- */

tri_status
history_init(history *h, mesh *m, const point2 *points, const vertex_id *order)
{
    *h = (history){.m = m, .points = points, .o = order[0], .room = 16};
    uint32_t triangles = mesh_room(m) / 3;
    h->node = memory_array(h->room, sizeof *h->node);
    h->today = memory_array(triangles, sizeof *h->today);
    if (h->node == NULL || h->today == NULL) {
        history_free(h);
        return TRI_OUT_OF_MEMORY;
    }
    for (triangle_id t = 0; t < triangles; t++)
        h->today[t] = NONE;
    halfedge_id ab = 0; /* the first half-edge ever made */
    add_leaf(h, mesh_triangle_of(ab));
    return history_share(h, ab);
}

void
history_free(history *h)
{
    memory_free(h->node);
    memory_free(h->today);
    *h = (history){0};
}
