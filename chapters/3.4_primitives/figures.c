/* figures.c - the pictures of section 3.4: what the two tests ask, and what
 * rounded arithmetic answers.
 */
#include "chapters/3.4_primitives/determinants.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/figures.h"
#include "lib/svg.h"
#include "lib/svg_write.h"

#include <string.h>

/* ---- What is asked. ---- */

/* The point, and its sign beside it. */
static void
draw_answer(svg *page, point2 p, const char *name, int sign)
{
    char text[16];
    snprintf(text, sizeof text, sign == 0 ? "%s: 0" : "%s: %+d", name, sign);
    svg_style style = sign > 0 ? SVG_NEW : sign < 0 ? SVG_BAD : SVG_STRONG;
    svg_points(page, &p, 1, style);
    svg_label(page, p, text, SVG_STRONG);
}

static void
draw_orient2d_panel(svg *page)
{
    const svg_box box = {{-0.2, -0.6}, {7.6, 5.2}};
    const point2 a = {1, 1}, b = {5, 3}, far = {-3, -1}, end = {11, 6};
    const point2 c[3] = {{1.5, 4.5}, {4, 0.5}, {6.5, 3.75}};
    svg_panel(page, box, 20, "orient2d(a, b, c)");
    svg_segment(page, far, end, SVG_FAINT);
    svg_triangle(page, a, b, c[0], SVG_NEW);
    svg_arrow(page, a, b, SVG_STRONG);
    svg_points(page, (const point2[]){a, b}, 2, SVG_STRONG);
    for (int i = 0; i < 3; i++)
        draw_answer(page, c[i], "c", orient2d(a, b, c[i]));
    svg_label(page, a, "a", SVG_STRONG);
    svg_label(page, b, "b", SVG_STRONG);
}

static void
draw_incircle_panel(svg *page)
{
    const svg_box box = {{-6, -5.5}, {7, 6}};
    const point2 a = {-4, -3}, b = {4, -3}, c = {0, 5};
    const point2 d[3] = {{1, 1}, {6, 3}, {-3, 4}};
    svg_panel(page, box, 20, "incircle(a, b, c, d)");
    svg_circle(page, a, b, c, SVG_FAINT);
    svg_arrow(page, a, b, SVG_STRONG);
    svg_arrow(page, b, c, SVG_STRONG);
    svg_arrow(page, c, a, SVG_STRONG);
    svg_points(page, (const point2[]){a, b, c}, 3, SVG_STRONG);
    for (int i = 0; i < 3; i++)
        draw_answer(page, d[i], "d", incircle(a, b, c, d[i]));
    svg_label(page, a, "a", SVG_STRONG);
    svg_label(page, b, "b", SVG_STRONG);
    svg_label(page, c, "c", SVG_STRONG);
}

static void
draw_tests(FILE *file)
{
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 310, 270, 1},
              "Two questions: which side of a line, which side of a circle",
              "Left: an arrow from a to b; a point c left of it has the sign "
              "+1, right of it -1, in line with it 0. Right: a triangle a, b, "
              "c and its circle; a point d inside has the sign +1, outside -1, "
              "on the circle 0.");
    draw_orient2d_panel(&page);
    draw_incircle_panel(&page);
    svg_end(&page);
}

/* ---- What is answered: a map of signs, with 256 x 256 cells. ---- */

enum { CELLS = 256 };

typedef signed char sign_map[CELLS][CELLS]; /* [row][column] */

/* Is cell (i, j) of this sign, and so are the `width` cells from it on? */
static bool
all_of(sign_map map, int i, int j, int width, int sign)
{
    for (int k = 0; k < width; k++)
        if (map[i][j + k] != sign)
            return false;
    return true;
}

/* Adds the largest rectangle of this sign with the lower left corner (i, j) to
 * the path, first as wide and then as high as can be, and clears it. */
static void
put_rectangle(svg *page, sign_map map, int i, int j, int sign)
{
    int width = 1, height = 1;
    while (j + width < CELLS && map[i][j + width] == sign)
        width++;
    while (i + height < CELLS && all_of(map, i + height, j, width, sign))
        height++;
    for (int k = 0; k < height; k++)
        memset(&map[i + k][j], 0, (size_t)width);
    svg_put_step(page->file, 'M', svg_place(page, (point2){j, i}));
    svg_put_step(page->file, 'L', svg_place(page, (point2){j + width, i}));
    svg_put_step(page->file, 'L',
                 svg_place(page, (point2){j + width, i + height}));
    svg_put_step(page->file, 'L', svg_place(page, (point2){j, i + height}));
}

/* Positive cells blue, negative cells orange, zeros white. Clears the map. */
static void
draw_map(svg *page, sign_map map, const char *caption)
{
    svg_panel(page, (svg_box){{0, 0}, {CELLS, CELLS}}, 10000, caption);
    for (int sign = -1; sign <= 1; sign += 2) {
        fprintf(page->file, "<path class=\"box %s\" d=\"",
                sign > 0 ? "new" : "mark");
        for (int i = 0; i < CELLS; i++)
            for (int j = 0; j < CELLS; j++)
                if (map[i][j] == sign)
                    put_rectangle(page, map, i, j, sign);
        fputs("\"/>\n", page->file);
    }
}

/* The point of cell (i, j): (0.5, 0.5) is the middle of the map. */
static point2
cell_point(int i, int j)
{
    return (point2){0.5 + (j - CELLS / 2) * 0x1p-53,
                    0.5 + (i - CELLS / 2) * 0x1p-53};
}

static signed char
sign_of(double x)
{
    return (signed char)((x > 0) - (x < 0));
}

static void
draw_orient2d_sign(FILE *file)
{
    static sign_map rounded, exact;
    const point2 b = {12, 12}, c = {24, 24};
    for (int i = 0; i < CELLS; i++)
        for (int j = 0; j < CELLS; j++) {
            point2 a = cell_point(i, j);
            rounded[i][j] = sign_of(orient2d_rounded(a, b, c));
            exact[i][j] = (signed char)orient2d(a, b, c);
        }
    svg page;
    svg_begin(&page, file, (svg_layout){2, 1, 310, 310, 2},
              "The sign of orient2d near a line, rounded and exact",
              "256 by 256 points around (0.5, 0.5), each 2^-53 from the next, "
              "beside the line through (12, 12) and (24, 24). Exact signs "
              "change at the diagonal. Rounded ones are 0 in a band of blocks "
              "around it, and blocks of the wrong "
              "sign lie in it.");
    draw_map(&page, rounded,
             "rounded: orient2d_rounded\nblue +, orange -, white 0");
    draw_map(&page, exact, "exact: orient2d\nwhite: the points of the line");
    svg_end(&page);
}

static void
draw_incircle_sign(FILE *file)
{
    static sign_map rounded, exact;
    const point2 a = {12.5, 0.5}, b = {12.5, 24.5}, c = {0.5, 24.5};
    for (int i = 0; i < CELLS; i++)
        for (int j = 0; j < CELLS; j++) {
            point2 d = cell_point(i, j);
            rounded[i][j] = sign_of(incircle_rounded(a, b, c, d));
            exact[i][j] = (signed char)incircle(a, b, c, d);
        }
    svg page;
    svg_begin(
        &page, file, (svg_layout){2, 1, 310, 310, 2},
        "The sign of incircle near a circle, rounded and exact",
        "256 by 256 points around (0.5, 0.5), each 2^-53 from the next, on the "
        "circle through (12.5, 0.5), (12.5, 24.5) and (0.5, 24.5), which looks "
        "straight from so near. Exact signs change at it. Rounded ones are 0 "
        "or wrong in blocks around it.");
    draw_map(&page, rounded,
             "rounded: incircle_rounded\nblue +, orange -, white 0");
    draw_map(&page, exact, "exact: incircle\nwhite: one point of the circle");
    svg_end(&page);
}

int
main(int argc, char **argv)
{
    const figure figures[] = {{"tests", draw_tests},
                              {"orient2d_sign", draw_orient2d_sign},
                              {"incircle_sign", draw_incircle_sign}};
    return draw_figures(argc, argv, figures, sizeof figures / sizeof *figures);
}
