place
straight_walk(mesh *m, const point2 *points, vertex_id v, point2 p)
{
    (void)v;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        if (mesh_is_hull_edge(m, e)) {
            point2 a = points[mesh_origin(m, e)], b = points[mesh_dest(m, e)];
            int side = orient2d(a, b, p);
            if (side < 0)
                return (place){PLACE_TRIANGLE, mesh_twin(m, e)};
            if (side == 0 && is_same_side(a, b, p) && is_same_side(b, a, p))
                return (place){PLACE_EDGE, e};
            if (side == 0 && !is_same_side(a, b, p) &&
                mesh_hull_prev(m, e) == mesh_twin(m, e))
                return (place){PLACE_BEYOND, e};
        }
        if (mesh_in_triangle(m, e) && !lies_beyond(m, points, e, p) &&
            !lies_beyond(m, points, mesh_next(e), p) &&
            !lies_beyond(m, points, mesh_prev(e), p))
            return place_in_triangle(m, points, e, p);
    }
    return (place){PLACE_TRIANGLE, 0};
}
