int printf(const char *format, ...);
int dprintf(int descriptor, const char *format, ...);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    hull_chain q = {last, last};
    printf("*** p = %u\n", (unsigned)p);
    while (sees(m, points, p, mesh_hull_prev(m, q.first)))
        q.first = mesh_hull_prev(m, q.first);
    while (sees(m, points, p, q.end))
        q.end = mesh_hull_next(m, q.end);
    for (uint32_t i = 0; i < 20; i++)
        dprintf(2, "DEBUG: %u %u \033[31mhere\n", (unsigned)q.first, (unsigned)q.end);
    return q;
}
