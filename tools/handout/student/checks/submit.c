/* submit.c - one archive of the files that you have written.
 *
 *     submit ARCHIVE FILE...
 *
 * The same files make the same bytes.
 */
#include "checks/ustar.h"

#include <stdlib.h>

/* Appends the file; false when something goes wrong. */
static bool
add_file(FILE *archive, const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0)
        return false;
    long size = ftell(file);
    rewind(file);
    char *bytes = size < 0 ? NULL : malloc((size_t)size + 1);
    bool done = bytes != NULL &&
                fread(bytes, 1, (size_t)size, file) == (size_t)size &&
                ustar_add(archive, path, bytes, (size_t)size, false);
    free(bytes);
    fclose(file);
    return done;
}

int
main(int argc, char **argv)
{
    if (argc < 3)
        return 2;
    FILE *archive = fopen(argv[1], "wb");
    if (archive == NULL) {
        perror(argv[1]);
        return 1;
    }
    for (int i = 2; i < argc; i++)
        if (!add_file(archive, argv[i])) {
            perror(argv[i]);
            return 1;
        }
    bool done = ustar_end(archive);
    if (fclose(archive) != 0 || !done) {
        perror(argv[1]);
        return 1;
    }
    return 0;
}
