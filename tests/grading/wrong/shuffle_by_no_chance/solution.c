void
shuffle(vertex_id *L, uint32_t count, random_source *random)
{
    (void)random;
    for (uint32_t i = 0; i < count / 2; i++) {
        vertex_id last = L[count - 1 - i];
        L[count - 1 - i] = L[i];
        L[i] = last;
    }
}
