/* flipgraph.c - tri flipgraph: all triangulations of a few points. */
#include "tools/tri/tri.h"

#include "chapters/3.5_edge_flips/flip_picture.h"
#include "lib/memory.h"

#include <string.h>
#include <time.h>
#include <unistd.h>

/* Where counting ends: so many triangulations of so many points need less than
 * half a gigabyte. And where the diameter is only bounded, as that takes
 * longer. */
enum {
    MOST_NODES = 1000000,
    MOST_POINTS = 64,
    MOST_NODES_FOR_DIAMETER = 50000
};

typedef struct watcher {
    trace base; /* first: see lib/trace.h */
    const flip_graph *g;
    uint32_t flips;
    bool terminal;
    time_t last_line; /* when progress was written */
} watcher;

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    (void)m;
    (void)event;
    watcher *w = (watcher *)self;
    /* The clock is asked rarely, as asking takes longer than counting. */
    if (w->terminal && ++w->flips % 65536 == 0 && time(NULL) != w->last_line) {
        fprintf(stderr, "\rtri: %lu triangulations ",
                (unsigned long)w->g->nodes);
        w->last_line = time(NULL);
    }
    return w->g->nodes > MOST_NODES;
}

static void
build(const text_points *in, flip_graph *g)
{
    if (in->count > MOST_POINTS)
        die("tri: %lu points have too many triangulations: use at most %d",
            (unsigned long)in->count, MOST_POINTS);
    watcher w = {{see}, g, 0, isatty(STDERR_FILENO) == 1, time(NULL)};
    time_t begin = w.last_line;
    tri_options options = tri_options_default();
    options.trace = &w.base;
    tri_status status = flip_graph_build(in->points, in->count, &options, g);
    if (w.last_line != begin)
        fputc('\n', stderr);
    if (status == TRI_CANCELLED)
        die("tri: there are more than %d triangulations: use fewer points",
            MOST_NODES);
    must(status);
    if (w.terminal && g->nodes > MOST_NODES_FOR_DIAMETER / 5)
        fprintf(stderr, "tri: %lu triangulations, now their distances\n",
                (unsigned long)g->nodes);
}

/* A large distance in the graph, found by going from a node to one of those
 * that are farthest from it, several times. (It need not grow each time.) */
static uint32_t
large_distance(const flip_graph *g)
{
    uint32_t *distance = memory_array(g->nodes, 2 * sizeof *distance);
    if (distance == NULL)
        must(TRI_OUT_OF_MEMORY);
    uint32_t *order = distance + g->nodes, from = 0, largest = 0;
    for (int times = 0; times < 10; times++) {
        flip_graph_distances(g, from, distance, order);
        from = order[g->nodes - 1];
        if (distance[from] > largest)
            largest = distance[from];
    }
    memory_free(distance);
    return largest;
}

static void
print_survey(const flip_graph *g)
{
    uint32_t diameter, delaunay = 0;
    bool exact = g->nodes <= MOST_NODES_FOR_DIAMETER;
    if (exact)
        must(flip_graph_diameter(g, &diameter));
    else
        diameter = large_distance(g);
    for (uint32_t node = 0; node < g->nodes; node++)
        delaunay += g->is_delaunay[node];
    printf("triangulations %lu\n", (unsigned long)g->nodes);
    printf("flip edges %lu\n", (unsigned long)flip_graph_flips(g));
    printf("diameter %s%lu\n", exact ? "" : "at least ",
           (unsigned long)diameter);
    printf("delaunay %lu\n", (unsigned long)delaunay);
}

int
command_flipgraph(int argc, char **argv)
{
    const char *picture = take_option(&argc, argv, "--svg");
    expect_words(argc, argv, 1, 1);
    if (picture != NULL && strcmp(picture, "-") == 0)
        die_usage(argv[0],
                  "--svg needs a name: the numbers go to standard output");
    check_output(picture);
    text_points in = load_points(argv[1]);
    flip_graph g;
    build(&in, &g);
    if (picture != NULL && g.nodes > FLIP_PICTURE_MOST_NODES)
        die("tri: %lu triangulations are too many for a picture: at most %d "
            "can be told "
            "apart",
            (unsigned long)g.nodes, FLIP_PICTURE_MOST_NODES);
    print_survey(&g);
    if (picture != NULL) {
        output o = begin_output(picture);
        flip_graph_draw(&g, in.points, o.file, "Flip graph");
        finish_output(&o, picture);
    }
    flip_graph_free(&g);
    text_points_free(&in);
    return EXIT_HOLDS;
}
