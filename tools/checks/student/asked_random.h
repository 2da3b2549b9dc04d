/* asked_random.h - random numbers that the checker chooses.
 *
 * For 3.6-d: the checker goes through all numbers that can come, one after the other.
 */
#ifndef TOOLS_CHECKS_STUDENT_ASKED_RANDOM_H
#define TOOLS_CHECKS_STUDENT_ASKED_RANDOM_H

#include "lib/random.h"

/* A source whose random_below is answered by the checker. The other functions end the
 * program: too many different numbers could come from them. */
random_source asked_random(void);

#endif
