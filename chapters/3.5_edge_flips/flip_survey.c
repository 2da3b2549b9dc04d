/* flip_survey.c - what can be read off a flip graph: distances, triangles. */
#include "chapters/3.5_edge_flips/flip_graph.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* ---- Distances. ---- */

void
flip_graph_distances(const flip_graph *g, uint32_t from, uint32_t *distance,
                     uint32_t *order)
{
    for (uint32_t node = 0; node < g->nodes; node++)
        distance[node] = NONE;
    distance[from] = 0;
    order[0] = from;
    for (uint32_t done = 0, seen = 1; done < seen; done++) {
        uint32_t node = order[done];
        for (size_t i = g->first[node]; i < g->first[node + 1]; i++) {
            uint32_t neighbour = g->neighbour[i];
            if (distance[neighbour] != NONE)
                continue;
            distance[neighbour] = distance[node] + 1;
            order[seen++] = neighbour;
        }
    }
}

/* Searches from the nodes in turn, those farthest from node 0 first. Two nodes
 * not begun with yet are both as near to node 0 as the next one or nearer, so
 * that the way through node 0 bounds their distance: at last none can be
 * further apart than two nodes already seen (page 3.5, flipgraph.P6). */
tri_status
flip_graph_diameter(const flip_graph *g, uint32_t *diameter)
{
    *diameter = 0;
    uint32_t *array = memory_array(g->nodes, 4 * sizeof *array);
    if (array == NULL)
        return TRI_OUT_OF_MEMORY;
    uint32_t *from_0 = array, *order_from_0 = from_0 + g->nodes;
    uint32_t *distance = order_from_0 + g->nodes, *order = distance + g->nodes;
    flip_graph_distances(g, 0, from_0, order_from_0);
    for (uint32_t k = g->nodes; k > 0; k--) {
        uint32_t node = order_from_0[k - 1];
        if (2 * from_0[node] <= *diameter)
            break;
        flip_graph_distances(g, node, distance, order);
        uint32_t farthest = distance[order[g->nodes - 1]];
        if (farthest > *diameter)
            *diameter = farthest;
    }
    memory_free(array);
    return TRI_OK;
}

/* ---- Triangles. ---- */

/* Does d lie in the counterclockwise triangle abc, or on its boundary? */
static bool
lies_in(const point2 *p, vertex_id d, vertex_id a, vertex_id b, vertex_id c)
{
    return orient2d(p[a], p[b], p[d]) >= 0 && orient2d(p[b], p[c], p[d]) >= 0 &&
           orient2d(p[c], p[a], p[d]) >= 0;
}

static bool
is_vertex(const flip_graph *g, uint32_t node, vertex_id v)
{
    for (vertex_id w = 0; w < g->points; w++)
        if (w != v && flip_graph_has_edge(g, node, v, w))
            return true;
    return false;
}

/* Is the counterclockwise abc, whose sides are edges, a triangle of the node?
 * The triangles inside it share no side with those outside. They fill it, and
 * there is more than one of them exactly when they have a fourth vertex. */
static bool
is_triangle(const flip_graph *g, const point2 *p, uint32_t node,
            const vertex_id t[3])
{
    for (vertex_id d = 0; d < g->points; d++)
        if (d != t[0] && d != t[1] && d != t[2] && is_vertex(g, node, d) &&
            lies_in(p, d, t[0], t[1], t[2]))
            return false;
    return true;
}

static void
add_triangle(triangle_list *list, vertex_id a, vertex_id b, vertex_id c)
{
    vertex_id *corner = list->corner[list->count++];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

tri_status
flip_graph_triangles(const flip_graph *g, const point2 *points, uint32_t node,
                     triangle_list *out)
{
    *out = (triangle_list){0, memory_array(g->points, 2 * sizeof *out->corner)};
    if (out->corner == NULL)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id a = 0; a < g->points; a++)
        for (vertex_id b = a + 1; b < g->points; b++) {
            if (!flip_graph_has_edge(g, node, a, b))
                continue;
            for (vertex_id c = b + 1; c < g->points; c++) {
                if (!flip_graph_has_edge(g, node, a, c) ||
                    !flip_graph_has_edge(g, node, b, c))
                    continue;
                int turn = orient2d(points[a], points[b], points[c]);
                vertex_id t[3] = {a, turn > 0 ? b : c, turn > 0 ? c : b};
                if (turn != 0 && is_triangle(g, points, node, t))
                    add_triangle(out, t[0], t[1], t[2]);
            }
        }
    return TRI_OK;
}
