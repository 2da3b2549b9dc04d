/* questions.c - first steps of an algorithm on seven points that a name gives. */
#include "tools/handout/questions.h"

#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/random.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REACH = 9, FLIPS = 3 };

/* ---- The points. ---- */

/* The 64-bit FNV-1a hash of the student's name and the section. */
static uint64_t
hash(const char *id, const char *section)
{
    uint64_t h = 14695981039346656037u;
    for (const char *text = id; text != NULL; text = text == id ? section : NULL)
        for (const char *c = text; *c != '\0'; c++)
            h = (h ^ (unsigned char)*c) * 1099511628211u;
    return h;
}

/* No three on a line, no four on a circle. */
static bool
in_general_position(const point2 *p)
{
    for (int a = 0; a < POINTS; a++)
        for (int b = a + 1; b < POINTS; b++)
            for (int c = b + 1; c < POINTS; c++) {
                if (orient2d(p[a], p[b], p[c]) == 0)
                    return false;
                for (int d = c + 1; d < POINTS; d++)
                    if (incircle(p[a], p[b], p[c], p[d]) == 0)
                        return false;
            }
    return true;
}

static void
draw_points(random_source *source, point2 *p)
{
    do {
        for (int i = 0; i < POINTS; i++) {
            p[i].x = (double)random_below(source, 2 * REACH + 1) - REACH;
            p[i].y = (double)random_below(source, 2 * REACH + 1) - REACH;
        }
    } while (!in_general_position(p));
}

/* ---- A section's questions, with what is right. ---- */

#if defined __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
static void
append(char *text, const char *what, ...)
{
    size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(text + length, ROOM - length, what, arguments);
    va_end(arguments);
}

static void
must(tri_status status)
{
    if (status == TRI_OK)
        return;
    fprintf(stderr, "traces: %s\n", tri_status_text(status));
    exit(2);
}

static const char *
before(const char *text)
{
    return text[0] != '\0' ? " " : "";
}

/* 2.3: the order of the sweep, and the hull vertices that the last point sees, from the
 * first to the last of them. Two edges or more are to be seen. */
static bool
ask_sweep(questions *q)
{
    vertex_id order[POINTS];
    uint32_t locations;
    point2 swept[POINTS];
    mesh m;
    must(sort_along(q->points, POINTS, (point2){1, 0}, order, &locations));
    for (int i = 0; i < POINTS; i++) {
        swept[i] = q->points[order[i]];
        append(q->order, "%s%u", before(q->order), order[i]);
    }
    must(sweep_triangulate(swept, POINTS, NULL, &m));

    /* It is joined to the hull vertices that it sees. Around it they come from the hull
     * edge that leaves it to the one that enters it: clockwise on the old hull. */
    vertex_id seen[POINTS];
    int count = 0;
    halfedge_id e = mesh_some_hull_edge(&m);
    while (mesh_origin(&m, e) != POINTS - 1)
        e = mesh_hull_next(&m, e);
    for (; mesh_dest(&m, e) != GHOST; e = mesh_around(&m, e))
        seen[count++] = mesh_dest(&m, e);
    for (int i = count - 1; i >= 0; i--)
        append(q->seen, "%s%u", before(q->seen), order[seen[i]]);
    mesh_free(&m);
    return count >= 3;
}

/* ---- 3.5: the stack after three flips. ---- */

static void
append_edge(char *text, vertex_id a, vertex_id b)
{
    append(text, "%s%u-%u", before(text), a, b);
}

void
write_from_lower_ends(char *edges)
{
    unsigned a, b;
    for (char *at = edges; sscanf(at, "%1u-%1u", &a, &b) == 2;
         at += at[3] == ' ' ? 4 : 3)
        if (a > b) {
            at[0] = (char)('0' + b);
            at[2] = (char)('0' + a);
        }
}

/* Figure 10 until so many flips have been made; how many there were. */
static int
flip_some(edge_stack *L, const point2 *points, int most)
{
    int flips = 0;
    halfedge_id ab;
    while (flips < most && edge_stack_pop(L, &ab))
        if (!is_locally_delaunay(L->m, points, ab)) {
            flip(L->m, ab);
            push_link(L, ab);
            flips++;
        }
    return flips;
}

/* The same with a stack of pairs of points, which no flip turns. */
typedef struct pair {
    vertex_id a, b;
} pair;

static halfedge_id
halfedge_of(const mesh *m, pair ends)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_origin(m, e) == ends.a && mesh_dest(m, e) == ends.b)
            return e;
    return NONE;
}

static void
push_pair(pair *stack, int *size, const mesh *m, halfedge_id e)
{
    pair p = {mesh_origin(m, e), mesh_dest(m, e)};
    for (int i = 0; i < *size; i++)
        if ((stack[i].a == p.a && stack[i].b == p.b) ||
            (stack[i].a == p.b && stack[i].b == p.a))
            return;
    stack[(*size)++] = p;
}

static void
flip_some_by_hand(mesh *m, const point2 *points, int most, char *stack_after)
{
    pair stack[6 * POINTS];
    int size = 0;
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_is_interior(m, e))
            push_pair(stack, &size, m, e);
    while (most > 0 && size > 0) {
        halfedge_id ab = halfedge_of(m, stack[--size]);
        if (is_locally_delaunay(m, points, ab))
            continue;
        flip(m, ab);
        halfedge_id dc = mesh_twin(m, ab);
        push_pair(stack, &size, m, mesh_next(ab));
        push_pair(stack, &size, m, mesh_prev(ab));
        push_pair(stack, &size, m, mesh_next(dc));
        push_pair(stack, &size, m, mesh_prev(dc));
        most--;
    }
    for (int i = 0; i < size; i++)
        append_edge(stack_after, stack[i].a, stack[i].b);
}

static void
append_stack(char *text, const edge_stack *L)
{
    for (uint32_t i = 0; i < L->size; i++)
        append_edge(text, mesh_origin(L->m, L->entry[i]), mesh_dest(L->m, L->entry[i]));
}

static bool
is_delaunay_everywhere(const mesh *m, const point2 *points)
{
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++)
        if (mesh_is_interior(m, e) && !is_locally_delaunay(m, points, e))
            return false;
    return true;
}

/* Whether the stack keeps half-edges, which a flip turns, or pairs of points must make
 * no difference; and after three flips there must be some left to do. */
static bool
ask_flips(questions *q)
{
    mesh m, by_hand;
    edge_stack L;
    char stack[ROOM] = "";
    must(sweep_triangulate(q->points, POINTS, NULL, &m));
    must(sweep_triangulate(q->points, POINTS, NULL, &by_hand));
    must(sweep_triangulate(q->points, POINTS, NULL, &q->broken));
    append(q->given, "triangles:");
    for (halfedge_id e = 0; e < mesh_halfedges(&m); e += 3)
        if (mesh_in_triangle(&m, e))
            append(q->given, " %u-%u-%u", mesh_origin(&m, e), mesh_dest(&m, e),
                   mesh_apex(&m, e));
    must(edge_stack_init(&L, &m));
    push_all_edges(&L);
    append(q->given, "\nL, the last one on top: ");
    char *edges = q->given + strlen(q->given);
    append_stack(edges, &L);
    bool enough = flip_some(&L, q->points, FLIPS) == FLIPS;
    append_stack(q->stack, &L);
    edge_stack_free(&L);
    flip_some_by_hand(&by_hand, q->points, FLIPS, stack);
    write_from_lower_ends(q->stack);
    write_from_lower_ends(stack);

    must(edge_stack_init(&L, &q->broken)); /* line 5 is missing */
    push_all_edges(&L);
    for (halfedge_id ab; edge_stack_pop(&L, &ab);)
        if (!is_locally_delaunay(&q->broken, q->points, ab))
            flip(&q->broken, ab);
    edge_stack_free(&L);
    enough = enough && !is_delaunay_everywhere(&m, q->points) && q->stack[0] != '\0' &&
             strcmp(stack, q->stack) == 0 &&
             !is_delaunay_everywhere(&q->broken, q->points);
    mesh_free(&m);
    mesh_free(&by_hand);
    return enough;
}

bool
is_witness(const questions *q, const unsigned v[4])
{
    const mesh *m = &q->broken;
    halfedge_id e = halfedge_of(m, (pair){v[0], v[1]});
    if (e == NONE || !mesh_is_interior(m, e))
        return false;
    vertex_id c = mesh_apex(m, e), d = mesh_apex(m, mesh_twin(m, e));
    return ((v[2] == c && v[3] == d) || (v[2] == d && v[3] == c)) &&
           !is_locally_delaunay(m, q->points, e);
}

/* ---- 3.6: the link of a point after its insertion. ---- */

/* The last point is to lie inside the hull, and to get five neighbours or more. */
static bool
ask_insertion(questions *q)
{
    mesh m;
    int degree = 0;
    bool inside = true;
    must(lawson_triangulate(q->points, POINTS, NULL, &m));
    halfedge_id begin = mesh_leaving(&m, POINTS - 1), e = begin;
    do {
        inside = inside && mesh_dest(&m, e) != GHOST;
        append(q->link, "%s%u", before(q->link), mesh_dest(&m, e));
        e = mesh_around(&m, e);
        degree++;
    } while (e != begin);
    mesh_free(&m);
    return inside && degree >= 5;
}

/* ---- All of them. ---- */

bool
questions_exist(const char *section)
{
    return strcmp(section, "2.3") == 0 || strcmp(section, "3.5") == 0 ||
           strcmp(section, "3.6") == 0;
}

/* The first points that the student's name gives and that are worth asking about. */
questions
questions_ask(const char *id, const char *section)
{
    random_source source = random_from_seed(hash(id, section));
    for (;;) {
        questions q = {.given = ""};
        draw_points(&source, q.points);
        bool asked = section[2] == '3'   ? ask_sweep(&q)
                     : section[2] == '5' ? ask_flips(&q)
                                         : ask_insertion(&q);
        if (asked)
            return q;
        mesh_free(&q.broken);
    }
}
