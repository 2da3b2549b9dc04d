/* lib/random: a seed names one sequence everywhere, and all values are equally likely.
 *
 * Hypotheses: none. The first answers of the two generators are those that their
 * authors' own programs print (Blackman and Vigna 2018; Steele, Lea and Flood 2014).
 */
#include "lib/random.h"

#include "tests/harness/harness.h"

#include <math.h>

static void
the_published_answers_come(void)
{
    static const uint64_t splitmix_of_0[4] = {0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4,
                                              0x06c45d188009454f, 0xf88bb8a8724c81ec};
    static const uint64_t xoshiro_of_1234[6] = {
        11520, 0, 1509978240, 1215971899390074240, 1216172134540287360,
        607988272756665600};
    random_source source = random_from_seed(0);
    for (int i = 0; i < 4; i++)
        CLAIM("random_from_seed", source.state[i] == splitmix_of_0[i], "word %d", i);
    source = (random_source){{1, 2, 3, 4}};
    for (int i = 0; i < 6; i++)
        CLAIM("random_bits", random_bits(&source) == xoshiro_of_1234[i], "answer %d",
              i);
}

/* Pearson's chi-square over `below` values; it has about below-1 on average, and
 * twice the square root of twice that more only one time in fifty. The bound here
 * is far above: what fails is not random. */
static void
small_numbers_are_equally_likely(void)
{
    enum { DRAWS = 20000, MOST = 30 };
    random_source *r = test_random_source();
    for (uint32_t below = 1; below <= MOST; below++) {
        uint32_t drawn[MOST] = {0};
        for (int i = 0; i < DRAWS; i++) {
            uint32_t value = random_below(r, below);
            CLAIM("random_below", value < below, "%u of %u", (unsigned)value,
                  (unsigned)below);
            drawn[value]++;
        }
        double expected = (double)DRAWS / below, chi_square = 0;
        for (uint32_t i = 0; i < below; i++)
            chi_square += (drawn[i] - expected) * (drawn[i] - expected) / expected;
        CLAIM("random_below", chi_square < below + 6 * sqrt(2.0 * below) + 10,
              "chi-square is %.1f for %u values", chi_square, (unsigned)below);
    }
}

/* 3 * 2^30 does not divide 2^32: a remainder alone would make the lower third twice
 * as likely as each of the others. */
static void
large_numbers_are_equally_likely(void)
{
    enum { DRAWS = 60000 };
    random_source *r = test_random_source();
    int lower_third = 0;
    for (int i = 0; i < DRAWS; i++)
        lower_third += random_below(r, 3u << 30) < 1u << 30;
    CLAIM("random_below", fabs(lower_third - DRAWS / 3.0) < 1000,
          "%d of %d are in the lower third", lower_third, DRAWS);
}

static void
the_unit_interval_is_filled(void)
{
    enum { DRAWS = 100000 };
    random_source *r = test_random_source();
    double sum = 0;
    int odd = 0;
    for (int i = 0; i < DRAWS; i++) {
        double x = random_unit(r), scaled = ldexp(x, 53);
        CLAIM("random_unit", x >= 0 && x < 1, "%g", x);
        CLAIM("random_unit", scaled == floor(scaled), "%.17g has more than 53 bits", x);
        odd += fmod(scaled, 2) != 0;
        sum += x;
    }
    /* six standard deviations: 1/sqrt(12 DRAWS) and 1/(2 sqrt(DRAWS)) */
    CLAIM("random_unit", fabs(sum / DRAWS - 0.5) < 0.0055, "mean %g", sum / DRAWS);
    CLAIM("random_unit", fabs((double)odd / DRAWS - 0.5) < 0.0095,
          "%d of %d are odd multiples of 2^-53", odd, DRAWS);
}

static void
a_seed_names_one_sequence(void)
{
    random_source *r = test_random_source();
    for (int i = 0; i < 1000; i++) {
        uint64_t seed = random_bits(r);
        random_source one = random_from_seed(seed), same = random_from_seed(seed);
        random_source other = random_from_seed(seed + 1);
        int differ = 0;
        for (int k = 0; k < 10; k++) {
            uint64_t bits = random_bits(&one);
            CLAIM("random_from_seed", bits == random_bits(&same), "answer %d", k);
            differ += bits != random_bits(&other);
        }
        CLAIM("random_from_seed", differ >= 9, "the next seed repeats %d of 10",
              10 - differ);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/random: the same everywhere, and fair");
    test_run("the published answers come", the_published_answers_come);
    test_run("a seed names one sequence", a_seed_names_one_sequence);
    test_run("small numbers are equally likely", small_numbers_are_equally_likely);
    test_run("large numbers are equally likely", large_numbers_are_equally_likely);
    test_run("the unit interval is filled", the_unit_interval_is_filled);
    return test_end((test_minima){.trials = 5});
}
