static double
blocks(point2 p, point2 q)
{
    return fabs(p.x - q.x) + fabs(p.y - q.y);
}

tri_status
emst(const mesh *m, const point2 *points, edge_list *out)
{
    tri_status status = mesh_edges(m, NULL, out);
    vertex_id *parent = no_connections(m->points);
    for (uint32_t i = 0; i < out->count; i++)
        for (uint32_t k = i; k > 0; k--) {
            vertex_id *e = out->ends[k - 1], *f = out->ends[k];
            if (blocks(points[e[0]], points[e[1]]) <= blocks(points[f[0]], points[f[1]]))
                break;
            for (int end = 0; end < 2; end++) {
                vertex_id other = e[end];
                e[end] = f[end];
                f[end] = other;
            }
        }
    keep_tree(out, parent);
    memory_free(parent);
    return status;
}
