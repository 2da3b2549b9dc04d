/* main.c - reads the points, runs the peer on the clock, certifies what it has
 * made. */
#include "lib/memory.h"
#include "lib/textio.h"
#include "tools/bench/certify.h"
#include "tools/bench/peers/peer.h"
#include "tools/bench/stopwatch.h"

#include <stdio.h>

static answer
certify(const text_points *in)
{
    peer_answer made = {0};
    answer a = {.right = false, .text = "wrong: no answer"};
    if (!peer_result(&made))
        return a;
    if (made.sorted)
        return certify_sorted(made.points, in->count);
    bool rounded = made.points != NULL;
    a = certify_triangles(rounded ? made.points : in->points, in->count,
                          made.list, true);
    if (a.right && rounded)
        snprintf(a.text, sizeof a.text,
                 "Delaunay, of the points rounded to integers");
    memory_free(made.points);
    triangle_list_free(&made.list);
    return a;
}

int
main(int argc, char **argv)
{
    text_points in;
    text_error error;
    answer a = {.right = true, .text = ""};
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: %s POINTS [certify]\n", argv[0]);
        return 2;
    }
    if (text_read_points(argv[1], &in, &error) != TRI_OK) {
        fprintf(stderr, "%s: %s\n", argv[1], error.text);
        return 2;
    }
    size_t rounds = stopwatch_copies(in.count);
    if (!peer_prepare(in.points, in.count, rounds))
        return 1;
    stopwatch w = stopwatch_start(stopwatch_least(in.count), rounds);
    do {
        if (!peer_round())
            return 1;
    } while (stopwatch_again(&w));
    times t = stopwatch_stop(&w);
    if (argc == 3)
        a = certify(&in);
    printf("%.9f %.9f %.9f %.0f %d %s\n", t.user, t.processor, t.wall, t.bytes,
           a.right, a.text);
    text_points_free(&in);
    return 0;
}
