/* contents.c - the table of all algorithms. */
#include "chapters/contents.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.2_empty_circumcircle/empty_circle.h"
#include "chapters/3.3_lifting_map/lower_hull.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "chapters/3.6_randomized_incremental/biased_order.h"
#include "chapters/3.6_randomized_incremental/bucket_grid.h"
#include "chapters/3.7_divide_and_conquer/divide.h"
#include "chapters/3.7_divide_and_conquer/fast_divide.h"

#include <string.h>

const algorithm contents[] = {
    {"sweep", "2.3", "sweep_triangulate", sweep_triangulate, false, UINT32_MAX,
     "a line sweeps over the points (Figure 3)", &sweep_steps},
    {"brute", "3.2", "brute_triangulate", brute_triangulate, true, 24,
     "all triangles whose circles enclose no site: n^4 questions", NULL},
    {"lift", "3.3", "lift_triangulate", lift_triangulate, true, 5000,
     "the underside of a convex hull in space (Figure 8)", NULL},
    {"lawson", "3.5", "lawson_triangulate", lawson_triangulate, true, UINT32_MAX,
     "the sweep, then edge flips until all edges are locally Delaunay (Figure 10)",
     &lawson_steps},
    {"incremental", "3.6", "incremental_triangulate", incremental_triangulate, true,
     UINT32_MAX,
     "points are inserted in random order, with edge flips (Figure 12)",
     &incremental_steps},
    {"biased", "3.6", "biased_triangulate", biased_triangulate, true, UINT32_MAX,
     "the same in an order that is random enough, and short to walk along",
     &incremental_steps},
    {"bucketed", "3.6", "bucketed_triangulate", bucketed_triangulate, true, UINT32_MAX,
     "inserted at random, each after a walk from a vertex in a grid of buckets",
     &incremental_steps},
    {"divide", "3.7", "divide_triangulate", divide_triangulate, true, UINT32_MAX,
     "halves, divided along a line again and again, are merged", &divide_steps},
    {"fast", "3.7", "fast_divide_triangulate", fast_divide_triangulate, true,
     UINT32_MAX, "the same, cut across and along, laid out for a machine", NULL},
};

const uint32_t contents_count = sizeof contents / sizeof contents[0];

const algorithm *
contents_find(const char *name)
{
    for (uint32_t i = 0; i < contents_count; i++)
        if (strcmp(contents[i].name, name) == 0)
            return &contents[i];
    return NULL;
}
