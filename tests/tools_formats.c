/* Each file that `tri triangulate -o` can write says the same as the .ele file, in the
 * words of its own format, with coordinates that are the doubles of the input.
 *
 * Hypotheses: none. The files are read by small readers of this test that share no code
 * with the program. What is not asked here: whether the .ele file is right (tools_tri).
 */
#include "chapters/3.4_primitives/predicates.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 40, MOST_TRIANGLES = 2 * MOST_POINTS };

/* The input, and the .ele file: the truth here. */
static const point2 *site;
static long sites, first;
static long triangles, corner[MOST_TRIANGLES][3]; /* as in the file */

/* ---- Reading. ---- */

/* The rest of a file that is taken apart. */
static const char *rest;
static char text[60000];

static void
open_text(const char *name)
{
    FILE *file = fopen(in_scratch(name).text, "rb");
    CLAIM("formats.whole", file != NULL, "there is no %s", name);
    size_t size = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    CLAIM("formats.whole", size < sizeof text - 1 && size > 0 && text[size - 1] == '\n',
          "%s has %zu bytes, or no newline at its end", name, size);
    text[size] = '\0';
    rest = text;
}

/* The next words or signs, whatever blanks are before each of them. */
static void
expect(const char *words)
{
    for (; *words != '\0'; words++) {
        while (isspace((unsigned char)*rest))
            rest++;
        CLAIM("formats.grammar", *rest == *words, "\"%c\" is expected before \"%.30s\"",
              *words, rest);
        rest++;
    }
}

static long
whole(void)
{
    char *end;
    long value = strtol(rest, &end, 10);
    CLAIM("formats.grammar", end != rest, "a whole number is expected before \"%.30s\"",
          rest);
    rest = end;
    return value;
}

/* A number as JSON wants it, which the other formats read too: no plus, no zeros in
 * front, a digit on both sides of a point. */
static double
number(void)
{
    while (isspace((unsigned char)*rest))
        rest++;
    const char *c = rest + (*rest == '-');
    bool good = isdigit((unsigned char)*c), zero = *c == '0';
    size_t digits = strspn(c, "0123456789");
    good = good && !(zero && digits > 1);
    c += digits;
    if (*c == '.') {
        good = good && isdigit((unsigned char)c[1]);
        c += 1 + strspn(c + 1, "0123456789");
    }
    if (*c == 'e' || *c == 'E') {
        c += c[1] == '-' || c[1] == '+' ? 2 : 1;
        good = good && isdigit((unsigned char)*c);
        c += strspn(c, "0123456789");
    }
    char *end;
    double value = strtod(rest, &end);
    CLAIM("formats.number", good && end == c, "\"%.30s\" does not begin with a number",
          rest);
    rest = end;
    return value;
}

static void
expect_point(long i, const char *between)
{
    double x = number();
    expect(between);
    double y = number();
    CLAIM("formats.coordinates", memcmp(&x, &site[i].x, sizeof x) == 0 &&
          memcmp(&y, &site[i].y, sizeof y) == 0, "point %ld became (%.17g,%.17g)", i, x,
          y);
}

static void
expect_end(void)
{
    CLAIM("formats.grammar", rest[strspn(rest, " \n")] == '\0', "at the end: \"%.30s\"",
          rest);
}

/* ---- The formats. ---- */

static void
read_ele(void)
{
    open_text("x.ele");
    triangles = whole();
    CLAIM("formats.ele", triangles >= 0 && triangles <= MOST_TRIANGLES,
          "%ld triangles of %ld points", triangles, sites);
    expect("30");
    for (long t = 0; t < triangles; t++) {
        CLAIM("formats.ele", whole() == first + t, "not triangle %ld", first + t);
        for (int i = 0; i < 3; i++) {
            corner[t][i] = whole();
            CLAIM("formats.ele", corner[t][i] >= first && corner[t][i] < first + sites,
                  "triangle %ld has the corner %ld", first + t, corner[t][i]);
        }
    }
    expect_end();
}

/* The triangle with a side from a to b, or -1; in the numbers of the files. */
static long
triangle_with(long a, long b)
{
    for (long t = 0; t < triangles; t++)
        for (int i = 0; i < 3; i++)
            if (corner[t][i] == a && corner[t][(i + 1) % 3] == b)
                return first + t;
    return -1;
}

static void
read_neigh(void)
{
    open_text("x.neigh");
    CLAIM("formats.neigh", whole() == triangles, "not %ld triangles", triangles);
    expect("3");
    for (long t = 0; t < triangles; t++) {
        CLAIM("formats.neigh", whole() == first + t, "not triangle %ld", first + t);
        for (int i = 0; i < 3; i++) {
            long said = whole();
            long is = triangle_with(corner[t][(i + 2) % 3], corner[t][(i + 1) % 3]);
            CLAIM("formats.neigh", said == is,
                  "opposite corner %d of triangle %ld: %ld, and it is %ld", i + 1,
                  first + t, said, is);
        }
    }
    expect_end();
}

static void
expect_corners(const char *claim, const char *before, long first_there)
{
    for (long t = 0; t < triangles; t++) {
        expect(before);
        for (int i = 0; i < 3; i++) {
            long there = whole() - first_there, here = corner[t][i] - first;
            CLAIM(claim, there == here, "triangle %ld: corner %ld is %ld", t, here,
                  there);
        }
    }
    expect_end();
}

static void
read_off(void)
{
    open_text("x.off");
    expect("OFF");
    CLAIM("formats.off", whole() == sites && whole() == triangles && whole() == 0,
          "not %ld points, %ld triangles", sites, triangles);
    for (long i = 0; i < sites; i++) {
        expect_point(i, "");
        CLAIM("formats.off", number() == 0, "point %ld is not in the plane", i);
    }
    expect_corners("formats.off", "3", 0);
}

static void
read_obj(void)
{
    open_text("x.obj");
    expect("#");
    CLAIM("formats.obj", whole() == sites, "not %ld points", sites);
    expect("points,");
    CLAIM("formats.obj", whole() == triangles, "not %ld triangles", triangles);
    expect("triangles");
    for (long i = 0; i < sites; i++) {
        expect("v");
        expect_point(i, "");
        CLAIM("formats.obj", number() == 0, "point %ld is not in the plane", i);
    }
    expect_corners("formats.obj", "f", 1);
}

/* The members may come in any order in JSON; here they come in one. */
static void
read_geojson(void)
{
    open_text("x.geojson");
    expect("{\"type\":\"FeatureCollection\",\"features\":[");
    for (long t = 0; t < triangles; t++) {
        point2 p[3];
        expect(t > 0 ? "," : "");
        expect("{\"type\":\"Feature\",\"id\":");
        CLAIM("formats.geojson", whole() == first + t, "not triangle %ld", first + t);
        expect(",\"properties\":{\"corners\":[");
        for (int i = 0; i < 3; i++) {
            long v = whole();
            CLAIM("formats.geojson", v == corner[t][i], "corner %ld is %ld",
                  corner[t][i], v);
            expect(i < 2 ? "," : "]},");
            p[i] = site[v - first];
        }
        expect("\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[");
        CLAIM("formats.geojson", orient2d(p[0], p[1], p[2]) > 0,
              "ring %ld does not run counterclockwise", t);
        for (int i = 0; i < 4; i++) { /* the last position is the first */
            expect("[");
            expect_point(corner[t][i % 3] - first, ",");
            expect(i < 3 ? "]," : "]]]}}");
        }
    }
    expect("]}");
    expect_end();
}

static void
all_formats_say_the_same(const point2 *points, uint32_t n)
{
    site = points;
    sites = n;
    first = (long)random_below(test_random_source(), 2);
    FILE *file = fopen(in_scratch("x.node").text, "wb");
    CLAIM("formats.setup", file != NULL, "x.node cannot be written");
    fprintf(file, "%ld 2 0 0\n", sites);
    for (long i = 0; i < sites; i++)
        fprintf(file, "%ld %.17g %.17g\n", first + i, site[i].x, site[i].y);
    fclose(file);
    if (sites == 0)
        first = 0; /* no line of the file says otherwise */
    int status = shell(
        "for e in ele neigh off obj geojson; do "
        "$tri triangulate -o $d/x.$e $d/x.node 2>$d/err || exit 1; done");
    CLAIM("formats.setup", status == 0, "%s", read_scratch("err").text);
    read_ele();
    read_neigh();
    read_off();
    read_obj();
    read_geojson();
}

/* ---- Names of files. ---- */

static void
endings_are_explained(void)
{
    static const char *const bad[] = {"x.txt", "x", "x.ELE", "x.ele.gz", "xele", "x."};
    static const char *const good[] = {".ele", ".neigh", ".off", ".obj", ".geojson"};
    shell("$tri help triangulate >$d/help; printf '0 0\\n1 0\\n0 1\\n' >$d/t.xy");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int status = shell("$tri triangulate -o $d/%s $d/t.xy 2>$d/err", bad[i]);
        CLAIM("formats.endings", status == 2 && shell("test -e $d/%s", bad[i]) == 1,
              "-o %s: exit status %d", bad[i], status);
        for (size_t k = 0; k < sizeof good / sizeof good[0]; k++)
            CLAIM("formats.endings", has("err", good[k]) && has("help", good[k]),
                  "%s is not named: %s", good[k], read_scratch("err").text);
    }
    CLAIM("formats.endings",
          shell("$tri triangulate $d/t.xy >$d/1.ele && "
                "$tri triangulate -o - $d/t.xy >$d/2.ele && "
                "$tri triangulate -o $d/3.ele $d/t.xy && "
                "cmp $d/1.ele $d/2.ele && cmp $d/1.ele $d/3.ele") == 0,
          "standard output is no .ele file");
}

/* A file-size limit fails in the middle of the writing, like a disk that is full. */
static void
failed_writing_leaves_nothing(void)
{
    int made = shell("$tri generate uniform 20000 -o $d/u.node");
    CLAIM("formats.setup", made == 0, "u.node: exit status %d", made);
    static const char *const ending[] = {"ele", "neigh", "off", "obj", "geojson"};
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++) {
        int status = shell("(ulimit -f 64; trap '' XFSZ; "
                           "exec $tri triangulate -o $d/u.%s $d/u.node) 2>$d/err",
                           ending[i]);
        CLAIM("formats.full", status == 2 && one_line("err"), ".%s: status %d: %s",
              ending[i], status, read_scratch("err").text);
        CLAIM("formats.full", shell("ls $d/u.%s* >$d/out 2>&1", ending[i]) != 0,
              "%s is left", read_scratch("out").text);
    }
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "the files of tri triangulate -o say the same");
    test_random("all formats say the same", all_formats_say_the_same, 100, MOST_POINTS);
    test_near_degenerate("the same, at every magnitude", all_formats_say_the_same, 100,
                         20);
    test_run("endings are explained", endings_are_explained);
    test_run("failed writing leaves nothing", failed_writing_leaves_nothing);
    int status = test_end((test_minima){.trials = 200, .largest_n = 30});
    shell_end();
    return status;
}
