/* nearest.c - the post-office problem: which site is nearest to x?
 *
 * Notes: section 3.1. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "chapters/3.4_primitives/predicates.h"

#include <stddef.h>

/* The neighbour of p that is nearest to x, or p itself when none is nearer than
 * p. Adds to *visited how many have been looked at. */
static vertex_id
nearer_neighbour(const mesh *m, const point2 *points, point2 x, vertex_id p,
                 uint32_t *visited)
{
    vertex_id best = p;
    halfedge_id leaving = mesh_leaving(m, p), e = leaving;
    do {
        vertex_id q = mesh_dest(m, e);
        if (q < m->points) { /* else e leads outside */
            ++*visited;
            if (compare_distance(x, points[q], x, points[best]) < 0)
                best = q;
        }
        e = mesh_around(m, e);
    } while (e != leaving);
    return best;
}

/* Each step comes nearer to x, so no site is reached twice. If no neighbour is
 * nearer than p, x lies in all half-planes that bound the cell of p, so in the
 * cell. */
vertex_id
nearest_site(const mesh *m, const point2 *points, point2 x, vertex_id start,
             uint32_t *visited)
{
    uint32_t count = 1;
    vertex_id p = m->locations > 1 ? start : 0;
    if (m->locations > 1) {
        vertex_id next = nearer_neighbour(m, points, x, p, &count);
        while (next != p) {
            p = next;
            next = nearer_neighbour(m, points, x, p, &count);
        }
    }
    if (visited != NULL)
        *visited = count;
    return p;
}
