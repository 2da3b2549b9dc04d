/* What is replayed is what was meant: splits and flips that a program reports, and the
 * order of its queue, are believed exactly when the geometry and the queue allow them.
 *
 * Hypotheses: none but small integers. Points of a small grid are inserted in random
 * order into a triangulation with the outside; all questions about all triangles are
 * compared with areas. Reports of a queue are made by a queue, and then changed in one
 * place; or by a queue that is not kept as it should be.
 */
#include "tests/harness/sites.h"
#include "tools/checks/cases.h"
#include "tools/checks/certify.h"
#include "tools/checks/meshes.h"
#include "tools/checks/replay.h"
#include "tools/checks/sphere.h"
#include "tools/checks/turns.h"

#include <stdlib.h>
#include <string.h>

/* ---- Triangulations with the outside. ---- */

/* The three corners from side e on; the last is at infinity if any is. */
static void
corners_from(const sphere *s, halfedge_id e, vertex_id c[3])
{
    for (int i = 0; i < 3; i++)
        if (side_apex(s->list, 3 * (e / 3) + (e + (halfedge_id)i) % 3) == s->infinity) {
            e = 3 * (e / 3) + (e + (halfedge_id)i) % 3;
            break;
        }
    c[0] = side_origin(s->list, e);
    c[1] = side_dest(s->list, e);
    c[2] = side_apex(s->list, e);
}

/* How p lies in the triangle, by areas; for an edge, or the end of a path, the two ends
 * of the side that is meant. */
static spot
spot_slowly(const sphere *s, uint32_t p, halfedge_id e, vertex_id *from, vertex_id *to)
{
    vertex_id c[3];
    corners_from(s, e, c);
    const site *at = s->at;
    bool outer = c[2] == s->infinity;
    int inside = 0, sides = outer ? 1 : 3;
    for (int i = 0; i < sides; i++) {
        site a = at[c[i]], b = at[c[(i + 1) % 3]];
        if (area(a, b, at[p]) < 0)
            return SPOT_NOWHERE;
        inside += area(a, b, at[p]) > 0;
        if (is_on_segment(a, at[p], b)) {
            *from = c[i];
            *to = c[(i + 1) % 3];
            return SPOT_EDGE;
        }
    }
    if (inside == sides)
        return SPOT_TRIANGLE;
    bool beyond_b = is_on_segment(at[c[0]], at[c[1]], at[p]);
    vertex_id end = beyond_b ? c[1] : c[0];
    for (halfedge_id f = 0; f < 3 * s->list.count; f++) { /* an end has one edge */
        vertex_id other = side_dest(s->list, f);
        if (side_apex(s->list, f) == s->infinity &&
            (!s->flat || (side_origin(s->list, f) == end && other != c[0] &&
                          other != c[1])))
            return SPOT_NOWHERE;
    }
    *from = end;
    *to = beyond_b ? c[0] : c[1];
    return outer ? SPOT_BEYOND : SPOT_NOWHERE;
}

/* All triangles are asked about p. Returns one where p lies, and how. */
static spot
compare_spots(const sphere *s, uint32_t p, halfedge_id *where)
{
    spot found = SPOT_NOWHERE;
    for (halfedge_id e = 0; e < 3 * s->list.count; e++) {
        vertex_id from = NONE, to = NONE;
        halfedge_id f = e;
        spot right = spot_slowly(s, p, e, &from, &to), said = sphere_spot(s, p, &f);
        CLAIM("certify.spot", said == right, "%u and side %u: %d, and not %d",
              (unsigned)p, (unsigned)e, (int)right, (int)said);
        CLAIM("certify.spot", right == SPOT_NOWHERE || right == SPOT_TRIANGLE ||
                                  (side_origin(s->list, f) == from &&
                                   side_dest(s->list, f) == to),
              "%u lies on %u-%u, or beyond %u", (unsigned)p, (unsigned)from,
              (unsigned)to, (unsigned)from);
        bool has = right != SPOT_NOWHERE;
        vertex_id c[3];
        corners_from(s, e, c);
        if (!s->flat && c[2] == s->infinity) /* in line with a hull edge will do */
            has = area(s->at[c[0]], s->at[c[1]], s->at[p]) >= 0;
        CLAIM("certify.has", sphere_has(s, e / 3, p) == has, "%u, triangle %u",
              (unsigned)p, (unsigned)(e / 3));
        if (right != SPOT_NOWHERE && (found == SPOT_NOWHERE || some(3) == 0)) {
            found = right;
            *where = f;
        }
    }
    return found;
}

/* A closed surface of 2u - 2 triangles: each directed side has a twin. (A vertex
 * between two edges of a path has two sides to infinity, until what is above it is
 * flipped.) None is flat or turned over. */
static void
check_surface(const sphere *s, uint32_t u)
{
    CLAIM("certify.surface", s->list.count == 2 * u - 2, "%u triangles, %u vertices",
          (unsigned)s->list.count, (unsigned)u);
    for (halfedge_id e = 0; e < 3 * s->list.count; e++) {
        vertex_id a = side_origin(s->list, e), b = side_dest(s->list, e), c[3];
        uint32_t along = 0, back = 0;
        for (halfedge_id f = 0; f < 3 * s->list.count; f++) {
            along += side_origin(s->list, f) == a && side_dest(s->list, f) == b;
            back += side_origin(s->list, f) == b && side_dest(s->list, f) == a;
        }
        corners_from(s, e, c);
        uint32_t most = a == s->infinity || b == s->infinity ? 2 : 1;
        CLAIM("certify.surface", along == back && along <= most,
              "%u-%u is there %u times, and %u-%u %u times", (unsigned)a, (unsigned)b,
              (unsigned)along, (unsigned)b, (unsigned)a, (unsigned)back);
        CLAIM("certify.surface",
              c[2] == s->infinity || area(s->at[c[0]], s->at[c[1]], s->at[c[2]]) > 0,
              "%u-%u-%u is not counterclockwise", (unsigned)c[0], (unsigned)c[1],
              (unsigned)c[2]);
    }
}

/* Is there an edge between a and b with p on one side, and on the other a point d that
 * p may be joined to? */
static bool
may_flip(const sphere *s, vertex_id a, vertex_id b, vertex_id p)
{
    for (halfedge_id e = 0; e < 3 * s->list.count; e++)
        for (halfedge_id f = 0; f < 3 * s->list.count; f++) {
            vertex_id from = side_origin(s->list, e), to = side_dest(s->list, e);
            vertex_id d = side_apex(s->list, f);
            bool edge = (from == a && to == b) || (from == b && to == a);
            if (!edge || side_apex(s->list, e) != p || side_origin(s->list, f) != to ||
                side_dest(s->list, f) != from || d == s->infinity)
                continue;
            if ((from == s->infinity || area(s->at[from], s->at[d], s->at[p]) > 0) &&
                (to == s->infinity || area(s->at[d], s->at[to], s->at[p]) > 0))
                return true;
        }
    return false;
}

/* Every pair of vertices is tried; a flip that is allowed gives p one edge more. */
static void
flip_around(sphere *s, uint32_t u, vertex_id p, uint32_t n)
{
    for (uint32_t times = 0; times < 3; times++)
        for (vertex_id a = 0; a <= n; a++)
            for (vertex_id b = 0; b <= n; b++) {
                bool outer = a == n || b == n;
                if (a == b || (!outer && some(4) > 0 && may_flip(s, a, b, p)))
                    continue; /* of those inside some are flipped, of the others all */
                uint32_t degree = sphere_degree(s, p);
                bool right = may_flip(s, a, b, p), done = sphere_flip(s, a, b, p);
                CLAIM("certify.flip", right == done, "%u-%u, opposite %u: %s",
                      (unsigned)a, (unsigned)b, (unsigned)p,
                      done ? "flipped" : "refused");
                CLAIM("certify.flip", sphere_degree(s, p) == degree + done, "%u",
                      (unsigned)p);
                if (done)
                    check_surface(s, u);
            }
}

/* Inserts the points one by one; once no edge to infinity can be flipped, the triangles
 * inside are a triangulation of them. */
static void
insert_in_some_order(const point2 *points, uint32_t n)
{
    (void)points;
    HYPOTHESIS(n >= 2);
    problem p = some_problem(10);
    uint32_t order[MOST], u = cases_locations(p.at, p.n, order);
    HYPOTHESIS(u >= 2);
    for (uint32_t i = u; i > 1; i--) {
        uint32_t j = some(i), chosen = order[j];
        order[j] = order[i - 1];
        order[i - 1] = chosen;
    }
    sphere s = sphere_of(p.at, p.n, (triangle_list){0}, order, 2, u);
    problem so_far = {.n = 2, .at = {p.at[order[0]], p.at[order[1]]}};
    for (uint32_t i = 2; i < u; i++) {
        halfedge_id where = 0;
        spot how = compare_spots(&s, order[i], &where);
        CLAIM("certify.spot", how != SPOT_NOWHERE, "%u lies nowhere",
              (unsigned)order[i]);
        sphere_split(&s, how, where, order[i]);
        CLAIM("certify.split",
              sphere_degree(&s, order[i]) == (how == SPOT_TRIANGLE ? 3u
                                              : how == SPOT_EDGE   ? 4u
                                                                   : 2u),
              "%u has %u edges", (unsigned)order[i],
              (unsigned)sphere_degree(&s, order[i]));
        check_surface(&s, i + 1);
        flip_around(&s, i + 1, order[i], p.n);
        so_far.at[so_far.n++] = p.at[order[i]];
        triangle_list list = sphere_triangles(&s);
        for (uint32_t k = 0; k < 3 * list.count; k++) /* vertex -> place in so_far */
            for (uint32_t v = 0; v <= i; v++)
                if (order[v] == list.corner[k / 3][k % 3]) {
                    list.corner[k / 3][k % 3] = v;
                    break;
                }
        CLAIM("certify.sphere", is_triangulation_slowly(&so_far, list),
              "after %u points it is no triangulation", (unsigned)i + 1);
        triangle_list_free(&list);
    }
    triangle_list_free(&s.list);
}

/* ---- The order of a queue. ---- */

enum { MOST_TURNS = 2000 };

/* How the queue is kept, and what is wrong about that. */
typedef enum manner {
    FAIR,
    STACK,    /* last in, first out */
    CARELESS, /* does not look whether the twin waits */
    EAGER,    /* pushes all edges after a flip */
    LAZY,     /* forgets one side after a flip */
    LATE,     /* forgets one edge at the start */
    MANNERS
} manner;

typedef struct queue {
    manner kept;
    bool wrong; /* has it made a difference? */
    turn report[MOST_TURNS];
    uint32_t count;
    halfedge_id entry[MOST_TURNS];
    uint32_t first, last;
} queue;

static void
tell(queue *q, turn_kind kind, halfedge_id e)
{
    if (q->count == MOST_TURNS)
        abort();
    q->report[q->count++] = (turn){kind, e};
}

static halfedge_id
twin_in(triangle_list list, halfedge_id e)
{
    halfedge_id twin[3 * MOST_LIST];
    certify_twins(list, twin);
    return twin[e];
}

static bool
has(const queue *q, halfedge_id e)
{
    for (uint32_t i = q->first; i < q->last; i++)
        if (q->entry[i] == e)
            return true;
    return false;
}

/* Puts e at the end, unless its edge waits; one on the hull if `hull` says so. */
static bool
enqueue(queue *q, triangle_list list, halfedge_id e, bool hull)
{
    halfedge_id twin = twin_in(list, e);
    if (has(q, e) || (twin == NONE && !hull) || (has(q, twin) && q->kept != CARELESS))
        return false;
    q->wrong |= has(q, twin);
    q->entry[q->last++] = e;
    tell(q, TURN_PUSHED, e);
    return true;
}

static halfedge_id
after(halfedge_id e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* ab becomes dc, and so on: chapters/3.5_edge_flips/flips.h. */
static void
flip_sides(triangle_list list, halfedge_id ab, halfedge_id ba)
{
    vertex_id a = side_origin(list, ab), b = side_origin(list, ba);
    vertex_id c = side_apex(list, ab), d = side_apex(list, ba);
    const vertex_id dca[3] = {d, c, a}, cdb[3] = {c, d, b};
    for (int i = 0; i < 3; i++, ab = after(ab), ba = after(ba)) {
        list.corner[ab / 3][ab % 3] = dca[i];
        list.corner[ba / 3][ba % 3] = cdb[i];
    }
}

static void
push_around(queue *q, triangle_list list, halfedge_id ab, halfedge_id ba, bool hull)
{
    const halfedge_id link[4] = {after(ab), after(after(ab)), after(ba),
                                 after(after(ba))};
    uint32_t first = some(4), skipped = q->kept == LAZY;
    for (uint32_t i = skipped; i < 4; i++) {
        halfedge_id e = link[(first + i) % 4], twin = twin_in(list, e);
        enqueue(q, list, twin != NONE && some(2) == 0 ? twin : e, hull);
    }
    halfedge_id left = link[first], twin = twin_in(list, left);
    q->wrong |= twin != NONE && !has(q, left) && !has(q, twin);
    for (halfedge_id e = 0; q->kept == EAGER && e < 3 * list.count; e++)
        q->wrong |= enqueue(q, list, e, false);
}

/* Figure 10 with the queue. */
static void
flip_all(queue *q, const problem *p, triangle_list list, bool hull)
{
    halfedge_id left = q->kept == LATE && list.count > 0 ? some(3 * list.count) : NONE;
    halfedge_id left_twin = left == NONE ? NONE : twin_in(list, left);
    q->wrong = left_twin != NONE;
    for (halfedge_id e = 0; e < 3 * list.count; e++)
        if (e != left && e != left_twin)
            enqueue(q, list, e, false);
    while (q->first < q->last) {
        q->wrong |= q->kept == STACK && q->last - q->first > 1;
        halfedge_id ab = q->kept == STACK ? q->entry[--q->last] : q->entry[q->first++];
        halfedge_id ba = twin_in(list, ab);
        tell(q, TURN_POPPED, ab);
        if (ba == NONE ||
            plane_incircle(p->at[side_origin(list, ab)], p->at[side_dest(list, ab)],
                           p->at[side_apex(list, ab)], p->at[side_apex(list, ba)]) <= 0)
            continue;
        flip_sides(list, ab, ba);
        tell(q, TURN_FLIPPED, some(2) == 0 ? ab : ba);
        push_around(q, list, ab, ba, hull);
    }
}

static verdict
judge(const problem *p, triangle_list before, const turn *report, uint32_t count)
{
    triangle_list list = copy_triangles(before);
    verdict v = certify_turns(p->at, list, report, count);
    if (v.holds) {
        verdict d = certify_delaunay(p->at, p->n, list);
        CLAIM("certify.queue", d.holds, "accepted, and yet %s", d.because);
    }
    triangle_list_free(&list);
    return v;
}

/* One event is left out, is there twice, changes places with the next, or is about
 * another half-edge. None of that is a queue's report. */
static void
change_reports(const problem *p, triangle_list before, const queue *q)
{
    static turn changed[MOST_TURNS + 1];
    for (int trial = 0; trial < 20; trial++) {
        uint32_t i = some(q->count), count = q->count;
        memcpy(changed, q->report, sizeof q->report);
        int kind = (int)some(4);
        if (kind == 0) {
            memmove(&changed[i], &changed[i + 1], (--count - i) * sizeof *changed);
        } else if (kind == 1) {
            memmove(&changed[i + 1], &changed[i], (count++ - i) * sizeof *changed);
        } else if (kind == 2) {
            if (i + 1 == count)
                continue;
            changed[i] = q->report[i + 1];
            changed[i + 1] = q->report[i];
        } else {
            halfedge_id e = some(3 * before.count);
            if (e == changed[i].e || changed[i].kind == TURN_FLIPPED)
                continue; /* a flip may be told of from either side */
            changed[i].e = e;
        }
        verdict v = judge(p, before, changed, count);
        CLAIM("certify.queue", !v.holds, "event %u of %u, change %d: accepted",
              (unsigned)i, (unsigned)q->count, kind);
    }
}

static void
queues_are_recognised(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    static queue q;
    problem p = some_problem(10);
    triangle_list before = mesh_at_random(test_random_source(), p.at, p.n, false);
    for (q.kept = FAIR; q.kept < MANNERS; q.kept++) {
        triangle_list list = copy_triangles(before);
        q.count = q.first = q.last = 0;
        flip_all(&q, &p, list, some(2) == 0);
        verdict v = judge(&p, before, q.report, q.count);
        CLAIM("certify.queue", v.holds == !q.wrong, "manner %d: %s", (int)q.kept,
              v.holds ? "accepted" : v.because);
        if (q.kept == FAIR && q.count > 0)
            change_reports(&p, before, &q);
        triangle_list_free(&list);
    }
    triangle_list_free(&before);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "What is replayed is what was meant: splits, flips, a queue");
    test_random("points are inserted in some order", insert_in_some_order, 1500, 5);
    test_random("queues are recognised", queues_are_recognised, 1500, 5);
    return test_end((test_minima){.trials = 2900, .largest_n = 5});
}
