/* feedback.c - what a student is told of a property that does not hold.
 *
 * The text stands alone: where it is shown there may be no picture and no checker. What
 * it says of the points is enough to draw them, and to run the case again elsewhere.
 */
#include "tools/checks/feedback.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_IN_A_COMMAND = 20 }; /* points; more are no case to type */
enum { MOST_PRINTED = 100 };     /* and more than these tell nobody anything */

/* Control characters, which could play with a terminal, become dots. */
static void
print_clean(FILE *file, const char *text)
{
    for (; *text != '\0'; text++)
        if (*text == '\n' || (isprint((unsigned char)*text) != 0 && *text != 127))
            putc(*text, file);
        else
            putc('.', file);
}

static void
print_points(FILE *file, const site *points, uint32_t n)
{
    for (uint32_t i = 0; i < n && i < MOST_PRINTED; i++)
        fprintf(file, "%s(%ld,%ld)", i == 0 ? "" : i % 10 == 0 ? "\n    " : " ",
                (long)points[i].x, (long)points[i].y);
    if (n > MOST_PRINTED)
        fputs("\n    ...", file);
}

static void
print_case(FILE *file, const questions *about)
{
    bool long_list = about->n > 10;
    fprintf(file, "  smallest case found (%lu point%s):%s", (unsigned long)about->n,
            about->n == 1 ? "" : "s", long_list ? "\n    " : about->n > 0 ? " " : "");
    print_points(file, about->at, about->n);
    putc('\n', file);
    sketch_print(file, "    ", about->at, about->n);
}

/* The command that runs it again. */
static void
print_again(FILE *file, const failure *f, const request *r)
{
    bool typed = f->is_a_case && f->n > 0 && f->n <= MOST_IN_A_COMMAND;
    fputs("  run it again: ", file);
    if (typed && r->again_case != NULL) {
        fprintf(file, "%s PROPERTY=%s CASE=\"", r->again_case, f->of->name);
        for (uint32_t i = 0; i < f->n; i++)
            fprintf(file, "%s(%ld,%ld)", i > 0 ? " " : "", (long)f->points[i].x,
                    (long)f->points[i].y);
        fputs("\"\n", file);
    } else if (r->again != NULL) {
        fprintf(file, "%s\n", r->again);
    } else {
        fprintf(file, "with --seed %llu\n", (unsigned long long)r->seed);
    }
}

static void
print_failure(FILE *file, const session *s, const failure *f)
{
    const property *p = f->of;
    const questions *about = questions_of(s); /* the points that the case was about */
    fprintf(file, "%s %s: %s\n", p->exercise, p->name, fate_verb(f->end));
    fprintf(file, "  what must hold: %s (%s)\n", p->statement, p->place);
    fputs("  what was seen: ", file);
    print_clean(file, s->seen);
    putc('\n', file);
    if (f->end != FATE_TODO && about->at != NULL)
        print_case(file, about);
    if (f->end != FATE_ANSWERED && s->student.said_count > 0) {
        fputs("  the program's last words:\n    ", file);
        print_clean(file, s->student.said);
        putc('\n', file);
    }
}

FILE *
feedback_open(const char *path)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        perror(path);
        exit(CHECKER_FAULT);
    }
    return file;
}

void
feedback_close(FILE *file, const char *path)
{
    if (ferror(file) != 0 || fclose(file) != 0) {
        fprintf(stderr, "checker: %s cannot be written\n", path);
        exit(CHECKER_FAULT);
    }
}

/* NAME.txt and a line of the table. */
static void
write_failure(const session *s, const failure *f, const request *r, FILE *table)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.txt", r->feedback, f->of->name);
    FILE *text = feedback_open(path);
    print_failure(text, s, f);
    print_again(text, f, r);
    feedback_close(text, path);
    fprintf(table, "%s\t%s\t", f->of->name,
            f->end == FATE_ANSWERED ? "fail" : fate_word(f->end));
    for (const char *c = s->seen; *c != '\0'; c++)
        putc(isprint((unsigned char)*c) != 0 ? *c : '.', table);
    putc('\n', table);
}

/* NAME.svg. (The text does not name it: it may be read where the picture is not.) */
static bool
draw_failure(const session *s, const failure *f, const char *path)
{
    return f->end != FATE_TODO && questions_of(s)->at != NULL &&
           questions_of(s)->n > 0 && picture_write(s, f->of, path);
}

void
feedback_failure(const session *s, const failure *f, const request *r, FILE *table)
{
    char picture[1024];
    print_failure(stdout, s, f);
    if (r->feedback != NULL) {
        write_failure(s, f, r, table);
        snprintf(picture, sizeof picture, "%s/%s.svg", r->feedback, f->of->name);
        if (draw_failure(s, f, picture))
            printf("  picture: %s\n", picture);
    }
    print_again(stdout, f, r);
}
