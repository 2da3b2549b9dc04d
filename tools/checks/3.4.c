/* 3.4.c - the properties of exercises 3.4-a and 3.4-b: exact signs.
 *
 * The instances come from a file (--instances), with their signs: see signs.c, which
 * made it. So the checker knows as little of exact arithmetic as a student's tree.
 */
#include "tools/checks/checker.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_INSTANCES = 2000 };

typedef struct instance {
    int sign;
    point2 p[4];
} instance;

typedef struct instance_list {
    uint32_t count;
    instance item[MOST_INSTANCES];
} instance_list;

static _Noreturn void
bad_file(const char *path, unsigned line, const char *because)
{
    fprintf(stderr, "checker: %s:%u: %s; make the file again with signs\n", path, line,
            because);
    exit(1);
}

/* "a m 1 X Y X Y X Y X Y" */
static bool
read_instance(const char *line, char exercise, char kind, instance *out, bool *wanted)
{
    char letter, class;
    int length;
    if (sscanf(line, "%c %c %d%n", &letter, &class, &out->sign, &length) != 3)
        return false;
    const char *next = line + length;
    for (int i = 0; i < 8; i++) {
        char *end;
        double x = strtod(next, &end);
        if (end == next || !isfinite(x))
            return false;
        *(i % 2 == 0 ? &out->p[i / 2].x : &out->p[i / 2].y) = x;
        next = end;
    }
    *wanted = letter == exercise && class == kind;
    return strcmp(next, "\n") == 0 && abs(out->sign) <= 1;
}

static void
read_instances(const char *path, char exercise, char kind, instance_list *list)
{
    char line[512];
    FILE *file = path != NULL ? fopen(path, "r") : NULL;
    if (file == NULL)
        bad_file(path != NULL ? path : "--instances", 0, "there is no such file");
    list->count = 0;
    for (unsigned number = 1; fgets(line, sizeof line, file) != NULL; number++) {
        bool wanted;
        if (list->count == MOST_INSTANCES)
            bad_file(path, number, "too many instances");
        if (!read_instance(line, exercise, kind, &list->item[list->count], &wanted))
            bad_file(path, number, "this line is no instance");
        list->count += wanted;
    }
    fclose(file);
    if (list->count < 100)
        bad_file(path, 0, "too few instances");
}

static void
check_signs(session *s, char exercise, char kind)
{
    static instance_list list;
    read_instances(instances_of(s), exercise, kind, &list);
    begin_case(s, exercise, NULL, 0);
    give_number(s, list.count);
    for (uint32_t k = 0; k < list.count; k++)
        for (int i = 0; i < 4; i++) {
            give_real(s, list.item[k].p[i].x);
            give_real(s, list.item[k].p[i].y);
        }
    if (!ask(s))
        return;
    /* When the y axis points down, left is right, and the signs are exchanged. */
    int up = strcmp(variant_of(s), "y-down") == 0 ? -1 : +1;
    for (uint32_t k = 0; k < list.count && !failed(s); k++) {
        const instance *in = &list.item[k];
        const point2 *p = in->p;
        int sign = take_sign(s, "a sign");
        expect(s, failed(s) || sign == up * in->sign,
               "the sign for (%.17g, %.17g), (%.17g, %.17g), (%.17g, %.17g), "
               "(%.17g, %.17g) is %+d, and your function says %+d",
               p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y,
               up * in->sign, sign);
    }
    take_end(s);
}

static void
cross_is_exact(session *s, const site *p, uint32_t n)
{
    (void)p, (void)n;
    check_signs(s, 'a', 'm');
}

static void
cross_is_always_exact(session *s, const site *p, uint32_t n)
{
    (void)p, (void)n;
    check_signs(s, 'a', 'w');
}

static void
incircle_is_exact(session *s, const site *p, uint32_t n)
{
    (void)p, (void)n;
    check_signs(s, 'b', 'm');
}

static void
incircle_is_always_exact(session *s, const site *p, uint32_t n)
{
    (void)p, (void)n;
    check_signs(s, 'b', 'w');
}

const property properties[] = {
    {"3.4-a", "moderate",
     "The sign of (p-q) x (r-s) is exact for coordinates between 2^-200 and 2^240",
     "notes 3.4, first determinant; page 3.4, sec3.4.P9", CASES_FEW, 3, 1, false,
     cross_is_exact},
    {"3.4-a", "every_double",
     "The sign is exact for every finite double, 1e308 and 5e-324 too",
     "page 3.4, Step 3", CASES_FEW, 3, 1, false, cross_is_always_exact},
    {"3.4-b", "moderate",
     "The sign of the incircle determinant is exact for coordinates between 2^-200 and "
     "2^240",
     "notes 3.4, second determinant; page 3.4, sec3.4.P2", CASES_FEW, 3, 1, false,
     incircle_is_exact},
    {"3.4-b", "every_double",
     "The sign is exact for every finite double, 1e308 and 5e-324 too",
     "page 3.4, Step 3", CASES_FEW, 3, 1, false, incircle_is_always_exact},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
