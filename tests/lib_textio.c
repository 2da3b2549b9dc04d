/* lib/textio: what is written reads back the same; whatever else is read is read
 * to its end or refused with a line and a reason.
 *
 * Hypotheses: none for reading; what is written has finite coordinates.
 */
#include "lib/binary.h"
#include "lib/memory.h"
#include "lib/textio.h"
#include "tests/harness/harness.h"

#include <stdlib.h>
#include <string.h>

static bool
same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* ---- Whole files. ---- */

/* A text in memory, as long as its array: a sanitizer sees who reads behind it. */
typedef struct text {
    char *bytes;
    size_t size;
} text;

static text
copy_text(const char *bytes, size_t size)
{
    text t = {malloc(size + (size == 0)), size};
    if (t.bytes == NULL)
        abort();
    memcpy(t.bytes, bytes, size);
    return t;
}

static text
written_points(const point2 *points, uint32_t n, uint32_t first)
{
    text t;
    FILE *file = open_memstream(&t.bytes, &t.size);
    if (file == NULL)
        abort();
    text_write_points(file, points, n, first);
    fclose(file);
    return t;
}

static bool
same_points(const text_points *read, const point2 *points, uint32_t n)
{
    if (read->count != n)
        return false;
    for (uint32_t i = 0; i < n; i++)
        if (!same_bits(read->points[i].x, points[i].x) ||
            !same_bits(read->points[i].y, points[i].y))
            return false;
    return true;
}

static void
points_survive(const point2 *points, uint32_t n)
{
    for (uint32_t first = 0; first < 2; first++) {
        text t = written_points(points, n, first);
        text_points read;
        text_error error = {0, ""};
        tri_status status =
            text_parse_points("x.node", t.bytes, t.size, &read, &error);
        CLAIM("textio.round_trip",
              status == TRI_OK && same_points(&read, points, n),
              "%u points are not what was written (%s)", n, error.text);
        CLAIM("textio.first_index", n == 0 || read.first == first,
              "numbered from %u, read as from %u", first, read.first);
        text_points_free(&read);
        free(t.bytes);
    }
}

/* ---- Points as bits. ---- */

static text
binary_points(const point2 *points, uint32_t n)
{
    text t;
    FILE *file = open_memstream(&t.bytes, &t.size);
    if (file == NULL)
        abort();
    binary_write_points(file, points, n);
    fclose(file);
    return t;
}

/* The bytes are put together anew here, from the description in lib/binary.h. */
static void
check_bytes(const text *t, const point2 *points, uint32_t n)
{
    static const unsigned char header[12] = {0x89, 0x54, 0x52, 0x49, 0x0D, 0x0A,
                                             0x1A, 0x0A, 1,    0,    0,    0};
    CLAIM("binary.bytes",
          t->size == 16 + 16 * (size_t)n &&
              memcmp(t->bytes, header, sizeof header) == 0,
          "%u points: %zu bytes", n, t->size);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < 16; k++) {
            uint64_t bits;
            memcpy(&bits, k < 8 ? &points[i].x : &points[i].y, sizeof bits);
            unsigned char byte = (unsigned char)t->bytes[16 + 16 * i + k];
            CLAIM("binary.bytes", byte == (bits >> 8 * (k % 8) & 255),
                  "byte %zu of point %zu is %u", k, i, byte);
        }
}

/* Read in the machine's own memory, as long as the bytes: a sanitizer looks on. */
static tri_status
read_binary(const text *t, size_t size, text_points *read, text_error *error)
{
    text copy = copy_text(t->bytes, size);
    tri_status status = text_parse_points("x.node", copy.bytes, size, read, error);
    free(copy.bytes);
    return status;
}

static void
bits_survive(const point2 *points, uint32_t n)
{
    text t = binary_points(points, n);
    text_points read;
    text_error error = {0, ""};
    check_bytes(&t, points, n);
    CLAIM("binary.round_trip", read_binary(&t, t.size, &read, &error) == TRI_OK &&
          same_points(&read, points, n) && read.first == 0,
          "%u points are not what was written (%s)", n, error.text);
    text_points_free(&read);
    memory_fail_at(1);
    tri_status status = read_binary(&t, t.size, &read, &error);
    memory_fail_at(0);
    CLAIM("binary.memory", status == TRI_OUT_OF_MEMORY && read.points == NULL &&
          read.count == 0, "without memory: status %d", (int)status);

    size_t shorter = 8 + random_below(test_random_source(), (uint32_t)t.size - 8);
    CLAIM("binary.cut",
          read_binary(&t, shorter, &read, &error) == TRI_BAD_FILE &&
              read.points == NULL && read.count == 0 && error.line == 0 &&
              strncmp(error.text, "binary points", 13) == 0,
          "%zu of %zu bytes are read, or refused with: %s", shorter, t.size,
          error.text);
    free(t.bytes);
}

/* Triangles and edges of random vertices; no file cares what they look like. */
static void
lists_survive(const point2 *points, uint32_t n)
{
    HYPOTHESIS(n > 0);
    (void)points;
    random_source *source = test_random_source();
    uint32_t count = random_below(source, 50), first = random_below(source, 2);
    text_points domain = {.count = n, .first = first};
    vertex_id corner[50][3], ends[50][2];
    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            corner[i][k] = random_below(source, n);
        for (int k = 0; k < 2; k++)
            ends[i][k] = random_below(source, n);
    }
    text t, e;
    FILE *triangles = open_memstream(&t.bytes, &t.size);
    FILE *edges = open_memstream(&e.bytes, &e.size);
    if (triangles == NULL || edges == NULL)
        abort();
    text_write_triangles(triangles, (triangle_list){count, corner}, first);
    text_write_edges(edges, (edge_list){count, ends}, first);
    fclose(triangles);
    fclose(edges);

    triangle_list list;
    edge_list pairs;
    text_error error = {0, ""};
    tri_status status =
        text_parse_triangles(t.bytes, t.size, &domain, &list, &error);
    CLAIM("textio.round_trip", status == TRI_OK && list.count == count &&
          memcmp(list.corner, corner, count * sizeof *corner) == 0,
          "%u triangles are not what was written (%s)", count, error.text);
    status = text_parse_edges(e.bytes, e.size, &domain, &pairs, &error);
    CLAIM("textio.round_trip", status == TRI_OK && pairs.count == count &&
          memcmp(pairs.ends, ends, count * sizeof *ends) == 0,
          "%u edges are not what was written (%s)", count, error.text);
    triangle_list_free(&list);
    edge_list_free(&pairs);
    free(t.bytes);
    free(e.bytes);
}

/* ---- What is refused, and what is not. ---- */

typedef enum kind { POINTS, TRIANGLES, EDGES } kind;

/* Reads t as that kind, with triangles and edges among four points that are
 * numbered from 1. What is read is written and read again: the same. */
static tri_status
read_as(kind what, const char *name, text t, text_error *error)
{
    text_points four = {.count = 4, .first = 1}, points;
    triangle_list triangles;
    edge_list edges;
    tri_status status;
    *error = (text_error){0, ""};
    if (what == POINTS) {
        status = text_parse_points(name, t.bytes, t.size, &points, error);
        if (status == TRI_OK)
            points_survive(points.points, points.count);
        else
            CLAIM("textio.zeroed", points.points == NULL && points.count == 0,
                  "after status %d points are left", (int)status);
        text_points_free(&points);
    } else if (what == TRIANGLES) {
        status = text_parse_triangles(t.bytes, t.size, &four, &triangles, error);
        for (uint32_t i = 0; i < triangles.count; i++)
            CLAIM("textio.in_range", triangles.corner[i][0] < 4 &&
                  triangles.corner[i][1] < 4 && triangles.corner[i][2] < 4,
                  "triangle %u has a corner that is no point", (unsigned)i);
        CLAIM("textio.zeroed", status == TRI_OK || triangles.corner == NULL,
              "after status %d triangles are left", (int)status);
        triangle_list_free(&triangles);
    } else {
        status = text_parse_edges(t.bytes, t.size, &four, &edges, error);
        for (uint32_t i = 0; i < edges.count; i++)
            CLAIM("textio.in_range", edges.ends[i][0] < 4 && edges.ends[i][1] < 4,
                  "edge %u has an end that is no point", (unsigned)i);
        CLAIM("textio.zeroed", status == TRI_OK || edges.ends == NULL,
              "after status %d edges are left", (int)status);
        edge_list_free(&edges);
    }
    return status;
}

/* Read or refused with a reason, never anything else. */
static void
check_any_text(kind what, const char *name, text t)
{
    text_error error;
    tri_status status = read_as(what, name, t, &error);
    if (status == TRI_OK)
        return;
    unsigned long lines = 1;
    for (size_t i = 0; i < t.size; i++)
        lines += t.bytes[i] == '\n';
    CLAIM("textio.says_where", status == TRI_BAD_FILE && error.line >= 1 &&
          error.line <= lines && error.text[0] != '\0',
          "status %d, line %lu of %lu: \"%s\"", (int)status, error.line, lines,
          error.text);
    for (const char *c = error.text; *c != '\0'; c++)
        CLAIM("textio.printable", *c >= ' ' && *c <= '~', "code %d in the message",
              *c);
}

typedef struct sample {
    kind what;
    const char *name, *text;
    bool counted; /* the first line says how many lines follow */
} sample;

static const sample samples[] = {
    {POINTS, "s.node",
     "# four points\n4 2 1 1\n1 0 0 7 1\n2 1.5 -0 7 1\n\n3 1e3 1 8 0 # far\n"
     "4 0 .5 9 1\n", true},
    {POINTS, "s.csv", "name,lon,lat\n\"Here, there\",1,2\nB,3.5,-4e-2\n", false},
    {POINTS, "-", "0 0\n1 0\r\n 1\t1 \n# end\n", false},
    {TRIANGLES, "", "2 3 1\n0 1 2 3 0.5\n1 1 3 4 -2 # last\n", true},
    {TRIANGLES, "", "2 3 0\n1 1 2 3\n2 1 3 4\n", true},
    {EDGES, "", "3 1\n1 1 2 1\n2 2 3 0\n3 3 4 1\n", true},
};

enum { SAMPLES = sizeof samples / sizeof samples[0] };

static void
prefixes_are_read_or_refused(void)
{
    for (int s = 0; s < SAMPLES; s++) {
        size_t size = strlen(samples[s].text);
        for (size_t cut = 0; cut <= size; cut++) {
            text t = copy_text(samples[s].text, cut);
            check_any_text(samples[s].what, samples[s].name, t);
            free(t.bytes);
        }
    }
}

/* Where the first line says how many follow, none can be missing. */
static void
counted_lines_are_missed(void)
{
    for (int s = 0; s < SAMPLES; s++) {
        if (!samples[s].counted)
            continue;
        const char *end = samples[s].text + strlen(samples[s].text) - 1;
        while (end[-1] != '\n')
            end--;
        text_error error;
        text t = copy_text(samples[s].text, strlen(samples[s].text));
        tri_status status =
            read_as(samples[s].what, samples[s].name, t, &error);
        CLAIM("textio.whole", status == TRI_OK, "sample %d is not read: %s", s,
              error.text);
        t.size = (size_t)(end - samples[s].text);
        status = read_as(samples[s].what, samples[s].name, t, &error);
        CLAIM("textio.whole", status == TRI_BAD_FILE,
              "sample %d without its last line is read", s);
        free(t.bytes);
    }
}

static void
corruptions_are_read_or_refused(void)
{
    for (int s = 0; s < SAMPLES; s++) {
        text t = copy_text(samples[s].text, strlen(samples[s].text));
        for (size_t i = 0; i < t.size; i++) {
            char good = t.bytes[i];
            for (int byte = 0; byte < 256; byte++) {
                t.bytes[i] = (char)byte;
                check_any_text(samples[s].what, samples[s].name, t);
            }
            t.bytes[i] = good;
        }
        free(t.bytes);
    }
}

static void
any_bytes_are_read_or_refused(void)
{
    static const char likely[] = "0123456789.-+eE,\"# \t\r\n\nxynaif\xEF\xBB\xBF";
    random_source *source = test_random_source();
    for (int i = 0; i < 50000; i++) {
        char bytes[60];
        uint32_t size = random_below(source, sizeof bytes);
        for (uint32_t k = 0; k < size; k++)
            bytes[k] = likely[random_below(source, sizeof likely)];
        text t = copy_text(bytes, size);
        check_any_text(POINTS, "any.csv", t);
        check_any_text(POINTS, "any.node", t);
        check_any_text(POINTS, "any", t);
        check_any_text(TRIANGLES, "", t);
        check_any_text(EDGES, "", t);
        free(t.bytes);
    }
}

/* Texts that say the same as "2 points: (1,2) and (3,-4)". */
static void
spellings_are_read(void)
{
    static const struct {
        const char *name, *text;
    } same[] = {
        {"-", "1 2\n3 -4\n"},
        {"-", "1 2\n3 -4"},
        {"-", "1 2\r\n3 -4\r\n"},
        {"-", "\xEF\xBB\xBFx y\n1 2\n3 -4\n"},
        {"-", "\n# two\n\t1.0   2e0 \n\n+3.\t-.4E+1\n\n"},
        {"-", "1,2\n3,-4\n"},
        {"-", "a,b\n1,2\n3,-4\n"},
        {"-", "Y,X\n2,1\n-4,3\n"},
        {"-", "lat,lon\n2,1\n-4,3\n"},
        {"-", "lat,lon,x,y\n9,9,1,2\n9,9,3,-4\n"},
        {"-", "x,lon,lat\n9,1,2\n9,3,-4\n"},
        {"-", "name, \"LON\" ,Lat\n\"a, \"\"b\"\"\",\"1\", 2\nc,3,-4\n"},
        {"-", "1,2,,\n3,-4,,\n"},
        {"-", "1 2 0\n3 -4 0\n"},
        {"x.csv", "1 2 0 0\n3 -4 0 0\n"},
        {"-", "2 2 0 0\n0 1 2\n1 3 -4\n"},
        {"x.node", "2\n1 1 2\n2 3 -4\n"},
        {"x.node", "2 2 2 1 # all\n0 1 2 5 6 1\n#\n1 3 -4 5 6 -1\n"},
    };
    const point2 expected[2] = {{1, 2}, {3, -4}};
    for (size_t s = 0; s < sizeof same / sizeof same[0]; s++) {
        text_points points;
        text_error error = {0, ""};
        text t = copy_text(same[s].text, strlen(same[s].text));
        tri_status status =
            text_parse_points(same[s].name, t.bytes, t.size, &points, &error);
        CLAIM("textio.spelling",
              status == TRI_OK && same_points(&points, expected, 2),
              "spelling %u: %u points, line %lu: %s", (unsigned)s,
              (unsigned)points.count, error.line, error.text);
        text_points_free(&points);
        free(t.bytes);
    }
}

static void
long_lines_are_read(void)
{
    enum { ZEROS = 1000000 };
    text t = {malloc(ZEROS + 100), 0};
    if (t.bytes == NULL)
        abort();
    t.size = (size_t)sprintf(t.bytes, "name,x,y\n\"");
    memset(t.bytes + t.size, 'a', ZEROS / 2);
    t.size += ZEROS / 2;
    t.size += (size_t)sprintf(t.bytes + t.size, "\",0.");
    memset(t.bytes + t.size, '0', ZEROS / 2);
    t.size += ZEROS / 2;
    t.size += (size_t)sprintf(t.bytes + t.size, "5e500001,2\n");
    text_points points;
    text_error error = {0, ""};
    tri_status status = text_parse_points("-", t.bytes, t.size, &points, &error);
    CLAIM("textio.long_lines", status == TRI_OK && points.count == 1 &&
          points.points[0].x == 5 && points.points[0].y == 2,
          "line %lu: %s", error.line, error.text);
    text_points_free(&points);
    free(t.bytes);
}

/* ---- Memory. ---- */

/* The k-th allocation fails, for every k until none is left to fail. */
static void
memory_may_end_anywhere(void)
{
    for (int s = 0; s < SAMPLES; s++) {
        text t = copy_text(samples[s].text, strlen(samples[s].text));
        text_points four = {.count = 4, .first = 1};
        for (unsigned long k = 1;; k++) {
            text_points points = {0};
            triangle_list triangles = {0};
            edge_list edges = {0};
            text_error error = {0, ""};
            memory_fail_at(k);
            tri_status status =
                samples[s].what == POINTS ? text_parse_points(
                    samples[s].name, t.bytes, t.size, &points, &error) :
                samples[s].what == TRIANGLES ? text_parse_triangles(
                    t.bytes, t.size, &four, &triangles, &error) :
                text_parse_edges(t.bytes, t.size, &four, &edges, &error);
            memory_fail_at(0);
            if (status == TRI_OK) {
                CLAIM("textio.memory", k > 1, "sample %d needs no memory", s);
                text_points_free(&points);
                triangle_list_free(&triangles);
                edge_list_free(&edges);
                break;
            }
            CLAIM("textio.memory", status == TRI_OUT_OF_MEMORY &&
                  points.points == NULL && points.count == 0 &&
                  triangles.corner == NULL && edges.ends == NULL &&
                  error.text[0] != '\0', "sample %d, allocation %lu: status %d",
                  s, k, (int)status);
        }
        free(t.bytes);
    }
}

/* The same for a file, whose bytes need memory too; and there is no file. */
static void
memory_may_end_in_a_file(void)
{
    for (unsigned long k = 1;; k++) {
        text_points points;
        text_error error = {0, ""};
        memory_fail_at(k);
        tri_status status =
            text_read_points("docs/data/coast.node", &points, &error);
        memory_fail_at(0);
        if (status == TRI_OK) {
            CLAIM("textio.memory", k > 2 && points.count > 0, "k is %lu", k);
            text_points_free(&points);
            break;
        }
        CLAIM("textio.memory", status == TRI_OUT_OF_MEMORY && points.points == NULL,
              "allocation %lu: status %d", k, (int)status);
    }
    text_points points;
    text_error error = {7, ""};
    tri_status status = text_read_points("docs/data/nothing", &points, &error);
    CLAIM("textio.says_where", status == TRI_CANNOT_READ && error.line == 0 &&
          error.text[0] != '\0', "a file that is not there: status %d",
          (int)status);
    status = text_read_points("docs/data", &points, &error);
    CLAIM("textio.says_where", status == TRI_CANNOT_READ, "a folder: status %d",
          (int)status);
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/textio: files are read whole, or refused");
    test_random("points survive", points_survive, 2000, 200);
    test_near_degenerate("points survive, at every magnitude", points_survive,
                         2000, 50);
    test_random("bits survive", bits_survive, 500, 200);
    test_near_degenerate("bits survive, at every magnitude", bits_survive, 500, 50);
    test_random("triangles and edges survive", lists_survive, 500, 200);
    test_run("spellings of the same points", spellings_are_read);
    test_run("lines of a million bytes", long_lines_are_read);
    test_run("every prefix is read or refused", prefixes_are_read_or_refused);
    test_run("a missing line is missed", counted_lines_are_missed);
    test_run("every corrupted byte is read or refused",
             corruptions_are_read_or_refused);
    test_run("any bytes are read or refused", any_bytes_are_read_or_refused);
    test_run("memory may end anywhere", memory_may_end_anywhere);
    test_run("memory may end while a file is read", memory_may_end_in_a_file);
    return test_end((test_minima){.trials = 4500, .largest_n = 150});
}
