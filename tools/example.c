#include "chapters/triangulations.h"
#include <stdio.h>

int
main(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}};
    mesh m;
    triangle_list t = {0};
    if (fast_divide_triangulate(points, 5, NULL, &m) != TRI_OK ||
        mesh_triangles(&m, &t) != TRI_OK)
        fputs("out of memory\n", stderr);
    for (uint32_t i = 0; i < t.count; i++)
        printf("%u %u %u\n", t.corner[i][0], t.corner[i][1], t.corner[i][2]);
    triangle_list_free(&t);
    mesh_free(&m);
}
