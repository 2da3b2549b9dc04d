/* traces: each student is asked for first steps of the algorithms on points of their
 * own, and the answers that count as right are right.
 *
 * The steps are done here once more, with nothing but the predicates and a table of
 * triangles.
 *
 * Hypotheses: the program is built, as `make test` does.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "tests/harness/harness.h"
#include "tests/harness/tools.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Questions and answers. ---- */

enum { NOBODY = 7 };

/* A question, as the file asks it. */
typedef struct question {
    point2 p[7];
    int third[7][7]; /* counterclockwise triangle a b -> its third corner, or NOBODY */
    int stack[60][2], size;
} question;

static void
add_triangle(question *q, int a, int b, int c, bool there)
{
    q->third[a][b] = there ? c : NOBODY;
    q->third[b][c] = there ? a : NOBODY;
    q->third[c][a] = there ? b : NOBODY;
}

static question
read_question(const char *id, const char *section)
{
    question q = {.size = 0};
    char arguments[100];
    int used = 0, a, b, c;
    snprintf(arguments, sizeof arguments, "%s %s", id, section);
    CLAIM("traces.asks", run_tool("traces", arguments) == 0, "%s", said);
    for (a = 0; a < 7; a++)
        for (b = 0; b < 7; b++)
            q.third[a][b] = NOBODY;
    const char *at = strstr(said, "points:") + strlen("points:");
    for (int i = 0; i < 7; i++, at += used)
        CLAIM("traces.asks",
              sscanf(at, " %*d (%lf,%lf)%n", &q.p[i].x, &q.p[i].y, &used) == 2, "%s",
              said);
    at = strstr(said, "triangles:");
    at = at == NULL ? "" : at + strlen("triangles:");
    for (; sscanf(at, " %d-%d-%d%n", &a, &b, &c, &used) == 3; at += used)
        add_triangle(&q, a, b, c, true);
    at = strstr(said, "on top:");
    at = at == NULL ? "" : at + strlen("on top:");
    for (; sscanf(at, " %d-%d%n", &a, &b, &used) == 2; at += used, q.size++)
        q.stack[q.size][0] = a, q.stack[q.size][1] = b;
    return q;
}

static bool
answer_passes(const char *section, const char *name, const char *answer)
{
    char text[400], path[2200], arguments[2400], line[50];
    snprintf(text, sizeof text, "---- 9.9\n%s: 1\n---- %s\n%s: %s\n---- 9.9\n%s: 1\n",
             name, section, name, answer, name);
    snprintf(path, sizeof path, "%s/tools_traces.txt", build);
    FILE *file = fopen(path, "w");
    if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0)
        abort();
    snprintf(arguments, sizeof arguments, "--check anna '%s' %s", path, section);
    CLAIM("traces.checks", run_tool("traces", arguments) == 0, "%s", said);
    snprintf(line, sizeof line, "%s\tpass\t", name);
    return strstr(said, line) != NULL;
}

/* Lexicographically, as all points are different. */
static void
the_order_is_that_of_the_points(void)
{
    question q = read_question("anna", "2.3");
    int order[7], from = NOBODY, next[7];
    char answer[30] = "", seen[30] = "";
    for (int v = 0; v < 7; v++) {
        int k = v;
        for (; k > 0 &&
               (q.p[v].x < q.p[order[k - 1]].x ||
                (q.p[v].x == q.p[order[k - 1]].x && q.p[v].y < q.p[order[k - 1]].y));
             k--)
            order[k] = order[k - 1];
        order[k] = v;
    }
    for (int i = 0; i < 7; i++)
        sprintf(answer + 2 * i, "%d ", order[i]);
    CLAIM("traces.order", answer_passes("2.3", "order", answer), "%s%s", answer, said);

    /* A hull edge has the other five on its left, and the seventh on its right. */
    bool is_end[7] = {false};
    for (int a = 0; a < 7; a++)
        next[a] = NOBODY;
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            bool hull = i != j;
            for (int k = 0; k < 7; k++) {
                int turn = orient2d(q.p[order[i]], q.p[order[j]], q.p[order[k]]);
                if (k != i && k != j)
                    hull = hull && (k == 6 ? turn < 0 : turn > 0);
            }
            if (hull) {
                next[order[i]] = order[j];
                is_end[order[j]] = true;
            }
        }
    for (int a = 0; a < 7; a++)
        if (next[a] != NOBODY && !is_end[a])
            from = a;
    for (int i = 0; from != NOBODY; from = next[from], i++)
        sprintf(seen + 2 * i, "%d ", from);
    CLAIM("traces.seen", answer_passes("2.3", "seen", seen), "%s: %s", seen, said);
    CLAIM("traces.wrong",
          !answer_passes("2.3", "seen", seen + 2) &&
              !answer_passes("2.3", "order", seen) &&
              !answer_passes("2.3", "order", ""),
          "%s", said);
}

static void
push_by_hand(question *q, int a, int b)
{
    for (int i = 0; i < q->size; i++)
        if ((q->stack[i][0] == a && q->stack[i][1] == b) ||
            (q->stack[i][0] == b && q->stack[i][1] == a))
            return;
    q->stack[q->size][0] = a;
    q->stack[q->size++][1] = b;
}

/* Figure 10 with pairs of points; line 5 may be left out. */
static void
flip_by_hand(question *q, int flips, bool push)
{
    while (flips > 0 && q->size > 0) {
        int *ab = q->stack[--q->size], a = ab[0], b = ab[1];
        int c = q->third[a][b], d = q->third[b][a];
        if (c == NOBODY || d == NOBODY ||
            incircle(q->p[a], q->p[b], q->p[c], q->p[d]) <= 0)
            continue;
        add_triangle(q, a, b, c, false);
        add_triangle(q, b, a, d, false);
        add_triangle(q, d, c, a, true);
        add_triangle(q, c, d, b, true);
        flips--;
        if (!push)
            continue;
        push_by_hand(q, c, a);
        push_by_hand(q, a, d);
        push_by_hand(q, d, b);
        push_by_hand(q, b, c);
    }
}

static void
the_stack_is_that_of_three_flips(void)
{
    question q = read_question("anna", "3.5"), broken = q;
    char answer[300] = "";
    int witnesses = 0, edges = 0;
    flip_by_hand(&q, 3, true);
    for (int i = 0; i < q.size; i++)
        sprintf(answer + 4 * i, "%d-%d ", q.stack[i][i % 2], q.stack[i][1 - i % 2]);
    CLAIM("traces.stack", answer_passes("3.5", "stack", answer), "%s: %s", answer,
          said);
    CLAIM("traces.wrong", !answer_passes("3.5", "stack", answer + 4), "%s", said);

    flip_by_hand(&broken, 1000, false);
    for (int a = 0; a < 7; a++)
        for (int b = 0; b < 7; b++) {
            int c = broken.third[a][b], d = broken.third[b][a];
            if (c == NOBODY || d == NOBODY)
                continue;
            bool bad = incircle(broken.p[a], broken.p[b], broken.p[c], broken.p[d]) > 0;
            sprintf(answer, "%d, %d, %d, %d", a, b, c, d);
            CLAIM("traces.witness", answer_passes("3.5", "witness", answer) == bad,
                  "%s: %s", answer, said);
            sprintf(answer, "%d %d %d %d", a, b, c, a);
            CLAIM("traces.wrong", !answer_passes("3.5", "witness", answer), "%s: %s",
                  answer, said);
            witnesses += bad;
            edges++;
        }
    CLAIM("traces.witness", witnesses > 0 && witnesses < edges, "%d of %d", witnesses,
          edges);
    CLAIM("traces.wrong", !answer_passes("3.5", "witness", "1 2") &&
          !answer_passes("3.5", "witness", "7 8 9 10"), "%s", said);
}

/* The triangles at 6 with an empty circle. */
static void
the_link_is_that_of_the_delaunay_triangulation(void)
{
    question q = read_question("anna", "3.6");
    int next[6], first = NOBODY, length = 0;
    char answer[30] = "";
    for (int a = 0; a < 6; a++) {
        next[a] = NOBODY;
        for (int b = 0; b < 6; b++) {
            bool empty = a != b && orient2d(q.p[6], q.p[a], q.p[b]) > 0;
            for (int c = 0; c < 6 && empty; c++)
                empty = c == a || c == b ||
                        incircle(q.p[6], q.p[a], q.p[b], q.p[c]) <= 0;
            if (empty)
                first = next[a] = b;
        }
    }
    CLAIM("traces.link", first != NOBODY, "6 has no triangle");
    for (int a = next[first]; length == 0 || a != next[first]; a = next[a])
        length += sprintf(answer + length, "%d ", a);
    CLAIM("traces.link", answer_passes("3.6", "link", answer), "%s: %s", answer, said);
    CLAIM("traces.wrong", !answer_passes("3.6", "link", answer + 2), "%s", said);
}

static void
each_student_has_questions_of_their_own(void)
{
    static char annas[5000];
    run_tool("traces", "anna 2.3 3.5 3.6");
    snprintf(annas, sizeof annas, "%.4999s", said);
    CLAIM("traces.same", run_tool("traces", "anna 2.3 3.5 3.6") == 0 &&
          strcmp(said, annas) == 0, "%s", said);
    run_tool("traces", "hann 2.3 3.5 3.6");
    CLAIM("traces.own", strcmp(strstr(said, "points"), strstr(annas, "points")) != 0,
          "%s", said);
    CLAIM("traces.none", run_tool("traces", "anna 2.1") == 1, "%s", said);
    CLAIM("traces.name", run_tool("traces", "'a b' 2.3") == 2 &&
          run_tool("traces", "'a\"b' 2.3") == 2, "%s", said);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "traces: questions about points of a student's own");
    tools_begin(argv);

    test_run("the order is that of the points", the_order_is_that_of_the_points);
    test_run("the stack is that of three flips", the_stack_is_that_of_three_flips);
    test_run("the link is that of the Delaunay triangulation",
             the_link_is_that_of_the_delaunay_triangulation);
    test_run("each student has questions of their own",
             each_student_has_questions_of_their_own);
    return test_end((test_minima){.trials = 4});
}
