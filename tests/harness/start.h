/* start.h - triangulations and diagrams to begin with, and what is asked of them. */
#ifndef TESTS_START_H
#define TESTS_START_H

#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "lib/mesh.h"
#include "tests/harness/harness.h"

/* A direction, never (0,0); often one along which many points are met together. */
point2 random_direction(void);

/* The triangles to draw if this trial fails: those of the mesh as it is now. */
void show(const mesh *m);

/* Some triangulation of the points: a sweep in a random direction and then random
 * flips, of which any number may be none. Fails the trial when there is no memory. */
void random_triangulation(const point2 *points, uint32_t n, mesh *out);

/* Some Delaunay triangulation of the points: by one of the algorithms, and then with
 * other diagonals wherever cocircular sites leave a choice. */
mesh random_delaunay(const point2 *points, uint32_t n);

/* Such a triangulation, and the Voronoi diagram that is dual to it. */
void random_diagram(const point2 *points, uint32_t n, mesh *m, voronoi *d);

/* How many edges leave v. Requires: one at least. */
uint32_t degree(const mesh *m, vertex_id v);

/* Is the triangle in the list, whichever corner comes first? */
bool has_triangle(triangle_list list, const vertex_id *t);

/* n points with whole coordinates 0 .. most, small enough to compute with them exactly
 * in a test. Drawn coordinates that are such numbers stay (so a failure shrinks to
 * points that can be shown); others are replaced at random, all of them if drawn is
 * NULL. The caller frees them. */
point2 *whole_points(const point2 *drawn, uint32_t n, uint32_t most);

#endif
