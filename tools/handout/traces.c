/* traces.c - questions about seven points, which are different for each student.
 *
 *     traces ID SECTION...                  the questions, as a file to fill in
 *     traces --check ID FILE SECTION...     what is right in a file that was filled in
 *
 * The sections are 2.3, 3.5 and 3.6; others have no questions. Whoever has understood an
 * algorithm does its first steps by hand in minutes; an answer of somebody else is about
 * other points. The points are in general position, so each answer is the only one,
 * but for the witness, of which every right one counts.
 *
 * --check prints lines NAME<TAB>pass|fail<TAB>sentence, as the checkers do. Exit status:
 * 0; 1 there is no question; 2 the program cannot run.
 */
#include "chapters/2.3_line_sweep/sweep.h"
#include "chapters/3.4_primitives/predicates.h"
#include "chapters/3.5_edge_flips/flips.h"
#include "lib/random.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 7, REACH = 9, FLIPS = 3, ROOM = 400 };

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

typedef struct questions {
    point2 points[POINTS];
    char given[ROOM];    /* what is needed besides the points */
    char order[ROOM], seen[ROOM];  /* 2.3 */
    char stack[ROOM];              /* 3.5 */
    mesh broken;                   /* 3.5: what a LawsonFlip without line 5 leaves */
    char link[ROOM];               /* 3.6 */
} questions;

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

/* The same text with each edge written from its lower end. */
static void
write_from_lower_ends(char *edges)
{
    unsigned a, b;
    for (char *at = edges; sscanf(at, "%1u-%1u", &a, &b) == 2; at += at[3] == ' ' ? 4 : 3)
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

/* Whether the stack keeps half-edges, which a flip turns, or pairs of points must make no
 * difference; and after three flips there must be some left to do. */
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

/* Do a and b have an edge with c and d opposite, d inside the circle of a, b, c? */
static bool
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

/* ---- Asking and checking. ---- */

static bool
is_section(const char *section)
{
    return strcmp(section, "2.3") == 0 || strcmp(section, "3.5") == 0 ||
           strcmp(section, "3.6") == 0;
}

/* The first points that the student's name gives and that are worth asking about. */
static questions
ask(const char *id, const char *section)
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

static void
print_questions(const questions *q, const char *section)
{
    printf("\n---- %s\npoints:", section);
    for (int i = 0; i < POINTS; i++)
        printf(" %d (%g,%g)", i, q->points[i].x, q->points[i].y);
    printf("\n%s%s", q->given, q->given[0] != '\0' ? "\n" : "");
    if (section[2] == '3')
        printf("\nA line moves to the right. In which order does it meet the points?\n"
               "order:\n\nWhich hull vertices of the first six does the seventh see, "
               "counterclockwise\nalong their hull?\nseen:\n");
    if (section[2] == '5')
        printf("\nFigure 10 begins with these triangles and this stack L; line 5 pushes as "
               "push_link\ndoes. What is on the stack after three flips, written like L? "
               "(3-4 or 4-3 is the same.)\nstack:\n\nSomebody forgets line 5, so nothing is "
               "pushed. Then the loop ends with an edge ab\nthat is not locally Delaunay, and "
               "opposite to it are c and d. Name one: a b c d.\nwitness:\n");
    if (section[2] == '6')
        printf("\nPoints 0 to 5 have a Delaunay triangulation, and point 6 is inserted. Its "
               "neighbours\nare then, counterclockwise, whichever comes first:\nlink:\n");
}

/* Copies the words, with one blank between them. */
static void
copy_words(char *to, const char *from)
{
    size_t length = 0;
    while (*(from += strspn(from, " \t\r\n,")) != '\0' && length < ROOM - 1) {
        if (length > 0)
            to[length++] = ' ';
        while (strchr(" \t\r\n,", *from) == NULL && length < ROOM - 1)
            to[length++] = *from++;
    }
    to[length] = '\0';
}

/* What stands behind `name:` in this section's part of the file. */
static void
find_answer(FILE *file, const char *section, const char *name, char *answer)
{
    char line[ROOM], here[ROOM] = "";
    size_t length = strlen(name);
    rewind(file);
    answer[0] = '\0';
    while (fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, "---- ", 5) == 0)
            copy_words(here, line + 5);
        if (strcmp(here, section) == 0 && strncmp(line, name, length) == 0 &&
            line[length] == ':')
            copy_words(answer, line + length + 1);
    }
}

/* The same cycle, wherever it begins? */
static bool
same_cycle(const char *answer, const char *link)
{
    char twice[2 * ROOM];
    snprintf(twice, sizeof twice, "%s %s", link, link);
    return strlen(answer) == strlen(link) && strstr(twice, answer) != NULL;
}

static void
report(const char *name, const char *answer, bool right)
{
    printf("%s\t%s\t%s\n", name, right ? "pass" : "fail",
           right ? "right" : answer[0] == '\0' ? "nothing has been filled in"
                                               : "this is not so for your points");
}

static void
check_answers(const questions *q, const char *section, FILE *file)
{
    char answer[ROOM];
    unsigned v[4];
    if (section[2] == '3') {
        find_answer(file, section, "order", answer);
        report("order", answer, strcmp(answer, q->order) == 0);
        find_answer(file, section, "seen", answer);
        report("seen", answer, strcmp(answer, q->seen) == 0);
    } else if (section[2] == '5') {
        find_answer(file, section, "stack", answer);
        write_from_lower_ends(answer);
        report("stack", answer, strcmp(answer, q->stack) == 0);
        find_answer(file, section, "witness", answer);
        report("witness", answer,
               sscanf(answer, "%u %u %u %u", &v[0], &v[1], &v[2], &v[3]) == 4 &&
                   is_witness(q, v));
    } else {
        find_answer(file, section, "link", answer);
        report("link", answer, same_cycle(answer, q->link));
    }
}

/* Letters, digits and . _ - @ only: the name stands in files and on command lines. */
static bool
is_name(const char *id)
{
    for (const char *c = id; *c != '\0'; c++)
        if (!isalnum((unsigned char)*c) && strchr("._-@", *c) == NULL)
            return false;
    return id[0] != '\0' && strlen(id) < 100;
}

int
main(int argc, char **argv)
{
    bool check = argc > 1 && strcmp(argv[1], "--check") == 0;
    char **given = argv + 1 + 2 * check; /* ID or FILE, then the sections */
    if (argc < 3 + 2 * check || !is_name(check ? argv[2] : argv[1])) {
        fputs("usage: traces ID SECTION... | traces --check ID FILE SECTION...\n"
              "ID has letters, digits and . _ - @ only\n", stderr);
        return 2;
    }
    const char *id = check ? argv[2] : argv[1];
    FILE *file = check ? fopen(argv[3], "r") : NULL;
    if (check && file == NULL) {
        perror(argv[3]);
        return 2;
    }
    int asked = 0;
    if (!check)
        printf("Questions for %s: seven points, by hand. Write the answers behind the "
               "colons.\n", id);
    for (char **section = given + 1; *section != NULL; section++) {
        if (!is_section(*section))
            continue;
        questions q = ask(id, *section);
        if (check)
            check_answers(&q, *section, file);
        else
            print_questions(&q, *section);
        mesh_free(&q.broken);
        asked++;
    }
    if (file != NULL)
        fclose(file);
    return asked == 0;
}
