/* Pictures are well-formed, finite, and show what they were asked to show.
 *
 * Hypotheses: none. A box may be a point, a line, 1e308 wide or subnormal.
 *
 * A picture is drawn into a temporary file and read back. Whether it is beautiful
 * somebody has to see; that no number in it is infinite, that all tags close and
 * that every point lies inside its panel can be asserted.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "lib/memory.h"
#include "lib/svg.h"
#include "lib/svg_write.h"
#include "tests/harness/harness.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- Reading a picture. ---- */

static char *
read_back(FILE *file)
{
    long size = ftell(file);
    CLAIM("svg.well_formed", size >= 0 && !ferror(file), "cannot write");
    char *text = memory_array((size_t)size + 1, 1);
    CLAIM("svg.well_formed", text != NULL, "no memory for %ld bytes", size);
    rewind(file);
    text[fread(text, 1, (size_t)size, file)] = '\0';
    fclose(file);
    return text;
}

/* Do all tags close, in order, and is & used for the three entities only? Deep
 * enough for svg in svg in svg; a picture's tags have names of at most 15 letters. */
static const char *
malformed(const char *text)
{
    char open[8][16];
    int depth = 0;
    for (const char *s = text; *s != '\0'; s++) {
        if (*s == '&' && strncmp(s, "&lt;", 4) != 0 && strncmp(s, "&gt;", 4) != 0 &&
            strncmp(s, "&amp;", 5) != 0)
            return "a loose &";
        if (*s == '>')
            return "a loose >";
        if (*s != '<')
            continue;
        bool closing = s[1] == '/';
        char name[16];
        int length = 0;
        s += closing ? 2 : 1;
        while (isalpha((unsigned char)*s) && length < 15)
            name[length++] = *s++;
        name[length] = '\0';
        int quotes = 0;
        for (; *s != '\0' && (*s != '>' || quotes % 2 == 1); s++) {
            quotes += *s == '"';
            if (*s == '<')
                return "a tag in a tag";
        }
        if (*s == '\0' || length == 0)
            return "a tag that does not end";
        if (closing && (depth == 0 || strcmp(open[--depth], name) != 0))
            return "a tag closed that is not open";
        if (!closing && s[-1] != '/') {
            if (depth == 8)
                return "too deep";
            strcpy(open[depth++], name);
        }
    }
    return depth == 0 ? NULL : "a tag left open";
}

/* Does every attribute that begins with a number, and every path, hold nothing but
 * numbers with at most two decimals and the letters of paths? */
static bool
numbers_are_plain(const char *text)
{
    for (const char *s = strstr(text, "=\""); s != NULL; s = strstr(s, "=\"")) {
        bool path = s[-1] == 'd' && s[-2] == ' ';
        s += 2;
        if (!path && !isdigit((unsigned char)*s) && *s != '-')
            continue;
        for (; *s != '"'; s++)
            if (strchr("0123456789-. %", *s) == NULL &&
                !(path && strchr("MLAhz", *s) != NULL))
                return false;
    }
    return strstr(text, " r=\"-") == NULL && strstr(text, "nan") == NULL &&
           strstr(text, "inf") == NULL;
}

/* ---- Drawing everything. ---- */

/* Everything in the vocabulary, on the first few points. */
static void
draw_things(svg *page, const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i + 2 < n && i < 6; i++) {
        point2 a = points[i], b = points[i + 1], c = points[i + 2];
        svg_style style = (svg_style)(i % (SVG_FAINT + 1));
        svg_triangle(page, a, b, c, style);
        svg_circle(page, a, b, c, style);
        svg_rectangle(page, svg_box_of(&points[i], 3), style);
        svg_segment(page, a, b, style);
        svg_arrow(page, b, c, style);
        svg_halfedge(page, a, b, "a & b", style);
        svg_angle(page, a, b, c, "<", style);
        svg_label(page, b, "b", style);
    }
}

static verdict
some_verdict(uint32_t n)
{
    verdict v = verdict_refuted("drawn for a test");
    for (vertex_id i = 0; i < n && i < 4; i++)
        v = verdict_with(v, i);
    return v;
}

static char *
draw_everything(const point2 *points, uint32_t n)
{
    mesh m;
    triangle_list list;
    CLAIM("svg.well_formed", sweep_triangulate(points, n, NULL, &m) == TRI_OK &&
          mesh_triangles(&m, &list) == TRI_OK, "no triangulation to draw");
    FILE *file = tmpfile();
    CLAIM("svg.well_formed", file != NULL, "no temporary file");
    svg_box box = svg_box_of(points, n);
    verdict v = some_verdict(n);
    svg page;
    svg_layout layout = svg_one_panel(box);
    layout.columns = 2;
    layout.rows = 2;
    svg_begin(&page, file, layout, "a < b & \"c\"", "all of it");
    svg_panel(&page, box, n, "a triangulation");
    svg_triangulation(&page, points, n, list);
    svg_panel(&page, box, n, "a mesh\nthe second line is too many");
    svg_mesh(&page, points, &m);
    svg_panel(&page, box, n, "");
    svg_verdict(&page, points, n, list, &v);
    svg_panel(&page, box, n, "things");
    draw_things(&page, points, n);
    svg_end(&page);
    triangle_list_free(&list);
    mesh_free(&m);
    return read_back(file);
}

/* ---- What is asserted. ---- */

static void
pictures_are_well_formed(const point2 *points, uint32_t n)
{
    char *text = draw_everything(points, n);
    const char *wrong = malformed(text);
    CLAIM("svg.well_formed", wrong == NULL, "%s", wrong == NULL ? "" : wrong);
    CLAIM("svg.well_formed", numbers_are_plain(text), "a number that is none");
    char *again = draw_everything(points, n);
    CLAIM("svg.same_bytes", strcmp(text, again) == 0, "drawn twice, two pictures");
    memory_free(again);
    memory_free(text);
}

/* Every point lies inside the panel, a margin away from its border, and the order
 * of coordinates is the order on the page. */
static void
points_are_where_they_are(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    FILE *file = tmpfile();
    CLAIM("svg.inside", file != NULL, "no temporary file");
    svg_box box = svg_box_of(points, n);
    svg page;
    svg_begin(&page, file, svg_one_panel(box), "", "");
    svg_panel(&page, box, n, "");
    double width = page.layout.width, height = page.layout.height;
    for (uint32_t i = 0; i < n; i++) {
        point2 p = svg_place(&page, points[i]), q = svg_place(&page, points[0]);
        CLAIM("svg.inside", p.x > 7 && p.x < width - 7 && p.y > 7 && p.y < height - 7,
              "point %u at %g, %g of %g, %g", i, p.x, p.y, width, height);
        CLAIM("svg.inside", (points[i].x <= points[0].x || p.x >= q.x) &&
              (points[i].y <= points[0].y || p.y <= q.y),
              "points 0 and %u change places", i);
    }
    /* The box fills its panel in one direction, unless it is a single point. */
    point2 low = svg_place(&page, box.min), high = svg_place(&page, box.max);
    double margin = 8 + 1.3 * page.em + 0.01;
    bool single = box.min.x == box.max.x && box.min.y == box.max.y;
    CLAIM("svg.inside", single || high.x - low.x >= width - 2 * margin ||
          low.y - high.y >= height - 2 * margin, "%g by %g of %g by %g",
          high.x - low.x, low.y - high.y, width, height);
    svg_end(&page);
    fclose(file);
}

static void
texts_are_escaped(void)
{
    const char *const given[] = {"a<b>&c", "\001\177\t", "\303\251\342\210\236",
                                 "\360\237\230\200", "one\ntwo"};
    const char *const wanted[] = {"a&lt;b&gt;&amp;c", "???", "\303\251\342\210\236",
                                  "\360\237\230\200", "one"};
    for (size_t i = 0; i < sizeof given / sizeof given[0]; i++) {
        FILE *file = tmpfile();
        CLAIM("svg.escaped", file != NULL, "no temporary file");
        svg_put_text(file, given[i]);
        char *text = read_back(file);
        CLAIM("svg.escaped", strcmp(text, wanted[i]) == 0, "text %u became %s",
              (unsigned)i, text);
        memory_free(text);
    }
}

static void
numbers_are_rounded(void)
{
    const double given[] = {0, -0.001, 1.5, -2.25, 0.05, 12.999, 1e308, -INFINITY, 7.1};
    const char *const wanted[] = {"0", "0", "1.5", "-2.25", "0.05", "13", "1000000",
                                  "-1000000", "7.1"};
    for (size_t i = 0; i < sizeof given / sizeof given[0]; i++) {
        FILE *file = tmpfile();
        CLAIM("svg.numbers", file != NULL, "no temporary file");
        svg_put_number(file, given[i]);
        char *text = read_back(file);
        CLAIM("svg.numbers", strcmp(text, wanted[i]) == 0, "%g became %s", given[i],
              text);
        memory_free(text);
    }
}

/* On a grid of nine points there is room: no label may cover a point. */
static void
labels_keep_clear(void)
{
    point2 points[9];
    for (int i = 0; i < 9; i++)
        points[i] = (point2){i % 3, i / 3};
    FILE *file = tmpfile();
    CLAIM("svg.labels", file != NULL, "no temporary file");
    svg page;
    svg_begin(&page, file, (svg_layout){1, 1, 300, 300, 0}, "", "");
    svg_panel(&page, svg_box_of(points, 9), 9, "");
    svg_points(&page, points, 9, SVG_PLAIN);
    svg_label_points(&page, points, 9);
    CLAIM("svg.labels", page.inks == 18, "%u things instead of 18", page.inks);
    for (uint32_t i = 9; i < page.inks; i++)
        for (uint32_t j = 0; j < i; j++) {
            point2 p = page.ink[i].a, q = page.ink[j].a;
            double gap = hypot(p.x - q.x, p.y - q.y) - page.ink[i].radius -
                         page.ink[j].radius;
            CLAIM("svg.labels", gap >= 0, "label %u overlaps thing %u by %g", i, j,
                  -gap);
        }
    svg_end(&page);
    fclose(file);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "Pictures are well-formed, finite and inside their panels");
    test_random("pictures", pictures_are_well_formed, 200, 30);
    test_near_degenerate("pictures", pictures_are_well_formed, 400, 20);
    test_random("places", points_are_where_they_are, 2000, 60);
    test_near_degenerate("places", points_are_where_they_are, 4000, 20);
    test_run("texts", texts_are_escaped);
    test_run("numbers", numbers_are_rounded);
    test_run("labels", labels_keep_clear);
    return test_end((test_minima){.trials = 6000, .largest_n = 55});
}
