/* signs.c - instances for the exercises of 3.4, with their signs.
 *
 *     signs SEED >FILE
 *
 * One instance a line: the letter of the exercise; m when all coordinates are 0 or
 * between 2^-200 and 2^240 in magnitude, so that expansions do, else w; the sign; and
 * eight coordinates in hexadecimal, which says all of their bits. The signs come from
 * big integers that share no code with section 3.4, so that the checker and a student
 * need not have the section's own functions.
 */
#include "lib/random.h"
#include "tests/oracle/oracle.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { INSTANCES = 400 }; /* of each kind */

static double
integer(random_source *source, uint32_t range)
{
    return (double)random_below(source, 2 * range + 1) - range;
}

/* Up to two doubles above or below x, where that is finite. */
static double
step(random_source *source, double x)
{
    for (uint32_t steps = random_below(source, 3); steps > 0; steps--) {
        double next = nextafter(x, random_below(source, 2) == 0 ? -DBL_MAX : DBL_MAX);
        x = isfinite(next) ? next : x;
    }
    return x;
}

/* Four points on a line or a circle, or nearly so; one or two of them may be a double
 * away from it. Small integers to begin with: so there are exact zeros. */
static void
draw_shape(random_source *source, point2 p[4])
{
    static const point2 circle[12] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},
                                      {-3, 4}, {-4, 3},  {-5, 0},  {-4, -3},
                                      {-3, -4}, {0, -5}, {3, -4},  {4, -3}};
    double dx = integer(source, 5), dy = integer(source, 5);
    point2 from = {integer(source, 50), integer(source, 50)};
    bool line = random_below(source, 2) == 0;
    for (int i = 0; i < 4; i++) {
        point2 on = circle[random_below(source, 12)];
        double t = integer(source, 20);
        p[i] = line ? (point2){from.x + t * dx, from.y + t * dy}
                    : (point2){from.x + on.x, from.y + on.y};
    }
}

/* Two vectors of up to 53 bits with the cross product 1 or -1: adding a multiple of one
 * to the other does not change it. Products of 64 bits cannot tell. */
static void
draw_neighbours(random_source *source, point2 p[4])
{
    point2 u = {1, 0}, v = {0, 1};
    for (;;) {
        double times = 1 + random_below(source, 7);
        point2 *larger = random_below(source, 2) == 0 ? &u : &v;
        point2 *other = larger == &u ? &v : &u;
        point2 sum = {larger->x + times * other->x, larger->y + times * other->y};
        if (sum.x > 0x1p53 || sum.y > 0x1p53)
            break;
        *larger = sum;
    }
    point2 zero = {0, 0};
    p[0] = u;
    p[1] = p[3] = zero;
    p[2] = v;
    if (random_below(source, 2) == 0) {
        p[0] = v;
        p[2] = u;
    }
}

/* By a power of two: the sign stays what it is. */
static void
scale(int exponent, point2 p[4])
{
    for (int i = 0; i < 4; i++) {
        p[i].x = ldexp(p[i].x, exponent);
        p[i].y = ldexp(p[i].y, exponent);
    }
}

/* Scaled, then some moved to a neighbouring double. */
static void
disturb(random_source *source, int exponent, point2 p[4])
{
    scale(exponent, p);
    for (int i = 0; i < 4; i++) {
        if (random_below(source, 3) == 0) {
            p[i].x = step(source, p[i].x);
            p[i].y = step(source, p[i].y);
        }
    }
}

/* Any doubles: bits at random. */
static double
any_double(random_source *source)
{
    for (;;) {
        double mantissa = 0.5 + random_unit(source) / 2;
        double x = ldexp(mantissa, (int)random_below(source, 2098) - 1073);
        if (isfinite(x))
            return random_below(source, 2) == 0 ? x : -x;
    }
}

static bool
is_moderate(double x)
{
    return x == 0 || (fabs(x) >= 0x1p-200 && fabs(x) <= 0x1p240);
}

static bool
all_moderate(const point2 p[4])
{
    bool all = true;
    for (int i = 0; i < 4; i++)
        all = all && is_moderate(p[i].x) && is_moderate(p[i].y);
    return all;
}

static void
print_instance(char exercise, const point2 p[4])
{
    int sign = exercise == 'a' ? oracle_cross(p[0], p[1], p[2], p[3])
                               : oracle_incircle(p[0], p[1], p[2], p[3]);
    printf("%c %c %d", exercise, all_moderate(p) ? 'm' : 'w', sign);
    for (int i = 0; i < 4; i++)
        printf(" %a %a", p[i].x, p[i].y);
    putchar('\n');
}

static void
print_instances(random_source *source, char exercise)
{
    point2 p[4];
    for (int i = 0; i < INSTANCES; i++) { /* moderate */
        if (exercise == 'a' && i % 4 == 0) {
            draw_neighbours(source, p);
        } else {
            draw_shape(source, p);
            disturb(source, (int)random_below(source, 60) - 50, p);
            if (exercise == 'a' &&
                i % 2 == 0) /* mostly two vectors with a common end */
                p[3] = p[1];
        }
        if (all_moderate(p))
            print_instance(exercise, p);
    }
    for (int i = 0; i < INSTANCES; i++) { /* every double */
        static const int extreme[4] = {-1074, -1040, 1014, 960};
        if (exercise == 'a' && i % 8 == 3) {
            draw_neighbours(source, p);
            scale(extreme[i / 8 % 2 * 3], p);
            print_instance(exercise, p);
            continue;
        }
        draw_shape(source, p);
        disturb(source, extreme[i % 4], p);
        if (i % 3 == 0)
            p[random_below(source, 4)] =
                (point2){any_double(source), any_double(source)};
        if (i % 7 == 0)
            p[random_below(source, 4)].y = DBL_MAX;
        if (!all_moderate(p))
            print_instance(exercise, p);
    }
}

int
main(int argc, char **argv)
{
    char *end = NULL;
    errno = 0;
    unsigned long long seed = argc == 2 ? strtoull(argv[1], &end, 10) : 0;
    if (argc != 2 || errno != 0 || end == argv[1] || *end != '\0') {
        fputs("usage: signs SEED >FILE\n", stderr);
        return 2;
    }
    random_source source = random_from_seed(seed);
    print_instances(&source, 'a');
    print_instances(&source, 'b');
    return fflush(stdout) == 0 && ferror(stdout) == 0 ? 0 : 1;
}
