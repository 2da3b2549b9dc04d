/* picture.c - the picture of a failure: points, triangles, and where to look. */
#include "lib/svg.h"
#include "tools/checks/session.h"

#include <stdio.h>
#include <stdlib.h>

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
    char title[200];
    snprintf(title, sizeof title, "%s %s: a case that fails", p->exercise, p->name);
    svg_begin(&page, file, svg_one_panel(box), title, s->seen);
    svg_panel(&page, box, n, title);
    svg_verdict(&page, at, n, s->lists > 0 ? s->kept[s->lists - 1] : (triangle_list){0},
                &s->witness);
    svg_end(&page);
    free(at);
    bool written = ferror(file) == 0;
    return fclose(file) == 0 && written;
}
