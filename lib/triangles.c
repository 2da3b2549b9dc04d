/* triangles.c - which triangles of a list are neighbours. */
#include "lib/triangles.h"

#include "lib/memory.h"
#include "lib/sort.h"

#include <stddef.h>

void
triangle_list_free(triangle_list *list)
{
    memory_free(list->corner);
    *list = (triangle_list){0};
}

/* The edge of side e, the same for both directions. */
static uint64_t
edge_key(triangle_list list, halfedge_id e)
{
    vertex_id a = side_origin(list, e), b = side_dest(list, e);
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

/* Of the sides along one edge, pairs those with opposite directions. */
static void
pair_sides(triangle_list list, const sort_item *side, size_t sides, halfedge_id *twin,
           halfedge_id *repeated)
{
    for (size_t i = 0; i < sides; i++) {
        halfedge_id e = side[i].id;
        for (size_t j = 0; j < i; j++) {
            halfedge_id f = side[j].id;
            if (side_origin(list, f) == side_origin(list, e)) {
                *repeated = e;
                return;
            }
            twin[e] = f;
            twin[f] = e;
        }
    }
}

tri_status
triangle_list_twins(triangle_list list, halfedge_id *twin, halfedge_id *repeated)
{
    *repeated = NONE;
    if (list.count > (NONE - 1) / 3)
        return TRI_TOO_MANY_POINTS;
    halfedge_id sides = 3 * list.count;
    sort_item *item = memory_array(sides, 2 * sizeof *item);
    if (item == NULL)
        return TRI_OUT_OF_MEMORY;
    for (halfedge_id e = 0; e < sides; e++) {
        item[e] = (sort_item){edge_key(list, e), e};
        twin[e] = NONE;
    }
    sort_by_key(item, item + sides, sides);
    for (size_t lo = 0, hi; lo < sides && *repeated == NONE; lo = hi) {
        for (hi = lo; hi < sides && item[hi].key == item[lo].key; hi++) {
        }
        pair_sides(list, item + lo, hi - lo, twin, repeated);
    }
    memory_free(item);
    return TRI_OK;
}
