/* shuffles.h - all orders that a shuffle can make, with their probabilities.
 *
 * The program's random numbers are chosen by the checker, which goes through all of
 * them like through the leaves of a tree. Nothing is drawn, and nothing is estimated.
 */
#ifndef TOOLS_CHECKS_SHUFFLES_H
#define TOOLS_CHECKS_SHUFFLES_H

#include "tools/checks/checker.h"

/* Exercise 3.6-d, `count` items (at most 5): every leaf is an order of them, and every
 * order comes; if `fair`, with the same probability. */
void check_shuffles(session *s, uint32_t count, bool fair);

/* With more items, and numbers from a seed: is it an order of them? */
void check_long_shuffle(session *s, uint32_t count);

#endif
