/* checker.h - the trials of an exercise: what a section's file writes.
 *
 * A property is a sentence that the student's answer must satisfy on every input. A
 * trial tries it on one set of points:
 *
 *     static void
 *     order_is_right(session *s, const site *p, uint32_t n)
 *     {
 *         begin_case(s, 'a', p, n);
 *         give_points(s);
 *         if (!ask(s))
 *             return;
 *         uint32_t count = take_number(s, 0, n, "the number of locations");
 *         ...
 *         expect(s, i < j, "point %u comes before point %u", i, j);
 *     }
 *
 * and the table names it, with the sentence that is shown when it fails:
 *
 *     const property properties[] = {
 *         {"2.3-a", "order", "The indices come in the order of the sweep",
 *          "notes 2.3, line 1 of Figure 3", CASES_GENERAL | CASES_GRID, 60, 200, true,
 *          order_is_right},
 *     };
 *
 * The checker (checker.c) draws the points, runs the trials, makes a case that fails
 * small, and says what was seen. Answers are certified, never compared with another
 * solution's: every right answer passes. All that a trial learns after its first
 * failure is ignored, and numbers taken after it are 0, so a trial need not stop there;
 * but an index that was to be used has to be checked: `failed(s)`.
 */
#ifndef TOOLS_CHECKS_CHECKER_H
#define TOOLS_CHECKS_CHECKER_H

#include "lib/random.h"
#include "lib/svg.h"
#include "lib/triangles.h"
#include "lib/verdict.h"
#include "tools/checks/cases.h"
#include "tools/checks/plane.h"
#include "tools/checks/program.h"

typedef struct session session;

typedef struct property {
    const char *exercise;  /* "2.3-b" */
    const char *name;      /* as in exercises.ini */
    const char *statement; /* what must hold, in a sentence without its full stop */
    const char *place;     /* where the notes and the page say so */
    unsigned families;     /* of points: cases.h */
    uint32_t most;         /* points */
    uint32_t trials;
    bool opaque;           /* are points tickets? */
    void (*trial)(session *s, const site *points, uint32_t n);
} property;

/* What a section's file defines. */
extern const property properties[];
extern const uint32_t property_count;

/* ---- The case. ---- */

/* Begins a case for the exercise with this letter, about these points. */
void begin_case(session *s, char exercise, const site *points, uint32_t n);

/* n, and the points as the mode has them: tickets, or coordinates. */
void give_points(session *s);
void give_number(session *s, uint64_t number);
void give_real(session *s, double x);
void give_numbers(session *s, const uint32_t *number, uint32_t count);

/* Triangles for case_mesh; without triangles, a path. */
void give_triangles(session *s, triangle_list list);
void give_path(session *s, const uint32_t *path, uint32_t count);

/* Sends the case; false when there is no answer, which fails the trial. */
bool ask(session *s);

/* How often the program has asked a question of this kind in this case. */
uint64_t asked(const session *s, wire_kind kind);
uint64_t asked_in_all(const session *s);

/* WIRE_RANDOM: the answers to come, and what was asked. */
void choose(session *s, const uint32_t *chosen, uint32_t count);
const questions *questions_of(const session *s);

/* Random numbers, the same whenever this trial is run again. */
random_source *trial_random(session *s);

/* The variant that was handed out: "" if none. */
const char *variant_of(const session *s);

/* The file of --instances, or NULL: cases that came with their answers (3.4). */
const char *instances_of(const session *s);

/* ---- The answer, strictly read. ---- */

/* The next number, from low to high; anything else fails the trial and gives low. */
uint32_t take_number(session *s, uint32_t low, uint32_t high, const char *what);

/* A tri_status, which must be TRI_OK. */
bool take_ok(session *s);

/* -1, 0 or +1. */
int take_sign(session *s, const char *what);

/* A finite double. */
double take_real(session *s, const char *what);

/* A number of triangles, at most `most`, and corners below n. The session keeps the
 * list. On failure it is empty. */
triangle_list take_triangles(session *s, uint32_t n, uint32_t most);

/* A number of edges, and the ends of each. Collinear points have one edge between
 * neighbours, and no other; anything else fails the trial. */
void take_path(session *s);

/* The answer must end here. */
void take_end(session *s);

/* ---- What must hold. ---- */

/* If not, the trial fails with this printf sentence. Returns `holds`. */
#if defined __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
bool expect(session *s, bool holds, const char *seen, ...);

/* The same with a verdict's sentence and witnesses. */
bool expect_verdict(session *s, verdict v);

bool failed(const session *s);

/* Hands a list over: the session frees it after the trial, and shows it in the picture
 * of a failure unless another list comes later. At most 8 in a trial. */
void keep_triangles(session *s, triangle_list list);

/* One more point to look at in the picture; four at most. Four are an edge, a circle
 * and a point: svg_verdict. */
void show_witness(session *s, uint32_t point);

/* Draws the point, edge or triangle with these 1 to 3 vertices: what the case has
 * beside its triangles (SVG_PLAIN), what was answered (SVG_NEW), what is wrong
 * (SVG_BAD). An index that is none is ignored. begin_case forgets them all. */
void show_face(session *s, svg_style style, const uint32_t *vertex, uint32_t count);
void show_edge(session *s, svg_style style, uint32_t a, uint32_t b);

/* The edges of a path, as a part of the case. */
void show_path(session *s, const uint32_t *path, uint32_t count);

#endif
