/* svg.c - pictures, written as plain SVG 1.1 with one style sheet. */
#include "lib/svg.h"

#include "lib/svg_write.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stddef.h>

/* Every rule begins with .tri, so that a picture can stand inside a web page
 * without repainting it. Colours: Okabe and Ito (2008), lighter on dark. An em
 * is the panel's, see svg_panel; texts have a size of their own. */
static const char style_sheet[] =
    "<style>\n"
    ".tri{font:13px sans-serif;color:#222}\n"
    ".tri .paper{fill:#fff}\n"
    ".tri path,.tri circle"
    "{fill:none;stroke:currentColor;stroke-linejoin:round}\n"
    ".tri text{fill:currentColor;font-size:13px}\n"
    ".tri .label{stroke:#fff;stroke-width:3px;stroke-linejoin:round;"
    "paint-order:stroke;text-anchor:middle}\n"
    ".tri .plain{color:#444;stroke-width:.1em}\n"
    ".tri .strong{color:#111;stroke-width:.22em}\n"
    ".tri .new{color:#0072b2;stroke-width:.2em}\n"
    ".tri .mark{color:#e69f00;stroke-width:.6em;stroke-linecap:round}\n"
    ".tri .bad{color:#d55e00;stroke-width:.22em;stroke-dasharray:.6em .3em}\n"
    ".tri .good{color:#009e73;stroke-width:.18em}\n"
    ".tri .faint{color:#777;stroke-width:.1em;stroke-dasharray:.2em .3em}\n"
    ".tri .dots{stroke-width:.55em;stroke-linecap:round;"
    "stroke-dasharray:none}\n"
    ".tri .dots.faint{stroke-width:.4em}\n"
    ".tri .dots.new,.tri .dots.bad,.tri .dots.strong{stroke-width:.85em}\n"
    ".tri .dots.mark{stroke-width:1.5em}\n"
    ".tri .area{fill:currentColor;fill-opacity:.12;stroke:none}\n"
    ".tri .box{fill:currentColor;stroke:none}\n"
    ".tri .head{fill:currentColor;stroke:none}\n"
    ".tri .hatch{stroke-width:.07em;stroke-dasharray:none}\n"
    "@media (prefers-color-scheme:dark){\n"
    ".tri{color:#ddd}.tri .paper{fill:#1c1c1e}.tri .label{stroke:#1c1c1e}\n"
    ".tri .plain{color:#bbb}.tri .strong{color:#fff}.tri .new{color:#56b4e9}\n"
    ".tri .bad{color:#ff8c4a}.tri .good{color:#4cc9a0}.tri .faint{color:#999}\n"
    "}\n"
    "</style>\n";

static const char *const class_of[] = {"plain", "strong", "new",  "mark",
                                       "bad",   "good",   "faint"};

/* Far outside every panel. */
static const double FAR = 1e5;

static double
clamp(double v, double low, double high)
{
    return v > low ? (v < high ? v : high) : low;
}

/* ---- From the world to the panel. ---- */

svg_box
svg_box_of(const point2 *points, uint32_t n)
{
    if (n == 0)
        return (svg_box){{0, 0}, {1, 1}};
    svg_box box = {points[0], points[0]};
    for (uint32_t i = 1; i < n; i++) {
        box.min.x = fmin(box.min.x, points[i].x);
        box.min.y = fmin(box.min.y, points[i].y);
        box.max.x = fmax(box.max.x, points[i].x);
        box.max.y = fmax(box.max.y, points[i].y);
    }
    return box;
}

/* The power of two above the box's largest coordinate: scaled by its inverse,
 * no sum or difference of coordinates overflows. */
static int
exponent_of(svg_box box)
{
    int exponent;
    double largest_x = fmax(fabs(box.min.x), fabs(box.max.x));
    double largest_y = fmax(fabs(box.min.y), fabs(box.max.y));
    (void)frexp(fmax(largest_x, largest_y), &exponent);
    return exponent;
}

static point2
scaled(point2 p, int exponent)
{
    return (point2){ldexp(p.x, -exponent), ldexp(p.y, -exponent)};
}

point2
svg_place(const svg *page, point2 p)
{
    p = scaled(p, page->exponent);
    double x = p.x - page->low.x - page->half.x;
    double y = p.y - page->low.y - page->half.y;
    double right = x / page->reach * page->pixels;
    double up = y / page->reach * page->pixels;
    return (point2){page->layout.width / 2 + clamp(right, -FAR, FAR),
                    page->layout.height / 2 - clamp(up, -FAR, FAR)};
}

static void
fit(svg *page, svg_box box, double margin)
{
    page->exponent = exponent_of(box);
    point2 min = scaled(box.min, page->exponent);
    point2 max = scaled(box.max, page->exponent);
    double half_x = (max.x - min.x) / 2, half_y = (max.y - min.y) / 2;
    double room_x = page->layout.width / 2 - margin;
    double room_y = page->layout.height / 2 - margin;
    bool wide = half_x / room_x >= half_y / room_y;

    page->low = min;
    page->half = (point2){half_x, half_y};
    page->reach = wide ? half_x : half_y;
    page->pixels = wide ? room_x : room_y;
    if (!(page->reach > 0)) /* a single point, drawn in the middle */
        page->reach = 1;
}

/* ---- The page and its panels. ---- */

enum { GAP = 14, CAPTION_LINE = 18 };

static double
panel_step_y(const svg_layout *layout)
{
    return layout->height + CAPTION_LINE * layout->caption_lines + GAP;
}

svg_layout
svg_one_panel(svg_box box)
{
    int exponent = exponent_of(box);
    point2 min = scaled(box.min, exponent), max = scaled(box.max, exponent);
    double height = 640 * (max.y - min.y) / fmax(max.x - min.x, DBL_MIN);
    return (svg_layout){1, 1, 640, clamp(height, 160, 640), 1};
}

void
svg_begin(svg *page, FILE *file, svg_layout layout, const char *title,
          const char *description)
{
    *page = (svg){.file = file, .layout = layout};
    double width = GAP + layout.columns * (layout.width + GAP);
    double height = GAP + layout.rows * panel_step_y(&layout);
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\"", file);
    fputs(" class=\"tri\" role=\"img\"", file);
    svg_put_attribute(page->file, "width", width);
    svg_put_attribute(page->file, "height", height);
    fputs(" viewBox=\"0 0", file);
    svg_put_step(page->file, ' ', (point2){width, height});
    fputs("\">\n<title>", file);
    svg_put_text(page->file, title);
    fputs("</title>\n<desc>", file);
    svg_put_text(page->file, description);
    fprintf(file, "</desc>\n%s", style_sheet);
    fputs("<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n", file);
}

static void
end_panel(svg *page)
{
    if (page->panels > 0)
        fputs("</svg>\n", page->file);
}

void
svg_end(svg *page)
{
    end_panel(page);
    fputs("</svg>\n", page->file);
}

void
svg_panel(svg *page, svg_box box, uint32_t n, const char *caption)
{
    const svg_layout *layout = &page->layout;
    uint32_t column = page->panels % layout->columns;
    uint32_t row = page->panels / layout->columns;
    assert(row < layout->rows);
    end_panel(page);
    page->panels++;
    page->inks = 0;
    double pixels_a_point = layout->width * layout->height / (n + 1.0);
    page->em = clamp(sqrt(pixels_a_point) / 4.5, 2, 13);
    fit(page, box, 8 + 1.3 * page->em);

    double x = GAP + column * (layout->width + GAP);
    double y = GAP + row * panel_step_y(layout);
    double baseline = y + layout->height + 0.8 * CAPTION_LINE;
    for (uint32_t line = 0; line < layout->caption_lines; line++) {
        fputs("<text", page->file);
        svg_put_attribute(page->file, "x", x);
        svg_put_attribute(page->file, "y", baseline + CAPTION_LINE * line);
        fputc('>', page->file);
        caption = svg_put_text(page->file, caption);
        fputs("</text>\n", page->file);
    }
    fputs("<svg", page->file); /* an inner svg cuts off what is outside it */
    svg_put_attribute(page->file, "x", x);
    svg_put_attribute(page->file, "y", y);
    svg_put_attribute(page->file, "width", layout->width);
    svg_put_attribute(page->file, "height", layout->height);
    svg_put_attribute(page->file, "font-size", page->em);
    fputs(">\n", page->file);
}

/* ---- Drawing in the panel: positions are pixels from here on. ---- */

static point2
moved(point2 p, point2 direction, double by)
{
    return (point2){p.x + by * direction.x, p.y + by * direction.y};
}

/* The direction from a to b; no direction at all when they coincide. */
static point2
toward(point2 a, point2 b)
{
    double length = sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (!(length > 0))
        return (point2){0, 0};
    return (point2){(b.x - a.x) / length, (b.y - a.y) / length};
}

/* The direction left of d; on the page, y points down. */
static point2
left_of(point2 d)
{
    return (point2){d.y, -d.x};
}

void
svg_remember(svg *page, point2 a, point2 b, double radius)
{
    page->ink[page->inks++ % SVG_REMEMBERED] = (svg_ink){a, b, radius};
}

static void
begin_path(svg *page, const char *kind, svg_style style)
{
    fprintf(page->file, "<path class=\"%s%s\" d=\"", kind, class_of[style]);
}

static void
end_path(svg *page)
{
    fputs("\"/>\n", page->file);
}

static void
draw_segment(svg *page, point2 a, point2 b, svg_style style)
{
    begin_path(page, "", style);
    svg_put_step(page->file, 'M', a);
    svg_put_step(page->file, 'L', b);
    end_path(page);
    svg_remember(page, a, b, (style == SVG_MARK ? 0.3 : 0.1) * page->em);
}

/* An arrow's head with its tip at b; of a half-edge only the left half. */
static void
draw_head(svg *page, point2 a, point2 b, bool half, svg_style style)
{
    point2 d = toward(a, b), tail = moved(b, d, -0.9 * page->em);
    begin_path(page, "head ", style);
    svg_put_step(page->file, 'M', b);
    svg_put_step(page->file, 'L', moved(tail, left_of(d), 0.4 * page->em));
    svg_put_step(page->file, 'L',
                 half ? tail : moved(tail, left_of(d), -0.4 * page->em));
    end_path(page);
}

double
svg_text_width(const char *text)
{
    double width = 0;
    for (const char *s = text; *s != '\0'; s++)
        if (((unsigned char)*s & 0xc0) != 0x80) /* a character begins */
            width += 7.6;
    return width;
}

void
svg_text(svg *page, point2 at, const char *text, svg_style style)
{
    fprintf(page->file, "<text class=\"label %s\"", class_of[style]);
    svg_put_attribute(page->file, "x", at.x);
    svg_put_attribute(page->file, "y", at.y + 4.5);
    fputc('>', page->file);
    svg_put_text(page->file, text);
    fputs("</text>\n", page->file);

    double half = fmax(svg_text_width(text) / 2 - 6, 0);
    point2 left = {at.x - half, at.y}, right = {at.x + half, at.y};
    svg_remember(page, left, right, 6);
}

void
svg_points(svg *page, const point2 *points, uint32_t n, svg_style style)
{
    begin_path(page, "dots ", style); /* a line of length 0 with round ends */
    for (uint32_t i = 0; i < n; i++) {
        point2 at = svg_place(page, points[i]);
        svg_put_step(page->file, 'M', at);
        fputs("h0", page->file);
        svg_remember(page, at, at, 0.4 * page->em);
    }
    end_path(page);
}

void
svg_segment(svg *page, point2 a, point2 b, svg_style style)
{
    draw_segment(page, svg_place(page, a), svg_place(page, b), style);
}

void
svg_arrow(svg *page, point2 a, point2 b, svg_style style)
{
    point2 from = svg_place(page, a), to = svg_place(page, b);
    point2 d = toward(from, to);
    draw_segment(page, from, moved(to, d, -0.6 * page->em), style);
    draw_head(page, from, to, false, style);
}

/* How far does a text reach from its middle in direction d? */
static double
reach_along(point2 d, const char *text)
{
    return fabs(d.x) * svg_text_width(text) / 2 + fabs(d.y) * 6;
}

void
svg_halfedge(svg *page, point2 a, point2 b, const char *name, svg_style style)
{
    point2 from = svg_place(page, a), to = svg_place(page, b);
    point2 d = toward(from, to), left = left_of(d);
    double em = page->em;
    from = moved(moved(from, d, 1.2 * em), left, 0.45 * em);
    to = moved(moved(to, d, -1.2 * em), left, 0.45 * em);
    draw_segment(page, from, to, style);
    draw_head(page, from, to, true, style);
    point2 middle = {from.x / 2 + to.x / 2, from.y / 2 + to.y / 2};
    middle = moved(middle, left, 3 + reach_along(left, name));
    svg_text(page, middle, name, style);
}

/* The parallel lines over a triangle: where x+y (new) or x-y (bad) is a
 * multiple of the gap, each crosses exactly two of its sides or none. */
static void
draw_hatch(svg *page, const point2 corner[3], svg_style style)
{
    double gap = 0.55 * page->em, slope = style == SVG_NEW ? 1 : -1;
    double least = slope > 0 ? 0 : -page->layout.height;
    double most = page->layout.width + (slope > 0 ? page->layout.height : 0);
    begin_path(page, "hatch ", style);
    for (double v = least; v < most; v += gap) {
        char letter = 'M';
        for (int i = 0; i < 3; i++) {
            point2 p = corner[i], q = corner[(i + 1) % 3];
            double at_p = p.x + slope * p.y - v, at_q = q.x + slope * q.y - v;
            if ((at_p < 0) == (at_q < 0))
                continue;
            double t = at_p / (at_p - at_q);
            point2 on_side = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            svg_put_step(page->file, letter, on_side);
            letter = 'L';
        }
    }
    end_path(page);
}

void
svg_triangle(svg *page, point2 a, point2 b, point2 c, svg_style style)
{
    const point2 corner[3] = {svg_place(page, a), svg_place(page, b),
                              svg_place(page, c)};
    begin_path(page, "area ", style);
    for (int i = 0; i < 3; i++)
        svg_put_step(page->file, i == 0 ? 'M' : 'L', corner[i]);
    end_path(page);
    if (style == SVG_NEW || style == SVG_BAD)
        draw_hatch(page, corner, style);
}

void
svg_rectangle(svg *page, svg_box box, svg_style style)
{
    point2 low = svg_place(page, box.min), high = svg_place(page, box.max);
    begin_path(page, "box ", style);
    svg_put_step(page->file, 'M', low);
    svg_put_step(page->file, 'L', (point2){high.x, low.y});
    svg_put_step(page->file, 'L', high);
    svg_put_step(page->file, 'L', (point2){low.x, high.y});
    end_path(page);
}

void
svg_circle(svg *page, point2 a, point2 b, point2 c, svg_style style)
{
    point2 p = svg_place(page, a), q = svg_place(page, b);
    point2 r = svg_place(page, c);
    double qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
    double area = 2 * (qx * ry - qy * rx);
    double qq = qx * qx + qy * qy, rr = rx * rx + ry * ry;
    double x = (qq * ry - rr * qy) / area, y = (rr * qx - qq * rx) / area;
    double radius = sqrt(x * x + y * y);
    if (!(radius < FAR)) { /* as good as straight */
        point2 d = toward(p, qq > rr ? q : r);
        point2 end = moved(p, d, FAR / 10);
        draw_segment(page, moved(p, d, -FAR / 10), end, style);
        return;
    }
    fprintf(page->file, "<circle class=\"%s\"", class_of[style]);
    svg_put_attribute(page->file, "cx", p.x + x);
    svg_put_attribute(page->file, "cy", p.y + y);
    svg_put_attribute(page->file, "r", radius);
    fputs("/>\n", page->file);
}

void
svg_angle(svg *page, point2 at, point2 a, point2 b, const char *name,
          svg_style style)
{
    point2 o = svg_place(page, at);
    point2 to_a = toward(o, svg_place(page, a));
    point2 to_b = toward(o, svg_place(page, b));
    double radius = 2 * page->em;
    begin_path(page, "", style);
    svg_put_step(page->file, 'M', moved(o, to_a, radius));
    svg_put_step(page->file, 'A', (point2){radius, radius});
    fputs(" 0 0 0", page->file); /* not turned, the short way, to the left */
    svg_put_step(page->file, ' ', moved(o, to_b, radius));
    end_path(page);

    /* The name stands beyond the arc, where the angle is as wide as it. */
    point2 sum = {to_a.x + to_b.x, to_a.y + to_b.y};
    point2 middle = toward((point2){0, 0}, sum);
    double cosine = sqrt(sum.x * sum.x + sum.y * sum.y) / 2; /* of the half */
    double sine = sqrt(fmax(1 - cosine * cosine, 0.01));
    double needed = reach_along(left_of(middle), name) * cosine / sine;
    double away = fmax(radius + 3, needed) + reach_along(middle, name);
    point2 summit = moved(o, middle, radius);
    svg_remember(page, moved(o, to_a, radius), summit, 2);
    svg_remember(page, moved(o, to_b, radius), summit, 2);
    svg_text(page, moved(o, middle, away), name, style);
}

void
svg_triangles(svg *page, const point2 *points, triangle_list list,
              svg_style style)
{
    if (list.count == 0)
        return;
    begin_path(page, "", style);
    for (triangle_id t = 0; t < list.count; t++) {
        point2 corner[3];
        for (int i = 0; i < 3; i++) {
            corner[i] = svg_place(page, points[list.corner[t][i]]);
            svg_put_step(page->file, i == 0 ? 'M' : 'L', corner[i]);
        }
        fputc('z', page->file);
        for (int i = 0; i < 3; i++)
            svg_remember(page, corner[i], corner[(i + 1) % 3], 0.1 * page->em);
    }
    end_path(page);
}
