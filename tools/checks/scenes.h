/* scenes.h - all points but one, and where that one lies: exercises 3.6-a and 3.6-b.
 * And what triangles and edges are called, outside ones too.
 */
#ifndef TOOLS_CHECKS_SCENES_H
#define TOOLS_CHECKS_SCENES_H

#include "tools/checks/checker.h"
#include "tools/checks/meshes.h"
#include "tools/checks/sphere.h"

typedef struct scene {
    uint32_t p;
    piece before;  /* of all points that are not at the place of p */
    sphere around; /* the same with the outside */
} scene;

/* Random triangles of all points but p. false, and nothing to forget: fewer than two
 * locations are left. */
bool set_scene(session *s, scene *sc, uint32_t p, const site *at, uint32_t n);

/* Gives the points and the mesh to the program; the session frees the triangles
 * then. */
void give_scene(session *s, const scene *sc);

/* Frees the rest, and zeroes what set_scene sets. */
void forget_scene(scene *sc);

/* "in a triangle", ... of a spot, or of a place: walk.h. */
const char *spot_name(spot how);

/* What a failure calls a triangle, "triangle 1-2-3" or "the outside of 1-2", and an
 * edge, "1-2" or "the edge from 1 to infinity". */
typedef struct name {
    char text[60];
} name;

name name_of_triangle(vertex_id infinity, vertex_id a, vertex_id b, vertex_id c);
name name_of_edge(vertex_id infinity, vertex_id a, vertex_id b);

/* The triangle of side e of the scene. */
name name_of(const scene *sc, halfedge_id e);

/* Draws a triangle; of an outside one its side. */
void show_triangle(session *s, svg_style style, vertex_id infinity, vertex_id a,
                   vertex_id b, vertex_id c);
void show_triangle_of(session *s, svg_style style, const scene *sc, halfedge_id e);

#endif
