static void
sweep(mesh *m, const point2 *points, const vertex_id *L)
{
    halfedge_id last = NONE;
    if (m->locations >= 2)
        last = start(m, L[0], L[1]);
    for (uint32_t i = 2; i < m->locations; i++) {
        halfedge_id e = last;
        uint32_t seen = 0;
        do {
            seen += sees(m, points, L[i], e);
            e = mesh_hull_next(m, e);
        } while (e != last);
        hull_chain q = {last, last};
        if (seen > 0)
            q = hull_edges_seeing(m, points, last, L[i]);
        last = attach(m, q, L[i]);
    }
}
