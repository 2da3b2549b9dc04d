/* splice puts single exercises of the reference into a student's file, or of a
 * student's into the reference's, with what they need and nothing else.
 *
 * Hypotheses: the programs are built, as `make test` does.
 */
#include "tests/harness/small_project.h"

#include <string.h>

/* A student's file in a style of its own, with names of the reference that mean
 * something else. */
static const char *const student =
    "#include \"chapters/2.3_a/a.h\"\n"
    "#if 0\n"
    "int twice(int a) { none\n"
    "#endif\n"
    "static int add(int a) { return a; } /* } */ // {\n"
    "__attribute__((noinline)) static int unused(const char *t) { return t[0] == '}'; "
    "}\n"
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
    "static int\nadd(int a, int b)\n{\n    const char brace = '{', *quote = "
    "\"}\\\"{\";\n"
    "    return a + /* and */ b + (brace == quote[0]);\n}\n";

static const char *const values =
    "#include \"chapters/2.3_a/a.h\"\n#include <stdio.h>\n"
    "void exercise_todo(const char *id);\n"
    "void exercise_todo(const char *id) { puts(id); }\n"
    "int main(void) { printf(\"%d %d %d\\n\", twice(7), half(14), increment(3)); "
    "return 0; }\n";

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
    plant("tools_splice");
    run("mkdir -p mine/chapters/2.3_a");
    write_file("mine/chapters/2.3_a/a.c", student);
    write_file("values.c", values);
    for (size_t k = 0; k < sizeof spliced / sizeof *spliced; k++) {
        CLAIM("splice", run_tool("splice", spliced[k].arguments) == 0, "%s", said);
        write_file("spliced.c", said);
        snprintf(command, sizeof command,
                 "cc -I. spliced.c values.c -o values && ./values");
        CLAIM("splice", run(command) == 0 && strcmp(said, spliced[k].result) == 0,
              "splice %s: %s", spliced[k].arguments, said);
    }
    write_file("mine/chapters/2.3_a/a.c", disordered);
    run_tool("splice", ". mine 2.3-a");
    write_file("spliced.c", said);
    CLAIM("splice.order",
          run("cc -Werror -I. spliced.c values.c -o values && ./values") == 0 &&
              strcmp(said, "14 14 4\n") == 0,
          "%s", said);
    write_file("mine/chapters/2.3_a/a.c", "int half(int a) { return a; }\n");
    CLAIM("splice.missing", run_tool("splice", ". mine 2.3-a") == 1 &&
          strstr(said, "no function twice"), "%s", said);
    write_file("mine/chapters/2.3_a/a.c", "int half(int a) { return a;\n");
    CLAIM("splice.brackets", run_tool("splice", ". mine 2.3-b") == 1 &&
          strstr(said, "brackets do not match"), "%s", said);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "splice: exercises of the reference in a student's file");
    tools_begin(argv);
    test_run("exercises are put into a student's file",
             exercises_are_put_into_a_students_file);
    return test_end((test_minima){.trials = 1});
}
