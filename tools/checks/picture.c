/* picture.c - the picture of a failure: points, triangles, and where to look. */
#include "lib/svg.h"
#include "tools/checks/session.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Some blanks become ends of lines, so that these fit. Returns how many lines. */
static uint32_t
wrap(char *text)
{
    enum { COLUMNS = 90 };
    uint32_t lines = 1;
    size_t begin = 0, blank = 0;
    for (size_t i = 0; text[i] != '\0'; i++) {
        if (text[i] == ' ')
            blank = i;
        if (i - begin == COLUMNS && blank > begin) {
            text[blank] = '\n';
            begin = blank + 1;
            lines++;
        }
    }
    return lines;
}

static void
draw_face(svg *page, const point2 *at, const shown_face *f)
{
    point2 a = at[f->vertex[0]], b = at[f->vertex[1]], c = at[f->vertex[2]];
    if (f->count == 1)
        svg_points(page, &a, 1, f->style);
    else if (f->count == 2)
        svg_segment(page, a, b, f->style);
    else
        svg_triangle(page, a, b, c, f->style);
}

/* Triangles first, then edges, then points. */
static void
draw_faces(svg *page, const session *s, const point2 *at)
{
    for (uint32_t count = 3; count > 0; count--)
        for (uint32_t i = 0; i < s->faces; i++)
            if (s->face[i].count == count)
                draw_face(page, at, &s->face[i]);
}

bool
picture_write(const session *s, const property *p, const char *path)
{
    const site *points = s->about.at;
    uint32_t n = s->about.n;
    FILE *file = fopen(path, "w");
    point2 *at = calloc((size_t)n + 1, sizeof *at);
    if (file == NULL || at == NULL) {
        free(at);
        return file != NULL && fclose(file) == 0 && false;
    }
    for (uint32_t i = 0; i < n; i++)
        at[i] = (point2){points[i].x, points[i].y};

    svg page;
    svg_box box = svg_box_of(at, n);
    if (s->witness.witnesses == 4) { /* room for a circle */
        double margin = fmax(box.max.x - box.min.x, box.max.y - box.min.y) / 4;
        box.min = (point2){box.min.x - margin, box.min.y - margin};
        box.max = (point2){box.max.x + margin, box.max.y + margin};
    }
    svg_layout layout = svg_one_panel(box);
    char title[200], caption[sizeof title + sizeof s->seen];
    snprintf(title, sizeof title, "%s %s: a case that fails", p->exercise, p->name);
    snprintf(caption, sizeof caption, "%s %s: %s", p->exercise, p->name, s->seen);
    layout.caption_lines = wrap(caption);
    svg_begin(&page, file, layout, title, s->seen);
    svg_panel(&page, box, n, caption);
    draw_faces(&page, s, at);
    svg_verdict(&page, at, n, s->lists > 0 ? s->kept[s->lists - 1] : (triangle_list){0},
                &s->witness);
    svg_end(&page);
    free(at);
    bool written = ferror(file) == 0;
    return fclose(file) == 0 && written;
}
