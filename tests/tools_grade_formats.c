/* What others read is what they document: Gradescope's results.json, Classroom 50's
 * result.json, JUnit's XML and the Test Anything Protocol; a fault of the grader is no
 * score in any of them; and the archive for Gradescope works in a folder laid out as
 * there. (Neither service can be tried here: what is checked is what they document.)
 *
 * Hypotheses: as tests/tools_grade.c; exercise 2.3-b.
 */
#include "tests/harness/graded.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Is there an unzip, and so the tree that the archive has made? */
static bool unpacked;

/* The tree is compiled once, by the archive's own setup.sh: grade accepts it. */
static int
prepare(void)
{
    if (!write_submission("good", "") || !write_submission("looks_one_way",
            "while (sees(m, points, p, q.end)) q.end = mesh_hull_next(m, q.end); "
            "if (q.first != q.end) return q;") ||
        !write_submission("crash", "*(volatile char *)(size_t)(q.first + 64) = 1;") ||
        !write_submission("colour_of_error",
                          "\n#error \\033[32m</pre><script>PASSED</script>\n"))
        return -1;
    int status = shell("mkdir -p $d/there/results && echo 'a secret' >$d/seed && "
                       "$build/grade --pack gradescope -a 2.3-b --seed-file $d/seed "
                       "-o $d/pack.zip >$d/out 2>&1");
    unpacked = status == 0 && shell("command -v unzip >$d/out") == 0;
    if (unpacked)
        status = shell("unzip -q $d/pack.zip -d $d/there/source >$d/out 2>&1 && "
                       "cp -R $d/class/good $d/there/submission && "
                       "AUTOGRADER=$d/there $d/there/source/setup.sh >$d/out 2>&1");
    else if (status == 0)
        status = shell(
            "$build/grade --prepare -a 2.3-b -o $d/there/source/ready >$d/out 2>&1");
    setenv("base", in_scratch("there/source/ready").text, 1);
    return status != 0 ? status : shell(
        "SUBMISSION_TAG=submit/2026-06-01T14-32-05Z-a1b2c3d; export SUBMISSION_TAG; "
        "echo absent >$d/roster; $build/grade --base $base --seed-file $d/seed -j 2 "
        "--roster $d/roster --format text,gradescope,classroom50,junit,tap "
        "-o $d/graded $d/class >$d/out 2>$d/err");
}

/* ---- What is documented. ---- */

/* Is the text one of these words? */
static bool
is_among(const char *text, const char *const words[], size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(text, words[i]) == 0)
            return true;
    return false;
}

/* A field that Gradescope documents (gradescope-autograders.readthedocs.io, "Specs"),
 * with what may stand in it. */
typedef struct field {
    const char *name;
    json_kind kind;
    const char *words[5]; /* those that it may be, if it is a word */
} field;

#define VISIBILITY {"hidden", "after_due_date", "after_published", "visible"}
#define FORMAT {"text", "html", "simple_format", "md", "ansi"}

static const field of_all[] = {
    {"score", JSON_NUMBER, {NULL}},
    {"execution_time", JSON_NUMBER, {NULL}},
    {"output", JSON_STRING, {NULL}},
    {"output_format", JSON_STRING, FORMAT},
    {"test_output_format", JSON_STRING, FORMAT},
    {"test_name_format", JSON_STRING, FORMAT},
    {"visibility", JSON_STRING, VISIBILITY},
    {"stdout_visibility", JSON_STRING, VISIBILITY},
    {"extra_data", JSON_OBJECT, {NULL}},
    {"tests", JSON_ARRAY, {NULL}},
    {"leaderboard", JSON_ARRAY, {NULL}},
};

static const field of_a_test[] = {
    {"score", JSON_NUMBER, {NULL}}, {"max_score", JSON_NUMBER, {NULL}},
    {"status", JSON_STRING, {"passed", "failed"}}, {"name", JSON_STRING, {NULL}},
    {"name_format", JSON_STRING, FORMAT}, {"number", JSON_STRING, {NULL}},
    {"output", JSON_STRING, {NULL}}, {"output_format", JSON_STRING, FORMAT},
    {"tags", JSON_ARRAY, {NULL}}, {"visibility", JSON_STRING, VISIBILITY},
    {"extra_data", JSON_OBJECT, {NULL}},
};

/* Each member is a field of the list, of its kind, and one of its words. */
static void
has_only(const char *name, const json *object, const field *list, size_t count)
{
    for (size_t i = 0; object != NULL && i < object->count; i++) {
        const json *member = &object->item[i];
        const field *f = NULL;
        for (size_t k = 0; k < count; k++)
            if (strcmp(list[k].name, member->name) == 0)
                f = &list[k];
        CLAIM("grade.gradescope", f != NULL && f->kind == member->kind,
              "%s: the field %s", name, member->name);
        size_t words = 0;
        while (f != NULL && words < 5 && f->words[words] != NULL)
            words++;
        CLAIM("grade.gradescope",
              words == 0 || is_among(text_of(member), f->words, words), "%s: %s is %s",
              name, member->name, text_of(member));
    }
}

/* The fields that Gradescope documents, and no other; the points and the words in
 * them. */
static void
gradescope_has_its_fields(void)
{
    static const char *const names[] = {"good", "crash", "absent", "colour_of_error"};
    for (int i = 0; i < 4; i++) {
        char path[200];
        snprintf(path, sizeof path, "graded/%s/results.json", names[i]);
        const json *all = read_json(path), *tests = json_member(all, "tests"), *test;
        CLAIM("grade.gradescope", all != NULL && tests != NULL, "%s: no JSON: %s",
              names[i], whole(path));
        has_only(names[i], all, of_all, sizeof of_all / sizeof of_all[0]);
        CLAIM("grade.gradescope",
              strcmp(text_of(json_member(all, "visibility")), "visible") == 0 &&
                  json_member(all, "score") == NULL,
              "%s: %s", names[i], whole(path));
        int score = 0, most = 0;
        size_t k = 0;
        for (; (test = item_of(tests, k)) != NULL; k++) {
            has_only(names[i], test, of_a_test, sizeof of_a_test / sizeof of_a_test[0]);
            bool passed = strcmp(text_of(json_member(test, "status")), "passed") == 0;
            int points = number_of(json_member(test, "score"));
            CLAIM("grade.gradescope", points == (passed ? (int)k + 1 : 0),
                  "%s: test %zu: %d points", names[i], k, points);
            CLAIM("grade.gradescope", *text_of(json_member(test, "output")) != '\0' &&
                  strcmp(text_of(item_of(json_member(test, "tags"), 0)), "2.3-b") == 0,
                  "%s: test %zu says nothing", names[i], k);
            score += points;
            most += number_of(json_member(test, "max_score"));
        }
        CLAIM("grade.gradescope", k == 2 && most == 3, "%s: %zu tests, %d points",
              names[i], k, most);
        CLAIM("grade.gradescope", score == (i == 0 ? 3 : 0), "%s: %d points", names[i],
              score);
    }
}

/* Students see there a text, and nothing beside it: it has the points, and a command
 * for their own tree, which does not give the seed away. */
static void
feedback_stands_alone(void)
{
    for (size_t k = 0; k < 2; k++) {
        const char *output =
            text_of(json_member(test_of("looks_one_way", k), "output"));
        CLAIM("grade.alone", strcmp(word_of("looks_one_way", 1), "fail") == 0, "%s",
              output);
        CLAIM("grade.alone",
              strstr(output, "picture") == NULL && strstr(output, "SEED") == NULL &&
                  strstr(output, "feedback/") == NULL,
              "%s", output);
    }
    const char *output = text_of(json_member(test_of("looks_one_way", 1), "output"));
    CLAIM("grade.alone",
          strstr(output, "\n  run it again: make check EX=2.3-b PROPERTY=chain "
                         "CASE=\"(") != NULL,
          "%s", output);
    CLAIM("grade.alone", strstr(whole("graded/looks_one_way/result.txt"),
                                "\n    picture: feedback/2.3-b/chain.svg\n") != NULL &&
          shell("test -s $d/graded/looks_one_way/feedback/2.3-b/chain.svg") == 0, "%s",
          whole("graded/looks_one_way/result.txt"));
}

/* In the tree that students have, the command shows the same case; and for a right
 * solution the case holds. */
static void
the_command_runs_it_again(void)
{
    int status =
        shell("again=$(sed -n 's/^ *run it again: make //p' "
              "$d/graded/looks_one_way/result.txt | "
              "grep PROPERTY=chain) && cp -R $base $d/students && cd $d/students && "
              "flags=\"CFLAGS='$(sed 's/^[^ ]* //' build/stamp)'\" && "
              "cp $d/class/looks_one_way/" SWEEP " " SWEEP " && "
              "! eval make -s \"$flags\" $again >$d/again 2>$d/err && "
              "cp $d/class/good/" SWEEP " " SWEEP " && "
              "eval make -s \"$flags\" $again >$d/out 2>$d/err");
    const char *said = strstr(whole("graded/looks_one_way/result.txt"),
                              "\n  2.3-b chain: fails\n");
    char seen[300] = "(nothing)";
    if (said != NULL && (said = strstr(said, "what was seen: ")) != NULL)
        snprintf(seen, sizeof seen, "%.*s", (int)strcspn(said, "\n"), said);
    CLAIM("grade.again", has("again", seen), "%s, and not %s", whole("again"), seen);
    CLAIM("grade.again",
          status == 0 && has("out", "2.3-b chain: holds for these points\n"),
          "status %d: %s%s", status, whole("out"), whole("err"));
}

/* The fields of its contract (the project's wiki, "Advanced Autograding"), but for
 * those that its runner adds: owner, assignment_type and graded_at. */
static void
classroom50_has_its_fields(void)
{
    static const char *const strings[] = {"classroom", "assignment", "submission",
                                          "commit",    "release",    "review"};
    const char *text = whole("graded/good/result.json");
    const json *all = read_json("graded/good/result.json");
    CLAIM("grade.classroom50",
          all != NULL &&
              strcmp(text_of(json_member(all, "schema")), "classroom50/result/v1") == 0,
          "%s", text);
    for (int i = 0; i < 6; i++) {
        const json *value = json_member(all, strings[i]);
        CLAIM("grade.classroom50", value != NULL && *text_of(value) != '\0',
              "%s is missing or empty", strings[i]);
    }
    CLAIM("grade.classroom50", number_of(json_member(all, "score")) == 3 &&
          number_of(json_member(all, "max-score")) == 3, "%s", text);
    CLAIM("grade.classroom50", strcmp(text_of(json_member(all, "datetime")),
                                      "2026-06-01T14:32:05Z") == 0, "%s", text);
    for (size_t k = 0; k < 2; k++) {
        const json *test = item_of(json_member(all, "tests"), k);
        const json *passed = json_member(test, "passed");
        CLAIM("grade.classroom50", *text_of(json_member(test, "test-name")) == '2' &&
              passed != NULL && passed->kind == JSON_TRUE &&
              number_of(json_member(test, "score")) == (int)k + 1 &&
              number_of(json_member(test, "max-score")) == (int)k + 1, "%s", text);
    }
}

/* What is common to the schemas that are about: Jenkins's and Ant's. (Ant's also wants
 * times and the names of machines, which would make the bytes differ.) */
static const char junit_dtd[] =
    "<!ELEMENT testsuites (testsuite*)>"
    "<!ELEMENT testsuite (testcase*)>"
    "<!ATTLIST testsuite name CDATA #REQUIRED tests NMTOKEN #REQUIRED"
    " failures NMTOKEN #REQUIRED errors NMTOKEN #REQUIRED skipped NMTOKEN #IMPLIED>"
    "<!ELEMENT testcase (error | failure)?>"
    "<!ATTLIST testcase name CDATA #REQUIRED classname CDATA #REQUIRED>"
    "<!ELEMENT error (#PCDATA)>"
    "<!ATTLIST error type NMTOKEN #REQUIRED message CDATA #REQUIRED>"
    "<!ELEMENT failure (#PCDATA)>"
    "<!ATTLIST failure type NMTOKEN #REQUIRED message CDATA #REQUIRED>";

/* Version 13, which readers of 14 accept, too: its version, its plan, a line for each
 * test, comments, and nothing else. A # in a line would begin a directive. */
static const char tap_grammar[] =
    "NR == 1 { bad += $0 != \"TAP version 13\"; next }"
    "NR == 2 { bad += $0 !~ /^1[.][.][0-9]+$/; split($0, plan, \"[.][.]\"); next }"
    "/^#/ { next }"
    "/^(not )?ok [0-9]+ - [^#]+$/ { n++; bad += $($1 == \"not\" ? 3 : 2) != n; next }"
    "{ bad++ }"
    "END { exit bad > 0 || n != plan[2] }";

static void
junit_and_tap_have_their_form(void)
{
    static const char *const names[] = {"good", "crash", "absent", "colour_of_error"};
    FILE *file = fopen(in_scratch("junit.dtd").text, "w");
    if (file != NULL) {
        fputs(junit_dtd, file);
        fclose(file);
    }
    bool xmllint = shell("command -v xmllint >/dev/null") == 0;
    for (int i = 0; i < 4; i++) {
        char path[200];
        snprintf(path, sizeof path, "graded/%s/junit.xml", names[i]);
        const char *text = whole(path);
        CLAIM("grade.junit",
              strstr(text, i == 0 ? "tests=\"2\" failures=\"0\" errors=\"0\""
                                  : "tests=\"2\" failures=\"2\" errors=\"0\"") != NULL,
              "%s: %s", names[i], text);
        CLAIM("grade.junit",
              !xmllint || shell("xmllint --noout --dtdvalid $d/junit.dtd $d/%s "
                                "2>$d/err",
                                path) == 0,
              "%s: %s", names[i], read_scratch("err").text);
        CLAIM("grade.junit",
              strstr(text, "<script") == NULL && strstr(text, "<b>") == NULL,
              "%s: a tag gets through: %s", names[i], text);
        CLAIM("grade.tap",
              shell("awk '%s' $d/graded/%s/result.tap && "
                    "test $(grep -c '^%s [12] - 2.3-b ' $d/graded/%s/result.tap) "
                    "-eq 2",
                    tap_grammar, names[i], i == 0 ? "ok" : "not ok", names[i]) == 0,
              "%s: %s", names[i], whole("graded/crash/result.tap"));
    }
}

/* ---- When the grader fails. ---- */

/* Makes $d/NAME, a base with a checker that does its work once, for the tree as it was
 * handed out, and then only this. */
static void
make_faulty(const char *name, const char *then)
{
    shell("cp -R $base $d/%s && cd $d/%s/build && mv checker_2.3 real && "
          "printf '#!/bin/sh\\nif test -e \"$0.called\"; then %s; exit; fi\\n"
          ": >\"$0.called\"; exec \"${0%%%%/*}/real\" \"$@\"\\n' >checker_2.3 && "
          "chmod +x checker_2.3", name, name, then);
}

/* When the checker itself fails, there is no score, and the status says so. */
static void
a_fault_of_the_grader_is_no_score(void)
{
    make_faulty("faulty", "\"${0%%/*}/real\" \"$@\"; exit 9");
    int status =
        shell("$build/grade --base $d/faulty --format text,gradescope,junit,tap "
              "--csv $d/faulty.csv -o $d/fault $d/class/good >$d/out");
    const json *all = read_json("fault/results.json");
    CLAIM("grade.infra", status == 3, "status %d", status);
    CLAIM("grade.infra", all != NULL && json_member(all, "tests") == NULL &&
          json_member(all, "score") == NULL &&
          json_member(json_member(all, "extra_data"), "infra_error") != NULL, "%s",
          whole("fault/results.json"));
    CLAIM("grade.infra",
          strstr(whole("faulty.csv"), "\n\"good\",,3,infra_error,,\n") != NULL, "%s",
          whole("faulty.csv"));
    CLAIM("grade.infra", strstr(whole("fault/junit.xml"), "errors=\"2\"") != NULL &&
          strstr(whole("fault/result.tap"), "Bail out!") != NULL, "%s",
          whole("fault/junit.xml"));
    make_faulty("silent", "exit 42");
    status = shell("$build/grade --base $d/silent --format gradescope -o $d/fault2 "
                   "$d/class/good >$d/out");
    CLAIM("grade.infra", status == 3, "a checker that says nothing accepts: status %d",
          status);
}

/* Nor does anybody lose points where nothing can be graded at all. */
static void
a_machine_that_cannot_grade_is_noticed(void)
{
    int status = shell("cp -R $base $d/none && rm $d/none/build/opaque/libgiven.a && "
                       "$build/grade --base $d/none --csv $d/none.csv $d/class/good "
                       ">$d/out 2>&1");
    CLAIM("grade.self", status == 1 && has("out", "nothing can be graded here") &&
          shell("test ! -e $d/none.csv") == 0, "status %d: %s", status,
          read_scratch("out").text);
}

/* Until there is a result the score is 0; and nothing is left behind. */
static void
a_zero_is_there_first(void)
{
    make_faulty("slow", "echo $$ >\"$d/slow.pid\"; exec sleep 60");
    shell("chmod 711 $d; mkdir $d/tmp");
    int status =
        shell("exec 2>$d/noise; "
              "TMPDIR=$d/tmp $build/grade --base $d/slow --format gradescope "
              "-o $d/killed $d/class/good >$d/out 2>&1 & grader=$!; "
              "for i in $(seq 60); do sleep 0.2; "
              "test -e $d/slow.pid && break; done; "
              "cp $d/killed/results.json $d/first.json; kill $grader; wait $grader; "
              "ls -A $d/tmp >$d/out; test ! -s $d/out && sleep 0.2 && "
              "! grep -q 'State:.[RSDT]' /proc/$(cat $d/slow.pid)/status");
    const json *last = item_of(json_member(read_json("first.json"), "tests"), 1);
    CLAIM("grade.zero",
          strstr(text_of(json_member(last, "output")), "interrupted") != NULL &&
              number_of(json_member(last, "score")) == 0,
          "%s", whole("first.json"));
    CLAIM("grade.zero", status == 0 && read_json("killed/results.json") != NULL,
          "files are left, or a process: %s", read_scratch("out").text);
}

/* ---- Gradescope, in a folder laid out as there. ---- */

static void
run_there(const char *as, const char *where)
{
    int status =
        shell("cd $d/%s && AUTOGRADER=$d/%s %s source/run_autograder >$d/out 2>&1",
              where, where, as);
    char path[100];
    snprintf(path, sizeof path, "%s/results/results.json", where);
    const json *last = item_of(json_member(read_json(path), "tests"), 1);
    CLAIM("grade.pack", status == 0 && number_of(json_member(last, "score")) == 2,
          "%s status %d: %s%s", as, status, read_scratch("out").text, whole(path));
}

static void
it_runs_as_root_or_as_you(void)
{
    run_there("", "there");
}

static void
it_runs_as_another_user(void)
{
    shell("rm -rf $d/there/results/* && cp -R $d/there $d/nobody && "
          "chmod 755 $d && chown -R 65534 $d/nobody");
    run_there("setpriv --reuid 65534 --regid 65534 --clear-groups", "nobody");
}

static void
the_archive_has_no_solution(void)
{
    int status = shell("$build/grade --pack gradescope -a 2.3-b --seed-file $d/seed "
                       "-o $d/again.zip >$d/out && cmp $d/pack.zip $d/again.zip");
    CLAIM("grade.pack", status == 0, "status %d: %s", status, read_scratch("out").text);
    CLAIM("grade.pack",
          shell("grep -q 'hull_edges_seeing' $d/pack.zip && "
                "! grep -q 'mesh_hull_prev(m, q.first)' $d/pack.zip") == 0,
          "a solution is in the archive");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "what others read is what they document");
    graded_or_end(prepare());
    test_run("Gradescope has its fields", gradescope_has_its_fields);
    test_run("feedback stands alone", feedback_stands_alone);
    test_run("the command runs it again", the_command_runs_it_again);
    test_run("Classroom 50 has its fields", classroom50_has_its_fields);
    test_run("JUnit and TAP have their form", junit_and_tap_have_their_form);
    test_run("a fault of the grader is no score", a_fault_of_the_grader_is_no_score);
    test_run("a machine that cannot grade is noticed",
             a_machine_that_cannot_grade_is_noticed);
    test_run("a zero is there first", a_zero_is_there_first);
    test_run("the archive has no solution", the_archive_has_no_solution);
    if (!unpacked)
        puts("# skipped: there is no unzip");
    if (unpacked)
        test_run("it runs as root, or as you", it_runs_as_root_or_as_you);
    if (unpacked && geteuid() == 0 && shell("command -v setpriv >$d/out") == 0)
        test_run("it runs as another user", it_runs_as_another_user);
    int result = test_end((test_minima){.trials = 9});
    shell_end();
    return result;
}
