void
shuffle(vertex_id *L, uint32_t count, random_source *random)
{
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = random_below(random, 32768) % i;
        vertex_id chosen = L[j];
        L[j] = L[i - 1];
        L[i - 1] = chosen;
    }
}
