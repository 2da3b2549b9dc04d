uint32_t
hull_vertices(const mesh *m, vertex_id *hull)
{
    uint32_t size = m->locations < 2 ? m->locations : mesh_hull_size(m);
    if (size < 2) {
        hull[0] = 0;
        return size;
    }
    uint32_t step = size % 2 == 1 && size > 3 ? 2 : 1; /* a pentagram turns left, too */
    halfedge_id e = first_hull_edge(m, false);
    for (uint32_t i = 0; i < size; i++) {
        hull[i] = mesh_origin(m, e);
        for (uint32_t k = 0; k < step; k++)
            e = mesh_hull_next(m, e);
    }
    return size;
}
