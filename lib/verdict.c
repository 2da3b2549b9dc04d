/* verdict.c - making verdicts. */
#include "lib/verdict.h"

#include <stdarg.h>
#include <stdio.h>

verdict
verdict_holds(void)
{
    verdict v = {.holds = true};
    return v;
}

verdict
verdict_refuted(const char *because, ...)
{
    verdict v = {.holds = false};
    va_list arguments;
    va_start(arguments, because);
    vsnprintf(v.because, sizeof v.because, because, arguments);
    va_end(arguments);
    return v;
}

verdict
verdict_with(verdict refuted, vertex_id witness)
{
    if (refuted.witnesses < 4)
        refuted.witness[refuted.witnesses++] = witness;
    return refuted;
}
