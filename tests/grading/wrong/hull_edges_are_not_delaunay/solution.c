bool
is_locally_delaunay(const mesh *m, const point2 *points, halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    if (mesh_is_hull_edge(m, ab) || mesh_is_hull_edge(m, ba))
        return false;
    return incircle(points[mesh_origin(m, ab)], points[mesh_origin(m, ba)],
                    points[mesh_apex(m, ab)], points[mesh_apex(m, ba)]) <= 0;
}
