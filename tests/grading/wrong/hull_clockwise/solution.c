uint32_t
hull_vertices(const mesh *m, vertex_id *hull)
{
    uint32_t size = m->locations < 2 ? m->locations : mesh_hull_size(m);
    halfedge_id e = size < 2 ? NONE : mesh_some_hull_edge(m);
    for (uint32_t i = 0; i < size; i++) {
        hull[i] = e == NONE ? 0 : mesh_origin(m, e);
        e = e == NONE ? NONE : mesh_hull_prev(m, e);
    }
    return size;
}
