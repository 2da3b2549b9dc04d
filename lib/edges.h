/* edges.h - lists of edges, the form in which graphs are handed out.
 *
 * Needs: lib/mesh.h.
 */
#ifndef LIB_EDGES_H
#define LIB_EDGES_H

#include "lib/mesh.h"

typedef struct edge_list {
    uint32_t count;
    vertex_id (*ends)[2]; /* edge -> its two ends */
} edge_list;

/* Frees the array and zeroes *list; a zeroed list is accepted. */
void edge_list_free(edge_list *list);

/* The edges of *m for which chosen[e] holds of a half-edge e along them; all of
 * its edges when chosen is NULL. Those at GHOST are left out. Each edge once,
 * the lower index first, in lexicographic order: the same edges make the same
 * list, whatever mesh they are in.
 *
 * Cost: O(n). TRI_OUT_OF_MEMORY: *out is zeroed. */
tri_status mesh_edges(const mesh *m, const bool *chosen, edge_list *out);

#endif
