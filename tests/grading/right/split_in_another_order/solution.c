static void
split_triangle(mesh *m, halfedge_id ab, vertex_id p)
{
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab), c = mesh_apex(m, ab);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), ac = mesh_twin(m, mesh_prev(ab));
    halfedge_id pc = mesh_add_triangle(m, p, c, a), pb = mesh_add_triangle(m, p, b, c);
    mesh_set_triangle(m, ab, a, b, p);
    mesh_link(m, mesh_next(pc), ac);
    mesh_link(m, mesh_next(pb), cb);
    mesh_link(m, pc, mesh_prev(pb));
    mesh_link(m, pb, mesh_next(ab));
    mesh_link(m, mesh_prev(pc), mesh_prev(ab));
}
