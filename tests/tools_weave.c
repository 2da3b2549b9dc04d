/* The tools that bind text and code: weave, say.sh, deps and check.sh find whatever is
 * not true.
 *
 * Each trial plants a small project in a folder of its own, damages one thing, and
 * wants the damage to be named with file and line. And the example of the first page
 * does what it says.
 *
 * Hypotheses: the programs are built, as `make test` does.
 */
#include "chapters/3.5_edge_flips/flips.h"
#include "tests/harness/harness.h"
#include "tests/harness/tools.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- A small project. ---- */

static const char *const source =
    "/* a.c - a source. */\n"
    "#include \"chapters/2.3_a/a.h\"\n"
    "#define TWICE(x) \\\n"
    "    ((x) + (x))\n"
    "\n"
    "typedef struct pair {\n"
    "    int left, right;\n"
    "} pair;\n"
    "\n"
    "/* Adds. */\n"
    "static int\n"
    "add(int a, int b)\n"
    "{\n"
    "    while (a > 0) { // Line 1: move\n"
    "        a--;        // Line 2\n"
    "        b++;\n"
    "\n"
    "    } // Line 3\n"
    "    return b; // Line 10\n"
    "}\n";

static const char *const header =
    "/* a.h - its header. Needs: 3.4. */\n"
    "#include \"lib/b.h\"\n"
    "#include \"chapters/3.4_p/p.h\"\n"
    "\n"
    "/* Says what\n"
    " * addition is. */\n"
    "int add(int a,\n"
    "        int b);\n"
    "enum state { ON, OFF };\n";

#define BLOCK "```c\n```\n"
static const char *const page =
    "# A page\n"
    "See [the source](a.c), `chapters/2.3_a/a.c add` and `lib/b.h`.\n"
    "<!-- code: chapters/2.3_a/a.c add -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.c add \"Line 1\" -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.c add \"Line 2\" -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.c pair -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.c TWICE -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.h add -->\n" BLOCK
    "<!-- code: chapters/2.3_a/a.h state -->\n" BLOCK
    "<!-- code: lib/b.h -->\n" BLOCK
    "\n"
    "**fig3.P1.** *It ends.* Because a falls.\n";

static const char *const woven =
    "# A page\n"
    "See [the source](a.c), `chapters/2.3_a/a.c add` and `lib/b.h`.\n"
    "<!-- code: chapters/2.3_a/a.c add -->\n```c\n"
    "static int\nadd(int a, int b)\n{\n"
    "    while (a > 0) { // Line 1: move\n        a--;        // Line 2\n"
    "        b++;\n\n    } // Line 3\n    return b; // Line 10\n}\n```\n"
    "<!-- code: chapters/2.3_a/a.c add \"Line 1\" -->\n```c\n"
    "while (a > 0) { // Line 1: move\n    a--;        // Line 2\n    b++;\n```\n"
    "<!-- code: chapters/2.3_a/a.c add \"Line 2\" -->\n```c\n"
    "a--;        // Line 2\nb++;\n```\n"
    "<!-- code: chapters/2.3_a/a.c pair -->\n```c\n"
    "typedef struct pair {\n    int left, right;\n} pair;\n```\n"
    "<!-- code: chapters/2.3_a/a.c TWICE -->\n```c\n"
    "#define TWICE(x) \\\n    ((x) + (x))\n```\n"
    "<!-- code: chapters/2.3_a/a.h add -->\n```c\n"
    "/* Says what\n * addition is. */\nint add(int a,\n        int b);\n```\n"
    "<!-- code: chapters/2.3_a/a.h state -->\n```c\n"
    "enum state { ON, OFF };\n```\n"
    "<!-- code: lib/b.h -->\n```c\n"
    "/* b.h */\n```\n"
    "\n"
    "**fig3.P1.** *It ends.* Because a falls.\n";

static void
read_file(const char *path, char *bytes, size_t room)
{
    FILE *file = fopen(path, "r");
    must(file != NULL, path);
    bytes[fread(bytes, 1, room - 1, file)] = '\0';
    fclose(file);
}

/* Enters the folder of the small project, with all its files as they should be. */
static void
plant(void)
{
    char folder[2200];
    snprintf(folder, sizeof folder, "%s/tools_weave.tree", build);
    mkdir(folder, 0777);
    must(chdir(folder) == 0, folder);
    static const char *const folders[] = {
        "lib", "docs", "tests", "tools", "chapters", "chapters/2.3_a", "chapters/3.4_p",
    };
    for (size_t k = 0; k < sizeof folders / sizeof *folders; k++)
        mkdir(folders[k], 0777);
    write_file("lib/b.h", "/* b.h */\n");
    write_file("chapters/3.4_p/p.h", "/* p.h */\n");
    write_file("chapters/2.3_a/a.h", header);
    write_file("chapters/2.3_a/a.c", source);
    write_file("chapters/2.3_a/README.md", page);
    write_file("README.md", "# All\n[a](chapters/2.3_a/README.md)\n");
    write_file("tests/2.3_a.c",
               "CLAIM(\"fig3.P1\", 1, \"\");\nCLAIM(\n  \"E10\", 1, \"\");\n");
    write_file("docs/errata.md",
               "| E10 | 2.3 | `tests/2.3_a.c` |\n| E11 | 2.3 | planned |\n");
    write_file("docs/glossary.md", "| add, `add` | plus | sum |\n");
    write_file("docs/notes_map.md",
               "| F3 | 2.3 | x | `chapters/2.3_a/a.c add` | `tests/2.3_a.c` | - | "
               "stands |\n"
               "| F4 | 3.1 | x | `lib/nothing.c` | - | - | planned |\n");
}

static int
run_check(void)
{
    char command[4000];
    snprintf(command, sizeof command, "'%s/tools/check.sh' '%s'", root, build);
    return run(command);
}

/* ---- weave. ---- */

static void
quotes_are_what_the_source_says(void)
{
    char bytes[5000];
    plant();
    CLAIM("weave.drift", run_tool("weave", "--check") == 1, "empty quotes pass");
    read_file("chapters/2.3_a/README.md", bytes, sizeof bytes);
    CLAIM("weave.check_only", strcmp(bytes, page) == 0, "--check has changed the page");

    CLAIM("weave.quotes", run_tool("weave", "") == 0, "%s", said);
    read_file("chapters/2.3_a/README.md", bytes, sizeof bytes);
    CLAIM("weave.quotes", strcmp(bytes, woven) == 0, "the page became:\n%s", bytes);
    CLAIM("weave.quotes", run_tool("weave", "--check") == 0, "%s", said);
    CLAIM("weave.twice", run_tool("weave", "") == 0 && said[0] == '\0', "%s", said);
}

/* Changes each letter of the function, and each byte of its quote, one at a time. */
static void
every_drift_is_found(void)
{
    char bytes[5000];
    plant();
    run_tool("weave", "");
    snprintf(bytes, sizeof bytes, "%s", source);
    for (char *at = strstr(bytes, "static int"); *at != '\0'; at++) {
        char was = *at;
        if (was == '\n')
            continue;
        *at = was == 'x' ? 'y' : 'x';
        write_file("chapters/2.3_a/a.c", bytes);
        CLAIM("weave.drift", run_tool("weave", "--check") == 1, "nobody saw:\n%s",
              bytes);
        *at = was;
    }
    write_file("chapters/2.3_a/a.c", source);
    snprintf(bytes, sizeof bytes, "%s", woven);
    char *quote = strstr(bytes, "static int");
    for (char *at = quote; strncmp(at, "```", 3) != 0; at++) {
        char was = *at;
        *at = was == 'x' ? 'y' : 'x';
        write_file("chapters/2.3_a/README.md", bytes);
        CLAIM("weave.drift", run_tool("weave", "--check") == 1, "nobody saw:\n%s",
              bytes);
        *at = was;
    }
}

/* Pages that cannot be right: the line that must be named, and a word of the reason. */
static void
bad_pages_are_refused(void)
{
    static const struct {
        const char *text, *line, *reason;
        bool only_checked;
    } bad[] = {
        {"\n<!-- code: lib/none.c add -->\n" BLOCK, ":2:", "no file", false},
        {"<!-- code: chapters/2.3_a/a.c ad -->\n" BLOCK, ":1:", "has no ad", false},
        {"<!-- code: chapters/2.3_a/a.c add \"Line 4\" -->\n" BLOCK, ":1:", "0 times",
         false},
        {"<!-- code: chapters/2.3_a/a.c add \"Line\" -->\n" BLOCK, ":1:", "4 times",
         false},
        {"<!-- code: chapters/2.3_a/twice.c add -->\n" BLOCK, ":1:", "lines 1 and 5",
         false},
        {"<!-- code: chapters/2.3_a/a.c add -->\ntext\n", ":1:", "```", false},
        {"\n\n```c\nint x;\n```\n", ":3:", "address", false},
        {"[x](none.c)\n", ":1:", "none.c", true},
        {"![x](figures/none.svg)\n", ":1:", "none.svg", true},
        {"\nSee `lib/none.h` there.\n", ":2:", "lib/none.h", true},
        {"`lib/b.h`, `chapters/2.3_a/a.c subtract`\n", ":1:", "subtract", true},
        {"| x | `tests/none.c` | stands |\n", ":1:", "tests/none.c", true},
    };
    char place[200], bytes[5000];
    plant();
    write_file("chapters/2.3_a/twice.c",
               "void\nadd(void)\n{\n}\nint\nadd(int a)\n{\n}\n");
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        write_file("chapters/2.3_a/README.md", bad[k].text);
        int status = run_tool("weave", "--check");
        snprintf(place, sizeof place, "chapters/2.3_a/README.md%s", bad[k].line);
        CLAIM("weave.bad_pages", status == 1 && strstr(said, place) &&
              strstr(said, bad[k].reason), "%s is answered by: %s", bad[k].text, said);
        status = run_tool("weave", "");
        CLAIM("weave.bad_pages", status == !bad[k].only_checked, "%s", said);
        read_file("chapters/2.3_a/README.md", bytes, sizeof bytes);
        CLAIM("weave.bad_pages", strcmp(bytes, bad[k].text) == 0, "became %s", bytes);
    }
    unlink("chapters/2.3_a/twice.c");
}

/* ---- say.sh: the steps of an algorithm, as text. ---- */

static int
run_say(const char *argument)
{
    char command[4000];
    snprintf(command, sizeof command, "'%s/tools/book/say.sh' '%s' %s", root, build,
             argument);
    return run(command);
}

static void
steps_are_those_of_the_algorithm(void)
{
    static const char before[] =
        "# A page\n<!-- player: --algorithm sweep chapters/2.3_a/watch.xy -->\n\n"
        "And so on.\n";
    static const char *const parts[] = { /* of the page afterwards, in this order */
        "# A page\n<!-- player: --algorithm sweep chapters/2.3_a/watch.xy -->\n\n",
        "<details><summary>The 3 steps as text</summary>\n\n", "1. Line 2: ", "0-1",
        "\n2. Line 4: ", "0-1", "\n3. Line 5: ", "0-1",
        "\n\n</details>\n\nAnd so on.\n",
    };
    char bytes[5000];
    plant();
    write_file("chapters/2.3_a/README.md", before);
    write_file("chapters/2.3_a/watch.xy", "0 0\n1 0\n1 1\n");
    CLAIM("say.drift", run_say("--check") == 1 &&
          strstr(said, "chapters/2.3_a/README.md:4:"), "no list: %s", said);
    read_file("chapters/2.3_a/README.md", bytes, sizeof bytes);
    CLAIM("say.check_only", strcmp(bytes, before) == 0, "--check has changed the page");
    CLAIM("say.steps", run_say("") == 0, "%s", said);
    read_file("chapters/2.3_a/README.md", bytes, sizeof bytes);
    const char *at = bytes;
    for (size_t k = 0; k < sizeof parts / sizeof *parts && at != NULL; k++) {
        at = strstr(at, parts[k]);
        at = at == NULL ? NULL : at + strlen(parts[k]);
    }
    CLAIM("say.steps", at != NULL && *at == '\0', "the page became:\n%s", bytes);
    CLAIM("say.twice", run_say("") == 0 && said[0] == '\0', "%s", said);
    CLAIM("say.twice", run_say("--check") == 0, "%s", said);

    write_file("chapters/2.3_a/watch.xy", "0 0\n1 0\n1 -1\n");
    CLAIM("say.drift", run_say("--check") == 1 &&
          strstr(said, "chapters/2.3_a/README.md:6:"), "other points: %s", said);
    unlink("chapters/2.3_a/watch.xy");
    CLAIM("say.unusable", run_say("--check") == 2 && strstr(said, "watch.xy"), "%s",
          said);
}

/* ---- deps. ---- */

static void
forbidden_includes_are_found(void)
{
    static const struct {
        const char *path, *line, *reason; /* no reason: it is allowed */
    } include[] = {
        {"lib/b.h", "\"chapters/2.3_a/a.h\"", "lib knows no chapter"},
        {"lib/b.h", "\"tests/t.h\"", "lib knows no"},
        {"lib/b.h", "<unistd.h>", "pure C11"},
        {"lib/b.h", "<stdio.h>", NULL},
        {"lib/b.h", "\"lib/b.h\"", "circle"},
        {"chapters/2.3_a/a.h", "\"b.h\"", "from the root"},
        {"chapters/2.3_a/a.h", "\"chapters/2.3_a/figures.c\"",
         "figures.c is a program"},
        {"chapters/2.3_a/a.h", "\"tests/t.h\"", "no test"},
        {"chapters/2.3_a/a.h", "\"chapters/3.1_v/v.h\"", "earlier"},
        {"chapters/2.3_a/a.h", "\"chapters/3.4_p/p.h\"", "Needs: 3.4"},
        {"chapters/2.3_a/figures.c", "\"chapters/3.1_v/v.h\"", NULL},
        {"chapters/3.1_v/v.h", "\"chapters/2.3_a/a.h\"", NULL},
        {"tests/t.h", "<unistd.h>", NULL},
        {"tests/t.h", "\"chapters/3.1_v/v.h\"", NULL},
    };
    plant();
    mkdir("chapters/3.1_v", 0777);
    for (size_t k = 0; k < sizeof include / sizeof *include; k++) {
        plant();
        write_file("chapters/2.3_a/figures.c", "int x;\n");
        write_file("chapters/3.1_v/v.h", "/* v.h */\n");
        write_file("tests/t.h", "/* t.h */\n");
        CLAIM("deps.clean", run_tool("deps", "") == 0, "%s", said);

        char text[300], place[200];
        snprintf(text, sizeof text, "/* x */\n#include %s\n", include[k].line);
        snprintf(place, sizeof place, "%s:", include[k].path);
        write_file(include[k].path, text);
        int status = run_tool("deps", "");
        const char *reason = include[k].reason;
        bool named = reason != NULL && strstr(said, place) && strstr(said, reason);
        CLAIM("deps.rules", status == (reason ? 1 : 0) && named == (reason != NULL),
              "%s: %s%s", include[k].path, text, said);
    }
    unlink("chapters/2.3_a/figures.c");
    unlink("chapters/3.1_v/v.h");
    unlink("tests/t.h");
}

/* ---- check.sh. ---- */

static void
broken_promises_are_found(void)
{
    static const struct {
        const char *path, *text, *reason;
    } broken[] = {
        {"chapters/2.3_a/README.md", "No claim.\n", "fig3.P1 stands on no page"},
        {"chapters/2.3_a/README.md", "**fig3.P1** (argued). x\n", "drop (argued)"},
        {"chapters/2.3_a/README.md", "**fig3.P1.** x\n\n- **fig3.P2.** y\n",
         "README.md:3: fig3.P2 is asserted by no test"},
        {"chapters/2.3_a/README.md", "**fig3.P1.** x\n\n**fig3.P1.** y\n",
         "number it anew"},
        {"tests/2.3_a.c",
         "CLAIM(\"fig3.P1\",\nCLAIM(\"E10\",\nclaim_verdict(\"E12\", v);\n",
         "tests/2.3_a.c:3: E12 has no row"},
        {"tests/2.3_a.c", "CLAIM(\"fig3.P1\", 1, \"\");\n",
         "docs/errata.md:1: E10 is not asserted in tests/2.3_a.c"},
        {"tests/2.3_a.c", "CLAIM(\"fig3.P1\",\nCLAIM(\"E10\",\nCLAIM(\"E11\",",
         "docs/errata.md:2: E11 is asserted in tests/2.3_a.c"},
        {"docs/glossary.md", "| sub, `subtract` | x | x |\n",
         "glossary.md:1: no header"},
        {"docs/notes_map.md", "| F3 | 2.3 | x | - | `tests/2.3_a.c` | - | stands |\n",
         "F3 stands, but without code"},
        {"docs/notes_map.md", "| F3 | 2.3 | x | - | `tests/2.3_a.c` | - | done |\n",
         "the status is"},
        {"docs/notes_map.md", "| F3 | 2.3 | `tests/2.3_a.c` | - | - | - | planned |\n"
         "| F3 | 2.3 | x | - | - | - | planned |\n",
         "notes_map.md:2: the id F3 stands twice"},
        {"docs/errata.md", "| E10 | `tests/2.3_a.c` |\n| E10 | planned |\n",
         "errata.md:2: the number E10 stands twice"},
        {"docs/notes_map.md", "| F3 | 2.3 | x | `tests/2.3_a.c` | stands |\n",
         "seven cells"},
        {"docs/notes_map.md", "| F3 | 2.3 | x | - | - | - | planned |\n",
         "tests/2.3_a.c is in no row"},
    };
    plant();
    run_tool("weave", "");
    run_check();
    CLAIM("check.clean",
          strstr(said, "ok     - each claim") && strstr(said, "ok     - each err") &&
              strstr(said, "ok     - the map") && strstr(said, "ok     - the names"),
          "%s", said);
    for (size_t k = 0; k < sizeof broken / sizeof *broken; k++) {
        plant();
        write_file(broken[k].path, broken[k].text);
        int status = run_check();
        CLAIM("check.promises", status == 1 && strstr(said, broken[k].reason),
              "%s with %s is answered by %s", broken[k].path, broken[k].text, said);
    }
}

/* ---- The example on the first page. ---- */

static void
example_is_delaunay(void)
{
    const point2 points[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}};
    vertex_id corner[20][3];
    triangle_list list = {0, corner};
    verdict v = verdict_holds();
    CLAIM("example", run_tool("example", "") == 0, "%s", said);
    char *line = strtok(said, "\n");
    for (; line && list.count < 20; line = strtok(NULL, "\n")) {
        vertex_id *c = corner[list.count++];
        CLAIM("example", sscanf(line, "%u %u %u", &c[0], &c[1], &c[2]) == 3, "%s",
              line);
    }
    CLAIM("example", is_delaunay(points, 5, list, &v) == TRI_OK, "no memory");
    claim_verdict("example", v);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "the tools: text and code are bound, and cannot drift");
    tools_begin(argv);

    test_run("quotes are what the source says", quotes_are_what_the_source_says);
    test_run("every drift is found", every_drift_is_found);
    test_run("pages that cannot be right are refused", bad_pages_are_refused);
    test_run("steps are those of the algorithm", steps_are_those_of_the_algorithm);
    test_run("forbidden includes are found", forbidden_includes_are_found);
    test_run("broken promises are found", broken_promises_are_found);
    test_run("the example of the first page is Delaunay", example_is_delaunay);
    return test_end((test_minima){.trials = 7});
}
