/* session.c - one trial: the case, the answer, and what must hold. */
#include "tools/checks/session.h"
#include "tools/checks/room.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The case. ---- */

static void
forget_tickets(session *s)
{
    free(s->owner);
    free(s->ticket);
    s->owner = s->ticket = NULL;
}

/* The tickets 0 .. n-1 are dealt at random. */
static void
deal_tickets(session *s, uint32_t n)
{
    forget_tickets(s);
    s->owner = room_for(n, sizeof *s->owner);
    s->ticket = room_for(n, sizeof *s->ticket);
    for (uint32_t i = 0; i < n; i++)
        s->owner[i] = i;
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_below(&s->random, i), chosen = s->owner[j];
        s->owner[j] = s->owner[i - 1];
        s->owner[i - 1] = chosen;
    }
    for (uint32_t i = 0; i < n; i++)
        s->ticket[s->owner[i]] = i;
}

void
begin_case(session *s, char exercise, const site *points, uint32_t n)
{
    words_clear(&s->given);
    words_put(&s->given, (uint64_t)exercise);
    s->about = (questions){.at = points, .n = n};
    s->faces = 0;
    if (s->opaque) {
        deal_tickets(s, n);
        s->about.owner = s->owner;
    }
}

void
give_points(session *s)
{
    give_number(s, s->about.n);
    for (uint32_t i = 0; i < s->about.n; i++) {
        site p = s->about.at[i];
        give_real(s, s->opaque ? (double)s->ticket[i] : p.x);
        give_real(s, s->opaque ? 0 : p.y);
    }
}

void
give_number(session *s, uint64_t number)
{
    words_put(&s->given, number);
}

void
give_real(session *s, double x)
{
    words_put_real(&s->given, x);
}

void
give_numbers(session *s, const uint32_t *number, uint32_t count)
{
    give_number(s, count);
    for (uint32_t i = 0; i < count; i++)
        give_number(s, number[i]);
}

void
give_triangles(session *s, triangle_list list)
{
    give_number(s, list.count);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        give_number(s, list.corner[i / 3][i % 3]);
    if (list.count == 0)
        give_number(s, 0); /* a path of no vertices */
}

void
give_path(session *s, const uint32_t *path, uint32_t count)
{
    give_number(s, 0); /* no triangles */
    give_numbers(s, path, count);
}

bool
ask(session *s)
{
    if (s->failed)
        return false;
    s->next = 0;
    s->end = program_ask(&s->student, &s->given, &s->about, s->seconds, &s->answer);
    return expect(s, s->end == FATE_ANSWERED, "%s", fate_text(s->end));
}

uint64_t
asked(const session *s, wire_kind kind)
{
    return s->about.asked[kind];
}

uint64_t
asked_in_all(const session *s)
{
    uint64_t all = 0;
    for (int kind = 0; kind < WIRE_KINDS; kind++)
        all += s->about.asked[kind];
    return all;
}

void
choose(session *s, const uint32_t *chosen, uint32_t count)
{
    s->about.chosen = chosen;
    s->about.choices = count;
}

const questions *
questions_of(const session *s)
{
    return &s->about;
}

random_source *
trial_random(session *s)
{
    return &s->random;
}

const char *
variant_of(const session *s)
{
    return s->variant;
}

const char *
instances_of(const session *s)
{
    return s->instances;
}

/* ---- The answer. ---- */

/* The next word; when there is none the trial fails, and the word is 0. */
static uint64_t
take_word(session *s, const char *what)
{
    if (!expect(s, s->next < s->answer.count, "the answer ends before %s", what))
        return 0;
    return s->failed ? 0 : s->answer.word[s->next++];
}

uint32_t
take_number(session *s, uint32_t low, uint32_t high, const char *what)
{
    uint64_t word = take_word(s, what);
    if (s->failed)
        return low;
    if (!expect(s, low <= word && word <= high,
                "%s is %lld%s, and must be between %lu and %lu", what, (long long)word,
                word == NONE ? " (NONE)" : "", (unsigned long)low, (unsigned long)high))
        return low;
    return (uint32_t)word;
}

bool
take_ok(session *s)
{
    uint32_t status = take_number(s, 0, 100, "the status");
    return expect(s, status == TRI_OK, "the function returned the status \"%s\"",
                  tri_status_text((tri_status)status));
}

int
take_sign(session *s, const char *what)
{
    int64_t word = (int64_t)take_word(s, what);
    if (!expect(s, -1 <= word && word <= 1, "%s is %lld, and must be -1, 0 or +1", what,
                (long long)word))
        return 0;
    return (int)word;
}

double
take_real(session *s, const char *what)
{
    double x = real_of_word(take_word(s, what));
    return expect(s, isfinite(x), "%s is not a finite number", what) ? x : 0;
}

triangle_list
take_triangles(session *s, uint32_t n, uint32_t most)
{
    triangle_list list = {0};
    uint32_t count = take_number(s, 0, most, "the number of triangles");
    list.corner = room_for(count, sizeof *list.corner);
    for (uint32_t i = 0; i < 3 * count; i++)
        list.corner[i / 3][i % 3] =
            take_number(s, 0, n > 0 ? n - 1 : 0, "a corner of a triangle");
    if (s->failed) {
        triangle_list_free(&list);
        return list;
    }
    list.count = count;
    keep_triangles(s, list);
    return list;
}

/* Edges that pass over no location and begin, seen from the left, at different ones: if
 * they are as many as neighbours, they are those between neighbours. */
void
take_path(session *s)
{
    static const site rightwards = {1, 0};
    const site *p = s->about.at;
    uint32_t n = s->about.n;
    uint32_t *begins = room_for(n, sizeof *begins); /* location -> edges */
    uint32_t locations = cases_locations(p, n, begins);
    memset(begins, 0, n * sizeof *begins);
    uint32_t edges = take_number(s, 0, 3 * n, "the number of edges");
    expect(s, edges + 1 == locations || (locations < 2 && edges == 0),
           "%lu edges on a line with %lu locations", (unsigned long)edges,
           (unsigned long)locations);
    for (uint32_t i = 0; i < edges && !s->failed; i++) {
        uint32_t a = take_number(s, 0, n - 1, "the end of an edge");
        uint32_t b = take_number(s, 0, n - 1, "the end of an edge");
        for (uint32_t k = 0; k < n && !s->failed; k++)
            expect(s, plane_dot(p[a], p[k], p[b]) >= 0 && !plane_same(p[a], p[b]),
                   "the edge %lu-%lu passes over %lu", (unsigned long)a,
                   (unsigned long)b, (unsigned long)k);
        uint32_t left = plane_along(rightwards, p[a], p[b]) < 0 ? a : b, at = 0;
        while (!plane_same(p[at], p[left]))
            at++;
        expect(s, begins[at]++ == 0,
               "the edge %lu-%lu is there twice", (unsigned long)a, (unsigned long)b);
    }
    free(begins);
}

void
take_end(session *s)
{
    expect(s, s->next == s->answer.count, "the answer goes on after its end");
}

/* ---- What must hold. ---- */

bool
expect(session *s, bool holds, const char *seen, ...)
{
    if (holds || s->failed)
        return holds && !s->failed;
    s->failed = true;
    va_list values;
    va_start(values, seen);
    vsnprintf(s->seen, sizeof s->seen, seen, values);
    va_end(values);
    return false;
}

bool
expect_verdict(session *s, verdict v)
{
    if (expect(s, v.holds, "%s", v.because))
        return true;
    if (s->witness.witnesses == 0)
        for (int i = 0; i < v.witnesses; i++)
            show_witness(s, v.witness[i]);
    return false;
}

bool
failed(const session *s)
{
    return s->failed;
}

void
keep_triangles(session *s, triangle_list list)
{
    assert(s->lists < SESSION_LISTS);
    s->kept[s->lists++] = list;
}

void
show_witness(session *s, uint32_t point)
{
    s->witness = verdict_with(s->witness, point);
}

void
show_face(session *s, svg_style style, const uint32_t *vertex, uint32_t count)
{
    shown_face f = {.style = style, .count = count};
    if (s->faces == SESSION_FACES)
        return;
    for (uint32_t i = 0; i < count; i++) {
        if (vertex[i] >= s->about.n)
            return;
        f.vertex[i] = vertex[i];
    }
    s->face[s->faces++] = f;
}

void
show_edge(session *s, svg_style style, uint32_t a, uint32_t b)
{
    const uint32_t end[2] = {a, b};
    show_face(s, style, end, 2);
}

void
show_path(session *s, const uint32_t *path, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        show_edge(s, SVG_PLAIN, path[i - 1], path[i]);
}

/* ---- One trial. ---- */

static void
forget_lists(session *s)
{
    for (uint32_t i = 0; i < s->lists; i++)
        triangle_list_free(&s->kept[i]);
    s->lists = 0;
}

void
session_trial(session *s, const property *p, uint64_t seed, const site *points,
              uint32_t n)
{
    forget_lists(s);
    s->seed = seed;
    s->random = random_from_seed(seed);
    s->opaque = p->opaque;
    s->failed = false;
    s->end = FATE_ANSWERED;
    s->seen[0] = '\0';
    s->witness = verdict_refuted("%s", "");
    p->trial(s, points, n);
}

void
session_free(session *s)
{
    program_end(&s->student);
    forget_lists(s);
    forget_tickets(s);
    words_free(&s->given);
    words_free(&s->answer);
}
