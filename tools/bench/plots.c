/* plots.c - the same numbers for the eye: how the cost of a point grows with
 * their number, and the ratios as bars. Both axes, and the bars, are
 * logarithmic. */
#include "tools/bench/bench.h"

#include "lib/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The library draws a plane in which both axes have one scale: a factor of ten
 * is so long in it. */
static const double ACROSS = 100, UP = 60;

enum { COLUMNS = 3 };

/* How far apart a ratio is drawn from 1. No clock is trusted here: a time that
 * was told as 0 must not make the picture infinite. */
static double
length_of(double ratio, double ten)
{
    if (!(ratio > 0) || !isfinite(ratio))
        return 0;
    return fmin(fmax(ten * log10(ratio), -9 * ten), 9 * ten);
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

static point2
place_cost(const bench *b, int s, int i, int c)
{
    return (point2){ACROSS * log10(b->size[s]),
                    length_of(cost(b, s, i, c), UP)};
}

/* What all panels show: a frame of whole powers of ten around all costs. */
static svg_box
box_of_costs(const bench *b)
{
    double low = 0, high = UP;
    for (int s = 0; s < b->sizes; s++)
        for (int i = 0; i < b->inputs; i++)
            for (int c = 0; c < b->contenders; c++)
                if (b->cell[s][i][c].state == CELL_MEASURED) {
                    double y = place_cost(b, s, i, c).y;
                    low = fmin(low, UP * floor(y / UP));
                    high = fmax(high, UP * ceil(y / UP));
                }
    double left = ACROSS * log10(b->size[0]);
    double right = ACROSS * log10(b->size[b->sizes - 1]);
    return (svg_box){{left - 50, low - 30}, {right + 90, high + 10}};
}

static void
draw_axes(const bench *b, svg *page, svg_box box)
{
    char text[32];
    double right = box.max.x - 90;
    for (double y = box.min.y + 30; y <= box.max.y - 10; y += UP) {
        point2 at = {box.min.x + 40, y}, end = {right, y};
        svg_segment(page, at, end, SVG_FAINT);
        snprintf(text, sizeof text, "%g", pow(10, floor(y / UP + 0.5)));
        at.x -= 8 + svg_text_width(text) / 2;
        svg_text(page, svg_place(page, at), text, SVG_PLAIN);
    }
    for (int s = 0; s < b->sizes; s++) {
        double x = ACROSS * log10(b->size[s]);
        point2 at = {x, box.min.y + 12};
        svg_segment(page, (point2){x, box.min.y + 30},
                    (point2){x, box.max.y - 10}, SVG_FAINT);
        snprintf(text, sizeof text, "%lu", (unsigned long)b->size[s]);
        svg_text(page, svg_place(page, at), text, SVG_PLAIN);
    }
}

/* The points of one contender, joined where neighbours have been measured, and
 * its name behind the last one. */
static void
draw_line(const bench *b, svg *page, int i, int c)
{
    int last = -1;
    svg_style style = style_of(&b->contender[c]);
    for (int s = 0; s < b->sizes; s++) {
        if (b->cell[s][i][c].state != CELL_MEASURED)
            continue;
        point2 at = place_cost(b, s, i, c);
        svg_points(page, &at, 1, style);
        if (last >= 0)
            svg_segment(page, place_cost(b, last, i, c), at, style);
        last = s;
    }
}

/* Names that would overlap are moved up, from the lowest on. */
static void
draw_names(const bench *b, svg *page, int i)
{
    double free_from = -1e9;
    bool named[MOST_CONTENDERS] = {false};
    for (;;) {
        int lowest = -1;
        point2 at = {0, 0};
        for (int c = 0; c < b->contenders; c++)
            for (int s = b->sizes - 1; s >= 0 && !named[c]; s--)
                if (b->cell[s][i][c].state == CELL_MEASURED) {
                    point2 p = place_cost(b, s, i, c);
                    if (lowest < 0 || p.y < at.y) {
                        lowest = c;
                        at = p;
                    }
                    break;
                }
        if (lowest < 0)
            return;
        named[lowest] = true;
        at.y = fmax(at.y, free_from);
        free_from = at.y + 13;
        at.x = ACROSS * log10(b->size[b->sizes - 1]);
        point2 middle = svg_place(page, at);
        middle.x += 8 + svg_text_width(b->contender[lowest].name) / 2;
        svg_text(page, middle, b->contender[lowest].name,
                 style_of(&b->contender[lowest]));
    }
}

static void
draw_growth(const bench *b)
{
    svg page;
    svg_box box = box_of_costs(b);
    svg_layout layout = layout_for(b->inputs, box.max.x - box.min.x,
                                   box.max.y - box.min.y);
    output o = begin_file(b, "growth.svg");
    svg_begin(
        &page, o.file, layout, "What a point costs, over the number of points",
        "Processor time a point as a multiple of sorting one, logarithmic.");
    for (int i = 0; i < b->inputs; i++) {
        svg_panel(&page, box, 200, b->input[i]->name);
        draw_axes(b, &page, box);
        for (int c = 0; c < b->contenders; c++)
            draw_line(b, &page, i, c);
        draw_names(b, &page, i);
    }
    svg_end(&page);
    end_file(&o, "growth.svg");
}

/* ---- Ratios. ---- */

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
            double ratio = k->user.least / b->cell[s][i][0].user.least;
            double length = fmax(0, length_of(ratio, ACROSS));
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
    for (double x = 0; x <= most; x += ACROSS)
        svg_segment(page, (point2){x, 0}, (point2){x, -20.0 * row}, SVG_FAINT);
}

static void
draw_ratios(const bench *b)
{
    svg page;
    char caption[100];
    double most = ACROSS;
    int s = b->sizes - 1;
    for (int i = 0; i < b->inputs; i++)
        for (int c = 1; c < b->contenders; c++)
            if (b->cell[s][i][c].state == CELL_MEASURED)
                most = fmax(most, length_of(b->cell[s][i][c].user.least /
                                                b->cell[s][i][0].user.least,
                                            ACROSS));
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
