/* pair.c - two threads on one set of points, and two runs side by side. */
#include "tools/bench/pair.h"

#include "lib/memory.h"

#include <sys/wait.h>
#include <unistd.h>

/* Seconds on the wall of one run with so many threads; negative when it fails.
 */
static double
wall_of_one(const bench *b, const point2 *points, uint32_t n, unsigned threads)
{
    tri_options options = tri_options_default();
    options.threads = threads;
    run r = measure(subject(), &options, points, n, b->seconds, false);
    return r.end == RUN_DONE ? r.times.wall : -1;
}

/* The mean of two runs, of one thread each, that begin at the same time. */
static double
wall_of_two(const bench *b, const point2 *points, uint32_t n)
{
    double sum = 0;
    int ends[2];
    pid_t child[2];
    bool well = pipe(ends) == 0;
    for (int k = 0; k < 2 && well; k++) {
        fflush(NULL);
        child[k] = fork();
        if (child[k] == 0) {
            double seconds = wall_of_one(b, points, n, 1);
            _exit(write(ends[1], &seconds, sizeof seconds) == sizeof seconds
                      ? 0
                      : 2);
        }
        well = child[k] > 0;
    }
    close(ends[1]);
    for (int k = 0; k < 2 && well; k++) {
        double seconds;
        well = read(ends[0], &seconds, sizeof seconds) == sizeof seconds &&
               seconds > 0;
        sum += seconds;
    }
    close(ends[0]);
    while (wait(NULL) > 0)
        continue;
    return well ? sum / 2 : -1;
}

void
compare_threads(const bench *b)
{
    enum { RUNS = 3 };
    static const uint32_t n = 1000000;
    point2 *points = make_points(&distributions[0], n);
    double alone[RUNS], threads[RUNS], beside[RUNS];
    bool well = true;
    for (int k = 0; k < RUNS && well; k++) {
        alone[k] = wall_of_one(b, points, n, 1);
        threads[k] = wall_of_one(b, points, n, 2);
        beside[k] = wall_of_two(b, points, n);
        well = alone[k] > 0 && threads[k] > 0 && beside[k] > 0;
    }
    memory_free(points);
    if (!well) {
        printf("FAIL  two threads: a run has failed\n");
        return;
    }
    double once = summarize(alone, RUNS).least;
    double speed = once / summarize(threads, RUNS).least;
    double most = 2 * once / summarize(beside, RUNS).least;
    printf("%s  uniform %lu: two threads are %.2f times as fast as one; two runs "
           "at once %.2f times: %.2f of that (at least 0.85)\n",
           speed >= 0.85 * most ? "PASS" : "FAIL", (unsigned long)n, speed, most,
           speed / most);
}
