/* session.h - what checker.c, session.c and feedback.c know of a trial. */
#ifndef TOOLS_CHECKS_SESSION_H
#define TOOLS_CHECKS_SESSION_H

#include "tools/checks/checker.h"

enum { SESSION_LISTS = 8 };   /* lists of triangles kept in one trial, at most */
enum { SESSION_FACES = 600 }; /* faces shown in a picture; more are left out */

typedef struct shown_face {
    svg_style style;
    uint32_t vertex[3], count;
} shown_face;

struct session {
    /* for all trials */
    program student;
    const char *variant, *instances;
    double seconds;     /* for one answer */
    bool opaque;

    /* for this trial */
    uint64_t seed;
    random_source random;
    words given, answer;
    size_t next; /* word of the answer */
    questions about;
    uint32_t *owner; /* ticket -> point */
    uint32_t *ticket; /* point -> ticket */

    /* how it came out */
    bool failed;
    fate end;        /* of the last case */
    char seen[600];  /* what was seen, in a sentence */
    verdict witness; /* the points to look at */
    triangle_list kept[SESSION_LISTS];
    uint32_t lists;
    shown_face face[SESSION_FACES];
    uint32_t faces;
};

/* One trial, from its seed. Afterwards `failed` and what belongs to it are set. */
void session_trial(session *s, const property *p, uint64_t seed, const site *points,
                   uint32_t n);

/* Frees everything, and ends the program. */
void session_free(session *s);

/* A picture of the failed trial and the points of its case. false: it cannot be
 * written. */
bool picture_write(const session *s, const property *p, const char *path);

#endif
