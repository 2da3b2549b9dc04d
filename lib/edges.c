/* edges.c - lists of edges. */
#include "lib/edges.h"

#include "lib/memory.h"
#include "lib/sort.h"

#include <stddef.h>

void
edge_list_free(edge_list *list)
{
    memory_free(list->ends);
    *list = (edge_list){0};
}

/* Of the two half-edges along an edge of *m, is e the one that names it? That
 * is the one towards the higher index; GHOST, the highest, is no end of an
 * edge. */
static bool
names_an_edge(const mesh *m, halfedge_id e)
{
    return mesh_origin(m, e) < mesh_dest(m, e) && mesh_dest(m, e) != GHOST;
}

tri_status
mesh_edges(const mesh *m, const bool *chosen, edge_list *out)
{
    *out = (edge_list){0};
    size_t most = mesh_halfedges(m) / 2;
    sort_item *item = memory_array(most, 2 * sizeof *item);
    if (item == NULL)
        return TRI_OUT_OF_MEMORY;
    uint32_t count = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (!names_an_edge(m, e))
            continue;
        if (chosen == NULL || chosen[e] || chosen[mesh_twin(m, e)])
            item[count++].key =
                (uint64_t)mesh_origin(m, e) << 32 | mesh_dest(m, e);
    }
    sort_by_key(item, item + most, count);
    out->ends = memory_array(count, sizeof *out->ends);
    for (uint32_t i = 0; i < count && out->ends != NULL; i++) {
        out->ends[i][0] = (vertex_id)(item[i].key >> 32);
        out->ends[i][1] = (vertex_id)(item[i].key & UINT32_MAX);
    }
    memory_free(item);
    if (out->ends == NULL)
        return TRI_OUT_OF_MEMORY;
    out->count = count;
    return TRI_OK;
}
