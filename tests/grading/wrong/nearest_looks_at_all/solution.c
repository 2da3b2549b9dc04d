vertex_id
nearest_site(const mesh *m, const point2 *points, point2 x, vertex_id start,
             uint32_t *visited)
{
    vertex_id best = m->locations > 1 ? start : 0;
    for (vertex_id q = 0; q < m->points; q++)
        if (mesh_leaving(m, q) != NONE && compare_distance(x, points[q], x, points[best]) < 0)
            best = q;
    return best;
}
