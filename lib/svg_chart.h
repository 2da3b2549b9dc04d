/* svg_chart.h - curves from a table of numbers, on axes that show ratios.
 *
 * Needs: lib/svg.h, lib/status.h.
 *
 * The table is text: lines of cells with commas between them, a header first. Its
 * first three columns say in which panel a point is, its x, and on which curve.
 *
 *     distribution,points,algorithm,orient2d,incircle
 *     uniform,1024,divide,17134,15522
 *
 * Both axes are logarithmic and the same in all panels: equal steps are equal ratios,
 * and a law c n^k is a straight line with the slope k.
 */
#ifndef LIB_SVG_CHART_H
#define LIB_SVG_CHART_H

#include "lib/status.h"
#include "lib/svg.h"

enum { CHART_NAME = 20, CHART_CURVES = 24 };

typedef struct chart_point {
    char panel[CHART_NAME], curve[CHART_NAME];
    svg_style style; /* the same on all of a curve */
    double x, y;     /* x >= 1, y > 0 */
} chart_point;

typedef struct chart {
    chart_point *point; /* point[0 .. count-1], in the order of the table */
    uint32_t count;
} chart;

/* Reads the points whose y is the number in the column of that name, divided by x if
 * it is asked for. Lines with no number there, or 0, are skipped. Curves next to each
 * other in the table have different styles.
 *
 * TRI_BAD_FILE (no such column, or a name that is too long), TRI_OUT_OF_MEMORY:
 * *out is zeroed. */
tri_status chart_read(FILE *table, const char *column, bool divide_by_x, chart *out);

/* Frees the array and zeroes *c; a zeroed struct is accepted. */
void chart_free(chart *c);

/* Draws a picture with a panel for each panel of the table, three in a row; each
 * curve has its name at its end. Names and order are those of the table.
 *
 * Requires: at least one point, at most CHART_CURVES panels and curves. */
void svg_charts(FILE *file, const chart *c, const char *title, const char *description,
                const char *caption);

#endif
