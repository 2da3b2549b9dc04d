/* random.c - xoshiro256** and what is drawn from it. */
#include "lib/random.h"

#include <assert.h>

static uint64_t
rotate_left(uint64_t bits, int by)
{
    return bits << by | bits >> (64 - by);
}

random_source
random_from_seed(uint64_t seed)
{
    random_source source;
    for (int i = 0; i < 4; i++) { /* splitmix64: four outputs, never all zero */
        uint64_t z = seed += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        source.state[i] = z ^ z >> 31;
    }
    return source;
}

uint64_t
random_bits(random_source *source)
{
    uint64_t *s = source->state;
    uint64_t result = rotate_left(s[1] * 5, 7) * 9;
    uint64_t shifted = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = rotate_left(s[3], 45);
    return result;
}

uint32_t
random_below(random_source *source, uint32_t below)
{
    assert(below > 0);
    /* Of the 2^32 values the first 2^32 mod `below` are drawn again, so that
     * the rest divides evenly. */
    uint32_t unfair = (uint32_t)(-below) % below;
    for (;;) {
        uint32_t bits = (uint32_t)(random_bits(source) >> 32);
        if (bits >= unfair)
            return bits % below;
    }
}

double
random_unit(random_source *source)
{
    return (double)(random_bits(source) >> 11) * 0x1p-53;
}

point2
random_point(random_source *source)
{
    point2 p;
    p.x = random_unit(source);
    p.y = random_unit(source);
    return p;
}
