/* traces.c - questions about seven points, which are different for each student.
 *
 *     traces ID SECTION...                  the questions, as a file to fill in
 *     traces --check ID FILE SECTION...     what is right in a file that was filled in
 *
 * The sections are 2.3, 3.5 and 3.6; others have no questions. Whoever has understood
 * an algorithm does its first steps by hand in minutes; an answer of somebody else is
 * about other points.
 *
 * --check prints lines NAME<TAB>pass|fail<TAB>sentence, as the checkers do. Exit
 * status: 0; 1 there is no question; 2 the program cannot run.
 */
#include "tools/handout/questions.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        printf(
            "\nFigure 10 begins with these triangles and this stack L; line 5 pushes "
            "as push_link\n"
            "does. What is on the stack after three flips, written like L? "
            "(3-4 or 4-3 is the same.)\nstack:\n\n"
            "Somebody forgets line 5, so nothing is pushed. Then the loop ends with an "
            "edge ab\nthat is not locally Delaunay, and opposite to it are c and d. "
            "Name one: a b c d.\nwitness:\n");
    if (section[2] == '6')
        printf(
            "\nPoints 0 to 5 have a Delaunay triangulation, and point 6 is inserted. "
            "Its neighbours\n"
            "are then, counterclockwise, whichever comes first:\nlink:\n");
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
        if (!questions_exist(*section))
            continue;
        questions q = questions_ask(id, *section);
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
