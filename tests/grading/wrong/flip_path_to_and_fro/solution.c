static tri_status
join(const recorder *down, const recorder *up, edge_list *out)
{
    size_t flips = (size_t)down->count + up->count, most = 0, again;
    for (uint32_t k = 0; k < down->count; k++)
        for (int i = 0; i < 4; i++)
            most = down->flip[k][i] >= most ? down->flip[k][i] + 1 : most;
    again = most * most;
    out->ends = memory_array(flips + 2 * again, sizeof *out->ends);
    if (out->ends == NULL)
        return TRI_OUT_OF_MEMORY;
    for (uint32_t k = 0; k < 2 * again; k++, out->count++) /* the first flip, to and fro */
        for (int end = 0; end < 2; end++)
            out->ends[out->count][end] = down->flip[0][2 * (k % 2) + (uint32_t)end];
    for (uint32_t k = 0; k < down->count; k++, out->count++)
        for (int end = 0; end < 2; end++)
            out->ends[out->count][end] = down->flip[k][end];
    for (uint32_t k = up->count; k > 0; k--, out->count++)
        for (int end = 0; end < 2; end++)
            out->ends[out->count][end] = up->flip[k - 1][2 + end];
    return TRI_OK;
}
