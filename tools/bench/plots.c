/* plots.c - the same numbers for the eye: how the cost of a point grows with
 * their number, and the ratios as bars. Both axes, and the bars, are
 * logarithmic. */
#include "tools/bench/bench.h"

#include "lib/memory.h"
#include "lib/svg_chart.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How long a factor of ten is, as a bar. */
static const double TEN = 100;

enum { COLUMNS = 3 };

/* The bar of a ratio; none up to 1. No clock is trusted here: a time that was told as 0
 * must not make the picture infinite. */
static double
length_of(double ratio)
{
    if (!(ratio > 1) || !isfinite(ratio))
        return 0;
    return fmin(TEN * log10(ratio), 9 * TEN);
}

static svg_style
style_of(const contender *c)
{
    if (c->sorts)
        return SVG_FAINT;
    if (c->algorithm == subject())
        return SVG_NEW;
    return c->algorithm != NULL ? SVG_PLAIN : SVG_GOOD;
}

static output
begin_file(const bench *b, const char *name)
{
    char path[400];
    output o = {0};
    snprintf(path, sizeof path, "%s/%s", b->folder, name);
    if (output_begin(&o, path) != TRI_OK)
        refuse("cannot write", path);
    return o;
}

static void
end_file(output *o, const char *name)
{
    if (output_commit(o) != TRI_OK)
        refuse("cannot write", name);
}

static svg_layout
layout_for(int panels, double width, double height)
{
    svg_layout l = {.columns = COLUMNS,
                    .width = width,
                    .height = height,
                    .caption_lines = 1};
    if (panels < COLUMNS)
        l.columns = (uint32_t)panels;
    l.rows = ((uint32_t)panels + l.columns - 1) / l.columns;
    return l;
}

/* ---- Growth. ---- */

/* The cost of a point, as a multiple of what it costs the yardstick to sort one
 * of the first input at the largest size. */
static double
cost(const bench *b, int s, int i, int c)
{
    double unit = b->cell[b->sizes - 1][0][0].user.least /
                  b->size[b->sizes - 1];
    return b->cell[s][i][c].user.least / b->size[s] / unit;
}

/* The curve of a contender on one input. A clock that ticks slowly may have told no
 * time at all, which has no place on a logarithmic axis. */
static void
add_curve(const bench *b, int i, int k, chart *c)
{
    for (int s = 0; s < b->sizes; s++) {
        double y = cost(b, s, i, k);
        if (b->cell[s][i][k].state != CELL_MEASURED || !isfinite(y) || y <= 0)
            continue;
        chart_point *p = &c->point[c->count++];
        *p = (chart_point){
            .style = style_of(&b->contender[k]), .x = b->size[s], .y = y};
        snprintf(p->panel, sizeof p->panel, "%.19s", b->input[i]->name);
        snprintf(p->curve, sizeof p->curve, "%.19s", b->contender[k].name);
    }
}

static void
draw_growth(const bench *b)
{
    chart c = {.count = 0};
    c.point = memory_array((size_t)b->sizes * MOST_INPUTS * MOST_CONTENDERS,
                           sizeof *c.point);
    if (c.point == NULL)
        refuse("there is no memory for", "growth.svg");
    for (int i = 0; i < b->inputs; i++)
        for (int k = 0; k < b->contenders; k++)
            add_curve(b, i, k, &c);
    if (c.count > 0) {
        output o = begin_file(b, "growth.svg");
        svg_charts(o.file, &c, "What a point costs, over the number of points",
                   "Processor time a point as a multiple of sorting one, logarithmic.",
                   "the cost of a point");
        end_file(&o, "growth.svg");
    }
    chart_free(&c);
}

/* ---- Ratios. ---- */

/* What a contender took over what sorting took, at the largest size. */
static double
ratio_of(const bench *b, int i, int c)
{
    const cell *row = b->cell[b->sizes - 1][i];
    return row[c].user.least / row[0].user.least;
}

static void
draw_bars(const bench *b, svg *page, int i, double most)
{
    int s = b->sizes - 1, row = 0;
    for (int c = 1; c < b->contenders; c++) {
        const cell *k = &b->cell[s][i][c];
        char text[32];
        double top = -20.0 * row++;
        const char *name = b->contender[c].name;
        point2 left = {-10 - svg_text_width(name) / 2, top - 8};
        svg_text(page, svg_place(page, left), name, SVG_PLAIN);
        if (k->state == CELL_MEASURED) {
            double ratio = ratio_of(b, i, c);
            double length = length_of(ratio);
            svg_box bar = {{0, top - 15}, {fmax(length, 1), top - 2}};
            svg_rectangle(page, bar, style_of(&b->contender[c]));
            snprintf(text, sizeof text, "%.2f", ratio);
            point2 end = {length + 8 + svg_text_width(text) / 2, top - 8};
            svg_text(page, svg_place(page, end), text, SVG_PLAIN);
        } else {
            const char *why = k->state == CELL_FAILED     ? "failed"
                              : k->state == CELL_TOO_LONG ? "stopped"
                                                          : "not run";
            point2 end = {8 + svg_text_width(why) / 2, top - 8};
            svg_text(page, svg_place(page, end), why, SVG_PLAIN);
        }
    }
    for (double x = 0; x <= most; x += TEN)
        svg_segment(page, (point2){x, 0}, (point2){x, -20.0 * row}, SVG_FAINT);
}

static void
draw_ratios(const bench *b)
{
    svg page;
    char caption[100];
    double most = TEN;
    int s = b->sizes - 1;
    for (int i = 0; i < b->inputs; i++)
        for (int c = 1; c < b->contenders; c++)
            if (b->cell[s][i][c].state == CELL_MEASURED)
                most = fmax(most, length_of(ratio_of(b, i, c)));
    svg_box box = {{-90, -20.0 * (b->contenders - 1) - 5}, {most + 50, 5}};
    output o = begin_file(b, "ratios.svg");
    svg_begin(
        &page, o.file,
        layout_for(b->inputs, box.max.x - box.min.x, box.max.y - box.min.y),
        "Times over that of sorting the same points",
        "A bar for each algorithm and peer, logarithmic: a line stands at each "
        "power of ten.");
    for (int i = 0; i < b->inputs; i++) {
        snprintf(caption, sizeof caption,
                 "%s, %lu points: time over that of sorting", b->input[i]->name,
                 (unsigned long)b->size[s]);
        svg_panel(&page, box, 200, caption);
        draw_bars(b, &page, i, most);
    }
    svg_end(&page);
    end_file(&o, "ratios.svg");
}

void
draw_plots(const bench *b)
{
    draw_growth(b);
    draw_ratios(b);
}
