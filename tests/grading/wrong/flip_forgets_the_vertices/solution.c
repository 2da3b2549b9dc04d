void
flip(mesh *m, halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), ac = mesh_twin(m, mesh_prev(ab));
    halfedge_id da = mesh_twin(m, mesh_next(ba)), bd = mesh_twin(m, mesh_prev(ba));
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    const halfedge_id e[6] = {ab, mesh_next(ab), mesh_prev(ab),
                              ba, mesh_next(ba), mesh_prev(ba)};
    const vertex_id origin[6] = {d, c, a, c, d, b};
    for (int i = 0; i < 6; i++)
        m->halfedge[e[i]].origin = origin[i];
    mesh_link(m, e[1], ac);
    mesh_link(m, e[2], da);
    mesh_link(m, e[4], bd);
    mesh_link(m, e[5], cb);
    trace_report(m, (trace_event){TRACE_FLIP, ab, a, b, c, d});
}
