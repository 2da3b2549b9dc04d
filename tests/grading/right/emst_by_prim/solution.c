tri_status
emst(const mesh *m, const point2 *points, edge_list *out)
{
    tri_status status = mesh_edges(m, NULL, out);
    bool *reached = memory_array(m->points, sizeof *reached);
    for (vertex_id v = 0; v < m->points; v++)
        reached[v] = false;
    if (out->count > 0)
        reached[out->ends[0][0]] = true;
    uint32_t kept = 0;
    for (;;) {
        uint32_t best = NONE;
        for (uint32_t i = kept; i < out->count; i++) {
            const vertex_id *e = out->ends[i];
            if (reached[e[0]] != reached[e[1]] &&
                (best == NONE ||
                 compare_distance(points[e[0]], points[e[1]], points[out->ends[best][0]],
                                  points[out->ends[best][1]]) <= 0))
                best = i;
        }
        if (best == NONE)
            break;
        reached[out->ends[best][0]] = reached[out->ends[best][1]] = true;
        for (int end = 0; end < 2; end++) {
            vertex_id other = out->ends[kept][end];
            out->ends[kept][end] = out->ends[best][end];
            out->ends[best][end] = other;
        }
        kept++;
    }
    out->count = kept;
    memory_free(reached);
    return status;
}
