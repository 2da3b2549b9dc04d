/* options.c - the defaults, and the checks before every algorithm. */
#include "lib/options.h"

#include <math.h>

tri_options
tri_options_default(void)
{
    tri_options defaults = {.size = sizeof defaults, .direction = {1, 0},
                            .locator = TRI_LOCATOR_BUCKETS, .threads = 1};
    return defaults;
}

/* The proofs of 3.4 need rounding to nearest and gradual underflow. Both are
 * observed, not asked for: volatile keeps the compiler from knowing the answers. */
static bool
arithmetic_is_ieee(void)
{
    volatile double one = 1, little = 0x1p-60, more = 0x1.8p-53;
    volatile double smallest_normal = 0x1p-1022, half = 0.5;
    volatile double up = one + little, down = -one - little, nearest = one + more;
    volatile double subnormal = smallest_normal * half;
    volatile double restored = subnormal / half;
    return up == 1 && down == -1 && nearest > 1 && subnormal > 0 &&
           restored == smallest_normal;
}

tri_status
tri_accept(const point2 *points, uint32_t n, const tri_options *given,
           tri_options *used)
{
    if (given != NULL && given->size != sizeof *given)
        return TRI_BAD_OPTION; /* and perhaps too short: nothing else is read */
    *used = given != NULL ? *given : tri_options_default();
    if (!isfinite(used->direction.x) || !isfinite(used->direction.y) ||
        (used->direction.x == 0 && used->direction.y == 0))
        return TRI_BAD_OPTION;
    if (used->cuts != TRI_CUTS_VERTICAL && used->cuts != TRI_CUTS_ALTERNATING)
        return TRI_BAD_OPTION;
    if (used->locator != TRI_LOCATOR_WALK && used->locator != TRI_LOCATOR_BUCKETS &&
        used->locator != TRI_LOCATOR_HISTORY && used->locator != TRI_LOCATOR_GRID)
        return TRI_BAD_OPTION;
    if (used->threads == 0)
        return TRI_BAD_OPTION;
    if (!arithmetic_is_ieee())
        return TRI_BAD_FP_ENVIRONMENT;
    for (uint32_t i = 0; i < n; i++)
        if (!isfinite(points[i].x) || !isfinite(points[i].y))
            return TRI_NOT_FINITE;
    return TRI_OK;
}
