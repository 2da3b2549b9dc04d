/* Section 3.6.2: probability spaces, with the examples of the notes; and that every
 * order that `shuffle` can make is equally likely.
 *
 * Hypotheses: finite spaces; fractions that fit into 64 bits.
 *
 * The shuffle is run with sources that give every possible sequence of answers.
 */
#include "chapters/3.6_randomized_incremental/incremental.h"
#include "chapters/3.6_randomized_incremental/probability.h"
#include "tests/harness/harness.h"

#include <stdlib.h>
#include <string.h>

/* ---- Fractions. ---- */

static int64_t
small_number(random_source *r)
{
    return (int64_t)random_below(r, 41) - 20;
}

/* P1: compared with fractions whose terms are not cancelled. */
static void
fractions_are_exact(void)
{
    random_source *r = test_random_source();
    for (int k = 0; k < 10000; k++) {
        int64_t a = small_number(r), b = small_number(r), c = small_number(r);
        int64_t d = small_number(r);
        rational x = rational_of(a, b), y = rational_of(c, d);
        bool good = b != 0 && d != 0;
        rational sum = rational_sum(x, y), product = rational_product(x, y);
        rational quotient = rational_quotient(x, y);
        CLAIM("chance.P1", (sum.den != 0) == good && (product.den != 0) == good,
              "%d/%d and %d/%d", (int)a, (int)b, (int)c, (int)d);
        CLAIM("chance.P1", (quotient.den != 0) == (good && c != 0),
              "%d/%d over %d/%d", (int)a, (int)b, (int)c, (int)d);
        if (!good)
            continue;
        CLAIM("chance.P1",
              sum.num * b * d == (a * d + c * b) * sum.den && sum.den > 0,
              "%d/%d plus %d/%d", (int)a, (int)b, (int)c, (int)d);
        CLAIM("chance.P1",
              product.num * b * d == a * c * product.den && product.den > 0,
              "%d/%d times %d/%d", (int)a, (int)b, (int)c, (int)d);
        CLAIM("chance.P1", rational_equal(sum, rational_of(a * d + c * b, b * d)),
              "%d/%d plus %d/%d is not in lowest terms", (int)a, (int)b, (int)c,
              (int)d);
        CLAIM("chance.P1", c == 0 || quotient.num * b * c == a * d * quotient.den,
              "%d/%d over %d/%d", (int)a, (int)b, (int)c, (int)d);
    }
}

static void
what_does_not_fit_is_no_number(void)
{
    const int64_t large = INT64_MAX;
    rational x = rational_of(large, 2), y = rational_of(1, large),
             z = rational_of(2, 3);
    CLAIM("chance.P1", rational_sum(x, x).den == 0,
          "a numerator too large on the way");
    CLAIM("chance.P1",
          rational_sum(rational_of(large, 1), rational_of(1, 1)).den == 0,
          "more than the largest number");
    CLAIM("chance.P1",
          rational_sum(rational_of(-large, 1), rational_of(-1, 1)).den == 0,
          "less than the smallest number");
    CLAIM("chance.P1", rational_sum(y, z).den == 0,
          "a denominator that does not fit");
    CLAIM("chance.P1", rational_product(x, x).den == 0,
          "a product that does not fit");
    CLAIM("chance.P1",
          rational_equal(rational_product(x, rational_of(2, large)),
                         rational_of(1, 1)),
          "a product that fits after cancelling");
    rational tiny = rational_of(1, INT64_C(1) << 62);
    CLAIM("chance.P1",
          rational_equal(rational_sum(tiny, tiny), rational_of(1, INT64_C(1) << 61)),
          "a sum that fits over the least common denominator");
    CLAIM("chance.P1",
          rational_of(INT64_MIN, 1).den == 0 && rational_of(1, INT64_MIN).den == 0,
          "a number without an opposite");
    CLAIM("chance.P1", !rational_equal(rational_of(1, 0), rational_of(1, 0)),
          "1/0 is equal");
}

/* ---- Spaces, events, expectation. ---- */

enum { MOST = 12 };

/* P2: of any weights, a space; and the laws of events in it. */
static void
the_laws_of_events(void)
{
    random_source *r = test_random_source();
    for (int k = 0; k < 2000; k++) {
        uint32_t n = 1 + random_below(r, MOST), sum = 0, weight[MOST];
        rational p[MOST], R[MOST];
        bool A[MOST], B[MOST], both[MOST], either[MOST], not_a[MOST];
        for (uint32_t w = 0; w < n; w++) {
            weight[w] = random_below(r, 10);
            sum += weight[w];
        }
        if (sum == 0)
            continue;
        for (uint32_t w = 0; w < n; w++) {
            p[w] = rational_of(weight[w], sum);
            A[w] = random_below(r, 2) == 0;
            B[w] = random_below(r, 2) == 0;
            both[w] = A[w] && B[w];
            either[w] = A[w] || B[w];
            not_a[w] = !A[w];
            R[w] = rational_of(A[w], 1);
        }
        probability_space S = {n, p};
        claim_verdict("chance.P2", is_probability_space(S));
        rational a = probability_of(S, A), b = probability_of(S, B);
        CLAIM("chance.P2",
              rational_equal(
                  rational_sum(a, b),
                  rational_sum(probability_of(S, both), probability_of(S, either))),
              "A or B, of %u outcomes", n);
        CLAIM("chance.P2",
              rational_equal(rational_sum(a, probability_of(S, not_a)),
                             rational_of(1, 1)),
              "A or not A, of %u outcomes", n);
        CLAIM("chance.P2", rational_equal(expected_value(S, R), a),
              "the mean of A's indicator, of %u outcomes", n);
        rational given = conditional_probability(S, A, B);
        CLAIM("chance.P2", (given.den == 0) == (b.num == 0),
              "given B, of %u outcomes", n);
        CLAIM("chance.P2",
              b.num == 0 || rational_equal(rational_product(given, b),
                                           probability_of(S, both)),
              "A given B, of %u outcomes", n);
        uint32_t w = random_below(r, n);
        p[w] = rational_sum(p[w], rational_of(1, 7));
        CLAIM("chance.P2", !is_probability_space(S).holds,
              "a sum of 8/7 was accepted");
        p[w] = rational_of(-1, 7);
        CLAIM("chance.P2", !is_probability_space(S).holds, "-1/7 was accepted");
        const rational half_too_much[] = {rational_of(3, 2), rational_of(-1, 2)};
        CLAIM("chance.P2",
              !is_probability_space((probability_space){2, half_too_much}).holds,
              "-1/2 was accepted, as the sum is 1");
        p[w] = rational_of(1, 0);
        CLAIM("chance.P2", !is_probability_space(S).holds, "1/0 was accepted");
    }
    CLAIM("chance.P2", !is_probability_space((probability_space){0, NULL}).holds,
          "an empty space was accepted");
}

/* P3: two dice sum to 10, given that both are odd; and the mean of one die. */
static void
the_examples_with_dice(void)
{
    rational p[36], R[6], die[6];
    bool ten[36], odd[36];
    for (int w = 0; w < 36; w++) {
        int first = w / 6 + 1, second = w % 6 + 1;
        p[w] = rational_of(1, 36);
        ten[w] = first + second == 10;
        odd[w] = first % 2 == 1 && second % 2 == 1;
    }
    for (int w = 0; w < 6; w++) {
        die[w] = rational_of(1, 6);
        R[w] = rational_of(w + 1, 1);
    }
    probability_space two = {36, p}, one = {6, die};
    claim_verdict("chance.P3", is_probability_space(two));
    rational given = conditional_probability(two, ten, odd),
             alone = probability_of(two, ten);
    rational mean = expected_value(one, R);
    CLAIM("chance.P3", rational_equal(given, rational_of(1, 9)), "%d/%d",
          (int)given.num, (int)given.den);
    CLAIM("chance.P3", rational_equal(alone, rational_of(1, 12)),
          "%d/%d without condition", (int)alone.num, (int)alone.den);
    CLAIM("chance.P3", rational_equal(mean, rational_of(7, 2)), "%d/%d",
          (int)mean.num, (int)mean.den);
}

/* P4: the tree of the three doors has 12 leaves; switching wins 2/3. */
static void
the_game_with_three_doors(void)
{
    door_game outcome[DOOR_GAMES];
    rational p[DOOR_GAMES];
    bool switching[DOOR_GAMES];
    door_games(outcome, p);
    int ninths = 0;
    for (int w = 0; w < DOOR_GAMES; w++) {
        door_game g = outcome[w];
        CLAIM("chance.P4", g.opened != g.car && g.opened != g.guess,
              "leaf %d opens the car", w);
        for (int earlier = 0; earlier < w; earlier++)
            CLAIM("chance.P4", memcmp(&outcome[earlier], &g, sizeof g) != 0,
                  "leaves %d and %d are the same", earlier, w);
        switching[w] = wins_by_switching(g);
        CLAIM("chance.P4", switching[w] == (3 - g.guess - g.opened == g.car),
              "leaf %d: where is the third door?", w);
        ninths += rational_equal(p[w], rational_of(1, 9));
    }
    probability_space S = {DOOR_GAMES, p};
    claim_verdict("chance.P4", is_probability_space(S));
    rational wins = probability_of(S, switching);
    CLAIM("chance.P4", rational_equal(wins, rational_of(2, 3)) && ninths == 6,
          "switching wins %d/%d, %d leaves of 1/9", (int)wins.num, (int)wins.den,
          ninths);
}

/* ---- The shuffle. ---- */

/* A source whose next random_below(below[i]), i = 0, 1, 2, is answer[i].
 *
 * The generator's output depends on the second word of its state by an invertible
 * function. In three steps this word becomes, one after the other, s1, s1^s2^s0,
 * and a word that s3 shifts at will: so each can be chosen. */
static random_source
source_with_answers(const uint32_t below[3], const uint32_t answer[3])
{
    uint64_t word[3];
    for (int i = 0; i < 3; i++) {
        /* Far from the first few values, which are drawn again; and a prime, so that
         * who asks for numbers below anything else gets other answers. */
        uint64_t output = (uint64_t)(1009 * below[i] + answer[i]) << 32;
        uint64_t ninth = 0x8e38e38e38e38e39u, fifth = 0xcccccccccccccccdu;
        uint64_t turned = output * ninth;
        word[i] = (turned >> 7 | turned << 57) * fifth;
    }
    random_source source = {{0, word[0], word[1] ^ word[0], 0}};
    uint64_t s2_then = source.state[2] ^ word[0] << 17;
    source.state[3] = word[2] ^ word[1] ^ s2_then ^ word[0];
    return source;
}

/* What many students write first: every place changes with any place. */
static void
naive_shuffle(vertex_id *L, uint32_t count, random_source *random)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t j = random_below(random, count);
        vertex_id chosen = L[j];
        L[j] = L[i];
        L[i] = chosen;
    }
}

/* The number of the order L of 0 .. count-1, as digits. */
static uint32_t
digits_of(const vertex_id *L, uint32_t count)
{
    uint32_t digits = 0;
    for (uint32_t i = 0; i < count; i++)
        digits = 10 * digits + L[i];
    return digits;
}

/* Runs a shuffle of `count` for all answers to three questions below[0], below[1],
 * below[2], each answer equally likely. Returns how many orders there are, and the
 * probabilities of the most and the least likely of them. */
static int
orders_of_shuffle(void (*shuffle_)(vertex_id *, uint32_t, random_source *),
                  uint32_t count, const uint32_t below[3], rational *least,
                  rational *most)
{
    uint32_t leaf[64], answer[3], leaves = 0;
    rational p[64];
    for (answer[0] = 0; answer[0] < below[0]; answer[0]++)
        for (answer[1] = 0; answer[1] < below[1]; answer[1]++)
            for (answer[2] = 0; answer[2] < below[2]; answer[2]++) {
                random_source source = source_with_answers(below, answer),
                              copy = source;
                for (int i = 0; i < 3; i++) {
                    uint32_t given = random_below(&copy, below[i]);
                    CLAIM("chance.P5", given == answer[i], "answer %d is %u", i,
                          given);
                }
                vertex_id L[] = {0, 1, 2, 3};
                shuffle_(L, count, &source);
                CLAIM("chance.P5", memcmp(&source, &copy, sizeof copy) == 0,
                      "the shuffle asked for other than three numbers");
                p[leaves] = rational_of(1, (int64_t)below[0] * below[1] * below[2]);
                leaf[leaves++] = digits_of(L, count);
            }
    probability_space S = {leaves, p};
    claim_verdict("chance.P5", is_probability_space(S));
    int orders = 0;
    *least = rational_of(1, 1);
    *most = rational_of(0, 1);
    for (uint32_t w = 0; w < leaves; w++) {
        bool same[64], first = true;
        for (uint32_t v = 0; v < leaves; v++) {
            same[v] = leaf[v] == leaf[w];
            first = first && (v >= w || !same[v]);
        }
        orders += first;
        rational chance = probability_of(S, same);
        if (rational_value(chance) < rational_value(*least))
            *least = chance;
        if (rational_value(chance) > rational_value(*most))
            *most = chance;
    }
    return orders;
}

static void
every_order_is_equally_likely(void)
{
    const uint32_t fair[3] = {4, 3, 2}, naive[3] = {3, 3, 3};
    rational least, most;
    int orders = orders_of_shuffle(shuffle, 4, fair, &least, &most);
    CLAIM("chance.P5",
          orders == 24 && rational_equal(least, rational_of(1, 24)) &&
              rational_equal(most, rational_of(1, 24)),
          "%d orders, one of probability %d/%d", orders, (int)most.num,
          (int)most.den);
    orders = orders_of_shuffle(naive_shuffle, 3, naive, &least, &most);
    CLAIM("chance.P6",
          orders == 6 && rational_equal(least, rational_of(4, 27)) &&
              rational_equal(most, rational_of(5, 27)),
          "%d orders, from %d/%d to %d/%d", orders, (int)least.num, (int)least.den,
          (int)most.num, (int)most.den);
}

/* Longer lists: nothing is lost, and count-1 numbers are used. */
static void
a_shuffle_is_a_permutation(const point2 *points, uint32_t n)
{
    (void)points;
    vertex_id *L = malloc((n + 1) * sizeof *L);
    bool *seen = calloc(n + 1, sizeof *seen);
    for (uint32_t i = 0; i < n; i++)
        L[i] = i;
    shuffle(L, n, test_random_source());
    bool once = true;
    for (uint32_t i = 0; i < n && once; i++) {
        once = L[i] < n && !seen[L[i]];
        seen[once ? L[i] : 0] = true;
    }
    free(L);
    free(seen);
    CLAIM("chance.P5", once, "of %u one is lost", n);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Section 3.6.2: probability spaces, and a fair shuffle");
    test_run("fractions", fractions_are_exact);
    test_run("what does not fit", what_does_not_fit_is_no_number);
    test_run("events", the_laws_of_events);
    test_run("dice", the_examples_with_dice);
    test_run("three doors", the_game_with_three_doors);
    test_run("every order is equally likely", every_order_is_equally_likely);
    test_random("a shuffle is a permutation", a_shuffle_is_a_permutation, 500, 100);
    return test_end((test_minima){.trials = 506, .largest_n = 90});
}
