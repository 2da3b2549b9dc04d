void
push_link(edge_stack *L, halfedge_id cd)
{
    edge_stack_push(L, mesh_next(cd));
    edge_stack_push(L, mesh_prev(cd));
}
