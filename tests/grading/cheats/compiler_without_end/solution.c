#if __INCLUDE_LEVEL__ < 190
#include "chapters/2.3_line_sweep/sweep.c"
#include "chapters/2.3_line_sweep/sweep.c"
#endif

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    (void)sees;
    return (hull_chain){last, last};
}
