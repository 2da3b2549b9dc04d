/* agreement.c - who answered, and was it right? */
#include "tests/oracle/agreement.h"

#include "tests/harness/harness.h"

tier
tier_since(predicate_counts before)
{
    if (predicate_count.signs > before.signs)
        return SIGNS;
    if (predicate_count.expansions > before.expansions)
        return EXPANSIONS;
    return predicate_count.wide > before.wide ? WIDE : FILTER;
}

void
claim_sign(predicate_counts before, int answered, int expected)
{
    bool right = answered == expected;
    switch (tier_since(before)) {
    case FILTER:
        CLAIM("sec3.4.P4", right, "filter: %+d for %+d", answered, expected);
        break;
    case SIGNS:
        CLAIM("sec3.4.P6", right, "step 1: %+d for %+d", answered, expected);
        break;
    case EXPANSIONS:
        CLAIM("sec3.4.P10", right, "step 2: %+d for %+d", answered, expected);
        break;
    case WIDE:
        CLAIM("sec3.4.P11", right, "step 3: %+d for %+d", answered, expected);
    }
}
