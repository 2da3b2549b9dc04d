/* fast_export.h - from half-edges without triangles to the mesh; no program includes
 * it.
 *
 * Notes: section 3.7. Needs: fast_parts.h.
 */
#ifndef CHAPTERS_3_7_FAST_EXPORT_H
#define CHAPTERS_3_7_FAST_EXPORT_H

#include "chapters/3.7_divide_and_conquer/fast_parts.h"
#include "chapters/3.7_divide_and_conquer/fast_share.h"

/* So many half-edges more than 6 a site must have room in run->edge. */
enum { FAST_EXPORT_MORE = 8 * FAST_MOST_THREADS };

/* Fills in *m, an empty mesh with room for m->locations; uses up *run. The sites, and
 * behind them run->cw, may lie where the half-edges of *m will be.
 *
 * Requires: all pools of the run are closed; a duplicate has the edge NONE. */
void fast_export(fast_run *run, uint32_t sites, uint32_t some_hull_site, mesh *m,
                 uint32_t threads);

#endif
