// std_sort.cpp - the yardstick of C++: is ours as fast?
//
//     std_sort FILE     sorts the pairs of doubles in the file; prints the seconds,
//                       the mean of as many sorts as are long enough for the clock
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

struct point {
    double x, y;
};

static bool operator<(point p, point q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

int main(int argc, char **argv)
{
    std::FILE *file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
    if (file == nullptr)
        return 2;
    std::vector<point> points;
    point p;
    while (std::fread(&p, sizeof p, 1, file) == 1)
        points.push_back(p);
    std::fclose(file);
    std::size_t rounds = points.empty() ? 0 : 1 + 4000000 / points.size();
    std::vector<std::vector<point>> copies(rounds, points);
    std::clock_t start = std::clock();
    for (std::vector<point> &copy : copies)
        std::sort(copy.begin(), copy.end());
    double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("%.9f\n", seconds / double(rounds));
}
