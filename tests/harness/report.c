/* report.c - a failure: made small, drawn, and put into words. */
#include "tests/harness/internal.h"

#include "lib/decimal.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    LIMIT_WHEN_SHRINKING = 100, /* milliseconds; trials take less than one */
    RUNS_TO_SHRINK = 1500,
    RUNS_TO_SHRINK_IF_ENDLESS = 100,
    MOST_LINES_OF_NOISE = 20
};

/* The failure that is being shrunk. */
static test failing_test;
static uint32_t failing_trial;
static ending failing_ending;

static bool
same_failure(ending one, ending other)
{
    return one.status == other.status && strcmp(one.failed, other.failed) == 0;
}

bool
still_fails(const point2 *points, uint32_t n)
{
    ending how = run_child(&failing_test, failing_trial, failing_trial + 1, points, n);
    return same_failure(how, failing_ending);
}

void
picture_path(char *path, size_t room)
{
    const char *slash = strrchr(program.name, '/');
    const char *name = slash != NULL ? slash + 1 : program.name;
    snprintf(path, room, "%s/%s-%u.svg", program.failures, name, program.tests);
}

void
print_noise(FILE *to, const char *before, unsigned most_lines)
{
    char text[1024];
    int copy = dup(program.noise);
    FILE *file = copy >= 0 ? fdopen(copy, "r") : NULL;
    if (file == NULL || fseek(file, 0, SEEK_SET) != 0)
        give_up("temporary file");
    for (unsigned i = 0; i < most_lines && fgets(text, sizeof text, file) != NULL;
         i++) {
        text[strcspn(text, "\n")] = '\0';
        fprintf(to, "%s%s\n", before, text);
    }
    fclose(file);
}

/* A sentence; if it has several lines, each begins as a comment does. */
static void
print_sentence(const char *sentence)
{
    for (; *sentence != '\0'; sentence++) {
        if (*sentence != '\n')
            putchar(*sentence);
        else if (sentence[1] != '\0')
            printf("\n#     ");
    }
    putchar('\n');
}

static void
print_because(const test *t, ending how)
{
    int status = how.status;
    if (how.failed[0] != '\0') {
        printf("#   because: ");
        print_sentence(how.because);
        printf("#   claim: %s\n", how.failed);
    } else if (was_endless(how)) {
        printf("#   because: did not end within %ld s\n", t->milliseconds / 1000);
    } else if (WIFSIGNALED(status)) {
        printf("#   because: stopped by signal %d (%s)\n", WTERMSIG(status),
               strsignal(WTERMSIG(status)));
    } else {
        printf("#   because: exited with status %d\n", WEXITSTATUS(status));
    }
    print_noise(stdout, "#     it printed: ", MOST_LINES_OF_NOISE);
}

/* In a form that reads back exactly. */
static void
print_points(const point2 *points, uint32_t n)
{
    char x[DECIMAL_ROOM], y[DECIMAL_ROOM];
    for (uint32_t i = 0; i < n; i++) {
        decimal_write(x, points[i].x);
        decimal_write(y, points[i].y);
        printf(" (%s,%s)", x, y);
    }
    printf("%s\n", n == 0 ? " no points" : "");
}

static void
print_again(const test *t)
{
    printf("again: %s --seed %llu", program.name, (unsigned long long)program.seed);
    printf(" --only \"%s\"", t->what);
    if (program.trials_factor != 1)
        printf(" --trials-factor %u", (unsigned)program.trials_factor);
    printf("\n");
}

static uint32_t
shrink_trial(const test *t, uint32_t k, ending how, point2 *points, uint32_t n)
{
    failing_test = *t;
    failing_test.milliseconds = LIMIT_WHEN_SHRINKING;
    failing_trial = k;
    failing_ending = how;
    return shrink(points, n, was_endless(how) ? RUNS_TO_SHRINK_IF_ENDLESS
                                              : RUNS_TO_SHRINK);
}

/* Trial k failed alone: makes its points few and simple (unless they are given), runs
 * it a last time to have it drawn, and says all that is known. */
static void
report_trial(const test *t, uint32_t k, ending how)
{
    if (t->kind == CHECK) {
        print_because(t, how);
        printf("#   ");
        print_again(t);
        return;
    }
    uint32_t n;
    point2 *points = draw_points(t, k, &n);
    bool given = t->kind == GIVEN || t->kind == PERMUTATIONS;
    if (!given)
        n = shrink_trial(t, k, how, points, n);

    char path[400];
    picture_path(path, sizeof path);
    draw_picture(path, points, n); /* for the case that the trial cannot */
    program.picture = path;
    ending last = run_child(t, k, k + 1, points, n);
    if (!same_failure(last, how)) { /* slow, and taken for endless: the whole input */
        free(points);
        points = draw_points(t, k, &n);
        draw_picture(path, points, n);
        last = run_child(t, k, k + 1, points, n);
    }
    program.picture = NULL;

    print_because(t, last);
    printf("#   %s:", given ? "input" : "smallest input found");
    print_points(points, n);
    printf("#   picture: %s    ", path);
    print_again(t);
    free(points);
}

void
report_batch(const test *t, uint32_t begin, uint32_t end, ending how)
{
    /* The trial it was in; or all, when it failed at its exit, as with a leak. */
    uint32_t running = program.shared->running;
    uint32_t first = running < end ? running : begin;
    uint32_t last = running < end ? running + 1 : end;
    for (uint32_t k = first; k < last; k++) {
        ending alone = t->trials == 1 ? how : run_child(t, k, k + 1, NULL, 0);
        if (!ended_well(alone)) {
            report_trial(t, k, alone);
            return;
        }
    }
    print_because(t, how);
    printf(
        "#   each of the trials from %u succeeds alone: one of them leaves something "
        "behind for the next\n#   ",
        (unsigned)begin);
    print_again(t);
}
