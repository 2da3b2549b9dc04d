// boost.cpp - Boost.Polygon (Sydorchuk): Fortune's sweep line, exact for
// integers.
//
// Needs: a compiler for C++ and the package libboost-dev. The points are
// multiplied by a power of two and rounded to integers of 31 bits.
#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <memory>
#include <vector>

extern "C" {
#include "lib/memory.h"
#include "tools/bench/peers/peer.h"
}

using point = boost::polygon::point_data<int>;
using diagram = boost::polygon::voronoi_diagram<double>;

static std::vector<point> points;
static std::unique_ptr<diagram> made;

bool peer_prepare(const point2 *given, uint32_t n, std::size_t)
{
    double largest = 0;
    int exponent;
    for (uint32_t i = 0; i < n; i++)
        largest = std::max(
            {largest, std::fabs(given[i].x), std::fabs(given[i].y)});
    std::frexp(largest, &exponent);
    for (uint32_t i = 0; i < n; i++)
        points.emplace_back(int(std::lrint(
                                std::ldexp(given[i].x, 30 - exponent))),
                            int(std::lrint(
                                std::ldexp(given[i].y, 30 - exponent))));
    return true;
}

bool peer_round()
{
    made = std::make_unique<diagram>();
    boost::polygon::construct_voronoi(points.begin(), points.end(), made.get());
    return true;
}

// A vertex of the diagram is a polygon of the Delaunay subdivision: a fan of
// triangles.
bool peer_result(peer_answer *out)
{
    std::size_t room = 0, n = points.size();
    for (const auto &v : made->vertices()) {
        const auto *e = v.incident_edge();
        do {
            room++;
            e = e->rot_next();
        } while (e != v.incident_edge());
    }
    out->points = static_cast<point2 *>(memory_array(n, sizeof(point2)));
    out->list.corner = static_cast<vertex_id(*)[3]>(
        memory_array(room, sizeof *out->list.corner));
    if (out->points == nullptr || out->list.corner == nullptr)
        return false;
    for (std::size_t i = 0; i < n; i++)
        out->points[i] = {double(points[i].x()), double(points[i].y())};
    for (const auto &v : made->vertices()) {
        const auto *first = v.incident_edge();
        const auto *e = first->rot_next();
        for (; e->rot_next() != first; e = e->rot_next()) {
            vertex_id *corner = out->list.corner[out->list.count++];
            corner[0] = vertex_id(first->cell()->source_index());
            corner[1] = vertex_id(e->cell()->source_index());
            corner[2] = vertex_id(e->rot_next()->cell()->source_index());
        }
    }
    return true;
}
