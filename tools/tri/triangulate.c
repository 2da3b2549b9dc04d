/* triangulate.c - tri triangulate. */
#include "tools/tri/tri.h"

#include "lib/decimal.h"
#include "tools/tri/formats.h"
#include "tools/tri/watch.h"

#include <string.h>

const algorithm *
default_algorithm(void)
{
    const algorithm *last = &contents[0];
    for (uint32_t i = 0; i < contents_count; i++)
        if (contents[i].delaunay)
            last = &contents[i];
    return last;
}

/* What was asked for. */
typedef struct request {
    const algorithm *algorithm;
    tri_options options;
    const char *triangles, *picture; /* where to; NULL: not wanted */
    const format *format;            /* of the triangles */
    bool stats;
    const char *points;
} request;

static point2
parse_direction(const char *name, const char *text)
{
    point2 d = {0, 0};
    const char *comma = strchr(text, ',');
    bool good = comma != NULL &&
        decimal_read(text, (size_t)(comma - text), &d.x) == DECIMAL_NUMBER &&
        decimal_read(comma + 1, strlen(comma + 1), &d.y) == DECIMAL_NUMBER;
    if (!good || (d.x == 0 && d.y == 0))
        die_usage(name, "--direction %s: needed are two numbers, not "
                  "both 0, with a comma between them, such as 0,1", text);
    return d;
}

/* The place of a word among those that an option takes, in the order of its enum. */
static int
parse_word(const char *name, const char *option, const char *text,
           const char *const words[], int count)
{
    char all[100] = "";
    for (int i = 0; i < count; i++) {
        if (strcmp(text, words[i]) == 0)
            return i;
        strcat(all, " ");
        strcat(all, words[i]);
    }
    die_usage(name, "%s %s: needed is one of:%s", option, text, all);
}

tri_options
parse_options(int *argc, char **argv)
{
    static const char *const cuts[] = {"vertical", "alternating"};
    static const char *const locators[] = {"walk", "buckets", "history", "grid"};
    tri_options options = tri_options_default();
    const char *text;
    if ((text = take_option(argc, argv, "--direction")) != NULL)
        options.direction = parse_direction(argv[0], text);
    if ((text = take_option(argc, argv, "--cuts")) != NULL)
        options.cuts = (tri_cuts)parse_word(argv[0], "--cuts", text, cuts, 2);
    if ((text = take_option(argc, argv, "--locator")) != NULL)
        options.locator =
            (tri_locator)parse_word(argv[0], "--locator", text, locators, 4);
    if ((text = take_option(argc, argv, "--seed")) != NULL)
        options.seed = parse_whole(argv[0], "--seed", text, UINT64_MAX);
    if ((text = take_option(argc, argv, "--threads")) != NULL)
        options.threads = (uint32_t)parse_whole(argv[0], "--threads", text, UINT32_MAX);
    if (options.threads == 0)
        die_usage(argv[0], "--threads 0: somebody has to do it");
    return options;
}

static bool
is_stdout(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

static const format *
parse_format(const char *path)
{
    char endings[100] = "";
    for (const format *f = formats; f->ending != NULL; f++) {
        strcat(endings, " ");
        strcat(endings, f->ending);
    }
    const format *found = format_of(path);
    if (found == NULL)
        die_usage("triangulate", "-o %s: its ending says what to write:%s", path,
                  endings);
    return found;
}

static request
parse(int argc, char **argv)
{
    request r = {.algorithm = default_algorithm(),
                 .options = parse_options(&argc, argv)};
    const char *name = take_option(&argc, argv, "--algorithm");
    r.triangles = take_option(&argc, argv, "-o");
    r.picture = take_option(&argc, argv, "--svg");
    r.stats = take_flag(&argc, argv, "--stats");
    expect_words(argc, argv, 1, 1);
    r.points = argv[1];
    if (name != NULL)
        r.algorithm = contents_find(name);
    if (r.algorithm == NULL)
        die_usage(argv[0], "there is no algorithm %s", name);
    if (r.triangles == NULL && r.picture == NULL && !r.stats)
        r.triangles = "-";
    if (is_stdout(r.triangles) + is_stdout(r.picture) + r.stats > 1)
        die_usage(argv[0], "of -o, --svg, --stats only one can have standard "
                  "output: name files");
    check_output(r.triangles);
    check_output(r.picture);
    if (r.triangles != NULL)
        r.format = parse_format(r.triangles);
    return r;
}

int
command_triangulate(int argc, char **argv)
{
    request r = parse(argc, argv);
    text_points in = load_points(r.points);
    mesh m;
    triangle_list list;
    tell_progress("triangulating by %s", r.algorithm->name);
    must(run_watched(r.algorithm, in.points, in.count, r.options, r.stats, &m));
    must(mesh_triangles(&m, &list));
    note_degenerate(in.count, m.locations, list.count);

    if (r.triangles != NULL) {
        output o = begin_output(r.triangles);
        must(r.format->write(o.file, &in, list));
        finish_output(&o, r.triangles);
    }
    if (r.picture != NULL)
        write_picture(r.picture, r.algorithm->summary, &in, list);
    triangle_list_free(&list);
    mesh_free(&m);
    text_points_free(&in);
    return EXIT_HOLDS;
}
