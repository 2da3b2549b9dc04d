/* pack.c - the archive that makes Gradescope run this grader.
 *
 * It holds the tree that was handed out, the grader's sources, the seed, and two
 * scripts. No solution is in it: answers are certified, not compared.
 */
#include "tools/grade/grade.h"

#include "lib/output.h"
#include "tools/grade/zip.h"
#include "tools/handout/basics.h"

#include <glob.h>
#include <string.h>

/* Gradescope runs it once, as root, when it makes the image. */
static const char setup[] =
    "#!/bin/sh\n"
    "# Installs a compiler and compiles the grader, in the folder that this script is "
    "in.\n"
    "set -eu\n"
    "here=${AUTOGRADER:-/autograder}/source\n"
    "if ! command -v cc >/dev/null || ! command -v make >/dev/null; then\n"
    "    apt-get update -q\n"
    "    DEBIAN_FRONTEND=noninteractive apt-get install -y -q gcc libc6-dev make\n"
    "fi\n"
    "cd \"$here\"\n"
    "chmod 600 seed\n"
    "mkdir -p build\n"
    "compile=\"cc -std=c11 -O1 -I. -D_POSIX_C_SOURCE=200809L\"\n"
    "jail=$(for part in jail inside outside confine filter; do echo "
    "tools/grade/$part.c; done)\n"
    "rest=$(find lib tools -name '*.c' | grep -vxF \"$jail\")\n"
    "$compile $jail -o build/jail\n"
    "$compile $rest -o build/grade\n"
    "build/grade --prepare --base base -o ready\n"
    "build/jail --layers || echo 'There is no seccomp here: programs are confined "
    "less.'\n";

/* And this one for each submission. What it prints only instructors see. */
static const char run_autograder[] =
    "#!/bin/sh\n"
    "# Grades $AUTOGRADER/submission into $AUTOGRADER/results.\n"
    "set -u\n"
    "top=${AUTOGRADER:-/autograder}\n"
    "cd \"$top/source\" || exit 2\n"
    "build/jail --layers\n"
    "exec build/grade --base ready --seed-file seed --one --format gradescope,text \\\n"
    "    -o \"$top/results\" \"$top/submission\"\n";

static void
add_matching(zip *z, const char *project, const char *pattern)
{
    glob_t files;
    size_t size;
    if (glob(format("%s/%s", project, pattern), 0, NULL, &files) != 0)
        refuse("there is no %s; run it in the root of the project", pattern);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i];
        const char *bytes = file_bytes(path, &size);
        if (bytes == NULL)
            give_up(path);
        zip_add(z, path + strlen(project) + 1, bytes, size, false);
    }
    globfree(&files);
}

/* All files below the base, in the order of their names. */
static void
add_base(zip *z, const char *base)
{
    char *list;
    size_t size;
    const char *const find[] = {"sh", "-c", "find . -type f | LC_ALL=C sort", NULL};
    if (run(base, find, 60, 1 << 20, &list, NULL) != 0)
        refuse("%s: %s", base, list);
    for (char *line = strtok(list, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        const char *bytes = file_bytes(format("%s/%s", base, line), &size);
        if (bytes == NULL)
            give_up(line);
        zip_add(z, format("base/%s", line + 2), bytes, size, ends_with(line, ".sh"));
    }
}

void
pack_gradescope(const char *project, const char *base, const char *seed_file,
                const char *output_path)
{
    static const char *const sources[] = {
        "lib/memory.[ch]",           "lib/output.[ch]",
        "lib/status.[ch]",           "tools/grade/*.[ch]",
        "tools/handout/basics.[ch]", "tools/handout/exercises.[ch]",
        "tools/handout/scan.[ch]",
    };
    output o;
    size_t size = 2;
    const char *seed = seed_file != NULL ? file_bytes(seed_file, &size) : "1\n";
    if (seed == NULL)
        refuse("%s: there is no such file", seed_file);
    if (output_begin(&o, output_path) != TRI_OK)
        give_up(output_path);
    zip z = {.file = o.file};
    zip_add(&z, "setup.sh", setup, strlen(setup), true);
    zip_add(&z, "run_autograder", run_autograder, strlen(run_autograder), true);
    zip_add(&z, "seed", seed, size, false);
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; i++)
        add_matching(&z, project, sources[i]);
    add_base(&z, base);
    zip_end(&z);
    if (output_commit(&o) != TRI_OK)
        give_up(output_path);
    printf("%s: %u files\n", output_path, z.entries);
}
