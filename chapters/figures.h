/* figures.h - the frame of every program that draws a section's figures.
 *
 * Needs: lib/output.h. Included by chapters/SECTION/figures.c only: programs,
 * so they may print and exit.
 */
#ifndef CHAPTERS_FIGURES_H
#define CHAPTERS_FIGURES_H

#include "lib/output.h"
#include "lib/status.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct figure {
    const char *name; /* of the file, without .svg */
    void (*draw)(FILE *file);
} figure;

/* Ends the program with a sentence, unless all is well. */
static inline void
must(tri_status status, const char *what)
{
    if (status == TRI_OK)
        return;
    fprintf(stderr, "%s: %s\n", what, tri_status_text(status));
    exit(1);
}

/* Draws the figures into the folder argv[1]; what main returns. */
static inline int
draw_figures(int argc, char **argv, const figure *figures, size_t count)
{
    if (argc != 2) {
        fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    for (size_t i = 0; i < count; i++) {
        char path[4096];
        int length = snprintf(path, sizeof path, "%s/%s.svg", argv[1],
                              figures[i].name);
        must(length < (int)sizeof path ? TRI_OK : TRI_CANNOT_WRITE, argv[1]);
        output o;
        must(output_begin(&o, path), path);
        figures[i].draw(o.file);
        must(output_commit(&o), path);
    }
    return 0;
}

#endif
