/* mesh_build.c - a mesh from triangles or a path that are known already. */
#include "lib/mesh_build.h"

#include "lib/memory.h"

#include <stddef.h>

/* How many vertices occur in the list. TRI_OUT_OF_MEMORY: *used is 0. */
static tri_status
count_vertices(uint32_t n, triangle_list list, uint32_t *used)
{
    *used = 0;
    bool *seen = memory_array(n, sizeof *seen);
    if (seen == NULL)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id v = 0; v < n; v++)
        seen[v] = false;
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        vertex_id v = side_origin(list, e);
        assert(v < n);
        *used += !seen[v];
        seen[v] = true;
    }
    memory_free(seen);
    return TRI_OK;
}

/* Adds the triangles with the given neighbours, and one at GHOST for each side
 * that has none. The spokes of these are not linked yet. */
static void
add_triangles(mesh *m, triangle_list list, const halfedge_id *twin)
{
    for (uint32_t t = 0; t < list.count; t++)
        mesh_add_triangle(m, list.corner[t][0], list.corner[t][1],
                          list.corner[t][2]);
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        halfedge_id f = twin[e];
        if (f == NONE)
            f = mesh_add_triangle(m, side_dest(list, e), side_origin(list, e),
                                  GHOST);
        mesh_link(m, e, f);
    }
}

/* Links the spokes: at each hull vertex v one triangle at GHOST has the
 * half-edge from v to GHOST, and another one has its twin. */
static void
close_outside(mesh *m, halfedge_id first_outside)
{
    for (halfedge_id ba = first_outside; ba < mesh_halfedges(m); ba += 3) {
        halfedge_id a_ghost = mesh_next(ba);
        m->leaving[mesh_origin(m, a_ghost)] = a_ghost;
    }
    for (halfedge_id ba = first_outside; ba < mesh_halfedges(m); ba += 3)
        mesh_link(m, mesh_prev(ba), mesh_leaving(m, mesh_origin(m, ba)));
}

tri_status
mesh_from_triangles(uint32_t n, triangle_list list, mesh *out)
{
    assert(list.count > 0);
    *out = (mesh){0};
    halfedge_id *twin = memory_array(list.count, 3 * sizeof *twin);
    if (twin == NULL)
        return TRI_OUT_OF_MEMORY;
    halfedge_id repeated;
    uint32_t used = 0;
    tri_status status = triangle_list_twins(list, twin, &repeated);
    if (status == TRI_OK)
        status = count_vertices(n, list, &used);
    if (status == TRI_OK)
        status = mesh_init(out, n, used);
    if (status == TRI_OK) {
        assert(repeated == NONE);
        add_triangles(out, list, twin);
        close_outside(out, 3 * list.count);
        assert(out->triangles == 2 * used - 2);
    }
    memory_free(twin);
    return status;
}

tri_status
mesh_from_path(uint32_t n, const vertex_id *path, uint32_t count, mesh *out)
{
    tri_status status = mesh_init(out, n, count);
    if (status != TRI_OK || count < 2)
        return status;
    halfedge_id last = mesh_hull_next(out, mesh_start(out, path[0], path[1]));
    for (uint32_t i = 2; i < count; i++)
        last = mesh_hull_join(out, last, last, path[i]);
    return TRI_OK;
}
