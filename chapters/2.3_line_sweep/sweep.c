/* sweep.c - Figure 3 of the notes: LineSweep. */
#include "chapters/2.3_line_sweep/sweep.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* ---- Line 1: the order of the sweep. ---- */

/* Points travel with their indices, so that comparing does not jump about. */
typedef struct site {
    point2 at;
    vertex_id id;
} site;

/* Merges the sorted runs from[lo,mid) and from[mid,hi) into to[lo,hi). Of equal
 * points the one from the left run comes first, so the order is stable. */
static void
merge_runs(const site *from, site *to, size_t lo, size_t mid, size_t hi, point2 d)
{
    size_t left = lo, right = mid;
    for (size_t k = lo; k < hi; k++) {
        bool take_left = right == hi ||
            (left < mid && compare_along(d, from[left].at, from[right].at) <= 0);
        to[k] = take_left ? from[left++] : from[right++];
    }
}

/* Sorts a[lo,hi). Both arrays hold the points before; b's part is used up. */
static void
merge_sort(site *a, site *b, size_t lo, size_t hi, point2 d)
{
    if (hi - lo < 2)
        return;
    size_t mid = lo + (hi - lo) / 2;
    merge_sort(b, a, lo, mid, d);
    merge_sort(b, a, mid, hi, d);
    merge_runs(b, a, lo, mid, hi, d);
}

tri_status
sort_along(const point2 *points, uint32_t n, point2 d, vertex_id *order,
           uint32_t *locations)
{
    *locations = 0;
    site *sorted = memory_array(n, 2 * sizeof *sorted);
    if (sorted == NULL)
        return TRI_OUT_OF_MEMORY;
    site *spare = sorted + n;
    for (vertex_id v = 0; v < n; v++)
        sorted[v] = spare[v] = (site){points[v], v};

    merge_sort(sorted, spare, 0, n, d);
    for (uint32_t i = 0; i < n; i++) {
        bool repeated = i > 0 && compare_along(d, sorted[i - 1].at, sorted[i].at) == 0;
        if (!repeated)
            order[(*locations)++] = sorted[i].id;
    }
    memory_free(sorted);
    return TRI_OK;
}

/* ---- Line 4: what the new point sees. ---- */

/* Does p see hull edge e, from u to w? The hull lies left of its edges, so exactly
 * when p is strictly right. A point in line with an edge cannot see it: the
 * triangle would be flat, and Definition 1 wants affinely independent vertices. */
static bool
sees(const mesh *m, const point2 *points, vertex_id p, halfedge_id e)
{
    vertex_id u = mesh_origin(m, e), w = mesh_dest(m, e);
    return orient2d(points[u], points[w], points[p]) < 0;
}

/* The edges that see p form one chain. If it is not empty it touches the vertex
 * where `last` begins (page 2.3, P1), on one side or the other, so the walk looks
 * both ways. */
hull_chain
hull_edges_seeing(const mesh *m, const point2 *points, halfedge_id last, vertex_id p)
{
    hull_chain q = {last, last};
    while (sees(m, points, p, mesh_hull_prev(m, q.first)))
        q.first = mesh_hull_prev(m, q.first);
    while (sees(m, points, p, q.end))
        q.end = mesh_hull_next(m, q.end);
    return q;
}

/* ---- Lines 2 and 5: the first edge, and what becomes of the visible ones. ---- */

halfedge_id
start(mesh *m, vertex_id a, vertex_id b)
{
    halfedge_id ab = mesh_start(m, a, b);
    trace_report(m, (trace_event){TRACE_START, ab, a, b, NONE, NONE});
    return mesh_hull_next(m, ab);
}

halfedge_id
attach(mesh *m, hull_chain q, vertex_id p)
{
    for (halfedge_id e = q.first; e != q.end; e = mesh_hull_next(m, e))
        mesh_cover(m, e, p);
    halfedge_id leaving = mesh_hull_join(m, q.first, q.end, p);
    trace_report(m, (trace_event){TRACE_ATTACH, leaving, p, NONE, NONE, NONE});
    return leaving;
}

/* ---- Figure 3. ---- */

/* A single location needs no edge; two or more begin with one. */
static void
sweep(mesh *m, const point2 *points, const vertex_id *L)
{
    halfedge_id last = NONE;
    if (m->locations >= 2)
        last = start(m, L[0], L[1]);                               // Line 2
    for (uint32_t i = 2; i < m->locations && !m->cancelled; i++) { // Line 3
        hull_chain q = hull_edges_seeing(m, points, last, L[i]);   // Line 4
        last = attach(m, q, L[i]);                                 // Line 5
    }                                                              // Line 6
}

tri_status
sweep_triangulate(const point2 *points, uint32_t n, const tri_options *options,
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
    status = sort_along(points, n, used.direction, L, &locations); // Line 1
    if (status == TRI_OK)
        status = mesh_init(out, n, locations);
    if (status == TRI_OK) {
        out->trace = used.trace;
        sweep(out, points, L);
    }
    memory_free(L);
    return mesh_finish(out, status);
}

/* ---- The hull, read off the mesh. ---- */

/* The hull edge that leaves the first vertex to be listed: of all hull vertices, or
 * of the two ends of a path, the one with the lowest index. At the end of a path
 * the hull turns back: the edge before is the twin of the edge after. */
static halfedge_id
first_hull_edge(const mesh *m, bool path)
{
    halfedge_id some = mesh_some_hull_edge(m), first = NONE, e = some;
    do {
        bool eligible = !path || mesh_hull_prev(m, e) == mesh_twin(m, e);
        if (eligible && (first == NONE || mesh_origin(m, e) < mesh_origin(m, first)))
            first = e;
        e = mesh_hull_next(m, e);
    } while (e != some);
    return first;
}

uint32_t
hull_vertices(const mesh *m, vertex_id *hull)
{
    if (m->locations < 2) {
        for (uint32_t i = 0; i < m->locations; i++)
            hull[i] = 0; /* of the copies of one point the first is its vertex */
        return m->locations;
    }
    bool path = !mesh_in_triangle(m, mesh_some_hull_edge(m));
    uint32_t size = path ? m->locations : mesh_hull_size(m);
    halfedge_id e = first_hull_edge(m, path);
    for (uint32_t i = 0; i < size; i++) {
        hull[i] = mesh_origin(m, e);
        e = mesh_hull_next(m, e);
    }
    return size;
}
