/* graphs.c - tri emst, gabriel, rng and nng: graphs inside the Delaunay
 * triangulation. */
#include "tools/tri/tri.h"

#include "chapters/3.2_empty_circumcircle/graphs.h"

#include <string.h>

typedef struct graph {
    const char *command;
    tri_status (*make)(const mesh *m, const point2 *points, edge_list *out);
} graph;

static const graph graphs[] = {
    {"emst", emst},
    {"gabriel", gabriel_graph},
    {"rng", relative_neighbourhood_graph},
    {"nng", nearest_neighbour_graph},
};

/* The graph that the command is named for. */
static const graph *
find_graph(const char *name)
{
    const graph *g = graphs;
    while (strcmp(g->command, name) != 0)
        g++;
    return g;
}

int
command_graph(int argc, char **argv)
{
    const graph *g = find_graph(argv[0]);
    const char *path = take_option(&argc, argv, "-o");
    expect_words(argc, argv, 1, 1);
    if (path == NULL)
        path = "-";
    check_output(path);
    text_points in = load_points(argv[1]);

    mesh m;
    edge_list edges;
    must(default_algorithm()->triangulate(in.points, in.count, NULL, &m));
    must(g->make(&m, in.points, &edges));
    note_copies(in.count, m.locations);
    output o = begin_output(path);
    text_write_edges(o.file, edges, in.first);
    finish_output(&o, path);

    edge_list_free(&edges);
    mesh_free(&m);
    text_points_free(&in);
    return EXIT_HOLDS;
}
