/* step.c - a step of a trace: lists, sentences, JSON. */
#include "tools/tri/step.h"

#include "lib/memory.h"
#include "tools/tri/tri.h"

#include <assert.h>
#include <stdarg.h>

/* ---- Lists. ---- */

void
id_list_add(id_list *list, vertex_id v)
{
    if (list->count == list->room) {
        uint32_t room = 2 * list->room + 8;
        vertex_id *id = memory_resize(list->id, room, sizeof *id);
        if (id == NULL)
            must(TRI_OUT_OF_MEMORY);
        list->id = id;
        list->room = room;
    }
    list->id[list->count++] = v;
}

void
id_list_add_edge(id_list *list, vertex_id a, vertex_id b)
{
    id_list_add(list, a < b ? a : b);
    id_list_add(list, a < b ? b : a);
}

void
id_list_free(id_list *list)
{
    memory_free(list->id);
    *list = (id_list){0};
}

void
step_free(step *s)
{
    for (int f = 0; f < STEP_FIELDS; f++)
        id_list_free(&s->field[f]);
}

/* ---- Sentences. ---- */

void
say(step *s, const char *words, ...)
{
    va_list arguments;
    va_start(arguments, words);
    int length =
        vsnprintf(s->says + s->length, STEP_SAYS - s->length, words, arguments);
    va_end(arguments);
    s->length += (size_t)length;
    assert(s->length < STEP_SAYS);
}

void
say_point(step *s, vertex_id p)
{
    say(s, "%lu", (unsigned long)p);
}

void
say_edge(step *s, vertex_id a, vertex_id b)
{
    const vertex_id ends[3] = {a < b ? a : b, a < b ? b : a, NONE};
    say_corners(s, ends);
}

void
say_corners(step *s, const vertex_id corner[3])
{
    unsigned long a = corner[0], b = corner[1], c = corner[2];
    if (corner[2] == NONE)
        say(s, "%lu-%lu", a, b);
    else
        say(s, "%lu, %lu, %lu", a, b, c);
}

void
say_list(step *s, const id_list *list, uint32_t size)
{
    const uint32_t most = 6;
    uint32_t count = list->count / size;
    uint32_t shown = count <= most ? count : most - 1;
    for (uint32_t i = 0; i < shown; i++) {
        const vertex_id *id = list->id + size * i;
        say(s, "%s", i == 0 ? "" : i + 1 == count ? " and " : ", ");
        if (size == 1)
            say_point(s, id[0]);
        else
            say_edge(s, id[0], id[1]);
    }
    if (shown < count)
        say(s, " and %lu more", (unsigned long)(count - shown));
}

void
say_count(step *s, uint32_t count, const char *thing)
{
    say(s, "%lu %s%s", (unsigned long)count, thing, count == 1 ? "" : "s");
}

/* ---- JSON. ---- */

static const char *const event_name[STEP_KINDS] = {
    [STEP_START] = "start",     [STEP_SEE] = "locate",     [STEP_ATTACH] = "attach",
    [STEP_PUSH] = "push",       [STEP_POP] = "pop",        [STEP_KEEP] = "keep",
    [STEP_FLIP] = "flip",       [STEP_PUSH_LINK] = "push", [STEP_VISIT] = "visit",
    [STEP_LOCATE] = "locate",   [STEP_SPLIT] = "split",    [STEP_MOVE] = "move",
    [STEP_TANGENT] = "locate",  [STEP_BRIDGE] = "bridge",  [STEP_DROP_LEFT] = "flip",
    [STEP_DROP_RIGHT] = "flip", [STEP_RISE] = "flip",      [STEP_TOP] = "keep",
};

/* A field is written as a list of groups of so many points (NONE is left out); as a
 * list of points if that is 1; as a point if it is 0. */
static const struct {
    const char *name;
    uint32_t group;
} form[STEP_FIELDS] = {
    [REMOVE] = {"remove", 2}, [ADD] = {"add", 2},       [PUSH] = {"push", 2},
    [POP] = {"pop", 2},       [TURNED] = {"turned", 3}, [INSERT] = {"insert", 1},
    [EDGES] = {"edges", 2},   [CIRCLE] = {"circle", 1}, [TRIANGLE] = {"triangle", 1},
    [POINT] = {"point", 0},   [VISITS] = {"visits", 3}, [MOVES] = {"moves", 4},
};

static void
write_points(FILE *file, const vertex_id *id, uint32_t count)
{
    for (uint32_t i = 0; i < count && id[i] != NONE; i++)
        fprintf(file, "%s%lu", i > 0 ? "," : "", (unsigned long)id[i]);
}

static void
write_field(FILE *file, const char *name, uint32_t group, const id_list *list)
{
    fprintf(file, ", \"%s\": %s", name, group > 0 ? "[" : "");
    if (group < 2)
        write_points(file, list->id, list->count);
    for (uint32_t i = 0; group >= 2 && i < list->count; i += group) {
        fputs(i > 0 ? ",[" : "[", file);
        write_points(file, list->id + i, group);
        fputc(']', file);
    }
    fputs(group > 0 ? "]" : "", file);
}

static void
write_step(step *s, step_kind kind)
{
    const char *label = s->figure->label[kind];
    fprintf(s->file, "%s\n  {\"event\": \"%s\", \"line\": \"%s\",\n   \"say\": \"%s\"",
            s->written > 0 ? "," : "", event_name[kind], label != NULL ? label : "",
            s->says);
    for (int f = 0; f < STEP_FIELDS; f++)
        if (s->field[f].count > 0 || f == REMOVE || f == ADD)
            write_field(s->file, form[f].name, form[f].group, &s->field[f]);
    fputc('}', s->file);
    s->written++;
}

void
step_end(step *s, step_kind kind)
{
    bool extra = kind == STEP_SEE || kind == STEP_TANGENT || kind == STEP_TOP;
    if (!extra || s->figure->label[kind] != NULL)
        write_step(s, kind);
    for (int f = 0; f < STEP_FIELDS; f++)
        s->field[f].count = 0;
    s->says[0] = '\0';
    s->length = 0;
}
