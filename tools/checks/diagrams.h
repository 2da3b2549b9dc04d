/* diagrams.h - Voronoi diagrams by their definition: which sites share an edge, and
 * which circles have no site inside.
 *
 * Slow and plain: everything is compared with everything.
 */
#ifndef TOOLS_CHECKS_DIAGRAMS_H
#define TOOLS_CHECKS_DIAGRAMS_H

#include "tools/checks/plane.h"

/* Do the regions of p and q share an edge, of some length: is there a point with p and
 * q nearest, and no other location as near? Requires: they do not coincide. */
bool share_an_edge(const site *at, uint32_t n, site p, site q);

/* Is there a site strictly inside the circle of a, b, c? Requires: not collinear;
 * either order. */
bool circle_is_empty(const site *at, uint32_t n, site a, site b, site c);

/* Turning left around p, from the direction of `from`: is q met before r? Requires:
 * none of them is p, and q and r lie in different directions. */
bool is_met_before(site p, site from, site q, site r);

#endif
