/* The commands tri emst, gabriel, rng and nng write the edges of the graphs
 * of 3.2.
 *
 * They are driven as people drive them. Needed: the program
 * (tests/harness/shell.h).
 */
#include "chapters/3.2_empty_circumcircle/graphs.h"
#include "lib/textio.h"
#include "tests/harness/shell.h"
#include "tests/harness/start.h"

#include <string.h>

typedef tri_status graph_of(const mesh *m, const point2 *points,
                            edge_list *out);

static const char *const commands[] = {"emst", "gabriel", "rng", "nng"};
static graph_of *const functions[] = {
    emst, gabriel_graph, relative_neighbourhood_graph, nearest_neighbour_graph};

/* The file holds the edges that the library finds in any Delaunay
 * triangulation. */
static void
files_hold_the_graphs(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    FILE *file = fopen(in_scratch("in.node").text, "wb");
    CLAIM("tri.graphs", file != NULL, "no file can be written");
    text_write_points(file, points, n, 1);
    fclose(file);
    text_points in = {n, 1, NULL};
    mesh m = random_delaunay(points, n);
    for (int which = 0; which < 4; which++) {
        edge_list written, expected;
        text_error error;
        int status = shell("$tri %s -o $d/out.edge $d/in.node 2>$d/err",
                           commands[which]);
        CLAIM("tri.graphs", status == 0, "%s: exit status %d", commands[which],
              status);
        CLAIM("tri.graphs",
              text_read_edges(in_scratch("out.edge").text, &in, &written,
                              &error) == TRI_OK,
              "line %lu: %s", error.line, error.text);
        CLAIM("tri.graphs", functions[which](&m, points, &expected) == TRI_OK,
              "out of memory");
        CLAIM("tri.graphs", written.count == expected.count,
              "%s: %u edges, not %u", commands[which], written.count,
              expected.count);
        for (uint32_t i = 0; i < written.count; i++)
            CLAIM("tri.graphs",
                  written.ends[i][0] == expected.ends[i][0] &&
                      written.ends[i][1] == expected.ends[i][1],
                  "%s: edge %u is %u %u", commands[which], i,
                  written.ends[i][0], written.ends[i][1]);
        edge_list_free(&written);
        edge_list_free(&expected);
    }
    mesh_free(&m);
}

static void
expect_text(const char *command, const char *text)
{
    int status = shell("%s >$d/out 2>$d/err", command);
    content out = read_scratch("out");
    CLAIM("tri.graphs", status == 0 && strcmp(out.text, text) == 0,
          "%s: exit status %d: %s%s", command, status, out.text,
          read_scratch("err").text);
}

static void
known_files(void)
{
    shell("printf '0 0\\n1 0\\n1 1\\n0 1\\n1 1\\n' >$d/square.xy");
    shell("printf '0 0\\n9 9\\n4 4\\n' >$d/line.xy");
    shell("printf '2 3\\n' >$d/one.xy");
    expect_text("$tri emst $d/square.xy", "3 0\n0 0 1\n1 0 3\n2 1 2\n");
    CLAIM("tri.graphs", has("err", "1 of 5 points") && one_line("err"), "%s",
          read_scratch("err").text);
    expect_text("$tri gabriel $d/square.xy",
                "4 0\n0 0 1\n1 0 3\n2 1 2\n3 2 3\n");
    expect_text("$tri rng - <$d/line.xy", "2 0\n0 0 2\n1 1 2\n");
    expect_text("$tri nng $d/line.xy", "2 0\n0 0 2\n1 1 2\n");
    CLAIM("tri.graphs", !has("err", "tri"), "%s", read_scratch("err").text);
    expect_text("$tri emst $d/one.xy", "0 0\n");
}

static void
refusals_leave_old_files(void)
{
    shell("printf 'old\\n' >$d/old.edge");
    shell("printf '0 0\\n1 x\\n' >$d/wrong.xy");
    for (int which = 0; which < 4; which++) {
        CLAIM("tri.graphs",
              shell("$tri %s -o $d/old.edge $d/wrong.xy 2>$d/err",
                    commands[which]) == 2 &&
                  has("err", "wrong.xy:2:"),
              "%s", read_scratch("err").text);
        CLAIM("tri.graphs", strcmp(read_scratch("old.edge").text, "old\n") == 0,
              "%s has replaced the file", commands[which]);
        CLAIM("tri.graphs",
              shell("$tri %s -o $d $d/square.xy 2>$d/err", commands[which]) ==
                      2 &&
                  has("err", "it is a folder"),
              "%s", read_scratch("err").text);
        CLAIM("tri.graphs",
              shell("$tri %s 2>$d/err", commands[which]) == 2 &&
                  has("err", "usage: tri "),
              "%s", read_scratch("err").text);
    }
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv,
               "tri emst, gabriel, rng, nng write the graphs of 3.2");
    test_random("files hold the graphs", files_hold_the_graphs, 100, 40);
    test_near_degenerate("files hold the graphs", files_hold_the_graphs, 50,
                         20);
    test_run("known files", known_files);
    test_run("refusals leave old files", refusals_leave_old_files);
    int status = test_end((test_minima){.trials = 150, .largest_n = 30});
    shell_end();
    return status;
}
