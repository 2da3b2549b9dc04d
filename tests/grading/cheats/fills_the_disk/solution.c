#include <stdio.h>

hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    FILE *file = fopen("@TREASURE@", "w");
    for (int i = 0; file != NULL; i++)
        fprintf(file, "%d bottles\n", i);
    return (hull_chain){last, last};
}
