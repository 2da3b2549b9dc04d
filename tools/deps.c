/* deps.c - proves who includes whom.
 *
 * Run it in the root of the project; it reads every source there.
 *
 *   lib         includes lib only
 *   a chapter   includes lib, itself, and earlier chapters; 3.4 too, if the file or a
 *               header of its folder says so in its first lines
 *   chapters/   (the table and the engineer's header) includes lib and chapters
 *   figures.c, tests, tools   are programs on top: nobody below includes them
 *
 * Paths begin at the root, so that they tell what is borrowed; no file includes itself,
 * not even through others; and lib and chapters use no system header but those of C11.
 *
 * Exit status: 0 all rules hold; 1 some do not, and standard error says where; 2 the
 * program cannot run.
 */
#include <glob.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Where does a file stand? The later its rank, the more it may include. ---- */

enum { NOT_OURS = -1, LIB = 0, SECTION_3_4 = 304, ALL_CHAPTERS = 9998, PROGRAM = 9999 };

static bool
begins_with(const char *s, const char *prefix)
{
    return strncmp(s, prefix, strlen(prefix)) == 0;
}

/* LIB, 100 times the chapter plus the section, ALL_CHAPTERS or PROGRAM. */
static int
rank(const char *path)
{
    int chapter, section = 0;
    const char *name = strrchr(path, '/');
    if (begins_with(path, "lib/"))
        return LIB;
    if (begins_with(path, "tests/") || begins_with(path, "tools/"))
        return PROGRAM;
    if (!begins_with(path, "chapters/"))
        return NOT_OURS;
    if (strcmp(name, "/figures.c") == 0)
        return PROGRAM;
    if (sscanf(path, "chapters/%d.%d_", &chapter, &section) < 1)
        return ALL_CHAPTERS;
    return 100 * chapter + section;
}

/* ---- What the files say. ---- */

typedef struct include {
    size_t from; /* index of the file */
    int line;    /* counted from 1 */
    bool system; /* <...> and not "..." */
    char path[200];
    size_t to; /* index of the file; the number of files if it is none of ours */
} include;

static struct {
    glob_t file;
    include *include;
    size_t includes;
} tree;

static void
find_files(void)
{
    static const char *const pattern[] = {
        "lib/*.[ch]", "chapters/*.[ch]", "chapters/*/*.[ch]", "tests/*.[ch]",
        "tests/*/*.[ch]", "tools/*.[ch]", "tools/*/*.[ch]",
    };
    for (size_t k = 0; k < sizeof pattern / sizeof *pattern; k++)
        glob(pattern[k], k == 0 ? 0 : GLOB_APPEND, NULL, &tree.file);
    if (tree.file.gl_pathc == 0) {
        fputs("deps: no sources here; run it in the root of the project\n", stderr);
        exit(2);
    }
}

static size_t
index_of(const char *path)
{
    size_t i = 0;
    while (i < tree.file.gl_pathc && strcmp(tree.file.gl_pathv[i], path) != 0)
        i++;
    return i;
}

static void
remember(include found)
{
    tree.include = realloc(tree.include, (tree.includes + 1) * sizeof *tree.include);
    if (tree.include == NULL) {
        fputs("deps: out of memory\n", stderr);
        exit(2);
    }
    found.to = found.system ? tree.file.gl_pathc : index_of(found.path);
    tree.include[tree.includes++] = found;
}

static void
read_includes(size_t from)
{
    FILE *file = fopen(tree.file.gl_pathv[from], "r");
    if (file == NULL) {
        perror(tree.file.gl_pathv[from]);
        exit(2);
    }
    char line[1000];
    for (int number = 1; fgets(line, sizeof line, file) != NULL; number++) {
        include found = {.from = from, .line = number};
        char open;
        if (sscanf(line, " # include %c%199[^\">]", &open, found.path) == 2) {
            found.system = open == '<';
            remember(found);
        }
    }
    fclose(file);
}

/* Do the first lines of the file name section 3.4? */
static bool
says_3_4(const char *path)
{
    FILE *file = fopen(path, "r");
    char line[1000];
    bool says = false;
    for (int k = 0; file && k < 12 && !says && fgets(line, sizeof line, file); k++)
        says = strstr(line, "3.4") != NULL && strstr(line, "#include") == NULL;
    if (file != NULL)
        fclose(file);
    return says;
}

/* ---- The rules. ---- */

static bool
is_c11_header(const char *name)
{
    static const char *const c11[] = {
        "assert.h", "complex.h", "ctype.h", "errno.h", "fenv.h", "float.h",
        "inttypes.h", "iso646.h", "limits.h", "locale.h", "math.h", "setjmp.h",
        "signal.h", "stdalign.h", "stdarg.h", "stdatomic.h", "stdbool.h", "stddef.h",
        "stdint.h", "stdio.h", "stdlib.h", "stdnoreturn.h", "string.h", "tgmath.h",
        "threads.h", "time.h", "uchar.h", "wchar.h", "wctype.h",
    };
    for (size_t k = 0; k < sizeof c11 / sizeof *c11; k++)
        if (strcmp(name, c11[k]) == 0)
            return true;
    return false;
}

/* Is it announced that the file borrows from 3.4? */
static bool
announces_3_4(size_t from)
{
    const char *path = tree.file.gl_pathv[from];
    size_t folder = (size_t)(strrchr(path, '/') - path + 1);
    if (says_3_4(path))
        return true;
    for (size_t k = 0; k < tree.includes; k++) {
        const include *i = &tree.include[k];
        if (i->from == from && strncmp(i->path, path, folder) == 0 && says_3_4(i->path))
            return true;
    }
    return false;
}

/* What is wrong with the include; NULL if nothing is. */
static const char *
fault(const include *i)
{
    int from = rank(tree.file.gl_pathv[i->from]), to = rank(i->path);
    if (i->system)
        return from == PROGRAM || is_c11_header(i->path)
                   ? NULL : "the library is pure C11; do without this header";
    if (i->to == tree.file.gl_pathc)
        return "there is no such file; write its path from the root";
    if (strstr(i->path, "/figures.c") != NULL)
        return "figures.c is a program; nobody includes it";
    if (to <= from)
        return NULL;
    if (from == LIB)
        return "lib knows no chapter and no program; move what is needed into lib";
    if (to == PROGRAM)
        return "a chapter includes no test and no tool";
    if (to == SECTION_3_4)
        return announces_3_4(i->from)
                   ? NULL : "say in the first lines of the header: Needs: 3.4";
    return "a chapter includes earlier ones only (and 3.4)";
}

static size_t
check_rules(void)
{
    size_t faults = 0;
    for (size_t k = 0; k < tree.includes; k++) {
        const include *i = &tree.include[k];
        const char *what = fault(i);
        if (what == NULL)
            continue;
        fprintf(stderr, "%s:%d: %s: %s\n", tree.file.gl_pathv[i->from], i->line,
                i->path, what);
        faults++;
    }
    return faults;
}

/* Takes away, again and again, the files all of whose includes are taken away. What is
 * left includes itself in a circle. */
static size_t
check_cycles(void)
{
    bool *done = calloc(tree.file.gl_pathc + 1, sizeof *done);
    if (done == NULL)
        exit(2);
    done[tree.file.gl_pathc] = true; /* a file that is not ours */
    size_t before, left = tree.file.gl_pathc;
    do {
        before = left;
        for (size_t f = 0; f < tree.file.gl_pathc; f++) {
            bool ready = !done[f];
            for (size_t k = 0; k < tree.includes && ready; k++)
                ready = tree.include[k].from != f || done[tree.include[k].to];
            if (ready) {
                done[f] = true;
                left--;
            }
        }
    } while (left < before);
    for (size_t f = 0; f < tree.file.gl_pathc; f++)
        if (!done[f])
            fprintf(stderr,
                    "%s:1: includes itself, or a file that does; cut the circle\n",
                    tree.file.gl_pathv[f]);
    free(done);
    return left;
}

int
main(void)
{
    find_files();
    for (size_t f = 0; f < tree.file.gl_pathc; f++)
        read_includes(f);
    size_t faults = check_rules();
    faults += check_cycles();
    if (faults == 0)
        printf("%zu includes of %zu files keep the rules\n", tree.includes,
               tree.file.gl_pathc);
    free(tree.include);
    globfree(&tree.file);
    return faults > 0;
}
