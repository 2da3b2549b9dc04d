/* graphs.h - graphs that lie inside the Delaunay triangulation.
 *
 * Notes: section 3.2.2, Theorem 2; the graphs named on the survey's page in
 * 3.1. Needs: 3.4, lib/edges.h, and any Delaunay triangulation. Exercise:
 * 3.2-b.
 *
 *     nearest neighbours   pq, if q is a nearest site of p; of several, all
 *     spanning trees       connected, of the smallest total length
 *     relative neighbours  pq, if no site is nearer to p and also nearer to q
 *                          than these are to each other: no site in the lune
 *     Gabriel              pq, if no other site is in the disc with diameter
 *                          pq, nor on its boundary (docs/errata.md, E24)
 *     Delaunay             the edges of any Delaunay triangulation
 *
 * The first two lie inside the third, and from there each one lies inside the
 * next. That is why all of them can be had from a Delaunay triangulation; which
 * one does not matter when sites are cocircular. Lengths are compared exactly.
 *
 * Each function that makes a graph requires that *m is a Delaunay triangulation
 * of the points. TRI_OUT_OF_MEMORY: *out is zeroed.
 */
#ifndef CHAPTERS_3_2_GRAPHS_H
#define CHAPTERS_3_2_GRAPHS_H

#include "lib/edges.h"
#include "lib/verdict.h"

/* ---- Spanning trees. ---- */

/* Sorts the edges by length; edges of the same length lexicographically by
 * their two indices.
 *
 * Cost: O(n), with fewer than n comparisons, if they come in lexicographic
 * order and their rounded lengths are in the right order; always O(n log n).
 * TRI_OUT_OF_MEMORY: they are in another order.
 */
tri_status sort_by_length(const point2 *points, edge_list edges);

/* A Euclidean minimum spanning tree, by Kruskal's algorithm on the Delaunay
 * edges, in the order of sort_by_length. Of several such trees it is the one
 * that this order prefers, whatever the triangulation.
 *
 * Exactly u-1 edges for u > 0 locations.
 * Cost: sort_by_length, then O(n log n) steps at most.
 * Source: notes 3.2.2, Theorem 2; Kruskal 1956.
 */
tri_status emst(const mesh *m, const point2 *points, edge_list *out);

/* Is the list a Euclidean minimum spanning tree of the points?
 *
 * Holds exactly when it has u-1 edges between vertices of *m, and the ends of
 * each edge of *m are connected by edges of the list that are not longer (page
 * 3.2, thm2.P6: that is enough).
 * Requires: *m is a Delaunay triangulation of the points (is_delaunay, 3.5).
 * Refuted: the ends of a wrong edge of the list, or of an edge of *m whose ends
 * are not so connected.
 * Cost: O(n log n). TRI_OUT_OF_MEMORY: *out says nothing.
 */
tri_status is_emst(const mesh *m, const point2 *points, edge_list tree,
                   verdict *out);

/* ---- Proximity graphs, their edges in lexicographic order. ---- */

/* Cost: O(n), at most 2 dot_signs for each edge.
 * Source: Gabriel and Sokal 1969. */
tri_status gabriel_graph(const mesh *m, const point2 *points, edge_list *out);

/* Cost: O(n log n), at most 6 comparisons of lengths for each triangle and 4
 * for each edge that is left out.
 * Source: Toussaint 1980; elimination paths: Jaromczyk and Kowaluk 1987. */
tri_status relative_neighbourhood_graph(const mesh *m, const point2 *points,
                                        edge_list *out);

/* Cost: O(n), at most 4 comparisons of lengths for each edge. */
tri_status nearest_neighbour_graph(const mesh *m, const point2 *points,
                                   edge_list *out);

#endif
