/* flip_graphs.c - from points to a flip graph, and between its nodes and meshes. */
#include "tests/harness/flip_graphs.h"

#include "lib/mesh_build.h"
#include "tests/harness/harness.h"

flip_graph
graph_of(const point2 *points, uint32_t n)
{
    flip_graph g;
    tri_status status = flip_graph_build(points, n, NULL, &g);
    CLAIM("flipgraph.P2", status == TRI_OK, "%s", tri_status_text(status));
    return g;
}

mesh
mesh_of_node(const flip_graph *g, const point2 *points, uint32_t node)
{
    mesh m = {0};
    triangle_list list;
    CLAIM("flipgraph.P2", flip_graph_triangles(g, points, node, &list) == TRI_OK &&
          (list.count == 0 || mesh_from_triangles(g->points, list, &m) == TRI_OK),
          "out of memory");
    triangle_list_free(&list);
    return m;
}

uint32_t
node_of(const flip_graph *g, const mesh *m)
{
    uint32_t node;
    CLAIM("flipgraph.P2", flip_graph_find(g, m, &node) == TRI_OK, "out of memory");
    return node;
}
