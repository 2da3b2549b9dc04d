static bool
right_is_first(const mesh *m, const point2 *points, halfedge_id left, halfedge_id right)
{
    vertex_id l = mesh_origin(m, left), y = mesh_dest(m, left);
    vertex_id x = mesh_origin(m, right), r = mesh_dest(m, right);
    uint32_t inside = 0;
    for (vertex_id v = 0; v < m->points; v++)
        if (mesh_leaving(m, v) != NONE)
            inside += incircle(points[l], points[r], points[x], points[v]) > 0;
    if (inside > m->points)
        return false;
    return incircle(points[l], points[r], points[y], points[x]) > 0;
}
