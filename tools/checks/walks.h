/* walks.h - is the place right that a walk has found, and was it a straight walk? */
#ifndef TOOLS_CHECKS_WALKS_H
#define TOOLS_CHECKS_WALKS_H

#include "tools/checks/checker.h"

/* Exercise 3.6-b: from a random vertex to one of the points, in a mesh of the others.
 * The place is checked; the visits if they are asked for; and with them the number of
 * tests. */
void check_walk(session *s, const site *at, uint32_t n, bool visits, bool tests);

#endif
