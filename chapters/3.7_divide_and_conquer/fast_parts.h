/* fast_parts.h - what the files of fast_divide.h share; no program includes it.
 *
 * Notes: section 3.7. Needs: lib/mesh.h.
 *
 * The sites are numbered in the order in which they are divided: a part is a range of
 * numbers, and neighbours in the plane are neighbours in memory. Half-edges e and e^1
 * are twins. There is no ghost, and no triangle is kept: each half-edge knows those
 * beside it around its origin, and the outside is a gap like any other.
 *
 *            ccw         A part of k sites owns 3k edges, more than it can ever have.
 *           /            So who triangulates it asks nobody for memory, and the
 *     origin ---> e      numbers do not depend on who works when.
 *           \
 *            cw
 */
#ifndef CHAPTERS_3_7_FAST_PARTS_H
#define CHAPTERS_3_7_FAST_PARTS_H

#include "lib/mesh.h"

/* Tells the machine that what p points to will be wanted soon: it may be far away. p
 * need not point to anything. */
#if defined __GNUC__
#define FAST_SOON(p) __builtin_prefetch(p)
#else
#define FAST_SOON(p) ((void)0)
#endif

/* A location, in its place. */
typedef struct fast_site {
    double x, y;
    vertex_id id;     /* the lowest index of the points here */
    halfedge_id edge; /* one that leaves it; on the hull, the one along the hull with
                         the outside on its right; NONE if there is none */
} fast_site;

typedef struct fast_edge {
    uint32_t origin; /* the number of a site; NONE: this half-edge is not in use */
    halfedge_id ccw; /* the next one around the origin; its cw stands in an array of its
                        own, since that is all that fast_export.c looks for */
} fast_edge;

/* What a worker reads. The bounds say when a rounded determinant has the right sign:
 * see fast_questions.h. */
typedef struct fast_run {
    fast_site *site;
    fast_edge *edge;
    halfedge_id *cw; /* half-edge -> the next one clockwise around the origin */
    double sure_turn, sure_circle;
    double whole_turn, whole_circle, twice_whole_circle;
} fast_run;

/* The half-edges of a part that are not in use. Those that have been: a list, linked by
 * ccw, of even numbers. Those from `fresh` up to `end` have never been. */
typedef struct fast_pool {
    halfedge_id fresh, end;
    halfedge_id first, last;
} fast_pool;

/* The sites of a part that come first and last in the order of x (equal ones by y), and
 * in the order of y (equal ones by x). */
typedef struct fast_part {
    uint32_t first[2], last[2];
} fast_part;

/* Does p come before q in the order of x (axis 0) or of y (axis 1)? */
static inline bool
fast_before(int axis, const fast_site *p, const fast_site *q)
{
    if (axis == 0)
        return p->x < q->x || (p->x == q->x && p->y < q->y);
    return p->y < q->y || (p->y == q->y && p->x < q->x);
}

static inline bool
fast_same_place(const fast_site *p, const fast_site *q)
{
    return p->x == q->x && p->y == q->y;
}

/* The unused half-edges of sites lo .. lo+count-1. */
fast_pool fast_pool_of(uint32_t lo, uint32_t count);

/* Marks all half-edges of the pool as not in use, and lists them. */
void fast_pool_close(const fast_run *run, fast_pool *pool);

/* The pool of both, after they have been closed. */
fast_pool fast_pool_join(const fast_run *run, fast_pool a, fast_pool b);

/* Triangulates the sites lo .. lo+count-1, up to three and in order along an axis. */
void fast_few(const fast_run *run, fast_pool *pool, uint32_t lo, uint32_t count);

/* Makes one Delaunay triangulation of two: the merge of page 3.7.
 *
 * Requires: along some direction all sites of the one come before all of the other;
 * v is the last of the first, w the first of the second. Either may be a single site.
 */
void fast_merge(const fast_run *run, fast_pool *pool, uint32_t v, uint32_t w);

#endif
