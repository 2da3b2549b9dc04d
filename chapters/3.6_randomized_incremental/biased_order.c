/* biased_order.c - rounds of doubling size, each along a curve. */
#include "chapters/3.6_randomized_incremental/biased_order.h"

#include "lib/memory.h"
#include "lib/sort.h"

#include <string.h>

/* ---- The curve. ---- */

/* Points travel with their indices, so that looking at them does not jump about. */
typedef struct site {
    point2 at;
    vertex_id id;
} site;

/* A part of the sites, and whether the curve runs down in x and in y. */
typedef struct part {
    site *site;
    uint32_t count;
    bool down_x, down_y;
} part;

/* Where a part is cut. Below are the coordinates less than `at`, and those equal to
 * it only if there are no others. */
typedef struct cut {
    bool across_x; /* else across y */
    double at;
    bool at_is_below;
} cut;

static double
coordinate(const site *s, bool x)
{
    return x ? s->at.x : s->at.y;
}

static double
middle_of(double a, double b, double c)
{
    double low = a < b ? a : b, high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

/* A cut across the longer side of the box, at the middle of three random points;
 * something is on both sides. False if all points are at one location. */
static bool
choose_cut(part p, random_source *random, cut *chosen)
{
    point2 least = p.site[0].at, most = least;
    for (uint32_t i = 1; i < p.count; i++) {
        point2 q = p.site[i].at;
        least.x = q.x < least.x ? q.x : least.x;
        least.y = q.y < least.y ? q.y : least.y;
        most.x = q.x > most.x ? q.x : most.x;
        most.y = q.y > most.y ? q.y : most.y;
    }
    bool x = most.x - least.x >= most.y - least.y; /* infinite, if need be */
    double sample[3];
    for (int i = 0; i < 3; i++)
        sample[i] = coordinate(&p.site[random_below(random, p.count)], x);
    double at = middle_of(sample[0], sample[1], sample[2]);
    *chosen = (cut){x, at, at == (x ? least.x : least.y)};
    return least.x < most.x || least.y < most.y;
}

/* Puts the side through which the curve runs first before the other, and returns how
 * many points it has. On both sides their order stays. */
static uint32_t
divide(part p, cut c, site *spare)
{
    bool down = c.across_x ? p.down_x : p.down_y;
    uint32_t first = 0, second = 0;
    for (uint32_t i = 0; i < p.count; i++) {
        double q = coordinate(&p.site[i], c.across_x);
        bool below = c.at_is_below ? q <= c.at : q < c.at;
        p.site[first] = spare[second] = p.site[i]; /* one of them counts */
        first += below != down;
        second += below == down;
    }
    memcpy(p.site + first, spare, second * sizeof *spare);
    return first;
}

/* Sorts p along the curve. It runs across a cut once, and along the cut it runs through
 * one side up and through the other down. Two points are left as they are. */
static void
sort_along_curve(part p, site *spare, random_source *random)
{
    cut c;
    while (p.count > 2 && choose_cut(p, random, &c)) {
        uint32_t k = divide(p, c, spare);
        part first = {p.site, k, p.down_x, p.down_y};
        part second = {p.site + k, p.count - k, p.down_x, p.down_y};
        if (c.across_x)
            second.down_y = !p.down_y;
        else
            second.down_x = !p.down_x;
        bool first_is_smaller = k < p.count - k; /* so at most log2 n calls deep */
        sort_along_curve(first_is_smaller ? first : second, spare, random);
        p = first_is_smaller ? second : first;
    }
}

/* A cut does not separate copies of a point, nor change their order. */
tri_status
along_curve(const point2 *points, uint32_t n, random_source *random, vertex_id *order,
            uint32_t *locations)
{
    *locations = 0;
    site *sorted = memory_array(n, 2 * sizeof *sorted);
    if (sorted == NULL)
        return TRI_OUT_OF_MEMORY;
    for (vertex_id v = 0; v < n; v++)
        sorted[v] = (site){points[v], v};
    sort_along_curve((part){sorted, n, false, false}, sorted + n, random);
    for (uint32_t i = 0; i < n; i++) {
        bool repeated = i > 0 && sorted[i - 1].at.x == sorted[i].at.x &&
                        sorted[i - 1].at.y == sorted[i].at.y;
        if (!repeated)
            order[(*locations)++] = sorted[i].id;
    }
    memory_free(sorted);
    return TRI_OK;
}

/* ---- The rounds. ---- */

enum { LAST_ROUND = 63 };

/* The last round if a coin shows heads, else the one before if it does then, ... */
static uint32_t
toss_for_round(random_source *random)
{
    uint64_t coins = random_bits(random);
    uint32_t round = LAST_ROUND;
    for (; coins % 2 == 0 && round > 0; coins /= 2)
        round--;
    return round;
}

tri_status
biased_order(const point2 *points, uint32_t n, random_source *random, vertex_id *order,
             uint32_t *locations)
{
    tri_status status = along_curve(points, n, random, order, locations);
    if (status != TRI_OK)
        return status;
    uint32_t count = *locations;
    sort_item *item = memory_array(count, 2 * sizeof *item);
    if (item == NULL) {
        *locations = 0;
        return TRI_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++)
        item[i] = (sort_item){toss_for_round(random), order[i]};
    sort_by_key(item, item + count, count); /* within a round the order stays */
    for (uint32_t i = 0; i < count; i++)
        order[i] = item[i].id;
    memory_free(item);
    return TRI_OK;
}

tri_status
biased_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                   mesh *out)
{
    *out = (mesh){0};
    tri_options used;
    tri_status status = tri_accept(points, n, options, &used);
    if (status != TRI_OK)
        return status;
    vertex_id *order = memory_array(n, sizeof *order);
    if (order == NULL)
        return TRI_OUT_OF_MEMORY;

    uint32_t locations;
    used.locator = TRI_LOCATOR_WALK;
    random_source random = random_from_seed(used.seed);
    status = biased_order(points, n, &random, order, &locations);
    if (status == TRI_OK)
        status = insert_in_order(points, n, order, locations, &used, out);
    memory_free(order);
    return status;
}
