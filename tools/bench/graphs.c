/* graphs.c - the graphs of 3.2 beside sorting the points. */
#include "tools/bench/graphs.h"

#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "lib/memory.h"
#include "tools/bench/stopwatch.h"

const char *const graph_name[GRAPHS] = {"emst", "gabriel", "rng", "nng"};

/* Makes the graph; true if it could. */
static bool
make_graph(int graph, const mesh *m, const point2 *points)
{
    edge_list edges;
    tri_status status = graph == 0   ? emst(m, points, &edges)
                        : graph == 1 ? gabriel_graph(m, points, &edges)
                        : graph == 2 ? relative_neighbourhood_graph(m, points, &edges)
                                     : nearest_neighbour_graph(m, points, &edges);
    edge_list_free(&edges);
    return status == TRI_OK;
}

/* The user time of one graph; negative when there is no memory. */
static double
seconds_for(int graph, const mesh *m, const point2 *points, uint32_t n)
{
    bool well = true;
    stopwatch w = stopwatch_start(stopwatch_least(n), SIZE_MAX);
    do {
        well = make_graph(graph, m, points) && well;
    } while (stopwatch_again(&w));
    return well ? stopwatch_stop(&w).user : -1;
}

bool
measure_graphs(const bench *b, const distribution *d, uint32_t n,
               double times_sorting[GRAPHS])
{
    enum { RUNS = 3 };
    double sort[RUNS], graph[GRAPHS][RUNS];
    point2 *points = make_points(d, n);
    mesh m;
    bool well = subject()->triangulate(points, n, NULL, &m) == TRI_OK;
    for (int k = 0; k < RUNS && well; k++) {
        run r = measure(NULL, NULL, points, n, b->seconds, false);
        well = r.end == RUN_DONE;
        sort[k] = r.times.user;
        for (int g = 0; g < GRAPHS && well; g++) {
            graph[g][k] = seconds_for(g, &m, points, n);
            well = graph[g][k] >= 0;
        }
    }
    for (int g = 0; g < GRAPHS && well; g++)
        times_sorting[g] =
            summarize(graph[g], RUNS).least / summarize(sort, RUNS).least;
    mesh_free(&m);
    memory_free(points);
    return well;
}
