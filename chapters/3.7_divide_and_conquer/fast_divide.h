/* fast_divide.h - Delaunay triangulations, as fast as they can be had.
 *
 * Notes: section 3.7. Needs: 3.4, lib/mesh.h, lib/options.h.
 *
 * The same method as divide.h, and the same triangulation where the notes leave no
 * choice. What is different is how the work is laid out for a machine; divide.c is the
 * one to read first, and the one to watch.
 */
#ifndef CHAPTERS_3_7_FAST_DIVIDE_H
#define CHAPTERS_3_7_FAST_DIVIDE_H

#include "lib/mesh.h"
#include "lib/options.h"

/* A Delaunay triangulation of the points, by options->threads threads.
 *
 * The mesh is the same, number by number, whatever the number of threads. Direction
 * and cuts mean nothing here: a part is cut across its longer side. Half-edges are
 * made and thrown away in an order that no observer could follow, so with a trace (or
 * more than MESH_MOST_LOCATIONS points, most of them duplicates) the work is done by
 * divide_triangulate.
 * Statuses and conventions: lib/options.h. Cost: O(n log n); 100 bytes a point, the
 * mesh included.
 * Source: Guibas and Stolfi 1985; alternating cuts: Dwyer 1987.
 */
tri_status fast_divide_triangulate(const point2 *points, uint32_t n,
                                   const tri_options *options, mesh *out);

#endif
