void
buckets_share(buckets *b, halfedge_id e)
{
    if (mesh_origin(b->m, e) == GHOST)
        e = mesh_twin(b->m, e);
    halfedge_id f = mesh_twin(b->m, e);
    vertex_id s = mesh_origin(b->m, e), w = mesh_dest(b->m, e);
    vertex_id right = mesh_apex(b->m, f);
    vertex_id list[2] = {take_all(b, mesh_triangle_of(e)),
                         take_all(b, mesh_triangle_of(f))};
    for (int i = 0; i < 2; i++) {
        vertex_id next;
        for (vertex_id q = list[i]; q != NONE; q = next) {
            next = b->next[q];
            move(b, q, goes_left(b->points, b->o, s, w, right, q) ? e : f);
        }
    }
    for (triangle_id t = 0; t < b->m->triangles; t++) {
        vertex_id next;
        for (vertex_id q = take_all(b, t); q != NONE; q = next) {
            next = b->next[q];
            move(b, q, 3 * t);
        }
    }
}
