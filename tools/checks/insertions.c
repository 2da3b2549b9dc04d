/* insertions.c - splits and flips on a sphere, and the points that wait in it. */
#include "tools/checks/insertions.h"

#include "tools/checks/certify.h"
#include "tools/checks/room.h"
#include "tools/checks/scenes.h"
#include "tools/checks/sphere.h"

#include <math.h>
#include <stdlib.h>

/* The locations in random order. */
static uint32_t
give_order(session *s, const site *at, uint32_t n, uint32_t *order)
{
    uint32_t count = cases_locations(at, n, order);
    for (uint32_t i = count; i > 1; i--) {
        uint32_t j = random_below(trial_random(s), i), chosen = order[j];
        order[j] = order[i - 1];
        order[i - 1] = chosen;
    }
    give_numbers(s, order, count);
    return count;
}

/* What is told of an insertion: found, flipped, moved. */
typedef enum told_kind { TOLD_LOCATE, TOLD_FLIP, TOLD_MOVE } told_kind;

typedef struct told {
    told_kind kind;
    uint32_t p, a, b, c; /* of a point, a triangle; of a flip, the ends a and b */
} told;

static told
take_told(session *s, uint32_t n)
{
    told t;
    t.kind = (told_kind)take_number(s, TOLD_LOCATE, TOLD_MOVE, "what happened");
    t.p = take_number(s, 0, n, "a point");
    t.a = take_number(s, 0, n, "a vertex");
    t.b = take_number(s, 0, n, "a vertex");
    t.c = take_number(s, 0, UINT32_MAX, "a vertex");
    return t;
}

/* The insertion so far. */
typedef struct insertion {
    const site *at;
    uint32_t n;
    const uint32_t *order;
    uint32_t count, inserted;
    sphere now;
    uint32_t (*home)[3]; /* point -> corners of the triangle in which it waits */
    bool *waits;         /* point -> has it been told where? */
    uint32_t moves;
} insertion;

static insertion
begin_insertion(const site *at, uint32_t n, const uint32_t *order, uint32_t count)
{
    insertion in = {.at = at, .n = n, .order = order, .count = count, .inserted = 2};
    in.now = sphere_of(at, n, (triangle_list){0}, order, count < 2 ? count : 2, count);
    in.home = room_for(n, sizeof *in.home);
    in.waits = room_for(n, sizeof *in.waits);
    return in;
}

static void
end_insertion(insertion *in)
{
    triangle_list_free(&in->now.list);
    free(in->home);
    free(in->waits);
}

/* The next point has been found in a triangle: it is split. */
static void
replay_locate(session *s, insertion *in, told t)
{
    expect(s, in->inserted < in->count && in->order[in->inserted] == t.p,
           "%lu is looked for, and it is not its turn", (unsigned long)t.p);
    halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, t.a, t.b, t.c);
    name place = name_of_triangle(in->n, t.a, t.b, t.c);
    expect(s, failed(s) || e != NONE,
           "%lu is found in %s, which is not there after the flips that were reported",
           (unsigned long)t.p, place.text);
    spot how = e != NONE ? sphere_spot(&in->now, t.p, &e) : SPOT_NOWHERE;
    if (expect(s, how != SPOT_NOWHERE,
               "%lu is looked for in %s, and does not lie there", (unsigned long)t.p,
               place.text)) {
        sphere_split(&in->now, how, e, t.p);
        in->inserted++;
    }
}

static void
replay_flip_at(session *s, insertion *in, told t)
{
    uint32_t p = in->order[in->inserted - 1];
    if (!expect(
            s, in->inserted > 2 && sphere_flip(&in->now, t.a, t.b, p),
            "after %lu has been inserted %s is flipped, which is not opposite %lu, or "
            "cannot be flipped: each flip is to give %lu one edge more",
            (unsigned long)p, name_of_edge(in->n, t.a, t.b).text, (unsigned long)p,
            (unsigned long)p)) {
        show_witness(s, p);
        if (t.a < in->n)
            show_witness(s, t.a);
        if (t.b < in->n)
            show_witness(s, t.b);
    }
}

/* The triangulation in which something went wrong. */
static void
show_replay(session *s, const insertion *in)
{
    keep_triangles(s, sphere_triangles(&in->now));
    for (uint32_t e = 0; in->now.flat && e < 3 * in->now.list.count; e++)
        show_edge(s, SVG_PLAIN, side_origin(in->now.list, e),
                  side_dest(in->now.list, e));
}

/* The result, and that of the replay: Delaunay. */
static void
check_result(session *s, const site *at, uint32_t n)
{
    if (!take_ok(s))
        return;
    triangle_list list = take_triangles(s, n, 2 * n);
    if (failed(s) || !expect_verdict(s, certify_delaunay(at, n, list)))
        return;
    if (cases_are_collinear(at, n))
        take_path(s);
}

void
check_insertion(session *s, const site *at, uint32_t n, bool flips)
{
    uint32_t *order = room_for(n, sizeof *order);
    begin_case(s, 'c', at, n);
    give_points(s);
    uint32_t count = give_order(s, at, n, order);
    if (ask(s)) {
        insertion in = begin_insertion(at, n, order, count);
        uint32_t events = take_number(s, 0, 20000, "the number of events");
        for (uint32_t i = 0; i < events && !failed(s); i++) {
            told t = take_told(s, n);
            if (flips && !failed(s) && t.kind == TOLD_LOCATE)
                replay_locate(s, &in, t);
            else if (flips && !failed(s) && t.kind == TOLD_FLIP)
                replay_flip_at(s, &in, t);
        }
        if (failed(s))
            show_replay(s, &in);
        check_result(s, at, n);
        expect(s, !flips || failed(s) || count < 3 || in.inserted == count,
               "locate has been asked for %lu points of %lu",
               (unsigned long)in.inserted - 2, (unsigned long)count - 2);
        if (flips && !failed(s)) {
            triangle_list again = sphere_triangles(&in.now);
            keep_triangles(s, again);
            expect_verdict(s, certify_delaunay(at, n, again));
        }
        end_insertion(&in);
    }
    free(order);
}

static void
replay_move(session *s, insertion *in, told t)
{
    expect(s, t.p < in->n, "the point that moves has the number %lu",
           (unsigned long)t.p);
    halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, t.a, t.b, t.c);
    if (!expect(s, e != NONE, "%lu is to wait in %s, which is not there then",
                (unsigned long)t.p, name_of_triangle(in->n, t.a, t.b, t.c).text))
        return;
    const uint32_t home[3] = {t.a, t.b, t.c};
    for (int i = 0; i < 3; i++)
        in->home[t.p][i] = home[i];
    in->waits[t.p] = true;
    in->moves++;
}

/* Before the next point is inserted: is everybody where he waits? */
static void
check_homes(session *s, const insertion *in)
{
    for (uint32_t i = in->inserted; i < in->count && !failed(s); i++) {
        uint32_t q = in->order[i];
        const uint32_t *h = in->home[q];
        expect(s, in->waits[q], "%lu has not been told where to wait",
               (unsigned long)q);
        halfedge_id e = failed(s) ? NONE : sphere_side(&in->now, h[0], h[1], h[2]);
        name home = name_of_triangle(in->n, h[0], h[1], h[2]);
        expect(s, failed(s) || e != NONE,
               "%lu waits in %s still, which is not there any more", (unsigned long)q,
               home.text);
        expect(s, failed(s) || sphere_has(&in->now, e / 3, q),
               "%lu waits in %s, and does not lie there", (unsigned long)q, home.text);
        if (failed(s)) {
            show_witness(s, q);
            if (in->waits[q])
                show_triangle(s, SVG_BAD, in->n, h[0], h[1], h[2]);
        }
    }
}

static void
replay_waiting(session *s, insertion *in, uint32_t events)
{
    for (uint32_t i = 0; i < events && !failed(s); i++) {
        told t = take_told(s, in->n);
        if (failed(s))
            return;
        if (t.kind == TOLD_LOCATE) {
            check_homes(s, in);
            replay_locate(s, in, t);
        } else if (t.kind == TOLD_FLIP) {
            replay_flip_at(s, in, t);
        } else {
            replay_move(s, in, t);
        }
    }
}

/* Counts only; that all is right in the end is seen from the result. */
static void
count_moves(session *s, insertion *in, uint32_t events)
{
    uint32_t located = 0;
    for (uint32_t i = 0; i < events; i++) {
        told t = take_told(s, in->n);
        in->moves += t.kind == TOLD_MOVE;
        located += t.kind == TOLD_LOCATE;
    }
    double most = in->count > 1 ? 6.0 * in->count * log(in->count) : 0;
    expect(s, in->moves <= most, "%lu moves of waiting points for %lu points in random "
                                 "order; 6 n ln n is %.0f",
           (unsigned long)in->moves, (unsigned long)in->count, most);
    expect(s, failed(s) || in->count < 3 || (located + 2 == in->count && in->moves > 0),
           "%lu points, and nobody is told where to wait", (unsigned long)in->count);
}

void
check_waiting(session *s, const site *at, uint32_t n, bool moves)
{
    uint32_t *order = room_for(n, sizeof *order);
    begin_case(s, 'e', at, n);
    give_points(s);
    uint32_t count = give_order(s, at, n, order);
    if (ask(s)) {
        insertion in = begin_insertion(at, n, order, count);
        uint32_t events = take_number(s, 0, 20000, "the number of events");
        if (moves)
            count_moves(s, &in, events);
        else
            replay_waiting(s, &in, events);
        if (failed(s) && !moves)
            show_replay(s, &in);
        check_result(s, at, n);
        end_insertion(&in);
    }
    free(order);
}
