static void
make_right(mesh *K, const point2 *points, halfedge_id ab)
{
    if (is_locally_delaunay(K, points, ab))
        return;
    flip(K, ab);
    halfedge_id cd = ab, dc = mesh_twin(K, ab);
    const halfedge_id around[4] = {mesh_next(cd), mesh_prev(cd), mesh_next(dc), mesh_prev(dc)};
    vertex_id end[4][2];
    for (int i = 0; i < 4; i++) { /* half-edges turn when others are flipped: keep names */
        end[i][0] = mesh_origin(K, around[i]);
        end[i][1] = mesh_dest(K, around[i]);
    }
    for (int i = 0; i < 4; i++)
        for (halfedge_id e = 0; e < mesh_halfedges(K); e++)
            if (mesh_origin(K, e) == end[i][0] && mesh_dest(K, e) == end[i][1]) {
                make_right(K, points, e);
                break;
            }
}

void
lawson_flip(edge_stack *L, const point2 *points)
{
    halfedge_id ab;
    while (edge_stack_pop(L, &ab))
        make_right(L->m, points, ab);
}
