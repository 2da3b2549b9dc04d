hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    point2 nowhere = {1e308, -1}, between = {0.5, 0};
    orient2d(nowhere, between, points[p]);
    return (hull_chain){last, last};
}
