tri_status
simplex_closure(simplex_list list, simplex_list *out)
{
    out->count = 0;
    out->simplex = memory_array(list.count, 16 * sizeof *out->simplex);
    if (out->simplex == NULL)
        return TRI_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < list.count; i++) {
        simplex face[16];
        uint32_t faces = simplex_faces(list.simplex[i], face);
        for (uint32_t k = 1; k < faces; k++)
            out->simplex[out->count++] = face[k];
    }
    return TRI_OK;
}
