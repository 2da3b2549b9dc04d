/* region.c - Definition 5: a Voronoi region, half-plane by half-plane. */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

static const point2 along_x = {1, 0};

/* ---- Directions around p. ---- */

/* Do q and r lie in the same direction from p? Requires: p, q, r are collinear
 * and p is neither of them. Then both come after p along the x axis, or both
 * before. */
static bool
same_side(point2 p, point2 q, point2 r)
{
    return compare_along(along_x, p, q) == compare_along(along_x, p, r);
}

/* Turning left from the direction of `from`: is q met before the half turn? */
static bool
in_first_half(point2 p, point2 from, point2 q)
{
    int side = orient2d(p, from, q);
    return side > 0 || (side == 0 && same_side(p, from, q));
}

/* Turning left around p from the direction of `from`: is q met before r (-1),
 * after it (+1), or at the same time (0)? */
static int
compare_turn(point2 p, point2 from, point2 q, point2 r)
{
    bool q_first = in_first_half(p, from, q),
         r_first = in_first_half(p, from, r);
    if (q_first != r_first)
        return q_first ? -1 : +1;
    return -orient2d(p, q, r);
}

/* ---- One half-plane more. ---- */

/* The region so far, and as much room again. */
typedef struct builder {
    voronoi_region region;
    vertex_id *turned; /* the same sites, counterclockwise from another one */
} builder;

/* Is the half-plane of b implied by those of a and c, between whose directions
 * it lies? Less than a half turn apart, the bisectors of a and c meet in the
 * centre of the circle through p, a and c, and nothing of the two half-planes
 * reaches further in the direction of b. So b cuts something off exactly when
 * it cuts off that point: when b lies strictly inside the circle. */
static bool
is_redundant(const point2 *points, vertex_id p, vertex_id a, vertex_id b,
             vertex_id c)
{
    return orient2d(points[p], points[a], points[c]) > 0 &&
           incircle(points[p], points[a], points[c], points[b]) <= 0;
}

/* Lists the sites counterclockwise from the first that is not met before q. */
static void
turn_to(builder *b, const point2 *points, vertex_id p, vertex_id q)
{
    const vertex_id *site = b->region.neighbour;
    uint32_t size = b->region.size, before = 0;
    while (before < size && compare_turn(points[p], points[site[0]],
                                         points[site[before]], points[q]) < 0)
        before++;
    for (uint32_t i = 0; i < size; i++)
        b->turned[i] = site[(before + i) % size];
}

/* Intersects the region with H_pq. What the bisector of q cuts off, it cuts off
 * around the direction of q: the sites that become redundant are next to it. */
static void
cut(builder *b, const point2 *points, vertex_id p, vertex_id q)
{
    turn_to(b, points, p, q); // Step 1: find the direction of q.
    const vertex_id *site = b->turned;
    uint32_t first = 0, end = b->region.size; /* site[first .. end-1] remain */
    if (end > 0 && compare_turn(points[p], points[site[0]], points[site[0]],
                                points[q]) == 0) {
        if (compare_distance(points[p], points[q], points[p],
                             points[site[0]]) >= 0)
            return; // Step 2: of two in one direction the nearer one counts.
        first = 1;
    }
    if (end - first >= 2 &&
        is_redundant(points, p, site[end - 1], q, site[first]))
        return; // Step 3: q's bisector misses the region, or only touches it.
    while (end - first >= 2 &&
           is_redundant(points, p, site[end - 2], site[end - 1], q))
        end--; // Step 4: q cuts off the edges before it,
    while (end - first >= 2 &&
           is_redundant(points, p, q, site[first], site[first + 1]))
        first++; // and those after it.

    b->region.neighbour[0] = q; // Step 5: what is left, and q.
    for (uint32_t i = first; i < end; i++)
        b->region.neighbour[1 + i - first] = site[i];
    b->region.size = 1 + end - first;
}

/* ---- The region. ---- */

/* Is the region of p unbounded between its neighbouring sites q and r? */
static bool
is_gap(const point2 *points, vertex_id p, vertex_id q, vertex_id r)
{
    return orient2d(points[p], points[q], points[r]) <= 0;
}

/* Where the list is to begin: after a gap if there is one, else (and of two) at
 * the lowest index. */
static uint32_t
beginning(const voronoi_region *r, const point2 *points, vertex_id p)
{
    uint32_t best = 0;
    bool best_is_after_gap = false;
    for (uint32_t i = 0; i < r->size; i++) {
        vertex_id before = r->neighbour[(i + r->size - 1) % r->size];
        bool after_gap = is_gap(points, p, before, r->neighbour[i]);
        if (after_gap > best_is_after_gap ||
            (after_gap == best_is_after_gap &&
             r->neighbour[i] < r->neighbour[best])) {
            best = i;
            best_is_after_gap = after_gap;
        }
    }
    return best;
}

tri_status
voronoi_region_of(const point2 *points, uint32_t n, vertex_id p,
                  voronoi_region *out)
{
    *out = (voronoi_region){0};
    builder b = {{0, memory_array(n, sizeof *b.turned)},
                 memory_array(n, sizeof *b.turned)};
    if (b.region.neighbour == NULL || b.turned == NULL) {
        voronoi_region_free(&b.region);
        memory_free(b.turned);
        return TRI_OUT_OF_MEMORY;
    }
    for (vertex_id q = 0; q < n; q++)
        if (compare_along(along_x, points[p], points[q]) != 0)
            cut(&b, points, p, q);

    uint32_t begin = beginning(&b.region, points, p);
    for (uint32_t i = 0; i < b.region.size; i++)
        b.turned[i] = b.region.neighbour[(begin + i) % b.region.size];
    *out = (voronoi_region){b.region.size, b.turned};
    memory_free(b.region.neighbour);
    return TRI_OK;
}

void
voronoi_region_free(voronoi_region *region)
{
    memory_free(region->neighbour);
    *region = (voronoi_region){0};
}
