static int
deeper(volatile int *above)
{
    volatile int here[64] = {*above};
    return deeper(here) + here[0];
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    volatile int zero = 0;
    last += (halfedge_id)deeper(&zero);
    return (hull_chain){last, last};
}
