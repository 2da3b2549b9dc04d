static bool
has_edge(const mesh *m, vertex_id a, vertex_id b)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_origin(m, e) == a && mesh_dest(m, e) == b)
            return true;
    return false;
}

tri_status
flip_path(const point2 *points, const mesh *from, const mesh *to,
          edge_list *out)
{
    mesh m;
    tri_status status = copy_mesh(from, &m);
    *out = (edge_list){0};
    out->ends = memory_array(mesh_halfedges(from), sizeof *out->ends);
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e++)
        if (mesh_is_interior(&m, e) && out->count < mesh_halfedges(from) &&
            !has_edge(to, mesh_origin(&m, e), mesh_dest(&m, e))) {
            out->ends[out->count][0] = mesh_origin(&m, e);
            out->ends[out->count++][1] = mesh_dest(&m, e);
            flip(&m, e);
        }
    mesh_free(&m);
    return status;
}
