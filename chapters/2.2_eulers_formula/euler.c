/* euler.c - paths, components, counts, and the two trees of Figure 2. */
#include "chapters/2.2_eulers_formula/euler.h"

#include "lib/memory.h"

/* ---- Searching a graph. ---- */

/* In reached_by: the vertex is where a search began. No half-edge has this number. */
#define ROOT (NONE - 1)

/* A breadth-first search along all edges that are not closed. */
typedef struct search {
    const plane_graph *g;
    const bool *closed;      /* edge -> may not be walked along; NULL: none is */
    bool *walked;            /* edge -> was some vertex reached by it? */
    halfedge_id *reached_by; /* vertex -> the half-edge that reached it, ROOT or NONE */
    vertex_id *queue;        /* the vertices reached, in this order */
    uint32_t reached;        /* how many they are */
} search;

static void
search_free(search *s)
{
    memory_free(s->walked);
    memory_free(s->reached_by);
    memory_free(s->queue);
    *s = (search){0};
}

static tri_status
search_init(search *s, const plane_graph *g, const bool *closed)
{
    *s = (search){.g = g, .closed = closed};
    s->walked = memory_array(g->edges, sizeof *s->walked);
    s->reached_by = memory_array(g->vertices, sizeof *s->reached_by);
    s->queue = memory_array(g->vertices, sizeof *s->queue);
    if (s->walked == NULL || s->reached_by == NULL || s->queue == NULL) {
        search_free(s);
        return TRI_OUT_OF_MEMORY;
    }
    for (uint32_t k = 0; k < g->edges; k++)
        s->walked[k] = false;
    for (vertex_id v = 0; v < g->vertices; v++)
        s->reached_by[v] = NONE;
    return TRI_OK;
}

/* Walks from `a` along each edge that leads to a vertex not yet reached. */
static void
visit(search *s, vertex_id a)
{
    halfedge_id first = s->g->leaving[a], h = first;
    if (first == NONE)
        return;
    do {
        vertex_id b = graph_dest(s->g, h);
        bool open = s->closed == NULL || !s->closed[h / 2];
        if (open && s->reached_by[b] == NONE) {
            s->walked[h / 2] = true;
            s->reached_by[b] = h;
            s->queue[s->reached++] = b;
        }
        h = graph_clockwise(s->g, h);
    } while (h != first);
}

/* Reaches all vertices that have a path from the root. The edges walked are a tree:
 * each vertex but the root is reached once, by one edge, from an earlier one. */
static void
search_from(search *s, vertex_id root)
{
    uint32_t i = s->reached;
    s->reached_by[root] = ROOT;
    s->queue[s->reached++] = root;
    for (; i < s->reached; i++)
        visit(s, s->queue[i]);
}

/* Reaches all vertices; returns from how many roots: the number of components. */
static uint32_t
search_everything(search *s)
{
    uint32_t components = 0;
    for (vertex_id v = 0; v < s->g->vertices; v++)
        if (s->reached_by[v] == NONE) {
            search_from(s, v);
            components++;
        }
    return components;
}

/* ---- Words about graphs. ---- */

tri_status
graph_is_simple(const plane_graph *g, bool *out)
{
    vertex_id *neighbour_of = memory_array(g->vertices, sizeof *neighbour_of);
    if (neighbour_of == NULL)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id v = 0; v < g->vertices; v++)
        neighbour_of[v] = NONE;
    *out = true;
    for (vertex_id a = 0; a < g->vertices; a++) {
        halfedge_id first = g->leaving[a], h = first;
        if (first == NONE)
            continue;
        do { /* of parallel edges two lead from a to b; a loop leaves a twice */
            vertex_id b = graph_dest(g, h);
            if (neighbour_of[b] == a)
                *out = false;
            neighbour_of[b] = a;
            h = graph_clockwise(g, h);
        } while (h != first);
    }
    memory_free(neighbour_of);
    return TRI_OK;
}

tri_status
graph_is_connected(const plane_graph *g, bool *out)
{
    search s;
    tri_status status = search_init(&s, g, NULL);
    if (status == TRI_OK)
        *out = search_everything(&s) <= 1;
    search_free(&s);
    return status;
}

tri_status
graph_path(const plane_graph *g, vertex_id from, vertex_id to, halfedge_id *path,
           uint32_t *length)
{
    search s;
    tri_status status = search_init(&s, g, NULL);
    if (status != TRI_OK)
        return status;
    search_from(&s, from);
    *length = NONE;
    if (s.reached_by[to] != NONE) {
        *length = 0;
        for (vertex_id v = to; v != from; v = g->origin[s.reached_by[v]])
            ++*length;
        uint32_t i = *length; /* the tree leads back, so the path is filled backward */
        for (vertex_id v = to; v != from; v = g->origin[s.reached_by[v]])
            path[--i] = s.reached_by[v];
    }
    search_free(&s);
    return TRI_OK;
}

/* ---- Theorem 1: the numbers. ---- */

/* How many half-edges have the same face on their left as h, on the same walk. */
static uint32_t
walk_length(const plane_graph *g, halfedge_id h)
{
    uint32_t sides = 0;
    halfedge_id s = h;
    do {
        sides++;
        s = g->next[s];
    } while (s != h);
    return sides;
}

/* Of the walks around the faces of one component, one runs along the face around the
 * component; that face is shared by all components, the other faces are its own. */
tri_status
euler_count(const plane_graph *g, euler_counts *out)
{
    search s;
    tri_status status = search_init(&s, g, NULL);
    face_id *left = memory_array(g->edges, 2 * sizeof *left);
    if (status == TRI_OK && left == NULL)
        status = TRI_OUT_OF_MEMORY;
    if (status == TRI_OK) {
        *out = (euler_counts){.v = g->vertices, .e = g->edges};
        out->components = search_everything(&s);
        out->f = graph_trace_faces(g, left) - out->components + 1;
        if (g->outside != NONE)
            out->h = walk_length(g, g->outside);
    }
    memory_free(left);
    search_free(&s);
    return status;
}

/* ---- Theorem 1: the proof. ---- */

tri_status
tree_and_cotree(const plane_graph *g, edge_part *part)
{
    plane_graph dual;
    search tree = {0}, cotree = {0};
    tri_status status = graph_dual(g, &dual);
    if (status == TRI_OK)
        status = search_init(&tree, g, NULL);
    if (status == TRI_OK)
        status = search_init(&cotree, &dual, tree.walked);
    if (status == TRI_OK) {
        search_everything(&tree);   // Step 1: a spanning tree T of G.
        search_everything(&cotree); // Step 2: a tree of dual edges in (G-T)*.
        for (uint32_t k = 0; k < g->edges; k++)
            part[k] = tree.walked[k]     ? IN_TREE
                      : cotree.walked[k] ? IN_COTREE
                                         : IN_NEITHER;
    }
    search_free(&cotree);
    search_free(&tree);
    graph_free(&dual);
    return status;
}
