void
shuffle(vertex_id *L, uint32_t count, random_source *random)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t j = random_below(random, count);
        vertex_id chosen = L[j];
        L[j] = L[i];
        L[i] = chosen;
    }
}
