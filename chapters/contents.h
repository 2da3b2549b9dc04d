/* contents.h - the table of all algorithms, in the order of the notes.
 *
 * Every test runs on every row, and the rows are compared with each other.
 */
#ifndef CHAPTERS_CONTENTS_H
#define CHAPTERS_CONTENTS_H

#include "lib/mesh.h"
#include "lib/options.h"
#include "lib/steps.h"

typedef struct algorithm {
    const char *name;     /* as in `tri triangulate --algorithm NAME` */
    const char *section;  /* of the notes */
    const char *function; /* its name in C */
    tri_status (*triangulate)(const point2 *points, uint32_t n,
                              const tri_options *options, mesh *out);
    bool delaunay;             /* is the result a Delaunay triangulation? */
    uint32_t most;             /* more points take longer than tests can wait */
    const char *summary;       /* a phrase for people */
    const figure_steps *steps; /* for those who watch; NULL: it reports nothing */
} algorithm;

extern const algorithm contents[];
extern const uint32_t contents_count;

/* The row with that name, or NULL. */
const algorithm *contents_find(const char *name);

#endif
