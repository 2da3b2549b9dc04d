/* The command tri voronoi writes the Voronoi diagram in the files of Triangle,
 * and all of them or none.
 *
 * It is driven as people drive it, by the shell. Needed: the program, beside
 * this one's folder or where the environment's TRI says.
 */
#include "chapters/3.1_voronoi_diagrams/voronoi.h"
#include "chapters/3.4_primitives/predicates.h"
#include "lib/textio.h"
#include "tests/harness/harness.h"
#include "tests/harness/start.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char scratch[400]; /* a folder of this run's own; $d in the shell */

static int
shell(const char *command)
{
    int status = system(command);
    return status != -1 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* The name of a file in the folder. */
typedef struct name {
    char text[500];
} name;

static name
in_scratch(const char *file)
{
    name n;
    snprintf(n.text, sizeof n.text, "%s/%s", scratch, file);
    return n;
}

/* Does the file have exactly this text, or this among its first 3999 bytes? */
static bool
is_text(const char *file, const char *text, bool all)
{
    char bytes[4000];
    FILE *f = fopen(in_scratch(file).text, "rb");
    if (f == NULL)
        return false;
    bytes[fread(bytes, 1, sizeof bytes - 1, f)] = '\0';
    fclose(f);
    return all ? strcmp(bytes, text) == 0 : strstr(bytes, text) != NULL;
}

static void
write_points(const point2 *points, uint32_t n)
{
    FILE *file = fopen(in_scratch("in.node").text, "wb");
    CLAIM("voronoi.setup", file != NULL, "no file can be written");
    text_write_points(file, points, n, 1);
    fclose(file);
}

/* ---- The diagram that is in the files. ---- */

/* A line of .v.edge. Items are numbered from 1 in these tests, here from 0. */
typedef struct line {
    int ends[2]; /* -1: at infinity */
    double number[4];
    int numbers;
} line;

typedef struct diagram {
    text_points vertices;
    triangle_list triangles;
    edge_list edges;
    uint32_t lines;
    line *line;
} diagram;

static void
read_lines(diagram *g, const char *file)
{
    char text[400];
    unsigned count = 0, k;
    FILE *f = fopen(in_scratch(file).text, "rb");
    CLAIM("voronoi.files", f != NULL, "%s is not there", file);
    CLAIM("voronoi.files",
          fgets(text, sizeof text, f) != NULL &&
              sscanf(text, "%u 0", &count) == 1,
          "%s has no first line", file);
    g->line = calloc(count + 1, sizeof *g->line);
    while (g->lines < count && fgets(text, sizeof text, f) != NULL) {
        line *l = &g->line[g->lines];
        int read = sscanf(text, "%u %d %d %lf %lf %lf %lf", &k, &l->ends[0],
                          &l->ends[1], &l->number[0], &l->number[1],
                          &l->number[2], &l->number[3]);
        CLAIM("voronoi.files", read >= 3 && k == ++g->lines, "%s: %s", file,
              text);
        l->numbers = read - 3;
        for (int i = 0; i < 2; i++)
            l->ends[i] -= l->ends[i] > 0;
    }
    CLAIM("voronoi.files",
          g->lines == count && fgets(text, sizeof text, f) == NULL,
          "%s announces %u edges", file, count);
    fclose(f);
}

/* Runs the command on the points and reads what it wrote. */
static diagram
run(const point2 *points, uint32_t n, bool per_triangle)
{
    diagram g = {0};
    text_error error = {0};
    text_points in = {n, 1, NULL};
    write_points(points, n);
    int status = shell(
        per_triangle
            ? "$tri voronoi --per-triangle -o $d/out --svg $d/out.svg "
              "$d/in.node 2>$d/err"
            : "$tri voronoi -o $d/out --svg $d/out.svg $d/in.node 2>$d/err");
    CLAIM("voronoi.files", status == 0, "exit status %d", status);
    CLAIM("voronoi.files", is_text("out.svg", "<svg", false), "no picture");
    CLAIM("voronoi.files",
          text_read_points(in_scratch("out.v.node").text, &g.vertices,
                           &error) == TRI_OK,
          "out.v.node:%lu: %s", error.line, error.text);
    read_lines(&g, "out.v.edge");
    if (per_triangle) {
        CLAIM("voronoi.files",
              text_read_triangles(in_scratch("out.ele").text, &in, &g.triangles,
                                  &error) == TRI_OK,
              "out.ele:%lu: %s", error.line, error.text);
        CLAIM("voronoi.files",
              text_read_edges(in_scratch("out.edge").text, &in, &g.edges,
                              &error) == TRI_OK,
              "out.edge:%lu: %s", error.line, error.text);
    }
    return g;
}

static void
diagram_free(diagram *g)
{
    text_points_free(&g->vertices);
    triangle_list_free(&g->triangles);
    edge_list_free(&g->edges);
    free(g->line);
}

/* ---- What the files say. ---- */

/* The corner of triangle t that is neither p nor q; NONE if these are not
 * corners. */
static vertex_id
third_corner(triangle_list list, int t, vertex_id p, vertex_id q)
{
    vertex_id third = NONE;
    int found = 0;
    for (int i = 0; i < 3; i++) {
        vertex_id c = list.corner[t][i];
        if (c == p || c == q)
            found++;
        else
            third = c;
    }
    return found == 2 ? third : NONE;
}

static double
dot(double x, double y, point2 p, point2 q)
{
    return x * (q.x - p.x) + y * (q.y - p.y);
}

/* Line k of .v.edge is dual to line k of .edge: its ends are the triangles at
 * that edge, and a ray leaves at a right angle, away from its triangle. */
static void
check_line(const point2 *points, const diagram *g, uint32_t k)
{
    vertex_id p = g->edges.ends[k][0], q = g->edges.ends[k][1];
    line l = g->line[k];
    uint32_t at_edge = 0, ends = 0;
    for (uint32_t t = 0; t < g->triangles.count; t++)
        at_edge += third_corner(g->triangles, (int)t, p, q) != NONE;
    for (int i = 0; i < 2; i++) {
        if (l.ends[i] < 0)
            continue;
        ends++;
        vertex_id c = third_corner(g->triangles, l.ends[i], p, q);
        CLAIM("voronoi.dual", c != NONE, "edge %u ends at triangle %d", k,
              l.ends[i]);
        if (l.ends[1] < 0)
            CLAIM("voronoi.outward",
                  dot(l.number[0], l.number[1], points[p], points[c]) < 0,
                  "ray %u leaves through its triangle", k);
    }
    CLAIM("voronoi.dual", ends == at_edge, "edge %u: %u ends, %u triangles", k,
          ends, at_edge);
    CLAIM("voronoi.form",
          l.numbers == (ends == 2   ? 0
                        : ends == 1 ? 2
                                    : 4),
          "edge %u: %u ends, %d numbers", k, ends, l.numbers);
    CLAIM("voronoi.form", l.ends[0] >= 0 || ends == 0,
          "ray %u comes from infinity", k);
    if (ends < 2) {
        const double *along = &l.number[2 - 2 * ends];
        CLAIM("voronoi.outward",
              dot(along[0], along[1], points[p], points[q]) == 0 &&
                  (along[0] != 0 || along[1] != 0),
              "edge %u does not run along the bisector", k);
    }
    if (ends == 0) {
        point2 x = {l.number[0], l.number[1]};
        CLAIM("voronoi.form", compare_distance(x, points[p], x, points[q]) == 0,
              "line %u runs through (%g,%g)", k, x.x, x.y);
    }
}

static void
per_triangle_files_agree(const point2 *given, uint32_t n)
{
    (void)given;
    point2 *points = whole_points(NULL, n, 12);
    diagram g = run(points, n, true);
    CLAIM("voronoi.dual",
          g.vertices.count == g.triangles.count && g.lines == g.edges.count,
          "%u vertices, %u triangles", g.vertices.count, g.triangles.count);
    for (uint32_t t = 0; t < g.triangles.count; t++) {
        const vertex_id *c = g.triangles.corner[t];
        point2 at;
        CLAIM("voronoi.dual",
              circumcentre(points[c[0]], points[c[1]], points[c[2]], &at) ==
                      TRI_OK &&
                  at.x == g.vertices.points[t].x &&
                  at.y == g.vertices.points[t].y,
              "vertex %u is not the centre of triangle %u", t, t);
    }
    for (uint32_t k = 0; k < g.lines; k++)
        check_line(points, &g, k);
    diagram_free(&g);
    free(points);
}

/* Without --per-triangle, no two vertices are the same point, and each is one
 * of those with it; an edge joins two different ones. */
static void
vertices_are_merged(const point2 *given, uint32_t n)
{
    (void)given;
    point2 *points = whole_points(NULL, n, 6);
    diagram all = run(points, n, true), g = run(points, n, false);
    for (uint32_t v = 0; v < g.vertices.count; v++) {
        bool known = false;
        point2 at = g.vertices.points[v];
        for (uint32_t t = 0; t < all.vertices.count; t++)
            known = known ||
                    compare_distance(at, all.vertices.points[t], at, at) == 0;
        CLAIM("voronoi.merged", known, "vertex %u is no centre", v);
        for (uint32_t w = 0; w < v; w++)
            CLAIM("voronoi.merged",
                  compare_distance(at, g.vertices.points[w], at, at) != 0,
                  "vertices %u and %u are the same point", w, v);
    }
    for (uint32_t k = 0; k < g.lines; k++)
        CLAIM("voronoi.merged",
              g.line[k].ends[0] != g.line[k].ends[1] || g.line[k].ends[0] < 0,
              "edge %u has length 0", k);
    CLAIM("voronoi.merged",
          g.lines + all.vertices.count == all.lines + g.vertices.count,
          "%u of %u edges and %u of %u vertices are left", g.lines, all.lines,
          g.vertices.count, all.vertices.count);
    diagram_free(&all);
    diagram_free(&g);
    free(points);
}

/* ---- Known files. ---- */

static void
known_files(void)
{
    shell("printf '0 0\\n2 0\\n0 2\\n' >$d/t.xy; $tri voronoi -o $d/t $d/t.xy");
    CLAIM("voronoi.known", is_text("t.v.node", "1 2 0 0\n0 1 1\n", true),
          "the vertex");
    CLAIM("voronoi.known",
          is_text("t.v.edge", " 0 -1 0 -2\n", false) &&
              is_text("t.v.edge", " 0 -1 2 2\n", false) &&
              is_text("t.v.edge", " 0 -1 -2 0\n", false),
          "the rays");
    shell("printf '0 0\\n4 2\\n' >$d/l.xy; $tri voronoi -o $d/l $d/l.xy "
          "2>$d/err");
    CLAIM("voronoi.known", is_text("l.v.node", "0 2 0 0\n", true),
          "no vertices");
    CLAIM("voronoi.known",
          is_text("l.v.edge", "1 0\n0 -1 -1 2 1 -2 4\n", true) ||
              is_text("l.v.edge", "1 0\n0 -1 -1 2 1 2 -4\n", true),
          "the line");
    shell("printf '7 7\\n7 7\\n' >$d/p.xy; $tri voronoi -o $d/p $d/p.xy "
          "2>$d/err");
    CLAIM("voronoi.known",
          is_text("p.v.edge", "0 0\n", true) &&
              is_text("err", "1 of 2 points", false),
          "one cell, the whole plane");
    int status = shell("$tri generate grid 49 -o $d/g.node && "
                       "$tri voronoi -o $d/g $d/g.node");
    CLAIM("voronoi.known",
          status == 0 && is_text("g.v.node", "36 2 0 0\n", false) &&
              is_text("g.v.edge", "84 0\n", false),
          "the 7 x 7 grid");
}

/* ---- Refusals. ---- */

static void
claim_untouched(const char *why)
{
    CLAIM("voronoi.all_or_none",
          is_text("x.v.node", "old\n", true) &&
              is_text("x.v.edge", "old\n", true),
          "%s: an old file is gone", why);
    CLAIM("voronoi.all_or_none", shell("ls $d/*.part >$d/ls 2>&1") != 0,
          "%s: a part of a file is left", why);
}

static void
refusals_leave_old_files(void)
{
    shell("echo old >$d/x.v.node; echo old >$d/x.v.edge");
    shell("printf '%s\\n' '-1e200 0' '1e200 0' '0 1e-200' >$d/far.xy");
    int status = shell("$tri voronoi -o $d/x $d/far.xy 2>$d/err");
    CLAIM("voronoi.range",
          status == 2 && is_text("err", "larger than the largest", false),
          "a vertex beyond the doubles: exit status %d", status);
    claim_untouched("out of range");

    status = shell("mkdir $d/x.edge; $tri generate uniform 9 -o $d/u.node; "
                   "$tri voronoi --per-triangle -o $d/x $d/u.node 2>$d/err");
    CLAIM("voronoi.all_or_none",
          status == 2 && is_text("err", "it is a folder", false),
          "a folder in the way: exit status %d", status);
    claim_untouched("a folder in the way");

    /* Only the last file is too long for a limit of 32 kB: the others must
     * wait. */
    status = shell(
        "$tri generate uniform 250 -o $d/u.node; (ulimit -f 64; trap '' XFSZ; "
        "exec $tri voronoi -o $d/x --svg $d/x.svg $d/u.node 2>$d/err)");
    CLAIM("voronoi.all_or_none",
          status == 2 && is_text("err", "cannot be written", false),
          "a full disk: exit status %d", status);
    claim_untouched("a full disk");

    status =
        shell("$tri voronoi -o $d/x --svg $d/no/such/x.svg $d/u.node 2>$d/err");
    CLAIM("voronoi.all_or_none",
          status == 2 && is_text("err", "cannot be written", false),
          "no such folder: exit status %d", status);
    claim_untouched("no such folder");
}

static void
wrong_arguments_are_explained(void)
{
    const char *const wrong[] = {
        "$tri voronoi $d/in.node 2>$d/err",
        "$tri voronoi -o - $d/in.node 2>$d/err",
        "$tri voronoi -o $d/x 2>$d/err",
        "$tri voronoi --svg - --per-triangle x 2>$d/err"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        CLAIM("voronoi.usage",
              shell(wrong[i]) == 2 &&
                  is_text("err", "usage: tri voronoi", false),
              "%s", wrong[i]);
}

int
main(int argc, char **argv)
{
    /* This program is BUILD/test/NAME; the one it drives is BUILD/tri. */
    char program[500];
    const char *slash = strrchr(argv[0], '/');
    int length = slash != NULL ? (int)(slash - argv[0]) : 1;
    const char *folder = slash != NULL ? argv[0] : ".";
    snprintf(scratch, sizeof scratch, "%.*s/voronoi.XXXXXX", length, folder);
    snprintf(program, sizeof program, "%.*s/../tri", length, folder);
    setenv("tri", getenv("TRI") != NULL ? getenv("TRI") : program, 1);
    if (mkdtemp(scratch) == NULL) {
        perror(scratch);
        return 2;
    }
    setenv("d", scratch, 1);

    test_begin(argc, argv,
               "tri voronoi writes the diagram, all of its files or none");
    test_random("a vertex for each triangle", per_triangle_files_agree, 150,
                40);
    test_random("merged vertices", vertices_are_merged, 100, 40);
    test_run("known files", known_files);
    test_run("refusals leave old files", refusals_leave_old_files);
    test_run("wrong arguments are explained", wrong_arguments_are_explained);
    int status = test_end((test_minima){.trials = 200, .largest_n = 30});
    shell("rm -r \"$d\"");
    return status;
}
