/* What the sentences of tri trace say is so.
 *
 * Each is taken apart into words and numbers, and what the words claim of the points
 * with these numbers is computed again: from the coordinates, by the predicates, and
 * from the edges that there are before the step. A sentence that is not known here is
 * a failure, too.
 */
#include "chapters/3.4_primitives/predicates.h"
#include "tests/harness/harness.h"
#include "tests/harness/replay.h"
#include "tests/harness/shell.h"
#include "tests/harness/start.h"

#include <stdlib.h>
#include <string.h>

/* ---- Sentences. ---- */

/* "3-7 is on the hull" is the words "#-# is on the hull" and the numbers 3, 7. */
typedef struct sentence {
    const char *text;
    char words[2000];
    uint32_t count;
    vertex_id id[500];
} sentence;

static sentence
take_apart(const char *text)
{
    sentence s = {.text = text};
    size_t length = 0;
    for (const char *at = text; *at != '\0';) {
        bool digit = *at >= '0' && *at <= '9';
        if (digit) {
            char *end;
            CLAIM("trace.says", s.count < 500, "too many numbers: %s", text);
            s.id[s.count++] = (vertex_id)strtoul(at, &end, 10);
            at = end;
        }
        CLAIM("trace.says", length + 1 < sizeof s.words, "too long: %s", text);
        s.words[length++] = digit ? '#' : *at++;
    }
    for (uint32_t i = s.count; i < 8; i++)
        s.id[i] = NONE; /* what asks for it will notice */
    return s;
}

static bool
is(const sentence *s, const char *words)
{
    return strcmp(s->words, words) == 0;
}

static bool
begins(const sentence *s, const char *words)
{
    return strncmp(s->words, words, strlen(words)) == 0;
}

/* ---- What there is before a step. ---- */

typedef struct trial {
    const point2 *points;
    replay r; /* before the step */
    const json *step;
    vertex_id l, r_end;       /* 3.7: the ends of the edge that rises */
    bool merging;             /* 3.7: between the lower tangent and the upper one */
    char part[REPLAY_POINTS]; /* 3.7: 'l' and 'r', what is being merged */
    vertex_id asked[8];       /* the numbers of the last question */
    char asked_words[2000];   /* ... and its words */
} trial;

/* +1 left, -1 right, 0 on one line. */
static int
turn(const trial *t, vertex_id a, vertex_id b, vertex_id c)
{
    CLAIM("trace.says", a < t->r.n && b < t->r.n && c < t->r.n,
          "step %u speaks of a point that is none", t->r.next);
    return orient2d(t->points[a], t->points[b], t->points[c]);
}

static bool
there(const trial *t, vertex_id a, vertex_id b)
{
    return a < t->r.n && b < t->r.n && t->r.edge[a][b];
}

/* Which vertices hang together with v? */
static void
mark_part(const trial *t, vertex_id v, char part[REPLAY_POINTS], char mark)
{
    bool more = true;
    part[v] = mark;
    while (more) {
        more = false;
        for (vertex_id a = 0; a < t->r.n; a++)
            for (vertex_id b = 0; b < t->r.n; b++)
                if (part[a] == mark && there(t, a, b) && part[b] != mark) {
                    part[b] = mark;
                    more = true;
                }
    }
}

/* Do all vertices that hang together with a, but for p, lie left of the line from a to
 * b, or on it? */
static bool
all_left(const trial *t, vertex_id a, vertex_id b, vertex_id p)
{
    char part[REPLAY_POINTS] = {0};
    mark_part(t, a, part, 1);
    for (vertex_id v = 0; v < t->r.n; v++)
        if (part[v] && v != p && turn(t, a, b, v) < 0)
            return false;
    return true;
}

/* Does p see the hull edge uv? It lies alone on one side of it, and is not joined to it
 * yet. */
static bool
sees(const trial *t, vertex_id p, vertex_id u, vertex_id v)
{
    if (!there(t, u, v) || (there(t, p, u) && there(t, p, v)))
        return false;
    return (turn(t, u, v, p) < 0 && all_left(t, u, v, p)) ||
           (turn(t, v, u, p) < 0 && all_left(t, v, u, p));
}

static bool
on_hull(const trial *t, vertex_id a, vertex_id b)
{
    return all_left(t, a, b, NONE) || all_left(t, b, a, NONE);
}

/* On one line with a and b, strictly between them? */
static bool
between(const trial *t, vertex_id a, vertex_id b, vertex_id p)
{
    const point2 d = {1, 0};
    const point2 *q = t->points;
    return turn(t, a, b, p) == 0 &&
           compare_along(d, q[a], q[p]) * compare_along(d, q[p], q[b]) > 0;
}

static void
claim(const trial *t, const sentence *s, bool holds)
{
    CLAIM("trace.says", holds, "step %u: %s", t->r.next, s->text);
}

/* ---- The lists of the step. ---- */

static bool
has_edge(const trial *t, const char *name, vertex_id a, vertex_id b)
{
    vertex_id low = a < b ? a : b, high = a < b ? b : a;
    for (uint32_t i = 0; i < step_count(t->step, name); i++)
        if (step_id(&t->r, t->step, name, i, 0) == low &&
            step_id(&t->r, t->step, name, i, 1) == high)
            return true;
    return false;
}

/* Are these numbers the edges of the list, and no others, in this order? A sentence
 * names six at most. */
static bool
are_edges(const trial *t, const sentence *s, uint32_t from, const char *name)
{
    uint32_t count = step_count(t->step, name);
    uint32_t named = count <= 6 ? count : 5;
    for (uint32_t i = 0; i < named; i++)
        for (uint32_t k = 0; k < 2; k++)
            if (from + 2 * i + k >= s->count ||
                step_id(&t->r, t->step, name, i, k) != s->id[from + 2 * i + k])
                return false;
    return true;
}

/* Is the point p shown, and the circle through a, b, c? */
static bool
shows(const trial *t, const vertex_id abc[3], vertex_id p)
{
    for (uint32_t i = 0; i < 3; i++)
        if (step_point(&t->r, t->step, "circle", i) != abc[i])
            return false;
    return step_point(&t->r, t->step, "point", 0) == p;
}

/* id[0] lies inside the circle of id[1], id[2], id[3]; or on it, or outside, as the
 * word says that stands before "the circle of". */
static bool
is_circle_right(const trial *t, const sentence *s, const vertex_id id[4])
{
    const point2 *q = t->points;
    int ccw = turn(t, id[1], id[2], id[3]);
    int sign = ccw * incircle(q[id[1]], q[id[2]], q[id[3]], q[id[0]]);
    const char *word = sign > 0 ? " lies inside the circle of "
                     : sign < 0 ? " lies outside the circle of "
                                : " lies on the circle of ";
    return strstr(s->words, word) != NULL && shows(t, id + 1, id[0]);
}

/* ---- 2.3 ---- */

/* The list `edges` has all hull edges that p sees, and no other. */
static bool
are_those_seen(const trial *t, vertex_id p, vertex_id neighbour)
{
    char part[REPLAY_POINTS] = {0};
    mark_part(t, neighbour, part, 1);
    for (vertex_id a = 0; a < t->r.n; a++)
        for (vertex_id b = a + 1; b < t->r.n; b++)
            if (part[a] && there(t, a, b) &&
                sees(t, p, a, b) != has_edge(t, "edges", a, b))
                return false;
    return true;
}

/* The rest of the sentence, whose numbers begin at `from`, tells what p sees. */
static void
check_seen(const trial *t, const sentence *s, uint32_t from, vertex_id p,
           vertex_id neighbour)
{
    static const char none[] = "no hull edge, as all points so far are in line with it";
    const char *rest = strstr(s->words, "it sees ");
    uint32_t count = step_count(t->step, "edges");
    claim(t, s, rest != NULL && are_those_seen(t, p, neighbour));
    rest += strlen("it sees ");
    if (count == 0)
        claim(t, s, strcmp(rest, none) == 0);
    else
        claim(t, s, are_edges(t, s, from, "edges") &&
              strncmp(rest, "the hull edge", 13) == 0 &&
              (rest[13] == 's') == (count > 1));
    for (vertex_id v = 0; v < t->r.n && count == 0; v++)
        claim(t, s, !there(t, neighbour, v) || turn(t, neighbour, v, p) == 0);
}

static bool
check_start_and_attach(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    const replay *r = &t->r;
    if (is(s, "begin with # and #: the edge #-#")) {
        claim(t, s, !t->merging && has_edge(t, "add", id[0], id[1]) &&
              has_edge(t, "add", id[2], id[3]) && step_count(t->step, "add") == 1 &&
              !r->is_vertex[id[0]] && !r->is_vertex[id[1]]);
    } else if (begins(s, "# comes: it sees ")) {
        vertex_id some = 0;
        while (!r->is_vertex[some])
            some++;
        claim(t, s, step_point(r, t->step, "point", 0) == id[0] &&
              !r->is_vertex[id[0]]);
        check_seen(t, s, 1, id[0], some);
    } else if (begins(s, "join # to ") && strstr(s->words, "it sees ") != NULL) {
        uint32_t added = step_count(t->step, "add"), named = added <= 6 ? added : 5;
        for (uint32_t i = 0; i < named; i++)
            claim(t, s, has_edge(t, "add", id[0], id[1 + i]));
        check_seen(t, s, 1 + named + (added > 6), id[0], id[1]);
    } else {
        return false;
    }
    return true;
}

/* ---- 3.5 and 3.6: the stack ---- */

/* The question that the last step has asked is answered. */
static bool
is_answer(const trial *t, const vertex_id *id, uint32_t count, const char *words)
{
    return strcmp(t->asked_words, words) == 0 &&
           memcmp(t->asked, id, count * sizeof *id) == 0;
}

static const char asks_circle[] =
    "pop #-#: does # lie inside the circle of #, #, #?";
static const char asks_hull[] = "pop #-#: is it on the hull?";
static const char asks_ray[] = "pop the ray from #: does # see the hull edge #-#?";

static bool
check_pop_and_keep(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    if (begins(s, "pop ")) {
        memcpy(t->asked, id, sizeof t->asked);
        strcpy(t->asked_words, s->words);
        if (is(s, asks_ray))
            claim(t, s, step_count(t->step, "pop") == 0 && there(t, id[2], id[3]) &&
                  (id[0] == id[2] || id[0] == id[3]) && there(t, id[0], id[1]));
        else
            claim(t, s, has_edge(t, "pop", id[0], id[1]) && (is(s, asks_hull) ||
                  (is(s, asks_circle) && shows(t, id + 3, id[2]) &&
                   there(t, id[0], id[2]) && there(t, id[1], id[2]))));
    } else if (is(s, "#-# stays: it is on the hull")) {
        claim(t, s, is_answer(t, id, 2, asks_hull) && on_hull(t, id[0], id[1]));
    } else if (begins(s, "#-# stays: # lies ")) {
        claim(t, s, is_answer(t, id, 6, asks_circle) &&
              strstr(s->words, "inside") == NULL && is_circle_right(t, s, id + 2));
    } else if (is(s, "the ray from # stays: # does not see #-#")) {
        claim(t, s, is_answer(t, id, 4, asks_ray) && !sees(t, id[1], id[2], id[3]));
    } else {
        return false;
    }
    return true;
}

static bool
check_flip(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    if (begins(s, "flip #-# to #-#: # lies inside the circle of #, #, #")) {
        /* The words are the question's, but for the new edge in their midst. */
        const vertex_id question[6] = {id[0], id[1], id[4], id[5], id[6], id[7]};
        claim(t, s, is_answer(t, question, 6, asks_circle) &&
              has_edge(t, "remove", id[0], id[1]) && has_edge(t, "add", id[2], id[3]) &&
              (id[4] == id[2] || id[4] == id[3]) && is_circle_right(t, s, id + 4));
        uint32_t turned = step_count(t->step, "turned");
        claim(t, s, turned == 0 ? s->count == 8 : s->count == 9 && id[8] == turned);
    } else if (is(s, "flip the ray from # to #-#: # sees #-#")) {
        const vertex_id question[4] = {id[0], id[3], id[4], id[5]};
        claim(t, s, is_answer(t, question, 4, asks_ray) &&
              step_count(t->step, "remove") == 0 && has_edge(t, "add", id[1], id[2]) &&
              sees(t, id[3], id[4], id[5]));
    } else {
        return false;
    }
    return true;
}

static bool
check_push(trial *t, const sentence *s)
{
    if (!begins(s, "push "))
        return false;
    uint32_t count = step_count(t->step, "push");
    claim(t, s, are_edges(t, s, 0, "push"));
    uint32_t rays = s->count - (count <= 6 ? 2 * count : 11);
    claim(t, s, (rays > 0) == (strstr(s->words, "to infinity from #") != NULL));
    for (uint32_t i = 0; i < rays; i++)
        claim(t, s, s->id[s->count - 1 - i] < t->r.n &&
              t->r.is_vertex[s->id[s->count - 1 - i]]);
    return true;
}

/* ---- 3.6: places ---- */

static bool
is_triangle(const trial *t, const vertex_id abc[3])
{
    return there(t, abc[0], abc[1]) && there(t, abc[1], abc[2]) &&
           there(t, abc[2], abc[0]) && turn(t, abc[0], abc[1], abc[2]) > 0;
}

static bool
is_beyond(const trial *t, vertex_id end, vertex_id p)
{
    for (vertex_id v = 0; v < t->r.n; v++)
        if (t->r.is_vertex[v] && v != end && !between(t, v, p, end))
            return false;
    return t->r.is_vertex[end];
}

static bool
check_place(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    vertex_id p = id[0];
    if (begins(s, "# lies in the triangle #, #, #")) {
        claim(t, s, is_triangle(t, id + 1));
        for (int i = 0; i < 3; i++)
            claim(t, s, turn(t, id[1 + i], id[1 + (i + 1) % 3], p) > 0);
    } else if (begins(s, "# lies on the edge #-#")) {
        claim(t, s, there(t, id[1], id[2]) && between(t, id[1], id[2], p));
    } else if (begins(s, "# lies outside of the hull: it sees #-#")) {
        claim(t, s, sees(t, p, id[1], id[2]) && has_edge(t, "edges", id[1], id[2]));
    } else if (begins(s, "# lies in line with all points so far, beyond #")) {
        claim(t, s, is_beyond(t, id[1], p));
    } else {
        return false;
    }
    claim(t, s, !t->r.is_vertex[p] && step_point(&t->r, t->step, "point", 0) == p);
    return true;
}

static bool
check_walk(trial *t, const sentence *s)
{
    if (!begins(s, "the walk to # "))
        return false;
    const vertex_id *id = s->id;
    claim(t, s, step_point(&t->r, t->step, "point", 0) == id[0]);
    if (is(s, "the walk to # begins in the triangle #, #, #") ||
        is(s, "the walk to # comes to the triangle #, #, #"))
        claim(t, s, is_triangle(t, id + 1));
    else
        claim(t, s, on_hull(t, id[1], id[2]) && there(t, id[1], id[2]) &&
              (is(s, "the walk to # begins at the edge #-#") ||
               is(s, "the walk to # leaves the hull through #-#")));
    return true;
}

static bool
check_split(trial *t, const sentence *s)
{
    if (!begins(s, "join # to ") || strstr(s->words, "it sees ") != NULL)
        return false;
    const vertex_id *id = s->id;
    uint32_t added = step_count(t->step, "add");
    bool divides = strstr(s->words, "; it divides #-#") != NULL;
    claim(t, s, added <= 4 && s->count == 1 + added + 2 * divides &&
          divides == (step_count(t->step, "remove") == 1));
    for (uint32_t i = 0; i < added; i++)
        claim(t, s, has_edge(t, "add", id[0], id[1 + i]));
    if (divides)
        claim(t, s, has_edge(t, "remove", id[1 + added], id[2 + added]) &&
              between(t, id[1 + added], id[2 + added], id[0]));
    return true;
}

/* Points on the sides of a triangle may wait in it. */
static bool
check_moves(trial *t, const sentence *s)
{
    if (strstr(s->words, " now wait") == NULL)
        return false;
    const json *step = t->step;
    bool moved[REPLAY_POINTS] = {false};
    for (uint32_t i = 0; i < step_count(step, "moves"); i++) {
        vertex_id id[4];
        for (uint32_t k = 0; k < 4; k++)
            id[k] = step_id(&t->r, step, "moves", i, k);
        claim(t, s, id[2] < t->r.n && !t->r.is_vertex[id[0]] && !moved[id[0]] &&
              there(t, id[1], id[2]));
        moved[id[0]] = true;
        if (id[3] == NONE)
            claim(t, s, turn(t, id[1], id[2], id[0]) <= 0);
        for (int k = 0; k < 3 && id[3] != NONE; k++)
            claim(t, s, is_triangle(t, id + 1) &&
                  turn(t, id[1 + k], id[1 + (k + 1) % 3], id[0]) >= 0);
    }
    claim(t, s, s->id[0] < t->r.n && moved[s->id[0]]);
    return true;
}

/* ---- 3.7 ---- */

static bool
check_tangents(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    if (is(s, "#-# is the lower tangent: no point of the two parts lies right of the "
              "line from # to #")) {
        memset(t->part, 0, sizeof t->part);
        claim(t, s, !t->merging);
        t->merging = true;
        t->l = id[2];
        t->r_end = id[3];
        mark_part(t, t->l, t->part, 'l');
        claim(t, s, t->part[t->r_end] == 0);
        mark_part(t, t->r_end, t->part, 'r');
        for (vertex_id v = 0; v < t->r.n; v++)
            claim(t, s, t->part[v] == 0 || turn(t, t->l, t->r_end, v) >= 0);
    } else if (is(s, "#-# is the upper tangent: no point of the two parts lies left of "
                     "the line from # to #")) {
        claim(t, s, t->merging && id[2] == t->l && id[3] == t->r_end &&
              there(t, t->l, t->r_end));
        t->merging = false;
        for (vertex_id v = 0; v < t->r.n; v++)
            claim(t, s, t->part[v] == 0 || turn(t, t->l, t->r_end, v) <= 0);
    } else if (is(s, "join # and # by the lower tangent")) {
        claim(t, s, id[0] == t->l && id[1] == t->r_end &&
              has_edge(t, "add", id[0], id[1]));
    } else {
        return false;
    }
    return true;
}

static bool
check_merge(trial *t, const sentence *s)
{
    const vertex_id *id = s->id;
    if (begins(s, "#-# goes: # lies inside the circle of #, #, #")) {
        const char *line = step_text(t->step, "line");
        bool left = t->part[id[0]] == 'l';
        claim(t, s, is_circle_right(t, s, id + 2) &&
              has_edge(t, "remove", id[0], id[1]) &&
              id[2] == (left ? t->r_end : t->l) &&
              strcmp(line, left ? "Step 3" : "Step 4") == 0);
        return true;
    }
    if (!begins(s, "join #-#: # "))
        return false;
    bool on_right = id[0] == t->l || id[1] == t->l;
    vertex_id stays = on_right ? t->l : t->r_end, old = on_right ? t->r_end : t->l;
    vertex_id winner = id[0] == stays ? id[1] : id[0];
    claim(t, s, (id[0] == stays || id[1] == stays) &&
          has_edge(t, "add", id[0], id[1]) &&
          t->part[winner] == t->part[old] && turn(t, t->l, t->r_end, winner) > 0);
    if (is(s, "join #-#: # is the only candidate, as # sees no hull edge at #")) {
        claim(t, s, id[2] == winner && id[3] == old && id[4] == stays);
        for (vertex_id v = 0; v < t->r.n; v++)
            claim(t, s, !there(t, stays, v) || t->part[v] != t->part[stays] ||
                  turn(t, t->l, t->r_end, v) <= 0);
    } else {
        claim(t, s, strstr(s->words, "inside") == NULL &&
              is_circle_right(t, s, id + 2) &&
              id[3] == t->l && id[4] == t->r_end && id[5] == winner &&
              t->part[id[2]] == t->part[stays] && there(t, stays, id[2]));
    }
    t->l = on_right ? t->l : winner;
    t->r_end = on_right ? winner : t->r_end;
    return true;
}

/* ---- All sentences of all algorithms. ---- */

/* After each question comes its answer, and nothing else. */
static void
check_order(const trial *t, const char *before)
{
    const char *event = t->step != NULL ? step_text(t->step, "event") : "the end";
    bool answer = strcmp(event, "keep") == 0 || strcmp(event, "flip") == 0;
    CLAIM("trace.says", strcmp(before, "pop") != 0 || answer,
          "step %u: after pop comes %s", t->r.next, event);
}

static void
sentences_say_what_is_so(const point2 *points, uint32_t n)
{
    static bool (*const checks[])(trial *, const sentence *) = {
        check_start_and_attach, check_pop_and_keep, check_flip, check_push, check_place,
        check_walk, check_split, check_moves, check_tangents, check_merge};
    for (uint32_t i = 0; i < contents_count; i++) {
        if (contents[i].steps == NULL)
            continue;
        static trial t; /* too large for some stacks */
        watched_run run = random_run(&contents[i]);
        t = (trial){.points = points};
        replay_begin(&t.r, &run, points, n);
        const char *before = "";
        while ((t.step = replay_peek(&t.r)) != NULL) {
            check_order(&t, before);
            before = step_text(t.step, "event");
            sentence s = take_apart(step_text(t.step, "say"));
            bool known = false;
            for (size_t k = 0; k < sizeof checks / sizeof checks[0] && !known; k++)
                known = checks[k](&t, &s);
            CLAIM("trace.says", known, "nobody knows the sentence: %s", s.text);
            replay_step(&t.r);
        }
        check_order(&t, before);
        CLAIM("trace.says", !t.merging, "a merge does not end at the upper tangent");
        replay_free(&t.r);
    }
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "tri trace: what the sentences say is so");
    test_random("sentences about random points", sentences_say_what_is_so, 100, 25);
    test_near_degenerate("sentences about nearly degenerate points",
                         sentences_say_what_is_so, 150, 15);
    int status = test_end((test_minima){.trials = 250, .largest_n = 20, .zeros = 1000});
    shell_end();
    return status;
}
