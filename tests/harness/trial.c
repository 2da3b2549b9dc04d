/* trial.c - one trial, and the child process in which a batch of them runs.
 *
 * A trial is fully named by the seed, the sentence of its test and its number: from
 * these its points and its random numbers are drawn, in whatever process it runs.
 */
#define _XOPEN_SOURCE 700 /* setitimer */
#include "tests/harness/internal.h"

#include "chapters/3.4_primitives/predicates.h"
#include "lib/memory.h"
#include "lib/svg.h"

#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

/* The trial that runs in this process. */
static random_source trial_source;
static jmp_buf outside_hypotheses;
static const point2 *trial_points;
static uint32_t trial_n;
static triangle_list picture_list;
static verdict picture_verdict;

static void *
allocate(size_t count, size_t size)
{
    void *array = malloc(count * size + (count == 0));
    if (array == NULL)
        give_up("no memory for the test itself");
    return array;
}

static point2 *
copy_points(const point2 *points, uint32_t n)
{
    point2 *copy = allocate(n, sizeof *copy);
    for (uint32_t i = 0; i < n; i++)
        copy[i] = points[i];
    return copy;
}

/* ---- Its points. ---- */

/* The source of trial k: another sequence for each seed, sentence and number. */
static random_source
source_of_trial(const test *t, uint32_t k)
{
    uint64_t name = program.seed;
    for (const char *c = t->what; *c != '\0'; c++)
        name = (name ^ (unsigned char)*c) * 0x100000001b3u;
    return random_from_seed(name * 0x9e3779b97f4a7c15u + k);
}

/* The points of the given order number k, of n! of them. */
static void
permute(const test *t, uint32_t k, point2 *points)
{
    uint32_t left[7];
    for (uint32_t i = 0; i < t->n; i++)
        left[i] = i;
    for (uint32_t i = t->n; i > 0; i--) {
        points[t->n - i] = t->given[left[k % i]];
        left[k % i] = left[i - 1];
        k /= i;
    }
}

/* The points of trial k, in an array without room to spare, so that a sanitizer
 * sees whoever reads beyond them. trial_source is left for the trial to use. */
point2 *
draw_points(const test *t, uint32_t k, uint32_t *n)
{
    trial_source = source_of_trial(t, k);
    *n = t->n;
    if (t->kind == GIVEN)
        return copy_points(t->given, *n);
    if (t->kind == ORDINARY || t->kind == NEAR_DEGENERATE)
        *n = generate_size(&trial_source, t->most_points);
    if (t->kind == SUBSETS)
        for (uint32_t i = 0; i < t->side * t->side; i++)
            *n += k >> i & 1;

    point2 *points = allocate(*n, sizeof *points);
    if (t->kind == ORDINARY)
        generate_ordinary(&trial_source, points, *n);
    else if (t->kind == NEAR_DEGENERATE)
        generate_near_degenerate(&trial_source, points, *n);
    else if (t->kind == PERMUTATIONS)
        permute(t, k, points);
    else if (t->kind == SUBSETS) {
        uint32_t filled = 0;
        for (uint32_t i = 0; i < t->side * t->side; i++)
            if (k >> i & 1)
                points[filled++] = (point2){i % t->side, i / t->side};
        generate_order(&trial_source, points, *n);
    }
    return points;
}

/* ---- What it does. ---- */

/* Runs trial k, on its own points or on those that shall replace them. */
static void
run_trial(const test *t, uint32_t k, const point2 *instead, uint32_t n_instead)
{
    uint32_t n;
    point2 *points = draw_points(t, k, &n);
    if (instead != NULL) {
        free(points);
        n = n_instead;
        points = copy_points(instead, n);
    }
    memory_fail_at(0);
    trial_points = points;
    trial_n = n;
    tally *counts = program.shared;
    counts->trials++;
    if (n > counts->largest_n)
        counts->largest_n = n;
    if (setjmp(outside_hypotheses) != 0)
        program.shared->outside++;
    else if (t->kind == CHECK)
        t->check();
    else
        t->claims(points, n);
    free(points);
}

random_source *
test_random_source(void)
{
    return &trial_source;
}

void
hypothesis_missed(void)
{
    longjmp(outside_hypotheses, 1);
}

/* Counts by name: a claim that is never made has not been tested. */
void
claim_made(const char *name)
{
    static uint32_t i; /* where the last one stands: a claim is often made in a row */
    tally *counts = program.shared;
    if (i >= counts->claims || strcmp(counts->claim[i].name, name) != 0)
        for (i = 0; i < counts->claims; i++)
            if (strcmp(counts->claim[i].name, name) == 0)
                break;
    if (i == counts->claims) {
        assert(i < MOST_CLAIMS && strlen(name) <= LONGEST_NAME);
        strcpy(counts->claim[i].name, name);
        counts->claim[i].made = 0;
        counts->claims++;
    }
    counts->claim[i].made++;
}

void
draw_picture(const char *path, const point2 *points, uint32_t n)
{
    FILE *file = fopen(path, "w");
    if (file == NULL)
        give_up(path);
    const tally *found = program.shared;
    svg page;
    svg_box box = svg_box_of(points, n);
    svg_begin(&page, file, svg_one_panel(box), "A counterexample", found->because);
    svg_panel(&page, box, n, found->failed);
    if (picture_verdict.witnesses > 0)
        svg_verdict(&page, points, n, picture_list, &picture_verdict);
    else
        svg_triangulation(&page, points, n, picture_list);
    svg_end(&page);
    fclose(file);
}

void
claim_failed(const char *name, const char *seen, ...)
{
    tally *found = program.shared;
    va_list arguments;
    va_start(arguments, seen);
    vsnprintf(found->because, sizeof found->because, seen, arguments);
    va_end(arguments);
    strcpy(found->failed, name);
    fflush(NULL);
    if (program.picture != NULL)
        draw_picture(program.picture, trial_points, trial_n);
    _exit(1);
}

void
claim_verdict(const char *name, verdict v)
{
    char witnesses[80] = "";
    for (int i = 0, at = 0; i < v.witnesses; i++)
        at += sprintf(witnesses + at, "%s%u", i == 0 ? " (points " : ", ",
                      (unsigned)v.witness[i]);
    picture_verdict = v;
    CLAIM(name, v.holds, "%s%s%s", v.because, witnesses, v.witnesses > 0 ? ")" : "");
}

void
test_picture(triangle_list list)
{
    if (program.picture == NULL)
        return;
    free(picture_list.corner);
    picture_list.count = list.count;
    picture_list.corner = allocate(list.count, sizeof *list.corner);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        picture_list.corner[i / 3][i % 3] = list.corner[i / 3][i % 3];
}

/* ---- A child. ---- */

static void
set_timer(int clock, long milliseconds)
{
    struct itimerval limit = {.it_value = {milliseconds / 1000,
                                           milliseconds % 1000 * 1000}};
    setitimer(clock, &limit, NULL);
}

/* SIGPROF ends this process after so much processor time, unless another limit is set;
 * 0: never. Time on the wall passes on a busy machine, too: SIGALRM is for a process
 * that only waits. */
static void
limit_time(long milliseconds)
{
    set_timer(ITIMER_PROF, milliseconds);
    set_timer(ITIMER_REAL, 10 * milliseconds);
}

/* In the child: trials begin .. end-1, then an ordinary exit, so that a sanitizer
 * can look for leaks. */
static void
run_trials(const test *t, uint32_t begin, uint32_t end, const point2 *instead,
           uint32_t n)
{
    dup2(program.noise, STDOUT_FILENO);
    dup2(program.noise, STDERR_FILENO);
    predicate_count = (predicate_counts){0};
    for (uint32_t k = begin; k < end; k++) {
        program.shared->running = k;
        limit_time(t->milliseconds);
        run_trial(t, k, instead, n);
    }
    limit_time(0);
    tally *counts = program.shared;
    counts->running = end;
    counts->zeros += predicate_count.zeros;
    counts->expansions += predicate_count.expansions;
    counts->wide += predicate_count.wide;
    exit(0);
}

ending
run_child(const test *t, uint32_t begin, uint32_t end, const point2 *instead,
          uint32_t n)
{
    *program.shared = program.total;
    if (ftruncate(program.noise, 0) != 0 || lseek(program.noise, 0, SEEK_SET) != 0)
        give_up("temporary file");
    fflush(NULL);
    pid_t child = fork();
    if (child < 0)
        give_up("fork");
    if (child == 0)
        run_trials(t, begin, end, instead, n);
    ending how = {0};
    while (waitpid(child, &how.status, 0) < 0)
        if (errno != EINTR)
            give_up("waitpid");
    strcpy(how.failed, program.shared->failed);
    strcpy(how.because, program.shared->because);
    return how;
}

bool
ended_well(ending how)
{
    return WIFEXITED(how.status) && WEXITSTATUS(how.status) == 0;
}

bool
was_endless(ending how)
{
    return WIFSIGNALED(how.status) &&
           (WTERMSIG(how.status) == SIGPROF || WTERMSIG(how.status) == SIGALRM);
}

