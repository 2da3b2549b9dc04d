/* svg_write.c - numbers and texts, written as SVG wants them. */
#include "lib/svg_write.h"

#include <math.h>

/* No picture is larger, and a long holds it. */
static const double LARGEST = 1e6;

/* In hundredths, by integers: printf's %f depends on the locale. */
void
svg_put_number(FILE *file, double v)
{
    long hundredths = lround(100 * fmin(fmax(v, -LARGEST), LARGEST));
    long size = hundredths < 0 ? -hundredths : hundredths;
    fprintf(file, "%s%ld", hundredths < 0 ? "-" : "", size / 100);
    if (size % 10 != 0)
        fprintf(file, ".%02ld", size % 100);
    else if (size % 100 != 0)
        fprintf(file, ".%ld", size % 100 / 10);
}

void
svg_put_attribute(FILE *file, const char *name, double v)
{
    fprintf(file, " %s=\"", name);
    svg_put_number(file, v);
    fputc('"', file);
}

void
svg_put_step(FILE *file, char letter, point2 p)
{
    fputc(letter, file);
    svg_put_number(file, p.x);
    fputc(' ', file);
    svg_put_number(file, p.y);
}

const char *
svg_put_text(FILE *file, const char *text)
{
    for (; *text != '\0' && *text != '\n'; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '<' || c == '>' || c == '&')
            fputs(c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;", file);
        else
            fputc(c < ' ' || c == 0x7f ? '?' : c, file);
    }
    return text + (*text == '\n');
}
