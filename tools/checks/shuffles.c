/* shuffles.c - a tree of random numbers, leaf by leaf. */
#include "tools/checks/shuffles.h"

#include "tools/checks/room.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ITEMS = 5, MOST_ORDERS = 120, MOST_LEAVES = 4000 };

/* ---- Fractions. ---- */

typedef struct fraction {
    uint64_t over, under;
} fraction;

static uint64_t
common_divisor(uint64_t a, uint64_t b)
{
    while (b != 0) {
        uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* f + 1/under. false: the numbers are too large. */
static bool
add_share(fraction *f, uint64_t under)
{
    uint64_t times = under / common_divisor(f->under, under);
    if (f->under > UINT32_MAX || times > UINT32_MAX / f->under)
        return false;
    uint64_t all = f->under * times;
    f->over = f->over * times + all / under;
    uint64_t divisor = common_divisor(f->over, all);
    *f = (fraction){f->over / divisor, all / divisor};
    return true;
}

/* ---- Orders. ---- */

/* The number of an order of 0 .. count-1 among all of them, from first to last. */
static uint32_t
rank_of(const uint32_t *order, uint32_t count)
{
    uint32_t rank = 0;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t smaller = 0;
        for (uint32_t j = i + 1; j < count; j++)
            smaller += order[j] < order[i];
        rank = rank * (count - i) + smaller;
    }
    return rank;
}

static void
order_of(uint32_t rank, uint32_t count, uint32_t *order)
{
    for (uint32_t i = count; i-- > 0;) {
        order[i] = rank % (count - i);
        rank /= count - i;
        for (uint32_t j = i + 1; j < count; j++)
            order[j] += order[j] >= order[i];
    }
}

/* "a b c" */
static const char *
letters_of(const uint32_t *order, uint32_t count, char text[2 * MOST_ITEMS + 1])
{
    for (uint32_t i = 0; i < count; i++) {
        text[2 * i] = (char)('a' + order[i]);
        text[2 * i + 1] = i + 1 < count ? ' ' : '\0';
    }
    return text;
}

/* The items of an answer between their two neighbours; each once, or the trial
 * fails. */
static void
take_order(session *s, uint32_t count, uint32_t *order)
{
    bool *seen = room_for(count, sizeof *seen);
    expect(s, take_number(s, 0, UINT32_MAX, "what stands before the items") == 0,
           "the shuffle of %lu items writes before the first of them",
           (unsigned long)count);
    for (uint32_t i = 0; i < count && !failed(s); i++) {
        uint32_t item = take_number(s, 0, UINT32_MAX, "an item");
        expect(s, failed(s) || (1 <= item && item <= count),
               "after the shuffle of %lu items there is something among them that was "
               "not there before", (unsigned long)count);
        expect(s, failed(s) || !seen[item - 1],
               "after the shuffle of %lu items item %lu is there twice, and another is "
               "lost", (unsigned long)count, (unsigned long)item);
        if (!failed(s)) {
            seen[item - 1] = true;
            order[i] = item - 1;
        }
    }
    expect(s, take_number(s, 0, UINT32_MAX, "what stands behind the items") == 0,
           "the shuffle of %lu items writes behind the last of them",
           (unsigned long)count);
    take_end(s);
    free(seen);
}

/* ---- The tree. ---- */

/* A leaf: the numbers chosen on the way, and below what each had to be. */
typedef struct leaf {
    uint32_t chosen[MOST_DRAWN], below[MOST_DRAWN], depth;
} leaf;

/* Asks for the leaf at the end of the way chosen[0 .. depth-1], then always 0. */
static void
visit_leaf(session *s, leaf *l, uint32_t count, uint32_t *order)
{
    begin_case(s, 'd', NULL, 0);
    give_number(s, 0);
    give_number(s, count);
    choose(s, l->chosen, l->depth);
    if (!ask(s))
        return;
    const questions *q = questions_of(s);
    take_order(s, count, order);
    bool same = q->drawn >= l->depth;
    for (uint32_t i = 0; same && i < l->depth; i++)
        same = l->below[i] == q->below[i];
    expect(s, same,
           "with the same random numbers the shuffle asks for others than before");
    for (uint32_t i = l->depth; i < q->drawn; i++)
        l->chosen[i] = 0;
    memcpy(l->below, q->below, sizeof l->below);
    l->depth = q->drawn;
}

/* The way to the next leaf. false: this was the last. */
static bool
turn_to_next(leaf *l)
{
    while (l->depth > 0) {
        uint32_t last = l->depth - 1;
        if (++l->chosen[last] < l->below[last])
            return true;
        l->depth--;
    }
    return false;
}

/* Visits all leaves; adds up their probabilities. Returns how many. */
static uint32_t
visit_all(session *s, uint32_t count, fraction *of)
{
    leaf l = {.depth = 0};
    uint32_t leaves = 0, order[MOST_ITEMS] = {0};
    do {
        visit_leaf(s, &l, count, order);
        uint64_t under = 1; /* the leaf has probability 1/under */
        for (uint32_t i = 0; i < l.depth && !failed(s); i++)
            under = under <= UINT32_MAX ? under * l.below[i] : under;
        expect(
            s, failed(s) || l.depth > 0 || count < 2,
            "the shuffle asks for no random number: %lu items always come in the same "
            "order",
            (unsigned long)count);
        leaves++;
        expect(
            s,
            leaves <= MOST_LEAVES && under <= UINT32_MAX &&
                add_share(&of[rank_of(order, count)], under),
            "for %lu items the random numbers can come in more than %d ways, which is "
            "too many to look at: ask for numbers below 2, 3 and so on, up to the "
            "number of items",
            (unsigned long)count, MOST_LEAVES);
    } while (!failed(s) && turn_to_next(&l));
    return leaves;
}

void
check_shuffles(session *s, uint32_t count, bool fair)
{
    assert(count <= MOST_ITEMS);
    fraction of[MOST_ORDERS];
    uint32_t orders = 1, order[MOST_ITEMS];
    char text[2 * MOST_ITEMS + 1];
    for (uint32_t i = 2; i <= count; i++)
        orders *= i;
    for (uint32_t i = 0; i < orders; i++)
        of[i] = (fraction){0, 1};
    uint32_t leaves = visit_all(s, count, of);
    for (uint32_t i = 0; i < orders && !failed(s); i++) {
        order_of(i, count, order);
        expect(s, of[i].over > 0, "the order %s of %lu items never comes",
               letters_of(order, count, text), (unsigned long)count);
        expect(s, !fair || (of[i].over == 1 && of[i].under == orders),
               "the order %s of %lu items comes with probability %llu/%llu instead of "
               "1/%lu: the random numbers can come in %lu ways",
               letters_of(order, count, text), (unsigned long)count,
               (unsigned long long)of[i].over, (unsigned long long)of[i].under,
               (unsigned long)orders, (unsigned long)leaves);
    }
}

void
check_long_shuffle(session *s, uint32_t count)
{
    uint32_t *order = room_for(count, sizeof *order);
    begin_case(s, 'd', NULL, 0);
    give_number(s, 1 + random_below(trial_random(s), 1000000));
    give_number(s, count);
    if (ask(s))
        take_order(s, count, order);
    free(order);
}
