/* The jail holds: a program that tries to get out of it, or to get hold of more than
 * its share, ends, and nothing outside has changed; an honest program does not notice.
 *
 * Hypotheses: Linux with seccomp and Landlock, and a compiler that links statically;
 * what is missing is said, and not asked about. Run by root, everything is tried as
 * root and as an ordinary user. The program that tries is tests/grading/attack.c.
 */
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct attempt {
    const char *what;    /* the argument of the program */
    const char *options; /* of the jail */
    const char *end;     /* how the report begins */
} attempt;

/* Signal 31 is SIGSYS: the filter has ended the process. */
#define FORBIDDEN "signal 31\t"

#ifdef __aarch64__
#define TRAP "signal 5\t" /* which is called SIGTRAP there */
#else
#define TRAP "signal 4\t"
#endif

static const attempt harmless[] = {
    {"exit", "", "exit 42\t"}, {"assert", "", "signal 6\t"},
    {"overflow", "", TRAP}, {"pointer", "", "signal 11\t"},
    {"recursion", "", "signal 11\t"},
};

static const attempt all_layers[] = {
    {"hog", "--memory 256", "exit 40\t"}, {"loop", "--cpu 1", "time\t"},
    {"stubborn", "--cpu 1", "time\t"}, {"stop", "--wall 0.3", "time\t"},
    {"environment", "", "exit 40\t"}, {"user", "", "exit 40\t"},
    {"inherited", "", "exit 40\t"}, {"open", "", FORBIDDEN}, {"create", "", FORBIDDEN},
    {"unlink", "", FORBIDDEN}, {"chmod", "", FORBIDDEN}, {"list", "", FORBIDDEN},
    {"fork", "", FORBIDDEN}, {"thread", "", FORBIDDEN}, {"parent", "", FORBIDDEN},
    {"all", "", FORBIDDEN}, {"other", "", FORBIDDEN}, {"ptrace 1", "", FORBIDDEN},
    {"peek", "", FORBIDDEN}, {"prlimit 1", "", FORBIDDEN}, {"raise", "", FORBIDDEN},
    {"nice", "", FORBIDDEN}, {"socket", "", FORBIDDEN}, {"exec", "", FORBIDDEN},
    {"again", "", "exit 40\t"}, {"path", "", FORBIDDEN}, {"code", "", FORBIDDEN},
    {"protect", "", FORBIDDEN}, {"memfd", "", FORBIDDEN}, {"dup", "", FORBIDDEN},
    {"sleep", "", FORBIDDEN}, {"mount", "", FORBIDDEN}, {"unshare", "", FORBIDDEN},
    {"session", "", FORBIDDEN},
#ifdef __x86_64__
    {"x32", "", FORBIDDEN}, {"i386", "", FORBIDDEN},
#endif
};

/* With the innermost layer off, another one holds; with that one off, too, nothing
 * does, or the attempt would prove nothing. */
static const attempt landlock_alone[] = {
    {"open", "--without seccomp --without user --without limits", "exit 40\t"},
    {"create", "--without seccomp --without user --without limits", "exit 40\t"},
    {"unlink", "--without seccomp --without user --without limits", "exit 40\t"},
    {"list", "--without seccomp --without user --without limits", "exit 40\t"},
    {"exec", "--without seccomp --without user --without limits", "exit 40\t"},
    {"open", "--without seccomp --without limits --without landlock", "exit 41\t"},
    {"list", "--without seccomp --without limits --without landlock", "exit 41\t"},
};

static const attempt limits_alone[] = {
    {"fork", "--without seccomp --without landlock", "exit 40\t"},
    {"memfd", "--without seccomp --without landlock", "exit 40\t"},
    {"hog", "--memory 256 --without seccomp --without landlock --without user",
     "exit 40\t"},
    {"raise", "--without seccomp --without landlock --memory 0 --without limits",
     "exit 41\t"},
    {"fork", "--without seccomp --without landlock --without limits", "exit 41\t"},
    {"memfd", "--without seccomp --without landlock --without limits", "exit 41\t"},
};

static const attempt user_alone[] = {
    {"parent", "--without seccomp --without landlock --without limits", "exit 40\t"},
    {"unlink", "--without seccomp --without landlock --without limits", "exit 40\t"},
    {"chmod", "--without seccomp --without landlock --without limits", "exit 40\t"},
    {"user", "--without user", "exit 41\t"},
};

/* "" or what runs the jail as another user. Of this test's own. */
static const char *as = "";

/* Runs one attempt, with its output in a pipe; the report's first line is in
 * $d/report. */
static void
attempt_one(attempt a, const char *claim)
{
    shell(
        "exec 2>$d/noise; rm -f $d/box/report; cd $d/box && "
        "%s ./jail run %s --report report -- ./attack %s 2>&1 3</dev/null 4>/dev/null "
        "| head -c 1000 >$d/out",
        as, a.options, a.what);
    content report = read_scratch("box/report");
    CLAIM(claim, strncmp(report.text, a.end, strlen(a.end)) == 0,
          "%s jail run %s -- attack %s: %s and not %s; it says: %s", as, a.options,
          a.what, report.text, a.end, read_scratch("out").text);
    CLAIM("jail.outside",
          shell("cd $d/box && test -r treasure && test ! -e loot && "
                "test \"$(ls -l treasure)\" = \"$(cat $d/treasure)\"") == 0,
          "after %s the file outside is not as it was", a.what);
}

#define ATTEMPT_ALL(list, claim) \
    for (size_t i = 0; i < sizeof(list) / sizeof(list)[0]; i++) \
        attempt_one((list)[i], claim)

/* ---- The run jail. ---- */

static void
an_honest_program_notices_nothing(void)
{
    shell("rm -f $d/box/report");
    int status =
        shell("cd $d/box && printf 12345678 | { "
              "%s ./jail run --require-sandbox --report report -- ./attack honest "
              "3<&0 4>&1 2>&1 | cat >$d/out; }",
              as);
    CLAIM("jail.honest",
          status == 0 && has("out", "to people\n") && has("out", "sorted 1\n") &&
              has("out", "12345678"),
          "it says: %s, and ends: %s", read_scratch("out").text,
          read_scratch("box/report").text);
    CLAIM("jail.report", has("box/report", "exit 0\t") &&
          has("box/report", "landlock limits seccomp\n"), "%s",
          read_scratch("box/report").text);
}

/* The jail ends as its program does. */
static void
it_ends_as_the_program_does(void)
{
    ATTEMPT_ALL(harmless, "jail.report");
    int exits = shell("cd $d/box && %s ./jail run -- ./attack exit", as);
    CLAIM("jail.alike", exits == 42, "exit status %d and not 42", exits);
    int aborts =
        shell("cd $d/box && (%s ./jail run -- ./attack assert; exit $?) 2>$d/err", as);
    CLAIM("jail.alike", aborts == 128 + 6, "status %d and not that of SIGABRT", aborts);
    int late =
        shell("cd $d/box && (%s ./jail run --wall 0.3 -- ./attack stop; exit $?) "
              "2>$d/err",
              as);
    CLAIM("jail.alike", late == 128 + 24, "status %d and not that of SIGXCPU", late);
    int none = shell("cd $d/box && %s ./jail run -- ./none 2>$d/err", as);
    CLAIM("jail.alike", none == 125 && has("err", "./none: "), "status %d: %s", none,
          read_scratch("err").text);
}

static void
attempts_end_in_the_filter(void)
{
    ATTEMPT_ALL(all_layers, "jail.all_layers");
}

static void
each_layer_holds_alone(void)
{
    ATTEMPT_ALL(landlock_alone, "jail.landlock");
    ATTEMPT_ALL(limits_alone, "jail.limits");
    if (geteuid() == 0 && as[0] == '\0')
        ATTEMPT_ALL(user_alone, "jail.user");
}

/* What it writes to a file is lost, and the file does not grow. */
static void
files_do_not_grow(void)
{
    shell("exec 2>$d/noise; cd $d/box && "
          "%s ./jail run --wall 5 -- ./attack flood >$d/flood 2>&1", as);
    CLAIM("jail.output", shell("test -f $d/flood && test ! -s $d/flood") == 0,
          "the file has grown");
}

/* However the jail ends, its program does not survive it. */
static void
nothing_survives_the_jail(void)
{
    static const char *const signals[] = {"KILL", "TERM", "INT", "HUP"};
    for (int i = 0; i < 4; i++) {
        int status = shell(
            "cd $d/box && mkfifo pipe && { %s ./jail run -- ./attack name >pipe & } && "
            "jail=$! && { read pid && test -n \"$pid\" && kill -0 $pid && "
            "kill -%s $jail && sleep 0.2 && ! grep -q 'State:.[RSDT]' "
            "/proc/$pid/status 2>/dev/null; } <pipe; status=$?; rm pipe; exit $status",
            as, signals[i]);
        CLAIM("jail.orphans", status == 0,
              "after SIG%s of the jail the program lives on", signals[i]);
    }
}

static void
it_says_when_a_layer_is_missing(void)
{
    int status =
        shell("cd $d/box && %s ./jail run --require-sandbox --without seccomp -- "
              "./attack exit 2>$d/err",
              as);
    CLAIM("jail.required", status == 125 && has("err", "no seccomp"), "status %d: %s",
          status, read_scratch("err").text);
    status = shell("cd $d/box && mkdir -p work && %s ./jail compile --require-sandbox "
                   "--without landlock --without user -w work -- true 2>$d/err", as);
    CLAIM("jail.required", status == 125 && has("err", "neither Landlock"),
          "status %d: %s", status, read_scratch("err").text);
    status = shell("cd $d/box && %s ./jail --layers >$d/out", as);
    CLAIM("jail.layers", status == 0 && has("out", "seccomp   on\n") &&
          has("out", "limits    on\n"), "%s", read_scratch("out").text);
}

/* Where no filter is known for the machine, or none can be had, the jail says so, and
 * --require-sandbox refuses. (qemu-user has neither filters nor Landlock.) */
static void
other_machines_have_less_and_say_so(void)
{
    static const char *const machines[] = {"aarch64", "s390x"};
    for (int i = 0; i < 2; i++) {
        const char *m = machines[i];
        if (shell("command -v %s-linux-gnu-gcc qemu-%s >$d/out", m, m) != 0) {
            printf("# skipped: no compiler for %s, or no qemu-user\n", m);
            continue;
        }
        int status =
            shell("cd tools/grade && %s-linux-gnu-gcc -std=c11 -static -I../.. "
                  "-Wall -Wextra -Wconversion -Werror jail.c inside.c outside.c "
                  "confine.c filter.c -o $d/box/jail_%s 2>$d/err",
                  m, m);
        CLAIM("jail.machines", status == 0, "%s: %s", m, read_scratch("err").text);
        status = shell("cd $d/box && qemu-%s ./jail_%s --layers >$d/out", m, m);
        CLAIM("jail.machines", status == 1 && has("out", "seccomp   off\n") &&
              has("out", "limits    on\n"), "%s: status %d: %s", m, status,
              read_scratch("out").text);
        status =
            shell("cd $d/box && qemu-%s ./jail_%s run --require-sandbox -- ./attack "
                  "exit 2>$d/err",
                  m, m);
        CLAIM("jail.machines", status == 125 && has("err", "no seccomp"),
              "%s: status %d: %s", m, status, read_scratch("err").text);
    }
}

/* ---- The compile jail. ---- */

/* Compiles a text in the jail; the exit status. What gcc says is in $d/err. */
static int
compile(const char *options, const char *text)
{
    FILE *file = fopen(in_scratch("box/src/a.c").text, "w");
    if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0)
        return -1;
    return shell(
        "cd $d/box && rm -rf work report && mkdir work && chmod 777 work && "
        "(SECRET=leaked %s ./jail compile --report report %s -r src -w work -- "
        "${CC-cc} -static -c src/a.c -o work/a.o; exit $?) 2>$d/err",
        as, options);
}

static void
a_compiler_works_inside(void)
{
    int status = compile("--require-sandbox", "#include <stdio.h>\n"
                         "int main(void) { puts(\"hello\"); return 0; }\n");
    CLAIM("jail.compile", status == 0, "status %d: %s", status,
          read_scratch("err").text);
    status =
        shell("cd $d/box && %s ./jail compile -w work -- ${CC-cc} -static work/a.o "
              "-o work/a 2>$d/err && %s ./jail run -- work/a | cat >$d/out",
              as, as);
    CLAIM("jail.compile", status == 0 && has("out", "hello\n"), "status %d: %s%s",
          status, read_scratch("err").text, read_scratch("out").text);
}

/* Whatever a source asks of the compiler, nothing outside is read or written. */
static void
a_compiler_reads_and_writes_where_it_may(void)
{
    CLAIM("jail.reads", compile("", "#include \"../treasure\"\n") != 0,
          "it is included");
    CLAIM("jail.reads", compile("", "__asm__(\".incbin \\\"treasure\\\"\");\n") != 0,
          "it is assembled");
    CLAIM("jail.reads", compile("", "#include \"/etc/passwd\"\n") != 0 &&
          !has("err", "root:"), "the users are seen: %s", read_scratch("err").text);
    CLAIM("jail.reads", shell("cp $d/box/treasure $d/box/src/known.h") == 0 &&
          compile("", "#include \"known.h\"\n") == 0, "what may be read is not");
    static const char *const elsewhere[] = {
        "touch loot",       "rm treasure",           "mv treasure work/",
        "chmod 0 treasure", "ln treasure work/link", "cp treasure work/"};
    for (size_t i = 0; i < sizeof elsewhere / sizeof elsewhere[0]; i++) {
        if (strncmp(elsewhere[i], "chmod", 5) == 0 && as[0] != '\0')
            continue; /* Landlock lets owners change modes, and this user is none */
        int status = shell("cd $d/box && %s ./jail compile -w work -- %s 2>$d/err", as,
                           elsewhere[i]);
        CLAIM("jail.writes", status != 0 && shell("cd $d/box && test -f treasure && "
              "test ! -e loot && test ! -e work/treasure && test ! -e work/link") == 0,
              "%s: status %d", elsewhere[i], status);
    }
    int leaked =
        shell("cd $d/box && SECRET=leaked %s ./jail compile -w work -- /bin/sh -c "
              "'test -n \"$SECRET$HOME\"' 7<treasure",
              as);
    CLAIM("jail.environment", leaked == 1, "status %d: it has an environment", leaked);
    leaked = shell("cd $d/box && %s ./jail compile -w work -- /bin/sh -c 'cat <&7' "
                   "7<treasure >$d/out 2>&1", as);
    CLAIM("jail.environment", leaked != 0 && !has("out", "gold"),
          "status %d: a descriptor is open", leaked);
}

static void
a_compiler_does_not_run_for_ever(void)
{
    int status = compile("--file 1", "char a[1 << 24] = {1};\n");
    CLAIM("jail.bombs", status != 0 && shell("test ! -s $d/box/work/a.o") == 0,
          "a file of 16 megabytes is written");
    status = compile("--wall 0.3",
            "#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(x)))\n"
            "int f(void) { int i = 0; B(B(i++;)) return i; }\n");
    CLAIM("jail.bombs", status == 128 + 24 && has("box/report", "time\t"),
          "status %d, and ends: %s", status, read_scratch("box/report").text);
    status = shell("cd $d/box && (%s ./jail compile --wall 0.3 -w work -- /bin/sh -c "
                   "'sleep 50 & echo $! >work/left; wait'; exit $?) 2>$d/err", as);
    CLAIM("jail.bombs", status == 128 + 24 && shell("sleep 0.1; grep -q "
          "'State:.[RSDT]' /proc/$(cat $d/box/work/left)/status 2>$d/err") != 0,
          "status %d, or a process is left", status);
}

/* ---- All of it. ---- */

static void
run_all(void)
{
    test_run("an honest program notices nothing", an_honest_program_notices_nothing);
    test_run("it ends as the program does", it_ends_as_the_program_does);
    test_run("attempts end in the filter", attempts_end_in_the_filter);
    test_run("each layer holds alone", each_layer_holds_alone);
    test_run("files do not grow", files_do_not_grow);
    test_run("nothing survives the jail", nothing_survives_the_jail);
    test_run("it says when a layer is missing", it_says_when_a_layer_is_missing);
    test_run("a compiler works inside", a_compiler_works_inside);
    test_run("a compiler reads and writes where it may",
             a_compiler_reads_and_writes_where_it_may);
    test_run("a compiler does not run for ever", a_compiler_does_not_run_for_ever);
}

/* $d/box is for anybody: the jail, the program that tries, a file to harm. */
static int
prepare(void)
{
    return shell("chmod 711 $d && mkdir $d/box $d/box/src && cp $build/jail $d/box && "
                 "echo 'int gold;' >$d/box/treasure && "
                 "chmod 1777 $d/box && chmod 777 $d/box/src && "
                 "(cd $d/box && ls -l treasure >../treasure) && "
                 "${CC-cc} -static -O1 -w -fsanitize=undefined "
                 "-fsanitize-undefined-trap-on-error tests/grading/attack.c "
                 "-o $d/box/attack 2>$d/err");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "the jail holds, whatever a program tries");
    if (prepare() != 0) {
        printf("ok 1 - # SKIP programs cannot be linked statically: %s\n1..1\n",
               read_scratch("err").text);
        shell_end();
        return 0;
    }
    run_all();
    test_run("other machines have less and say so",
             other_machines_have_less_and_say_so);
    if (geteuid() == 0) {
        as = "./attack as_nobody";
        run_all();
    }
    int status = test_end((test_minima){.trials = 8});
    shell_end();
    return status;
}
