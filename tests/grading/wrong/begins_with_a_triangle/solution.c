static void
sweep(mesh *m, const point2 *points, const vertex_id *L)
{
    halfedge_id last = NONE;
    if (m->locations >= 2)
        last = start(m, L[0], L[1]);
    for (uint32_t i = 2; i < m->locations; i++) {
        hull_chain q = hull_edges_seeing(m, points, last, L[i]);
        if (i == 2) /* one side of the first edge or the other */
            q = (hull_chain){mesh_hull_prev(m, last), last};
        last = attach(m, q, L[i]);
    }
}
