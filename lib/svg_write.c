/* svg_write.c - numbers and texts, written as SVG wants them. */
#include "lib/svg_write.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

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

/* How many bytes does the character at s have, if XML allows it; else 0. */
static int
character_length(const unsigned char *s)
{
    if (s[0] < 0x80)
        return s[0] >= 0x20 && s[0] != 0x7f;
    int length = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
    const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    uint32_t code = s[0] & (0xffu >> (length + 1));
    for (int i = 1; i < length; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (s[i] & 0x3f);
    }
    bool wrong = s[0] < 0xc0 || s[0] >= 0xf8 || code < least[length] ||
                 code > 0x10fffd || (code >= 0xd800 && code < 0xe000) ||
                 (code & 0xfffe) == 0xfffe;
    return wrong ? 0 : length;
}

const char *
svg_put_text(FILE *file, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    while (*s != '\0' && *s != '\n') {
        int length = character_length(s);
        if (length == 0)
            fputc('?', file);
        else if (*s == '<' || *s == '>' || *s == '&')
            fputs(*s == '<' ? "&lt;" : *s == '>' ? "&gt;" : "&amp;", file);
        else
            fwrite(s, 1, (size_t)length, file);
        s += length == 0 ? 1 : length;
    }
    return (const char *)s + (*s == '\n');
}
