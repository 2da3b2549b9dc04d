long write(int descriptor, const void *bytes, unsigned long count);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    static const char line[4096] = "all work and no play\n";
    while (orient2d(points[0], points[0], points[0]) == 0)
        write(1, line, sizeof line);
    return (hull_chain){last, last};
}
