/* flips.c - Definition 9, the flip, and Figure 10 of the notes: LawsonFlip. */
#include "chapters/3.5_edge_flips/flips.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"

/* ---- Line 3: is it right already? ---- */

bool
is_locally_delaunay(const mesh *m, const point2 *points, halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    if (mesh_is_hull_edge(m, ab) || mesh_is_hull_edge(m, ba))
        return true;
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    return incircle(points[a], points[b], points[c], points[d]) <= 0;
}

/* ---- Line 4: the flip. ---- */

bool
is_flippable(const mesh *m, const point2 *points, halfedge_id ab)
{
    if (!mesh_is_interior(m, ab))
        return false;
    vertex_id a = mesh_origin(m, ab), b = mesh_dest(m, ab);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, mesh_twin(m, ab));
    return orient2d(points[d], points[c], points[a]) > 0 &&
           orient2d(points[c], points[d], points[b]) > 0;
}

void
flip(mesh *m, halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    halfedge_id cb = mesh_twin(m, mesh_next(ab)), ac = mesh_twin(m, mesh_prev(ab));
    halfedge_id da = mesh_twin(m, mesh_next(ba)), bd = mesh_twin(m, mesh_prev(ba));
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    assert(c != d);

    halfedge_id dc = ab, cd = ba;
    mesh_set_triangle(m, dc, d, c, a);
    mesh_set_triangle(m, cd, c, d, b);
    mesh_link(m, mesh_next(dc), ac);
    mesh_link(m, mesh_prev(dc), da);
    mesh_link(m, mesh_next(cd), bd);
    mesh_link(m, mesh_prev(cd), cb);
    trace_report(m, (trace_event){TRACE_FLIP, dc, a, b, c, d});
}

/* ---- Lines 2 and 5: the stack. ---- */

tri_status
edge_stack_init(edge_stack *L, mesh *m)
{
    *L = (edge_stack){.m = m};
    L->entry = memory_array(mesh_room(m), sizeof *L->entry);
    L->on_stack = memory_array(mesh_room(m), sizeof *L->on_stack);
    if (L->entry == NULL || L->on_stack == NULL) {
        edge_stack_free(L);
        return TRI_OUT_OF_MEMORY;
    }
    for (halfedge_id e = 0; e < mesh_room(m); e++)
        L->on_stack[e] = false;
    return TRI_OK;
}

void
edge_stack_free(edge_stack *L)
{
    memory_free(L->entry);
    memory_free(L->on_stack);
    *L = (edge_stack){0};
}

static void
report_edge(mesh *m, trace_kind kind, halfedge_id e)
{
    if (m->trace != NULL) /* else the ends need not be looked up */
        trace_report(m, (trace_event){kind, e, mesh_origin(m, e), mesh_dest(m, e), NONE,
                                      NONE});
}

void
edge_stack_push(edge_stack *L, halfedge_id ab)
{
    if (L->on_stack[ab] || L->on_stack[mesh_twin(L->m, ab)])
        return;
    L->on_stack[ab] = true;
    L->entry[L->size++] = ab;
    report_edge(L->m, TRACE_PUSH, ab);
}

bool
edge_stack_pop(edge_stack *L, halfedge_id *ab)
{
    if (L->size == 0 || L->m->cancelled)
        return false;
    *ab = L->entry[--L->size];
    L->on_stack[*ab] = false;
    report_edge(L->m, TRACE_POP, *ab);
    return !L->m->cancelled;
}

void
push_all_edges(edge_stack *L)
{
    for (halfedge_id e = 0; e < mesh_halfedges(L->m); e++)
        if (mesh_is_interior(L->m, e))
            edge_stack_push(L, e);
}

void
push_link(edge_stack *L, halfedge_id cd)
{
    halfedge_id dc = mesh_twin(L->m, cd);
    edge_stack_push(L, mesh_next(cd));
    edge_stack_push(L, mesh_prev(cd));
    edge_stack_push(L, mesh_next(dc));
    edge_stack_push(L, mesh_prev(dc));
}

/* ---- Figure 10. ---- */

void
lawson_flip(edge_stack *L, const point2 *points)
{
    mesh *K = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {              // Lines 1-2
        if (is_locally_delaunay(K, points, ab))   // Line 3
            continue;
        flip(K, ab);                              // Line 4: ab becomes cd.
        push_link(L, ab);                         // Line 5: push ac, cb, db, da.
    }                                             // Lines 6-7
}

tri_status
lawson_triangulate(const point2 *points, uint32_t n, const tri_options *options,
                   mesh *out)
{
    tri_status status = sweep_triangulate(points, n, options, out);
    if (status != TRI_OK)
        return status;
    edge_stack L;
    status = edge_stack_init(&L, out);
    if (status == TRI_OK) {
        out->trace = options != NULL ? options->trace : NULL;
        push_all_edges(&L);
        lawson_flip(&L, points);
        edge_stack_free(&L);
    }
    return mesh_finish(out, status);
}

/* ---- Certifying: Theorem 3 as a check. ---- */

/* Is each edge of the list locally Delaunay? Each is looked at from one side. */
static verdict
check_local_delaunay(const point2 *points, triangle_list list, const halfedge_id *twin)
{
    for (halfedge_id ab = 0; ab < 3 * list.count; ab++) {
        halfedge_id ba = twin[ab];
        if (ba == NONE || ba < ab)
            continue;
        vertex_id a = side_origin(list, ab), b = side_dest(list, ab);
        vertex_id c = side_apex(list, ab), d = side_apex(list, ba);
        if (incircle(points[a], points[b], points[c], points[d]) <= 0)
            continue;
        verdict v = verdict_refuted(
            "edge %u %u is not locally Delaunay: %u lies inside the circle of "
            "%u, %u, %u", (unsigned)a, (unsigned)b, (unsigned)d, (unsigned)a,
            (unsigned)b, (unsigned)c);
        return verdict_with(verdict_with(verdict_with(verdict_with(v, a), b), c), d);
    }
    return verdict_holds();
}

tri_status
is_delaunay(const point2 *points, uint32_t n, triangle_list list, verdict *out)
{
    halfedge_id *twin;
    tri_status status = is_triangulation_with_twins(points, n, list, out, &twin);
    if (status == TRI_OK && out->holds)
        *out = check_local_delaunay(points, list, twin);
    memory_free(twin);
    return status;
}
