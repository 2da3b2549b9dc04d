/* fast_export.c - half-edges without triangles become a mesh.
 *
 * Each half-edge gets its place in the mesh, kept in `ccw`, which is not needed any
 * more: the next half-edge around a triangle is the one clockwise of the twin. The
 * triangles come in the order of their lowest half-edges, then the ghosts in the order
 * of the hull.
 */
#include "chapters/3.7_divide_and_conquer/fast_export.h"

enum { AHEAD = 8000 }; /* so far away, at most, are most neighbours of a half-edge */

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

/* Whether e is the lowest half-edge of its triangle cannot be predicted: so places are
 * written in any case, to `nowhere` if it is not. */
static void
place_triangles(fast_run *run, halfedge_id halfedges, halfedge_id nowhere)
{
    fast_edge *edge = run->edge;
    const fast_site *site = run->site;
    const halfedge_id *cw = run->cw;
    halfedge_id place = 0;
    for (halfedge_id e = 0; e < halfedges; e++) {
        FAST_SOON(&cw[e + AHEAD]);
        FAST_SOON(&edge[e + AHEAD]);
        FAST_SOON(&site[(e + AHEAD) / 6]);
        halfedge_id f = next(cw, e), g = next(cw, f);
        uint32_t lowest = (uint32_t)(e < f) & (uint32_t)(e < g), mask = 0 - lowest;
        edge[nowhere ^ ((e ^ nowhere) & mask)].ccw = place;
        edge[nowhere ^ ((f ^ nowhere) & mask)].ccw = place + 1;
        edge[nowhere ^ ((g ^ nowhere) & mask)].ccw = place + 2;
        place += 3 * lowest;
        if (edge[e].origin != NONE)
            edge[e].origin = site[edge[e].origin].id;
    }
}

static void
fill_mesh(const fast_run *run, halfedge_id halfedges, mesh_halfedge *to)
{
    const fast_edge *edge = run->edge;
    for (halfedge_id e = 0; e < halfedges; e += 2) {
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

void
fast_export(fast_run *run, uint32_t sites, uint32_t some_hull_site, mesh *m)
{
    uint32_t u = m->locations;
    if (u < 2)
        return;
    m->triangles = 2 * u - 2;
    halfedge_id halfedges = 6 * sites;
    uint32_t h = place_outside(run, u, some_hull_site);
    place_triangles(run, halfedges, halfedges);
    for (uint32_t v = 0; v < sites; v++)
        if (run->site[v].edge != NONE)
            m->leaving[run->site[v].id] = run->edge[run->site[v].edge].ccw;
    fill_mesh(run, halfedges, m->halfedge);
    fill_ghosts(m, h);
}
