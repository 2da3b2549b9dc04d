static void add_vertex(voronoi *d, const mesh *m, names *of, halfedge_id start);

static void
name_edges(voronoi *d, const mesh *m, const point2 *points, names *of)
{
    for (halfedge_id e = mesh_halfedges(m); e-- > 0;) {
        halfedge_id twin = mesh_twin(m, e);
        if (twin > e)
            of->edge[e] = of->edge[twin];
        else if (!joins_sites(m, e) || vanishes(m, points, e))
            of->edge[e] = NONE;
        else
            of->edge[e] = d->edges++;
    }
}

static void
name_vertices(voronoi *d, const mesh *m, names *of)
{
    d->vertex_first[0] = 0;
    for (triangle_id t = 0; t < m->triangles; t++)
        of->vertex[t] = NONE;
    for (halfedge_id e = mesh_halfedges(m); e-- > 0;)
        if (mesh_in_triangle(m, e) && of->edge[e] != NONE &&
            of->vertex[mesh_triangle_of(e)] == NONE)
            add_vertex(d, m, of, e);
}

static void
fill_cell(voronoi *d, const mesh *m, const names *of, vertex_id p)
{
    uint32_t at = d->cell_first[p];
    halfedge_id leaving = mesh_leaving(m, p), e = leaving;
    if (leaving != NONE)
        do {
            if (of->edge[e] != NONE)
                d->cell_edge[at++] = of->edge[e];
            e = mesh_around(m, e);
        } while (e != leaving);
    d->cell_first[p + 1] = at;
}
