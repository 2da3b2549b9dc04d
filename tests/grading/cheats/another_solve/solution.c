void answer_number(uint64_t number);

void
solve(char exercise)
{
    answer_number(0);
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    (void)sees;
    return (hull_chain){last, last};
}
