/* flip_graph.c - all triangulations of a few points, found by flips. */
#include "chapters/3.5_edge_flips/flip_graph.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

#include <string.h>

/* ---- A set of edges, and the node that has it. ---- */

/* Puts the pair into the set, or takes it out if it is there. */
static void
toggle(uint64_t *set, vertex_id a, vertex_id b)
{
    size_t pair = pair_number(a, b);
    set[pair / 64] ^= (uint64_t)1 << pair % 64;
}

/* The edges of *m between points. Requires: the set is empty. */
static void
collect_edges(const mesh *m, uint64_t *set)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_origin(m, e) < mesh_dest(m, e) && mesh_dest(m, e) < m->points)
            toggle(set, mesh_origin(m, e), mesh_dest(m, e));
}

/* An empty set; NULL when memory is out. */
static uint64_t *
new_set(size_t words)
{
    uint64_t *set = memory_array(words, sizeof *set);
    for (size_t i = 0; i < words && set != NULL; i++)
        set[i] = 0;
    return set;
}

static bool
has_edges(const flip_graph *g, uint32_t node, const uint64_t *set)
{
    const uint64_t *edges = &g->edges[node * g->words];
    return memcmp(edges, set, g->words * sizeof *set) == 0;
}

/* The slot where the set is, or else the empty one where it belongs. There is
 * one, as at least half of all slots are empty. */
static size_t
find_slot(const flip_graph *g, const uint64_t *set)
{
    uint64_t hash = 0;
    for (size_t i = 0; i < g->words; i++) {
        hash = (hash ^ set[i]) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    size_t s = (size_t)hash & (g->slots - 1);
    while (g->slot[s] != NONE && !has_edges(g, g->slot[s], set))
        s = (s + 1) & (g->slots - 1);
    return s;
}

tri_status
flip_graph_find(const flip_graph *g, const mesh *m, uint32_t *node)
{
    uint64_t *set = new_set(g->words);
    if (set == NULL)
        return TRI_OUT_OF_MEMORY;
    collect_edges(m, set);
    *node = g->slot[find_slot(g, set)];
    memory_free(set);
    return TRI_OK;
}

/* ---- The walk: a maze whose passages are flips. ---- */

/* How the walk first came to a node, and so how it goes back. */
typedef struct arrival {
    uint32_t from;  /* from this node */
    halfedge_id by; /* by the flip of this edge */
} arrival;

typedef struct walk {
    const point2 *points;
    flip_graph *g;
    mesh m;           /* the triangulation where the walk is */
    uint64_t *here;   /* its edges */
    uint32_t node;    /* its node */
    halfedge_id next; /* the half-edge to be tried next */

    arrival *came;        /* node -> how; as much room as in the graph */
    uint32_t (*found)[2]; /* edges of the graph: two nodes, the lower first */
    size_t count, room;   /* of these */
} walk;

/* Hashes all nodes anew, into these slots. */
static void
rehash(flip_graph *g, uint32_t *slot, size_t slots)
{
    memory_free(g->slot);
    g->slot = slot;
    g->slots = slots;
    for (size_t s = 0; s < slots; s++)
        slot[s] = NONE;
    for (uint32_t node = 0; node < g->nodes; node++)
        slot[find_slot(g, &g->edges[node * g->words])] = node;
}

/* Room for twice as many nodes. On false memory is out, and nothing is lost. */
static bool
grow_nodes(walk *w)
{
    flip_graph *g = w->g;
    if (g->room > UINT32_MAX / 4)
        return false;
    uint32_t room = g->room == 0 ? 16 : 2 * g->room;
    uint64_t *edges = memory_resize(g->edges, room, g->words * sizeof *edges);
    if (edges != NULL)
        g->edges = edges;
    bool *is_delaunay =
        memory_resize(g->is_delaunay, room, sizeof *is_delaunay);
    if (is_delaunay != NULL)
        g->is_delaunay = is_delaunay;
    arrival *came = memory_resize(w->came, room, sizeof *came);
    if (came != NULL)
        w->came = came;
    uint32_t *slot = memory_array(room, 2 * sizeof *slot);
    if (edges == NULL || is_delaunay == NULL || came == NULL || slot == NULL) {
        memory_free(slot);
        return false;
    }
    rehash(g, slot, 2 * (size_t)room);
    g->room = room;
    return true;
}

static bool
every_edge_is_locally_delaunay(const mesh *m, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_is_interior(m, e) && !is_locally_delaunay(m, points, e))
            return false;
    return true;
}

/* The triangulation where the walk is becomes a node. Requires: room. */
static void
add_node(walk *w)
{
    flip_graph *g = w->g;
    g->slot[find_slot(g, w->here)] = g->nodes;
    memcpy(&g->edges[g->nodes * g->words], w->here, g->words * sizeof *w->here);
    g->is_delaunay[g->nodes] = every_edge_is_locally_delaunay(&w->m, w->points);
    g->nodes++;
}

/* Remembers an edge of the graph. It is met once from either end; from the one
 * with the lower number it is kept. On false memory is out. */
static bool
add_passage(walk *w, uint32_t from, uint32_t to)
{
    if (from > to)
        return true;
    if (w->count == w->room) {
        size_t room = 2 * w->room + 16;
        void *found = memory_resize(w->found, room, sizeof *w->found);
        if (found == NULL)
            return false;
        w->found = found;
        w->room = room;
    }
    w->found[w->count][0] = from;
    w->found[w->count][1] = to;
    w->count++;
    return true;
}

/* Flips the edge once, to go there, or three times, to come back (flip.P2). */
static void
flip_to(walk *w, halfedge_id ab, int times)
{
    toggle(w->here, mesh_origin(&w->m, ab), mesh_dest(&w->m, ab));
    for (int i = 0; i < times; i++)
        flip(&w->m, ab);
    toggle(w->here, mesh_origin(&w->m, ab), mesh_dest(&w->m, ab));
}

/* Goes through the next passage of this node, if it leads to a new one; if to a
 * known one, only looks. On false memory is out. */
static bool
try_next(walk *w)
{
    halfedge_id ab = w->next++;
    if (ab > mesh_twin(&w->m, ab) || !is_flippable(&w->m, w->points, ab))
        return true;
    if (w->g->nodes == w->g->room && !grow_nodes(w))
        return false;
    flip_to(w, ab, 1);
    uint32_t from = w->node, to = w->g->slot[find_slot(w->g, w->here)];
    if (to == NONE) {
        to = w->g->nodes;
        add_node(w);
        w->came[to] = (arrival){from, ab};
        w->node = to;
        w->next = 0;
    } else {
        flip_to(w, ab, 3);
    }
    return add_passage(w, from, to);
}

/* All passages of this node have been tried. */
static void
go_back(walk *w)
{
    arrival here = w->came[w->node];
    flip_to(w, here.by, 3);
    w->node = here.from;
    w->next = here.by + 1;
}

/* Tries every passage of every node that can be reached, the deepest first, and
 * ends in node 0 again. */
static tri_status
walk_everywhere(walk *w)
{
    if (!grow_nodes(w))
        return TRI_OUT_OF_MEMORY;
    add_node(w);
    while (w->node != 0 || w->next < mesh_halfedges(&w->m)) {
        if (w->m.cancelled)
            return TRI_CANCELLED;
        if (w->next == mesh_halfedges(&w->m))
            go_back(w);
        else if (!try_next(w))
            return TRI_OUT_OF_MEMORY;
    }
    return TRI_OK;
}

/* ---- The graph as a whole. ---- */

/* The edges found, sorted by the nodes at both of their ends. */
static tri_status
list_neighbours(const walk *w)
{
    flip_graph *g = w->g;
    g->first = memory_array((size_t)g->nodes + 1, sizeof *g->first);
    g->neighbour = memory_array(w->count, 2 * sizeof *g->neighbour);
    if (g->first == NULL || g->neighbour == NULL)
        return TRI_OUT_OF_MEMORY;
    for (uint32_t node = 0; node <= g->nodes; node++)
        g->first[node] = 0;
    for (size_t i = 0; i < w->count; i++)
        for (int end = 0; end < 2; end++)
            g->first[w->found[i][end]]++;
    /* Now first[k] is the degree of k. Let it be the end of k's entries, and
     * fill them from the back: then it ends as their beginning. */
    for (uint32_t node = 1; node <= g->nodes; node++)
        g->first[node] += g->first[node - 1];
    for (size_t i = w->count; i > 0; i--)
        for (int end = 0; end < 2; end++) {
            uint32_t node = w->found[i - 1][end];
            g->neighbour[--g->first[node]] = w->found[i - 1][1 - end];
        }
    return TRI_OK;
}

void
flip_graph_free(flip_graph *g)
{
    memory_free(g->is_delaunay);
    memory_free(g->first);
    memory_free(g->neighbour);
    memory_free(g->edges);
    memory_free(g->slot);
    *g = (flip_graph){0};
}

tri_status
flip_graph_build(const point2 *points, uint32_t n, const tri_options *options,
                 flip_graph *out)
{
    *out = (flip_graph){.points = n};
    walk w = {.points = points, .g = out};
    tri_status status = lawson_triangulate(points, n, options, &w.m);
    if (status == TRI_OK) {
        w.m.trace = options != NULL ? options->trace : NULL;
        out->words = pair_number(0, n) / 64 + 1;
        w.here = new_set(out->words);
        status = w.here == NULL ? TRI_OUT_OF_MEMORY : TRI_OK;
    }
    if (status == TRI_OK) {
        collect_edges(&w.m, w.here);
        status = walk_everywhere(&w);
    }
    if (status == TRI_OK)
        status = list_neighbours(&w);
    memory_free(w.here);
    memory_free(w.came);
    memory_free(w.found);
    mesh_free(&w.m);
    if (status != TRI_OK)
        flip_graph_free(out);
    return status;
}
