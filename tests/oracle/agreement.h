/* agreement.h - a predicate's answer beside the oracle's.
 *
 * Needs: chapters/3.4_primitives/predicates.h (counted),
 * tests/harness/harness.h.
 */
#ifndef TESTS_ORACLE_AGREEMENT_H
#define TESTS_ORACLE_AGREEMENT_H

#include "chapters/3.4_primitives/predicates.h"

/* The tier of 3.4 that has answered. */
typedef enum tier { FILTER, SIGNS, EXPANSIONS, WIDE } tier;

/* Which tier answered the one determinant asked for since `before` was copied
 * from predicate_count? */
tier tier_since(predicate_counts before);

/* Claims that the sign is right, in the name of the proof (page 3.4) of the
 * tier that answered since `before`. */
void claim_sign(predicate_counts before, int answered, int expected);

#endif
