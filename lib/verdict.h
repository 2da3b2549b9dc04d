/* verdict.h - the answer of a check: it holds, or here is a witness against it.
 *
 * Needs: lib/point.h.
 *
 * A checker stands where its idea does (is_triangulation in 2.1, is_delaunay in
 * 3.5); all of them return this one type, so that one routine can print and one
 * can draw whatever was refuted.
 */
#ifndef LIB_VERDICT_H
#define LIB_VERDICT_H

#include "lib/point.h"

#include <stdbool.h>

typedef struct verdict {
    bool holds;
    char because[160];    /* when refuted: a sentence, indices from 0, no full stop */
    vertex_id witness[4]; /* when refuted: the points to look at, most telling first */
    int witnesses;        /* how many of them there are */
} verdict;

/* The verdict that a statement holds. */
verdict verdict_holds(void);

/* The verdict that it does not: a printf sentence, to which witnesses are added. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
verdict verdict_refuted(const char *because, ...);

/* The same verdict with one more point to look at; a fifth is dropped. */
verdict verdict_with(verdict refuted, vertex_id witness);

#endif
