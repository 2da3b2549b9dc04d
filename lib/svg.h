/* svg.h - pictures: a small vocabulary for drawing points and triangles.
 *
 * Needs: lib/point.h, lib/mesh.h, lib/verdict.h.
 *
 * A picture is a grid of panels. Each panel has a caption and shows a box of
 * the world, y pointing up, as large as fits; whatever lies outside is cut off.
 * Boxes may be a point, a line, 1e308 wide or subnormal. Sizes of dots and
 * lines follow the number of points, so that 10 and 10,000 can both be read.
 *
 *     svg page;
 *     svg_box box = svg_box_of(points, n);
 *     svg_begin(&page, file, svg_one_panel(box), "Title", "A description.");
 *     svg_panel(&page, box, n, "the caption");
 *     svg_triangulation(&page, points, n, list);
 *     svg_end(&page);
 *
 * A colour is never the only difference between two styles, a picture has its
 * own background, and readers who prefer a dark one get it. The same calls
 * write the same bytes everywhere, whatever the locale. Positions are rounded
 * to 1/100 of a pixel: what is seen decides nothing. Errors of writing are the
 * caller's to find, with ferror; the file stays open.
 */
#ifndef LIB_SVG_H
#define LIB_SVG_H

#include "lib/mesh.h"
#include "lib/point.h"
#include "lib/verdict.h"

#include <stdint.h>
#include <stdio.h>

typedef enum svg_style {
    SVG_PLAIN,  /* a thin line, a light area: what is there */
    SVG_STRONG, /* a thick line: the hull, or what the text speaks of */
    SVG_NEW,    /* thick and blue, areas hatched /// : what this step made */
    SVG_MARK,   /* broad and orange, to lie under a line: look here */
    SVG_BAD,    /* thick and red, dashed, areas hatched \\\ : what is refuted */
    SVG_GOOD,   /* green, of medium weight: what holds */
    SVG_FAINT   /* thin, grey and dotted: what was, or will be, or helps */
} svg_style;

/* A rectangle of the world. */
typedef struct svg_box {
    point2 min, max;
} svg_box;

/* The smallest box around n points; for none, the unit square. */
svg_box svg_box_of(const point2 *points, uint32_t n);

/* Panels in rows, filled from the left and from the top. */
typedef struct svg_layout {
    uint32_t columns, rows;
    double width, height;   /* of each panel, in pixels */
    uint32_t caption_lines; /* room for the captions */
} svg_layout;

/* One panel of a good size and shape for the box, and one line of caption. */
svg_layout svg_one_panel(svg_box box);

/* Labels keep clear of the things drawn latest, at most so many. */
enum { SVG_REMEMBERED = 256 };

/* A line with round ends, in pixels: where there is ink. */
typedef struct svg_ink {
    point2 a, b;
    double radius;
} svg_ink;

typedef struct svg {
    FILE *file;
    svg_layout layout;
    uint32_t panels; /* begun so far */
    double em;       /* in pixels: the unit of sizes in this panel */

    /* Point p of the world, first scaled by 2^-exponent, is drawn to the right
     * of the panel's centre by (p.x - low.x - half.x) / reach * pixels; up alike.
     * In this order: low + half is rounded when the box is a few ulps wide. */
    int exponent;
    point2 low, half;
    double reach, pixels;

    svg_ink ink[SVG_REMEMBERED]; /* the k-th is ink[k % SVG_REMEMBERED] */
    uint32_t inks;               /* in this panel so far */
} svg;

/* Begins a picture; title and description are for those who cannot see it. */
void svg_begin(svg *page, FILE *file, svg_layout layout, const char *title,
               const char *description);
void svg_end(svg *page);

/* The next panel: shows the box with sizes fit for n points. Lines of the
 * caption are separated by '\n'. Requires: one more panel than before in the
 * layout. */
void svg_panel(svg *page, svg_box box, uint32_t n, const char *caption);

/* ---- Things. Later ones lie on top of earlier ones. ---- */

void svg_points(svg *page, const point2 *points, uint32_t n, svg_style style);
void svg_segment(svg *page, point2 a, point2 b, svg_style style);
void svg_arrow(svg *page, point2 a, point2 b, svg_style style);
void svg_triangle(svg *page, point2 a, point2 b, point2 c, svg_style style);
void svg_rectangle(svg *page, svg_box box, svg_style style);

/* The sides of the triangles of a list. */
void svg_triangles(svg *page, const point2 *points, triangle_list list,
                   svg_style style);

/* The circle through three points; their line if it is as good as straight. */
void svg_circle(svg *page, point2 a, point2 b, point2 c, svg_style style);

/* An arrow left of the segment from a to b, with its name at its left. */
void svg_halfedge(svg *page, point2 a, point2 b, const char *name,
                  svg_style style);

/* The angle at `at` from the direction of a counterclockwise to that of b, with
 * its name in it. Requires: less than 180 degrees. */
void svg_angle(svg *page, point2 at, point2 a, point2 b, const char *name,
               svg_style style);

/* A text beside a point, on the side where there is most room: labels last. */
void svg_label(svg *page, point2 at, const char *text, svg_style style);

/* The same with the numbers 0 .. n-1 for texts. */
void svg_label_points(svg *page, const point2 *points, uint32_t n);

/* ---- In pixels from the panel's upper left corner; y points down. ---- */

/* Where p is drawn. What is absurdly far outside is drawn somewhere outside. */
point2 svg_place(const svg *page, point2 p);

/* About how wide a text is: browsers differ in their fonts. */
double svg_text_width(const char *text);

/* A text whose middle is at `at`. */
void svg_text(svg *page, point2 at, const char *text, svg_style style);

/* Labels from now on keep clear of the line from a to b. */
void svg_remember(svg *page, point2 a, point2 b, double radius);

/* ---- Whole pictures. ---- */

/* The triangles and the points; up to 50 points with their numbers. */
void svg_triangulation(svg *page, const point2 *points, uint32_t n,
                       triangle_list list);

/* The edges of the mesh, hull edges thicker, without points; paths too. */
void svg_mesh(svg *page, const point2 *points, const mesh *m);

/* The triangulation, and what refutes the verdict: one point, the edge from the
 * first witness to the second, the triangle of three; of four a, b, c, d the
 * edge ab, the circle of abc and the point d. Witnesses carry their numbers. */
void svg_verdict(svg *page, const point2 *points, uint32_t n,
                 triangle_list list, const verdict *v);

#endif
