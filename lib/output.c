/* output.c - files that appear whole, or not at all. */
#include "lib/output.h"

#include "lib/memory.h"

#include <string.h>

/* Replacing a device by a file would be a strange way to write to it. */
static int
is_device(const char *path)
{
    return strncmp(path, "/dev/", 5) == 0;
}

/* Opens o->beside under the first name that is free: "x" makes looking and
 * creating one step, so two programs never share a file. */
static FILE *
open_beside(const output *o, size_t room)
{
    for (unsigned i = 1; i <= 100; i++) {
        snprintf(o->beside, room, "%s.%u.part", o->path, i);
        FILE *file = fopen(o->beside, "wbx");
        if (file != NULL)
            return file;
    }
    return NULL;
}

static void
free_names(output *o)
{
    memory_free(o->path);
    memory_free(o->beside);
    *o = (output){0};
}

tri_status
output_begin(output *o, const char *path)
{
    *o = (output){0};
    if (strcmp(path, "-") == 0) {
        o->file = stdout;
        return TRI_OK;
    }
    size_t length = strlen(path), room = length + sizeof ".100.part";
    o->path = memory_array(length + 1, 1);
    if (o->path == NULL)
        return TRI_OUT_OF_MEMORY;
    memcpy(o->path, path, length + 1);
    if (is_device(path)) {
        o->file = fopen(path, "wb");
    } else {
        o->beside = memory_array(room, 1);
        if (o->beside == NULL) {
            free_names(o);
            return TRI_OUT_OF_MEMORY;
        }
        o->file = open_beside(o, room);
    }
    if (o->file == NULL) {
        free_names(o);
        return TRI_CANNOT_WRITE;
    }
    return TRI_OK;
}

tri_status
output_commit(output *o)
{
    /* ferror remembers every write that failed, the flush included; on some file
     * systems the last ones fail only in the close. */
    fflush(o->file);
    int failed = ferror(o->file) != 0;
    if (o->file != stdout)
        failed |= fclose(o->file) != 0;
    o->file = NULL;
    if (!failed && o->beside != NULL)
        failed = rename(o->beside, o->path) != 0;
    if (failed && o->beside != NULL)
        remove(o->beside);
    free_names(o);
    return failed ? TRI_CANNOT_WRITE : TRI_OK;
}
