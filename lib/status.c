/* status.c - the sentences of status.h. */
#include "lib/status.h"

const char *
tri_status_text(tri_status status)
{
    switch (status) {
    case TRI_OK:
        return "no error";
    case TRI_OUT_OF_MEMORY:
        return "out of memory: use fewer points or a larger machine";
    case TRI_TOO_MANY_POINTS:
        return "too many points: at most 715827882 locations have 32-bit handles";
    case TRI_NOT_FINITE:
        return "a coordinate is NaN or infinite: remove that point";
    case TRI_BAD_OPTION:
        return "an option has a value that means nothing (a zero direction?)";
    case TRI_BAD_FP_ENVIRONMENT:
        return "floating point does not round to nearest with gradual underflow: "
               "restore the default environment before the call";
    case TRI_CANCELLED:
        return "stopped by the observer";
    case TRI_BAD_FILE:
        return "the file is malformed";
    case TRI_CANNOT_READ:
        return "the file cannot be read";
    case TRI_CANNOT_WRITE:
        return "the file cannot be written";
    case TRI_OUT_OF_RANGE:
        return "a result is larger than the largest double: points nearly on "
               "one line have a circle that is too large";
    }
    return "unknown status";
}
