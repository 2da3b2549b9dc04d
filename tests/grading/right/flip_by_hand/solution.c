void
flip(mesh *m, halfedge_id ab)
{
    halfedge_id ba = m->halfedge[ab].twin;
    halfedge_id bc = mesh_next(ab), ca = mesh_prev(ab), ad = mesh_next(ba), db = mesh_prev(ba);
    vertex_id a = m->halfedge[ab].origin, b = m->halfedge[ba].origin;
    vertex_id c = m->halfedge[ca].origin, d = m->halfedge[db].origin;
    halfedge_id cb = m->halfedge[bc].twin, ac = m->halfedge[ca].twin;
    halfedge_id da = m->halfedge[ad].twin, bd = m->halfedge[db].twin;
    m->halfedge[ab] = (mesh_halfedge){d, ba};
    m->halfedge[bc] = (mesh_halfedge){c, ac};
    m->halfedge[ca] = (mesh_halfedge){a, da};
    m->halfedge[ba] = (mesh_halfedge){c, ab};
    m->halfedge[ad] = (mesh_halfedge){d, bd};
    m->halfedge[db] = (mesh_halfedge){b, cb};
    m->halfedge[ac].twin = bc, m->halfedge[da].twin = ca;
    m->halfedge[bd].twin = ad, m->halfedge[cb].twin = db;
    const halfedge_id changed[6] = {ab, bc, ca, ba, ad, db};
    for (int i = 0; i < 6; i++)
        if (m->halfedge[changed[i]].origin == GHOST)
            m->ghost_leaving = changed[i];
        else
            m->leaving[m->halfedge[changed[i]].origin] = changed[i];
    trace_report(m, (trace_event){TRACE_FLIP, ab, a, b, c, d});
}
