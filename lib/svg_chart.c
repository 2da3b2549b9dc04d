/* svg_chart.c - a table of numbers, and its curves. */
#include "lib/svg_chart.h"

#include "lib/decimal.h"
#include "lib/memory.h"

#include <math.h>
#include <string.h>

/* The number of that name among those found so far; a new one comes last. */
static int
number_of(const char *name, const char *known[CHART_CURVES], int *count)
{
    for (int i = 0; i < *count; i++)
        if (strcmp(known[i], name) == 0)
            return i;
    if (*count < CHART_CURVES)
        known[(*count)++] = name;
    return *count - 1;
}

/* ---- Reading the table. ---- */

enum { MOST_CELLS = 32, LINE_LENGTH = 1000 };

/* Cuts the line at its commas; returns how many cells there are. */
static int
cells_of(char *line, char *cell[MOST_CELLS])
{
    int count = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at != NULL && count < MOST_CELLS; count++) {
        cell[count] = at;
        at = strchr(at, ',');
        if (at != NULL)
            *at++ = '\0';
    }
    return count;
}

static bool
number_in(const char *cell, double *value)
{
    return decimal_read(cell, strlen(cell), value) == DECIMAL_NUMBER && *value > 0;
}

/* One line of the table: TRI_OK also if it has no number to show. */
static tri_status
read_line(char *line, int column, bool divide_by_x, chart *c)
{
    char *cell[MOST_CELLS];
    chart_point p = {.x = 0};
    if (cells_of(line, cell) <= column || !number_in(cell[1], &p.x) ||
        p.x < 1 || !number_in(cell[column], &p.y))
        return TRI_OK;
    if (strlen(cell[0]) >= CHART_NAME || strlen(cell[2]) >= CHART_NAME)
        return TRI_BAD_FILE;
    strcpy(p.panel, cell[0]);
    strcpy(p.curve, cell[2]);
    p.y = divide_by_x ? p.y / p.x : p.y;
    if ((c->count & (c->count - 1)) == 0) { /* there is room for a power of two */
        size_t room = c->count > 0 ? 2 * (size_t)c->count : 1;
        chart_point *more = memory_resize(c->point, room, sizeof *more);
        if (more == NULL)
            return TRI_OUT_OF_MEMORY;
        c->point = more;
    }
    c->point[c->count++] = p;
    return TRI_OK;
}

static void
choose_styles(chart *c)
{
    static const svg_style styles[] = {SVG_PLAIN, SVG_BAD, SVG_GOOD, SVG_NEW,
                                       SVG_STRONG};
    const char *known[CHART_CURVES];
    int curves = 0;
    for (uint32_t i = 0; i < c->count; i++)
        c->point[i].style = styles[number_of(c->point[i].curve, known, &curves) % 5];
}

tri_status
chart_read(FILE *table, const char *column, bool divide_by_x, chart *out)
{
    char line[LINE_LENGTH], *cell[MOST_CELLS];
    tri_status status = TRI_BAD_FILE;
    int at = MOST_CELLS, cells = 0;
    *out = (chart){0};
    if (fgets(line, sizeof line, table) != NULL)
        cells = cells_of(line, cell);
    for (int i = 3; i < cells; i++)
        if (strcmp(cell[i], column) == 0) {
            at = i;
            status = TRI_OK;
        }
    while (status == TRI_OK && fgets(line, sizeof line, table) != NULL)
        status = read_line(line, at, divide_by_x, out);
    choose_styles(out);
    if (status != TRI_OK)
        chart_free(out);
    return status;
}

void
chart_free(chart *c)
{
    memory_free(c->point);
    *c = (chart){0};
}

/* ---- Axes. In a panel, positions are pixels, and y points up. ---- */

static const double WIDTH = 330, HEIGHT = 270;         /* of a panel */
static const double LEFT = 34, RIGHT = 90, BELOW = 16; /* around its frame */
static const double LABEL_HEIGHT = 13;

typedef struct axes {
    point2 low, high;   /* of the table */
    point2 corner, top; /* of the frame: where these are drawn */
    bool tens;          /* y is marked at powers of ten only */
} axes;

/* From a to b in equal steps for equal ratios; in the middle if all v are the same. */
static double
between(double v, double low, double high, double a, double b)
{
    if (low == high)
        return (a + b) / 2;
    return a + (log2(v) - log2(low)) / (log2(high) - log2(low)) * (b - a);
}

static point2
place_of(const axes *a, double x, double y)
{
    return (point2){between(x, a->low.x, a->high.x, a->corner.x, a->top.x),
                    between(y, a->low.y, a->high.y, a->corner.y, a->top.y)};
}

/* The next of 1, 2, 5, 10, 20, 50, ... after v, which is one of them; of 1, 10, 100,
 * ... on an axis that is too long for more. */
static double
next_tick(double v, bool tens)
{
    if (tens)
        return 10 * v;
    double first = v;
    while (first >= 10)
        first /= 10;
    while (first < 0.99)
        first *= 10;
    return first > 1.5 && first < 3 ? v * 2.5 : v * 2;
}

/* A power of ten that is not above v. */
static double
power_of_ten_below(double v)
{
    double p = 1;
    while (p > v)
        p /= 10;
    while (10 * p <= v)
        p *= 10;
    return p;
}

static axes
axes_of(const chart *c)
{
    axes a = {.corner = {LEFT, BELOW}, .top = {WIDTH - RIGHT, HEIGHT - 30}};
    a.low = a.high = (point2){c->point[0].x, c->point[0].y};
    for (uint32_t i = 1; i < c->count; i++) {
        a.low.x = fmin(a.low.x, c->point[i].x);
        a.low.y = fmin(a.low.y, c->point[i].y);
        a.high.x = fmax(a.high.x, c->point[i].x);
        a.high.y = fmax(a.high.y, c->point[i].y);
    }
    double least = power_of_ten_below(a.low.y), most;
    a.tens = a.high.y > 1e4 * least;
    for (double next; (next = next_tick(least, a.tens)) <= a.low.y;)
        least = next;
    for (most = least; most < a.high.y || most == least;)
        most = next_tick(most, a.tens);
    a.low.y = least;
    a.high.y = most;
    return a;
}

static void
text_at(svg *page, double x, double y, const char *text, svg_style style)
{
    point2 at = svg_place(page, (point2){x, y});
    svg_text(page, at, text, style);
}

/* A power of two, written as one, at every second tick of x. */
static void
draw_axes(svg *page, const axes *a)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴",
                                        "⁵", "⁶", "⁷", "⁸", "⁹"};
    char text[DECIMAL_ROOM];
    for (double y = a->low.y; y <= a->high.y * 1.01; y = next_tick(y, a->tens)) {
        double up = place_of(a, a->low.x, y).y;
        svg_segment(page, (point2){a->corner.x, up}, (point2){a->top.x, up}, SVG_FAINT);
        decimal_write(text, y);
        text_at(page, a->corner.x - 4 - svg_text_width(text) / 2, up, text, SVG_PLAIN);
    }
    for (int k = (int)ceil(log2(a->low.x)); k <= log2(a->high.x); k++) {
        double right = place_of(a, ldexp(1, k), a->low.y).x;
        svg_segment(page, (point2){right, a->corner.y},
                    (point2){right, a->corner.y + (k % 2 == 0 ? 6 : 3)}, SVG_PLAIN);
        if (k % 2 != 0)
            continue;
        snprintf(text, sizeof text, "2%s%s", k >= 10 ? digit[k / 10 % 10] : "",
                 digit[k % 10]);
        text_at(page, right, a->corner.y - 11, text, SVG_PLAIN);
    }
}

/* ---- Curves. ---- */

typedef struct curve_end {
    const char *name;
    svg_style style;
    point2 at;    /* the last point */
    double label; /* how high the name stands */
} curve_end;

/* Names stand at their curves' ends, one above the other where these are close. */
static void
draw_names(svg *page, const axes *a, curve_end *end, int count)
{
    for (int i = 1; i < count; i++) /* from the lowest to the highest */
        for (int k = i; k > 0 && end[k].at.y < end[k - 1].at.y; k--) {
            curve_end higher = end[k - 1];
            end[k - 1] = end[k];
            end[k] = higher;
        }
    for (int i = 0; i < count; i++)
        end[i].label = end[i].at.y;
    for (int round = 0; round < 100; round++) /* push those apart that are too close */
        for (int i = 1; i < count; i++) {
            double push = (LABEL_HEIGHT - (end[i].label - end[i - 1].label)) / 2;
            if (push > 0) {
                end[i].label = fmin(end[i].label + push, a->top.y);
                end[i - 1].label = fmax(end[i - 1].label - push, a->corner.y);
            }
        }
    for (int i = 0; i < count; i++) {
        svg_segment(page, end[i].at, (point2){a->top.x + 12, end[i].label}, SVG_FAINT);
        text_at(page, a->top.x + 14 + svg_text_width(end[i].name) / 2, end[i].label,
                end[i].name, end[i].style);
    }
}

static void
draw_curves(svg *page, const chart *c, const axes *a, const char *panel)
{
    const char *known[CHART_CURVES];
    curve_end end[CHART_CURVES];
    int curves = 0;
    for (uint32_t i = 0; i < c->count; i++) {
        const chart_point *p = &c->point[i];
        if (strcmp(p->panel, panel) != 0)
            continue;
        point2 at = place_of(a, p->x, p->y);
        int before = curves, k = number_of(p->curve, known, &curves);
        if (curves > before)
            end[k] = (curve_end){.name = p->curve, .style = p->style};
        else
            svg_segment(page, end[k].at, at, p->style);
        svg_points(page, &at, 1, p->style);
        end[k].at = at;
    }
    draw_names(page, a, end, curves);
}

void
svg_charts(FILE *file, const chart *c, const char *title, const char *description,
           const char *caption)
{
    const char *panel[CHART_CURVES];
    int panels = 0;
    for (uint32_t i = 0; i < c->count; i++)
        number_of(c->point[i].panel, panel, &panels);
    svg page;
    enum { SIZES = 150, MARGINS = 31 }; /* dots and lines as for so many points */
    svg_layout layout = {3, (uint32_t)(panels + 2) / 3, WIDTH + MARGINS,
                         HEIGHT + MARGINS, 1};
    svg_begin(&page, file, layout, title, description);
    axes a = axes_of(c);
    for (int i = 0; i < panels; i++) {
        char text[200];
        snprintf(text, sizeof text, "%s: %s", panel[i], caption);
        svg_panel(&page, (svg_box){{0, 0}, {WIDTH, HEIGHT}}, SIZES, text);
        draw_axes(&page, &a);
        draw_curves(&page, c, &a, panel[i]);
    }
    svg_end(&page);
}
