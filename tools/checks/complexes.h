/* complexes.h - lists of simplices, and what is wrong with them as a complex.
 *
 * (Definition 3: each face is listed, and two simplices meet in a common face or not at
 * all. Page 2.1 says why it is enough to look at vertices and edges.)
 */
#ifndef TOOLS_CHECKS_COMPLEXES_H
#define TOOLS_CHECKS_COMPLEXES_H

#include "tools/checks/plane.h"

enum { MOST_SIMPLICES = 400 };

/* As a set of dimension + 1 vertices, in increasing order; 0 <= dimension <= 2, or up
 * to 3 where only faces are counted; -1 is the empty face. */
typedef struct face {
    int dimension;
    uint32_t vertex[4];
} face;

typedef struct face_list {
    uint32_t count;
    face item[MOST_SIMPLICES];
} face_list;

bool face_equals(const face *s, const face *t);

/* Are all vertices of s among those of t? */
bool face_is_part(const face *s, const face *t);

bool face_is_listed(const face_list *list, const face *s);

/* Adds s and all its faces but the empty one, each once, as far as there is room. */
void faces_close(face_list *list, const face *s);

/* What is wrong, as far as these vertices show it: an index out of range (always
 * shown), a flat simplex, a face that is missing, two equal simplices, a vertex inside
 * a simplex or at the place of another, two edges that cross; all of their vertices
 * must be marked. NULL: nothing. With every vertex marked, NULL says that the list is a
 * complex. */
const char *faces_fault(const site *points, uint32_t n, const face_list *list,
                        const bool *marked);

#endif
