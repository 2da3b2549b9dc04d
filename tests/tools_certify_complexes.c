/* What is enough to check is enough: simplicial complexes, spanning trees, and
 * the questions about Voronoi diagrams.
 *
 * Hypotheses: none but small integers. The certifiers are asked about all edges, and
 * many lists of simplices, on a few points of a small grid, and compared with the
 * definitions, written down slowly: with intersections and all subsets.
 */
#include "tests/harness/sites.h"
#include "tools/checks/cases.h"
#include "tools/checks/complexes.h"
#include "tools/checks/diagrams.h"
#include "tools/checks/trees.h"

#include <math.h>
#include <string.h>

/* ---- Complexes. ---- */

/* Is there a line with s on one side and t on the other, and not both of them in it?
 * With two points of s and t on it, or square to two: others need not be tried. */
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
            list.item[some(list.count)] =
                list.item[list.count - 1]; /* drop, or repeat */
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

/* On the bisector of p and q, at the middle plus t times the normal, r is farther than
 * p exactly where a + b t > 0. */
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
            CLAIM("certify.edges",
                  share_an_edge(p.at, p.n, a, b) == share_an_edge_slowly(&p, a, b),
                  "%u and %u", (unsigned)i, (unsigned)j);
            for (uint32_t k = 0; k < p.n; k++) {
                site c = p.at[k];
                /* The centre is (x, y) / d; distances are compared, multiplied by d. */
                int64_t d = 2 * area(a, b, c), bx = b.x - a.x, by = b.y - a.y,
                        cx = c.x - a.x, cy = c.y - a.y, b2 = bx * bx + by * by,
                        c2 = cx * cx + cy * cy;
                int64_t x = cy * b2 - by * c2, y = bx * c2 - cx * b2;
                bool empty = true;
                for (uint32_t l = 0; l < p.n; l++) {
                    int64_t rx = d * (p.at[l].x - a.x) - x,
                            ry = d * (p.at[l].y - a.y) - y;
                    empty = empty && rx * rx + ry * ry >= x * x + y * y;
                }
                if (d != 0)
                    CLAIM("certify.circles",
                          circle_is_empty(p.at, p.n, a, b, c) == empty, "%u, %u, %u",
                          (unsigned)i, (unsigned)j, (unsigned)k);
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
        site p = s.at[i % s.n], from = s.at[i / s.n % s.n],
             q = s.at[i / s.n / s.n % s.n], r = s.at[i / s.n / s.n / s.n];
        if (same(p, from) || same(p, q) || same(p, r))
            continue;
        double first = turn(p, from, q), second = turn(p, from, r);
        if (fabs(first - second) > 1e-9)
            CLAIM("certify.turns", is_met_before(p, from, q, r) == (first < second),
                  "(%d,%d) from (%d,%d): (%d,%d) or (%d,%d)?", p.x, p.y, from.x, from.y,
                  q.x, q.y, r.x, r.y);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv,
               "What is enough to check is enough: complexes, trees, diagrams");
    test_grid_subsets("lists of simplices", some_lists_of_simplices, 3);
    test_grid_subsets("every set of edges is a tree or not", every_set_of_edges, 3);
    test_random("regions and circles", regions_and_circles, 1000, 5);
    test_grid_subsets("directions in order", directions_in_order, 3);
    return test_end((test_minima){.trials = 2500, .largest_n = 5});
}
