/* driver.c - case after case, until the checker has no more. */
#include "tools/checks/student/driver.h"

#include "lib/mesh_build.h"

#include <stdio.h>
#include <stdlib.h>

/* The program has one case and one answer at a time. */
static struct {
    words given;
    size_t next;
    words answer;
} now;

static _Noreturn void
give_up(const char *because)
{
    fprintf(stderr, "driver: %s\n", because);
    exit(3);
}

static uint64_t
case_word(void)
{
    if (now.next >= now.given.count)
        give_up("the case is shorter than expected");
    return now.given.word[now.next++];
}

uint32_t
case_number(void)
{
    return (uint32_t)case_word();
}

double
case_real(void)
{
    return real_of_word(case_word());
}

point2
case_point(void)
{
    double x = case_real(), y = case_real();
    return (point2){x, y};
}

static void *
room_for(size_t count, size_t size)
{
    void *room = calloc(count + 1, size);
    if (room == NULL)
        give_up("out of memory");
    return room;
}

point2 *
case_points(uint32_t *n)
{
    *n = case_number();
    point2 *points = room_for(*n, sizeof *points);
    for (uint32_t i = 0; i < *n; i++)
        points[i] = case_point();
    return points;
}

uint32_t *
case_numbers(uint32_t *n)
{
    *n = case_number();
    uint32_t *number = room_for(*n, sizeof *number);
    for (uint32_t i = 0; i < *n; i++)
        number[i] = case_number();
    return number;
}

uint32_t
case_mesh(uint32_t n, mesh *m)
{
    triangle_list list = {.count = case_number()};
    list.corner = room_for(list.count, sizeof *list.corner);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        list.corner[i / 3][i % 3] = case_number();

    tri_status status;
    if (list.count > 0) {
        status = mesh_from_triangles(n, list, m);
    } else {
        uint32_t length;
        vertex_id *path = case_numbers(&length);
        status = mesh_from_path(n, path, length, m);
        free(path);
    }
    free(list.corner);
    if (status != TRI_OK)
        give_up(tri_status_text(status));
    return 3 * list.count;
}

void
append_mesh(mesh *m, const mesh *part)
{
    halfedge_id first = mesh_halfedges(m);
    for (halfedge_id e = 0; e < mesh_halfedges(part); e += 3)
        mesh_add_triangle(m, mesh_origin(part, e), mesh_dest(part, e),
                          mesh_apex(part, e));
    for (halfedge_id e = 0; e < mesh_halfedges(part); e++)
        mesh_link(m, first + e, first + mesh_twin(part, e));
}

void
answer_number(uint64_t number)
{
    words_put(&now.answer, number);
}

void
answer_sign(int sign)
{
    words_put(&now.answer, (uint64_t)(int64_t)sign);
}

void
answer_real(double x)
{
    words_put_real(&now.answer, x);
}

void
answer_mesh(const mesh *m)
{
    triangle_list list;
    tri_status status = mesh_triangles(m, &list);
    if (status != TRI_OK)
        give_up(tri_status_text(status));
    answer_number(list.count);
    for (uint32_t i = 0; i < 3 * list.count; i++)
        answer_number(list.corner[i / 3][i % 3]);
    triangle_list_free(&list);
}

void
answer_edges(const mesh *m)
{
    size_t count = now.answer.count;
    answer_number(0); /* for now */
    for (halfedge_id e = 0; e < mesh_halfedges(m); e++) {
        vertex_id a = mesh_origin(m, e), b = mesh_dest(m, e);
        if (e > mesh_twin(m, e) || a == GHOST || b == GHOST)
            continue;
        answer_number(a);
        answer_number(b);
        now.answer.word[count]++;
    }
}

/* What TODO("2.3-b") in a handout calls. */
_Noreturn void exercise_todo(const char *id);

_Noreturn void
exercise_todo(const char *id)
{
    (void)id;
    wire_write(WIRE_TO_CHECKER, WIRE_TODO, NULL, 0);
    _Exit(0);
}

/* What the predicates of opaque mode call: a question to the checker. */
int64_t driver_ask(wire_kind kind, const uint64_t *word, size_t count);

int64_t
driver_ask(wire_kind kind, const uint64_t *word, size_t count)
{
    uint64_t reply[3]; /* SIGN, 1, the sign */
    if (!wire_write(WIRE_TO_CHECKER, kind, word, count) ||
        !wire_read_bytes(WIRE_FROM_CHECKER, reply, sizeof reply))
        _Exit(3); /* the checker has gone */
    return (int64_t)reply[2];
}

/* false when the checker has no more cases. */
static bool
read_case(void)
{
    uint64_t head[2];
    if (!wire_read_bytes(WIRE_FROM_CHECKER, head, sizeof head))
        return false;
    words_clear(&now.given);
    now.next = 0;
    for (uint64_t i = 0; i < head[1]; i++)
        words_put(&now.given, 0);
    return wire_read_bytes(WIRE_FROM_CHECKER, now.given.word,
                           now.given.count * sizeof *now.given.word);
}

int
main(void)
{
    while (read_case()) {
        words_clear(&now.answer);
        solve((char)case_number());
        if (!wire_write(WIRE_TO_CHECKER, WIRE_ANSWER, now.answer.word,
                        now.answer.count))
            return 3;
    }
    words_free(&now.given);
    words_free(&now.answer);
    return 0;
}
