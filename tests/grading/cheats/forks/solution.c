int fork(void);

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    for (;;)
        fork();
    return (hull_chain){last, last};
}
