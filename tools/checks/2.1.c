/* 2.1.c - the properties of exercises 2.1-a to 2.1-c: simplicial complexes. */
#include "tools/checks/checker.h"
#include "tools/checks/complexes.h"
#include "tools/checks/meshes.h"

#include <stdio.h>

/* ---- Giving and taking simplices. ---- */

static void
give_face(session *s, const face *f)
{
    give_number(s, (uint64_t)(f->dimension + 1));
    for (int i = 0; i <= f->dimension; i++)
        give_number(s, f->vertex[i]);
}

static void
give_faces(session *s, const face_list *list)
{
    give_number(s, list->count);
    for (uint32_t i = 0; i < list->count; i++)
        give_face(s, &list->item[i]);
}

/* With its vertices in increasing order. */
static face
take_face(session *s)
{
    face f = {.dimension = (int)take_number(s, 0, 4, "a dimension plus one") - 1};
    for (int i = 0; i <= f.dimension && !failed(s); i++) {
        f.vertex[i] = take_number(s, 0, UINT32_MAX, "a vertex");
        expect(s, i == 0 || failed(s) || f.vertex[i - 1] < f.vertex[i],
               "the vertices of a simplex do not increase");
    }
    return f;
}

/* At most `most` of them. */
static void
take_faces(session *s, face_list *list, uint32_t most)
{
    list->count = take_number(s, 0, most, "the number of simplices");
    for (uint32_t i = 0; i < list->count; i++)
        list->item[i] = take_face(s);
    take_end(s);
}

static uint32_t
draw(session *s, uint32_t below)
{
    return random_below(trial_random(s), below);
}

/* As a text, as far as there is room: 0-1-2 0-1 0 ... */
static void
describe(const face *f, uint32_t count, char *text, size_t room)
{
    size_t at = 0;
    text[0] = '\0';
    for (uint32_t i = 0; i < count && at + 50 < room; i++) {
        at += (size_t)snprintf(text + at, room - at, "%s%s", i > 0 ? " " : "",
                               f[i].dimension < 0 ? "(empty)" : "");
        for (int k = 0; k <= f[i].dimension; k++)
            at += (size_t)snprintf(text + at, room - at, "%s%lu", k > 0 ? "-" : "",
                                   (unsigned long)f[i].vertex[k]);
        if (at + 50 >= room)
            snprintf(text + at, room - at, " ...");
    }
}

/* Some simplex over vertices 0 .. 9, of this dimension. */
static face
draw_face(session *s, int dimension)
{
    face f = {.dimension = -1};
    for (uint32_t v = 0; v < 10; v++) {
        uint32_t wanted = (uint32_t)(dimension - f.dimension);
        if (draw(s, 10 - v) < wanted)
            f.vertex[++f.dimension] = v;
    }
    return f;
}

/* ---- 2.1-a: the faces of a simplex. ---- */

/* No points: a simplex is a set of numbers here. */
static face
ask_faces(session *s, face_list *list, bool read)
{
    face f = draw_face(s, (int)draw(s, 5) - 1);
    begin_case(s, 'a', NULL, 0);
    give_face(s, &f);
    list->count = 0;
    if (!ask(s))
        return f;
    if (read)
        take_faces(s, list, 16);
    else
        list->count = take_number(s, 0, UINT32_MAX, "the number of faces");
    return f;
}

/* 2^(k+1): the empty simplex has one, itself. */
static uint32_t
count_faces(int dimension)
{
    return 1u << (dimension + 1);
}

static void
faces_are_counted(session *s, const site *p, uint32_t n)
{
    face_list list;
    char text[80];
    (void)p, (void)n;
    face f = ask_faces(s, &list, false);
    describe(&f, 1, text, sizeof text);
    expect(s, failed(s) || list.count == count_faces(f.dimension),
           "the simplex %s, of dimension %d, has %lu faces, and not %lu", text,
           f.dimension, (unsigned long)count_faces(f.dimension),
           (unsigned long)list.count);
}

static void
faces_are_all(session *s, const site *p, uint32_t n)
{
    face_list list;
    char whole[80], text[80];
    (void)p, (void)n;
    face f = ask_faces(s, &list, true);
    describe(&f, 1, whole, sizeof whole);
    for (uint32_t i = 0; i < list.count && !failed(s); i++) {
        describe(&list.item[i], 1, text, sizeof text);
        expect(s, face_is_part(&list.item[i], &f),
               "%s is listed, and has a vertex that %s has not", text, whole);
        for (uint32_t j = 0; j < i; j++)
            expect(s, !face_equals(&list.item[i], &list.item[j]),
                   "faces %lu and %lu of %s are the same: %s", (unsigned long)j,
                   (unsigned long)i, whole, text);
    }
    expect(s, failed(s) || list.count == count_faces(f.dimension),
           "%lu of the %lu faces of %s are listed", (unsigned long)list.count,
           (unsigned long)count_faces(f.dimension), whole);
}

/* ---- 2.1-b: is it a simplicial complex? ---- */

/* Some simplices of a triangulation of the points, and their faces; each of the points
 * has a place of its own. */
static void
draw_complex(session *s, const site *p, uint32_t n, face_list *list)
{
    triangle_list all = mesh_at_random(trial_random(s), p, n, false);
    keep_triangles(s, all);
    list->count = 0;
    for (uint32_t t = 0; t < all.count; t++) {
        const vertex_id *c = all.corner[t];
        face f = {.dimension = -1};
        uint32_t wanted = draw(s, 4); /* corners of it: 0 to 3 */
        for (vertex_id v = 0; v < n; v++) /* in increasing order */
            if ((v == c[0] || v == c[1] || v == c[2]) && f.dimension + 1 < (int)wanted)
                f.vertex[++f.dimension] = v;
        if (f.dimension >= 0)
            faces_close(list, &f);
    }
    for (uint32_t v = 0; v < n && list->count == 0; v++)
        faces_close(list, &(face){.dimension = 0, .vertex = {v}});
}

/* What is wrong with the list; NULL when it is a complex. */
static const char *
fault_in(const site *p, uint32_t n, const face_list *list)
{
    bool marked[64];
    for (int v = 0; v < 64; v++)
        marked[v] = true;
    return faces_fault(p, n, list, marked);
}

/* Spoils the complex in some way, which may not work here. */
static void
spoil(session *s, uint32_t n, face_list *list)
{
    uint32_t some = draw(s, list->count);
    face f = {.dimension = -1};
    switch (draw(s, 5)) {
    case 0: /* a face goes away */
        list->item[some] = list->item[--list->count];
        break;
    case 1: /* something is listed twice */
        list->item[list->count++] = list->item[some];
        break;
    case 2: /* a vertex that does not exist */
        list->item[some].vertex[list->item[some].dimension] = n + draw(s, 3);
        break;
    default: /* any other simplex, with its faces: it may cross, cover or be flat */
        for (uint32_t v = 0; v < n; v++)
            if (f.dimension < 2 && draw(s, 3) == 0)
                f.vertex[++f.dimension] = v;
        faces_close(list, &f);
        break;
    }
}

/* Draws the list, and not the triangulation from which it comes. */
static void
show_list(session *s, const face_list *list)
{
    keep_triangles(s, (triangle_list){0});
    for (uint32_t i = 0; i < list->count; i++)
        show_face(s, SVG_PLAIN, list->item[i].vertex,
                  (uint32_t)list->item[i].dimension + 1);
}

/* Draws what is wrong: as few vertices as show it, and what is listed with no other. */
static void
show_fault(session *s, const site *p, uint32_t n, const face_list *list)
{
    bool marked[64];
    uint32_t pair[64], count = 0;
    for (int v = 0; v < 64; v++)
        marked[v] = true;
    for (uint32_t v = 0; v < n; v++) {
        marked[v] = false;
        if (faces_fault(p, n, list, marked) == NULL) {
            marked[v] = true;
            pair[count++] = v;
            show_face(s, SVG_BAD, &v, 1);
        }
    }
    if (count == 2) /* an edge that is missing, perhaps */
        show_edge(s, SVG_BAD, pair[0], pair[1]);
    for (uint32_t i = 0; i < list->count; i++) {
        bool all = true;
        for (int k = 0; k <= list->item[i].dimension; k++)
            all = all && list->item[i].vertex[k] < n && marked[list->item[i].vertex[k]];
        if (all)
            show_face(s, SVG_BAD, list->item[i].vertex,
                      (uint32_t)list->item[i].dimension + 1);
    }
}

/* Asks about the list; true when the answer is right. */
static bool
ask_complex(session *s, const site *p, uint32_t n, const face_list *list)
{
    char text[200];
    begin_case(s, 'b', p, n);
    give_points(s);
    give_faces(s, list);
    show_list(s, list);
    if (!ask(s))
        return false;
    describe(list->item, list->count, text, sizeof text);
    const char *fault = fault_in(p, n, list);
    bool says = take_number(s, 0, 1, "the verdict") == 1;
    if (fault == NULL)
        expect(s, says, "the list %s is a complex, and is refuted", text);
    else
        expect(s, !says, "%s in the list %s, and it is accepted", fault, text);
    if (failed(s) && fault != NULL)
        show_fault(s, p, n, list);
    return !failed(s);
}

/* The witness has to show what is wrong. */
static void
check_witness(session *s, const site *p, uint32_t n, const face_list *list)
{
    char text[200], named[60] = "";
    size_t at = 0;
    bool marked[64] = {false};
    uint32_t witnesses = take_number(s, 0, 4, "the number of witnesses");
    for (uint32_t i = 0; i < witnesses; i++) {
        uint32_t v = take_number(s, 0, UINT32_MAX, "a witness");
        if (v < n && !failed(s)) {
            marked[v] = true;
            at += (size_t)snprintf(named + at, sizeof named - at, " %lu",
                                   (unsigned long)v);
            show_face(s, SVG_NEW, &v, 1);
        }
    }
    describe(list->item, list->count, text, sizeof text);
    expect(s, failed(s) || faces_fault(p, n, list, marked) != NULL,
           "%s in the list %s, but the witnesses%s do not show it",
           fault_in(p, n, list), text, witnesses > 0 ? named : " (there are none)");
    if (failed(s))
        show_fault(s, p, n, list);
}

/* First the complex, which is to be accepted, then the spoilt one. */
static void
check_complex(session *s, const site *p, uint32_t n, bool witness)
{
    static face_list list;
    draw_complex(s, p, n, &list);
    if (list.count == 0 || list.count + 8 > MOST_SIMPLICES ||
        !ask_complex(s, p, n, &list))
        return;
    spoil(s, n, &list);
    if (ask_complex(s, p, n, &list) && witness && fault_in(p, n, &list) != NULL)
        check_witness(s, p, n, &list);
}

/* A complex is accepted; the same without one of its vertices is not. */
static void
complexes_are_accepted(session *s, const site *p, uint32_t n)
{
    static face_list list;
    draw_complex(s, p, n, &list);
    if (list.count == 0 || !ask_complex(s, p, n, &list))
        return;
    for (uint32_t i = 0; i < list.count; i++)
        if (list.item[i].dimension > 0) {
            face vertex = {.dimension = 0, .vertex = {list.item[i].vertex[0]}};
            for (uint32_t j = 0; j < list.count; j++)
                if (face_equals(&list.item[j], &vertex))
                    list.item[j] = list.item[--list.count];
            ask_complex(s, p, n, &list);
            return;
        }
}

static void
others_are_refuted(session *s, const site *p, uint32_t n)
{
    check_complex(s, p, n, false);
}

static void
witnesses_show_why(session *s, const site *p, uint32_t n)
{
    check_complex(s, p, n, true);
}

/* ---- 2.1-c: the closure. ---- */

static void
check_closure(session *s, const site *p, uint32_t n, bool once)
{
    static face_list given, closure, expected;
    char list[100], text[80];
    (void)p;
    given.count = draw(s, 2 * n + 1);
    expected.count = 0;
    for (uint32_t i = 0; i < given.count; i++) {
        given.item[i] = draw_face(s, (int)draw(s, 4));
        faces_close(&expected, &given.item[i]);
    }
    describe(given.item, given.count, list, sizeof list);
    begin_case(s, 'c', NULL, 0);
    give_faces(s, &given);
    if (!ask(s))
        return;
    take_ok(s);
    take_faces(s, &closure, MOST_SIMPLICES);
    for (uint32_t i = 0; i < expected.count && !failed(s); i++) {
        describe(&expected.item[i], 1, text, sizeof text);
        expect(s, face_is_listed(&closure, &expected.item[i]),
               "%s is missing in the closure of %s", text, list);
    }
    for (uint32_t i = 0; i < closure.count && !failed(s); i++) {
        describe(&closure.item[i], 1, text, sizeof text);
        expect(s, face_is_listed(&expected, &closure.item[i]),
               "%s is in the closure of %s, and is a face of none of them", text, list);
    }
    if (once)
        expect(s, failed(s) || closure.count == expected.count,
               "%lu simplices are in the closure of %s, but only %lu are different",
               (unsigned long)closure.count, list, (unsigned long)expected.count);
}

static void
closure_has_the_faces(session *s, const site *p, uint32_t n)
{
    check_closure(s, p, n, false);
}

static void
closure_has_them_once(session *s, const site *p, uint32_t n)
{
    check_closure(s, p, n, true);
}

enum { DIFFERENT = CASES_GENERAL | CASES_GRID | CASES_COCIRCULAR | CASES_CONVEX };

const property properties[] = {
    {"2.1-a", "count", "A k-simplex has 2^(k+1) faces", "notes 2.1, Definition 2",
     CASES_FEW, 3, 60, false, faces_are_counted},
    {"2.1-a", "faces", "The faces are all subsets of the vertices, each once",
     "notes 2.1, Definition 2; page 2.1, def2.P1", CASES_FEW, 3, 60, false,
     faces_are_all},
    {"2.1-b", "yes", "A simplicial complex is accepted, and refuted without one vertex",
     "notes 2.1, Definition 3", DIFFERENT, 16, 150, false, complexes_are_accepted},
    {"2.1-b", "no", "A list that breaks Definition 3 is refuted, its complex accepted",
     "notes 2.1, Definition 3; page 2.1, def3.P1", DIFFERENT, 16, 300, false,
     others_are_refuted},
    {"2.1-b", "witness", "The witnesses of a refutation show what is wrong",
     "complex.h, is_complex", DIFFERENT, 16, 300, false, witnesses_show_why},
    {"2.1-c", "faces", "The closure has the simplices, their faces, and nothing else",
     "notes 2.1, Definition 3", CASES_FEW, 3, 150, false, closure_has_the_faces},
    {"2.1-c", "once", "The closure has each of them once", "complex.h, simplex_closure",
     CASES_FEW, 3, 150, false, closure_has_them_once},
};
const uint32_t property_count = sizeof properties / sizeof properties[0];
