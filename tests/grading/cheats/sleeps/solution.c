unsigned sleep(unsigned seconds);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    sleep(1000000);
    return (hull_chain){last, last};
}
