/* handout.c - makes a student's tree from the project.
 *
 *     handout W3|2.3|2.3-b [--variant NAME] [--student ID] [--no-proof]
 *             -o FOLDER|FILE.tar.gz
 *
 * Run it in the root of the project. The exercises of a week (docs/assignments.ini), of
 * a section, or one alone are taken out of a copy of the sources that they need; what
 * the student reads, runs and hands in is put around them (docs/grading.md). The same
 * project makes the same bytes.
 *
 * With --student, answers.txt asks for the first steps of the algorithms on points that
 * are the student's own (traces.c).
 *
 * The tree is not written before its promises have been seen to be true (proof.c).
 * --no-proof leaves out what takes seconds, compiling and running it: where the same
 * tree has been proved before, as for the second student of a class.
 *
 * Exit status: 0 written; 1 refused, standard error says why; 2 the program cannot run.
 */
#include "tools/handout/handout.h"

#include "tools/handout/basics.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct request {
    const char *what, *variant, *student, *output;
    bool prove;
} request;

static request
parse(int argc, char **argv)
{
    request r = {.variant = "", .student = "", .prove = true};
    bool understood = true;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--no-proof") == 0)
            r.prove = false;
        else if (strcmp(argv[i], "--variant") == 0 && i + 1 < argc)
            r.variant = argv[++i];
        else if (strcmp(argv[i], "--student") == 0 && i + 1 < argc)
            r.student = argv[++i];
        else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc)
            r.output = argv[++i];
        else if (argv[i][0] != '-' && r.what == NULL)
            r.what = argv[i];
        else
            understood = false;
    }
    if (!understood || r.what == NULL || r.output == NULL) {
        fputs(
            "usage, in the root of the project: handout W3|2.3|2.3-b [--variant NAME] "
            "[--student ID] [--no-proof] -o FOLDER|FILE.tar.gz\n",
            stderr);
        exit(2);
    }
    return r;
}

/* A folder of our own, removed when the program ends. */
static const char *scratch;

static void
remove_scratch(void)
{
    const char *const remove[] = {"rm", "-rf", scratch, NULL};
    run_program(".", "/dev/null", remove);
}

static const char *
make_scratch(void)
{
    const char *place = getenv("TMPDIR");
    char *folder = format("%s/handout.XXXXXX", place != NULL ? place : "/tmp");
    if (mkdtemp(folder) == NULL)
        give_up(folder);
    scratch = folder;
    atexit(remove_scratch);
    return folder;
}

/* The program beside this one, from the root of the file system. */
static const char *
beside(const char *self, const char *name)
{
    char here[4096];
    const char *slash = strrchr(self, '/');
    const char *folder = slash != NULL ? part_of(self, (size_t)(slash - self)) : ".";
    if (*folder == '/')
        return format("%s/%s", folder, name);
    if (getcwd(here, sizeof here) == NULL)
        give_up("getcwd");
    return format("%s/%s/%s", here, folder, name);
}

static void
write_out(const handout *h, const char *output)
{
    struct stat there;
    if (ends_with(output, ".tar.gz")) {
        tree_archive(&h->tree, format("triangulations-%s", h->name), output);
        return;
    }
    if (stat(output, &there) == 0 && rmdir(output) != 0)
        refuse("%s is there already; choose another name", output);
    tree_write(&h->tree, output);
}

int
main(int argc, char **argv)
{
    request r = parse(argc, argv);
    handout h = {.name = r.what, .variant = r.variant, .student = r.student};
    h.project = project_read(".");
    h.weave = beside(argv[0], "weave");
    h.signs = beside(argv[0], "signs");
    h.traces = beside(argv[0], "traces");
    h.scratch = make_scratch();

    handout_select(&h);
    handout_collect(&h);
    handout_take_out(&h);
    if (*h.student != '\0')
        handout_ask(&h);
    handout_write_pages(&h);
    handout_weave(&h);
    const char *missing = handout_unchecked(&h);
    if (*missing != '\0')
        fprintf(stderr, "%s: there is no check of section %s yet: the tree has the "
                "exercises, but nothing is said about them\n", h.name, missing);
    handout_prove_nothing_leaks(&h);
    if (r.prove)
        handout_prove(&h);
    write_out(&h, r.output);
    printf("%s: %zu files in %s\n", h.name, h.tree.files, r.output);
    return 0;
}
