/* The command tri flipgraph prints the numbers of the flip graph, draws it if
 * it is small, and refuses what is too large without harm. */
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <string.h>

/* Runs `tri flipgraph ARGUMENTS`, and claims its exit status and what it
 * prints. */
static void
run(const char *arguments, int expected, const char *output)
{
    int status = shell("$tri flipgraph %s >$d/out 2>$d/err", arguments);
    CLAIM("flipgraph.status", status == expected,
          "tri flipgraph %s: exit status %d: %s", arguments, status,
          read_scratch("err").text);
    CLAIM("flipgraph.output", strcmp(read_scratch("out").text, output) == 0,
          "tri flipgraph %s: %s", arguments, read_scratch("out").text);
}

static void
numbers_are_printed(void)
{
    shell("printf '0 0\\n1 0\\n1 1\\n0 1\\n' >$d/square.xy");
    run("$d/square.xy", 0,
        "triangulations 2\nflip edges 1\ndiameter 1\ndelaunay 2\n");
    shell("awk 'BEGIN { for (i = 0; i < 9; i++) print i %% 3, int(i / 3) }' "
          ">$d/3x3.xy");
    run("- <$d/3x3.xy", 0,
        "triangulations 64\nflip edges 132\ndiameter 8\ndelaunay 16\n");
    shell("printf '1 1\\n2 2\\n0 0\\n1 1\\n' >$d/line.xy");
    run("$d/line.xy", 0,
        "triangulations 1\nflip edges 0\ndiameter 0\ndelaunay 1\n");
    /* The fourth point lies just right of the line between the third and the
     * last. */
    shell("printf '1e308 0\\n-1e308 0\\n0 1e308\\n5e-324 0\\n0 -1e308\\n' "
          ">$d/huge.xy");
    run("$d/huge.xy --svg $d/huge.svg", 0,
        "triangulations 2\nflip edges 1\ndiameter 1\ndelaunay 1\n");
    /* More than 50,000: the true diameter of the 13-gon is 16. */
    shell("awk 'BEGIN { for (i = 0; i < 13; i++) print i, i * i }' >$d/13.xy");
    run("$d/13.xy", 0,
        "triangulations 58786\nflip edges 293930\ndiameter at least 16\n"
        "delaunay 1\n");
}

static void
small_graphs_are_drawn(void)
{
    shell("awk 'BEGIN { for (i = 0; i < 6; i++) print i, i * i }' >$d/6.xy");
    run("--svg $d/6.svg $d/6.xy", 0,
        "triangulations 14\nflip edges 21\ndiameter 4\ndelaunay 1\n");
    int segments =
        shell("test $(grep -o 'class=\"new\"' $d/6.svg | wc -l) -eq 21");
    CLAIM("flipgraph.svg", segments == 0, "not 21 flips in the picture");
    int pictures =
        shell("test $(grep -c 'class=\"plain\"' $d/6.svg) -eq $((13 * 9)) &&"
              "test $(grep -c 'class=\"strong\"' $d/6.svg) -eq 9");
    CLAIM("flipgraph.svg", pictures == 0,
          "not 13 triangulations of 9 edges, and one "
          "that is Delaunay");
}

static void
too_much_is_refused(void)
{
    shell("awk 'BEGIN { for (i = 0; i < 16; i++) print i, i * i }' >$d/16.xy");
    run("$d/16.xy", 2, "");
    CLAIM("flipgraph.limit", one_line("err") && has("err", "more than 1000000"),
          "%s", read_scratch("err").text);
    shell("awk 'BEGIN { for (i = 0; i < 65; i++) print i, i }' >$d/65.xy");
    run("$d/65.xy", 2, "");
    CLAIM("flipgraph.limit", one_line("err") && has("err", "at most 64"), "%s",
          read_scratch("err").text);
    shell("awk 'BEGIN { for (i = 0; i < 8; i++) print i, i * i }' >$d/8.xy");
    run("--svg $d/8.svg $d/8.xy", 2, "");
    CLAIM("flipgraph.limit",
          one_line("err") && has("err", "132 triangulations are too"), "%s",
          read_scratch("err").text);
    CLAIM("flipgraph.limit", shell("test ! -e $d/8.svg") == 0,
          "a picture is left");
    run("--svg - $d/8.xy", 2, "");
    run("$d/none.xy", 2, "");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "tri flipgraph: the numbers, a picture, the limits");
    test_run("numbers are printed", numbers_are_printed);
    test_run("small graphs are drawn", small_graphs_are_drawn);
    test_run("too much is refused", too_much_is_refused);
    int status = test_end((test_minima){.trials = 3});
    shell_end();
    return status;
}
