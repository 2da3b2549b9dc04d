/* asked_random.c - what lib/random.h declares, with one more source: the checker.
 *
 * It is linked in the place of lib/random.c. Numbers of the other sources are random
 * enough for a program that is checked, and are not those of the library.
 */
#include "tools/checks/student/asked_random.h"

#include "tools/checks/wire.h"

#include <stdio.h>
#include <stdlib.h>

int64_t driver_ask(wire_kind kind, const uint64_t *word, size_t count);

enum { SEEDED = 1, ASKED = 2 }; /* state[1]: which kind of source it is */

random_source
asked_random(void)
{
    return (random_source){{0, ASKED, 0, 0}};
}

random_source
random_from_seed(uint64_t seed)
{
    return (random_source){{seed, SEEDED, 0, 0}};
}

uint64_t
random_bits(random_source *source)
{
    if (source->state[1] == ASKED) {
        fputs("Please draw with random_below: its numbers can be counted.\n", stderr);
        exit(3);
    }
    uint64_t z = source->state[0] += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

uint32_t
random_below(random_source *source, uint32_t below)
{
    const uint64_t word = below;
    if (source->state[1] == ASKED)
        return (uint32_t)driver_ask(WIRE_RANDOM, &word, 1);
    return (uint32_t)((random_bits(source) >> 32) * below >> 32);
}

double
random_unit(random_source *source)
{
    return (double)(random_bits(source) >> 11) * 0x1p-53;
}

point2
random_point(random_source *source)
{
    double x = random_unit(source), y = random_unit(source);
    return (point2){x, y};
}
