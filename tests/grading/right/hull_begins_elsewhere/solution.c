static halfedge_id
first_hull_edge(const mesh *m, bool path)
{
    halfedge_id e = mesh_some_hull_edge(m);
    while (path && mesh_hull_prev(m, e) != mesh_twin(m, e))
        e = mesh_hull_next(m, e);
    return path ? e : mesh_hull_next(m, mesh_hull_next(m, e));
}
