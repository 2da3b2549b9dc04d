/* watch.h - running an algorithm: progress for people, statistics for tables.
 *
 * Needs: chapters/contents.h.
 */
#ifndef TOOLS_TRI_WATCH_H
#define TOOLS_TRI_WATCH_H

#include "chapters/contents.h"

/* Runs the algorithm; *m is its mesh.
 *
 * If standard error is a terminal, a long run tells there how far it is. If
 * `stats`, lines `name value` are printed: the sizes of the result, the flips,
 * and the shortest of several runs that nobody watches, in seconds and as a
 * multiple of sorting the points by (x,y) with qsort. The counted build,
 * build/counted/tri, adds the questions asked of the predicates, and how many
 * determinants were left to each tier after the filter.
 */
tri_status run_watched(const algorithm *a, const point2 *points, uint32_t n,
                       tri_options options, bool stats, mesh *m);

#endif
