/* trace.c - tri trace: an algorithm step by step, as JSON (docs/trace.md). */
#include "tools/tri/tri.h"

#include "lib/decimal.h"
#include "tools/tri/tracer.h"

#include <string.h>

/* More is nothing that people watch. */
enum { MOST_POINTS = 10000, MOST_STEPS = 1000000 };

static void
write_head(FILE *file, const algorithm *a, const text_points *in)
{
    const figure_steps *figure = a->steps;
    fprintf(file, "{\"format\": \"tri-trace 1\",\n \"algorithm\": \"%s\",\n"
            " \"section\": \"%s\",\n \"figure\": {\"name\": \"%s\", \"lines\": [",
            a->name, a->section, figure->figure);
    for (const figure_line *line = figure->lines; line->label != NULL; line++)
        fprintf(file, "%s\n  {\"label\": \"%s\", \"text\": \"%s\"}",
                line > figure->lines ? "," : "", line->label, line->text);
    fprintf(file, "]},\n \"points\": [");
    for (uint32_t v = 0; v < in->count; v++) {
        char x[DECIMAL_ROOM], y[DECIMAL_ROOM];
        decimal_write(x, in->points[v].x);
        decimal_write(y, in->points[v].y);
        fprintf(file, "%s\n  [%s, %s]", v > 0 ? "," : "", x, y);
    }
    fprintf(file, "],\n \"steps\": [");
}

static void
write_trace(FILE *file, const algorithm *a, tri_options options, const text_points *in)
{
    write_head(file, a, in);
    mesh m;
    tracer w = tracer_begin(file, a->steps, in->points, MOST_STEPS);
    options.trace = &w.base;
    tri_status status = a->triangulate(in->points, in->count, &options, &m);
    if (status == TRI_CANCELLED)
        die("tri trace: there are more than %d steps; take fewer points", MOST_STEPS);
    must(status);
    tracer_end(&w);
    fprintf(file, "]}\n");
    note_copies(in->count, m.locations);
    mesh_free(&m);
}

/* The algorithm of that name. */
static const algorithm *
find_watchable(const char *name)
{
    char all[200] = "";
    for (uint32_t i = 0; i < contents_count; i++)
        if (contents[i].steps != NULL)
            strcat(strcat(all, " "), contents[i].name);
    if (name == NULL)
        die_usage("trace", "--algorithm is missing; after it:%s", all);
    const algorithm *a = contents_find(name);
    if (a == NULL)
        die_usage("trace", "there is no algorithm %s; needed is one of:%s", name, all);
    if (a->steps == NULL)
        die_usage("trace", "%s reports no steps; these do:%s", name, all);
    return a;
}

int
command_trace(int argc, char **argv)
{
    tri_options options = parse_options(&argc, argv);
    const algorithm *a = find_watchable(take_option(&argc, argv, "--algorithm"));
    const char *path = take_option(&argc, argv, "-o");
    expect_words(argc, argv, 1, 1);
    if (path == NULL)
        path = "-";
    check_output(path);
    text_points in = load_points(argv[1]);
    if (in.count > MOST_POINTS)
        die("tri trace: %lu points are too many to watch; take at most %d",
            (unsigned long)in.count, MOST_POINTS);

    output o = begin_output(path);
    write_trace(o.file, a, options, &in);
    finish_output(&o, path);
    text_points_free(&in);
    return EXIT_HOLDS;
}
