#define hull_edges_seeing not_this_one
#include "@PROJECT@/chapters/2.3_line_sweep/sweep.c"
#undef hull_edges_seeing

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    (void)sees;
    return (hull_chain){last, last};
}
