/* replay.c - traces, read back and run again. */
#include "tests/harness/replay.h"

#include "lib/textio.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"
#include "tests/harness/start.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

watched_run
random_run(const algorithm *a)
{
    static const char *const cuts[] = {"vertical", "alternating"};
    static const char *const locators[] = {"walk", "buckets", "history", "grid"};
    random_source *random = test_random_source();
    watched_run run = {.algorithm = a, .options = tri_options_default()};
    tri_options *o = &run.options;
    o->direction = random_direction();
    o->cuts = (tri_cuts)random_below(random, 2);
    o->locator = (tri_locator)random_below(random, 4);
    o->seed = random_below(random, 1000);
    snprintf(run.words, sizeof run.words,
             "--algorithm %s --direction %.17g,%.17g --cuts %s --locator %s "
             "--seed %" PRIu64, a->name, o->direction.x, o->direction.y, cuts[o->cuts],
             locators[o->locator], o->seed);
    return run;
}

/* ---- Reading. ---- */

/* The whole file $d/trace.json; the caller frees it. */
static char *
read_file(size_t *length)
{
    FILE *file = fopen(in_scratch("trace.json").text, "rb");
    CLAIM("trace.setup", file != NULL, "there is no file");
    char *text = NULL;
    size_t room = 0, got;
    *length = 0;
    do {
        room = 2 * room + 65536;
        text = realloc(text, room);
        CLAIM("trace.setup", text != NULL, "memory is out");
        got = fread(text + *length, 1, room - *length, file);
        *length += got;
    } while (got > 0);
    fclose(file);
    return text;
}

void
replay_begin(replay *r, const watched_run *run, const point2 *points, uint32_t n)
{
    *r = (replay){.n = n};
    CLAIM("trace.setup", n <= REPLAY_POINTS, "%u points", n);
    FILE *file = fopen(in_scratch("points.node").text, "wb");
    CLAIM("trace.setup", file != NULL, "no file can be written");
    text_write_points(file, points, n, 1);
    fclose(file);
    int status = shell("$tri trace %s -o $d/trace.json $d/points.node 2>$d/err",
                       run->words);
    CLAIM("trace.status", status == 0, "tri trace %s: exit status %d: %s", run->words,
          status, read_scratch("err").text);

    size_t length, at;
    const char *wrong;
    r->text = read_file(&length);
    r->root = json_read(r->text, length, &wrong, &at);
    CLAIM("trace.json", r->root != NULL, "tri trace %s: byte %zu: %s", run->words, at,
          wrong);
    r->steps = json_member(r->root, "steps");
    CLAIM("trace.json", r->steps != NULL && r->steps->kind == JSON_ARRAY,
          "there are no steps");
}

void
replay_free(replay *r)
{
    json_free(r->root);
    free(r->text);
}

const json *
replay_peek(const replay *r)
{
    return r->next < r->steps->count ? &r->steps->item[r->next] : NULL;
}

const char *
step_text(const json *step, const char *name)
{
    const json *member = json_member(step, name);
    CLAIM("trace.json", member != NULL && member->kind == JSON_STRING,
          "%s is no string", name);
    return member->text;
}

uint32_t
step_count(const json *step, const char *name)
{
    const json *list = json_member(step, name);
    CLAIM("trace.json", list == NULL || list->kind == JSON_ARRAY, "%s is no list",
          name);
    return list == NULL ? 0 : (uint32_t)list->count;
}

static vertex_id
id_of(const replay *r, const json *value)
{
    CLAIM("trace.json", value->kind == JSON_NUMBER && value->number >= 0 &&
          value->number < r->n && value->number == (uint32_t)value->number,
          "%g is no point", value->number);
    return (vertex_id)value->number;
}

vertex_id
step_id(const replay *r, const json *step, const char *name, uint32_t i, uint32_t j)
{
    if (i >= step_count(step, name))
        return NONE;
    const json *item = &json_member(step, name)->item[i];
    CLAIM("trace.json", item->kind == JSON_ARRAY, "an item of %s is no list", name);
    return j < item->count ? id_of(r, &item->item[j]) : NONE;
}

vertex_id
step_point(const replay *r, const json *step, const char *name, uint32_t i)
{
    const json *value = json_member(step, name);
    if (value != NULL && value->kind == JSON_ARRAY)
        value = i < value->count ? &value->item[i] : NULL;
    return value != NULL ? id_of(r, value) : NONE;
}

/* ---- Running. ---- */

/* Edge i of the list. */
static void
edge_of(const replay *r, const json *step, const char *name, uint32_t i, vertex_id *a,
        vertex_id *b)
{
    *a = step_id(r, step, name, i, 0);
    *b = step_id(r, step, name, i, 1);
    CLAIM("trace.replay", *b != NONE && *a < *b && step_id(r, step, name, i, 2) == NONE,
          "step %u: an edge of %s does not have two ends, the lower first", r->next,
          name);
}

static void
change_edges(replay *r, const json *step, const char *name, bool there)
{
    CLAIM("trace.replay", json_member(step, name) != NULL, "step %u has no list %s",
          r->next, name);
    for (uint32_t i = 0; i < step_count(step, name); i++) {
        vertex_id a, b;
        edge_of(r, step, name, i, &a, &b);
        CLAIM("trace.replay", r->edge[a][b] != there, "step %u: %u-%u %s", r->next, a,
              b, there ? "is there already" : "is not there");
        CLAIM("trace.replay", r->is_vertex[a] && r->is_vertex[b],
              "step %u: an end of %u-%u is no vertex", r->next, a, b);
        r->edge[a][b] = r->edge[b][a] = there;
    }
}

static void
run_stack(replay *r, const json *step)
{
    vertex_id a, b;
    for (uint32_t i = 0; i < step_count(step, "pop"); i++) {
        edge_of(r, step, "pop", i, &a, &b);
        CLAIM("trace.stack", r->on_stack > 0, "step %u: the stack is empty", r->next);
        const vertex_id *top = r->stack[--r->on_stack];
        CLAIM("trace.stack", top[0] == a && top[1] == b,
              "step %u: the last edge on the stack is %u-%u, not %u-%u", r->next,
              top[0], top[1], a, b);
    }
    for (uint32_t i = 0; i < step_count(step, "turned"); i++) {
        const json *turned = &json_member(step, "turned")->item[i];
        CLAIM("trace.stack", turned->kind == JSON_ARRAY && turned->count == 3 &&
              turned->item[0].number < r->on_stack, "step %u: no entry turns", r->next);
        uint32_t entry = (uint32_t)turned->item[0].number;
        a = id_of(r, &turned->item[1]);
        b = id_of(r, &turned->item[2]);
        CLAIM("trace.stack", a < b, "step %u: entry %u turns to %u-%u", r->next, entry,
              a, b);
        r->stack[entry][0] = a;
        r->stack[entry][1] = b;
    }
    for (uint32_t k = 0; k < r->on_stack; k++)
        CLAIM("trace.stack", r->edge[r->stack[k][0]][r->stack[k][1]],
              "step %u: %u-%u is on the stack and not there", r->next, r->stack[k][0],
              r->stack[k][1]);
    for (uint32_t i = 0; i < step_count(step, "push"); i++) {
        edge_of(r, step, "push", i, &a, &b);
        CLAIM("trace.stack", r->edge[a][b], "step %u: %u-%u is pushed and not there",
              r->next, a, b);
        for (uint32_t k = 0; k < r->on_stack; k++)
            CLAIM("trace.stack", r->stack[k][0] != a || r->stack[k][1] != b,
                  "step %u: %u-%u is on the stack already", r->next, a, b);
        r->stack[r->on_stack][0] = a;
        r->stack[r->on_stack++][1] = b;
    }
}

void
replay_step(replay *r)
{
    const json *step = replay_peek(r);
    for (uint32_t i = 0; i < step_count(step, "insert"); i++) {
        vertex_id p = step_point(r, step, "insert", i);
        CLAIM("trace.replay", !r->is_vertex[p], "step %u: %u is a vertex already",
              r->next, p);
        r->is_vertex[p] = true;
    }
    change_edges(r, step, "remove", false);
    change_edges(r, step, "add", true);
    run_stack(r, step);
    r->next++;
}
