/* harness.c - a test program: its tests one after the other, and the counts.
 *
 * A thousand trials share one child process. When it does not end well, the trial it
 * was in is run again alone, made small in many more children, and reported.
 */
#include "tests/harness/internal.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    TRIALS_IN_A_BATCH = 1000,
    LIMIT_FOR_A_TRIAL = 5000, /* milliseconds */
    LIMIT_FOR_A_CHECK = 30000 /* test_run: it may hold many trials of its own */
};

test_program program = {.seed = 1, .trials_factor = 1};

static const char *only; /* the tests to run, or NULL */
static unsigned tests_failed, tests_skipped;

void
give_up(const char *what)
{
    fprintf(stderr, "%s: %s: %s\n", program.name, what, strerror(errno));
    exit(2);
}

static uint64_t
claims_made(void)
{
    uint64_t made = 0;
    for (uint32_t i = 0; i < program.total.claims; i++)
        made += program.total.claim[i].made;
    return made;
}

/* "ok 3 - what is claimed (5000 random inputs)" */
static void
print_line(const char *result, const test *t)
{
    static const char *const inputs[] = {
        [ORDINARY] = "random inputs", [NEAR_DEGENERATE] = "nearly degenerate inputs",
        [SUBSETS] = "subsets of a grid", [PERMUTATIONS] = "orders", [GIVEN] = NULL,
        [CHECK] = NULL};
    printf("%s %u - %s", result, program.tests, t->what);
    if (inputs[t->kind] != NULL)
        printf(" (%u %s)", (unsigned)t->trials, inputs[t->kind]);
}

/* One test: its batches until one fails, and its line of the output. */
static void
run_test(test t)
{
    program.tests++;
    if (only != NULL && strstr(t.what, only) == NULL) {
        tests_skipped++;
        print_line("ok", &t);
        printf(" # SKIP not asked for\n");
        return;
    }
    char path[400];
    picture_path(path, sizeof path);
    remove(path); /* of an earlier failure */

    uint64_t claims_before = claims_made();
    t.milliseconds = t.kind == CHECK ? LIMIT_FOR_A_CHECK : LIMIT_FOR_A_TRIAL;
    for (uint32_t begin = 0; begin < t.trials; begin += TRIALS_IN_A_BATCH) {
        uint32_t end = t.trials - begin > TRIALS_IN_A_BATCH ? begin + TRIALS_IN_A_BATCH
                                                            : t.trials;
        ending how = run_child(&t, begin, end, NULL, 0);
        if (!ended_well(how)) {
            tests_failed++;
            print_line("not ok", &t);
            printf("\n");
            report_batch(&t, begin, end, how);
            return;
        }
        program.total = *program.shared;
        print_noise(stderr, "", UINT_MAX);
    }
    if (claims_made() == claims_before) {
        tests_failed++;
        print_line("not ok", &t);
        printf("\n#   because: nothing was claimed in any of the trials\n");
        return;
    }
    print_line("ok", &t);
    printf("\n");
}

/* ---- What a test program calls. ---- */

static uint64_t
number_after(const char *option, const char *text)
{
    char *end;
    errno = 0;
    uint64_t number = text != NULL ? strtoull(text, &end, 10) : 0;
    if (text == NULL || *text < '0' || *text > '9' || *end != '\0' || errno != 0) {
        fprintf(stderr, "%s: %s needs a whole number\n", program.name, option);
        exit(2);
    }
    return number;
}

/* build/test/NAME draws its failures in build/failures. */
static void
make_folder_for_failures(void)
{
    int length = (int)strlen(program.name);
    for (int slashes = 0; length > 0 && slashes < 2;)
        slashes += program.name[--length] == '/';
    snprintf(program.failures, sizeof program.failures, "%.*s/failures",
             length > 0 ? length : 1, length > 0 ? program.name : ".");
    if (mkdir(program.failures, 0777) != 0 && errno != EEXIST)
        give_up(program.failures);
}

/* Memory that children write and the parent reads, and a file for what they print. */
static void
open_the_channels(void)
{
    FILE *memory = tmpfile(), *text = tmpfile();
    if (memory == NULL || text == NULL ||
        ftruncate(fileno(memory), sizeof *program.shared) != 0 ||
        fcntl(fileno(text), F_SETFL, O_APPEND) != 0)
        give_up("temporary file");
    program.noise = fileno(text);
    program.shared = mmap(NULL, sizeof *program.shared, PROT_READ | PROT_WRITE,
                          MAP_SHARED, fileno(memory), 0);
    if (program.shared == MAP_FAILED)
        give_up("memory shared with the children");
}

void
test_begin(int argc, char **argv, const char *statement)
{
    program.name = argv[0];
    for (int i = 1; i < argc; i += 2) {
        if (strcmp(argv[i], "--seed") == 0) {
            program.seed = number_after(argv[i], argv[i + 1]);
        } else if (strcmp(argv[i], "--trials-factor") == 0) {
            program.trials_factor = (uint32_t)number_after(argv[i], argv[i + 1]);
        } else if (strcmp(argv[i], "--only") == 0 && argv[i + 1] != NULL) {
            only = argv[i + 1];
        } else {
            fprintf(stderr, "usage: %s [--seed N] [--trials-factor K] [--only TEXT]\n",
                    program.name);
            exit(2);
        }
    }
    make_folder_for_failures();
    open_the_channels();
    printf("TAP version 13\n# %s\n# seed %llu\n", statement,
           (unsigned long long)program.seed);
}

void
test_random(const char *what, property *p, uint32_t trials, uint32_t most_points)
{
    run_test((test){.kind = ORDINARY,
                    .what = what,
                    .claims = p,
                    .trials = trials * program.trials_factor,
                    .most_points = most_points});
}

void
test_near_degenerate(const char *what, property *p, uint32_t trials,
                     uint32_t most_points)
{
    run_test((test){.kind = NEAR_DEGENERATE,
                    .what = what,
                    .claims = p,
                    .trials = trials * program.trials_factor,
                    .most_points = most_points});
}

void
test_grid_subsets(const char *what, property *p, uint32_t side)
{
    assert(side <= 4);
    run_test((test){.kind = SUBSETS, .what = what, .claims = p,
                    .trials = 1u << (side * side), .side = side});
}

void
test_permutations(const char *what, property *p, const point2 *points, uint32_t n)
{
    assert(n <= 7);
    uint32_t orders = 1;
    for (uint32_t i = 2; i <= n; i++)
        orders *= i;
    run_test((test){.kind = PERMUTATIONS, .what = what, .claims = p, .trials = orders,
                    .given = points, .n = n});
}

void
test_points(const char *what, property *p, const point2 *points, uint32_t n)
{
    run_test((test){.kind = GIVEN, .what = what, .claims = p, .trials = 1,
                    .given = points, .n = n});
}

void
test_run(const char *what, void (*check)(void))
{
    run_test((test){.kind = CHECK, .what = what, .check = check, .trials = 1});
}

/* Prints a count; false when it is less than it must be. */
static bool
enough(const char *what, uint64_t count, uint64_t minimum)
{
    printf("# %s: %llu", what, (unsigned long long)count);
    if (minimum > 0)
        printf(", at least %llu wanted", (unsigned long long)minimum);
    printf("\n");
    return count >= minimum;
}

/* How often the claims with these names have been made, all of them together. */
static uint64_t
times_made(const char *names)
{
    uint64_t made = 0;
    size_t length;
    for (; *names != '\0'; names += length + (names[length] == ' ')) {
        length = strcspn(names, " ");
        for (uint32_t i = 0; i < program.total.claims; i++) {
            const char *name = program.total.claim[i].name;
            if (strlen(name) == length && memcmp(name, names, length) == 0)
                made += program.total.claim[i].made;
        }
    }
    return made;
}

int
test_end(test_minima minima)
{
    const tally *total = &program.total;
    for (uint32_t i = 0; i < total->claims; i++)
        printf("# claim %s made %llu times\n", total->claim[i].name,
               (unsigned long long)total->claim[i].made);
    bool looked = enough("trials", total->trials, minima.trials);
    looked &= enough("largest n", total->largest_n, minima.largest_n);
    looked &= enough("zeros", total->zeros, minima.zeros);
    looked &= enough("answers by the second tier", total->expansions,
                     minima.expansions);
    looked &= enough("answers by the third tier", total->wide, minima.wide);
    for (int i = 0; i < 5 && minima.made[i].names != NULL; i++)
        looked &= enough(minima.made[i].names, times_made(minima.made[i].names),
                         minima.made[i].times);
    printf("# outside the hypotheses: %llu\n", (unsigned long long)total->outside);
    looked &= total->outside <= total->trials / 5;

    if (tests_failed == 0 && tests_skipped == 0) { /* else the counts mean little */
        program.tests++;
        tests_failed += !looked;
        printf("%s %u - the search has looked far enough\n", looked ? "ok" : "not ok",
               program.tests);
        if (!looked)
            printf(
                "#   because: a count above is below its minimum, or more than 20 %% "
                "of the trials are outside the hypotheses\n");
    }
    printf("1..%u\n", program.tests);
    return tests_failed > 0;
}
