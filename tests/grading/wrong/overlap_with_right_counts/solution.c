/* Triangles abc and bad become dca and cdb, whatever the four points look like. */
static void
exchange(mesh *m, halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), ac = mesh_twin(m, mesh_prev(ab));
    halfedge_id da = mesh_twin(m, mesh_next(ba)), bd = mesh_twin(m, mesh_prev(ba));
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    mesh_set_triangle(m, ab, d, c, a);
    mesh_set_triangle(m, ba, c, d, b);
    mesh_link(m, mesh_next(ab), ac);
    mesh_link(m, mesh_prev(ab), da);
    mesh_link(m, mesh_next(ba), bd);
    mesh_link(m, mesh_prev(ba), cb);
}

static void
sweep(mesh *m, const point2 *points, const vertex_id *L)
{
    halfedge_id last = NONE;
    if (m->locations >= 2)
        last = start(m, L[0], L[1]);
    for (uint32_t i = 2; i < m->locations; i++)
        last = attach(m, hull_edges_seeing(m, points, last, L[i]), L[i]);
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_is_interior(m, e) && m->locations % 3 != 0) {
            exchange(m, e); /* a longer diagonal, a shorter one: who can tell? */
            return;
        }
}
