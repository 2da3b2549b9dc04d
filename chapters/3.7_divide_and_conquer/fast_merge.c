/* fast_merge.c - the merge of page 3.7 on half-edges without triangles.
 *
 * The names of the steps are those of merge.c. What is faster: to take a triangle away
 * is to unlink one edge, and to make one is to link one; the points lie in the order of
 * their numbers; and how a site sees the rising edge lr is computed once, for all
 * questions about them.
 */
#include "chapters/3.7_divide_and_conquer/fast_questions.h"

/* ---- Edges: taken from the pool, linked, unlinked. ---- */

fast_pool
fast_pool_of(uint32_t lo, uint32_t count)
{
    return (fast_pool){6 * lo, 6 * (lo + count), NONE, NONE};
}

/* An edge between two sites, not linked yet; returns the half-edge from p to q. */
static halfedge_id
new_edge(const fast_run *run, fast_pool *pool, uint32_t p, uint32_t q)
{
    halfedge_id e = pool->first;
    if (e != NONE) {
        pool->first = run->edge[e].ccw;
    } else {
        assert(pool->fresh < pool->end);
        e = pool->fresh;
        pool->fresh += 2;
    }
    run->edge[e].origin = p;
    run->edge[e ^ 1].origin = q;
    return e;
}

/* A half-edge that is not in use is its own neighbour across its twin: for
 * fast_export.c that is no corner of a triangle. */
static void
release(const fast_run *run, fast_pool *pool, halfedge_id e)
{
    e &= ~(halfedge_id)1;
    run->edge[e] = (fast_edge){NONE, pool->first};
    run->edge[e ^ 1].origin = NONE;
    run->cw[e] = e ^ 1;
    run->cw[e ^ 1] = e;
    if (pool->first == NONE)
        pool->last = e;
    pool->first = e;
}

void
fast_pool_close(const fast_run *run, fast_pool *pool)
{
    for (; pool->fresh < pool->end; pool->fresh += 2)
        release(run, pool, pool->fresh);
}

fast_pool
fast_pool_join(const fast_run *run, fast_pool a, fast_pool b)
{
    if (a.first == NONE)
        return b;
    if (b.first != NONE) {
        run->edge[a.last].ccw = b.first;
        a.last = b.last;
    }
    return a;
}

/* Links e between the half-edge f and the one counterclockwise of it; all leave the
 * same site. */
static void
link_after(const fast_run *run, halfedge_id f, halfedge_id e)
{
    halfedge_id g = run->edge[f].ccw;
    run->cw[e] = f;
    run->edge[e].ccw = g;
    run->edge[f].ccw = e;
    run->cw[g] = e;
}

static void
link_alone(const fast_run *run, halfedge_id e)
{
    run->edge[e].ccw = run->cw[e] = e;
}

/* Takes e away from its origin, which has other edges. */
static void
detach(const fast_run *run, halfedge_id e)
{
    halfedge_id f = run->cw[e], g = run->edge[e].ccw;
    fast_site *origin = &run->site[run->edge[e].origin];
    run->edge[f].ccw = g;
    run->cw[g] = f;
    if (origin->edge == e)
        origin->edge = g;
}

static void
delete_edge(const fast_run *run, fast_pool *pool, halfedge_id e)
{
    detach(run, e);
    detach(run, e ^ 1);
    release(run, pool, e);
}

/* ---- Two and three sites. ---- */

/* An edge between two sites that have none yet. */
static halfedge_id
lone_edge(const fast_run *run, fast_pool *pool, uint32_t p, uint32_t q)
{
    halfedge_id e = new_edge(run, pool, p, q);
    link_alone(run, e);
    link_alone(run, e ^ 1);
    run->site[p].edge = e;
    run->site[q].edge = e ^ 1;
    return e;
}

void
fast_few(const fast_run *run, fast_pool *pool, uint32_t lo, uint32_t count)
{
    run->site[lo].edge = NONE;
    if (count == 1)
        return;
    uint32_t a = lo, b = lo + 1, c = lo + 2;
    halfedge_id ab = lone_edge(run, pool, a, b);
    if (count == 2)
        return;
    int side = fast_turn(run, a, b, c);
    halfedge_id bc = new_edge(run, pool, b, c);
    link_after(run, ab ^ 1, bc);
    link_alone(run, bc ^ 1);
    run->site[c].edge = bc ^ 1;
    if (side == 0)
        return;
    halfedge_id ca = new_edge(run, pool, c, a);
    link_after(run, bc ^ 1, ca);
    link_after(run, ab, ca ^ 1);
    if (side > 0) {
        run->site[b].edge = bc;
        run->site[c].edge = ca;
    } else {
        run->site[a].edge = ca ^ 1;
    }
}

/* ---- Steps 1 and 2: the first edge between left and right. ---- */

typedef struct tangent {
    uint32_t l, r;
} tangent;

/* While the right end sees the hull edge that arrives at the left end, or the left end
 * the one that leaves the right end, there is something below. */
static tangent
lower_tangent(const fast_run *run, uint32_t l, uint32_t r)
{
    const fast_edge *edge = run->edge;
    halfedge_id left = run->site[l].edge, right = run->site[r].edge;
    for (;;) {
        if (left != NONE) {
            halfedge_id before = run->cw[left] ^ 1;
            uint32_t p = edge[before].origin;
            if (fast_turn(run, p, l, r) < 0) {
                left = before;
                l = p;
                continue;
            }
        }
        if (right != NONE) {
            uint32_t q = edge[right ^ 1].origin;
            if (fast_turn(run, r, q, l) < 0) {
                right = edge[right ^ 1].ccw;
                r = q;
                continue;
            }
        }
        return (tangent){l, r};
    }
}

/* Links e, which leaves a site on the hull, into the outside there. */
static void
link_outside(const fast_run *run, halfedge_id e)
{
    halfedge_id along = run->site[run->edge[e].origin].edge;
    if (along == NONE)
        link_alone(run, e);
    else
        link_after(run, run->cw[along], e);
}

/* ---- The merge. ---- */

void
fast_merge(const fast_run *run, fast_pool *pool, uint32_t v, uint32_t w)
{
    fast_edge *edge = run->edge;
    tangent lowest = lower_tangent(run, v, w);                  // Step 1
    uint32_t l = lowest.l, r = lowest.r;
    halfedge_id lr = new_edge(run, pool, l, r);                 // Step 2
    link_outside(run, lr);
    link_outside(run, lr ^ 1);
    run->site[l].edge = lr;
    for (;;) {
        halfedge_id ly = edge[lr].ccw;                          // Step 3
        uint32_t y = edge[ly ^ 1].origin;
        fast_view ys = fast_look(run, y, l, r);
        bool left = y != r && fast_is_above(run, l, r, y, ys);
        while (left) {
            halfedge_id lz = edge[ly].ccw;
            uint32_t z = edge[lz ^ 1].origin;
            if (z == r)
                break;
            fast_view zs = fast_look(run, z, l, r);
            if (!fast_is_inside(run, l, r, y, z, ys, zs))
                break;
            delete_edge(run, pool, ly);
            ly = lz;
            y = z;
            ys = zs;
        }

        halfedge_id rx = run->cw[lr ^ 1];                       // Step 4
        uint32_t x = edge[rx ^ 1].origin;
        fast_view xs = fast_look(run, x, l, r);
        bool right = x != l && fast_is_above(run, l, r, x, xs);
        while (right) {
            halfedge_id rz = run->cw[rx];
            uint32_t z = edge[rz ^ 1].origin;
            if (z == l)
                break;
            fast_view zs = fast_look(run, z, l, r);
            if (!fast_is_inside(run, l, r, x, z, xs, zs))
                break;
            delete_edge(run, pool, rx);
            rx = rz;
            x = z;
            xs = zs;
        }

        if (!left && !right)                                    // Step 5
            break;
        if (!left || (right && fast_is_inside(run, l, r, y, x, ys, xs))) { // Step 6
            halfedge_id lx = new_edge(run, pool, l, x);
            link_after(run, lr, lx);
            link_after(run, run->cw[rx ^ 1], lx ^ 1);
            lr = lx;
            r = x;
        } else {
            halfedge_id yr = new_edge(run, pool, y, r);
            link_after(run, ly ^ 1, yr);
            link_after(run, rx, yr ^ 1);
            lr = yr;
            l = y;
        }
    }
    run->site[r].edge = lr ^ 1;
}
