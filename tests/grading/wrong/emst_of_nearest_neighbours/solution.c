tri_status
emst(const mesh *m, const point2 *points, edge_list *out)
{
    tri_status status = mesh_edges(m, NULL, out);
    uint32_t kept = 0;
    for (uint32_t i = 0; i < out->count; i++) {
        vertex_id v = out->ends[i][0], w = out->ends[i][1];
        bool nearest[2] = {true, true};
        for (uint32_t k = 0; k < out->count; k++)
            for (int side = 0; side < 2; side++)
                for (int end = 0; end < 2; end++)
                    if (out->ends[k][end] == (side == 0 ? v : w) &&
                        compare_distance(points[out->ends[k][0]], points[out->ends[k][1]],
                                         points[v], points[w]) < 0)
                        nearest[side] = false;
        if (nearest[0] || nearest[1]) {
            vertex_id *kept_edge = out->ends[kept++];
            vertex_id old[2] = {kept_edge[0], kept_edge[1]};
            kept_edge[0] = v, kept_edge[1] = w;
            out->ends[i][0] = kept - 1 == i ? v : old[0];
            out->ends[i][1] = kept - 1 == i ? w : old[1];
        }
    }
    out->count = kept;
    return status;
}
