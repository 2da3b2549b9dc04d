/* biased_order.c - rounds of doubling size, each along a space-filling curve. */
#include "chapters/3.6_randomized_incremental/biased_order.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "lib/memory.h"
#include "lib/sort.h"

/* ---- The curve. ---- */

enum { CURVE_BITS = 16 }; /* of each coordinate */

/* The curve runs through the quarters of a square in one of four ways. For the lower
 * left, upper left, lower right, upper right quarter: when is its turn, and in which
 * way does the curve run through it, so that it ends beside the next? */
typedef struct curve_way {
    unsigned char turn[4], inside[4];
} curve_way;

static const curve_way way[4] = {
    {{0, 1, 3, 2}, {1, 0, 3, 0}}, /* from the lower left to the lower right */
    {{0, 3, 1, 2}, {0, 2, 1, 1}}, /* from the lower left to the upper left */
    {{2, 3, 1, 0}, {2, 1, 2, 3}}, /* from the upper right to the upper left */
    {{2, 1, 3, 0}, {3, 3, 0, 2}}, /* from the upper right to the lower right */
};

uint32_t
curve_place(uint32_t x, uint32_t y)
{
    uint32_t along = 0, w = 0;
    for (int bit = CURVE_BITS - 1; bit >= 0; bit--) {
        uint32_t quarter = 2 * (x >> bit & 1) + (y >> bit & 1);
        along = 4 * along + way[w].turn[quarter];
        w = way[w].inside[quarter];
    }
    return along;
}

/* In which of the cells between `least` and `most` does c lie? Halves, so that the
 * difference of two coordinates is no infinity. */
static uint32_t
cell(double c, double least, double most)
{
    const double cells = 1u << CURVE_BITS;
    double width = most / 2 - least / 2;
    double at = (c / 2 - least / 2) / width * cells;
    if (!(at >= 0)) /* the width is 0 */
        return 0;
    return at < cells ? (uint32_t)at : (1u << CURVE_BITS) - 1;
}

/* ---- The rounds. ---- */

/* Place i of a random order is in the round of its highest bit: half of the points
 * are in the last round, half of the others in the one before, and so on. */
static uint32_t
round_of(uint32_t i)
{
    uint32_t number = 0;
    for (; i > 0; i /= 2)
        number++;
    return number;
}

tri_status
biased_order(const point2 *points, vertex_id *L, uint32_t count, random_source *random)
{
    shuffle(L, count, random);
    sort_item *item = memory_array(count, 2 * sizeof *item);
    if (item == NULL)
        return TRI_OUT_OF_MEMORY;

    point2 least = {0, 0}, most = {0, 0};
    for (uint32_t i = 0; i < count; i++) {
        point2 p = points[L[i]];
        least.x = i == 0 || p.x < least.x ? p.x : least.x;
        least.y = i == 0 || p.y < least.y ? p.y : least.y;
        most.x = i == 0 || p.x > most.x ? p.x : most.x;
        most.y = i == 0 || p.y > most.y ? p.y : most.y;
    }
    for (uint32_t i = 0; i < count; i++) {
        point2 p = points[L[i]];
        uint32_t along = curve_place(cell(p.x, least.x, most.x),
                                     cell(p.y, least.y, most.y));
        item[i] = (sort_item){(uint64_t)round_of(i) << 32 | along, L[i]};
    }
    sort_by_key(item, item + count, count);
    for (uint32_t i = 0; i < count; i++)
        L[i] = item[i].id;
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
    vertex_id *L = memory_array(n, sizeof *L);
    if (L == NULL)
        return TRI_OUT_OF_MEMORY;

    uint32_t locations;
    used.locator = TRI_LOCATOR_WALK;
    random_source random = random_from_seed(used.seed);
    status = sort_along(points, n, (point2){1, 0}, L, &locations);
    if (status == TRI_OK)
        status = biased_order(points, L, locations, &random);
    if (status == TRI_OK)
        status = insert_in_order(points, n, L, locations, &used, out);
    memory_free(L);
    return status;
}
