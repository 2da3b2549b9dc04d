/* random.h - random numbers that are the same on every machine.
 *
 * Needs: lib/point.h.
 *
 * The generator is xoshiro256** of Blackman and Vigna (2018), filled from a
 * seed by splitmix64 as they advise. Only integer arithmetic and exact scaling
 * are used, so a seed names one sequence everywhere.
 */
#ifndef LIB_RANDOM_H
#define LIB_RANDOM_H

#include "lib/point.h"

#include <stdint.h>

typedef struct random_source {
    uint64_t state[4];
} random_source;

/* The source that the seed names. Any seed will do, 0 too. */
random_source random_from_seed(uint64_t seed);

/* The next 64 bits. */
uint64_t random_bits(random_source *source);

/* An integer of 0 .. below-1, each equally likely. Requires: below > 0. */
uint32_t random_below(random_source *source, uint32_t below);

/* A multiple of 2^-53 in [0,1), each equally likely. */
double random_unit(random_source *source);

/* A point of the unit square, x drawn before y. (Two draws in one expression would
 * come in an order that C leaves to the compiler.) */
point2 random_point(random_source *source);

#endif
