static bool
is_to_be_flipped(const mesh *D, const point2 *points, halfedge_id ab)
{
    vertex_id a = mesh_origin(D, ab), b = mesh_dest(D, ab);
    vertex_id c = mesh_apex(D, ab), d = mesh_apex(D, mesh_twin(D, ab));
    if (a == GHOST || b == GHOST || c == GHOST || d == GHOST)
        return !is_locally_delaunay_at_infinity(D, points, ab);
    return incircle(points[a], points[b], points[c], points[d]) >= 0;
}

static void
lawson_flip_around(edge_stack *L, const point2 *points, locator *T)
{
    mesh *D = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {
        if (!is_to_be_flipped(D, points, ab))
            continue;
        flip(D, ab);
        locator_flip(T, ab);
        edge_stack_push(L, mesh_prev(ab));
        edge_stack_push(L, mesh_next(mesh_twin(D, ab)));
    }
}
