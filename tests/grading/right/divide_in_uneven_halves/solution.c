static void
divide(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count <= 3) {
        triangulate_few(m, points, L, count);
        return;
    }
    uint32_t half = count < 6 ? 2 : (count + 1) / 2;
    divide(m, points, L + half, count - half);
    divide(m, points, L, half);
    if (!m->cancelled)
        merge(m, points, L[half - 1], L[half]);
}
