/* small_project.h - a project with two exercises and a checker that only counts: for
 * tests of the tools that make a student's tree. Each trial plants it in a folder of
 * its own.
 */
#ifndef TESTS_HARNESS_SMALL_PROJECT_H
#define TESTS_HARNESS_SMALL_PROJECT_H

#include "tests/harness/harness.h"
#include "tests/harness/tools.h"

#include <stdio.h>
#include <unistd.h>

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

/* Enters the folder of the small project, with all its files as they should be. */
static inline void
plant(const char *folder_name)
{
    static char folder[2200], command[12000];
    snprintf(folder, sizeof folder, "%s/%s.tree", build, folder_name);
    snprintf(
        command, sizeof command,
        "rm -rf '%s' && mkdir '%s' && cd '%s' && mkdir -p lib docs out "
        "chapters/2.3_a/figures tools/checks/student tools/handout && "
        "cp -R '%s/tools/handout/student' '%s'/tools/handout/ustar.[ch] tools/handout "
        "&& cp '%s/docs/LICENSE' docs",
        folder, folder, folder, root, root, root);
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
    write_file("tools/checks/checker.h",
               "#include \"lib/one.h\"\nenum { ACCEPT = 42 };\n");
    write_file("tools/checks/checker.c", checker);
    write_file("tools/checks/2.3.c", "#include \"tools/checks/checker.h\"\n");
    write_file("tools/checks/wire.h", "/* wire.h */\n");
    write_file("tools/checks/wire.c", "extern int wire;\n");
    write_file("tools/checks/more.c",
               "#include \"tools/checks/wire.h\"\nextern int more;\n");
    write_file("tools/checks/other.c", "#include \"tests/other.h\"\n");
    write_file("tools/checks/3.1.c", "#include \"tools/checks/checker.h\"\n");
    write_file("tools/checks/student/driver.c", driver);
    write_file("tools/checks/student/2.3.c", "extern int more;\n");
}

#endif
