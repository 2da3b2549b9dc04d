/* tiers.c - what an algorithm asks of the predicates, and who answers.
 *
 *     tiers ALGORITHM POINTS
 *
 * prints in one line: orientation tests, incircle tests, other questions; then
 * how many determinants the filter left to each step of exact.c, and how many
 * were 0. It is linked with the counted library; the benchmark itself is not,
 * since counting takes time.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/contents.h"
#include "lib/textio.h"

#include <inttypes.h>
#include <stdio.h>

int
main(int argc, char **argv)
{
    text_points in;
    text_error error;
    mesh m;
    const algorithm *a = argc == 3 ? contents_find(argv[1]) : NULL;
    if (a == NULL) {
        fprintf(stderr, "usage: %s ALGORITHM POINTS\n", argv[0]);
        return 2;
    }
    if (text_read_points(argv[2], &in, &error) != TRI_OK) {
        fprintf(stderr, "%s: %s\n", argv[2], error.text);
        return 2;
    }
    predicate_count = (predicate_counts){0};
    if (a->triangulate(in.points, in.count, NULL, &m) != TRI_OK)
        return 1;
    predicate_counts c = predicate_count;
    uint64_t others = c.orient3d + c.compare_along + c.compare_distance +
                      c.dot_sign;
    printf("%" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64
           " %" PRIu64 " %" PRIu64 "\n",
           c.orient2d, c.incircle, others, c.signs, c.expansions, c.wide,
           c.zeros);
    mesh_free(&m);
    text_points_free(&in);
    return 0;
}
