/* The tools that make a student's tree: handout takes the solutions out, and nothing but
 * them, and refuses to write a tree that does not keep its promises; splice puts
 * single exercises of the reference into a student's file.
 *
 * Each trial plants a small project in a folder of its own, with two exercises and a
 * checker that only counts. And each week of the real project makes a tree in which
 * nothing of a solution is left.
 *
 * Hypotheses: the programs are built, as `make test` does.
 */
#include "tests/harness/harness.h"
#include "tests/harness/tools.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* ---- A small project. ---- */

static const char *const header =
    "/* a.h - a header. */\n"
    "#ifndef A\n"
    "#define A\n"
    "/* Two times a. */\n"
    "int twice(int a);\n"
    "/* Half of an even number. */\n"
    "int half(int a);\n"
    "/* One more. */\n"
    "int increment(int a);\n"
    "#endif\n";

static const char *const source =
    "/* a.c - a source. */\n"
    "#include \"chapters/2.3_a/a.h\"\n"
    "\n"
    "static int add(int a, int b);\n"
    "\n"
    "/* Adds, because { and \" are no more than characters here. */\n"
    "static int\n"
    "add(int a, int b)\n"
    "{\n"
    "    const char brace = '{', *quote = \"}\\\"{\";\n"
    "    return a + b + (brace == quote[0]);\n"
    "}\n"
    "\n"
    "/* Why it is right: twice is the sum of two. */\n"
    "int\n"
    "twice(int a)\n"
    "{\n"
    "    int first_summand = a; // Step 1\n"
    "    int second_summand = a;\n"
    "    int sum_of_the_two = add(first_summand, second_summand);\n"
    "    return sum_of_the_two;\n"
    "}\n"
    "\n"
    "int\n"
    "increment(int a)\n"
    "{\n"
    "    return a + 1;\n"
    "}\n"
    "\n"
    "int\n"
    "half(int a)\n"
    "{\n"
    "    int candidate_number = 0;\n"
    "    while (candidate_number + candidate_number < a)\n"
    "        candidate_number = increment(candidate_number);\n"
    "    return candidate_number;\n"
    "}\n";

static const char *const stubbed =
    "/* a.c - a source. */\n"
    "#include \"chapters/2.3_a/a.h\"\n"
    "#include \"lib/todo.h\"\n"
    "\n"
    "int\n"
    "twice(int a)\n"
    "{\n"
    "    TODO(\"2.3-a\");\n"
    "}\n"
    "\n"
    "int\n"
    "increment(int a)\n"
    "{\n"
    "    return a + 1;\n"
    "}\n"
    "\n"
    "int\n"
    "half(int a)\n"
    "{\n"
    "    TODO(\"2.3-b\");\n"
    "}\n";

static const char *const exercises =
    "[2.3-a]\n"
    "title    = Two times\n"
    "function = chapters/2.3_a/a.c twice\n"
    "helpers  = add\n"
    "points   = right:2 quick:1\n"
    "mode     = plain\n"
    "stars    = 1\n"
    "hours    = 1\n"
    "hint1    = What is a sum?\n"
    "hint2    = Draw it.\n"
    "[2.3-b]\n"
    "title    = Half of it\n"
    "function = chapters/2.3_a/a.c half\n"
    "points   = right:4\n"
    "mode     = plain\n"
    "needs    = 2.3-a\n";

static const char *const page =
    "# A page\n"
    "See [the source](a.c), [later](../3.1_v/README.md), and\n"
    "![a picture](figures/x.svg)![none](figures/none.svg).\n"
    "\n"
    "<!-- code: chapters/2.3_a/a.c twice -->\n```c\n```\n"
    "<!-- code: chapters/2.3_a/a.c twice \"Step 1\" -->\n```c\n```\n"
    "<!-- code: chapters/2.3_a/a.c add -->\n```c\n```\n"
    "<!-- code: tests/t.c t -->\n```c\n```\n"
    "<!-- code: chapters/2.3_a/a.c increment -->\n```c\n```\n";

static const char *const page_without =
    "# A page\n"
    "See [the source](a.c), later, and\n"
    "![a picture](figures/x.svg).\n"
    "\n"
    "<!-- code: chapters/2.3_a/a.c twice -->\n```c\n"
    "int\ntwice(int a)\n{\n    TODO(\"2.3-a\");\n}\n```\n"
    "*(Exercise 2.3-a: yours to write.)*\n"
    "*(Exercise 2.3-a: yours to write.)*\n"
    "*(This code is in `tests/t.c`, which is not in your tree.)*\n"
    "<!-- code: chapters/2.3_a/a.c increment -->\n```c\n"
    "int\nincrement(int a)\n{\n    return a + 1;\n}\n```\n";

/* Runs PROGRAM LETTER, which prints how each property came out, and believes it. */
static const char *const checker =
    "#include \"tools/checks/checker.h\"\n"
    "#include <stdio.h>\n"
    "#include <string.h>\n"
    "int\n"
    "main(int argc, char **argv)\n"
    "{\n"
    "    char command[500], path[500], line[100];\n"
    "    const char *folder = \"\";\n"
    "    int passed = 1;\n"
    "    for (int i = 1; i + 1 < argc; i++)\n"
    "        if (strcmp(argv[i], \"--feedback\") == 0)\n"
    "            folder = argv[i + 1];\n"
    "    snprintf(command, sizeof command, \"%s %c\", argv[argc - 1], argv[1][4]);\n"
    "    snprintf(path, sizeof path, \"%s/properties.tsv\", folder);\n"
    "    FILE *table = fopen(path, \"w\"), *program = popen(command, \"r\");\n"
    "    while (fgets(line, sizeof line, program) != NULL) {\n"
    "        fputs(line, table);\n"
    "        passed &= strstr(line, \"pass\") != NULL;\n"
    "    }\n"
    "    pclose(program);\n"
    "    fclose(table);\n"
    "    return passed ? ACCEPT : ACCEPT + 1;\n"
    "}\n";

static const char *const driver =
    "#include \"chapters/2.3_a/a.h\"\n"
    "#include \"lib/todo.h\"\n"
    "#include \"tools/checks/wire.h\"\n"
    "#include <stdio.h>\n"
    "#include <stdlib.h>\n"
    "static char exercise;\n"
    "static void\n"
    "say(const char *result)\n"
    "{\n"
    "    printf(\"right\\t%s\\tx\\n\", result);\n"
    "    if (exercise == 'a')\n"
    "        printf(\"quick\\t%s\\tx\\n\", result);\n"
    "}\n"
    "void\n"
    "exercise_todo(const char *id)\n"
    "{\n"
    "    (void)id;\n"
    "    say(\"todo\");\n"
    "    exit(0);\n"
    "}\n"
    "int\n"
    "main(int argc, char **argv)\n"
    "{\n"
    "    exercise = argv[argc - 1][0];\n"
    "    if (exercise == 'a')\n"
    "        say(twice(7) == 14 ? \"pass\" : \"fail\");\n"
    "    else\n"
    "        say(half(14) == 7 ? \"pass\" : \"fail\");\n"
    "    return 0;\n"
    "}\n";

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

/* Enters the folder of the small project, with all its files as they should be. */
static void
plant(const char *folder_name)
{
    static char folder[2200], command[12000];
    snprintf(folder, sizeof folder, "%s/%s.tree", build, folder_name);
    snprintf(command, sizeof command,
             "rm -rf '%s' && mkdir '%s' && cd '%s' && mkdir -p lib docs out "
             "chapters/2.3_a/figures tools/checks/student tools/handout && "
             "cp -R '%s/tools/handout/student' '%s'/tools/handout/ustar.[ch] tools/handout "
             "&& cp '%s/docs/LICENSE' docs", folder, folder, folder, root, root, root);
    must(run(command) == 0 && chdir(folder) == 0, said);
    write_file("README.md", "# All\n");
    write_file("lib/one.h", "/* one.h */\n");
    write_file("lib/one.c", "#include \"lib/one.h\"\nint one = 1;\n");
    write_file("lib/part.c", "#include \"lib/one.h\"\nextern int one;\n");
    write_file("lib/other.h", "/* other.h */\n");
    write_file("docs/assignments.ini", "[W1]\ntitle = All\nexercises = 2.3\n\n[up]\n"
               "text = Up is down.\n");
    write_file("chapters/2.3_a/a.h", header);
    write_file("chapters/2.3_a/a.c", source);
    write_file("chapters/2.3_a/exercises.ini", exercises);
    write_file("chapters/2.3_a/README.md", page);
    write_file("chapters/2.3_a/figures.c", "int main(void) { return 0; }\n");
    write_file("chapters/2.3_a/fast_a.c", "int fast_a;\n");
    write_file("chapters/2.3_a/figures/x.svg", "<svg/>\n");
    write_file("tools/checks/checker.h", "#include \"lib/one.h\"\nenum { ACCEPT = 42 };\n");
    write_file("tools/checks/checker.c", checker);
    write_file("tools/checks/2.3.c", "#include \"tools/checks/checker.h\"\n");
    write_file("tools/checks/wire.h", "/* wire.h */\n");
    write_file("tools/checks/wire.c", "extern int wire;\n");
    write_file("tools/checks/more.c", "#include \"tools/checks/wire.h\"\nextern int more;\n");
    write_file("tools/checks/other.c", "#include \"tests/other.h\"\n");
    write_file("tools/checks/3.1.c", "#include \"tools/checks/checker.h\"\n");
    write_file("tools/checks/student/driver.c", driver);
    write_file("tools/checks/student/2.3.c", "extern int more;\n");
}

/* ---- The tree. ---- */

static void
solutions_and_nothing_else_are_taken_out(void)
{
    plant("tools_handout");
    CLAIM("handout.tree", run_tool("handout", "--no-proof 2.3 -o out/t") == 0, "%s", said);
    CLAIM("handout.stub", file_is("out/t/chapters/2.3_a/a.c", stubbed), "%s", said);
    CLAIM("handout.page", file_is("out/t/chapters/2.3_a/README.md", page_without), "%s",
          said);
    CLAIM("handout.tree", file_is("out/t/chapters/2.3_a/a.h", header), "%s", said);
    run("cd out/t && find . -type f | LC_ALL=C sort | tr '\\n' ' '");
    CLAIM("handout.tree", strcmp(said,
          "./Makefile ./README.md ./assignment.ini ./assignment.mk ./chapters/2.3_a/README.md "
          "./chapters/2.3_a/a.c ./chapters/2.3_a/a.h ./chapters/2.3_a/figures/x.svg "
          "./checks/2.3.c ./checks/checker.c ./checks/checker.h ./checks/hint.sh "
          "./checks/more.c ./checks/run.sh ./checks/student/2.3.c ./checks/student/driver.c "
          "./checks/submit.c ./checks/ustar.c ./checks/ustar.h ./checks/wire.c ./checks/wire.h "
          "./docs/LICENSE ./lib/one.c ./lib/one.h ./lib/part.c ./lib/todo.h ") == 0, "%s",
          said);
    CLAIM("handout.outside", run("grep -rn 'tools/' out/t") == 1, "%s", said);
    CLAIM("handout.outside", run("grep -rnw 'add' out/t/assignment.* out/t/chapters") == 1, "%s", said);
    CLAIM("handout.there", run_tool("handout", "--no-proof 2.3 -o out/t") == 1 &&
          strstr(said, "out/t is there already"), "%s", said);
}

/* Which bodies are gone when only one exercise is asked? */
static void
earlier_exercises_are_given_and_later_ones_left_out(void)
{
    plant("tools_handout");
    CLAIM("handout.roles", run_tool("handout", "--no-proof 2.3-a -o out/a") == 0, "%s", said);
    CLAIM("handout.roles", file_is("out/a/chapters/2.3_a/a.c", stubbed), "%s", said);
    CLAIM("handout.roles", run("grep -c '^\\[2' out/a/assignment.ini") == 0 &&
          strcmp(said, "1\n") == 0, "%s", said);
    CLAIM("handout.roles", run_tool("handout", "--no-proof 2.3-b -o out/b") == 0, "%s", said);
    CLAIM("handout.roles", run("grep TODO out/b/chapters/2.3_a/a.c; grep -cw add "
                               "out/b/chapters/2.3_a/a.c") == 0 &&
          strcmp(said, "    TODO(\"2.3-b\");\n3\n") == 0, "%s", said);
    CLAIM("handout.roles", run_tool("handout", "--no-proof W1 -o out/w") == 0, "%s", said);
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
        {"chapters/2.3_a/a.c", "return a + 1;", "int x; return a + 1;", "without warnings"},
        {"chapters/2.3_a/a.c", "return a + 1", "return (a + 1", "brackets do not match"},
        {"tools/checks/student/driver.c", "twice(7) == 14", "1", "comes out as todo"},
        {"chapters/2.3_a/exercises.ini", "right:4", "right:4 small:1", "comes out as todo"},
        {"chapters/2.3_a/exercises.ini", "a.c half", "b.c half", "there is no chapters"},
        {"chapters/2.3_a/README.md", "# A page\n",
         "int first_summand = a;\n  int second_summand=a;\n}\n"
         "int sum_of_the_two = add(first_summand,\tsecond_summand);\n",
         "README.md, after line 0:"},
        {"chapters/2.3_a/README.md", "a.c increment", "a.c decrement", "has no decrement"},
        {"chapters/2.3_a/a.h", "#define A", "#define A\n#include \"chapters/3.1_v/v.h\"",
         "comes later"},
    };
    const char *original[] = {source, source, source, driver, exercises, exercises, page,
                              page, header};
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
        "first_summand - second_summand;\n    int first_summand_2 = a + sum_of_the_two;\n"
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
    CLAIM("handout.overlap", run_tool("handout", "--no-proof 2.3 -o out/u") == 1 &&
          strstr(said, "of a solution of 2.3-a") && strstr(said, "after line"), "%s", said);
    write_changed("chapters/2.3_a/exercises.ini", exercises, "helpers  = add\n",
                  "helpers  = add\noverlap = increment\n");
    CLAIM("handout.overlap", run_tool("handout", "--no-proof 2.3 -o out/u") == 0, "%s", said);
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
    snprintf(command, sizeof command, "BUILD=no MAKEFLAGS=n '%s/handout' 2.3 -o out/e", build);
    CLAIM("handout.environment", run(command) == 0, "%s", said);
    write_changed("out/t/chapters/2.3_a/a.c", stubbed, "{\n    TODO(\"2.3-a\");\n}",
                  "{ return a << 1; }");
    CLAIM("student.points", run("cd out/t && make -s check EX=2.3-a") == 0 &&
          strstr(said, "2.3-a   3 of  3 points:") && !strstr(said, "2.3-b"), "%s", said);
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

    CLAIM("student.submit", run("cd out/t && make -s submit && cp build/submission.tar .. && "
          "touch chapters/*/* && make -s clean submit && cmp build/submission.tar "
          "../submission.tar") == 0, "%s", said);
    CLAIM("student.submit", run("cd out && mkdir s && cd s && tar xf ../submission.tar && "
          "find . -type f && cmp chapters/2.3_a/a.c ../t/chapters/2.3_a/a.c") == 0 &&
          strcmp(said, "./chapters/2.3_a/a.c\n") == 0, "%s", said);
}

static void
students_have_questions_of_their_own(void)
{
    plant("tools_handout");
    run_tool("traces", "anna 2.3 >asked.txt");
    CLAIM("handout.student",
          run_tool("handout", "--no-proof --student anna 2.3 -o out/t") == 0 &&
          run("cmp asked.txt out/t/answers.txt && cd out/t && make -s submit && "
              "tar tf build/submission.tar") == 0 && strstr(said, "answers.txt\n"), "%s",
          said);
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
    write_changed("chapters/2.3_a/exercises.ini", exercises, "stars", "variants = up\nstars");
    CLAIM("handout.variant", run_tool("handout", "2.3 --variant up -o out/t") == 1 &&
          strstr(said, "no variant"), "the reference solves it: %s", said);
    CLAIM("handout.variant", run_tool("handout", "--no-proof 2.3 --variant up -o out/t") == 0
          && run("grep -A2 'This is a variant' out/t/README.md") == 0 &&
          strstr(said, "In 2.3-a: Up is down.\n"), "%s", said);
    CLAIM("handout.variant", run("grep '^VARIANT = up$' out/t/assignment.mk") == 0, "%s",
          said);
    CLAIM("handout.variant", run_tool("handout", "2.3 --variant down -o out/d") == 1 &&
          strstr(said, "no variant down"), "%s", said);
}

/* ---- splice. ---- */

/* A student's file in a style of its own, with names of the reference that mean
 * something else. */
static const char *const student =
    "#include \"chapters/2.3_a/a.h\"\n"
    "#if 0\n"
    "int twice(int a) { none\n"
    "#endif\n"
    "static int add(int a) { return a; } /* } */ // {\n"
    "__attribute__((noinline)) static int unused(const char *t) { return t[0] == '}'; }\n"
    "struct pair { int a, b; } both = { 1, 2 };\n"
    "int increment (int a) { return add(a) + 1 + 0 * unused(\"}\"); }\n"
    "int\n"
    "twice( int a ) /* twice(int a) { */ {\n"
    "    if (a) { return 99; } return 98;\n"
    "}\n"
    "int half(int a){return add(a)+33;}";

/* The reference's helper in the same words, but below the function. */
static const char *const disordered =
    "static int add(int a, int b);\n"
    "int twice(int a) { return add(a, 1); }\n"
    "int increment(int a) { return add(a, 1) ; }\n"
    "int half(int a) { return a; }\n"
    "static int\nadd(int a, int b)\n{\n    const char brace = '{', *quote = \"}\\\"{\";\n"
    "    return a + /* and */ b + (brace == quote[0]);\n}\n";

static const char *const values =
    "#include \"chapters/2.3_a/a.h\"\n#include <stdio.h>\n"
    "void exercise_todo(const char *id);\n"
    "void exercise_todo(const char *id) { puts(id); }\n"
    "int main(void) { printf(\"%d %d %d\\n\", twice(7), half(14), increment(3)); return 0; }\n";

static void
exercises_are_put_into_a_students_file(void)
{
    static const struct {
        const char *arguments, *result;
    } spliced[] = {
        {". mine 2.3-a", "14 47 4\n"},
        {". mine 2.3-b", "99 7 4\n"},
        {". mine 2.3-a 2.3-b", "14 7 4\n"},
        {"--only . mine 2.3-a", "99 7 4\n"},
        {"--only . mine 2.3-b", "14 47 4\n"},
    };
    char command[500];
    plant("tools_handout");
    run("mkdir -p mine/chapters/2.3_a");
    write_file("mine/chapters/2.3_a/a.c", student);
    write_file("values.c", values);
    for (size_t k = 0; k < sizeof spliced / sizeof *spliced; k++) {
        CLAIM("splice", run_tool("splice", spliced[k].arguments) == 0, "%s", said);
        write_file("spliced.c", said);
        snprintf(command, sizeof command, "cc -I. spliced.c values.c -o values && ./values");
        CLAIM("splice", run(command) == 0 && strcmp(said, spliced[k].result) == 0,
              "splice %s: %s", spliced[k].arguments, said);
    }
    write_file("mine/chapters/2.3_a/a.c", disordered);
    run_tool("splice", ". mine 2.3-a");
    write_file("spliced.c", said);
    CLAIM("splice.order", run("cc -Werror -I. spliced.c values.c -o values && ./values") == 0
          && strcmp(said, "14 14 4\n") == 0, "%s", said);
    write_file("mine/chapters/2.3_a/a.c", "int half(int a) { return a; }\n");
    CLAIM("splice.missing", run_tool("splice", ". mine 2.3-a") == 1 &&
          strstr(said, "no function twice"), "%s", said);
    write_file("mine/chapters/2.3_a/a.c", "int half(int a) { return a;\n");
    CLAIM("splice.brackets", run_tool("splice", ". mine 2.3-b") == 1 &&
          strstr(said, "brackets do not match"), "%s", said);
}

/* ---- The project. ---- */

/* Each week and each section: whatever can be seen without compiling. */
static void
nothing_of_a_solution_is_left_in_any_week(void)
{
    char command[12000];
    must(chdir(root) == 0, root);
    snprintf(command, sizeof command,
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
    test_run("students get points for what is right", students_get_points_for_what_is_right);
    test_run("students have questions of their own", students_have_questions_of_their_own);
    test_run("missing checks are reported", missing_checks_are_reported);
    test_run("variants are told", variants_are_told);
    test_run("exercises are put into a student's file",
             exercises_are_put_into_a_students_file);
    test_run("nothing of a solution is left in any week",
             nothing_of_a_solution_is_left_in_any_week);
    test_run("pages list the exercises", pages_list_the_exercises);
    return test_end((test_minima){.trials = 12});
}
