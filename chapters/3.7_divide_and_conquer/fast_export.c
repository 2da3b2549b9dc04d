/* fast_export.c - half-edges without triangles become a mesh.
 *
 * Each half-edge gets its place in the mesh, kept in `ccw`, which is not needed any
 * more: the next half-edge around a triangle is the one clockwise of the twin. The
 * triangles come in the order of their lowest half-edges, then the ghosts in the order
 * of the hull.
 */
#include "chapters/3.7_divide_and_conquer/fast_export.h"

#include "chapters/3.7_divide_and_conquer/fast_share.h"

enum {
    AHEAD = 8000, /* most neighbours of a half-edge are no further away */
    APART = 8     /* so many half-edges fill a line of the cache */
};

static halfedge_id
next(const halfedge_id *cw, halfedge_id e)
{
    return cw[e ^ 1];
}

/* The sides of the outside become their own next ones: no triangle is found there.
 * Returns how many there are. Their places follow those of the triangles. */
static uint32_t
place_outside(fast_run *run, uint32_t u, uint32_t some_hull_site)
{
    fast_edge *edge = run->edge;
    halfedge_id first = run->site[some_hull_site].edge, e = first;
    uint32_t h = 0;
    do {
        h++;
        e = edge[e ^ 1].ccw;
    } while (e != first);
    halfedge_id place = 3 * (2 * u - 2 - h);
    for (uint32_t i = 0; i < h; i++, place += 3) {
        halfedge_id outside = e ^ 1, after = edge[outside].ccw;
        edge[outside].ccw = place;
        run->cw[e] = outside;
        e = after;
    }
    return h;
}

/* ---- In tasks, each of which has a piece of the half-edges, or of the sites. ---- */

/* What the tasks share. */
typedef struct exporting {
    fast_work work;
    fast_run *run;
    mesh *m;
    uint32_t sites, pieces;
    halfedge_id place[FAST_MOST_THREADS + 1]; /* of the first triangle of each piece */
} exporting;

static halfedge_id
first_of(const exporting *x, uint32_t piece)
{
    return 6 * fast_begin(piece, x->pieces, x->sites);
}

/* Is e the lowest half-edge of its triangle e f g? 1 or 0, as nobody can predict it. */
static uint32_t
is_lowest(halfedge_id e, halfedge_id f, halfedge_id g)
{
    return (uint32_t)(e < f) & (uint32_t)(e < g);
}

static void
count_places(fast_work *self, uint32_t piece)
{
    exporting *x = (exporting *)self;
    const halfedge_id *cw = x->run->cw;
    uint32_t triangles = 0;
    for (halfedge_id e = first_of(x, piece); e < first_of(x, piece + 1); e++) {
        FAST_SOON(&cw[e + AHEAD]);
        halfedge_id f = next(cw, e);
        triangles += is_lowest(e, f, next(cw, f));
    }
    x->place[piece + 1] = 3 * triangles;
}

/* The places of a triangle are written at each of its half-edges: to a half-edge that
 * is nowhere, if it is not the lowest. */
static void
place_triangles(fast_work *self, uint32_t piece)
{
    const exporting *x = (const exporting *)self;
    fast_edge *edge = x->run->edge;
    const fast_site *site = x->run->site;
    const halfedge_id *cw = x->run->cw;
    halfedge_id place = x->place[piece], end = first_of(x, piece + 1);
    const halfedge_id nowhere = 6 * x->sites + APART * piece;
    for (halfedge_id e = first_of(x, piece); e < end; e++) {
        FAST_SOON(&cw[e + AHEAD]);
        FAST_SOON(&edge[e + AHEAD]);
        FAST_SOON(&site[(e + AHEAD) / 6]);
        halfedge_id f = next(cw, e), g = next(cw, f);
        uint32_t lowest = is_lowest(e, f, g), mask = 0 - lowest;
        edge[nowhere ^ ((e ^ nowhere) & mask)].ccw = place;
        edge[nowhere ^ ((f ^ nowhere) & mask)].ccw = place + 1;
        edge[nowhere ^ ((g ^ nowhere) & mask)].ccw = place + 2;
        place += 3 * lowest;
        if (edge[e].origin != NONE)
            edge[e].origin = site[edge[e].origin].id;
    }
}

static void
fill_leaving(fast_work *self, uint32_t piece)
{
    const exporting *x = (const exporting *)self;
    const fast_site *site = x->run->site;
    uint32_t end = fast_begin(piece + 1, x->pieces, x->sites);
    for (uint32_t v = fast_begin(piece, x->pieces, x->sites); v < end; v++)
        if (site[v].edge != NONE)
            x->m->leaving[site[v].id] = x->run->edge[site[v].edge].ccw;
}

/* From here on the sites are overwritten. */
static void
fill_halfedges(fast_work *self, uint32_t piece)
{
    const exporting *x = (const exporting *)self;
    const fast_edge *edge = x->run->edge;
    mesh_halfedge *to = x->m->halfedge;
    for (halfedge_id e = first_of(x, piece); e < first_of(x, piece + 1); e += 2) {
        if (edge[e].origin == NONE)
            continue;
        halfedge_id p = edge[e].ccw, q = edge[e + 1].ccw;
        to[p] = (mesh_halfedge){edge[e].origin, q};
        to[q] = (mesh_halfedge){edge[e + 1].origin, p};
    }
}

/* Half-edge `place` of ghost triangle i runs from b to a, along the hull; the other two
 * lead to the ghost and back. */
static void
fill_ghosts(mesh *m, uint32_t h)
{
    mesh_halfedge *to = m->halfedge;
    halfedge_id begin = 6 * m->locations - 6 - 3 * h;
    for (uint32_t i = 0; i < h; i++) {
        halfedge_id place = begin + 3 * i;
        halfedge_id before = begin + 3 * (i > 0 ? i - 1 : h - 1);
        vertex_id a = to[to[place].twin].origin;
        to[place + 1] = (mesh_halfedge){a, before + 2};
        to[place + 2].origin = GHOST;
        to[before + 2].twin = place + 1;
    }
    m->ghost_leaving = begin + 2;
}

/* ---- All. ---- */

static void
share(exporting *x, void (*task)(fast_work *, uint32_t))
{
    x->work.task = task;
    fast_share(&x->work, x->pieces, x->pieces);
}

void
fast_export(fast_run *run, uint32_t sites, uint32_t some_hull_site, mesh *m,
            uint32_t threads)
{
    exporting x = {.run = run, .m = m, .sites = sites, .pieces = threads};
    if (m->locations < 2)
        return;
    m->triangles = 2 * m->locations - 2;
    uint32_t h = place_outside(run, m->locations, some_hull_site);
    if (threads > 1)
        share(&x, count_places);
    for (uint32_t i = 0; i < threads; i++)
        x.place[i + 1] += x.place[i];
    share(&x, place_triangles);
    share(&x, fill_leaving);
    share(&x, fill_halfedges);
    fill_ghosts(m, h);
}
