/* certify.c - the project's own checkers, which are exact, look at each answer.
 */
#include "tools/bench/certify.h"

#include "chapters/2.1_simplicial_complexes/complex.h"
#include "chapters/3.5_edge_flips/flips.h"

#include <stdio.h>

answer
certify_triangles(const point2 *points, uint32_t n, triangle_list list,
                  bool delaunay)
{
    answer a = {.right = false};
    verdict v;
    tri_status status = delaunay ? is_delaunay(points, n, list, &v)
                                 : is_triangulation(points, n, list, &v);
    a.right = status == TRI_OK && v.holds;
    if (status != TRI_OK)
        snprintf(a.text, sizeof a.text, "not checked: %s",
                 tri_status_text(status));
    else if (v.holds)
        snprintf(a.text, sizeof a.text, "%s",
                 delaunay ? "Delaunay" : "triangulation");
    else
        snprintf(a.text, sizeof a.text, "wrong: %.80s", v.because);
    return a;
}

answer
certify_sorted(const point2 *points, uint32_t n)
{
    answer a = {.right = true, .text = "sorted"};
    for (uint32_t i = 1; i < n && a.right; i++) {
        point2 p = points[i - 1], q = points[i];
        a.right = p.x < q.x || (p.x == q.x && p.y <= q.y);
        if (!a.right)
            snprintf(a.text, sizeof a.text,
                     "wrong: point %lu is before the one in front",
                     (unsigned long)i);
    }
    return a;
}
