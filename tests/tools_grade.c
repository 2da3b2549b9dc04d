/* The grader gives each property of a submission its points or not, says why, and in
 * every format the same; whatever a submission does, it is graded, and nobody else's
 * result changes.
 *
 * Hypotheses: Linux, and a compiler that links statically; otherwise it is said, and not
 * asked about. The checkers have tests of their own: what is graded here is exercise
 * 2.3-b, with the reference's code, and with lines added to it; and section 2.3
 * with questions of the students' own.
 */
#include "tests/harness/harness.h"
#include "tests/harness/json.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Reading what the grader writes. ---- */

/* Memory that is kept until the process ends, where a search for leaks finds it. */
static void *
kept(void *memory)
{
    static void *keep[1 << 16];
    static size_t count;
    if (count < sizeof keep / sizeof keep[0])
        keep[count++] = memory;
    return memory;
}

/* The whole file $d/name; "" if there is none. */
static const char *
whole(const char *name)
{
    FILE *file = fopen(in_scratch(name).text, "rb");
    char *text = kept(calloc(1, 1 << 20));
    if (text != NULL && file != NULL)
        (void)!fread(text, 1, (1 << 20) - 1, file);
    if (file != NULL)
        fclose(file);
    return text != NULL ? text : "";
}

/* The same, read as JSON; NULL if it is none. */
static const json *
read_json(const char *name)
{
    const char *text = whole(name), *wrong;
    size_t length = strlen(text), at;
    char *copy = kept(malloc(length + 1));
    return copy == NULL
        ? NULL : kept(json_read(memcpy(copy, text, length + 1), length, &wrong, &at));
}

static const json *
item_of(const json *array, size_t k)
{
    return array != NULL && array->kind == JSON_ARRAY && k < array->count ? &array->item[k]
                                                                           : NULL;
}

static const char *
text_of(const json *value)
{
    return value != NULL && value->kind == JSON_STRING ? value->text : "(no text)";
}

/* A whole number, or -1. */
static int
number_of(const json *value)
{
    bool number = value != NULL && value->kind == JSON_NUMBER;
    return number && value->number == (int)value->number ? (int)value->number : -1;
}

/* ---- The submissions. ---- */

/* A line that is added to the reference's function, and how the property comes out. */
static const struct {
    const char *name, *line, *word, *sentence;
} ends[] = {
    {"crash", "*(volatile char *)(size_t)(q.first + 64) = 1;", "crash", "crashed"},
    {"assert", "assert(q.first != q.end);", "assert", "assertion"},
    {"overflow", "volatile int most = 2147483647; most += 1;", "undefined", "undefined"},
    {"late", "raise(SIGXCPU);", "timeout", "in time"},
    {"exit", "exit(0);", "noanswer", "ended without an answer"},
    {"good", "fputs(\"no harm\\n\", stderr);", "pass", ""},
    {"garbage", "write(4, \"*** all tests passed ***\", 24);", "malformed", "no answer and no"},
    {"fork", "fork();", "forbidden", "stopped"},
    {"open", "fopen(\"/etc/passwd\", \"r\");", "forbidden", "stopped"},
    {"kill", "kill(getppid(), SIGKILL);", "forbidden", "stopped"},
    {"colours", "fputs(\"\\033[2J\\033]0;PASSED\\007<b>&\\x9b\\r\\n\", stderr); abort();",
     "assert", "assertion"},
    {"does_not_end", "/* ", "uncompiled", "does not compile"},
    {"colour_of_error", "\n#error \\033[32m</pre><script>PASSED</script>\n", "uncompiled",
     "does not compile"},
    {"secret", "\n#include \"/etc/hostname\"\n", "uncompiled", "does not compile"},
};
enum { ENDS = sizeof ends / sizeof ends[0] };

#define SWEEP "chapters/2.3_line_sweep/sweep.c"

/* Makes $d/class/NAME/SWEEP: the reference, with headers and one line more. */
static bool
write_submission(const char *name, const char *line)
{
    static char text[1 << 17];
    FILE *file = fopen(SWEEP, "rb");
    size_t size = file != NULL ? fread(text, 1, sizeof text - 1, file) : 0;
    text[size] = '\0';
    if (file == NULL || fclose(file) != 0 || shell("mkdir -p $d/class/%s/%s", name, SWEEP) != 0
        || shell("rmdir $d/class/%s/%s", name, SWEEP) != 0)
        return false;
    const char *place = strstr(text, "hull_chain q = {last, last};");
    char path[300];
    snprintf(path, sizeof path, "class/%s/%s", name, SWEEP);
    file = fopen(in_scratch(path).text, "wb");
    if (place == NULL || file == NULL)
        return false;
    fprintf(file, "#define _GNU_SOURCE\n#include <assert.h>\n#include <signal.h>\n"
            "#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>\n"
            "%.*s\n    hull_chain q = {last, last};\n    %s\n%s", (int)(place - text), text,
            line, place + strlen("hull_chain q = {last, last};"));
    return fclose(file) == 0;
}

/* Those that are not a folder with a file: links, archives, files without folders. */
static bool
write_odd_submissions(void)
{
    return shell(
        "cd $d/class && mkdir -p untouched link/%s linked_folder archive empty flat "
        "&& rmdir link/%s && cp -R ../base/chapters untouched && "
        "ln -s /etc/passwd link/%s && ln -s ../good/chapters linked_folder/chapters && "
        "mkdir packed && (cd good && tar -cf ../archive/submission.tar %s && "
        "tar -czf ../packed.tar.gz %s) && rmdir packed && "
        "cp good/%s flat/sweep.c && echo 'int x;' >flat/helper.h && "
        "touch \"flat/$(printf 'a\\033[31mb\\342\\200\\256\\r\\007c').h\" && "
        "mkdir -p no_function/%s && rmdir no_function/%s && "
        "sed 's/^hull_edges_seeing/another_name/' good/%s >no_function/%s && "
        "(cd link && tar -cf ../link_in_archive.tar %s) && "
        "head -c 3000 archive/submission.tar >damaged.tar && echo hello >hello.tar && "
        "touch empty/README.txt",
        SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP, SWEEP) == 0;
}

/* ---- Questions of a student's own: answers.txt. ---- */

/* Right answers to the questions of 2.3 for this name, by looking at all pairs of points. */
static bool
answer_by_hand(const char *id, char order[15], char seen[15])
{
    int x[7], y[7], at[7], next[6], begin = -1, used = 0;
    bool is_end[6] = {false};
    shell("$build/traces %s 2.3 >$d/asked.txt", id);
    const char *text = strstr(whole("asked.txt"), "points:");
    for (int i = 0; text != NULL && i < 7; i++, text += used)
        if (sscanf(text += i == 0 ? 7 : 0, " %*d (%d,%d)%n", &x[i], &y[i], &used) != 2)
            return false;
    if (text == NULL)
        return false;
    for (int v = 0; v < 7; v++) {
        int k = v;
        for (; k > 0 && (x[v] < x[at[k - 1]] || (x[v] == x[at[k - 1]] && y[v] < y[at[k - 1]]));
             k--)
            at[k] = at[k - 1];
        at[k] = v;
    }
    /* An edge of the hull of the first six, with the seventh on its right. */
    for (int a = 0; a < 6; a++) {
        next[a] = -1;
        for (int b = 0; b < 6; b++) {
            bool hull = a != b;
            for (int c = 0; c < 7; c++) {
                int p = at[a], q = at[b], r = at[c];
                int turn = (x[q] - x[p]) * (y[r] - y[p]) - (y[q] - y[p]) * (x[r] - x[p]);
                hull = hull && (c == a || c == b || (c == 6 ? turn < 0 : turn > 0));
            }
            if (hull)
                is_end[next[a] = b] = true;
        }
    }
    for (int a = 0; a < 6; a++) {
        if (next[a] >= 0 && !is_end[a])
            begin = a;
    }
    for (int i = 0; i < 7; i++)
        sprintf(order + 2 * i, "%d ", at[i]);
    for (int i = 0; begin >= 0; begin = next[begin], i++) {
        sprintf(seen + 2 * i, "%d ", at[begin]);
        if (next[begin] < 0)
            break;
    }
    return true;
}

/* How both answers come out, and what is said of the first that is not right. ORDER and SEEN
 * stand for right answers. Some have handed in the reference's code, too. */
static const struct {
    const char *name, *file, *word, *other, *sentence;
    bool code;
} sheets[] = {
    {"right", "---- 2.3\norder: ORDER\nseen:\tSEEN\n", "pass", "pass", "right",
     true},
    {"windows", "notes\r\n---- 2.3\r\norder: ORDER\r\nseen: SEEN\r\n", "pass", "pass",
     "right", false},
    {"wrong", "---- 2.3\norder: SEEN\nseen: SEEN\n", "fail", "pass", "points of wrong", false},
    {"half", "---- 2.3\norder:\nseen: SEEN\n", "todo", "pass", "filled in", false},
    {"elsewhere", "---- 3.5\norder: ORDER\n---- 2.3\nseen: SEEN\n", "malformed", "pass",
     "no line `order:`", false},
    {"twice", "---- 2.3\norder: ORDER\nseen: SEEN\norder: ORDER\n", "malformed", "pass",
     "twice", false},
    {"letters", "---- 2.3\norder: x\nseen: SEEN\n", "malformed", "pass", "0 to 6", false},
    {"run_together", "---- 2.3\norder: 0123456\nseen: SEEN\n", "malformed", "pass",
     "0 to 6", false},
    {"control", "---- 2.3\norder: ORDER\nseen: SEEN\n\033[32m", "malformed", "malformed",
     "line 4", true},
    {"latin", "---- 2.3\norder: ORDER\nseen: SEEN\n\xE9\n", "malformed", "malformed",
     "line 4", false},
    {"copied", NULL, "fail", "fail", "points of copied", false},
    {"an na", "---- 2.3\norder: 0\nseen: 0\n", "fail", "fail", "Nobody of this name", false},
    {"nothing", NULL, "refused", "refused", "not handed in", true},
};
enum { SHEETS = sizeof sheets / sizeof sheets[0], QUESTIONS_AT = 9 };

static bool
write_sheet(const char *name, const char *text)
{
    char path[100], order[15] = "", seen[15] = "";
    snprintf(path, sizeof path, "own/%s/answers.txt", name);
    FILE *file = fopen(in_scratch(path).text, "wb");
    if (file == NULL || (strchr(name, ' ') == NULL && !answer_by_hand(name, order, seen)))
        return false;
    for (const char *c = text; *c != '\0'; c++)
        if (strncmp(c, "ORDER", 5) == 0) {
            fputs(order, file);
            c += 4;
        } else if (strncmp(c, "SEEN", 4) == 0) {
            fputs(seen, file);
            c += 3;
        } else {
            putc(*c, file);
        }
    return fclose(file) == 0;
}

/* Submissions of section 2.3 with these files. */
static bool
write_sheets(void)
{
    bool written = shell("mkdir $d/own") == 0;
    for (int i = 0; i < SHEETS; i++)
        written = written &&
                  shell("mkdir \"$d/own/%s\" && cd $d/own/\"%s\" && %s", sheets[i].name,
                        sheets[i].name, sheets[i].code ? "cp -R ../../class/good/. ." : ":") == 0 &&
                  (sheets[i].file == NULL || write_sheet(sheets[i].name, sheets[i].file));
    return written && shell("cp $d/own/right/answers.txt $d/own/copied") == 0;
}

/* Grades two classes once for all that follows. */
static int
prepare(void)
{
    if (shell("$build/handout 2.3-b --no-proof -o $d/handout >$d/out 2>&1 && "
              "$build/grade --prepare --base $d/handout -o $d/base >$d/out 2>&1 && "
              "$build/grade --prepare -a 2.3 --answers -o $d/section >$d/out 2>&1") != 0)
        return -1;
    for (int i = 0; i < ENDS; i++)
        if (!write_submission(ends[i].name, ends[i].line))
            return -1;
    if (!write_odd_submissions() || !write_sheets())
        return -1;
    return shell("echo 'a secret' >$d/seed && printf 'good,Gus\\nabsent,Ann\\n' >$d/roster && "
                 "$build/grade --base $d/base --seed-file $d/seed -j 2 "
                 "--format text,gradescope,classroom50,junit,tap --csv $d/class.csv "
                 "--roster $d/roster -o $d/graded $d/class >$d/said 2>$d/err && "
                 "$build/grade --base $d/section -j 2 --roster $d/roster "
                 "--format text,gradescope,classroom50,junit,tap --csv $d/own.csv "
                 "-o $d/own_graded $d/own >$d/out 2>$d/err && "
                 "$build/grade --pack gradescope -a 2.3-b --seed-file $d/seed "
                 "-o $d/pack.zip >$d/out");
}

/* ---- What must hold. ---- */

/* graded/NAME/results.json, as text, and its test k. */
static const char *
results_of(const char *name)
{
    char path[200];
    snprintf(path, sizeof path, "graded/%s/results.json", name);
    return whole(path);
}

static const json *
test_of(const char *name, size_t k)
{
    char path[200];
    snprintf(path, sizeof path, "graded/%s/results.json", name);
    return item_of(json_member(read_json(path), "tests"), k);
}

static const char *
result_of(const json *test)
{
    return text_of(json_member(json_member(test, "extra_data"), "result"));
}

static const char *
word_of(const char *name, size_t k)
{
    return result_of(test_of(name, k));
}

static int
score_of(const char *name, size_t k)
{
    return number_of(json_member(test_of(name, k), "score"));
}

/* A crash, a time-out, an assert, undefined behaviour, ... each has its own sentence. */
static void
each_end_has_its_sentence(void)
{
    for (int i = 0; i < ENDS; i++)
        for (size_t k = 0; k < 2; k++) {
            const char *output = text_of(json_member(test_of(ends[i].name, k), "output"));
            CLAIM("grade.sentences", strcmp(word_of(ends[i].name, k), ends[i].word) == 0,
                  "%s, test %zu: %s", ends[i].name, k, word_of(ends[i].name, k));
            CLAIM("grade.sentences", strstr(output, ends[i].sentence) != NULL, "%s: %s",
                  ends[i].name, output);
        }
    CLAIM("grade.sentences", strcmp(word_of("no_function", 0), "uncompiled") == 0 &&
          strstr(results_of("no_function"), "cannot be linked") != NULL &&
          strstr(results_of("no_function"), "undefined reference") != NULL,
          "without its function: %s", results_of("no_function"));
    for (size_t k = 0; k < 2; k++)
        CLAIM("grade.todo", strcmp(word_of("untouched", k), "todo") == 0 &&
              score_of("untouched", k) == 0, "%s", word_of("untouched", k));
}

static void
has_fields(const char *name, size_t k, const json *test)
{
    static const struct { const char *name; json_kind kind; } fields[] = {
        {"name", JSON_STRING}, {"number", JSON_STRING}, {"score", JSON_NUMBER},
        {"max_score", JSON_NUMBER}, {"status", JSON_STRING}, {"output", JSON_STRING},
        {"output_format", JSON_STRING}, {"visibility", JSON_STRING}, {"tags", JSON_ARRAY},
        {"extra_data", JSON_OBJECT},
    };
    enum { FIELDS = sizeof fields / sizeof fields[0] };
    CLAIM("grade.gradescope", test->count == FIELDS, "%s: test %zu has %zu fields", name, k,
          test->count);
    for (size_t f = 0; f < FIELDS; f++) {
        const json *field = json_member(test, fields[f].name);
        CLAIM("grade.gradescope", field != NULL && field->kind == fields[f].kind,
              "%s: test %zu: %s", name, k, fields[f].name);
    }
    CLAIM("grade.gradescope", strcmp(text_of(json_member(test, "output_format")), "text") == 0 &&
          strcmp(text_of(json_member(test, "visibility")), "visible") == 0,
          "%s: test %zu", name, k);
}

/* The fields that Gradescope documents, and no other. */
static void
gradescope_has_its_fields(void)
{
    static const char *const names[] = {"good", "crash", "absent", "colour_of_error"};
    for (int i = 0; i < 4; i++) {
        char path[200];
        snprintf(path, sizeof path, "graded/%s/results.json", names[i]);
        const json *all = read_json(path), *tests = json_member(all, "tests"), *test;
        CLAIM("grade.gradescope", all != NULL, "%s: no JSON: %s", names[i], whole(path));
        CLAIM("grade.gradescope", strcmp(text_of(json_member(all, "visibility")), "visible") == 0
              && strcmp(text_of(json_member(all, "output_format")), "text") == 0 &&
              json_member(all, "score") == NULL, "%s: %s", names[i], whole(path));
        int score = 0, most = 0;
        size_t k = 0;
        for (; (test = item_of(tests, k)) != NULL; k++) {
            has_fields(names[i], k, test);
            bool passed = strcmp(text_of(json_member(test, "status")), "passed") == 0;
            int points = number_of(json_member(test, "score"));
            CLAIM("grade.gradescope", passed ||
                  strcmp(text_of(json_member(test, "status")), "failed") == 0,
                  "%s: test %zu has no status", names[i], k);
            CLAIM("grade.gradescope", points == (passed ? (int)k + 1 : 0),
                  "%s: test %zu: %d points", names[i], k, points);
            score += points;
            most += number_of(json_member(test, "max_score"));
        }
        CLAIM("grade.gradescope", k == 2 && most == 3, "%s: %zu tests, %d points", names[i], k,
              most);
        CLAIM("grade.gradescope", score == (i == 0 ? 3 : 0), "%s: %d points", names[i], score);
    }
}

static void
classroom50_has_its_fields(void)
{
    static const char *const strings[] = {"classroom", "assignment", "submission", "commit",
                                          "release", "review"};
    const char *text = whole("graded/good/result.json");
    const json *all = read_json("graded/good/result.json");
    CLAIM("grade.classroom50", all != NULL &&
          strcmp(text_of(json_member(all, "schema")), "classroom50/result/v1") == 0, "%s", text);
    for (int i = 0; i < 6; i++) {
        const json *value = json_member(all, strings[i]);
        CLAIM("grade.classroom50", value != NULL && *text_of(value) != '\0',
              "%s is missing or empty", strings[i]);
    }
    CLAIM("grade.classroom50", number_of(json_member(all, "score")) == 3 &&
          number_of(json_member(all, "max-score")) == 3, "%s", text);
    for (size_t k = 0; k < 2; k++) {
        const json *test = item_of(json_member(all, "tests"), k);
        const json *passed = json_member(test, "passed");
        CLAIM("grade.classroom50", *text_of(json_member(test, "test-name")) == '2' &&
              passed != NULL && passed->kind == JSON_TRUE &&
              number_of(json_member(test, "score")) == (int)k + 1 &&
              number_of(json_member(test, "max-score")) == (int)k + 1, "%s", text);
    }
}

static void
junit_and_tap_agree(void)
{
    bool xmllint = shell("command -v xmllint >/dev/null") == 0;
    for (int i = 0; i < ENDS; i++) {
        char path[200];
        snprintf(path, sizeof path, "graded/%s/junit.xml", ends[i].name);
        const char *text = whole(path);
        bool good = strcmp(ends[i].word, "pass") == 0;
        CLAIM("grade.junit", strstr(text, good ? "tests=\"2\" failures=\"0\" errors=\"0\""
                                    : "tests=\"2\" failures=\"2\" errors=\"0\"") != NULL,
              "%s: %s", ends[i].name, text);
        CLAIM("grade.junit", !xmllint || shell("xmllint --noout $d/%s 2>$d/err", path) == 0,
              "%s: %s", ends[i].name, read_scratch("err").text);
        CLAIM("grade.junit", strstr(text, "<script") == NULL && strstr(text, "<b>") == NULL,
              "%s: a tag gets through: %s", ends[i].name, text);
        CLAIM("grade.tap", shell("grep -c '^%s [12] - 2.3-b ' $d/graded/%s/result.tap | "
                                 "grep -qx 2 && grep -qx '1[.][.]2' $d/graded/%s/result.tap",
                                 good ? "ok" : "not ok", ends[i].name, ends[i].name) == 0,
              "%s: result.tap", ends[i].name);
    }
}

/* A row for each, in the order of the names; those who handed in nothing, too. */
static void
the_class_is_one_table(void)
{
    const char *text = whole("class.csv");
    CLAIM("grade.csv", strncmp(text, "submission,score,total,state,2.3-b sees,2.3-b chain\n",
                               51) == 0, "%s", text);
    CLAIM("grade.csv", shell("tail -n +2 $d/class.csv | cut -d, -f1 | LC_ALL=C sort -c") == 0,
          "the rows are not in order: %s", text);
    CLAIM("grade.csv", strstr(text, "\n\"good\",3,3,graded,1,2\n") != NULL &&
          strstr(text, "\n\"absent\",0,3,missing,0,0\n") != NULL &&
          strstr(text, "\n\"empty\",0,3,refused,0,0\n") != NULL &&
          strstr(text, "\n\"fork\",0,3,graded,0,0\n") != NULL, "%s", text);
    CLAIM("grade.csv", shell("test $(wc -l <$d/class.csv) -eq %d", ENDS + 13) == 0,
          "%d rows are expected: %s", ENDS + 12, text);
    CLAIM("grade.text", strstr(whole("said"), "good: 3 of 3 points\n") != NULL, "%s",
          whole("said"));
}

static void
submissions_come_in_every_form(void)
{
    static const char *const whole_ones[] = {"archive", "packed", "flat"};
    static const char *const refused[] = {"link", "linked_folder", "link_in_archive", "damaged",
                                          "hello", "empty"};
    for (int i = 0; i < 3; i++)
        CLAIM("grade.forms", score_of(whole_ones[i], 1) == 2, "%s: %s", whole_ones[i],
              results_of(whole_ones[i]));
    for (int i = 0; i < 6; i++)
        CLAIM("grade.refuses", strcmp(word_of(refused[i], 0), "refused") == 0 &&
              score_of(refused[i], 1) == 0, "%s: %s", refused[i], results_of(refused[i]));
    CLAIM("grade.refuses", strstr(results_of("link"), "is a link") != NULL &&
          strstr(results_of("link_in_archive"), "is a link") != NULL &&
          strstr(results_of("linked_folder"), "is a link") != NULL, "links: %s",
          results_of("link"));
    CLAIM("grade.unlisted", strstr(results_of("flat"), "helper.h") != NULL,
          "%s", results_of("flat"));
    CLAIM("grade.refuses", shell("! grep -rq 'root:' $d/graded") == 0, "a link is followed");
}

static void
nothing_controls_a_terminal(void)
{
    CLAIM("grade.clean", shell("! LC_ALL=C grep -rlq \"$(printf '[\\001-\\010\\013-\\037\\177"
                               "\\200-\\377]')\" $d/graded $d/said $d/class.csv") == 0,
          "a control character is in the results");
    CLAIM("grade.clean", strstr(results_of("colour_of_error"), "<script") == NULL,
          "a tag is in the JSON");
    CLAIM("grade.clean", strstr(whole("graded/secret/result.txt"), "Permission denied") != NULL,
          "%s", whole("graded/secret/result.txt"));
}

static void
the_same_submission_gives_the_same_bytes(void)
{
    int status = shell("$build/grade --base $d/base --seed-file $d/seed "
                       "--format text,gradescope,classroom50,junit,tap -o $d/again "
                       "$d/class/crash $d/class/good $d/class/colour_of_error >$d/out && "
                       "for s in crash good colour_of_error; do "
                       "diff -r $d/graded/$s $d/again/$s >$d/out || exit 9; done");
    CLAIM("grade.same", status == 0, "status %d: %s", status, read_scratch("out").text);
    CLAIM("grade.same", shell("test -s $d/again/crash/feedback/2.3-b/sees.svg") == 0,
          "no picture");
}

/* Makes $d/NAME, a base with a checker that does its work once, for the tree as it was
 * handed out, and then only this. */
static void
make_faulty(const char *name, const char *then)
{
    shell("cp -R $d/base $d/%s && cd $d/%s/build && mv checker_2.3 real && "
          "printf '#!/bin/sh\\nif test -e \"$0.called\"; then %s; exit; fi\\n"
          ": >\"$0.called\"; exec \"${0%%%%/*}/real\" \"$@\"\\n' >checker_2.3 && "
          "chmod +x checker_2.3", name, name, then);
}

/* When the checker itself fails, there is no score, and the status says so. */
static void
a_fault_of_the_grader_is_no_score(void)
{
    make_faulty("faulty", "\"${0%%/*}/real\" \"$@\"; exit 9");
    int status = shell("$build/grade --base $d/faulty --format text,gradescope,junit,tap "
                       "--csv $d/faulty.csv -o $d/fault $d/class/good >$d/out");
    const json *all = read_json("fault/results.json");
    CLAIM("grade.infra", status == 3, "status %d", status);
    CLAIM("grade.infra", all != NULL && json_member(all, "tests") == NULL &&
          json_member(all, "score") == NULL &&
          json_member(json_member(all, "extra_data"), "infra_error") != NULL, "%s",
          whole("fault/results.json"));
    CLAIM("grade.infra", strstr(whole("faulty.csv"), "\n\"good\",,3,infra_error,,\n") != NULL,
          "%s", whole("faulty.csv"));
    CLAIM("grade.infra", strstr(whole("fault/junit.xml"), "errors=\"2\"") != NULL &&
          strstr(whole("fault/result.tap"), "Bail out!") != NULL, "%s",
          whole("fault/junit.xml"));
    make_faulty("silent", "exit 42");
    status = shell("$build/grade --base $d/silent --format gradescope -o $d/fault2 "
                   "$d/class/good >$d/out");
    CLAIM("grade.infra", status == 3, "a checker that says nothing accepts: status %d", status);
}

/* Nor does anybody lose points where nothing can be graded at all. */
static void
a_machine_that_cannot_grade_is_noticed(void)
{
    int status = shell("cp -R $d/base $d/none && rm $d/none/build/opaque/libgiven.a && "
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
    int status = shell("exec 2>$d/noise; "
                       "TMPDIR=$d/tmp $build/grade --base $d/slow --format gradescope "
                       "-o $d/killed $d/class/good >$d/out 2>&1 & grader=$!; "
                       "for i in $(seq 60); do sleep 0.2; "
                       "test -e $d/slow.pid && break; done; "
                       "cp $d/killed/results.json $d/first.json; kill $grader; wait $grader; "
                       "ls -A $d/tmp >$d/out; test ! -s $d/out && sleep 0.2 && "
                       "! grep -q 'State:.[RSDT]' /proc/$(cat $d/slow.pid)/status");
    const json *last = item_of(json_member(read_json("first.json"), "tests"), 1);
    CLAIM("grade.zero", strstr(text_of(json_member(last, "output")), "interrupted") != NULL &&
          number_of(json_member(last, "score")) == 0, "%s", whole("first.json"));
    CLAIM("grade.zero", status == 0 && read_json("killed/results.json") != NULL,
          "files are left, or a process: %s", read_scratch("out").text);
}

/* --supply: 2.3-c is right, and rests on a 2.3-b that is wrong. */
static void
one_mistake_is_not_punished_twice(void)
{
    const char *wrong = "if (last != NONE) return q;";
    CLAIM("grade.supply", write_submission("wrong_b", wrong), "no submission");
    int status = shell("$build/grade --base $d/section --supply --format text -o $d/supplied "
                       "$d/class/wrong_b >$d/out 2>&1 && "
                       "grep -q '^  0/4  2.3-b chain  *fail ' $d/out && "
                       "grep -q '^  6/6  2.3-c triangulation  *pass .*others* exercises' $d/out");
    /* A program with the address sanitizer, as splice is then, cannot start in the jail. */
    bool sanitized = shell("nm $build/splice 2>$d/err | grep -q __asan_init") == 0;
    CLAIM("grade.supply", status == 0 || sanitized, "status %d: %s", status,
          read_scratch("out").text);
}

static void
a_conversation_shows_functions_and_a_bug(void)
{
    int status = shell("$build/grade --viva anna --base $d/base $d/class/good >$d/anna && "
                       "$build/grade --viva anna --base $d/base $d/class/good >$d/anna2 && "
                       "$build/grade --viva bert --base $d/base $d/class/good >$d/bert && "
                       "cmp $d/anna $d/anna2 && sed 1d $d/anna >$d/a && sed 1d $d/bert >$d/b "
                       "&& ! cmp -s $d/a $d/b");
    CLAIM("grade.viva", status == 0, "status %d", status);
    CLAIM("grade.viva", strstr(whole("anna"), "\nhull_edges_seeing(") != NULL &&
          strstr(whole("anna"), "Which statement fails, and why?") != NULL &&
          strstr(whole("anna"), "no harm") != NULL, "%s", whole("anna"));
}

/* The questions are 6 of 30 points, the exercises twice their 12. */
static void
questions_of_their_own_are_a_fifth(void)
{
    for (int i = 0; i < SHEETS; i++) {
        const char *name = sheets[i].name, *word = sheets[i].word, *other = sheets[i].other;
        int right = (strcmp(word, "pass") == 0) + (strcmp(other, "pass") == 0);
        char row[200], path[100];
        snprintf(path, sizeof path, "own_graded/%s/results.json", name);
        const json *tests = json_member(read_json(path), "tests"), *test[2];
        for (size_t k = 0; k < 2; k++)
            test[k] = item_of(tests, QUESTIONS_AT + k);
        CLAIM("grade.answers", item_of(tests, QUESTIONS_AT + 2) == NULL &&
              strcmp(result_of(test[0]), word) == 0 && strcmp(result_of(test[1]), other) == 0,
              "%s: %s", name, whole(path));
        CLAIM("grade.answers", strstr(text_of(json_member(test[0], "output")),
                                      sheets[i].sentence) != NULL, "%s: %s", name, whole(path));
        snprintf(row, sizeof row, "\n\"%s\",%d,30,graded,", name,
                 24 * sheets[i].code + 3 * right);
        CLAIM("grade.answers", strstr(whole("own.csv"), row) != NULL, "%s: %s", row,
              whole("own.csv"));
        snprintf(path, sizeof path, "own_graded/%s/result.tap", name);
        CLAIM("grade.answers", strstr(whole(path), " - 2.3 order\n") != NULL &&
              strstr(whole(path), right == 2 ? "\nok 11 - 2.3 seen" : " - 2.3 seen") != NULL, "%s",
              whole(path));
    }
    CLAIM("grade.answers", strstr(whole("own.csv"), ",2.3 order,2.3 seen\n") != NULL &&
          strstr(whole("own.csv"), "\n\"absent\",0,30,missing,") != NULL, "%s",
          whole("own.csv"));
    CLAIM("grade.answers", strstr(whole("own_graded/half/junit.xml"), "<testcase classname=\"2.3\" "
                                  "name=\"order\">\n      <failure type=\"todo\"") != NULL &&
          strstr(whole("own_graded/right/result.json"), "\"score\": 30,\n  \"max-score\": 30,") != NULL
          && strstr(whole("own_graded/half/result.txt"), "  0/3  2.3 order ") != NULL, "%s",
          whole("own_graded/right/result.json"));
    CLAIM("grade.answers", shell("! LC_ALL=C grep -rlq \"$(printf '[\\033\\351]')\" "
                                 "$d/own_graded") == 0,
          "a control character is in the results");
    CLAIM("grade.answers", shell("$build/grade --pack gradescope -a 2.3 --answers -o $d/no.zip "
                                 ">$d/out 2>&1") == 1 && has("out", "which it must not have"),
          "%s", read_scratch("out").text);
}

/* ---- Gradescope, in a folder laid out as there. ---- */

static int set_up; /* the status of setup.sh */

/* Unpacks and sets it up, in $d/there, as its image is made. */
static int
prepare_gradescope(void)
{
    return shell("mkdir $d/there $d/there/results && "
                 "unzip -q $d/pack.zip -d $d/there/source >$d/out 2>&1 && "
                 "cp -R $d/class/archive $d/there/submission && "
                 "AUTOGRADER=$d/there $d/there/source/setup.sh >$d/out 2>&1");
}

static void
run_there(const char *as, const char *where)
{
    int status = shell("cd $d/%s && AUTOGRADER=$d/%s %s source/run_autograder >$d/out 2>&1",
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
    CLAIM("grade.pack", set_up == 0, "setup.sh: status %d: %s", set_up,
          read_scratch("out").text);
    run_there("", "there");
}

static void
it_runs_as_another_user(void)
{
    shell("rm -f $d/there/results/* && cp -R $d/there $d/nobody && "
          "chmod 755 $d && chown -R 65534 $d/nobody");
    run_there("setpriv --reuid 65534 --regid 65534 --clear-groups", "nobody");
}

static void
the_archive_has_no_solution(void)
{
    int status = shell("$build/grade --pack gradescope -a 2.3-b --seed-file $d/seed "
                       "-o $d/again.zip >$d/out && cmp $d/pack.zip $d/again.zip");
    CLAIM("grade.pack", status == 0, "status %d: %s", status, read_scratch("out").text);
    CLAIM("grade.pack", shell("grep -q 'hull_edges_seeing' $d/pack.zip && "
                              "! grep -q 'mesh_hull_prev(m, q.first)' $d/pack.zip") == 0,
          "a solution is in the archive");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "the grader: every submission gets its points, and nothing else");
    int status = prepare();
    if (shell("echo 'int main(void){return 0;}' >$d/a.c && ${CC-cc} -static $d/a.c -o $d/a "
              "2>$d/err") != 0) {
        printf("ok 1 - # SKIP programs cannot be linked statically\n1..1\n");
        shell_end();
        return 0;
    }
    if (status != 0) {
        printf("not ok 1 - the class is graded: status %d: %s%s\n1..1\n", status,
               read_scratch("out").text, read_scratch("err").text);
        shell_end();
        return 1;
    }
    test_run("each end has its sentence", each_end_has_its_sentence);
    test_run("Gradescope has its fields", gradescope_has_its_fields);
    test_run("Classroom 50 has its fields", classroom50_has_its_fields);
    test_run("JUnit and TAP agree", junit_and_tap_agree);
    test_run("the class is one table", the_class_is_one_table);
    test_run("submissions come in every form", submissions_come_in_every_form);
    test_run("nothing controls a terminal", nothing_controls_a_terminal);
    test_run("the same submission gives the same bytes",
             the_same_submission_gives_the_same_bytes);
    test_run("a fault of the grader is no score", a_fault_of_the_grader_is_no_score);
    test_run("a machine that cannot grade is noticed", a_machine_that_cannot_grade_is_noticed);
    test_run("a zero is there first", a_zero_is_there_first);
    test_run("one mistake is not punished twice", one_mistake_is_not_punished_twice);
    test_run("questions of their own are a fifth", questions_of_their_own_are_a_fifth);
    test_run("a conversation shows functions and a bug",
             a_conversation_shows_functions_and_a_bug);
    test_run("the archive has no solution", the_archive_has_no_solution);
    if (shell("command -v unzip >$d/out") != 0) {
        puts("# skipped: there is no unzip");
    } else {
        set_up = prepare_gradescope();
        test_run("it runs as root, or as you", it_runs_as_root_or_as_you);
        if (geteuid() == 0 && shell("command -v setpriv >$d/out") == 0)
            test_run("it runs as another user", it_runs_as_another_user);
    }
    int result = test_end((test_minima){.trials = 14});
    shell_end();
    return result;
}
