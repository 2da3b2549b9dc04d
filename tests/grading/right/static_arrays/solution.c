static site room[2][1000];

tri_status
sort_along(const point2 *points, uint32_t n, point2 d, vertex_id *order,
           uint32_t *locations)
{
    *locations = 0;
    if (n > 1000)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id v = 0; v < n; v++)
        room[0][v] = room[1][v] = (site){points[v], v};
    merge_sort(room[0], room[1], 0, n, d);
    for (uint32_t i = 0; i < n; i++)
        if (i == 0 || compare_along(d, room[0][i - 1].at, room[0][i].at) != 0)
            order[(*locations)++] = room[0][i].id;
    return TRI_OK;
}
