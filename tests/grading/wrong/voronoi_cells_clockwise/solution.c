static void
fill_cell(voronoi *d, const mesh *m, const names *of, vertex_id p)
{
    uint32_t at = d->cell_first[p];
    halfedge_id leaving = mesh_leaving(m, p), e = leaving;
    if (leaving != NONE)
        do {
            if (of->edge[e] != NONE)
                d->cell_edge[at++] = of->edge[e];
            e = mesh_next(mesh_twin(m, e));
        } while (e != leaving);
    d->cell_first[p + 1] = at;
}
