/* sketch.c - a few points as characters on a grid, for where no picture can be shown.
 *
 * A unit is two columns and one line, which are about as long as each other. If the
 * points lie far apart, several units are one place.
 */
#include "tools/checks/feedback.h"

#include <string.h>

enum { MOST_LABELS = 10, MOST_ACROSS = 24, MOST_UP = 12 };

/* The lowest and the highest corner of the points' box. */
static void
box_of(const site *points, uint32_t n, site *low, site *high)
{
    *low = *high = points[0];
    for (uint32_t i = 1; i < n; i++) {
        site p = points[i];
        low->x = p.x < low->x ? p.x : low->x;
        low->y = p.y < low->y ? p.y : low->y;
        high->x = p.x > high->x ? p.x : high->x;
        high->y = p.y > high->y ? p.y : high->y;
    }
}

void
sketch_print(FILE *file, const char *margin, const site *points, uint32_t n)
{
    char line[MOST_UP + 1][2 * MOST_ACROSS + 2] = {{0}};
    site low, high;
    int32_t unit = 1;
    if (n < 2 || n > MOST_LABELS)
        return;
    box_of(points, n, &low, &high);
    while ((high.x - low.x) / unit > MOST_ACROSS || (high.y - low.y) / unit > MOST_UP)
        unit++;
    memset(line, ' ', sizeof line);
    for (uint32_t i = 0; i < n; i++) {
        char *at =
            &line[(points[i].y - low.y) / unit][2 * ((points[i].x - low.x) / unit)];
        if (*at != ' ')
            return;
        *at = (char)('0' + i);
    }
    for (int32_t up = (high.y - low.y) / unit; up >= 0; up--) {
        int width = (int)sizeof line[0];
        while (width > 0 && line[up][width - 1] == ' ')
            width--;
        fprintf(file, "%s%.*s\n", width > 0 ? margin : "", width, line[up]);
    }
}
