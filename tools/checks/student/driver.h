/* driver.h - what stands around a student's function: it reads a case, calls the
 * function, and sends the answer to the checker.
 *
 * Each section has a file SECTION.c beside this one with the function `solve`. What
 * goes wrong in here goes wrong in the student's process: the checker believes none
 * of it, and certifies the answer.
 */
#ifndef TOOLS_CHECKS_STUDENT_DRIVER_H
#define TOOLS_CHECKS_STUDENT_DRIVER_H

#include "lib/mesh.h"
#include "tools/checks/wire.h"

/* One case of the exercise with this letter: reads it with case_..., answers with
 * answer_.... What it allocates it may leave to the end of the process. */
void solve(char exercise);

/* ---- The case, from its first word to its last. ---- */

uint32_t case_number(void);
double case_real(void);
point2 case_point(void);

/* A number n, then n points, which the caller frees. In opaque mode the points are
 * tickets: their coordinates say nothing, and predicates.h knows whose they are. */
point2 *case_points(uint32_t *n);

/* A number n, then n numbers; the caller frees them. */
uint32_t *case_numbers(uint32_t *n);

/* A number t, then three corners for each of t triangles; and the mesh of them. For
 * t = 0 a path follows: its length, and its vertices. Returns the number of sides:
 * half-edge e of the mesh is side e of the case. */
uint32_t case_mesh(uint32_t n, mesh *m);

/* Adds the triangles of `part` to those of *m, ghosts included: half-edge 0 of `part`
 * becomes the next one of *m. Requires: *m has room for them. */
void append_mesh(mesh *m, const mesh *part);

/* ---- The answer. ---- */

void answer_number(uint64_t number);
void answer_sign(int sign);
void answer_real(double x);

/* The triangles of the mesh: their number, then three corners of each. */
void answer_mesh(const mesh *m);

/* The edges of the mesh between points: their number, then both ends of each. */
void answer_edges(const mesh *m);

#endif
