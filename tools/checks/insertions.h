/* insertions.h - one point after the other, replayed from what is reported. */
#ifndef TOOLS_CHECKS_INSERTIONS_H
#define TOOLS_CHECKS_INSERTIONS_H

#include "tools/checks/checker.h"

/* Exercise 3.6-c: the locations are inserted in random order. The result must be
 * Delaunay; and if `flips`, each flip reported must be opposite the point that was
 * inserted last. */
void check_insertion(session *s, const site *at, uint32_t n, bool flips);

/* Exercise 3.6-e: the same with points that wait. Each must be where it waits; or, if
 * `moves`, they must move seldom. */
void check_waiting(session *s, const site *at, uint32_t n, bool moves);

#endif
