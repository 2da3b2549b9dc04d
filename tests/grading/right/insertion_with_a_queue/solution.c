static void
lawson_flip_around(edge_stack *L, const point2 *points, locator *T)
{
    mesh *D = L->m;
    while (L->size > 0 && !D->cancelled) {
        halfedge_id ab = L->entry[0];
        L->size--;
        for (uint32_t i = 0; i < L->size; i++)
            L->entry[i] = L->entry[i + 1];
        L->on_stack[ab] = false;
        if (is_locally_delaunay_at_infinity(D, points, ab))
            continue;
        flip(D, ab);
        locator_flip(T, ab);
        edge_stack_push(L, mesh_prev(ab));
        edge_stack_push(L, mesh_next(mesh_twin(D, ab)));
    }
}
