static void
push_link_of(edge_stack *L, vertex_id p)
{
    halfedge_id first = mesh_leaving(L->m, p), e = first;
    do {
        halfedge_id link = mesh_next(e);
        if (e == first || mesh_origin(L->m, link) == GHOST || mesh_dest(L->m, link) == GHOST)
            edge_stack_push(L, link);
        e = mesh_around(L->m, e);
    } while (e != first);
}
