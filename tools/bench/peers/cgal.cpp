// cgal.cpp - CGAL, 2D Triangulations (Yvinec): incremental insertion along a
// space-filling curve, with exact predicates.
//
// Needs: a compiler for C++ and the package libcgal-dev.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <memory>
#include <vector>

extern "C" {
#include "lib/memory.h"
#include "tools/bench/peers/peer.h"
}

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using point = kernel::Point_2;
using triangulation = CGAL::Delaunay_triangulation_2<kernel>;

static std::vector<point> points;
static std::unique_ptr<triangulation> made;

bool peer_prepare(const point2 *given, uint32_t n, std::size_t)
{
    points.reserve(n);
    for (uint32_t i = 0; i < n; i++)
        points.emplace_back(given[i].x, given[i].y);
    return true;
}

bool peer_round()
{
    made.reset();
    made = std::make_unique<triangulation>(points.begin(), points.end());
    return true;
}

// Its vertices are points: their indices are found again in a sorted list.
bool peer_result(peer_answer *out)
{
    std::vector<vertex_id> order(points.size());
    for (vertex_id i = 0; i < order.size(); i++)
        order[i] = i;
    std::sort(order.begin(), order.end(), [](vertex_id i, vertex_id k) {
        return points[i] < points[k] || (points[i] == points[k] && i < k);
    });
    auto index = [&](const point &p) {
        return *std::lower_bound(order.begin(), order.end(), p,
                                 [](vertex_id i, const point &q) {
                                     return points[i] < q;
                                 });
    };
    std::size_t triangles = made->number_of_faces(), t = 0;
    out->list.count = static_cast<uint32_t>(triangles);
    out->list.corner = static_cast<vertex_id(*)[3]>(
        memory_array(triangles, sizeof *out->list.corner));
    if (out->list.corner == nullptr)
        return false;
    for (auto f = made->finite_faces_begin(); f != made->finite_faces_end();
         ++f, ++t)
        for (int i = 0; i < 3; i++)
            out->list.corner[t][i] = index(f->vertex(i)->point());
    return true;
}
