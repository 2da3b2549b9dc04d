static void
triangulate_few(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count < 2)
        return;
    halfedge_id e = start(m, L[0], L[1]);
    if (count == 3 && orient2d(points[L[0]], points[L[1]], points[L[2]]) > 0)
        attach(m, (hull_chain){e, mesh_hull_next(m, e)}, L[2]);
    else if (count == 3)
        attach(m, (hull_chain){mesh_hull_prev(m, e), e}, L[2]);
}
