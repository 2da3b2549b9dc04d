/* large_triangle.c - a triangle of finite size around everything. */
#include "chapters/3.6_randomized_incremental/large_triangle.h"

#include "lib/memory.h"

void
large_triangle(const point2 *points, uint32_t n, double k, point2 xyz[3])
{
    point2 least = points[0], most = points[0];
    for (uint32_t i = 1; i < n; i++) {
        least.x = points[i].x < least.x ? points[i].x : least.x;
        least.y = points[i].y < least.y ? points[i].y : least.y;
        most.x = points[i].x > most.x ? points[i].x : most.x;
        most.y = points[i].y > most.y ? points[i].y : most.y;
    }
    double width = most.x - least.x, height = most.y - least.y;
    double far = k * (width > height ? width : height);
    point2 middle = {least.x + width / 2, least.y + height / 2};
    xyz[0] = (point2){middle.x - far, middle.y - far};
    xyz[1] = (point2){middle.x + far, middle.y - far};
    xyz[2] = (point2){middle.x, middle.y + far};
}

/* Line 8 of Figure 12, with "or" for its "and" (E41). */
static void
remove_triangles_at(triangle_list *list, vertex_id first_removed)
{
    uint32_t kept = 0;
    for (uint32_t t = 0; t < list->count; t++) {
        const vertex_id *corner = list->corner[t];
        if (corner[0] >= first_removed || corner[1] >= first_removed ||
            corner[2] >= first_removed)
            continue;
        for (int i = 0; i < 3; i++)
            list->corner[kept][i] = corner[i];
        kept++;
    }
    list->count = kept;
}

tri_status
large_triangle_triangulate(const point2 *points, uint32_t n, double k,
                           triangle_list *out)
{
    *out = (triangle_list){0};
    point2 *all = memory_array((size_t)n + 3, sizeof *all);
    vertex_id *order = memory_array((size_t)n + 3, sizeof *order);
    tri_status status = all != NULL && order != NULL ? TRI_OK : TRI_OUT_OF_MEMORY;
    mesh D = {0};
    if (status == TRI_OK) {
        for (uint32_t i = 0; i < n; i++)
            all[i] = points[i];
        large_triangle(points, n, k, &all[n]);                // Line 1
        for (uint32_t i = 0; i < n + 3; i++)
            order[i] = i < 3 ? n + i : i - 3;
        tri_options options = tri_options_default();
        options.order = order;
        status = incremental_triangulate(all, n + 3, &options, &D); // Lines 2-7
    }
    if (status == TRI_OK)
        status = mesh_triangles(&D, out);
    if (status == TRI_OK)
        remove_triangles_at(out, n);                          // Line 8
    mesh_free(&D);
    memory_free(order);
    memory_free(all);
    return status;
}
