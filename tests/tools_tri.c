/* The program tri does what `tri help` says, and refuses the rest without harm.
 *
 * What is not asked here: what is in the files that -o can write (tools_formats), and
 * how long it takes.
 */
#define _XOPEN_SOURCE 700 /* posix_openpt */
#include "lib/textio.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <fcntl.h>
#include <glob.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Runs `$tri ARGUMENTS >$d/out 2>$d/err`, and claims its exit status. */
static void
run_tri(int expected, const char *arguments)
{
    int status = shell("$tri %s >$d/out 2>$d/err", arguments);
    CLAIM("tri.status", status == expected, "tri %s: exit status %d, not %d: %s",
          arguments, status, expected, read_scratch("err").text);
}

/* ---- What it does. ---- */

static const char square_1[] = "'4 2 0 0\\n1 0 0\\n2 1 0\\n3 1 1\\n4 0 1\\n'";
static const char square_0[] = "'4 2 0 0\\n0 0 0\\n1 1 0\\n2 1 1\\n3 0 1\\n'";

static void
triangles_are_numbered_like_the_points(void)
{
    CLAIM("tri.setup", shell("printf %s >$d/1.node; printf %s >$d/0.node", square_1,
                             square_0) == 0, "no files can be made");
    run_tri(0, "triangulate -o $d/1.ele $d/1.node");
    run_tri(0, "triangulate -o $d/0.ele $d/0.node");
    content from_1 = read_scratch("1.ele"), from_0 = read_scratch("0.ele");
    CLAIM("tri.first_index", strncmp(from_1.text, "2 3 0\n1 ", 8) == 0 &&
          strstr(from_1.text, "4") != NULL, "from 1: %s", from_1.text);
    CLAIM("tri.first_index", strncmp(from_0.text, "2 3 0\n0 ", 8) == 0 &&
          strstr(from_0.text, "4") == NULL, "from 0: %s", from_0.text);
    run_tri(0, "check --delaunay $d/1.node $d/1.ele");
    run_tri(0, "check --delaunay $d/0.node $d/0.ele");
    run_tri(0, "hull -o $d/1.edge $d/1.node");
    content hull = read_scratch("1.edge");
    CLAIM("tri.hull", strcmp(hull.text, "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n") == 0,
          "the hull of a square: %s", hull.text);
}

/* Every distribution, every algorithm: certified, twice the same bytes, through
 * pipes too. */
static void
results_are_certified_and_reproducible(void)
{
    int status = shell(
        "for dist in $($tri help generate | awk '/^Distributions/ {on=1; next} "
        "    on {print $1}'); do "
        "  $tri generate $dist 60 --seed 5 -o $d/g.node || exit 3; "
        "  for a in $($tri help triangulate | awk '$2 ~ /^[0-9]+\\.[0-9]+$/ "
        "      {print $1 \"=\" $3}'); do "
        "    $tri triangulate --algorithm ${a%%=*} -o $d/g.ele $d/g.node 2>$d/err "
        "      || exit 4; "
        "    $tri triangulate --algorithm ${a%%=*} <$d/g.node >$d/h.ele - 2>$d/err "
        "      || exit 5; "
        "    cmp $d/g.ele $d/h.ele || exit 6; "
        "    $tri check $d/g.node $d/g.ele >$d/out || exit 7; "
        "    case $a in *=Delaunay) "
        "      $tri check --delaunay $d/g.node $d/g.ele >$d/out || exit 8;; esac; "
        "    echo x >>$d/count; "
        "  done; "
        "done; test $(wc -l <$d/count) -ge 22");
    CLAIM("tri.certified", status == 0, "exit status %d (see the test)", status);
}

static void
wrong_triangulations_are_refuted(void)
{
    shell("printf %s >$d/p.node", square_1);
    shell("printf '2 3 0\\n1 1 2 3\\n2 1 2 4\\n' >$d/overlap.ele");
    run_tri(1, "check $d/p.node $d/overlap.ele");
    CLAIM("tri.witness", has("out", "refuted: ") && has("out", "witness: point "),
          "no witness: %s", read_scratch("out").text);
    shell("printf '1 3 0\\n1 1 2 3\\n' >$d/hole.ele");
    run_tri(1, "check $d/p.node $d/hole.ele");
    /* A triangulation, and not Delaunay: 2 lies in the circle of 1 3 4. */
    shell("printf '0 0\\n3 -1\\n6 0\\n3 1\\n' >$d/kite.xy");
    shell("printf '2 3 0\\n0 0 1 2\\n1 0 2 3\\n' >$d/kite.ele");
    run_tri(0, "check $d/kite.xy $d/kite.ele");
    run_tri(1, "check --delaunay $d/kite.xy $d/kite.ele");
    CLAIM("tri.witness", has("out", "witness: point "), "no witness: %s",
          read_scratch("out").text);
}

static void
degenerate_points_are_reported(void)
{
    shell("printf '0 0\\n1 0\\n0 1\\n1 0\\n0 0\\n' >$d/twice.xy");
    run_tri(0, "triangulate -o $d/twice.ele $d/twice.xy");
    CLAIM("tri.duplicates", one_line("err") && has("err", "2 of 5 points"),
          "duplicates: %s", read_scratch("err").text);
    CLAIM("tri.duplicates", strcmp(read_scratch("twice.ele").text,
                                   "1 3 0\n0 0 1 2\n") == 0 ||
          strncmp(read_scratch("twice.ele").text, "1 3 0\n", 6) == 0,
          "triangles: %s", read_scratch("twice.ele").text);
    shell("printf '0 0\\n1 1\\n2 2\\n3 3\\n' >$d/line.xy");
    run_tri(0, "triangulate -o $d/line.ele $d/line.xy");
    CLAIM("tri.collinear", one_line("err") && has("err", "one line") &&
          strcmp(read_scratch("line.ele").text, "0 3 0\n") == 0, "collinear: %s%s",
          read_scratch("err").text, read_scratch("line.ele").text);
    run_tri(0, "hull $d/line.xy");
    CLAIM("tri.collinear", strcmp(read_scratch("out").text,
                                  "3 0\n0 0 1\n1 1 2\n2 2 3\n") == 0,
          "the hull of a line: %s", read_scratch("out").text);
    run_tri(0, "check --delaunay $d/line.xy $d/line.ele");
    for (int n = 0; n < 3; n++) {
        char arguments[200];
        snprintf(arguments, sizeof arguments,
                 "generate uniform %d -o $d/few.node", n);
        run_tri(0, arguments);
        run_tri(0, "triangulate -o $d/few.ele $d/few.node");
        CLAIM("tri.few", one_line("err") && has("err", "no triangles") &&
              strcmp(read_scratch("few.ele").text, "0 3 0\n") == 0,
              "%d points: %s", n, read_scratch("err").text);
        run_tri(0, "check --delaunay $d/few.node $d/few.ele");
        run_tri(0, "hull -o $d/few.edge $d/few.node");
        run_tri(0, "draw $d/few.node $d/few.ele -o $d/few.svg");
    }
}

static void
pictures_and_statistics(void)
{
    run_tri(0, "draw docs/data/timezones.csv -o $d/p.svg");
    CLAIM("tri.picture", has("p.svg", "<svg") && has("p.svg", "<title>"),
          "no picture: %.80s", read_scratch("p.svg").text);
    run_tri(0, "triangulate --algorithm sweep --direction 0,1 --svg $d/t.svg "
           "--stats "
           "-o $d/t.ele docs/data/timezones.csv");
    CLAIM("tri.picture", has("t.svg", "<svg"), "no picture");
    const char *const names[] = {"points 312\n", "locations 312\n", "duplicates 0\n",
                                 "hull 14\n", "triangles 608\n", "flips 0\n",
                                 "seconds ", "seconds_to_sort ", "ratio "};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        CLAIM("tri.stats", has("out", names[i]), "no line %s: %s", names[i],
              read_scratch("out").text);
    run_tri(0, "check docs/data/timezones.csv $d/t.ele");
    CLAIM("tri.stats", shell("$build/counted/tri triangulate --algorithm sweep --stats "
                             "docs/data/timezones.csv >$d/out") == 0, "no counts");
    const char *const counts[] = {"\norient2d 1228\n", /* 4u-6-h: page 2.3, P6 */
                                  "\nincircle 0\n", "\norient3d 0\n",
                                  "\ncompare_along ", "\ncompare_distance 0\n",
                                  "\ndot_sign 0\n", "\ndecided_by_signs ",
                                  "\ndecided_by_expansions 0\n",
                                  "\ndecided_by_wide 0\n", "\nzeros "};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
        CLAIM("tri.stats", has("out", counts[i]), "no line %s: %s", counts[i] + 1,
              read_scratch("out").text);
    run_tri(0, "triangulate --algorithm divide --cuts alternating -o $d/a.ele "
               "docs/data/timezones.csv");
    run_tri(0, "triangulate --algorithm divide -o $d/v.ele docs/data/timezones.csv");
    CLAIM("tri.cuts", shell("cmp -s $d/a.ele $d/v.ele") == 1, "--cuts changes nothing");
    run_tri(0, "generate uniform 10000 -o $d/f.node");
    run_tri(0, "triangulate --algorithm fast -o $d/f.ele $d/f.node");
    run_tri(0, "triangulate --algorithm fast --threads 3 -o $d/f3.ele $d/f.node");
    CLAIM("tri.threads", shell("cmp -s $d/f.ele $d/f3.ele") == 0,
          "--threads changes the result");
    run_tri(0,
            "triangulate --algorithm incremental --locator walk --seed 3 -o $d/w.ele "
            "docs/data/timezones.csv");
    run_tri(0, "triangulate --algorithm incremental --locator history --seed 3 -o "
               "$d/h.ele docs/data/timezones.csv");
    run_tri(0, "check --delaunay docs/data/timezones.csv $d/h.ele");
    run_tri(0, "triangulate --algorithm incremental --seed 4 -o $d/b.ele "
               "docs/data/timezones.csv");
    CLAIM("tri.seed", shell("cmp -s $d/b.ele $d/h.ele") == 1, "--seed changes nothing");
    run_tri(0, "triangulate --algorithm sweep -o $d/u.ele docs/data/timezones.csv");
    CLAIM("tri.direction", shell("cmp -s $d/t.ele $d/u.ele") == 1,
          "the direction changes nothing");
    run_tri(0, "--version");
    run_tri(0, "help");
    run_tri(0, "help check");
}

/* The bytes of 1000 points, seed 7. The sums were taken from programs made by gcc at
 * -O0 and -O2 and by clang, on one machine: this test asks all the others. */
static void
generated_points_are_the_same_everywhere(void)
{
    static const struct {
        const char *name, *sum;
    } expected[] = {
        {"uniform", "2121501552 42444"},
        {"normal", "1405449722 43212"},
        {"clusters", "1282766043 42387"},
        {"grid", "2189459314 9263"},
        {"circle", "1381185349 43196"},
        {"kuzmin", "4285050887 42712"},
        {"near-line", "1354129949 45315"},
        {"collinear", "3776058117 11681"},
        {"parabola", "1545967584 14262"},
        {"ladder", "4211861130 9791"},
        {"spiral", "1925673834 43286"},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        char arguments[100];
        snprintf(arguments, sizeof arguments, "generate %s 1000 --seed 7",
                 expected[i].name);
        run_tri(0, arguments);
        shell("cksum <$d/out >$d/sum");
        content sum = read_scratch("sum");
        sum.text[strcspn(sum.text, "\n")] = '\0';
        CLAIM("tri.generate", strcmp(sum.text, expected[i].sum) == 0,
              "%s: the sum is %s, not %s", expected[i].name, sum.text,
              expected[i].sum);
    }
}

/* ---- What it refuses. ---- */

static void
bad_files_are_refused(void)
{
    glob_t files;
    CLAIM("tri.setup", glob("tests/bad_files/line*", 0, NULL, &files) == 0 &&
          files.gl_pathc > 40, "the bad files are not there");
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i];
        bool triangles = strcmp(path + strlen(path) - 4, ".ele") == 0;
        char arguments[1000], begin[600];
        if (triangles)
            snprintf(arguments, sizeof arguments,
                     "draw tests/bad_files/good.node %s -o $d/old.ele", path);
        else
            snprintf(arguments, sizeof arguments, "triangulate -o $d/old.ele %s", path);
        unsigned line = (unsigned)strtoul(strstr(path, "/line") + 5, NULL, 10);
        snprintf(begin, sizeof begin, "%s:%u: ", path, line);

        shell("echo old >$d/old.ele");
        run_tri(2, arguments);
        content err = read_scratch("err");
        CLAIM("tri.says_where", strncmp(err.text, begin, strlen(begin)) == 0 &&
              one_line("err"), "%s is refused with: %s", path, err.text);
        CLAIM("tri.old_file", strcmp(read_scratch("old.ele").text, "old\n") == 0,
              "%s: the old output is gone", path);
    }
    globfree(&files);
}

/* Those that have no lines. Beside them stands one that is good, under any name. */
static void
bad_binary_files_are_refused(void)
{
    glob_t files;
    CLAIM("tri.setup", glob("tests/bad_files/binary_*", 0, NULL, &files) == 0 &&
          files.gl_pathc > 5, "the bad files are not there");
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i];
        char arguments[600], begin[600];
        snprintf(arguments, sizeof arguments, "triangulate %s", path);
        snprintf(begin, sizeof begin, "%s: binary points", path);
        run_tri(2, arguments);
        CLAIM("tri.binary",
              strncmp(read_scratch("err").text, begin, strlen(begin)) == 0 &&
                  one_line("err") && !has("out", "\n"),
              "%s is refused with: %s", path, read_scratch("err").text);
    }
    globfree(&files);
    int status = shell("$tri generate uniform 500 -o $d/b.node && "
                       "$tri generate uniform 500 --binary -o $d/b.xy && "
                       "$tri triangulate -o $d/1.ele $d/b.node && "
                       "$tri triangulate -o $d/2.ele - <$d/b.xy && "
                       "cmp $d/1.ele $d/2.ele && test $(wc -c <$d/b.xy) -eq 8016");
    CLAIM("tri.binary", status == 0, "bits and text differ: status %d", status);
}

static void
what_is_no_file_is_refused(void)
{
    const char *const arguments[] = {
        "triangulate $d/missing.node", "triangulate $d",
        "check tests/bad_files/good.node $d/missing.ele",
        "triangulate -o $d/no/such/folder/x.ele tests/bad_files/good.node",
        "draw tests/bad_files/good.node -o $d/no/such/folder/x.svg"};
    for (size_t i = 0; i < sizeof arguments / sizeof arguments[0]; i++) {
        run_tri(2, arguments[i]);
        CLAIM("tri.one_line", one_line("err") && has("err", ": cannot be "),
              "tri %s: %s", arguments[i], read_scratch("err").text);
    }
    run_tri(2, "triangulate -o $d tests/bad_files/good.node");
    CLAIM("tri.one_line", has("err", "it is a folder"), "%s",
          read_scratch("err").text);
    run_tri(2, "triangulate - </dev/null");
    CLAIM("tri.says_where", has("err", "<stdin>:1: "), "%s",
          read_scratch("err").text);
}

static void
wrong_arguments_are_explained(void)
{
    const char *const arguments[] = {"triangulate",
                                     "triangulate a b",
                                     "triangulate --algorithm",
                                     "check a",
                                     "triangulate --algorithm bubble a",
                                     "triangulate --fast a",
                                     "hull",
                                     "triangulate --direction 0,0 a",
                                     "triangulate --direction 1 a",
                                     "triangulate --cuts skew a",
                                     "triangulate --locator luck a",
                                     "triangulate --seed x a",
                                     "triangulate --threads 0 a",
                                     "triangulate --threads two a",
                                     "triangulate --direction 1,x a",
                                     "triangulate --direction nan,1 a",
                                     "triangulate -o x.ele -o y.ele a",
                                     "triangulate --stats -o - a",
                                     "generate",
                                     "generate uniform",
                                     "generate uniform many",
                                     "generate lumpy 10",
                                     "generate uniform -5",
                                     "generate uniform 4294967295",
                                     "generate uniform 10 --seed x",
                                     "generate uniform 10 20",
                                     "draw",
                                     "help nothing",
                                     "check --delaunay a b c"};
    for (size_t i = 0; i < sizeof arguments / sizeof arguments[0]; i++) {
        run_tri(2, arguments[i]);
        CLAIM("tri.usage", has("err", "usage: tri ") && !has("out", "\n"),
              "tri %s: %s", arguments[i], read_scratch("err").text);
    }
    run_tri(2, "");
    run_tri(2, "fold a");
    CLAIM("tri.usage", has("err", "usage:"), "%s", read_scratch("err").text);
}

/* A file-size limit fails in the middle of the writing, like a disk that is full. */
static void
failed_writing_leaves_the_old_file(void)
{
    shell("$tri generate uniform 20000 -o $d/u.node; echo old >$d/u.ele");
    int status = shell("(ulimit -f 64; trap '' XFSZ; "
                       "exec $tri triangulate -o $d/u.ele $d/u.node) 2>$d/err");
    CLAIM("tri.full",
          status == 2 && one_line("err") && has("err", "cannot be written"),
          "exit status %d: %s", status, read_scratch("err").text);
    CLAIM("tri.old_file", strcmp(read_scratch("u.ele").text, "old\n") == 0,
          "the old output is gone");
    CLAIM("tri.old_file", shell("ls $d/*.part >$d/out 2>&1") != 0, "%s is left",
          read_scratch("out").text);

    /* Devices are written in place. Names in /dev/fd are used, as a program that
     * replaced them by files would do no harm there, even to root. */
    if (access("/dev/full", W_OK) != 0 || access("/dev/fd/0", F_OK) != 0)
        return;
    run_tri(0, "triangulate -o /dev/fd/3 3>$d/3.ele $d/u.node");
    run_tri(0, "check $d/u.node $d/3.ele");
    run_tri(2, "triangulate -o /dev/fd/3 3>/dev/full $d/u.node");
    CLAIM("tri.full", one_line("err") && has("err", "/dev/fd/3: cannot be written"),
          "%s", read_scratch("err").text);
    run_tri(2, "triangulate --svg /dev/fd/3 3>/dev/full $d/u.node");
    run_tri(2, "generate uniform 10 -o /dev/fd/3 3>/dev/full");
    run_tri(2, "hull -o /dev/fd/3 3>/dev/full $d/u.node");
    const char *const printing[] = {"triangulate $d/u.node", "generate uniform 1",
                                    "check $d/u.node $d/3.ele", "help"};
    for (size_t i = 0; i < sizeof printing / sizeof printing[0]; i++) {
        status = shell("$tri %s >/dev/full 2>$d/err", printing[i]);
        CLAIM("tri.full", status == 2 && has("err", "<stdout>: cannot be written"),
              "tri %s: exit status %d: %s", printing[i], status,
              read_scratch("err").text);
    }
}

static void
closed_pipes_are_errors(void)
{
    shell("$tri generate uniform 20000 -o $d/u.node");
    int status = shell("{ $tri triangulate $d/u.node 2>$d/err; "
                       "echo $? >$d/status; } | true");
    CLAIM("tri.pipe", status == 0 && strcmp(read_scratch("status").text, "2\n") == 0,
          "exit status %s", read_scratch("status").text);
    CLAIM("tri.pipe", one_line("err") && has("err", "cannot be written"), "%s",
          read_scratch("err").text);
}

/* Runs tri, sends it the signal as soon as the file $d/beside is there, and returns how
 * it ended. */
static int
interrupt(int signal_number, char *const arguments[], const char *beside)
{
    pid_t child = fork();
    if (child == 0) {
        signal(signal_number, SIG_DFL);
        execv(getenv("tri"), arguments);
        _exit(127);
    }
    const struct timespec moment = {0, 100000};
    int status;
    while (access(in_scratch(beside).text, F_OK) != 0) {
        CLAIM("tri.interrupt", waitpid(child, &status, WNOHANG) == 0,
              "%s was never seen; status %d", beside, status);
        nanosleep(&moment, NULL);
    }
    kill(child, signal_number);
    waitpid(child, &status, 0);
    return status;
}

static void
interrupted_writing_leaves_the_old_file(void)
{
    const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    file_name path = in_scratch("i.node");
    char tri[] = "tri", generate[] = "generate", uniform[] = "uniform";
    char number[] = "2000000", o[] = "-o";
    char *const arguments[] = {tri, generate, uniform, number, o, path.text, NULL};
    for (int i = 0; i < 3; i++) {
        shell("echo old >$d/i.node");
        int status = interrupt(signals[i], arguments, "i.node.1.part");
        CLAIM("tri.interrupt", WIFSIGNALED(status) && WTERMSIG(status) == signals[i],
              "signal %d: it ended with %d", signals[i], status);
        CLAIM("tri.interrupt", shell("ls $d/i.node.*.part >$d/out 2>&1") != 0,
              "signal %d: %s is left", signals[i], read_scratch("out").text);
        CLAIM("tri.old_file", strcmp(read_scratch("i.node").text, "old\n") == 0,
              "signal %d: the old output is gone", signals[i]);
    }
}

/* ---- What a terminal is told. ---- */

/* Runs `$tri ARGUMENTS` with a terminal for standard error; what it was told there. */
static content
told_by(const char *arguments)
{
    content told = {""};
    int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    CLAIM("tri.setup",
          terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0,
          "no terminal");
    int kept = open(ptsname(terminal), O_RDWR | O_NOCTTY); /* else it forgets */
    int status = shell("$tri %s 2>%s", arguments, ptsname(terminal));
    CLAIM("tri.progress", status == 0 && write(kept, "|", 1) == 1,
          "tri %s: exit status %d", arguments, status);
    size_t length = 0;
    while (strchr(told.text, '|') == NULL && length < sizeof told.text - 1) {
        ssize_t more =
            read(terminal, told.text + length, sizeof told.text - 1 - length);
        CLAIM("tri.progress", more > 0, "the terminal was told nothing");
        length += (size_t)more;
    }
    close(kept);
    close(terminal);
    return told;
}

/* Every algorithm, also one that no observer can watch; and a terminal only. */
static void
long_runs_say_how_far_they_are(void)
{
    const char *const algorithms[] = {"sweep", "fast"};
    shell("$tri generate uniform 300000 --binary -o $d/many.xy");
    for (int i = 0; i < 2; i++) {
        char arguments[200];
        snprintf(arguments, sizeof arguments,
                 "triangulate --algorithm %s -o $d/many.ele $d/many.xy", algorithms[i]);
        content told = told_by(arguments);
        const char *read = strstr(told.text, "tri: 300000 points have been read");
        const char *does = strstr(told.text, "tri: triangulating by ");
        const char *writes = strstr(told.text, "tri: writing ");
        CLAIM("tri.progress", read != NULL && does != NULL && writes != NULL &&
              read < does && does < writes, "tri %s: %s", arguments, told.text);
        run_tri(0, arguments);
        CLAIM("tri.progress", read_scratch("err").text[0] == '\0',
              "a file is told of progress: %s", read_scratch("err").text);
    }
    content told = told_by("check --delaunay $d/many.xy $d/many.ele >$d/out");
    CLAIM("tri.progress", strstr(told.text, "tri: checking ") != NULL, "tri check: %s",
          told.text);
    told = told_by("triangulate -o $d/few.ele docs/data/timezones.csv");
    CLAIM("tri.progress", strcmp(told.text, "|") == 0, "a short run says: %s",
          told.text);
}

/* ---- Doubles go through, whatever the environment's locale. ---- */

static void
doubles_go_through(const point2 *points, uint32_t n)
{
    FILE *file = fopen(in_scratch("d.node").text, "wb");
    CLAIM("tri.setup", file != NULL, "d.node cannot be written");
    text_write_points(file, points, n, 1);
    fclose(file);
    int status = shell("LC_ALL=de_DE.UTF-8 $tri triangulate -o $d/d.ele $d/d.node "
                       "2>$d/err && "
                       "$tri check --delaunay $d/d.node $d/d.ele >$d/out");
    CLAIM("tri.certified", status == 0, "%s%s", read_scratch("err").text,
          read_scratch("out").text);
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "tri does what its help says, and refuses the rest");
    test_run("triangles are numbered like the points",
             triangles_are_numbered_like_the_points);
    test_run("results are certified and reproducible",
             results_are_certified_and_reproducible);
    test_run("wrong triangulations are refuted", wrong_triangulations_are_refuted);
    test_run("degenerate points are reported", degenerate_points_are_reported);
    test_run("pictures and statistics", pictures_and_statistics);
    test_run("generated points are the same everywhere",
             generated_points_are_the_same_everywhere);
    test_near_degenerate("doubles go through", doubles_go_through, 60, 20);
    test_run("bad files are refused", bad_files_are_refused);
    test_run("bad binary files are refused", bad_binary_files_are_refused);
    test_run("what is no file is refused", what_is_no_file_is_refused);
    test_run("wrong arguments are explained", wrong_arguments_are_explained);
    test_run("failed writing leaves the old file",
             failed_writing_leaves_the_old_file);
    test_run("interrupted writing leaves the old file",
             interrupted_writing_leaves_the_old_file);
    test_run("closed pipes are errors", closed_pipes_are_errors);
    test_run("long runs say how far they are", long_runs_say_how_far_they_are);
    int status = test_end((test_minima){.trials = 70});
    shell_end();
    return status;
}
