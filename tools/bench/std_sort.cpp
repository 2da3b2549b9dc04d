// std_sort.cpp - is the yardstick a good one? It and std::sort take turns.
//
// The only C++ of the project; `make bench` builds and runs it where there is g++.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <vector>

extern "C" {
#include "tools/bench/yardstick.h"
}

static bool operator<(point2 p, point2 q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

static double now()
{
    return double(std::clock()) / CLOCKS_PER_SEC;
}

int main()
{
    std::mt19937_64 source;
    std::uniform_real_distribution<double> unit;
    std::vector<point2> points(1000000);
    for (point2 &p : points)
        p = {unit(source), unit(source)};

    double ours = 1e9, theirs = 1e9;
    for (int turn = 0; turn < 7; turn++) {
        std::vector<point2> a = points, b = points;
        double start = now();
        yardstick_sort(a.data(), a.size());
        double middle = now();
        std::sort(b.begin(), b.end());
        double end = now();
        ours = std::min(ours, middle - start);
        theirs = std::min(theirs, end - middle);
        for (std::size_t i = 0; i < a.size(); i++)
            if (a[i] < b[i] || b[i] < a[i])
                return std::puts("the yardstick does not sort"), 1;
    }
    std::printf("the yardstick sorts %lu uniform points in %.3f s, std::sort in %.3f s: "
                "%.2f times as long\n", (unsigned long)points.size(), ours, theirs,
                ours / theirs);
}
