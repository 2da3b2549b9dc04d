/* 2.2.c - the properties of exercises 2.2-a and 2.2-b: Euler's formula.
 *
 * The drawings are some edges of a triangulation, so that nothing crosses. Their faces
 * are walked along here too, with the order of the edges around each point computed
 * from the coordinates.
 */
#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"

#include <stdlib.h>

enum { MOST_VERTICES = 32, MOST_EDGES = 3 * MOST_VERTICES };

/* Edge k has the half-edges 2k, from its first end to the second, and 2k+1. */
typedef struct drawing {
    const site *at;
    uint32_t vertices, edges;
    uint32_t origin[2 * MOST_EDGES];
    uint32_t left[2 * MOST_EDGES]; /* half-edge -> the walk that it belongs to */
    uint32_t walks;
    uint32_t outer; /* the walk along the outer face; only if connected */
    uint32_t component[MOST_VERTICES], components;
} drawing;

static uint32_t
dest(const drawing *d, uint32_t h)
{
    return d->origin[h ^ 1u];
}

/* ---- What there is to count. ---- */

static uint32_t
root_of(const uint32_t *parent, uint32_t v)
{
    while (parent[v] != v)
        v = parent[v];
    return v;
}

/* Joins two classes; false when they are one already. */
static bool
join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = root_of(parent, a);
    b = root_of(parent, b);
    parent[a] = b;
    return a != b;
}

static void
find_components(drawing *d)
{
    d->components = d->vertices;
    for (uint32_t v = 0; v < d->vertices; v++)
        d->component[v] = v;
    for (uint32_t k = 0; k < d->edges; k++)
        if (join(d->component, d->origin[2 * k], d->origin[2 * k + 1]))
            d->components--;
}

/* Seen from b, does direction bx come before by, turning clockwise from ba? */
static bool
comes_before(const drawing *d, uint32_t b, uint32_t a, uint32_t x, uint32_t y)
{
    const site *p = d->at;
    int xa = plane_orient(p[b], p[a], p[x]), ya = plane_orient(p[b], p[a], p[y]);
    if (x == a || y == a)
        return y == a; /* all the way around, back to a, is last */
    /* clockwise from ba: right of it (-1), behind it (0), left of it (+1) */
    if (xa != ya)
        return xa < ya;
    return xa != 0 && plane_orient(p[b], p[x], p[y]) < 0;
}

/* The half-edge after h on the walk along the face on the left. */
static uint32_t
next_on_face(const drawing *d, uint32_t h)
{
    uint32_t a = d->origin[h], b = dest(d, h), best = h ^ 1u;
    for (uint32_t g = 0; g < 2 * d->edges; g++)
        if (d->origin[g] == b && comes_before(d, b, a, dest(d, g), dest(d, best)))
            best = g;
    return best;
}

/* Twice the area to the left of a walk; the outer face's is not positive. */
static int64_t
area_of(const drawing *d, uint32_t walk)
{
    int64_t area = 0;
    for (uint32_t h = 0; h < 2 * d->edges; h++)
        if (d->left[h] == walk) {
            site a = d->at[d->origin[h]], b = d->at[dest(d, h)];
            area += (int64_t)a.x * b.y - (int64_t)a.y * b.x;
        }
    return area;
}

static void
find_walks(drawing *d)
{
    for (uint32_t h = 0; h < 2 * d->edges; h++)
        d->left[h] = NONE;
    for (uint32_t h = 0; h < 2 * d->edges; h++) {
        if (d->left[h] != NONE)
            continue;
        for (uint32_t g = h; d->left[g] == NONE; g = next_on_face(d, g))
            d->left[g] = d->walks;
        d->walks++;
    }
    for (uint32_t walk = 0; walk < d->walks; walk++)
        if (area_of(d, walk) <= 0)
            d->outer = walk;
    for (uint32_t v = 0; v < d->vertices; v++) { /* isolated: a walk of no edges */
        bool isolated = true;
        for (uint32_t h = 0; h < 2 * d->edges; h++)
            isolated = isolated && d->origin[h] != v;
        d->walks += isolated;
    }
}

/* Every face has one walk from each component on its boundary. */
static uint32_t
count_faces(const drawing *d)
{
    return d->walks + 1 - d->components;
}

/* ---- Drawings. ---- */

/* Some edges of a triangulation, all of them if `connected`; only n distinct points. */
static bool
draw_some(session *s, const site *p, uint32_t n, bool connected, drawing *d)
{
    triangle_list list = mesh_at_random(trial_random(s), p, n, false);
    keep_triangles(s, list);
    *d = (drawing){.at = p, .vertices = n};
    uint32_t keep = connected ? 100 : 30 + random_below(trial_random(s), 60);
    for (halfedge_id e = 0; e < 3 * list.count; e++) {
        vertex_id a = side_origin(list, e), b = side_dest(list, e);
        bool repeated = false;
        for (uint32_t k = 0; k < d->edges; k++)
            repeated = repeated || (d->origin[2 * k] == b && d->origin[2 * k + 1] == a);
        if (repeated || random_below(trial_random(s), 100) >= keep)
            continue;
        d->origin[2 * d->edges] = a;
        d->origin[2 * d->edges + 1] = b;
        d->edges++;
    }
    find_components(d);
    /* There are fewer and fewer, as they go. */
    for (uint32_t k = 0; connected && k < d->edges; k++) {
        if (random_below(trial_random(s), 2) == 0)
            continue;
        drawing without = *d;
        without.edges--;
        without.origin[2 * k] = d->origin[2 * without.edges];
        without.origin[2 * k + 1] = d->origin[2 * without.edges + 1];
        find_components(&without);
        if (without.components == d->components)
            *d = without;
    }
    if (list.count > 0)
        find_walks(d);
    return list.count > 0;
}

/* Sends the drawing; false when there is no good answer. */
static bool
ask_about(session *s, char exercise, const drawing *d)
{
    begin_case(s, exercise, d->at, d->vertices);
    give_points(s);
    give_number(s, d->edges);
    for (uint32_t h = 0; h < 2 * d->edges; h++)
        give_number(s, d->origin[h]);
    keep_triangles(s, (triangle_list){0}); /* the drawing is drawn, and nothing else */
    for (uint32_t k = 0; k < d->edges; k++)
        show_edge(s, SVG_PLAIN, d->origin[2 * k], d->origin[2 * k + 1]);
    if (!ask(s))
        return false;
    uint32_t drawn = take_number(s, 0, 100, "the status of graph_from_drawing");
    expect(s, drawn == TRI_OK, "graph_from_drawing returned the status \"%s\"",
           tri_status_text((tri_status)drawn));
    uint32_t status = take_number(s, 0, 100, "the status");
    return expect(s, status == TRI_OK, "the function returned the status \"%s\"",
                  tri_status_text((tri_status)status));
}

/* ---- 2.2-a: the counts. ---- */

typedef struct counts {
    uint32_t v, e, f, h, components;
} counts;

static counts
ask_counts(session *s, const drawing *d)
{
    counts c = {0};
    if (!ask_about(s, 'a', d))
        return c;
    c.v = take_number(s, 0, UINT32_MAX, "v");
    c.e = take_number(s, 0, UINT32_MAX, "e");
    c.f = take_number(s, 0, UINT32_MAX, "f");
    c.h = take_number(s, 0, UINT32_MAX, "h");
    c.components = take_number(s, 0, UINT32_MAX, "the number of components");
    take_end(s);
    return c;
}

static void
expect_number(session *s, const drawing *d, const char *what, uint32_t seen,
              uint32_t right)
{
    expect(
        s, failed(s) || seen == right,
        "%s is %lu, and should be %lu: the drawing has %lu vertices, %lu edges and %lu "
        "component%s",
        what, (unsigned long)seen, (unsigned long)right, (unsigned long)d->vertices,
        (unsigned long)d->edges, (unsigned long)d->components,
        d->components == 1 ? "" : "s");
}

static void
faces_are_counted(session *s, const site *p, uint32_t n)
{
    static drawing d;
    if (!draw_some(s, p, n, random_below(trial_random(s), 2) == 0, &d))
        return;
    counts c = ask_counts(s, &d);
    expect_number(s, &d, "v", c.v, n);
    expect_number(s, &d, "e", c.e, d.edges);
    expect_number(s, &d, "f", c.f, count_faces(&d));
}

static void
components_are_counted(session *s, const site *p, uint32_t n)
{
    static drawing d;
    if (draw_some(s, p, n, random_below(trial_random(s), 4) == 0, &d))
        expect_number(s, &d, "the number of components", ask_counts(s, &d).components,
                      d.components);
}

static void
sides_are_counted(session *s, const site *p, uint32_t n)
{
    static drawing d;
    if (!draw_some(s, p, n, true, &d))
        return;
    uint32_t sides = 0;
    for (uint32_t h = 0; h < 2 * d.edges; h++)
        sides += d.left[h] == d.outer;
    expect_number(s, &d, "h", ask_counts(s, &d).h, sides);
}

/* ---- 2.2-b: the two trees. ---- */

enum { IN_NEITHER, IN_TREE, IN_COTREE };

/* How many edges went where; the tree and the co-tree must have no cycle. */
static void
take_parts(session *s, const drawing *d, uint32_t count[3], bool tree, bool cotree)
{
    static uint32_t vertex[MOST_VERTICES], walk[2 * MOST_EDGES];
    for (uint32_t v = 0; v < d->vertices; v++)
        vertex[v] = v;
    for (uint32_t w = 0; w < d->walks; w++)
        walk[w] = w;
    for (uint32_t k = 0; k < d->edges && !failed(s); k++) {
        uint32_t a = d->origin[2 * k], b = d->origin[2 * k + 1];
        uint32_t part = take_number(s, 0, 2, "where an edge went");
        count[part]++;
        if (part == (tree ? IN_TREE : IN_COTREE))
            show_edge(s, SVG_NEW, a, b);
        else if (part == IN_NEITHER && tree && cotree)
            show_edge(s, SVG_BAD, a, b);
        bool cycle = (part == IN_TREE && tree && !join(vertex, a, b)) ||
                     (part == IN_COTREE && cotree &&
                      !join(walk, d->left[2 * k], d->left[2 * k + 1]));
        if (!expect(s, !cycle, part == IN_TREE
                                   ? "the edge %lu-%lu closes a cycle of the tree"
                                   : "the dual of edge %lu-%lu closes a cycle of the "
                                     "co-tree",
                    (unsigned long)a, (unsigned long)b)) {
            show_witness(s, a);
            show_witness(s, b);
        }
    }
    take_end(s);
}

static void
check_parts(session *s, const site *p, uint32_t n, bool tree, bool cotree)
{
    static drawing d;
    uint32_t count[3] = {0};
    if (!draw_some(s, p, n, random_below(trial_random(s), 4) != 0, &d) ||
        !ask_about(s, 'b', &d))
        return;
    take_parts(s, &d, count, tree, cotree);
    if (tree)
        expect(
            s, failed(s) || count[IN_TREE] == n - d.components,
            "%lu edges are in the tree; with %lu vertices in %lu components a spanning "
            "tree has %lu",
            (unsigned long)count[IN_TREE], (unsigned long)n,
            (unsigned long)d.components, (unsigned long)(n - d.components));
    /* Isolated vertices have a walk too, which no dual edge reaches: each is the whole
     * co-tree of its component. */
    if (cotree)
        expect(s, failed(s) || count[IN_COTREE] == d.walks - d.components,
               "%lu edges are in the co-tree, and %lu are needed to join the faces",
               (unsigned long)count[IN_COTREE],
               (unsigned long)(d.walks - d.components));
    if (tree && cotree)
        expect(s, failed(s) || count[IN_NEITHER] == 0,
               "%lu edges are in neither tree, and in the plane there is none",
               (unsigned long)count[IN_NEITHER]);
}

static void
tree_spans(session *s, const site *p, uint32_t n)
{
    check_parts(s, p, n, true, false);
}

static void
cotree_spans(session *s, const site *p, uint32_t n)
{
    check_parts(s, p, n, false, true);
}

static void
all_edges_are_used(session *s, const site *p, uint32_t n)
{
    check_parts(s, p, n, true, true);
}

enum { DIFFERENT = CASES_GENERAL | CASES_GRID | CASES_COCIRCULAR | CASES_CONVEX };

const property properties[] = {
    {"2.2-a", "faces", "v, e and f are those of the drawing", "notes 2.2, Theorem 1",
     DIFFERENT, 16, 300, false, faces_are_counted},
    {"2.2-a", "components", "The number of components is that of the drawing",
     "euler.h, euler_count; page 2.2, thm1.P6", DIFFERENT, 16, 300, false,
     components_are_counted},
    {"2.2-a", "hull", "h is the length of the walk along the outer face",
     "notes 2.2, equations (1) to (4); euler.h, euler_count", DIFFERENT, 16, 300, false,
     sides_are_counted},
    {"2.2-b", "tree", "The tree joins all vertices of a component, without a cycle",
     "notes 2.2, proof of Theorem 1; page 2.2, thm1.P2", DIFFERENT, 16, 300, false,
     tree_spans},
    {"2.2-b", "cotree", "The co-tree joins all faces, without a cycle",
     "notes 2.2, proof of Theorem 1; page 2.2, thm1.P3 and thm1.P4", DIFFERENT, 16, 300,
     false, cotree_spans},
    {"2.2-b", "partition", "Each edge is in one of the two trees, and none in neither",
     "notes 2.2, Figure 2; page 2.2, thm1.P5", DIFFERENT, 16, 300, false,
     all_edges_are_used},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
