static void
divide(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count <= 3) {
        triangulate_few(m, points, L, count);
        return;
    }
    const point2 d = {1, 0};
    uint32_t half = count / 2, wrong = 0;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t j = 0; j < i; j++)
            wrong += compare_along(d, points[L[j]], points[L[i]]) >= 0;
    divide(m, points, L, half);
    divide(m, points, L + half, count - half);
    if (!m->cancelled)
        merge(m, points, L[half - 1], L[half]);
}
