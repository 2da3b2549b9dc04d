/* mark.c - one submission: its files, its programs, what the checkers say. */
#include "tools/grade/grade.h"

#include "tools/grade/clean.h"
#include "tools/handout/basics.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_OF_A_TEXT = 6000, CHECKER_SECONDS = 1800 };

/* ---- Marks. ---- */

bool
mark_earned(const mark *m)
{
    return strcmp(m->word, "pass") == 0;
}

int
result_score(const assignment *a, const result *r)
{
    int score = 0;
    for (size_t p = 0; p < a->properties; p++)
        score += mark_earned(&r->mark[p]) ? a->property[p].points : 0;
    return score;
}

result
result_nothing(const assignment *a, const char *name, const char *because)
{
    result r = {.name = clean(name, strlen(name), 200), .notes = ""};
    r.mark = take(a->properties * sizeof *r.mark);
    for (size_t p = 0; p < a->properties; p++)
        r.mark[p] = (mark){"ungraded", because, because, NULL};
    return r;
}

static void
mark_task(result *r, const task *t, const char *word, const char *sentence,
          const char *text)
{
    for (size_t p = t->first; p < t->end; p++)
        r->mark[p] = (mark){word, sentence, text, NULL};
}

/* ---- Compiling. ---- */

/* One way to build a submission: where its sources are, and what became of them. */
typedef struct build {
    const grading *g;
    const char *folder;     /* from /; in it src/ and build/ */
    const char **refusal;   /* of each listed file: NULL, or why it is no part of it */
} build;

/* Is the file part of the programs of a mode? (What a question of the checker replaces
 * is not.) */
static bool
is_in_mode(const grading *g, const char *mode, const char *path)
{
    return access(
               format("%s/build/%s/%.*s.o", g->base, mode, (int)strlen(path) - 2, path),
               F_OK) == 0;
}

static const char *
object_of(const char *mode, size_t file)
{
    return format("../build/%s_%zu.o", mode, file);
}

/* A jail in which `folder`/build can be written, and what is compiled with be read. */
static command_line
compiler_in(const build *b)
{
    const char *const reads[] = {b->g->base, format("%s/src", b->folder), NULL};
    command_line c = jail_compile(b->g, reads, format("%s/build", b->folder));
    command_add_words(&c, b->g->compiler);
    command_add_words(&c, GRADING_FLAGS " -std=c11 -ffp-contract=off");
    return c;
}

/* Compiles listed file f for a mode; NULL, or what the compiler says. The folder is
 * src/, so that messages name files as the student knows them. */
static const char *
compile_file(const build *b, const char *mode, size_t f, const char **fault)
{
    char *said;
    size_t size;
    command_line c = compiler_in(b);
    if (strcmp(mode, "opaque") == 0)
        command_add(&c, format("-I%s/checks/student/opaque", b->g->base));
    command_add(&c, "-I.");
    command_add(&c, format("-I%s", b->g->base));
    command_add(&c, "-c");
    command_add(&c, b->g->asked.file[f]);
    command_add(&c, "-o");
    command_add(&c, object_of(mode, f));
    int status =
        run(format("%s/src", b->folder), c.word, 120, MOST_OF_A_TEXT, &said, &size);
    if (status == 125)
        *fault = format("the jail of the compiler: %s", clean(said, size, 500));
    if (status == 0)
        return NULL;
    const char *text = clean(said, size, MOST_OF_A_TEXT);
    return *text != '\0' ? text : status == 128 + 24
        ? "The compiler was ended: it took too much time." : "The compiler failed.";
}

static bool
is_asked_in(const assignment *a, const char *mode)
{
    for (size_t t = 0; t < a->exercises; t++)
        if (strcmp(a->task[t].mode, mode) == 0)
            return true;
    return false;
}

/* Compiles the listed files in the modes in which something is asked. One that cannot
 * be is replaced by what was handed out, so that the exercises of the other files can
 * be graded. */
static void
compile_files(build *b, const char **fault)
{
    const assignment *a = &b->g->asked;
    static const char *const modes[] = {"opaque", "plain"};
    for (size_t f = 0; f < a->files; f++)
        for (int m = 0; m < 2; m++)
            if (b->refusal[f] == NULL && is_asked_in(a, modes[m]) &&
                is_in_mode(b->g, modes[m], a->file[f]))
                b->refusal[f] = compile_file(b, modes[m], f, fault);
}

static const char *
program_of(const task *t)
{
    return format("build/%s_%s", t->mode, t->section);
}

/* Links the program of a task, if it has not been linked; NULL, or what the linker
 * says. */
static const char *
link_program(const build *b, const task *t, const char **fault)
{
    const grading *g = b->g;
    const char *given = format("%s/build/%s", g->base, t->mode);
    char *said;
    size_t size;
    glob_t driver;
    if (access(format("%s/%s", b->folder, program_of(t)), F_OK) == 0)
        return NULL;
    command_line c = compiler_in(b);
    for (size_t f = 0; f < g->asked.files; f++) {
        const char *path = g->asked.file[f];
        if (!is_in_mode(g, t->mode, path))
            continue;
        bool own = b->refusal[f] == NULL;
        command_add(&c, own ? object_of(t->mode, f)
                            : format("%s/%.*s.o", given, (int)strlen(path) - 2, path));
    }
    command_add(&c, format("%s/checks/student/%s.o", given, t->section));
    command_add(&c, format("%s/checks/wire.o", given));
    if (glob(format("%s/checks/student/[a-z]*.o", given), 0, NULL, &driver) == 0)
        for (size_t i = 0; i < driver.gl_pathc; i++)
            command_add(&c, format("%s", driver.gl_pathv[i]));
    globfree(&driver);
    command_add(&c, format("%s/libgiven.a", given));
    command_add_words(&c, "-lm -o");
    command_add(&c, format("../%s", program_of(t)));
    int status =
        run(format("%s/src", b->folder), c.word, 120, MOST_OF_A_TEXT, &said, &size);
    if (status == 125)
        *fault = format("the jail of the linker: %s", clean(said, size, 500));
    return status == 0 ? NULL : clean(said, size, MOST_OF_A_TEXT);
}

/* ---- Checking. ---- */

/* The line of a property in the checker's table, as its two cells. */
static bool
find_line(const char *table, const char *property, mark *m)
{
    size_t length = strlen(property);
    for (const char *line = table; line != NULL && *line != '\0';) {
        const char *cell = line + length + 1;
        if (strncmp(line, property, length) == 0 && line[length] == '\t') {
            size_t word = strcspn(cell, "\t\n");
            m->word = part_of(cell, word);
            if (cell[word] == '\t')
                cell += word + 1;
            m->sentence = clean(cell, strcspn(cell, "\n"), 1000);
            return true;
        }
        line = strchr(line, '\n');
        line = line != NULL ? line + 1 : NULL;
    }
    return false;
}

/* What the checker has written about the properties of a task. */
static void
read_feedback(const build *b, const task *t, const char *feedback, result *r)
{
    const grading *g = b->g;
    const char *folder = format("%s/%s", b->folder, feedback);
    const char *table = file_bytes(format("%s/properties.tsv", folder), NULL);
    for (size_t p = t->first; p < t->end; p++) {
        mark *m = &r->mark[p];
        size_t size;
        const char *name = g->asked.property[p].name;
        if (table == NULL || !find_line(table, name, m)) {
            r->fault =
                format("the checker of %s says nothing of %s", t->exercise, name);
            continue;
        }
        char *text = file_bytes(format("%s/%s.txt", folder, name), &size);
        bool told = text != NULL && strcmp(m->word, "todo") != 0;
        const char *picture = format("%s/%s.svg", feedback, name);
        bool drawn = access(format("%s/%s", b->folder, picture), F_OK) == 0;
        m->text = told ? clean(text, size, MOST_OF_A_TEXT) : m->sentence;
        m->picture = drawn ? picture : NULL;
    }
}

/* Did the jail report that it could not be made? */
static const char *
jail_fault(const build *b)
{
    const char *report = file_bytes(format("%s/report", b->folder), NULL);
    const char *line = report == NULL ? NULL : strncmp(report, "fault", 5) == 0
        ? report : strstr(report, "\nfault");
    if (line == NULL)
        return NULL;
    line += *line == '\n';
    return format("the jail: %s", part_of(line, strcspn(line, "\t\n")));
}

/* Lets the checker ask the program of a task. */
static void
check_task(const build *b, const task *t, const char *feedback, result *r)
{
    const grading *g = b->g;
    char *said;
    size_t size;
    command_line c = {NULL, 0};
    const char *instances = format("%s/checks/%s.instances", g->base, t->section);
    make_folder(format("%s/%s", b->folder, feedback));
    command_add(&c, format("%s/build/checker_%s", g->base, t->section));
    command_add(&c, t->exercise);
    command_add(&c, "--seed");
    command_add(&c, format("%llu", (unsigned long long)g->seed));
    command_add(&c, "--feedback");
    command_add(&c, feedback);
    command_add(&c, "--again");
    command_add(&c, format("make check EX=%s %s", t->exercise, g->seed == PUBLIC_SEED
                           ? "SEED=1" : "(there the points are others)"));
    command_add(&c, "--again-case");
    command_add(&c, format("make check EX=%s", t->exercise));
    if (*g->asked.variant != '\0') {
        command_add(&c, "--variant");
        command_add(&c, g->asked.variant);
    }
    if (access(instances, F_OK) == 0) {
        command_add(&c, "--instances");
        command_add(&c, instances);
    }
    command_add(&c, "--");
    command_add(&c, format("%s/jail", g->tools));
    command_add_words(&c, "run --report report --cpu 120 --wall 300");
    if (g->required)
        command_add(&c, "--require-sandbox");
    command_add(&c, "--");
    command_add(&c, program_of(t));
    int status = run(b->folder, c.word, CHECKER_SECONDS, MOST_OF_A_TEXT, &said, &size);
    if (status != 42 && status != 43)
        r->fault = format("the checker of %s ended with status %d: %s", t->exercise,
                          status, clean(said, size, 500));
    else
        read_feedback(b, t, feedback, r);
    if (jail_fault(b) != NULL)
        r->fault = jail_fault(b);
}

static size_t
file_of(const assignment *a, const task *t)
{
    for (size_t f = 0; f < a->files; f++)
        if (strcmp(a->file[f], t->path) == 0)
            return f;
    refuse("assignment.ini: the file of %s is not listed", t->exercise);
}

/* ---- The submission; where it fails, each exercise, the others correct. ---- */

static bool
all_earned(const result *r, const task *t)
{
    for (size_t p = t->first; p < t->end; p++)
        if (!mark_earned(&r->mark[p]))
            return false;
    return true;
}

/* The sources for one exercise of the student's: the rest is the reference's. false:
 * they cannot be put together, or splice has failed itself. */
static bool
write_spliced(const build *from, const task *t, const char *folder, const char **fault)
{
    const grading *g = from->g;
    const assignment *a = &g->asked;
    char *text;
    size_t size;
    for (size_t f = 0; f < a->files; f++) {
        if (strcmp(a->file[f], ANSWERS) == 0)
            continue;
        char *reference = file_bytes(format("%s/%s", g->reference, a->file[f]), &size);
        if (reference == NULL) {
            *fault = format("--supply: the project has no %s", a->file[f]);
            return false;
        }
        write_file(format("%s/src/%s", folder, a->file[f]), reference, size);
    }
    make_folder(format("%s/build", folder));
    const char *const reads[] = {g->reference, format("%s/src", from->folder), NULL};
    command_line c = jail_compile(g, reads, format("%s/build", folder));
    command_add(&c, format("%s/splice", g->reference));
    command_add(&c, "--only");
    command_add(&c, g->reference);
    command_add(&c, format("%s/src", from->folder));
    command_add(&c, t->exercise);
    int status = run(folder, c.word, 60, 1 << 20, &text, &size);
    if (status > 1) /* 1: the student's file is too strange */
        *fault =
            format("splice ended with status %d: %s", status, clean(text, size, 500));
    if (status != 0)
        return false;
    write_file(format("%s/src/%s", folder, t->path), text, size);
    return true;
}

/* One mistake is not punished twice: a property that holds when all other exercises are
 * the reference's has been earned. */
static void
supply(const build *own, const task *t, result *r)
{
    const assignment *a = &own->g->asked;
    const char *folder = format("%s/alone-%s", own->folder, t->exercise);
    build b = {own->g, folder, take(a->files * sizeof(char *))};
    result alone = result_nothing(a, r->name, "");
    if (!write_spliced(own, t, folder, &r->fault))
        return;
    compile_files(&b, &alone.fault);
    if (b.refusal[file_of(a, t)] != NULL || link_program(&b, t, &alone.fault) != NULL)
        return;
    check_task(&b, t, "feedback", &alone);
    if (alone.fault != NULL)
        r->fault = alone.fault;
    for (size_t p = t->first; p < t->end; p++)
        if (!mark_earned(&r->mark[p]) && mark_earned(&alone.mark[p]))
            r->mark[p] = (mark){"pass", "It holds when the other exercises are right.",
                                "It holds when the other exercises are right.", NULL};
}

static void
mark_one(const build *b, const task *t, const char *id, const listed *l, result *r)
{
    const assignment *a = &b->g->asked;
    size_t f = file_of(a, t);
    bool exercise = t < a->task + a->exercises;
    const char *said;
    if (l->trouble[f] != NULL)
        mark_task(r, t, "refused",
                  format("%s is not used: %s.", t->path, l->trouble[f]),
                  format("%s is not used: %s.", t->path, l->trouble[f]));
    else if (!exercise)
        answers_mark(b->g, t, id, b->folder, r);
    else if (b->refusal[f] != NULL)
        mark_task(r, t, "uncompiled", format("%s does not compile.", t->path),
                  format("%s does not compile:\n%s", t->path, b->refusal[f]));
    else if ((said = link_program(b, t, &r->fault)) != NULL)
        mark_task(r, t, "uncompiled", "The program cannot be linked.",
                  format("The program cannot be linked:\n%s", said));
    else
        check_task(b, t, format("feedback/%s", t->exercise), r);
    if (exercise && b->g->reference != NULL && a->exercises > 1 &&
        l->trouble[f] == NULL && !all_earned(r, t))
        supply(b, t, r);
}

/* The pictures go where the texts that name them will be. */
static void
keep_pictures(const char *folder, const char *output)
{
    char *said;
    const char *const sh[] = {
        "sh",
        "-c",
        "rm -rf \"$1/feedback\" && cd \"$0\" && for p in feedback/*/*.svg; do "
        "[ -f \"$p\" ] || continue; mkdir -p \"$1/${p%/*}\" && cp \"$p\" \"$1/$p\" || "
        "exit 1; done",
        folder,
        output,
        NULL};
    if (run("/", sh, 60, 2000, &said, NULL) != 0)
        refuse("%s: pictures cannot be kept: %s", output, said);
}

result
mark_submission(const grading *g, const char *name, const char *path,
                const char *scratch, const char *output)
{
    const assignment *a = &g->asked;
    result r = result_nothing(a, name, "It has not been graded.");
    build b = {g, scratch, take(a->files * sizeof(char *))};
    make_folder(format("%s/build", scratch));
    listed l = files_collect(g, path, format("%s/src", scratch));
    r.notes = l.notes;
    memcpy(b.refusal, l.trouble, a->files * sizeof *b.refusal); /* what is not used */
    compile_files(&b, &r.fault);
    for (size_t t = 0; t < a->tasks && r.fault == NULL; t++)
        mark_one(&b, &a->task[t], name, &l, &r);
    keep_pictures(scratch, output);
    return r;
}
