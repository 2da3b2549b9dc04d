static bool
sees(const mesh *m, const point2 *points, vertex_id p, halfedge_id e)
{
    point2 u = points[mesh_origin(m, e)], w = points[mesh_dest(m, e)], q = points[p];
    return (w.x - u.x) * (q.y - u.y) - (w.y - u.y) * (q.x - u.x) < 0;
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    hull_chain q = {last, last};
    uint32_t size = mesh_hull_size(m);
    for (uint32_t i = 0; i < size && sees(m, points, p, mesh_hull_prev(m, q.first)); i++)
        q.first = mesh_hull_prev(m, q.first);
    for (uint32_t i = 0; i < size && sees(m, points, p, q.end); i++)
        q.end = mesh_hull_next(m, q.end);
    return q;
}
