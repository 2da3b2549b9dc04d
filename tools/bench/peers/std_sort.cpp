// std_sort.cpp - not a triangulation: std::sort, the sort that everybody has.
//
// Needs: a compiler for C++. It shows that the yardstick is a good one.
#include <algorithm>
#include <vector>

extern "C" {
#include "lib/memory.h"
#include "tools/bench/peers/peer.h"
}

static std::vector<point2> copies; // one after the other, each sorted once
static std::size_t count, done;

static bool operator<(point2 p, point2 q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

bool peer_prepare(const point2 *points, uint32_t n, std::size_t rounds)
{
    count = n;
    for (std::size_t i = 0; i < rounds; i++)
        copies.insert(copies.end(), points, points + n);
    return true;
}

bool peer_round()
{
    std::sort(copies.data() + done * count, copies.data() + (done + 1) * count);
    done++;
    return true;
}

bool peer_result(peer_answer *out)
{
    out->points = static_cast<point2 *>(memory_array(count, sizeof(point2)));
    std::copy(copies.data(), copies.data() + count, out->points);
    out->sorted = true;
    return true;
}
