/* emst.c - Euclidean minimum spanning trees: Theorem 2 at work. */
#include "chapters/3.2_empty_circumcircle/graphs.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/sort.h"

#include <string.h>

/* ---- The order of the edges. ---- */

/* Which of two edges comes first? By exact length, then by indices. */
static int
compare_edges(const point2 *points, const vertex_id e[2], const vertex_id f[2])
{
    int sign = compare_distance(points[e[0]], points[e[1]], points[f[0]],
                                points[f[1]]);
    if (sign != 0)
        return sign;
    if (e[0] != f[0])
        return e[0] < f[0] ? -1 : 1;
    return (e[1] > f[1]) - (e[1] < f[1]);
}

/* The square of the length, rounded. Edges with equal ones may differ in
 * length, and edges with nearly equal ones may be in the wrong order. */
static double
rounded_square(point2 p, point2 q)
{
    double x = p.x - q.x, y = p.y - q.y;
    return x * x + y * y;
}

/* Sorts by rounded length, which takes linear time. */
static tri_status
sort_roughly(const point2 *points, edge_list edges)
{
    size_t count = edges.count;
    sort_item *item = memory_array(count, 2 * sizeof *item);
    vertex_id (*copy)[2] = memory_array(count, sizeof *copy);
    tri_status status = TRI_OUT_OF_MEMORY;
    if (item != NULL && copy != NULL) {
        status = TRI_OK;
        for (uint32_t i = 0; i < count; i++) {
            const vertex_id *e = edges.ends[i];
            double square = rounded_square(points[e[0]], points[e[1]]);
            item[i] = (sort_item){sort_key_of(square), i};
            memcpy(copy[i], e, sizeof copy[i]);
        }
        sort_by_key(item, item + count, count);
        for (uint32_t i = 0; i < count; i++)
            memcpy(edges.ends[i], copy[item[i].id], sizeof copy[i]);
    }
    memory_free(item);
    memory_free(copy);
    return status;
}

/* Merges the sorted runs ends[lo,mid) and ends[mid,hi), with room for the first
 * of them in `left`. When all is in order already, one comparison finds out. */
static void
merge_runs(const point2 *points, vertex_id (*ends)[2], vertex_id (*left)[2],
           size_t lo, size_t mid, size_t hi)
{
    if (compare_edges(points, ends[mid - 1], ends[mid]) < 0)
        return;
    memcpy(left, ends + lo, (mid - lo) * sizeof *ends);
    size_t taken = 0, count = mid - lo, right = mid;
    for (size_t k = lo; taken < count; k++) {
        bool take_left =
            right == hi || compare_edges(points, left[taken], ends[right]) < 0;
        memcpy(ends[k], take_left ? left[taken++] : ends[right++],
               sizeof *ends);
    }
}

tri_status
sort_by_length(const point2 *points, edge_list edges)
{
    tri_status status = sort_roughly(points, edges);
    if (status != TRI_OK)
        return status;
    size_t n = edges.count;
    vertex_id (*left)[2] = memory_array(n, sizeof *left);
    if (left == NULL)
        return TRI_OUT_OF_MEMORY;
    for (size_t run = 1; run < n; run *= 2)
        for (size_t lo = 0; lo + run < n; lo += 2 * run) {
            size_t mid = lo + run, hi = mid + run < n ? mid + run : n;
            merge_runs(points, edges.ends, left, lo, mid, hi);
        }
    memory_free(left);
    return TRI_OK;
}

/* ---- Which vertices are connected already? ---- */

/* parent[v] leads from v towards the one vertex that stands for its component.
 * NULL when there is no memory. */
static vertex_id *
no_connections(uint32_t n)
{
    vertex_id *parent = memory_array(n, sizeof *parent);
    for (vertex_id v = 0; v < n && parent != NULL; v++)
        parent[v] = v;
    return parent;
}

/* The vertex that stands for the component of v. Half of the vertices on the
 * way are led past their parents, which makes the next way shorter. */
static vertex_id
component(vertex_id *parent, vertex_id v)
{
    while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
    return v;
}

/* Joins the components of v and w; false when they are the same already. */
static bool
connect(vertex_id *parent, vertex_id v, vertex_id w)
{
    v = component(parent, v);
    w = component(parent, w);
    parent[v] = w;
    return v != w;
}

/* ---- Kruskal's algorithm. ---- */

/* Of the edges, which are sorted by length, keeps each one that connects two
 * components of those kept before. */
static void
keep_tree(edge_list *edges, vertex_id *parent)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < edges->count; i++) {
        vertex_id v = edges->ends[i][0], w = edges->ends[i][1];
        if (!connect(parent, v, w))
            continue;
        edges->ends[kept][0] = v;
        edges->ends[kept][1] = w;
        kept++;
    }
    edges->count = kept;
}

tri_status
emst(const mesh *m, const point2 *points, edge_list *out)
{
    tri_status status = mesh_edges(m, NULL, out);
    vertex_id *parent = no_connections(m->points);
    if (parent == NULL)
        status = TRI_OUT_OF_MEMORY;
    if (status == TRI_OK)
        status = sort_by_length(points, *out);
    if (status == TRI_OK)
        keep_tree(out, parent);
    memory_free(parent);
    if (status != TRI_OK)
        edge_list_free(out);
    return status;
}

/* ---- Certifying. ---- */

static verdict
refuted_edge(const char *what, vertex_id v, vertex_id w)
{
    verdict no = verdict_refuted("%s: %u %u", what, (unsigned)v, (unsigned)w);
    return verdict_with(verdict_with(no, v), w);
}

/* Does the list have u-1 edges, all between vertices of the mesh? */
static verdict
check_ends(const mesh *m, edge_list tree)
{
    uint32_t needed = m->locations > 0 ? m->locations - 1 : 0;
    if (tree.count != needed)
        return verdict_refuted(
            "%u edges: a spanning tree of %u locations has %u",
            (unsigned)tree.count, (unsigned)m->locations, (unsigned)needed);
    for (uint32_t i = 0; i < tree.count; i++) {
        vertex_id v = tree.ends[i][0], w = tree.ends[i][1];
        if (v >= m->points || w >= m->points)
            return verdict_refuted("edge %u joins points that there are not",
                                   (unsigned)i);
        if (mesh_leaving(m, v) == NONE || mesh_leaving(m, w) == NONE)
            return refuted_edge("an end is a copy of an earlier point", v, w);
    }
    return verdict_holds();
}

/* When all edges of the tree are there that are not longer than an edge of the
 * mesh, are its ends connected? Both lists are sorted by length. In the end the
 * tree connects everything then, which it cannot do if one of its u-1 edges
 * closes a cycle. Uses and spoils parent. */
static verdict
check_minimum(const point2 *points, edge_list tree, edge_list edges,
              vertex_id *parent)
{
    uint32_t added = 0;
    for (uint32_t i = 0; i < edges.count; i++) {
        vertex_id v = edges.ends[i][0], w = edges.ends[i][1];
        for (; added < tree.count; added++) {
            const vertex_id *t = tree.ends[added];
            if (compare_distance(points[t[0]], points[t[1]], points[v],
                                 points[w]) > 0)
                break;
            connect(parent, t[0], t[1]);
        }
        if (component(parent, v) != component(parent, w))
            return refuted_edge("the tree has no way between the ends of this "
                                "edge on which all are as short", v, w);
    }
    return verdict_holds();
}

/* A copy of the list; TRI_OUT_OF_MEMORY: *out is zeroed. */
static tri_status
copy_edges(edge_list list, edge_list *out)
{
    *out = (edge_list){list.count, memory_array(list.count, sizeof *list.ends)};
    if (out->ends == NULL) {
        out->count = 0;
        return TRI_OUT_OF_MEMORY;
    }
    if (list.count > 0)
        memcpy(out->ends, list.ends, list.count * sizeof *list.ends);
    return TRI_OK;
}

tri_status
is_emst(const mesh *m, const point2 *points, edge_list tree, verdict *out)
{
    *out = check_ends(m, tree);
    if (!out->holds)
        return TRI_OK;
    edge_list edges, sorted = {0};
    vertex_id *parent = no_connections(m->points);
    tri_status status = mesh_edges(m, NULL, &edges);
    if (parent == NULL)
        status = TRI_OUT_OF_MEMORY;
    if (status == TRI_OK)
        status = copy_edges(tree, &sorted);
    if (status == TRI_OK)
        status = sort_by_length(points, edges);
    if (status == TRI_OK)
        status = sort_by_length(points, sorted);
    if (status == TRI_OK)
        *out = check_minimum(points, sorted, edges, parent);
    edge_list_free(&edges);
    edge_list_free(&sorted);
    memory_free(parent);
    return status;
}
