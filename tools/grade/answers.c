/* answers.c - questions about points of a student's own, of which answers.txt has the
 * answers (`handout --student`).
 *
 * The student's file is data: it is read here, strictly, and what it is not asked for
 * is left aside. `traces --check` gets a file that is written anew, and knows what is
 * right.
 */
#include "tools/grade/grade.h"

#include "tools/handout/basics.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_OF_A_LINE = 300 };

static const char letters[] = "abcdefghijklmnopqrstuvwxyz";

/* The line at *rest, without the blanks at its end; *rest moves on. NULL: there is
 * none. */
static const char *
next_line(const char **rest)
{
    if (**rest == '\0')
        return NULL;
    const char *line = *rest;
    size_t all = strcspn(line, "\n"), length = all;
    *rest += all + (line[all] == '\n');
    while (length > 0 && strchr(" \t\r", line[length - 1]) != NULL)
        length--;
    return part_of(line, length);
}

/* ---- What is asked. ---- */

static void
add_question(assignment *a, const char *line)
{
    a->property = take_one_more(a->property, a->properties, sizeof *a->property);
    a->property[a->properties++] = (graded_property){
        .name = part_of(line, strlen(line) - 1)};
    a->task[a->tasks - 1].end = a->properties;
}

/* A factor for the points of the exercises, and the points of each question: the
 * smallest whole numbers with which the questions are a fifth of the total. With E
 * points and Q questions, 4 Q times the exercises and E for each question would do;
 * both can be divided by what divides both. */
static void
weigh(assignment *a, size_t first)
{
    int questions = (int)(a->properties - first), factor = 4 * questions,
        each = a->total;
    for (int d = factor; d > 1; d--)
        if (factor % d == 0 && each % d == 0) {
            factor /= d;
            each /= d;
        }
    for (size_t p = 0; p < a->properties; p++)
        a->property[p].points = p < first ? a->property[p].points * factor : each;
    a->total = a->total * factor + each * questions;
}

void
answers_ask(assignment *a, const char *folder)
{
    const char *rest = file_bytes(format("%s/" ANSWERS, folder), NULL), *line;
    size_t first = a->properties;
    if (rest == NULL)
        refuse("%s has no " ANSWERS ", but its assignment.ini lists it", folder);
    while ((line = next_line(&rest)) != NULL) {
        size_t word = strspn(line, letters);
        if (begins_with(line, "---- ")) {
            a->task = take_one_more(a->task, a->tasks, sizeof *a->task);
            a->task[a->tasks++] = (task){
                .exercise = line + strlen("---- "), .section = line + strlen("---- "),
                .title = "first steps on points of your own", .path = ANSWERS,
                .first = a->properties, .end = a->properties};
        } else if (a->tasks > a->exercises && word > 0 &&
                   strcmp(line + word, ":") == 0) {
            add_question(a, line);
        }
    }
    if (a->properties == first)
        refuse("%s/" ANSWERS " asks nothing", folder);
    weigh(a, first);
}

/* ---- What is answered. ---- */

/* Why the file as a whole cannot be read; NULL if it can. */
static const char *
trouble_with(const char *bytes, size_t size)
{
    unsigned line = 1, length = 0;
    for (size_t i = 0; i < size; i++) {
        char c = bytes[i];
        bool ends = c == '\r' && bytes[i + 1] == '\n';
        if ((c < ' ' && c != '\t' && c != '\n' && !ends) || c > '~')
            return format(ANSWERS
                          " is not plain text: line %u has a character that cannot "
                          "be typed in ASCII.",
                          line);
        line += c == '\n';
        length = c == '\n' ? 0 : length + 1;
        if (length > MOST_OF_A_LINE)
            return format(ANSWERS " has a line of more than %d characters: line %u.",
                          MOST_OF_A_LINE, line);
    }
    return NULL;
}

/* What stands behind `question:` below the line `---- section`; NULL: *trouble says why
 * there is no answer. */
static const char *
find_answer(const char *rest, const char *section, const char *question,
            const char **trouble)
{
    const char *line, *answer = NULL, *begin = format("%s:", question);
    const char *head = format("---- %s", section);
    bool here = false;
    *trouble = NULL;
    while ((line = next_line(&rest)) != NULL) {
        if (begins_with(line, "---- "))
            here = strcmp(line, head) == 0;
        if (!here || !begins_with(line, begin))
            continue;
        if (answer != NULL)
            *trouble =
                format(ANSWERS " has the line `%s` twice below `%s`.", begin, head);
        answer = line + strlen(begin);
    }
    if (answer == NULL)
        *trouble = format(ANSWERS " has no line `%s` below `%s`.", begin, head);
    for (const char *c = answer; c != NULL && *c != '\0' && *trouble == NULL; c++)
        if (strchr("0123456 \t,-", *c) == NULL ||
            (strchr("0123456", *c) != NULL && c[1] != '\0' &&
             strchr("0123456", c[1]) != NULL))
            *trouble =
                format("The answer behind `%s` is to have points, which are 0 to 6, "
                       "with blanks, commas or - between them.",
                       begin);
    return *trouble == NULL ? answer : NULL;
}

/* Letters, digits and . _ - @, as `handout --student` wants them. */
static bool
can_be_asked(const char *id)
{
    const char *others = ".0123456789@ABCDEFGHIJKLMNOPQRSTUVWXYZ_-";
    for (const char *c = id; *c != '\0'; c++)
        if (strchr(letters, *c) == NULL && strchr(others, *c) == NULL)
            return false;
    return *id != '\0' && strlen(id) < 100;
}

static mark
mark_in_a_sentence(const char *word, const char *sentence)
{
    return (mark){word, sentence, sentence, NULL};
}

/* Asks `traces --check` about one answer, whose characters are known. */
static mark
mark_answer(const grading *g, const task *t, const char *id, const char *question,
            const char *answer, const char *scratch, const char **fault)
{
    char *said;
    const char *path = format("%s/answer", scratch);
    const char *text = format("---- %s\n%s:%s\n", t->section, question, answer);
    const char *pass = format("\n%s\tpass\t", question);
    const char *fail = format("\n%s\tfail\t", question);
    const char *const check[] = {format("%s/traces", g->tools), "--check", id, path,
                                 t->section, NULL};
    write_file(path, text, strlen(text));
    int status = run(scratch, check, 60, 4000, &said, NULL);
    const char *lines = format("\n%s", said);
    if (status == 0 && strstr(lines, pass) != NULL)
        return mark_in_a_sentence("pass", "This is right for these points.");
    if (status != 0 || strstr(lines, fail) == NULL)
        *fault = format("traces --check says nothing of %s %s: status %d", t->section,
                        question, status);
    return mark_in_a_sentence("fail",
                              format("This is not so for the points of %s.", id));
}

void
answers_mark(const grading *g, const task *t, const char *id, const char *scratch,
             result *r)
{
    size_t size;
    const char *text = file_bytes(format("%s/src/" ANSWERS, scratch), &size);
    const char *trouble = trouble_with(text, size);
    for (size_t p = t->first; p < t->end; p++) {
        const char *question = g->asked.property[p].name, *why = trouble;
        const char *answer =
            why != NULL ? NULL : find_answer(text, t->section, question, &why);
        if (answer == NULL)
            r->mark[p] = mark_in_a_sentence("malformed", why);
        else if (answer[strspn(answer, " \t,-")] == '\0')
            r->mark[p] = mark_in_a_sentence("todo", "Nothing has been filled in.");
        else if (!can_be_asked(id))
            r->mark[p] = mark_in_a_sentence(
                "fail", "Nobody of this name has questions: it "
                        "is to have letters, digits and . _ - @ only.");
        else
            r->mark[p] = mark_answer(g, t, id, question, answer, scratch, &r->fault);
    }
}
