/* flip_path.c - from any triangulation to any other, by way of a third one. */
#include "chapters/3.5_edge_flips/flip_graph.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/mesh_build.h"

/* ---- One Delaunay triangulation among several. ---- */

/* Four points on a circle lie in one plane when lifted. Then the one with the
 * lowest index, lifted more than the others, decides: at an end of ab it lifts
 * ab above cd; at an apex it lifts cd. */
bool
is_locally_delaunay_perturbed(const mesh *m, const point2 *points,
                              halfedge_id ab)
{
    halfedge_id ba = mesh_twin(m, ab);
    if (mesh_is_hull_edge(m, ab) || mesh_is_hull_edge(m, ba))
        return true;
    vertex_id a = mesh_origin(m, ab), b = mesh_origin(m, ba);
    vertex_id c = mesh_apex(m, ab), d = mesh_apex(m, ba);
    int sign = incircle(points[a], points[b], points[c], points[d]);
    if (sign != 0)
        return sign < 0;
    vertex_id lower_end = a < b ? a : b, lower_apex = c < d ? c : d;
    return lower_apex < lower_end;
}

void
lawson_flip_perturbed(edge_stack *L, const point2 *points)
{
    mesh *K = L->m;
    halfedge_id ab;
    while (edge_stack_pop(L, &ab)) {
        if (is_locally_delaunay_perturbed(K, points, ab))
            continue;
        flip(K, ab);
        push_link(L, ab);
    }
}

/* ---- The way there. ---- */

/* An observer that remembers flips. */
typedef struct recorder {
    trace base; /* first: see lib/trace.h */
    uint32_t count, room;
    vertex_id (*flip)[4]; /* a, b, c, d: ab became cd */
} recorder;

static int
record_flip(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    recorder *r = (recorder *)self;
    if (event->kind != TRACE_FLIP)
        return 0;
    if (r->count == r->room) {
        uint32_t room = r->room < UINT32_MAX / 4 ? 2 * r->room + 16 : 0;
        void *larger = NULL;
        if (room > 0)
            larger = memory_resize(r->flip, room, sizeof *r->flip);
        if (larger == NULL)
            return 1; /* stops the flips */
        r->flip = larger;
        r->room = room;
    }
    vertex_id *abcd = r->flip[r->count++];
    abcd[0] = event->a;
    abcd[1] = event->b;
    abcd[2] = event->c;
    abcd[3] = event->d;
    return 0;
}

/* A mesh of the same triangles; one without any edge if there are no triangles,
 * as there is nothing to flip then. */
static tri_status
copy_mesh(const mesh *m, mesh *out)
{
    *out = (mesh){0};
    triangle_list list;
    tri_status status = mesh_triangles(m, &list);
    if (status == TRI_OK && list.count > 0)
        status = mesh_from_triangles(m->points, list, out);
    triangle_list_free(&list);
    return status;
}

/* Records the flips from a triangulation to the one that all share. */
static tri_status
record_descent(const point2 *points, const mesh *from, recorder *r)
{
    mesh m;
    edge_stack L = {0};
    tri_status status = copy_mesh(from, &m);
    if (status == TRI_OK)
        status = edge_stack_init(&L, &m);
    if (status == TRI_OK) {
        push_all_edges(&L);
        m.trace = &r->base;
        lawson_flip_perturbed(&L, points);
        if (m.cancelled)
            status = TRI_OUT_OF_MEMORY;
    }
    edge_stack_free(&L);
    mesh_free(&m);
    return status;
}

/* Down as recorded, then up by the others backwards: cd becomes ab again. */
static tri_status
join(const recorder *down, const recorder *up, edge_list *out)
{
    size_t flips = (size_t)down->count + up->count;
    out->ends = memory_array(flips, sizeof *out->ends);
    if (out->ends == NULL)
        return TRI_OUT_OF_MEMORY;
    for (uint32_t k = 0; k < down->count; k++, out->count++) {
        out->ends[out->count][0] = down->flip[k][0];
        out->ends[out->count][1] = down->flip[k][1];
    }
    for (uint32_t k = up->count; k > 0; k--, out->count++) {
        out->ends[out->count][0] = up->flip[k - 1][2];
        out->ends[out->count][1] = up->flip[k - 1][3];
    }
    return TRI_OK;
}

tri_status
flip_path(const point2 *points, const mesh *from, const mesh *to,
          edge_list *out)
{
    *out = (edge_list){0};
    recorder down = {.base = {record_flip}}, up = {.base = {record_flip}};
    tri_status status = record_descent(points, from, &down);
    if (status == TRI_OK)
        status = record_descent(points, to, &up);
    if (status == TRI_OK)
        status = join(&down, &up, out);
    memory_free(down.flip);
    memory_free(up.flip);
    return status;
}
