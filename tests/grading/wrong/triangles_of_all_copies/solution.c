tri_status
delaunay_triangles(const point2 *points, uint32_t n, triangle_list *out)
{
    *out = (triangle_list){0};
    vertex_id *site = memory_array(n, sizeof *site);
    for (uint32_t i = 0; i < n; i++)
        site[i] = i;
    tri_status status = try_all_triangles(points, n, site, n, out);
    memory_free(site);
    return status;
}
