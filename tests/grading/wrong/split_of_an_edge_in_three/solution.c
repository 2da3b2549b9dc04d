void
split(mesh *m, place at, vertex_id p)
{
    if (at.kind == PLACE_BEYOND)
        mesh_hull_join(m, at.e, at.e, p);
    else
        split_triangle(m, at.e, p);
    trace_report(m, (trace_event){TRACE_SPLIT, mesh_leaving(m, p), p, NONE, NONE, NONE});
}
