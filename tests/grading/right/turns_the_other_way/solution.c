static void
divide_in_turn(mesh *m, const point2 *points, vertex_id *L, uint32_t count, point2 d,
               random_source *random)
{
    if (count <= 3) {
        for (uint32_t i = 0; i + 1 < count; i++)
            select_along(points, L + i, count - i, 0, d, random);
        triangulate_few(m, points, L, count);
        return;
    }
    uint32_t half = (count + 1) / 2;
    select_along(points, L, count, half - 1, d, random);
    select_along(points, L + half, count - half, 0, d, random);
    vertex_id v = L[half - 1], w = L[half];
    const point2 across = {d.y, -d.x};
    divide_in_turn(m, points, L, half, across, random);
    divide_in_turn(m, points, L + half, count - half, across, random);
    if (!m->cancelled)
        merge(m, points, v, w);
}
