/* fast_merge.c - the merge of page 3.7 on half-edges without triangles.
 *
 * The names of the steps are those of merge.c. What is faster: to take a triangle away
 * is to unlink one edge, and to make one is to link one; the points lie in the order of
 * their numbers; and all questions about the rising edge lr are asked as seen from l,
 * so that they share their arithmetic.
 */
#include "chapters/3.7_divide_and_conquer/fast_parts.h"

#include "chapters/3.4_primitives/predicates.h"

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

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

/* Links e between the half-edge f and the one counterclockwise of it; all leave the same
 * site. */
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

/* ---- Questions. ---- */

/* Each is tried in rounded arithmetic. The answer stands when the determinant exceeds
 * what roundings can have changed for any sites in the box (P2), or when all numbers
 * are whole multiples of a unit and so few that none of them was rounded (P3). */

void
fast_bounds(fast_run *run, double width, double height, double unit)
{
    double most = 0x1.01p0 * (width * width + height * height); /* squared length */
    run->sure_turn = 0x1p-51 * most + DBL_MIN;
    run->sure_circle = 0x1.1p-48 * most * most + 0x1p-998 * (1 + most);
    run->whole_turn = 0x1p53 * unit * unit;
    run->whole_circle = 0x1p27 * unit * unit;
}

static point2
at(const fast_run *run, uint32_t site)
{
    return (point2){run->site[site].x, run->site[site].y};
}

/* Another site as seen from the left end l of the rising edge: the vector to it, its
 * squared length, and the cross product with the vector to the right end r. */
typedef struct seen {
    double x, y, lift, turn;
} seen;

static inline seen
see(point2 l, seen r, point2 p)
{
    double x = p.x - l.x, y = p.y - l.y;
    return (seen){x, y, x * x + y * y, r.x * y - r.y * x};
}

/* The sign of orient2d when the rounded determinant is too small to be sure. */
static int
near_turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r, double det)
{
    point2 a = at(run, p), b = at(run, q), c = at(run, r);
    double x = fmax(fabs(a.x - c.x), fabs(b.x - c.x));
    double y = fmax(fabs(a.y - c.y), fabs(b.y - c.y));
    if (2 * x * y < run->whole_turn)
        return (det > 0) - (det < 0);
    return cross_sign(a, c, b, c);
}

/* Is p strictly left of the line from l to r? */
static inline bool
is_above(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, seen ps)
{
    PREDICATE_COUNT(orient2d);
    if (ps.turn > run->sure_turn)
        return true;
    if (ps.turn < -run->sure_turn)
        return false;
    return near_turn(run, l, r, p, ps.turn) > 0;
}

/* The sign of orient2d. */
static inline int
turn(const fast_run *run, uint32_t p, uint32_t q, uint32_t r)
{
    point2 a = at(run, p), b = at(run, q), c = at(run, r);
    double det = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    PREDICATE_COUNT(orient2d);
    if (det > run->sure_turn)
        return +1;
    if (det < -run->sure_turn)
        return -1;
    return near_turn(run, p, q, r, det);
}

/* Does q lie strictly inside the circle of l, r and p, when it is hard to say? */
static bool
near_circle(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, uint32_t q,
            double det, double lifts)
{
    if (lifts < run->whole_circle) {
        PREDICATE_COUNT(incircle);
        return det > 0;
    }
    return incircle(at(run, l), at(run, r), at(run, p), at(run, q)) > 0;
}

/* Does q lie strictly inside the circle of l, r and p? Requires: p is above lr. */
static inline bool
is_inside(const fast_run *run, uint32_t l, uint32_t r, uint32_t p, uint32_t q, seen rs,
          seen ps, seen qs)
{
    double det = ps.lift * qs.turn - qs.lift * ps.turn -
                 rs.lift * (ps.x * qs.y - ps.y * qs.x);
    if (det > run->sure_circle) {
        PREDICATE_COUNT(incircle);
        return true;
    }
    if (det < -run->sure_circle) {
        PREDICATE_COUNT(incircle);
        return false;
    }
    return near_circle(run, l, r, p, q, det, rs.lift + ps.lift + qs.lift);
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
    int side = turn(run, a, b, c);
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
            if (turn(run, p, l, r) < 0) {
                left = before;
                l = p;
                continue;
            }
        }
        if (right != NONE) {
            uint32_t q = edge[right ^ 1].origin;
            if (turn(run, r, q, l) < 0) {
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
        point2 eye = at(run, l), far = at(run, r);
        seen rs = {far.x - eye.x, far.y - eye.y, 0, 0};
        rs.lift = rs.x * rs.x + rs.y * rs.y;

        halfedge_id ly = edge[lr].ccw;                          // Step 3
        uint32_t y = edge[ly ^ 1].origin;
        seen ys = see(eye, rs, at(run, y));
        bool left = y != r && is_above(run, l, r, y, ys);
        while (left) {
            halfedge_id lz = edge[ly].ccw;
            uint32_t z = edge[lz ^ 1].origin;
            if (z == r)
                break;
            seen zs = see(eye, rs, at(run, z));
            if (!is_inside(run, l, r, y, z, rs, ys, zs))
                break;
            delete_edge(run, pool, ly);
            ly = lz;
            y = z;
            ys = zs;
        }

        halfedge_id rx = run->cw[lr ^ 1];                       // Step 4
        uint32_t x = edge[rx ^ 1].origin;
        seen xs = see(eye, rs, at(run, x));
        bool right = x != l && is_above(run, l, r, x, xs);
        while (right) {
            halfedge_id rz = run->cw[rx];
            uint32_t z = edge[rz ^ 1].origin;
            if (z == l)
                break;
            seen zs = see(eye, rs, at(run, z));
            if (!is_inside(run, l, r, x, z, rs, xs, zs))
                break;
            delete_edge(run, pool, rx);
            rx = rz;
            x = z;
            xs = zs;
        }

        if (!left && !right)                                    // Step 5
            break;
        if (!left || (right && is_inside(run, l, r, y, x, rs, ys, xs))) { // Step 6
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
