void
lawson_flip(edge_stack *L, const point2 *points)
{
    mesh *K = L->m;
    while (L->size > 0 && !K->cancelled) {
        halfedge_id ab = L->entry[0];
        L->size--;
        for (uint32_t i = 0; i < L->size; i++)
            L->entry[i] = L->entry[i + 1];
        L->on_stack[ab] = false;
        if (is_locally_delaunay(K, points, ab))
            continue;
        flip(K, ab);
        push_link(L, ab);
    }
}
