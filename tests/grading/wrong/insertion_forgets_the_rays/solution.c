static void
lawson_flip_around(edge_stack *L, const point2 *points, locator *T)
{
    mesh *D = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {
        if (mesh_origin(D, ab) == GHOST || mesh_dest(D, ab) == GHOST ||
            is_locally_delaunay_at_infinity(D, points, ab))
            continue;
        flip(D, ab);
        locator_flip(T, ab);
        edge_stack_push(L, mesh_prev(ab));
        edge_stack_push(L, mesh_next(mesh_twin(D, ab)));
    }
}
