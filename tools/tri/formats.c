/* formats.c - the files that `tri triangulate -o` can write. */
#include "tools/tri/formats.h"

#include "lib/decimal.h"
#include "lib/memory.h"

#include <assert.h>
#include <string.h>

static void
put_whole(FILE *file, uint64_t number, const char *after)
{
    fprintf(file, "%llu%s", (unsigned long long)number, after);
}

static void
put_point(FILE *file, point2 p, const char *between, const char *after)
{
    char x[DECIMAL_ROOM], y[DECIMAL_ROOM];
    decimal_write(x, p.x);
    decimal_write(y, p.y);
    fprintf(file, "%s%s%s%s", x, between, y, after);
}

/* ---- Triangle (Shewchuk 1996). ---- */

static tri_status
write_ele(FILE *file, const text_points *points, triangle_list list)
{
    text_write_triangles(file, list, points->first);
    return TRI_OK;
}

/* The neighbour opposite corner i lies across the side after it, which runs from
 * corner i+1 to corner i+2. */
static tri_status
write_neigh(FILE *file, const text_points *points, triangle_list list)
{
    halfedge_id repeated, *twin = memory_array(list.count, 3 * sizeof *twin);
    if (twin == NULL)
        return TRI_OUT_OF_MEMORY;
    tri_status status = triangle_list_twins(list, twin, &repeated);
    assert(status != TRI_OK || repeated == NONE);
    if (status == TRI_OK) {
        put_whole(file, list.count, " 3\n");
        for (triangle_id t = 0; t < list.count; t++) {
            put_whole(file, (uint64_t)points->first + t, "");
            for (halfedge_id i = 0; i < 3; i++) {
                halfedge_id across = twin[3 * t + (i + 1) % 3];
                fputc(' ', file);
                if (across == NONE)
                    fputs("-1", file);
                else
                    put_whole(file, (uint64_t)points->first + across / 3, "");
            }
            fputc('\n', file);
        }
    }
    memory_free(twin);
    return status;
}

/* ---- Surfaces in space: the plane z = 0. ---- */

/* The corners of the triangles, one triangle a line. */
static void
put_corners(FILE *file, const char *before, triangle_list list, uint32_t first)
{
    for (triangle_id t = 0; t < list.count; t++) {
        fputs(before, file);
        put_whole(file, (uint64_t)first + list.corner[t][0], " ");
        put_whole(file, (uint64_t)first + list.corner[t][1], " ");
        put_whole(file, (uint64_t)first + list.corner[t][2], "\n");
    }
}

/* The first line but one counts points, faces and edges; nobody reads the last. */
static tri_status
write_off(FILE *file, const text_points *points, triangle_list list)
{
    fputs("OFF\n", file);
    put_whole(file, points->count, " ");
    put_whole(file, list.count, " 0\n");
    for (uint32_t i = 0; i < points->count; i++)
        put_point(file, points->points[i], " ", " 0\n");
    put_corners(file, "3 ", list, 0);
    return TRI_OK;
}

static tri_status
write_obj(FILE *file, const text_points *points, triangle_list list)
{
    fputs("# ", file);
    put_whole(file, points->count, " points, ");
    put_whole(file, list.count, " triangles\n");
    for (uint32_t i = 0; i < points->count; i++) {
        fputs("v ", file);
        put_point(file, points->points[i], " ", " 0\n");
    }
    put_corners(file, "f ", list, 1);
    return TRI_OK;
}

/* ---- Maps. ---- */

/* RFC 7946: a polygon's ring is counterclockwise and ends with its first position. A
 * feature is a triangle; it and its corners are numbered as in the .ele file. */
static void
put_feature(FILE *file, const text_points *points, triangle_list list, triangle_id t)
{
    const vertex_id *corner = list.corner[t];
    fputs("{\"type\":\"Feature\",\"id\":", file);
    put_whole(file, (uint64_t)points->first + t, ",\"properties\":{\"corners\":[");
    put_whole(file, (uint64_t)points->first + corner[0], ",");
    put_whole(file, (uint64_t)points->first + corner[1], ",");
    put_whole(file, (uint64_t)points->first + corner[2], "]},");
    fputs("\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[", file);
    for (int i = 0; i <= 3; i++) {
        fputc('[', file);
        put_point(file, points->points[corner[i % 3]], ",", i < 3 ? "]," : "]]]}}");
    }
}

static tri_status
write_geojson(FILE *file, const text_points *points, triangle_list list)
{
    fputs("{\"type\":\"FeatureCollection\",\"features\":[", file);
    for (triangle_id t = 0; t < list.count; t++) {
        fputs(t > 0 ? ",\n" : "\n", file);
        put_feature(file, points, list, t);
    }
    fputs("\n]}\n", file);
    return TRI_OK;
}

/* ---- The table. ---- */

const format formats[] = {
    {".ele", write_ele, "triangles, their corners numbered as in IN"},
    {".neigh", write_neigh, "neighbours of those opposite their corners, -1 outside"},
    {".off", write_off, "points and triangles, for programs that show surfaces"},
    {".obj", write_obj, "the same for others"},
    {".geojson", write_geojson, "a polygon for each triangle, for maps (x lon, y lat)"},
    {NULL, NULL, NULL},
};

const format *
format_of(const char *path)
{
    size_t length = strlen(path);
    if (strcmp(path, "-") == 0 || strncmp(path, "/dev/", 5) == 0)
        return &formats[0];
    for (const format *f = formats; f->ending != NULL; f++) {
        size_t tail = strlen(f->ending);
        if (length > tail && strcmp(path + length - tail, f->ending) == 0)
            return f;
    }
    return NULL;
}
