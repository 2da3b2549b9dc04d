/* checker.c - checks one exercise of a student's program.
 *
 *     checker EXERCISE [--seed N] [--property NAME] [--variant NAME] [--instances FILE]
 *             [--feedback DIR] [--again "COMMAND"] -- PROGRAM [ARGUMENT...]
 *
 * Each property of the exercise is tried on many sets of points; the first that fails is
 * made as small as possible and reported: what must hold, what was seen, the points, a
 * picture, and the command that runs it again. With --feedback the same goes to DIR:
 * properties.tsv (name, how it came out in one word, a sentence), NAME.txt and NAME.svg.
 *
 * Exit status: 42 all properties hold, 43 some do not, 1 a fault of the checker.
 */
#include "tools/checks/session.h"

#include <ctype.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ACCEPT = 42, REJECT = 43, FAULT = 1 };
enum { MOST_POINTS = 1000, MOST_RUNS = 300 };

typedef struct request {
    const char *exercise, *property, *variant, *instances, *feedback, *again;
    uint64_t seed;
} request;

/* ---- A smaller case. ---- */

typedef struct failure {
    const property *of;
    uint64_t seed;
    fate end;
    site points[MOST_POINTS];
    uint32_t n;
} failure;

static uint32_t runs_left; /* to make the case smaller; one that hangs takes a second */

static bool
all_differ(const site *points, uint32_t n)
{
    uint32_t lowest[MOST_POINTS];
    return cases_locations(points, n, lowest) == n;
}

/* Does this smaller case fail in the same way? Where no points coincided none may. */
static bool
still_fails(session *s, const failure *f, const site *points, uint32_t n)
{
    bool may_coincide = (f->of->families & (CASES_DUPLICATES | CASES_COLLINEAR)) != 0;
    if (runs_left == 0 || !(may_coincide || all_differ(points, n)))
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
    session_trial(s, f->of, f->seed, f->points, f->n); /* what is reported */
}

/* ---- Feedback. ---- */

/* Control characters, which could play with a terminal, become dots. */
static void
print_clean(FILE *file, const char *text)
{
    for (; *text != '\0'; text++)
        if (*text == '\n' || (isprint((unsigned char)*text) != 0 && *text != 127))
            putc(*text, file);
        else
            putc('.', file);
}

static void
print_points(FILE *file, const site *points, uint32_t n)
{
    fprintf(file, "  smallest case found (%lu point%s):", (unsigned long)n,
            n == 1 ? "" : "s");
    for (uint32_t i = 0; i < n; i++)
        fprintf(file, "%s(%ld,%ld)", i % 10 == 0 && n > 10 ? "\n    " : " ",
                (long)points[i].x, (long)points[i].y);
    putc('\n', file);
}

static void
print_failure(FILE *file, const session *s, const failure *f, const request *r,
              const char *picture)
{
    const property *p = f->of;
    const questions *about = questions_of(s); /* the points that the case was about */
    fprintf(file, "%s %s: fails\n", p->exercise, p->name);
    fprintf(file, "  what must hold: %s (%s)\n", p->statement, p->place);
    fputs("  what was seen: ", file);
    print_clean(file, s->seen);
    putc('\n', file);
    if (f->end != FATE_TODO && about->at != NULL)
        print_points(file, about->at, about->n);
    if (f->end != FATE_ANSWERED && s->student.said_count > 0) {
        fputs("  the program's last words:\n    ", file);
        print_clean(file, s->student.said);
        putc('\n', file);
    }
    if (picture != NULL)
        fprintf(file, "  picture: %s\n", picture);
    if (r->again != NULL)
        fprintf(file, "  run it again: %s\n", r->again);
    else
        fprintf(file, "  run it again: with --seed %llu\n", (unsigned long long)r->seed);
}

static FILE *
open_in(const char *folder, const char *name, const char *end, char *path, size_t room)
{
    snprintf(path, room, "%s/%s%s", folder, name, end);
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        perror(path);
        exit(FAULT);
    }
    return file;
}

static void
close_written(FILE *file, const char *path)
{
    if (ferror(file) != 0 || fclose(file) != 0) {
        fprintf(stderr, "checker: %s cannot be written\n", path);
        exit(FAULT);
    }
}

static void
report_failure(const session *s, const failure *f, const request *r, FILE *table)
{
    char path[1024], picture[1024];
    const char *drawn = NULL;
    if (r->feedback != NULL) {
        snprintf(picture, sizeof picture, "%s/%s.svg", r->feedback, f->of->name);
        if (f->end != FATE_TODO && questions_of(s)->at != NULL &&
            questions_of(s)->n > 0 && picture_write(s, f->of, picture))
            drawn = picture;
        FILE *text = open_in(r->feedback, f->of->name, ".txt", path, sizeof path);
        print_failure(text, s, f, r, drawn);
        close_written(text, path);
        const char *word = f->end == FATE_ANSWERED ? "fail" : fate_word(f->end);
        fprintf(table, "%s\t%s\t", f->of->name, word);
        for (const char *c = s->seen; *c != '\0'; c++)
            putc(isprint((unsigned char)*c) != 0 ? *c : '.', table);
        putc('\n', table);
    }
    print_failure(stdout, s, f, r, drawn);
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
    if (f.end != FATE_TODO)
        shrink(s, &f);
    report_failure(s, &f, r, table);
    return false;
}

/* ---- The command line. ---- */

static _Noreturn void
usage(const char *wrong)
{
    fprintf(stderr,
            "checker: %s\nusage: checker EXERCISE [--seed N] [--property NAME] "
            "[--variant NAME] [--instances FILE] [--feedback DIR] [--again TEXT] -- PROGRAM [ARGUMENT...]\n",
            wrong);
    exit(FAULT);
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
    if (strchr(s.student.command[0], '/') != NULL && access(s.student.command[0], X_OK) != 0) {
        perror(s.student.command[0]);
        return FAULT;
    }
    s.variant = r.variant;
    s.instances = r.instances;
    s.seconds = 3;
    signal(SIGPIPE, SIG_IGN);
    FILE *table = NULL;
    if (r.feedback != NULL) {
        if (mkdir(r.feedback, 0777) != 0 && errno != EEXIST) {
            perror(r.feedback);
            return FAULT;
        }
        table = open_in(r.feedback, "properties", ".tsv", path, sizeof path);
    }
    uint32_t tried = 0, held = 0;
    for (uint32_t i = 0; i < property_count; i++) {
        const property *p = &properties[i];
        if (strcmp(p->exercise, r.exercise) != 0 ||
            (r.property != NULL && strcmp(p->name, r.property) != 0))
            continue;
        tried++;
        held += check(&s, p, &r, table);
    }
    if (table != NULL)
        close_written(table, path);
    session_free(&s);
    if (tried == 0)
        usage("there is no such exercise or property");
    return held == tried ? ACCEPT : REJECT;
}
