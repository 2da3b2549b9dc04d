/* grade.c - grades submissions: one, a folder of them, or a class.
 *
 *     grade [-a WEEK|SECTION|EXERCISE] [--base FOLDER] [--seed-file FILE] [-j N]
 *           [--format LIST] [-o FOLDER] [--csv FILE] [--roster FILE] [--supply]
 *           [--variant NAME] [--answers] [--require-sandbox] [--one]
 *           SUBMISSION|FOLDER...
 *     grade --prepare [-a ...] [--base FOLDER] [--variant NAME] -o FOLDER
 *     grade --viva ID -a ... SUBMISSION
 *     grade --pack gradescope -a ... [--seed-file FILE] -o FILE.zip
 *
 * docs/grading.md explains it. Exit status: 0 all were graded; 1 refused, standard
 * error says why; 2 the program cannot run; 3 for some submissions the grader has
 * failed, and these have no score.
 */
#include "tools/grade/grade.h"

#include "tools/grade/rows.h"
#include "tools/grade/submissions.h"
#include "tools/handout/basics.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { GRADED = 0, FAULT = 3 };

typedef struct request {
    const char *what, *base, *seed_file, *formats, *output, *csv, *roster, *variant;
    const char *viva, *pack;
    int workers;
    bool supply, answers, required, one, prepare;
    char **path;
} request;

static _Noreturn void
usage(void)
{
    fputs(
        "usage: grade [-a WEEK|SECTION|EXERCISE] [--base FOLDER] [--seed-file FILE] "
        "[-j N]\n"
        "             [--format text,gradescope,classroom50,junit,tap] [-o FOLDER]\n"
        "             [--csv FILE] [--roster FILE] [--supply] [--variant NAME]\n"
        "             [--answers] [--require-sandbox] [--one] SUBMISSION|FOLDER...\n"
        "       grade --prepare [-a WEEK|SECTION|EXERCISE] [--base FOLDER] -o FOLDER\n"
        "       grade --viva ID -a WEEK|SECTION|EXERCISE SUBMISSION\n"
        "       grade --pack gradescope -a WEEK|SECTION|EXERCISE [--seed-file FILE] "
        "-o FILE.zip\n",
        stderr);
    exit(2);
}

static request
parse(int argc, char **argv)
{
    request r = {.formats = "text", .workers = 1, .variant = ""};
    const struct { const char *name; const char **value; } valued[] = {
        {"-a", &r.what}, {"--base", &r.base}, {"--seed-file", &r.seed_file},
        {"--format", &r.formats}, {"-o", &r.output}, {"--csv", &r.csv},
        {"--roster", &r.roster}, {"--variant", &r.variant}, {"--viva", &r.viva},
        {"--pack", &r.pack},
    };
    int i = 1;
    for (; i < argc && argv[i][0] == '-'; i++) {
        bool known = false;
        if (strcmp(argv[i], "--supply") == 0)
            r.supply = known = true;
        else if (strcmp(argv[i], "--answers") == 0)
            r.answers = known = true;
        else if (strcmp(argv[i], "--require-sandbox") == 0)
            r.required = known = true;
        else if (strcmp(argv[i], "--prepare") == 0)
            r.prepare = known = true;
        else if (strcmp(argv[i], "--one") == 0)
            r.one = known = true;
        else if (i + 1 == argc)
            usage();
        else if (strcmp(argv[i], "-j") == 0 && (r.workers = atoi(argv[++i])) > 0)
            known = true;
        for (size_t k = 0; !known && k < sizeof valued / sizeof valued[0]; k++)
            if (strcmp(argv[i], valued[k].name) == 0) {
                *valued[k].value = argv[++i];
                known = true;
            }
        if (!known)
            usage();
    }
    r.path = argv + i;
    bool writes_one = r.pack != NULL || r.prepare;
    if ((r.what == NULL && r.base == NULL) || (writes_one && r.output == NULL) ||
        (!writes_one && i == argc) || (r.viva != NULL && i + 1 != argc) ||
        (r.answers && r.base != NULL))
        usage();
    r.formats = replace_all(r.formats, ",", " ");
    if (formats_check(r.formats) != NULL)
        refuse("there is no format %s", formats_check(r.formats));
    return r;
}

/* ---- The place of work. ---- */

static const char *work; /* removed at the end */
static pid_t owner;      /* by the process that has made it, and by no worker */
static pid_t *workers;   /* of the owner: those that run, and zeros */
static int most_workers;

/* In a signal handler, too: so no memory is taken. */
static void
remove_work(void)
{
    if (getpid() != owner)
        return;
    pid_t child = fork();
    if (child == 0) {
        execl("/bin/rm", "rm", "-rf", work, (char *)NULL);
        _exit(127);
    }
    waitpid(child, NULL, 0);
}

/* What is being run ends, and nothing is left behind. */
static void
interrupted(int signal_number)
{
    run_end();
    for (int i = 0; getpid() == owner && i < most_workers; i++)
        if (workers[i] > 0) {
            kill(workers[i], SIGTERM);
            waitpid(workers[i], NULL, 0);
        }
    remove_work();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static const char *
make_work(void)
{
    const char *place = getenv("TMPDIR");
    char *folder = format("%s/grade.XXXXXX", from_root(place != NULL ? place : "/tmp"));
    if (mkdtemp(folder) == NULL || chmod(folder, 0755) != 0)
        give_up(folder);
    work = folder;
    owner = getpid();
    atexit(remove_work);
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
    signal(SIGHUP, interrupted);
    return folder;
}

/* The folder of this program, with jail, handout and splice beside it. */
static const char *
own_folder(const char *self)
{
    const char *slash = strrchr(self, '/');
    if (slash == NULL)
        refuse("call grade by its path: build/grade");
    return from_root(part_of(self, (size_t)(slash - self)));
}

/* The tree that was handed out, in `to`: a copy of --base, or made here. */
static void
bring_base(const request *r, const grading *g, const char *to)
{
    char *said;
    command_line c = {NULL, 0};
    if (r->base != NULL) {
        bool prepared = base_is_prepared(g, r->base);
        const char *const sh[] = {"sh", "-c", format(
            "mkdir -p \"$1\" && cp -R \"$0/.\" \"$1\" && %schmod -R a+rX \"$1\"",
            prepared ? "" : "rm -rf \"$1/build\" && "), r->base, to, NULL};
        if (run(".", sh, 60, 2000, &said, NULL) != 0)
            refuse("%s: %s", r->base, said);
        return;
    }
    command_add(&c, format("%s/handout", g->tools));
    command_add(&c, r->what);
    command_add_words(&c, "--no-proof -o");
    command_add(&c, to);
    if (*r->variant != '\0') {
        command_add(&c, "--variant");
        command_add(&c, r->variant);
    }
    if (r->answers) /* anybody's: the questions of all have the same names */
        command_add_words(&c, "--student untouched");
    if (run(".", c.word, 120, 4000, &said, NULL) != 0)
        refuse("%s", said);
}

/* For --supply, a copy of the chapters and of splice: in the jail root is nobody, who
 * may not look into the project's folder. */
static const char *
bring_reference(const grading *g)
{
    char *said;
    const char *to = format("%s/reference", g->work);
    const char *const sh[] = {"sh", "-c",
        "mkdir -p \"$1/docs\" && cp -R chapters \"$1\" && "
        "cp docs/assignments.ini \"$1/docs\" && "
        "cp \"$0/splice\" \"$1\" && chmod -R a+rX \"$1\"", g->tools, to, NULL};
    if (run(g->project, sh, 60, 2000, &said, NULL) != 0)
        refuse("--supply needs the project's chapters and splice; run it in its "
               "root: %s", said);
    return to;
}

/* Any text names a sequence of cases; without one it is the students' own. */
static uint64_t
read_seed(const char *path)
{
    size_t size;
    uint64_t seed = 14695981039346656037u;
    if (path == NULL)
        return PUBLIC_SEED;
    const char *bytes = file_bytes(path, &size);
    if (bytes == NULL || size == 0)
        refuse("%s: there is no seed; write some random text into it", path);
    for (size_t i = 0; i < size; i++)
        seed = (seed ^ (unsigned char)bytes[i]) * 1099511628211u;
    return seed;
}

static grading
prepare(const request *r, const char *self)
{
    grading g = {.work = make_work(),
                 .tools = own_folder(self),
                 .seed = read_seed(r->seed_file)};
    const char *compiler = getenv("CC");
    g.base = r->prepare ? from_root(r->output) : format("%s/base", g.work);
    g.project = current_folder();
    g.compiler = compiler != NULL && *compiler != '\0' ? compiler : "cc";
    g.required = r->required;
    g.reference = r->supply ? bring_reference(&g) : NULL;
    g.formats = r->formats;
    bring_base(r, &g, g.base);
    g.asked = assignment_read(g.base);
    return g;
}

/* ---- Grading. ---- */

/* In a process of its own: whatever becomes of one submission, the others are graded.
 * Until there is a result, and if there is never one, the score is 0. */
static _Noreturn void
grade_one(const grading *g, const submission *s)
{
    const char *scratch = format("%s/of/%s", g->work, s->name);
    result r = result_nothing(
        &g->asked, s->name,
        s->path == NULL ? "Nothing was handed in."
                        : "It has not been graded: the grader was interrupted.");
    formats_write(g, &r, s->output);
    if (s->path != NULL) {
        make_folder(scratch);
        r = mark_submission(g, s->name, s->path, scratch, s->output);
        formats_write(g, &r, s->output);
    }
    row_leave(g, s, &r);
    remove_folder(scratch);
    _exit(r.fault != NULL ? FAULT : GRADED);
}

/* What became of a worker; one that ends in another way has failed itself. */
static int
worker_ended(const grading *g, const submission *s, int status)
{
    int ended = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (ended == GRADED || ended == FAULT)
        return ended;
    result r = result_nothing(&g->asked, s->name, "");
    r.fault = format("the process that grades it ended with status %d", status);
    formats_write(g, &r, s->output);
    row_leave(g, s, &r);
    return FAULT;
}

static int
wait_for_worker(const grading *g, submission *const *of)
{
    int status;
    pid_t ended = wait(&status);
    for (int i = 0; ended > 0 && i < most_workers; i++)
        if (workers[i] == ended) {
            workers[i] = 0;
            return worker_ended(g, of[i], status);
        }
    return GRADED;
}

/* The place of a worker that is not there yet, or has ended; -1: all are busy. */
static int
free_worker(void)
{
    for (int i = 0; i < most_workers; i++)
        if (workers[i] == 0)
            return i;
    return -1;
}

static bool
any_worker(void)
{
    for (int i = 0; i < most_workers; i++)
        if (workers[i] != 0)
            return true;
    return false;
}

static int
grade_all(const grading *g, class *c, int count)
{
    int worst = GRADED;
    submission **of = take((size_t)count * sizeof(submission *));
    workers = take((size_t)count * sizeof *workers);
    most_workers = count;
    for (size_t next = 0; next < c->count || any_worker();) {
        int i = free_worker();
        if (next < c->count && i >= 0) {
            of[i] = &c->at[next++];
            fflush(NULL);
            workers[i] = fork();
            if (workers[i] < 0)
                give_up("fork");
            if (workers[i] == 0)
                grade_one(g, of[i]);
            continue;
        }
        int how = wait_for_worker(g, of);
        worst = how > worst ? how : worst;
    }
    return worst;
}

/* The tree as it was handed out is graded first. Unless each property comes out as
 * "todo" there, something is wrong with this machine or with the tree, and not with
 * anybody's submission. */
static void
check_untouched(const grading *g)
{
    const char *scratch = format("%s/untouched", g->work);
    make_folder(scratch);
    result r = mark_submission(g, "untouched", g->base, scratch, scratch);
    if (r.fault != NULL)
        refuse("nothing can be graded here: %s", r.fault);
    for (size_t p = 0; p < g->asked.properties; p++)
        if (strcmp(r.mark[p].word, "todo") != 0)
            refuse("nothing can be graded here: of the tree as it was handed out, %s "
                   "%s comes out as %s, and not as todo: %s",
                   g->asked.property[p].of->exercise, g->asked.property[p].name,
                   r.mark[p].word, r.mark[p].text);
}

/* Students have the instances of 3.4 with their signs: a program could know them by
 * heart. So the seed makes others. */
static void
draw_instances(const grading *g)
{
    const char *path = format("%s/checks/3.4.instances", g->base);
    const char *const signs[] = {format("%s/signs", g->tools),
                                 format("%llu", (unsigned long long)g->seed), NULL};
    char *drawn;
    size_t size;
    if (access(path, F_OK) != 0 || access(signs[0], X_OK) != 0)
        return; /* a pack brings its own */
    if (run(".", signs, 60, 1 << 22, &drawn, &size) != 0)
        refuse("%s: %s", signs[0], drawn);
    write_file(path, drawn, size);
}

static int
grade_class(const request *r, const char *self)
{
    grading g = prepare(r, self);
    base_prepare(&g);
    draw_instances(&g);
    check_untouched(&g);
    const char *top = r->output != NULL ? from_root(r->output) : format("%s/out", work);
    class c = find_submissions(&g.asked, r->path, r->one, r->roster, top);
    make_folder(format("%s/of", g.work));
    int worst = grade_all(&g, &c, r->workers);
    if (r->csv != NULL)
        rows_join(&g, &c, r->csv);
    for (size_t i = 0; i < c.count; i++) {
        const char *text = file_bytes(format("%s/result.txt", c.at[i].output), NULL);
        if (text != NULL && has_word(g.formats, "text", 4))
            fputs(text, stdout);
    }
    return fflush(stdout) == 0 ? worst : 2;
}

int
main(int argc, char **argv)
{
    umask(022);
    /* What a make that runs the grader was told is not for the tree's own. */
    unsetenv("MAKEFLAGS");
    unsetenv("MFLAGS");
    unsetenv("MAKELEVEL");
    request r = parse(argc, argv);
    if (r.pack != NULL && strcmp(r.pack, "gradescope") != 0)
        refuse("there is no pack %s", r.pack);
    if (r.pack == NULL && r.viva == NULL && !r.prepare)
        return grade_class(&r, argv[0]);

    grading g = prepare(&r, argv[0]);
    if (r.pack != NULL && g.asked.tasks > g.asked.exercises)
        refuse("an archive for Gradescope cannot ask for " ANSWERS
               ": what knows the answers "
               "is solutions, which it must not have");
    if (r.pack != NULL)
        draw_instances(&g);
    if (r.prepare)
        base_prepare(&g);
    else if (r.pack != NULL)
        pack_gradescope(g.project, g.base, r.seed_file, r.output);
    else
        viva(&g, r.viva, from_root(r.path[0]));
    return 0;
}
