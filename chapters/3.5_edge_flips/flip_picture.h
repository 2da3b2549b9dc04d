/* flip_picture.h - a flip graph as a picture: each node a little triangulation.
 *
 * Notes: section 3.5.4. Needs: flip_graph.h, lib/svg.h.
 */
#ifndef CHAPTERS_3_5_FLIP_PICTURE_H
#define CHAPTERS_3_5_FLIP_PICTURE_H

#include "chapters/3.5_edge_flips/flip_graph.h"
#include "lib/svg.h"

/* More cannot be told apart on a page. */
enum { FLIP_PICTURE_MOST_NODES = 64 };

/* A whole picture. Delaunay triangulations are drawn with thicker lines.
 *
 * The distances on the page are about those in the graph; a picture of a convex
 * polygon looks like a solid with a vertex for each triangulation, and is one.
 * Requires: at most FLIP_PICTURE_MOST_NODES nodes.
 * Source: for the places, Kamada and Kawai 1989; Gansner, Koren and North 2004.
 */
void flip_graph_draw(const flip_graph *g, const point2 *points, FILE *file,
                     const char *title);

#endif
