static void
push_link_of(edge_stack *L, vertex_id p)
{
    halfedge_id e = mesh_leaving(L->m, p);
    for (int i = 0; i < 3; i++) {
        edge_stack_push(L, mesh_next(e));
        e = mesh_around(L->m, e);
    }
}
