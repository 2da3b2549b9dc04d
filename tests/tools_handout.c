/* handout makes a student's tree: it takes the solutions out, and nothing but them, and
 * refuses to write a tree that does not keep its promises.
 *
 * Each trial plants a small project in a folder of its own, with two exercises and a
 * checker that only counts. And each week of the real project makes a tree in which
 * nothing of a solution is left.
 *
 * Hypotheses: the programs are built, as `make test` does.
 */
#include "tests/harness/small_project.h"

#include <string.h>

static bool
file_is(const char *path, const char *bytes)
{
    static char found[20000];
    FILE *file = fopen(path, "r");
    must(file != NULL, path);
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    fclose(file);
    bool same = strcmp(found, bytes) == 0;
    if (!same)
        snprintf(said, sizeof said, "%s", found);
    return same;
}

/* ---- The tree. ---- */

static void
solutions_and_nothing_else_are_taken_out(void)
{
    plant("tools_handout");
    CLAIM("handout.tree", run_tool("handout", "--no-proof 2.3 -o out/t") == 0, "%s",
          said);
    CLAIM("handout.stub", file_is("out/t/chapters/2.3_a/a.c", stubbed), "%s", said);
    CLAIM("handout.page", file_is("out/t/chapters/2.3_a/README.md", page_without), "%s",
          said);
    CLAIM("handout.tree", file_is("out/t/chapters/2.3_a/a.h", header), "%s", said);
    run("cd out/t && find . -type f | LC_ALL=C sort | tr '\\n' ' '");
    CLAIM(
        "handout.tree",
        strcmp(
            said,
            "./Makefile ./README.md ./assignment.ini ./assignment.mk "
            "./chapters/2.3_a/README.md ./chapters/2.3_a/a.c ./chapters/2.3_a/a.h "
            "./chapters/2.3_a/figures/x.svg ./checks/2.3.c ./checks/checker.c "
            "./checks/checker.h ./checks/hint.sh ./checks/more.c ./checks/run.sh "
            "./checks/student/2.3.c ./checks/student/driver.c ./checks/submit.c "
            "./checks/ustar.c ./checks/ustar.h ./checks/wire.c ./checks/wire.h "
            "./docs/LICENSE ./lib/one.c ./lib/one.h ./lib/part.c ./lib/todo.h ") == 0,
        "%s", said);
    CLAIM("handout.outside", run("grep -rn 'tools/' out/t") == 1, "%s", said);
    CLAIM("handout.outside",
          run("grep -rnw 'add' out/t/assignment.* out/t/chapters") == 1, "%s", said);
    CLAIM("handout.there", run_tool("handout", "--no-proof 2.3 -o out/t") == 1 &&
          strstr(said, "out/t is there already"), "%s", said);
}

/* Which bodies are gone when only one exercise is asked? */
static void
earlier_exercises_are_given_and_later_ones_left_out(void)
{
    plant("tools_handout");
    CLAIM("handout.roles", run_tool("handout", "--no-proof 2.3-a -o out/a") == 0, "%s",
          said);
    CLAIM("handout.roles", file_is("out/a/chapters/2.3_a/a.c", stubbed), "%s", said);
    CLAIM("handout.roles", run("grep -c '^\\[2' out/a/assignment.ini") == 0 &&
          strcmp(said, "1\n") == 0, "%s", said);
    CLAIM("handout.roles", run_tool("handout", "--no-proof 2.3-b -o out/b") == 0, "%s",
          said);
    CLAIM("handout.roles", run("grep TODO out/b/chapters/2.3_a/a.c; grep -cw add "
                               "out/b/chapters/2.3_a/a.c") == 0 &&
          strcmp(said, "    TODO(\"2.3-b\");\n3\n") == 0, "%s", said);
    CLAIM("handout.roles", run_tool("handout", "--no-proof W1 -o out/w") == 0, "%s",
          said);
    CLAIM("handout.roles", file_is("out/w/chapters/2.3_a/a.c", stubbed), "%s", said);
    CLAIM("handout.roles", run_tool("handout", "--no-proof 2.4 -o out/n") == 1 &&
          strstr(said, "2.4 is no week"), "%s", said);
}

static void
archives_have_the_same_bytes(void)
{
    plant("tools_handout");
    run_tool("handout", "--no-proof 2.3 -o out/t");
    run_tool("handout", "--no-proof 2.3 -o out/1.tar.gz");
    sleep(1);
    run("touch chapters/*/* lib/* tools/checks/* && chmod 600 lib/*");
    run_tool("handout", "--no-proof 2.3 -o out/2.tar.gz");
    CLAIM("handout.bytes", run("cmp out/1.tar.gz out/2.tar.gz") == 0, "%s", said);
    CLAIM("handout.bytes", run("cd out && gzip -d -c 1.tar.gz | tar xf - && diff -r "
                               "triangulations-2.3 t") == 0, "%s", said);
}

/* ---- The promises. ---- */

/* In this copy of the text, `what` becomes `by`. */
static void
write_changed(const char *path, const char *text, const char *what, const char *by)
{
    static char bytes[60000];
    const char *at = strstr(text, what);
    must(at != NULL, what);
    snprintf(bytes, sizeof bytes, "%.*s%s%s", (int)(at - text), text, by,
             at + strlen(what));
    write_file(path, bytes);
}

static void
broken_promises_are_refused(void)
{
    static const struct {
        const char *path, *what, *by, *reason;
    } broken[] = {
        {"chapters/2.3_a/a.c", "return a + b", "return a + a + b", "comes out as pass"},
        {"chapters/2.3_a/a.c", "return a + 1;", "int x; return a + 1;",
         "without warnings"},
        {"chapters/2.3_a/a.c", "return a + 1", "return (a + 1",
         "brackets do not match"},
        {"tools/checks/student/driver.c", "twice(7) == 14", "1", "comes out as todo"},
        {"chapters/2.3_a/exercises.ini", "right:4", "right:4 small:1",
         "comes out as todo"},
        {"chapters/2.3_a/exercises.ini", "a.c half", "b.c half",
         "there is no chapters"},
        {"chapters/2.3_a/README.md", "# A page\n",
         "int first_summand = a;\n  int second_summand=a;\n}\n"
         "int sum_of_the_two = add(first_summand,\tsecond_summand);\n",
         "README.md, after line 0:"},
        {"chapters/2.3_a/README.md", "a.c increment", "a.c decrement",
         "has no decrement"},
        {"chapters/2.3_a/a.h", "#define A",
         "#define A\n#include \"chapters/3.1_v/v.h\"", "comes later"},
    };
    const char *original[] = {source,    source, source, driver, exercises,
                              exercises, page,   page,   header};
    for (size_t k = 0; k < sizeof broken / sizeof *broken; k++) {
        plant("tools_handout");
        write_changed(broken[k].path, original[k], broken[k].what, broken[k].by);
        int status = run_tool("handout", "2.3 -o out/t");
        CLAIM("handout.promises", status == 1 && strstr(said, broken[k].reason),
              "%s with %s: %s", broken[k].path, broken[k].by, said);
        CLAIM("handout.promises", access("out/t", F_OK) != 0 &&
              run("ls out | grep .") == 1, "something was written: %s", said);
    }
}

/* Lines that two functions share may be left where exercises.ini says so. */
static void
overlap_is_said(void)
{
    static const char lines[] =
        "int\nincrement(int a)\n{\n    int first_summand = a;\n"
        "    int second_summand = a;\n    int sum_of_the_two = 1 + "
        "first_summand - second_summand;\n    int first_summand_2 = a + "
        "sum_of_the_two;\n"
        "    return first_summand_2;\n}\n";
    char text[1000];
    plant("tools_handout");
    write_changed("chapters/2.3_a/a.c", source, "int\nincrement(int a)\n{\n"
                  "    return a + 1;\n}\n", lines);
    CLAIM("handout.overlap", run_tool("handout", "--no-proof 2.3 -o out/t") == 0,
          "two lines are too many: %s", said);
    snprintf(text, sizeof text, "%s", lines);
    memcpy(strstr(text, "1 + first"), "add(first", 9);
    memcpy(strstr(text, " - second_summand;"), ", second_summand);", 18);
    write_changed("chapters/2.3_a/a.c", source, "int\nincrement(int a)\n{\n"
                  "    return a + 1;\n}\n", text);
    CLAIM("handout.overlap",
          run_tool("handout", "--no-proof 2.3 -o out/u") == 1 &&
              strstr(said, "of a solution of 2.3-a") && strstr(said, "after line"),
          "%s", said);
    write_changed("chapters/2.3_a/exercises.ini", exercises, "helpers  = add\n",
                  "helpers  = add\noverlap = increment\n");
    CLAIM("handout.overlap", run_tool("handout", "--no-proof 2.3 -o out/u") == 0, "%s",
          said);
}

/* ---- What a student does. ---- */

static void
students_get_points_for_what_is_right(void)
{
    plant("tools_handout");
    CLAIM("handout.proof", run_tool("handout", "2.3 -o out/t") == 0, "%s", said);
    CLAIM("student.zero", run("cd out/t && make -s check") != 0 &&
          strstr(said, "2.3-a   0 of  3 points:  right 0/2  quick 0/1\n") &&
          strstr(said, "2.3-b   0 of  4 points:  right 0/4\n"), "%s", said);
    char command[3000];
    snprintf(command, sizeof command, "BUILD=no MAKEFLAGS=n '%s/handout' 2.3 -o out/e",
             build);
    CLAIM("handout.environment", run(command) == 0, "%s", said);
    write_changed("out/t/chapters/2.3_a/a.c", stubbed, "{\n    TODO(\"2.3-a\");\n}",
                  "{ return a << 1; }");
    CLAIM("student.points",
          run("cd out/t && make -s check EX=2.3-a") == 0 &&
              strstr(said, "2.3-a   3 of  3 points:") && !strstr(said, "2.3-b"),
          "%s", said);
    CLAIM("student.points", run("cd out/t && make -s check") != 0 &&
          strstr(said, "2.3-a   3 of  3 points:") &&
          strstr(said, "2.3-b   0 of  4 points:") &&
          strstr(said, "all     3 of  7 points\n"), "%s", said);
    CLAIM("student.unknown", run("cd out/t && make -s check EX=2.3-x") != 0 &&
          strstr(said, "no such exercise") && strstr(said, "2.3-a 2.3-b"), "%s", said);
    CLAIM("student.seed", run("cd out/t && make -s check SEED=x") != 0 &&
          strstr(said, "SEED is a number") && !strstr(said, "has failed"), "%s", said);
    CLAIM("student.hint", run("cd out/t && make -s hint EX=2.3-a N=2") == 0 &&
          strcmp(said, "  1. What is a sum?\n  2. Draw it.\n") == 0, "%s", said);
    CLAIM("student.hint", run("cd out/t && make -s hint EX=2.3-a") == 0 &&
          strcmp(said, "  1. What is a sum?\n") == 0, "%s", said);

    CLAIM("student.submit",
          run("cd out/t && make -s submit && cp build/submission.tar .. && "
              "touch chapters/*/* && make -s clean submit && cmp build/submission.tar "
              "../submission.tar") == 0,
          "%s", said);
    CLAIM("student.submit",
          run("cd out && mkdir s && cd s && tar xf ../submission.tar && "
              "find . -type f && cmp chapters/2.3_a/a.c ../t/chapters/2.3_a/a.c") ==
                  0 &&
              strcmp(said, "./chapters/2.3_a/a.c\n") == 0,
          "%s", said);
}

static void
students_have_questions_of_their_own(void)
{
    plant("tools_handout");
    run_tool("traces", "anna 2.3 >asked.txt");
    CLAIM("handout.student",
          run_tool("handout", "--no-proof --student anna 2.3 -o out/t") == 0 &&
              run("cmp asked.txt out/t/answers.txt && cd out/t && make -s submit && "
                  "tar tf build/submission.tar") == 0 &&
              strstr(said, "answers.txt\n"),
          "%s", said);
    CLAIM("handout.student", run_tool("handout", "--student 'a b' 2.3 -o out/u") == 1 &&
          strstr(said, "no questions for a b"), "%s", said);
}

/* Without a check of the section the tree is written, and says so. */
static void
missing_checks_are_reported(void)
{
    plant("tools_handout");
    unlink("tools/checks/2.3.c");
    CLAIM("handout.unchecked", run_tool("handout", "2.3 -o out/t") == 0 &&
          strstr(said, "no check of section 2.3"), "%s", said);
    CLAIM("handout.unchecked", run("cd out/t && make -s check") != 0 &&
          strstr(said, "no check"), "%s", said);
}

static void
variants_are_told(void)
{
    plant("tools_handout");
    CLAIM("handout.variant", run_tool("handout", "2.3 --variant up -o out/t") == 1 &&
          strstr(said, "no exercise of 2.3 is asked in the variant up"), "%s", said);
    write_changed("chapters/2.3_a/exercises.ini", exercises, "stars",
                  "variants = up\nstars");
    CLAIM("handout.variant", run_tool("handout", "2.3 --variant up -o out/t") == 1 &&
          strstr(said, "no variant"), "the reference solves it: %s", said);
    CLAIM("handout.variant",
          run_tool("handout", "--no-proof 2.3 --variant up -o out/t") == 0 &&
              run("grep -A2 'This is a variant' out/t/README.md") == 0 &&
              strstr(said, "In 2.3-a: Up is down.\n"),
          "%s", said);
    CLAIM("handout.variant", run("grep '^VARIANT = up$' out/t/assignment.mk") == 0,
          "%s", said);
    CLAIM("handout.variant", run_tool("handout", "2.3 --variant down -o out/d") == 1 &&
          strstr(said, "no variant down"), "%s", said);
}

/* ---- The project. ---- */

/* Each week and each section: whatever can be seen without compiling. */
static void
nothing_of_a_solution_is_left_in_any_week(void)
{
    char command[12000];
    must(chdir(root) == 0, root);
    snprintf(
        command, sizeof command,
        "for what in $(sed -n 's/^\\[\\(W[0-9]*\\)\\]/\\1/p' docs/assignments.ini) "
        "$(sed -n 's/^\\[\\([0-9].*\\)\\]/\\1/p' chapters/*/exercises.ini); do "
        "rm -rf '%s/tools_handout.week'; "
        "'%s/handout' --no-proof $what -o '%s/tools_handout.week' "
        ">'%s/tools_handout.txt' 2>&1 || { cat '%s/tools_handout.txt'; exit 1; }; done",
        build, build, build, build, build);
    CLAIM("handout.weeks", run(command) == 0, "%s", said);
}

/* A page's list of exercises says what exercises.ini says: points, stars and hours. */
static void
pages_list_the_exercises(void)
{
    must(chdir(root) == 0, root);
    CLAIM("handout.pages",
          run("for ini in chapters/*/exercises.ini; do awk -F' *= *' '"
              "/^\\[/ { id = substr($0, 2, length($0) - 2); what = \"points\" } "
              "$1 == \"bonus\" { what = \"bonus points\" } "
              "$1 == \"stars\" { stars = substr(\"****\", 1, $2) } "
              "$1 == \"points\" { n = split($2, part, /[ :]/); points = 0; "
              "  for (i = 2; i <= n; i += 2) points += part[i] } "
              "$1 == \"hours\" { printf \"- @%s@ (%d %s, %s, %d hour%s)\\n\", "
              "  id, points, what, stars, $2, $2 == 1 ? \"\" : \"s\" }' \"$ini\" | "
              "while read -r line; do "
              "sed 's/^- \\*\\*\\([^*]*\\)\\*\\*/- @\\1@/; s/\xe2\x98\x85/*/g' "
              "\"${ini%/*}/README.md\" | grep -qF -- \"$line\" || "
              "{ echo \"${ini%/*}: $line\"; exit 1; }; done || exit 1; done") == 0,
          "the page does not say %s", said);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "handout: a student's tree, without the solutions");
    tools_begin(argv);

    test_run("solutions are taken out, and nothing else",
             solutions_and_nothing_else_are_taken_out);
    test_run("earlier exercises are given, later ones left out",
             earlier_exercises_are_given_and_later_ones_left_out);
    test_run("archives have the same bytes", archives_have_the_same_bytes);
    test_run("broken promises are refused", broken_promises_are_refused);
    test_run("overlap is said", overlap_is_said);
    test_run("students get points for what is right",
             students_get_points_for_what_is_right);
    test_run("students have questions of their own",
             students_have_questions_of_their_own);
    test_run("missing checks are reported", missing_checks_are_reported);
    test_run("variants are told", variants_are_told);
    test_run("nothing of a solution is left in any week",
             nothing_of_a_solution_is_left_in_any_week);
    test_run("pages list the exercises", pages_list_the_exercises);
    return test_end((test_minima){.trials = 11});
}
