#include "checks/wire.h"

int64_t
driver_ask(wire_kind kind, const uint64_t *word, size_t count)
{
    return -1;
}

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    (void)sees;
    return (hull_chain){last, last};
}
