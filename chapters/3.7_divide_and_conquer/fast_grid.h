/* fast_grid.h - sites sorted into the cells of a grid; no program includes it.
 *
 * Notes: section 3.7. Needs: fast_parts.h.
 *
 * A box is halved again and again, across its longer side each time. The cells that are
 * left are numbered like the halves: the bits of a number, from the highest on, say
 * "second half" or "first half" of one halving after the other. So the cells of a half
 * are a range of numbers, and so are their sites.
 */
#ifndef CHAPTERS_3_7_FAST_GRID_H
#define CHAPTERS_3_7_FAST_GRID_H

#include "chapters/3.7_divide_and_conquer/fast_parts.h"

enum { FAST_GRID_BITS = 11, FAST_GRID_CELLS = 1 << FAST_GRID_BITS };

typedef struct fast_box {
    double low[2], high[2]; /* along x, along y */
} fast_box;

/* The cells and their sites; kept while the cells are worked on. */
typedef struct fast_cells {
    int bits;                           /* there are 2^bits cells */
    unsigned char axis[FAST_GRID_BITS]; /* which way each halving went: the first stands
                                           at bits-1 */
    uint32_t end[FAST_GRID_CELLS]; /* cell -> how many sites it and those before have */
} fast_cells;

/* The smallest box around the sites. Requires: count > 0. */
fast_box fast_box_around(const fast_site *site, uint32_t count);

/* The smallest box around two. */
fast_box fast_box_join(fast_box a, fast_box b);

/* A box that may leave out some sites that are far away from the others: most
 * likely less than a quarter of them. */
fast_box fast_box_of_most(const fast_site *site, uint32_t count, fast_box all);

/* Halves the box `bits` times and moves the sites to `to`, those of cell 0 first. Sites
 * outside the box are in the cells at its border. Changes from[].edge. False, and
 * nothing has happened, when doubles cannot measure the box. More threads than one need
 * memory; if there is none, one will do.
 *
 * Two sites in different halves differ in that coordinate: a column grows with x, since
 * rounding is monotonic. */
bool fast_grid_sort(fast_cells *cells, fast_box box, int bits, fast_site *from,
                    fast_site *to, uint32_t count, uint32_t threads);

#endif
