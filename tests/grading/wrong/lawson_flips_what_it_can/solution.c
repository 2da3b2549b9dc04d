void
lawson_flip(edge_stack *L, const point2 *points)
{
    mesh *K = L->m;
    halfedge_id ab, some = NONE;
    for (halfedge_id e = 0; e < mesh_halfedges(K) && some == NONE; e++)
        if (is_flippable(K, points, e))
            some = e;
    if (some != NONE) { /* to begin with */
        flip(K, some);
        push_link(L, some);
        edge_stack_push(L, some);
    }
    while (edge_stack_pop(L, &ab)) {
        if (is_locally_delaunay(K, points, ab))
            continue;
        flip(K, ab);
        push_link(L, ab);
    }
}
