/* The benchmark says what it has seen, of peers that crash, hang, talk nonsense
 * or are wrong, too, and these do not end it. Its certificates refuse wrong answers.
 *
 * Hypotheses: none on times, which are only asked to be there. The peers here
 * are scripts of the shell.
 */
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"
#include "tools/bench/certify.h"

#include <stdio.h>
#include <string.h>

static void
make_peer(const char *name, const char *script)
{
    int status =
        shell("mkdir -p $d/peers && printf '#!/bin/sh\\n%s\\n' >$d/peers/%s && "
              "chmod +x $d/peers/%s",
              script, name, name);
    CLAIM("bench.setup", status == 0, "the peer %s cannot be made", name);
}

/* The line of $d/out that begins with two blanks and the name, or "". */
static content
line_of(const char *name)
{
    content line;
    shell("grep '^  %s ' $d/out >$d/line", name);
    line = read_scratch("line");
    return line;
}

/* The line of bench.csv for the name, or "". */
static content
row_of(const char *name)
{
    shell("grep ',%s,' $d/bench.csv >$d/line", name);
    return read_scratch("line");
}

static void
peers_do_what_they_want(void)
{
    make_peer("crash", "kill -SEGV $$");
    make_peer("hang", "while :; do :; done");
    make_peer("nonsense", "echo I am faster than all others");
    make_peer("silent", "exit 0");
    make_peer("wrong",
              "echo 0.001 0.001 0.001 1000 0 wrong: a triangle is missing");
    make_peer("instant",
              "echo 0 0 0.001 1000 1 Delaunay"); /* clocks may tick slowly */
    make_peer("good", "echo 0.001 0.001 0.001 160000 1 Delaunay");
    int status = shell(
        "$build/bench/bench -r 1 -t 1 -o $d uniform 1000 sweep fast "
        "crash hang nonsense silent wrong instant good >$d/out 2>$d/err");
    CLAIM("bench.goes_on", status == 0, "exit status %d: %s", status,
          read_scratch("err").text);
    static const char *const expected[][2] =
        {{"crash", "failed"},      {"hang", "stopped at the limit"},
         {"nonsense", "failed"},   {"silent", "failed"},
         {"instant", "Delaunay"},  {"wrong", "wrong: a triangle is missing"},
         {"good", "160 Delaunay"}, {"sweep", "triangulation"},
         {"fast", "Delaunay"},     {"yardstick", "sorted"}};
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const char *name = expected[i][0];
        content line = line_of(name);
        /* the columns are as wide as their numbers: one blank will do */
        CLAIM("bench.says",
              strstr(line.text, expected[i][1]) != NULL ||
                  (strcmp(name, "good") == 0 &&
                   strstr(line.text, "160  Delaunay") != NULL),
              "%s: \"%s\" is not in: %s", name, expected[i][1], line.text);
        CLAIM("bench.csv", row_of(name).text[0] != '\0', "no row for %s", name);
    }
    CLAIM("bench.marks", shell("grep '^uniform .*!' $d/out >/dev/null") == 0,
          "a wrong answer is not marked in the summary");
    CLAIM("bench.plots",
          shell("grep -q '</svg>' $d/growth.svg && "
                "grep -q '</svg>' $d/ratios.svg") == 0,
          "no plots");
    CLAIM("bench.aims", !has("out", "PASS") && !has("out", "FAIL"),
          "aims are looked at, and nobody has asked");
}

/* The ratios in the file are those of the times beside them. */
static void
ratios_are_ratios(void)
{
    int status = shell("$build/bench/bench -r 2 -o $d grid circle 200 divide "
                       ">$d/out 2>$d/err");
    CLAIM("bench.goes_on", status == 0, "exit status %d", status);
    status = shell(
        "awk -F, 'NR > 1 && $3 == \"yardstick\" { least[$1, $2] = $6 }"
        "$3 == \"divide\" { rows++; r = $6 / least[$1, $2] / $12;"
        "  if ($7 < $6 || $5 != 2 || r < 0.99 || r > 1.01) bad = 1 }"
        "END { exit bad || rows != 2 }' $d/bench.csv");
    CLAIM("bench.ratios", status == 0, "%s", read_scratch("bench.csv").text);
}

/* A quadrangle with each of its diagonals, of which the short one, 1-3, is Delaunay,
 * and with half of it; points in order, and not. */
static void
wrong_answers_are_refused(void)
{
    const point2 at[] = {{0, 0}, {3, -1}, {6, 0}, {3, 1}};
    const point2 line[] = {{0, 0}, {0, 1}, {0, 0}};
    vertex_id good[][3] = {{0, 1, 3}, {1, 2, 3}}, bad[][3] = {{0, 1, 2}, {0, 2, 3}};
    const struct {
        const char *what;
        answer given;
        bool right;
        const char *text;
    } asked[] = {
        {"the Delaunay triangulation",
         certify_triangles(at, 4, (triangle_list){2, good}, true), true, "Delaunay"},
        {"the other diagonal", certify_triangles(at, 4, (triangle_list){2, bad}, true),
         false, "wrong: "},
        {"the other diagonal, not said to be Delaunay",
         certify_triangles(at, 4, (triangle_list){2, bad}, false), true,
         "triangulation"},
        {"one triangle only", certify_triangles(at, 4, (triangle_list){1, good}, false),
         false, "wrong: "},
        {"two points", certify_sorted(line, 2), true, "sorted"},
        {"a point after a larger one", certify_sorted(line, 3), false,
         "wrong: point 2"},
    };
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++)
        CLAIM("bench.certifies",
              asked[i].given.right == asked[i].right &&
                  strncmp(asked[i].given.text, asked[i].text, strlen(asked[i].text)) ==
                      0,
              "%s: %s", asked[i].what, asked[i].given.text);
}

static void
wrong_words_are_explained(void)
{
    static const char *const words[] = {"lumpy", "0",  "-r 0",
                                        "-r x",  "-z", "-t"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        int status = shell("$build/bench/bench -o $d %s >$d/out 2>$d/err",
                           words[i]);
        CLAIM("bench.usage", status == 2 && has("err", "--help"),
              "%s: status %d: %s", words[i], status, read_scratch("err").text);
    }
    int status = shell("$build/bench/bench --help >$d/out");
    CLAIM("bench.usage",
          status == 0 && has("out", "usage: bench") && has("out", "near-line"),
          "--help: status %d", status);
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "bench says what it has seen");
    test_run("peers do what they want", peers_do_what_they_want);
    test_run("ratios are ratios", ratios_are_ratios);
    test_run("wrong answers are refused", wrong_answers_are_refused);
    test_run("wrong words are explained", wrong_words_are_explained);
    int status = test_end((test_minima){.trials = 4});
    shell_end();
    return status;
}
