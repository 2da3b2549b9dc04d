static void
divide(mesh *m, const point2 *points, const vertex_id *L, uint32_t count)
{
    if (count <= 2) {
        triangulate_few(m, points, L, count);
        return;
    }
    uint32_t half = count / 2;
    divide(m, points, L, half);
    divide(m, points, L + half, count - half);
    merge(m, points, L[half - 1], L[half]);
}
