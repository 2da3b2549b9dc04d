/* The command tri trace: what it writes is JSON, and whoever takes away and adds the
 * edges that it names has, after each step, the edges of the mesh. It refuses the rest
 * without harm.
 *
 * What its sentences say is asked in tools_trace_says.
 */
#include "lib/edges.h"
#include "tests/harness/harness.h"
#include "tests/harness/replay.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- The edges after each step. ---- */

/* A set of edges, as a number; none at all is 0. Equal sets have equal numbers, and
 * others hardly ever: an edge is a random number of 64 bits, and a set their sum. */
static uint64_t
number_of_edge(vertex_id a, vertex_id b)
{
    random_source random = random_from_seed(a < b ? (uint64_t)a << 32 | b
                                                  : (uint64_t)b << 32 | a);
    return random_bits(&random);
}

/* All sets that there have been, each different from the one before. */
typedef struct history_of_edges {
    trace observer; /* first: see lib/trace.h */
    uint32_t count, room;
    uint64_t *set;
} history_of_edges;

static void
remember(history_of_edges *h, uint64_t set)
{
    if (set == (h->count > 0 ? h->set[h->count - 1] : 0))
        return;
    if (h->count == h->room) {
        h->room = 2 * h->room + 100;
        h->set = realloc(h->set, h->room * sizeof *h->set);
        CLAIM("trace.setup", h->set != NULL, "memory is out");
    }
    h->set[h->count++] = set;
}

static int
see(trace *self, const mesh *m, const trace_event *event)
{
    (void)event;
    uint64_t set = 0;
    edge_list edges;
    CLAIM("trace.setup", mesh_edges(m, NULL, &edges) == TRI_OK, "memory is out");
    for (uint32_t i = 0; i < edges.count; i++)
        set += number_of_edge(edges.ends[i][0], edges.ends[i][1]);
    edge_list_free(&edges);
    remember((history_of_edges *)self, set);
    return 0;
}

static uint64_t
set_of(const replay *r)
{
    uint64_t set = 0;
    for (vertex_id a = 0; a < r->n; a++)
        for (vertex_id b = a + 1; b < r->n; b++)
            set += r->edge[a][b] ? number_of_edge(a, b) : 0;
    return set;
}

/* ---- What belongs to all steps. ---- */

/* A line of the figure, or none. */
static void
check_line(const replay *r, const json *step)
{
    const char *label = step_text(step, "line");
    const json *lines = json_member(json_member(r->root, "figure"), "lines");
    bool found = label[0] == '\0';
    for (size_t i = 0; lines != NULL && i < lines->count && !found; i++)
        found = strcmp(step_text(&lines->item[i], "label"), label) == 0;
    CLAIM("trace.line", found, "the figure has no line %s", label);
}

static void
check_event(const json *step)
{
    static const char all[] =
        " start attach pop flip push bridge visit locate split move keep ";
    char word[40];
    snprintf(word, sizeof word, " %.30s ", step_text(step, "event"));
    CLAIM("trace.event", strstr(all, word) != NULL, "there is no event%s", word);
    CLAIM("trace.event", step_text(step, "say")[0] != '\0', "a step says nothing");
}

static void
check_head(const replay *r, const algorithm *a, const point2 *points)
{
    const json *given = json_member(r->root, "points");
    CLAIM("trace.head", strcmp(step_text(r->root, "format"), "tri-trace 1") == 0 &&
          strcmp(step_text(r->root, "algorithm"), a->name) == 0 &&
          strcmp(step_text(r->root, "section"), a->section) == 0,
          "the format, the algorithm or the section is wrong");
    CLAIM("trace.points", given != NULL && given->count == r->n,
          "the points are not there");
    for (uint32_t i = 0; i < r->n; i++) {
        const json *xy = &given->item[i];
        CLAIM("trace.points", xy->kind == JSON_ARRAY && xy->count == 2 &&
              xy->item[0].number == points[i].x && xy->item[1].number == points[i].y,
              "point %u is another", i);
    }
}

static void
edges_are_those_of_the_mesh(const point2 *points, uint32_t n)
{
    for (uint32_t i = 0; i < contents_count; i++) {
        if (contents[i].steps == NULL)
            continue;
        watched_run run = random_run(&contents[i]);
        history_of_edges mesh_had = {.observer = {see}}, steps_had = {.count = 0};
        mesh m;
        run.options.trace = &mesh_had.observer;
        tri_status status = contents[i].triangulate(points, n, &run.options, &m);
        CLAIM("trace.setup", status == TRI_OK, "%s", tri_status_text(status));

        static replay r; /* too large for some stacks */
        replay_begin(&r, &run, points, n);
        check_head(&r, &contents[i], points);
        for (const json *step; (step = replay_peek(&r)) != NULL;) {
            check_line(&r, step);
            check_event(step);
            replay_step(&r);
            remember(&steps_had, set_of(&r));
        }
        CLAIM("trace.mesh", steps_had.count == mesh_had.count,
              "tri trace %s: the edges of "
              "the mesh change %u times, those of the steps %u times",
              run.words, mesh_had.count, steps_had.count);
        for (uint32_t k = 0; k < steps_had.count; k++)
            CLAIM("trace.mesh", steps_had.set[k] == mesh_had.set[k],
                  "tri trace %s: change %u of the edges is another", run.words, k);
        CLAIM("trace.stack", r.on_stack == 0,
              "tri trace %s: the stack is not empty at the "
              "end",
              run.words);
        for (vertex_id v = 0; v < n; v++)
            CLAIM("trace.replay", r.is_vertex[v] == (mesh_leaving(&m, v) != NONE),
                  "tri trace %s: %u is a vertex, or is not", run.words, v);
        replay_free(&r);
        free(mesh_had.set);
        free(steps_had.set);
        mesh_free(&m);
    }
}

/* ---- What is promised otherwise. ---- */

/* The edges that have come and not gone, sorted. */
static const char edges_of_trace[] =
    "awk 'function each(list, sign) { "
    "         while (match(list, /\\[[0-9]+,[0-9]+\\]/)) { "
    "             split(substr(list, RSTART + 1, RLENGTH - 2), end, \",\"); "
    "             there[end[1] \" \" end[2]] += sign; "
    "             list = substr(list, RSTART + RLENGTH) } } "
    "     match($0, /\"remove\": [][0-9,]*/) { each(substr($0, RSTART, RLENGTH), -1) } "
    "     match($0, /\"add\": [][0-9,]*/) { each(substr($0, RSTART, RLENGTH), 1) } "
    "     END { for (e in there) if (there[e] == 1) print e }' $d/t.json | sort";

/* The last edges, once more and without this test's reader: those of the triangles and
 * of the hull that the program finds. */
static void
last_edges_are_those_of_triangulate(void)
{
    const char *const inputs[] = {"uniform 40", "grid 25", "collinear 9", "uniform 2",
                                  "uniform 1", "uniform 0", "circle 30"};
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; i++) {
        for (uint32_t k = 0; k < contents_count; k++) {
            const char *name = contents[k].name;
            if (contents[k].steps == NULL)
                continue;
            int status = shell(
                "$tri generate %s -o $d/p.node || exit 3; "
                "$tri trace --algorithm %s -o $d/t.json $d/p.node || exit 4; "
                "$tri triangulate --algorithm %s -o $d/t.ele $d/p.node 2>$d/err || "
                "    exit 5; "
                "{ awk 'NR > 1 { print $2, $3; print $3, $4; print $4, $2 }' $d/t.ele; "
                "  $tri hull $d/p.node 2>$d/err | awk 'NR > 1 { print $2, $3 }'; } | "
                "awk '{ print $1 < $2 ? $1 \" \" $2 : $2 \" \" $1 }' | "
                "    sort -u >$d/there; "
                "%s >$d/here; cmp $d/here $d/there >$d/err 2>&1",
                inputs[i], name, name, edges_of_trace);
            CLAIM("trace.triangulate", status == 0, "%s, %s: exit status %d: %s",
                  inputs[i], name, status, read_scratch("err").text);
        }
    }
}

static void
the_same_bytes_twice_and_through_pipes(void)
{
    shell("$tri generate uniform 20 -o $d/p.node");
    for (uint32_t k = 0; k < contents_count; k++) {
        if (contents[k].steps == NULL)
            continue;
        int status = shell(
            "$tri trace --algorithm %s -o $d/1.json $d/p.node || exit 3; "
            "$tri trace --algorithm %s - <$d/p.node >$d/2.json || exit 4; "
            "cmp $d/1.json $d/2.json >$d/err 2>&1", contents[k].name, contents[k].name);
        CLAIM("trace.same", status == 0, "%s: exit status %d: %s", contents[k].name,
              status, read_scratch("err").text);
    }
}

/* Each line that the section's table names is lit by some step. */
static void
every_line_of_the_tables_is_lit(void)
{
    point2 points[50];
    for (int i = 0; i < 50; i++)
        points[i] = (point2){(double)(i * 37 % 101), (double)(i * i * 17 % 103)};
    for (uint32_t i = 0; i < contents_count; i++) {
        const figure_steps *figure = contents[i].steps;
        if (figure == NULL)
            continue;
        static replay r;
        watched_run run = {.algorithm = &contents[i]};
        snprintf(run.words, sizeof run.words, "--algorithm %s --locator walk",
                 contents[i].name);
        replay_begin(&r, &run, points, 50);
        for (int kind = 0; kind < STEP_KINDS; kind++) {
            const char *label = figure->label[kind];
            bool lit = label == NULL;
            for (size_t k = 0; k < r.steps->count && !lit; k++)
                lit = strcmp(step_text(&r.steps->item[k], "line"), label) == 0;
            CLAIM("trace.line", lit, "%s of %s is never lit", label, figure->figure);
        }
        replay_free(&r);
    }
}

/* docs/trace.md shows the trace of three points in full. */
static void
the_document_shows_what_is_written(void)
{
    int status = shell(
        "awk '/^```json$/ { on = 1; next } /^```$/ { on = 0 } on' docs/trace.md "
        "    >$d/doc.json; "
        "printf '0 0\\n3 0\\n0 4\\n' >$d/three.xy; "
        "$tri trace --algorithm sweep -o $d/three.json $d/three.xy || exit 3; "
        "cmp $d/doc.json $d/three.json >$d/err 2>&1");
    CLAIM("trace.document", status == 0, "docs/trace.md shows another text: %s",
          read_scratch("err").text);
}

/* ---- What is refused. ---- */

static void
refuse(const char *arguments, const char *reason)
{
    int status = shell("echo old >$d/old.json; "
                       "$tri trace %s -o $d/old.json >$d/out 2>$d/err", arguments);
    CLAIM("trace.refused", status == 2 && has("err", reason),
          "tri trace %s: exit status "
          "%d: %s",
          arguments, status, read_scratch("err").text);
    CLAIM("trace.refused",
          strcmp(read_scratch("old.json").text, "old\n") == 0 &&
              shell("ls $d/*.part >$d/out 2>&1") != 0,
          "tri trace %s: the old file is gone, or "
          "an unfinished one is left",
          arguments);
}

static void
the_rest_is_refused(void)
{
    shell("$tri generate uniform 10 -o $d/p.node; "
          "$tri generate uniform 10001 -o $d/many.node; "
          "$tri generate parabola 3000 -o $d/slow.node");
    refuse("--algorithm brute $d/p.node", "brute reports no steps; these do: sweep ");
    refuse("--algorithm lift $d/p.node", "lift reports no steps");
    refuse("--algorithm bubble $d/p.node", "there is no algorithm bubble");
    refuse("$d/p.node", "--algorithm is missing");
    refuse("--algorithm sweep", "something is missing");
    refuse("--algorithm sweep $d/p.node $d/p.node", "one word too many");
    refuse("--algorithm sweep --svg $d/p.node", "there is no option --svg");
    refuse("--algorithm divide --cuts skew $d/p.node", "--cuts skew");
    refuse("--algorithm incremental --locator luck $d/p.node", "--locator luck");
    refuse("--algorithm sweep --direction 0,0 $d/p.node", "usage: tri trace");
    refuse("--algorithm sweep $d/missing.node", "missing.node: cannot be ");
    refuse("--algorithm sweep tests/bad_files/line4_infinity.node",
           "infinity.node:4: ");
    refuse("--algorithm sweep $d/many.node", "10001 points are too many to watch");
    refuse("--algorithm lawson $d/slow.node", "more than 1000000 steps");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "tri trace: each step's edges are those of the mesh");
    test_random("edges of random points", edges_are_those_of_the_mesh, 60, 40);
    test_near_degenerate("edges of nearly degenerate points",
                         edges_are_those_of_the_mesh, 150, 20);
    test_run("the last edges are those of tri triangulate",
             last_edges_are_those_of_triangulate);
    test_run("the same bytes", the_same_bytes_twice_and_through_pipes);
    test_run("every line of the tables is lit", every_line_of_the_tables_is_lit);
    test_run("the document's example", the_document_shows_what_is_written);
    test_run("the rest is refused", the_rest_is_refused);
    int status = test_end((test_minima){.trials = 200, .largest_n = 30, .zeros = 1000});
    shell_end();
    return status;
}
