tri_status
sort_along(const point2 *points, uint32_t n, point2 d, vertex_id *order,
           uint32_t *locations)
{
    *locations = 0;
    site *sorted = memory_array(n, 2 * sizeof *sorted);
    if (sorted == NULL)
        return TRI_OUT_OF_MEMORY;
    site *spare = sorted + n;
    for (vertex_id v = 0; v < n; v++)
        sorted[v] = spare[v] = (site){points[n - 1 - v], n - 1 - v};
    merge_sort(sorted, spare, 0, n, d);
    for (uint32_t i = 0; i < n; i++)
        if (i == 0 || compare_along(d, sorted[i - 1].at, sorted[i].at) != 0)
            order[(*locations)++] = sorted[i].id;
    memory_free(sorted);
    return TRI_OK;
}
