/* turns.h - the variant `queue` of exercise 3.5-c: whoever waits longest is next.
 *
 * A program reports which half-edges it puts on its queue, takes off and flips, in this
 * order. That the report is one of a queue is certified, and nothing is computed:
 * they come off as they were put on, and each step is one that Figure 10 allows.
 */
#ifndef TOOLS_CHECKS_TURNS_H
#define TOOLS_CHECKS_TURNS_H

#include "lib/triangles.h"
#include "lib/verdict.h"
#include "tools/checks/plane.h"

typedef enum turn_kind { TURN_PUSHED, TURN_POPPED, TURN_FLIPPED } turn_kind;

/* What happened to half-edge e: a side of the list, or above them one outside. A flip
 * turns the sides of its two triangles one place, as flips.h says. */
typedef struct turn {
    turn_kind kind;
    halfedge_id e;
} turn;

/* Is this what Figure 10 reports when L is a queue? All of these must hold:
 *
 *   - the k-th half-edge popped is the k-th that was pushed, and each one is popped;
 *     none is pushed that waits, or whose twin waits
 *   - before the first pop every inner edge is pushed; later, only the sides of the
 *     quadrilateral of a flip are, right after it: each that is an inner edge and does
 *     not wait, in any order and direction; those on the hull may be pushed, too
 *   - an edge is flipped right after it is popped, exactly if it is not locally
 *     Delaunay
 *
 * Requires: the list is a triangulation. It becomes what the flips make of it, which
 * is Delaunay if the verdict holds (page 3.5, fig10.P5). Refuted: the edge that is
 * not treated as it should be. */
verdict certify_turns(const site *points, triangle_list list, const turn *report,
                      uint32_t count);

#endif
