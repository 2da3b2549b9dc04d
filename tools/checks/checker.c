/* checker.c - checks one exercise of a student's program.
 *
 *     checker EXERCISE [--seed N | --case POINTS] [--property NAME] [--variant NAME]
 *             [--instances FILE] [--feedback DIR] [--again "COMMAND"]
 *             [--again-case "COMMAND"] -- PROGRAM [ARGUMENT...]
 *
 * Each property of the exercise is tried on many sets of points; the first that fails
 * is made as small as possible and reported: what must hold, what was seen, the points,
 * a picture, and the command that runs it again: that of --again, or, where these
 * points are enough for it to fail, that of --again-case with the points. With
 * --feedback the same goes to DIR: properties.tsv (name, how it came out in one word, a
 * sentence), NAME.txt and NAME.svg. --case tries one set of points: "(0,0) (4,1)
 * (2,3)".
 *
 * Exit status: 42 all properties hold, 43 some do not, 1 a fault of the checker.
 */
#include "tools/checks/feedback.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ACCEPT = 42, REJECT = 43 };
enum { MOST_RUNS = 300 };

/* The seed of a trial for which the points are enough: of --case. */
enum { SEED_OF_A_CASE = 1 };

/* ---- A smaller case. ---- */

static uint32_t runs_left; /* to make the case smaller; one that hangs takes a second */

static bool
all_differ(const site *points, uint32_t n)
{
    uint32_t lowest[MOST_POINTS];
    return cases_locations(points, n, lowest) == n;
}

/* Where the property's families have no points that coincide none may. */
static bool
is_asked(const property *p, const site *points, uint32_t n)
{
    return (p->families & (CASES_DUPLICATES | CASES_COLLINEAR)) != 0 ||
           all_differ(points, n);
}

/* Does this smaller case fail in the same way? */
static bool
still_fails(session *s, const failure *f, const site *points, uint32_t n)
{
    if (runs_left == 0 || !is_asked(f->of, points, n))
        return false;
    runs_left--;
    session_trial(s, f->of, f->seed, points, n);
    return s->failed && s->end == f->end;
}

static void
drop_points(session *s, failure *f)
{
    site fewer[MOST_POINTS];
    for (uint32_t count = f->n / 2; count > 0; count /= 2)
        for (uint32_t at = 0; at + count <= f->n;) {
            memcpy(fewer, f->points, at * sizeof *fewer);
            memcpy(fewer + at, f->points + at + count,
                   (f->n - at - count) * sizeof *fewer);
            if (still_fails(s, f, fewer, f->n - count)) {
                f->n -= count;
                memcpy(f->points, fewer, f->n * sizeof *fewer);
            } else {
                at += count;
            }
        }
}

/* The same points on a smaller grid: divided by 2, 4, 8, ... as long as it fails. */
static void
draw_smaller(session *s, failure *f)
{
    site smaller[MOST_POINTS];
    for (int32_t divisor = PLANE_REACH; divisor > 1; divisor /= 2) {
        for (uint32_t i = 0; i < f->n; i++)
            smaller[i] = (site){f->points[i].x / divisor, f->points[i].y / divisor};
        if (still_fails(s, f, smaller, f->n)) {
            memcpy(f->points, smaller, f->n * sizeof *smaller);
            return;
        }
    }
}

static void
shrink(session *s, failure *f)
{
    double patience = s->seconds;
    runs_left = f->end == FATE_TIMEOUT ? 6 : MOST_RUNS;
    s->seconds = f->end == FATE_TIMEOUT ? 1 : patience;
    drop_points(s, f);
    draw_smaller(s, f);
    drop_points(s, f);
    s->seconds = patience;
}

/* Runs once more what is reported: with the seed of a case if it fails with that, too,
 * or else with its own. */
static void
run_again(session *s, failure *f)
{
    session_trial(s, f->of, SEED_OF_A_CASE, f->points, f->n);
    f->is_a_case = s->failed && s->end == f->end;
    if (!f->is_a_case)
        session_trial(s, f->of, f->seed, f->points, f->n);
}

/* ---- Properties. ---- */

/* A number for this property that the seed does not give away. */
static uint64_t
seed_of(const request *r, const property *p)
{
    uint64_t seed = r->seed;
    for (const char *c = p->name; *c != '\0'; c++)
        seed = 31 * seed + (unsigned char)*c;
    random_source source = random_from_seed(seed);
    return random_bits(&source);
}

/* Tries it until it fails. */
static bool
holds(session *s, const property *p, const request *r, failure *f)
{
    random_source source = random_from_seed(seed_of(r, p));
    for (uint32_t trial = 0; trial < p->trials; trial++) {
        f->n = cases_draw(&source, p->families, p->most, f->points);
        f->seed = random_bits(&source);
        session_trial(s, p, f->seed, f->points, f->n);
        if (s->failed) {
            f->of = p;
            f->end = s->end;
            return false;
        }
    }
    return true;
}

static bool
check(session *s, const property *p, const request *r, FILE *table)
{
    static failure f;
    if (holds(s, p, r, &f)) {
        printf("%s %s: holds in %lu trials\n", p->exercise, p->name,
               (unsigned long)p->trials);
        if (table != NULL)
            fprintf(table, "%s\tpass\t%s\n", p->name, p->statement);
        return true;
    }
    if (f.end != FATE_TODO) {
        shrink(s, &f);
        run_again(s, &f);
    }
    feedback_failure(s, &f, r, table);
    return false;
}

/* The points of --case; their number, or 0 when they are none that this property is
 * asked about. */
static uint32_t
read_case(const property *p, const char *text, site *points)
{
    uint32_t n = 0;
    long x, y;
    for (int used; n < MOST_POINTS && sscanf(text, " (%ld,%ld)%n", &x, &y, &used) == 2;
         text += used) {
        if (x < -PLANE_REACH || x > PLANE_REACH || y < -PLANE_REACH || y > PLANE_REACH)
            return 0;
        points[n++] = (site){(int32_t)x, (int32_t)y};
    }
    return text[strspn(text, " ")] == '\0' && is_asked(p, points, n) ? n : 0;
}

/* The one trial of --case. */
static bool
check_case(session *s, const property *p, const request *r, FILE *table)
{
    static failure f;
    f = (failure){.of = p, .seed = SEED_OF_A_CASE, .is_a_case = true};
    f.n = read_case(p, r->points, f.points);
    if (f.n == 0) {
        printf("%s %s: is not asked about these points\n", p->exercise, p->name);
        return true;
    }
    session_trial(s, p, f.seed, f.points, f.n);
    f.end = s->end;
    if (s->failed)
        feedback_failure(s, &f, r, table);
    else
        printf("%s %s: holds for these points\n", p->exercise, p->name);
    return !s->failed;
}

/* ---- The command line. ---- */

static _Noreturn void
usage(const char *wrong)
{
    fprintf(stderr,
            "checker: %s\nusage: checker EXERCISE [--seed N | --case POINTS] "
            "[--property NAME] [--variant NAME] [--instances FILE] [--feedback DIR] "
            "[--again TEXT] [--again-case TEXT] -- PROGRAM [ARGUMENT...]\n",
            wrong);
    exit(CHECKER_FAULT);
}

static uint64_t
number_of(const char *text)
{
    char *end;
    errno = 0;
    unsigned long long number = strtoull(text, &end, 10);
    if (errno != 0 || end == text || *end != '\0')
        usage("--seed needs a number");
    return number;
}

static request
read_arguments(int argc, char **argv, char ***command)
{
    request r = {.seed = 1, .variant = ""};
    int i = 1;
    for (; i < argc && strcmp(argv[i], "--") != 0; i++) {
        const char *name = argv[i];
        if (name[0] != '-') {
            r.exercise = name;
            continue;
        }
        if (i + 1 == argc)
            usage("an option lacks its value");
        const char *value = argv[++i];
        if (strcmp(name, "--seed") == 0)
            r.seed = number_of(value);
        else if (strcmp(name, "--property") == 0)
            r.property = value;
        else if (strcmp(name, "--variant") == 0)
            r.variant = value;
        else if (strcmp(name, "--instances") == 0)
            r.instances = value;
        else if (strcmp(name, "--feedback") == 0)
            r.feedback = value;
        else if (strcmp(name, "--again") == 0)
            r.again = value;
        else if (strcmp(name, "--again-case") == 0)
            r.again_case = value;
        else if (strcmp(name, "--case") == 0)
            r.points = value;
        else
            usage("there is no such option");
    }
    if (r.exercise == NULL || i + 1 >= argc)
        usage("EXERCISE and PROGRAM are needed");
    *command = argv + i + 1;
    return r;
}

int
main(int argc, char **argv)
{
    static session s;
    char path[1024];
    request r = read_arguments(argc, argv, &s.student.command);
    if (strchr(s.student.command[0], '/') != NULL &&
        access(s.student.command[0], X_OK) != 0) {
        perror(s.student.command[0]);
        return CHECKER_FAULT;
    }
    s.variant = r.variant;
    s.instances = r.instances;
    s.seconds = 3;
    signal(SIGPIPE, SIG_IGN);
    FILE *table = NULL;
    if (r.feedback != NULL) {
        if (mkdir(r.feedback, 0777) != 0 && errno != EEXIST) {
            perror(r.feedback);
            return CHECKER_FAULT;
        }
        snprintf(path, sizeof path, "%s/properties.tsv", r.feedback);
        table = feedback_open(path);
    }
    uint32_t tried = 0, held = 0;
    for (uint32_t i = 0; i < property_count; i++) {
        const property *p = &properties[i];
        if (strcmp(p->exercise, r.exercise) != 0 ||
            (r.property != NULL && strcmp(p->name, r.property) != 0))
            continue;
        tried++;
        held +=
            r.points != NULL ? check_case(&s, p, &r, table) : check(&s, p, &r, table);
    }
    if (table != NULL)
        feedback_close(table, path);
    session_free(&s);
    if (tried == 0)
        usage("there is no such exercise or property");
    return held == tried ? ACCEPT : REJECT;
}
