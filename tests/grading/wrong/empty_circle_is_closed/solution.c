static tri_status
append_if_delaunay(const point2 *points, uint32_t n, vertex_id a, vertex_id b,
                   vertex_id c, triangle_list *list, uint32_t *room)
{
    int turn = orient2d(points[a], points[b], points[c]);
    if (turn == 0)
        return TRI_OK;
    vertex_id second = turn > 0 ? b : c, third = turn > 0 ? c : b;
    for (vertex_id d = 0; d < n; d++)
        if (d != a && d != b && d != c &&
            incircle(points[a], points[second], points[third], points[d]) >= 0)
            return TRI_OK;
    return append_triangle(list, room, a, second, third);
}
