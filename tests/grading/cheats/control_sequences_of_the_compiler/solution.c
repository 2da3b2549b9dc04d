#error [2J[32m3 of 3 points</pre><script>alert(1)</script>

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    return (hull_chain){last, last};
}
