/* What is enough to check is enough: the certifiers of the grader accept exactly what the
 * definitions accept.
 *
 * Hypotheses: none but small integers. Each certifier is asked about every answer that
 * there is to a few points of a small grid, where ties of all kinds come up, and about
 * good answers that are broken in some way. The definitions are written down here once
 * more, slowly: with areas, intersections, and all subsets.
 */
#include "tests/harness/harness.h"
#include "tools/checks/cases.h"
#include "tools/checks/certify.h"
#include "tools/checks/complexes.h"
#include "tools/checks/diagrams.h"
#include "tools/checks/meshes.h"
#include "tools/checks/trees.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 16, MOST_LIST = 64 };

/* ---- Points and lists. ---- */

typedef struct problem {
    site at[MOST];
    uint32_t n;
} problem;

static problem
problem_of(const point2 *points, uint32_t n)
{
    problem p = {.n = n};
    for (uint32_t i = 0; i < n; i++)
        p.at[i] = (site){(int32_t)points[i].x, (int32_t)points[i].y};
    return p;
}

static uint32_t
some(uint32_t below)
{
    return random_below(test_random_source(), below);
}

/* Points of a 4 x 4 grid, some of them twice. */
static problem
some_problem(uint32_t most)
{
    problem p = {.n = 3 + some(most - 2)};
    for (uint32_t i = 0; i < p.n; i++)
        p.at[i] = (site){(int32_t)some(4), (int32_t)some(4)};
    return p;
}

/* Twice the area of abc, positive when it is counterclockwise. */
static int64_t
area(site a, site b, site c)
{
    return (int64_t)(b.x - a.x) * (c.y - a.y) - (int64_t)(b.y - a.y) * (c.x - a.x);
}

static bool
same(site p, site q)
{
    return p.x == q.x && p.y == q.y;
}

/* ---- Definition 4, written down slowly. ---- */

/* Is q on the segment from p to r, ends included? */
static bool
is_on_segment(site p, site q, site r)
{
    return area(p, q, r) == 0 && (int64_t)(p.x - q.x) * (r.x - q.x) +
        (int64_t)(p.y - q.y) * (r.y - q.y) <= 0;
}

/* Twice the area of the convex hull: the sum along its edges, each of them from corner to
 * corner. */
static int64_t
area_of_hull(const problem *p)
{
    int64_t sum = 0;
    for (uint32_t i = 0; i < p->n; i++)
        for (uint32_t j = 0; j < p->n; j++) {
            site a = p->at[i], b = p->at[j];
            bool edge = !same(a, b);
            for (uint32_t k = 0; k < p->n; k++) {
                int64_t side = area(a, b, p->at[k]);
                edge = edge && (side > 0 || (side == 0 && is_on_segment(a, p->at[k], b)));
                edge = edge && (k >= i || !same(p->at[k], a)); /* copies: the lowest */
                edge = edge && (k >= j || !same(p->at[k], b));
            }
            if (edge)
                sum += area((site){0, 0}, a, b);
        }
    return sum;
}

/* Is there a line through two of the corners with one triangle on either side? (If not,
 * they have interior points in common.) */
static bool
are_apart(const site *s, const site *t)
{
    for (int i = 0; i < 3; i++) {
        bool apart_s = true, apart_t = true;
        for (int k = 0; k < 3; k++) {
            apart_s = apart_s && area(s[i], s[(i + 1) % 3], t[k]) <= 0;
            apart_t = apart_t && area(t[i], t[(i + 1) % 3], s[k]) <= 0;
        }
        if (apart_s || apart_t)
            return true;
    }
    return false;
}

static void
corners_of(const problem *p, triangle_list list, uint32_t t, site corner[3])
{
    for (int i = 0; i < 3; i++)
        corner[i] = p->at[list.corner[t][i]];
}

/* Counterclockwise triangles that have no interior point in common, have the corners that
 * they should and no other point, and together have the area of the hull. */
static bool
is_triangulation_slowly(const problem *p, triangle_list list)
{
    bool used[MOST] = {false};
    site s[3], t[3];
    int64_t sum = 0;
    for (uint32_t k = 0; k < list.count; k++) {
        corners_of(p, list, k, s);
        if (area(s[0], s[1], s[2]) <= 0)
            return false;
        sum += area(s[0], s[1], s[2]);
        for (int i = 0; i < 3; i++)
            used[list.corner[k][i]] = true;
        for (uint32_t i = 0; i < p->n; i++)
            if (area(s[0], s[1], p->at[i]) >= 0 && area(s[1], s[2], p->at[i]) >= 0 &&
                area(s[2], s[0], p->at[i]) >= 0 && !same(p->at[i], s[0]) &&
                !same(p->at[i], s[1]) && !same(p->at[i], s[2]))
                return false;
        for (uint32_t l = 0; l < k; l++) {
            corners_of(p, list, l, t);
            if (!are_apart(s, t))
                return false;
        }
    }
    for (uint32_t i = 0; i < p->n && list.count > 0; i++) {
        uint32_t indices = 0;
        for (uint32_t k = 0; k < p->n; k++)
            indices += used[k] && same(p->at[k], p->at[i]);
        if (indices != 1)
            return false;
    }
    return sum == area_of_hull(p);
}

/* Definition 7, for all points and all triangles: not only neighbours. */
static bool
is_delaunay_slowly(const problem *p, triangle_list list)
{
    site s[3];
    for (uint32_t k = 0; k < list.count; k++) {
        corners_of(p, list, k, s);
        if (!circle_is_empty(p->at, p->n, s[0], s[1], s[2]))
            return false;
    }
    return is_triangulation_slowly(p, list);
}

static void
compare_lists(const problem *p, triangle_list list)
{
    bool right = is_triangulation_slowly(p, list);
    verdict v = certify_triangulation(p->at, p->n, list);
    CLAIM("certify.triangulation", v.holds == right, "%u points, %u triangles: %s, and %s",
          (unsigned)p->n, (unsigned)list.count, v.holds ? "accepted" : v.because,
          right ? "they are a triangulation" : "they are not");
    right = right && is_delaunay_slowly(p, list);
    v = certify_delaunay(p->at, p->n, list);
    CLAIM("certify.delaunay", v.holds == right, "%u points, %u triangles: %s, and %s",
          (unsigned)p->n, (unsigned)list.count, v.holds ? "accepted" : v.because,
          right ? "they are Delaunay" : "they are not");
}

/* Every set of triangles on four or five points, each counterclockwise (or flat). */
static void
every_list_of_triangles(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n <= 5);
    problem p = problem_of(points, n);
    vertex_id all[10][3], chosen[10][3];
    uint32_t triangles = 0;
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = a + 1; b < n; b++)
            for (uint32_t c = b + 1; c < n; c++) {
                bool turn = area(p.at[a], p.at[b], p.at[c]) < 0;
                const vertex_id abc[3] = {a, turn ? c : b, turn ? b : c};
                memcpy(all[triangles++], abc, sizeof abc);
            }
    for (uint32_t set = 0; set < 1u << triangles; set++) {
        triangle_list list = {.corner = chosen};
        for (uint32_t t = 0; t < triangles; t++)
            if ((set >> t & 1) != 0)
                memcpy(chosen[list.count++], all[t], sizeof all[t]);
        compare_lists(&p, list);
    }
}

/* ---- Good triangulations, broken. ---- */

static void
flip_over(triangle_list list, uint32_t t)
{
    vertex_id b = list.corner[t][1];
    list.corner[t][1] = list.corner[t][2];
    list.corner[t][2] = b;
}

/* Two neighbours abc and bad become dca and cdb, whatever they look like: the counts of
 * Euler's formula stay what they were. */
static void
exchange_diagonal(triangle_list list)
{
    halfedge_id twin[3 * MOST_LIST];
    certify_twins(list, twin);
    halfedge_id e = some(3 * list.count), f = twin[e];
    if (f == NONE)
        return;
    vertex_id a = side_origin(list, e), b = side_dest(list, e);
    vertex_id c = side_apex(list, e), d = side_apex(list, f);
    const vertex_id dca[3] = {d, c, a}, cdb[3] = {c, d, b};
    memcpy(list.corner[e / 3], dca, sizeof dca);
    memcpy(list.corner[f / 3], cdb, sizeof cdb);
}

/* Spoils the list in one of seven ways; sometimes it is as good as before. */
static void
break_list(triangle_list *list, uint32_t n)
{
    uint32_t t = some(list->count);
    switch (some(7)) {
    case 0: /* drop */
        memcpy(list->corner[t], list->corner[list->count - 1], sizeof list->corner[t]);
        list->count--;
        break;
    case 1: /* duplicate */
        memcpy(list->corner[list->count++], list->corner[t], sizeof list->corner[t]);
        break;
    case 2: flip_over(*list, t); break;
    case 3: list->corner[t][some(3)] = some(n); break;
    case 4: /* any other triangle on top */
        for (int i = 0; i < 3; i++)
            list->corner[list->count][i] = some(n);
        list->count++;
        break;
    default: exchange_diagonal(*list); break;
    }
}

/* A triangulation is accepted; broken once or twice, it is what the definition says. */
static void
broken_triangulations(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    problem p = some_problem(MOST - 4);
    vertex_id corner[MOST_LIST][3];
    triangle_list good = mesh_at_random(test_random_source(), p.at, p.n, some(2) == 0);
    compare_lists(&p, good);
    CLAIM("certify.accepts", certify_triangulation(p.at, p.n, good).holds, "%u points",
          (unsigned)p.n);
    for (int trial = 0; trial < 20 && good.count > 0; trial++) {
        triangle_list list = {good.count, corner};
        memcpy(corner, good.corner, good.count * sizeof *corner);
        for (uint32_t times = 1 + some(2); times > 0 && list.count > 0; times--)
            break_list(&list, p.n);
        compare_lists(&p, list);
    }
    triangle_list_free(&good);
}

/* A star of five triangles around a point: each directed side once, all triangles
 * counterclockwise, v - e + f = 1, a boundary that only turns left; and it winds twice. */
static void
the_pentagram_is_refused(void)
{
    problem p = {{{0, -10}, {10, -3}, {6, 8}, {-6, 8}, {-10, -3}, {0, 0}}, 6};
    vertex_id corner[5][3];
    triangle_list list = {5, corner};
    uint32_t star[5];
    for (uint32_t i = 0; i < 5; i++) {
        const vertex_id t[3] = {i, (i + 2) % 5, 5};
        memcpy(corner[i], t, sizeof t);
        star[i] = 2 * i % 5;
        CLAIM("certify.pentagram", area(p.at[t[0]], p.at[t[1]], p.at[t[2]]) > 0,
              "triangle %u is not counterclockwise", (unsigned)i);
    }
    verdict v = certify_triangulation(p.at, p.n, list);
    CLAIM("certify.pentagram", !v.holds && strstr(v.because, "2 times") != NULL, "%s",
          v.holds ? "accepted" : v.because);
    v = certify_hull(p.at, p.n, star, 5);
    CLAIM("certify.pentagram", !v.holds && strstr(v.because, "2 times") != NULL, "%s",
          v.holds ? "accepted" : v.because);
}

/* ---- Hulls. ---- */

/* The point after a on the hull: the nearest such that none is right of the way there. */
static uint32_t
next_on_hull(const problem *p, uint32_t a)
{
    for (uint32_t b = 0; b < p->n; b++) {
        bool good = !same(p->at[a], p->at[b]);
        for (uint32_t k = 0; good && k < p->n; k++) {
            int64_t side = area(p->at[a], p->at[b], p->at[k]);
            bool between = side == 0 && is_on_segment(p->at[a], p->at[k], p->at[b]) &&
                !same(p->at[k], p->at[a]) && !same(p->at[k], p->at[b]);
            good = side >= 0 && !between;
        }
        if (good)
            return b;
    }
    return NONE;
}

/* Follows the hull once around and compares. */
static bool
is_hull_slowly(const problem *p, const vertex_id *hull, uint32_t count)
{
    uint32_t a = count > 0 ? hull[0] : NONE, start = a;
    for (uint32_t i = 0; i < count; i++) {
        if (a == NONE || !same(p->at[a], p->at[hull[i]]))
            return false;
        a = next_on_hull(p, a);
        bool around = a != NONE && same(p->at[a], p->at[start]);
        if (around != (i + 1 == count))
            return false;
    }
    return count > 0;
}

/* Collinear points: all locations, from one end to the other. */
static bool
is_path_slowly(const problem *p, const vertex_id *path, uint32_t count)
{
    uint32_t lowest[MOST];
    if (count != cases_locations(p->at, p->n, lowest))
        return false;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = i + 2; k < count; k++)
            for (uint32_t j = i + 1; j < k; j++)
                if (!is_on_segment(p->at[path[i]], p->at[path[j]], p->at[path[k]]))
                    return false;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; k < i; k++)
            if (same(p->at[path[i]], p->at[path[k]]))
                return false;
    return true;
}

static void
compare_hull(const problem *p, const vertex_id *hull, uint32_t count)
{
    bool right = cases_are_collinear(p->at, p->n) ? is_path_slowly(p, hull, count)
                                                  : is_hull_slowly(p, hull, count);
    verdict v = certify_hull(p->at, p->n, hull, count);
    CLAIM("certify.hull", v.holds == right, "%u vertices, from %u on: %s, and %s",
          (unsigned)count, count > 0 ? (unsigned)hull[0] : 0,
          v.holds ? "accepted" : v.because, right ? "they are the hull" : "they are not");
}

/* Every row of at most five different points is, or is not, the hull. */
static void
every_row_of_points(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n <= 6);
    problem p = problem_of(points, n);
    uint32_t rows = 1;
    for (uint32_t i = 0; i < n; i++)
        rows *= n + 1;
    for (uint32_t code = 0; code < rows; code++) { /* the digits; n ends the row */
        vertex_id row[MOST];
        uint32_t count = 0, rest = code;
        bool ended = false, good = true;
        for (uint32_t i = 0; i < n; i++, rest /= n + 1) {
            uint32_t digit = rest % (n + 1);
            good = good && (!ended || digit == n);
            ended = ended || digit == n;
            for (uint32_t k = 0; k < count; k++)
                good = good && (ended || row[k] != digit || code % 7 == 0);
            if (!ended)
                row[count++] = digit;
        }
        if (good)
            compare_hull(&p, row, count);
    }
}

/* ---- Complexes. ---- */

/* Is there a line with s on one side and t on the other, and not both of them in it? With
 * two points of s and t on it, or square to two: others need not be tried. */
static bool
interiors_are_disjoint(const site *s, int s_count, const site *t, int t_count)
{
    site all[6];
    memcpy(all, s, (size_t)s_count * sizeof *s);
    memcpy(all + s_count, t, (size_t)t_count * sizeof *t);
    for (int i = 0; i < s_count + t_count; i++)
        for (int j = 0; j < s_count + t_count; j++)
            for (int square = 0; square < 2; square++) {
                site d = {all[j].x - all[i].x, all[j].y - all[i].y};
                int64_t x = square ? d.x : -d.y, y = square ? d.y : d.x;
                int64_t most = INT64_MIN, least = INT64_MAX, lowest = INT64_MAX,
                        highest = INT64_MIN;
                for (int k = 0; k < s_count + t_count; k++) {
                    int64_t height = x * all[k].x + y * all[k].y;
                    if (k < s_count && height > most)
                        most = height;
                    if (k >= s_count && height < least)
                        least = height;
                    lowest = height < lowest ? height : lowest;
                    highest = height > highest ? height : highest;
                }
                if (most <= least && lowest < highest)
                    return true;
            }
    return false;
}

/* Definition 3, in other words: no simplex is flat, each face is listed, and different
 * simplices have no point in common that is inside both. */
static bool
is_complex_slowly(const problem *p, const face_list *list)
{
    for (uint32_t i = 0; i < list->count; i++) {
        const face *f = &list->item[i];
        site s[3], t[3];
        for (int k = 0; k <= f->dimension; k++)
            s[k] = p->at[f->vertex[k]];
        if ((f->dimension == 2 && area(s[0], s[1], s[2]) == 0) ||
            (f->dimension == 1 && same(s[0], s[1])))
            return false;
        face_list faces = {.count = 0};
        faces_close(&faces, f);
        for (uint32_t k = 0; k < faces.count; k++)
            if (!face_is_listed(list, &faces.item[k]))
                return false;
        for (uint32_t j = 0; j < i; j++) {
            const face *g = &list->item[j];
            for (int k = 0; k <= g->dimension; k++)
                t[k] = p->at[g->vertex[k]];
            if (!interiors_are_disjoint(s, f->dimension + 1, t, g->dimension + 1))
                return false;
        }
    }
    return true;
}

static void
some_lists_of_simplices(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    problem p = problem_of(points, n);
    bool marked[MOST];
    memset(marked, true, sizeof marked);
    for (int trial = 0; trial < 40; trial++) {
        face_list list = {.count = 0};
        for (uint32_t wanted = 1 + some(4); wanted > 0; wanted--) {
            face f = {.dimension = -1};
            for (uint32_t v = 0; v < n; v++)
                if (f.dimension < 2 && some(3) == 0)
                    f.vertex[++f.dimension] = v;
            if (f.dimension >= 0)
                faces_close(&list, &f);
        }
        if (list.count > 0 && some(3) == 0)
            list.item[some(list.count)] = list.item[list.count - 1]; /* drop, or repeat */
        if (list.count > 0 && some(2) == 0)
            list.count--;
        bool right = is_complex_slowly(&p, &list);
        const char *fault = faces_fault(p.at, p.n, &list, marked);
        CLAIM("certify.complex", (fault == NULL) == right, "%u simplices: %s, and %s",
              (unsigned)list.count, fault == NULL ? "accepted" : fault,
              right ? "they are a complex" : "they are not");
    }
}

/* ---- Trees. ---- */

/* Every set of edges on five points; the least sum of squares among those that span is
 * that of a minimum spanning tree, as squares have the order of lengths. */
static void
every_set_of_edges(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n <= 5);
    problem p = problem_of(points, n);
    for (uint32_t i = 1; i < n && some(2) == 0; i++) /* and copies */
        p.at[i] = p.at[some(n)];
    tree_edge all[10], chosen[10];
    uint32_t edges = 0, lowest[MOST], u = cases_locations(p.at, n, lowest);
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = a + 1; b < n; b++)
            all[edges++] = (tree_edge){a, b};
    int64_t least = INT64_MAX, sums[1 << 10];
    for (uint32_t set = 0; set < 1u << edges; set++) {
        uint32_t count = 0, class[MOST], classes = u;
        int64_t sum = 0;
        for (uint32_t v = 0; v < n; v++)
            for (class[v] = 0; !same(p.at[class[v]], p.at[v]);)
                class[v]++;
        for (uint32_t k = 0; k < edges; k++) {
            if ((set >> k & 1) == 0)
                continue;
            tree_edge e = chosen[count++] = all[k];
            int64_t x = p.at[e.a].x - p.at[e.b].x, y = p.at[e.a].y - p.at[e.b].y;
            uint32_t a = class[e.a], b = class[e.b];
            sum += x * x + y * y;
            classes -= a != b;
            for (uint32_t v = 0; v < n; v++)
                class[v] = class[v] == b ? a : class[v];
        }
        bool spans = classes <= 1 && count + 1 == u + (u == 0);
        verdict v = certify_spanning(p.at, n, chosen, count);
        CLAIM("certify.spanning", v.holds == spans, "%u edges, %u locations: %s",
              (unsigned)count, (unsigned)u, v.holds ? "accepted" : v.because);
        sums[set] = spans ? sum : -1;
        least = spans && sum < least ? sum : least;
    }
    for (uint32_t set = 0; set < 1u << edges; set++) {
        uint32_t count = 0;
        for (uint32_t k = 0; k < edges; k++)
            if ((set >> k & 1) != 0)
                chosen[count++] = all[k];
        if (sums[set] >= 0)
            CLAIM("certify.minimum",
                  certify_minimum(p.at, n, chosen, count).holds == (sums[set] == least),
                  "a tree with the squares %lld is judged; the least is %lld",
                  (long long)sums[set], (long long)least);
    }
}

/* ---- Voronoi diagrams. ---- */

/* On the bisector of p and q, at the middle plus t times the normal, r is farther than p
 * exactly where a + b t > 0. */
static void
half_line(site p, site q, site r, int64_t *a, int64_t *b)
{
    int64_t x = r.x - p.x, y = r.y - p.y;
    *a = -((int64_t)(p.x + q.x) * x + (int64_t)(p.y + q.y) * y) + (int64_t)r.x * r.x +
        (int64_t)r.y * r.y - (int64_t)p.x * p.x - (int64_t)p.y * p.y;
    *b = -2 * (-(int64_t)(q.y - p.y) * x + (int64_t)(q.x - p.x) * y);
}

/* Do these half-lines, each open, have more than nothing in common? -a/b bounds t. */
static bool
share_an_edge_slowly(const problem *s, site p, site q)
{
    for (uint32_t i = 0; i < s->n; i++)
        for (uint32_t j = 0; j < s->n; j++) {
            int64_t a, b, c, d;
            if (same(s->at[i], p) || same(s->at[i], q) || same(s->at[j], p) ||
                same(s->at[j], q))
                continue;
            half_line(p, q, s->at[i], &a, &b);
            half_line(p, q, s->at[j], &c, &d);
            if (b == 0 && a <= 0)
                return false;
            if (b > 0 && d < 0 && -a * -d >= c * b) /* -a/b < t < c/-d is empty */
                return false;
        }
    return true;
}

static void
regions_and_circles(const point2 *points, uint32_t n)
{
    (void)points, (void)n;
    problem p = some_problem(8);
    for (uint32_t i = 0; i < p.n; i++)
        for (uint32_t j = 0; j < p.n; j++) {
            site a = p.at[i], b = p.at[j];
            if (same(a, b))
                continue;
            CLAIM("certify.edges", share_an_edge(p.at, p.n, a, b) ==
                  share_an_edge_slowly(&p, a, b), "%u and %u", (unsigned)i, (unsigned)j);
            for (uint32_t k = 0; k < p.n; k++) {
                site c = p.at[k];
                /* The centre is (x, y) / d; distances are compared, multiplied by d. */
                int64_t d = 2 * area(a, b, c), bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x,
                        cy = c.y - a.y, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
                int64_t x = cy * b2 - by * c2, y = bx * c2 - cx * b2;
                bool empty = true;
                for (uint32_t l = 0; l < p.n; l++) {
                    int64_t rx = d * (p.at[l].x - a.x) - x, ry = d * (p.at[l].y - a.y) - y;
                    empty = empty && rx * rx + ry * ry >= x * x + y * y;
                }
                if (d != 0)
                    CLAIM("certify.circles", circle_is_empty(p.at, p.n, a, b, c) == empty,
                          "%u, %u, %u", (unsigned)i, (unsigned)j, (unsigned)k);
            }
        }
}

/* The turn from one direction to another, in 0 .. 2 pi. */
static double
turn(site p, site from, site to)
{
    double angle = atan2(to.y - p.y, to.x - p.x) - atan2(from.y - p.y, from.x - p.x);
    return angle < -1e-9 ? angle + 6.283185307179586 : fabs(angle);
}

static void
directions_in_order(const point2 *points, uint32_t n)
{
    problem s = problem_of(points, n < 6 ? n : 6);
    for (uint32_t i = 0; i < s.n * s.n * s.n * s.n; i++) {
        site p = s.at[i % s.n], from = s.at[i / s.n % s.n], q = s.at[i / s.n / s.n % s.n],
             r = s.at[i / s.n / s.n / s.n];
        if (same(p, from) || same(p, q) || same(p, r))
            continue;
        double first = turn(p, from, q), second = turn(p, from, r);
        if (fabs(first - second) > 1e-9)
            CLAIM("certify.turns", is_met_before(p, from, q, r) == (first < second),
                  "(%d,%d) from (%d,%d): (%d,%d) or (%d,%d)?", p.x, p.y, from.x, from.y, q.x,
                  q.y, r.x, r.y);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "What is enough to check is enough");
    test_grid_subsets("every list of triangles", every_list_of_triangles, 3);
    test_random("broken triangulations", broken_triangulations, 1500, 5);
    test_run("the pentagram is refused", the_pentagram_is_refused);
    test_grid_subsets("every row of points is the hull or not", every_row_of_points, 3);
    test_grid_subsets("lists of simplices", some_lists_of_simplices, 3);
    test_grid_subsets("every set of edges is a tree or not", every_set_of_edges, 3);
    test_random("regions and circles", regions_and_circles, 1000, 5);
    test_grid_subsets("directions in order", directions_in_order, 3);
    return test_end((test_minima){.trials = 4000, .largest_n = 5});
}
