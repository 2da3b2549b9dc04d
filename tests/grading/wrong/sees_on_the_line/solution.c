static bool
sees(const mesh *m, const point2 *points, vertex_id p, halfedge_id e)
{
    return orient2d(points[mesh_origin(m, e)], points[mesh_dest(m, e)], points[p]) <= 0;
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    hull_chain q = {last, last};
    for (uint32_t i = mesh_hull_size(m); i > 1; i--)
        if (sees(m, points, p, mesh_hull_prev(m, q.first)))
            q.first = mesh_hull_prev(m, q.first);
        else if (sees(m, points, p, q.end))
            q.end = mesh_hull_next(m, q.end);
    return q;
}
