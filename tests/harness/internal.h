/* internal.h - what the three files of the harness tell each other. */
#ifndef TESTS_HARNESS_INTERNAL_H
#define TESTS_HARNESS_INTERNAL_H

#include "tests/harness/harness.h"

#include <stdbool.h>

/* ---- generate.c: where points come from. ---- */

/* A number of points up to `most`: one time in 16 fewer than four, else spread over
 * small and large, so that both are met often. */
uint32_t generate_size(random_source *source, uint32_t most);

/* n points of one of the families of test_random. */
void generate_ordinary(random_source *source, point2 *points, uint32_t n);

/* n points of one of the families of test_near_degenerate. */
void generate_near_degenerate(random_source *source, point2 *points, uint32_t n);

/* Puts the points into a random order. */
void generate_order(random_source *source, point2 *points, uint32_t n);

/* ---- shrink.c: small counterexamples. ---- */

/* Makes points[0..n) smaller and simpler while still_fails says so, at most `runs`
 * times. Returns how many points are left, at the front. Requires: they do fail. */
uint32_t shrink(point2 *points, uint32_t n, unsigned runs);

/* The shortest of 15 to 17 digits that read back as x. */
void shortest_text(double x, char text[32]);

/* ---- harness.c ---- */

/* Does the test that is being shrunk fail in the same way on these points? */
bool still_fails(const point2 *points, uint32_t n);

#endif
