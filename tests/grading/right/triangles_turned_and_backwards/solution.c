static tri_status
try_all_triangles(const point2 *points, uint32_t n, const vertex_id *site,
                  uint32_t u, triangle_list *list)
{
    tri_status status = TRI_OK;
    uint32_t room = 0;
    for (uint32_t k = u; k-- > 0;)
        for (uint32_t j = k; j-- > 0;)
            for (uint32_t i = j; i-- > 0 && status == TRI_OK;)
                status = append_if_delaunay(points, n, site[k], site[i],
                                            site[j], list, &room);
    return status;
}
