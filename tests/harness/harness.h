/* harness.h - tests that search for counterexamples.
 *
 * Needs: lib/point.h, lib/mesh.h, lib/random.h, lib/verdict.h.
 *
 * A test program belongs to one statement of the notes. Its properties are claims
 * about a set of points; the harness draws the points, in three strengths: at
 * random, nearly degenerate, and exhaustively in a small world. It runs them in
 * child processes with a time limit, so that a crash or an endless loop is a
 * result like any other, and makes a counterexample small before it reports it.
 * That none is found is no proof: the proof stands on the section's page.
 *
 *     static void
 *     interior_edges_have_two_sides(const point2 *points, uint32_t n)
 *     {
 *         HYPOTHESIS(n >= 3);
 *         ...
 *         CLAIM("def4.P3", sides == 2, "edge %u has %u sides", e, sides);
 *     }
 *
 *     int
 *     main(int argc, char **argv)
 *     {
 *         test_begin(argc, argv, "Definition 4: a triangulation of a point set");
 *         test_random("an interior edge has two sides",
 *                     interior_edges_have_two_sides, 5000, 60);
 *         return test_end((test_minima){.trials = 5000, .largest_n = 50});
 *     }
 *
 * The output is TAP. The same --seed gives the same bytes.
 */
#ifndef TESTS_HARNESS_H
#define TESTS_HARNESS_H

#include "lib/mesh.h"
#include "lib/point.h"
#include "lib/random.h"
#include "lib/verdict.h"

#include <stdint.h>

/* One trial: searches for a counterexample among these n points. What it allocates
 * it frees; what a failed CLAIM leaves behind does not matter. */
typedef void property(const point2 *points, uint32_t n);

/* ---- Inside a trial. ---- */

/* A claim of a page, by its name there. When it does not hold, the trial fails
 * with a printf sentence of what was seen. */
#define CLAIM(name, holds, ...) \
    (claim_made(name), (holds) ? (void)0 : claim_failed(name, __VA_ARGS__))

/* The input is outside the statement's hypotheses: the trial ends here and is
 * counted. Say it before anything is allocated. */
#define HYPOTHESIS(holds) ((holds) ? (void)0 : hypothesis_missed())

/* CLAIM with the verdict's own sentence and witnesses. */
void claim_verdict(const char *name, verdict v);

/* The triangles to draw if this trial fails. */
void test_picture(triangle_list list);

/* Random numbers, the same whenever this trial is run again. */
random_source *test_random_source(void);

/* ---- A test program. Each of these but the first is one line of the output. ---- */

/* Reads --seed N (1 if not given), --trials-factor K (1) and --only TEXT (run only
 * what contains TEXT), and prints the statement. */
void test_begin(int argc, char **argv, const char *statement);

/* Points of every kind that comes up: uniform, on grids, in clusters, on a circle,
 * on a line, on a parabola, repeated; few of them or as many as most_points. */
void test_random(const char *what, property *p, uint32_t trials, uint32_t most_points);

/* Collinear, cocircular and equal points, exactly or moved by a few ulps; mixed
 * magnitudes; coordinates about the largest and the smallest doubles. */
void test_near_degenerate(const char *what, property *p, uint32_t trials,
                          uint32_t most_points);

/* Every subset of the side x side grid, in some order. Requires: side <= 4. */
void test_grid_subsets(const char *what, property *p, uint32_t side);

/* Every order of the points. Requires: n <= 7. */
void test_permutations(const char *what, property *p, const point2 *points, uint32_t n);

/* These points only: the witness of an erratum, an example of the notes. */
void test_points(const char *what, property *p, const point2 *points, uint32_t n);

/* A check without points. */
void test_run(const char *what, void (*check)(void));

/* Claims, and how often they must be made, all of them together. */
typedef struct claim_minimum {
    const char *names; /* separated by blanks */
    uint64_t times;
} claim_minimum;

/* What the program must at least have tried: a search that has not looked says
 * nothing. zeros, expansions and wide are answers of predicates: zeros met, and those
 * that needed the second and the third tier of 3.4. */
typedef struct test_minima {
    uint64_t trials, largest_n, zeros, expansions, wide;
    claim_minimum made[5]; /* as many as have names */
} test_minima;

/* Prints the counts, asserts the minima and that at most 20 % of the trials were
 * outside the hypotheses. Returns the exit status of main. */
int test_end(test_minima minima);

/* ---- What the macros call. ---- */

void claim_made(const char *name);

#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
_Noreturn void claim_failed(const char *name, const char *seen, ...);

_Noreturn void hypothesis_missed(void);

#endif
