void
lawson_flip(edge_stack *L, const point2 *points)
{
    mesh *K = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {
        vertex_id a = mesh_origin(K, ab), b = mesh_dest(K, ab);
        vertex_id c = mesh_apex(K, ab), d = mesh_apex(K, mesh_twin(K, ab));
        if (!mesh_is_interior(K, ab) || !is_flippable(K, points, ab) ||
            incircle(points[a], points[b], points[c], points[d]) < 0)
            continue;
        flip(K, ab);
        push_link(L, ab);
        edge_stack_push(L, ab); /* is it right now? */
    }
}
