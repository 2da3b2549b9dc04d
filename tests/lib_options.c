/* lib/options: what every algorithm refuses, and that it refuses nothing else.
 *
 * Hypotheses: none. Flush-to-zero is tried where there is a way to switch it on.
 */
#include "lib/options.h"

#include "tests/harness/harness.h"

#include <fenv.h>
#include <math.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

static void
expect(tri_status wanted, const point2 *points, uint32_t n, const tri_options *given)
{
    tri_options used;
    tri_status status = tri_accept(points, n, given, &used);
    CLAIM("tri_accept", status == wanted, "\"%s\" and not \"%s\"",
          tri_status_text(status), tri_status_text(wanted));
}

static void
finite_points_are_accepted(const point2 *points, uint32_t n)
{
    tri_options used, given = tri_options_default();
    expect(TRI_OK, points, n, NULL);
    given.direction = (point2){-0x1p-1074, 0};
    CLAIM("tri_accept", tri_accept(points, n, &given, &used) == TRI_OK &&
          used.direction.x == -0x1p-1074 && used.trace == NULL,
          "the options are not those that were given");
    CLAIM("tri_accept", tri_accept(points, n, NULL, &used) == TRI_OK &&
          used.size == sizeof used && used.direction.x == 1 && used.direction.y == 0 &&
          used.trace == NULL, "NULL does not give the defaults");
}

/* One bad coordinate among n points, in whatever place. */
static void
one_bad_coordinate_is_found(const point2 *points, uint32_t n)
{
    const double bad[4] = {NAN, -NAN, INFINITY, -INFINITY};
    HYPOTHESIS(n > 0);
    point2 changed[50];
    for (uint32_t i = 0; i < n; i++)
        changed[i] = points[i];
    random_source *r = test_random_source();
    uint32_t place = random_below(r, n);
    double value = bad[random_below(r, 4)];
    if (random_below(r, 2) == 0)
        changed[place].x = value;
    else
        changed[place].y = value;
    expect(TRI_NOT_FINITE, changed, n, NULL);
}

static void
bad_options_are_refused(void)
{
    const point2 bad[] = {{0, 0}, {-0.0, 0}, {NAN, 1}, {1, NAN}, {INFINITY, 0},
                          {0, -INFINITY}};
    tri_options options = tri_options_default();
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        options.direction = bad[i];
        expect(TRI_BAD_OPTION, NULL, 0, &options);
    }
    options = tri_options_default();
    options.threads = 0;
    expect(TRI_BAD_OPTION, NULL, 0, &options);
    for (int i = TRI_CUTS_VERTICAL - 1; i <= TRI_CUTS_ALTERNATING + 1; i++) {
        bool known = i == TRI_CUTS_VERTICAL || i == TRI_CUTS_ALTERNATING;
        options = tri_options_default();
        options.cuts = (tri_cuts)i;
        expect(known ? TRI_OK : TRI_BAD_OPTION, NULL, 0, &options);
    }
    for (int i = TRI_LOCATOR_WALK - 1; i <= TRI_LOCATOR_GRID + 1; i++) {
        bool known = i == TRI_LOCATOR_WALK || i == TRI_LOCATOR_BUCKETS ||
                     i == TRI_LOCATOR_HISTORY || i == TRI_LOCATOR_GRID;
        options = tri_options_default();
        options.locator = (tri_locator)i;
        expect(known ? TRI_OK : TRI_BAD_OPTION, NULL, 0, &options);
    }
    options = tri_options_default();
    options.size--;
    expect(TRI_BAD_OPTION, NULL, 0, &options);
    options.size += 2;
    expect(TRI_BAD_OPTION, NULL, 0, &options);
}

static void
wrong_arithmetic_is_refused(void)
{
    const int wrong[3] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (int i = 0; i < 3; i++) {
        CLAIM("tri_accept", fesetround(wrong[i]) == 0, "rounding mode %d", i);
        tri_options used;
        tri_status status = tri_accept(NULL, 0, NULL, &used);
        fesetround(FE_TONEAREST);
        CLAIM("tri_accept", status == TRI_BAD_FP_ENVIRONMENT, "rounding mode %d: %s", i,
              tri_status_text(status));
    }
#ifdef __SSE2__
    const unsigned flush[2] = {0x8000, 0x0040}; /* of results, of operands */
    for (int i = 0; i < 2; i++) {
        unsigned control = _mm_getcsr();
        _mm_setcsr(control | flush[i]);
        tri_options used;
        tri_status status = tri_accept(NULL, 0, NULL, &used);
        _mm_setcsr(control);
        CLAIM("tri_accept", status == TRI_BAD_FP_ENVIRONMENT,
              "subnormals are flushed: %s", tri_status_text(status));
    }
#endif
    expect(TRI_OK, NULL, 0, NULL);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/options: what every algorithm refuses");
    test_random("finite points are accepted", finite_points_are_accepted, 500, 50);
    test_near_degenerate("finite points are accepted", finite_points_are_accepted, 500,
                         50);
    test_random("one bad coordinate is found", one_bad_coordinate_is_found, 1000, 50);
    test_run("bad options are refused", bad_options_are_refused);
    test_run("wrong arithmetic is refused", wrong_arithmetic_is_refused);
    return test_end((test_minima){.trials = 2000, .largest_n = 50});
}
