/* probability.h - finite probability spaces, with exact probabilities.
 *
 * Notes: section 3.6.2. Needs: lib/verdict.h.
 *
 * The outcomes of a space are numbered 0 .. outcomes-1. An event is a subset: an
 * array that says for each outcome whether it is in it. A random variable is a
 * function: an array that gives its value at each outcome.
 */
#ifndef CHAPTERS_3_6_PROBABILITY_H
#define CHAPTERS_3_6_PROBABILITY_H

#include "lib/verdict.h"

#include <stdbool.h>
#include <stdint.h>

/* ---- Exact fractions. ---- */

/* num/den in lowest terms, den > 0, so that equal numbers have equal members. If
 * den is 0 it is no number: something was divided by zero, or was too large for 64
 * bits on the way. Whatever is computed from no number is none. */
typedef struct rational {
    int64_t num, den;
} rational;

/* num/den; no number if den is 0 or one of the two is INT64_MIN. */
rational rational_of(int64_t num, int64_t den);

rational rational_sum(rational a, rational b);
rational rational_product(rational a, rational b);
rational rational_quotient(rational a, rational b);

/* Are both numbers, and equal? */
bool rational_equal(rational a, rational b);

/* A rounded value, for pictures and for people. */
double rational_value(rational a);

/* ---- Probability spaces. ---- */

typedef struct probability_space {
    uint32_t outcomes;
    const rational *probability; /* outcome -> Pr{w} */
} probability_space;

/* Is it one: is there an outcome, is each Pr{w} >= 0, and is their sum 1? */
verdict is_probability_space(probability_space S);

/* Pr{A}: the sum of Pr{w} over the outcomes w in A. */
rational probability_of(probability_space S, const bool *A);

/* Pr{A|B} = Pr{A and B} / Pr{B}; no number if Pr{B} is 0. */
rational conditional_probability(probability_space S, const bool *A, const bool *B);

/* E[R]: the sum of R(w) Pr{w}; equation (5) of the notes is one. */
rational expected_value(probability_space S, const rational *R);

/* ---- The four-step method: the game with three doors. ---- */

/* A leaf of the tree of Figure 14: the doors, 0 to 2, behind which the car is, which
 * the player takes at first, and which is opened then: neither of these two. */
typedef struct door_game {
    int car, guess, opened;
} door_game;

enum { DOOR_GAMES = 12 };

/* Step 1, the sample space, and step 3, the probabilities of its outcomes: the
 * products along the branches of the tree. */
void door_games(door_game outcome[DOOR_GAMES], rational probability[DOOR_GAMES]);

/* Step 2, the event of interest: who changes to the third door wins. */
bool wins_by_switching(door_game w);

#endif
