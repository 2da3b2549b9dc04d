/* tri.h - what the commands of the program tri have in common.
 *
 * Needs: lib/textio.h, lib/output.h.
 *
 * A program may end at once: die() is how a command refuses. What is being written
 * is removed then, and when people interrupt it: whatever stood there still does.
 */
#ifndef TOOLS_TRI_H
#define TOOLS_TRI_H

#include "chapters/contents.h"
#include "lib/output.h"
#include "lib/random.h"
#include "lib/textio.h"

#include <stdbool.h>

/* What tri returns to the shell. */
enum { EXIT_HOLDS = 0, EXIT_REFUTED = 1, EXIT_UNUSABLE = 2 };

typedef struct command {
    const char *name;
    int (*run)(int argc, char **argv); /* argv[0] is the name */
    const char *usage;                 /* the arguments after the name */
    const char *help;                  /* what it does, in lines */
} command;

extern const command commands[]; /* ended by a row without a name */

int command_triangulate(int argc, char **argv);
int command_check(int argc, char **argv);
int command_hull(int argc, char **argv);
int command_voronoi(int argc, char **argv);
int command_flipgraph(int argc, char **argv);
int command_graph(int argc, char **argv); /* emst, gabriel, rng, nng */
int command_generate(int argc, char **argv);
int command_trace(int argc, char **argv);
int command_draw(int argc, char **argv);
int command_help(int argc, char **argv);

/* ---- Ending with a message. ---- */

/* Prints a printf sentence on standard error and exits with EXIT_UNUSABLE. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
_Noreturn void die(const char *sentence, ...);

/* The same for wrong arguments: the command's usage follows. */
#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
_Noreturn void die_usage(const char *command, const char *sentence, ...);

/* The whole number 0 .. most that the text is; `what` names it if it is none. */
uint64_t parse_whole(const char *name, const char *what, const char *text,
                     uint64_t most);

/* Dies unless the status is TRI_OK. */
void must(tri_status status);

/* ---- Arguments: the options are taken out, then the rest is read. ---- */

/* Takes the option `name` and the word after it out of argv; that word, or NULL
 * when the option is not there. */
const char *take_option(int *argc, char **argv, const char *name);

/* Takes `name` out of argv; was it there? */
bool take_flag(int *argc, char **argv, const char *name);

/* Dies if an option is left, or not `least` to `most` words are. */
void expect_words(int argc, char **argv, int least, int most);

/* ---- Files. ---- */

/* Says on standard error how far the run is, if that is a terminal and the points that
 * load_points has read are many. load_points and begin_output say so themselves. */
#if defined __GNUC__
__attribute__((format(printf, 1, 2)))
#endif
void tell_progress(const char *sentence, ...);

/* Reads a file or dies with `file:line: what is wrong`. */
text_points load_points(const char *path);
triangle_list load_triangles(const char *path, const text_points *points);

/* Dies if a folder or a pipe has the name, before time is spent on what could
 * not be written there; NULL and "-" will do. */
void check_output(const char *path);

/* output_begin and output_commit, or a message. Between them the program may end in
 * any way that can be caught: no part of a file is left. */
output begin_output(const char *path);
void finish_output(output *o, const char *path);

/* Sends what has been written on its way, or a message: before the first finish_output
 * of several files that shall appear all or not at all. */
void flush_output(const output *o, const char *path);

/* A picture of the points and the triangles, or a message. */
void write_picture(const char *path, const char *title,
                   const text_points *points, triangle_list list);

/* Says on standard error how many points repeat a location. */
void note_copies(uint32_t points, uint32_t locations);

/* The same, and why there are no triangles if there are none. */
void note_degenerate(uint32_t points, uint32_t locations, uint32_t triangles);

/* What tri triangulate runs when nothing is said: the last row of the table of
 * algorithms that gives Delaunay triangulations. */
const algorithm *default_algorithm(void);

/* Takes what some algorithms can be told out of argv (--direction, --cuts, --locator,
 * --seed, --threads); what is not given is the default. */
tri_options parse_options(int *argc, char **argv);

/* ---- distributions.c ---- */

typedef struct distribution {
    const char *name;
    void (*fill)(point2 *points, uint32_t n, random_source *source);
    const char *summary;
} distribution;

extern const distribution distributions[]; /* ended by a row without a name */

/* Every order is equally likely. */
void shuffle_points(point2 *points, uint32_t n, random_source *source);

#endif
