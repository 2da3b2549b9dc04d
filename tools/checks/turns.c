/* turns.c - a report of pushes, pops and flips: is it that of a queue? */
#include "tools/checks/turns.h"

#include "tools/checks/room.h"

#include <stdlib.h>

/* The report so far. pushed[pops .. pushes-1] wait. */
typedef struct record {
    const site *at;
    triangle_list list;
    halfedge_id *pushed;
    uint32_t pushes, pops;
    bool due;          /* the last one popped is to be flipped, and is not yet */
    halfedge_id cd;    /* just flipped: nothing but pushes since; else NONE */
} record;

/* ---- Edges. ---- */

static halfedge_id
next_of(halfedge_id e)
{
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* The side that is its twin; NONE: it is outside, or on the hull. */
static halfedge_id
twin_of(const record *r, halfedge_id e)
{
    triangle_list l = r->list;
    for (halfedge_id f = 0; e < 3 * l.count && f < 3 * l.count; f++)
        if (side_origin(l, f) == side_dest(l, e) &&
            side_dest(l, f) == side_origin(l, e))
            return f;
    return NONE;
}

static bool
waits(const record *r, halfedge_id e)
{
    for (uint32_t i = r->pops; i < r->pushes; i++)
        if (r->pushed[i] == e)
            return true;
    return false;
}

static bool
edge_waits(const record *r, halfedge_id e)
{
    halfedge_id twin = twin_of(r, e);
    return waits(r, e) || (twin != NONE && waits(r, twin));
}

static bool
is_locally_delaunay(const record *r, halfedge_id ab)
{
    triangle_list l = r->list;
    halfedge_id ba = twin_of(r, ab);
    return ba == NONE ||
           plane_incircle(r->at[side_origin(l, ab)], r->at[side_dest(l, ab)],
                          r->at[side_apex(l, ab)], r->at[side_apex(l, ba)]) <= 0;
}

/* Is e on the hull, or a side of the quadrilateral around cd, seen from within or
 * without? */
static bool
is_around(const record *r, halfedge_id e)
{
    halfedge_id cd = r->cd, dc = twin_of(r, cd), twin = twin_of(r, e);
    if (twin == NONE)
        return true;
    return e != cd && e != dc && (e / 3 == cd / 3 || e / 3 == dc / 3 ||
                                  twin / 3 == cd / 3 || twin / 3 == dc / 3);
}

/* ---- What is wrong. ---- */

/* "edge 2-3 does this", and its ends to look at. */
static verdict
refuted(const record *r, halfedge_id e, const char *what)
{
    if (e >= 3 * r->list.count)
        return verdict_refuted("half-edge %lu, outside, %s", (unsigned long)e, what);
    vertex_id a = side_origin(r->list, e), b = side_dest(r->list, e);
    verdict v = verdict_refuted("edge %lu-%lu %s", (unsigned long)a, (unsigned long)b,
                                what);
    return verdict_with(verdict_with(v, a), b);
}

/* Before each pop, and at the end: have lines 4 and 5 been done for the one before? */
static verdict
is_settled(const record *r)
{
    if (r->due)
        return refuted(r, r->pushed[r->pops - 1],
                       "was popped, is not locally Delaunay, and is not flipped");
    if (r->pops > 0 && r->cd == NONE)
        return verdict_holds();
    for (halfedge_id e = 0; e < 3 * r->list.count; e++)
        if ((r->pops == 0 || is_around(r, e)) && twin_of(r, e) != NONE &&
            !edge_waits(r, e))
            return refuted(r, e, r->pops == 0 ? "does not wait at the start"
                                              : "does not wait after a flip beside it");
    return verdict_holds();
}

/* ---- The three kinds. ---- */

static verdict
push(record *r, halfedge_id e)
{
    if (edge_waits(r, e))
        return refuted(r, e, "is pushed, and waits already");
    if (r->pops > 0 && r->cd == NONE)
        return refuted(r, e, "is pushed, and nothing has just been flipped");
    if (r->pops > 0 && !is_around(r, e))
        return refuted(r, e, "is pushed, and is not around the one just flipped");
    r->pushed[r->pushes++] = e;
    return verdict_holds();
}

static verdict
pop(record *r, halfedge_id e)
{
    verdict v = is_settled(r);
    if (!v.holds)
        return v;
    if (!waits(r, e))
        return refuted(r, e, "is popped, and does not wait");
    if (r->pushed[r->pops] != e)
        return refuted(r, r->pushed[r->pops], "has waited longer than the one popped");
    r->pops++;
    r->cd = NONE;
    r->due = !is_locally_delaunay(r, e);
    return verdict_holds();
}

static verdict
flip(record *r, halfedge_id ab)
{
    halfedge_id ba = twin_of(r, ab);
    if (!r->due || (r->pushed[r->pops - 1] != ab && r->pushed[r->pops - 1] != ba))
        return refuted(r, ab, "is flipped; it was not just popped, or was fine");
    triangle_list l = r->list;
    vertex_id a = side_origin(l, ab), b = side_dest(l, ab);
    vertex_id c = side_apex(l, ab), d = side_apex(l, ba);
    const vertex_id dca[3] = {d, c, a}, cdb[3] = {c, d, b};
    for (int i = 0; i < 3; i++, ab = next_of(ab), ba = next_of(ba)) {
        l.corner[ab / 3][ab % 3] = dca[i];
        l.corner[ba / 3][ba % 3] = cdb[i];
    }
    r->due = false;
    r->cd = ba;
    return verdict_holds();
}

verdict
certify_turns(const site *points, triangle_list list, const turn *report,
              uint32_t count)
{
    record r = {.at = points, .list = list, .cd = NONE};
    r.pushed = room_for(count, sizeof *r.pushed);
    verdict v = verdict_holds();
    for (uint32_t i = 0; v.holds && i < count; i++)
        switch (report[i].kind) {
        case TURN_PUSHED: v = push(&r, report[i].e); break;
        case TURN_POPPED: v = pop(&r, report[i].e); break;
        case TURN_FLIPPED: v = flip(&r, report[i].e); break;
        }
    if (v.holds)
        v = is_settled(&r);
    if (v.holds && r.pops < r.pushes)
        v = refuted(&r, r.pushed[r.pops], "still waits at the end");
    free(r.pushed);
    return v;
}
