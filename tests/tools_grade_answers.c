/* Questions of a student's own are a fifth of the points, and what does not answer them
 * says so; and an exercise that rests on another one can be tried with the project's.
 *
 * Hypotheses: as tests/tools_grade.c; section 2.3.
 */
#include "tests/harness/graded.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <string.h>

/* ---- Questions of a student's own: answers.txt. ---- */

/* Right answers to the questions of 2.3 for this name, by looking at all pairs of
 * points. */
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
        for (; k > 0 &&
               (x[v] < x[at[k - 1]] || (x[v] == x[at[k - 1]] && y[v] < y[at[k - 1]]));
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
                int turn =
                    (x[q] - x[p]) * (y[r] - y[p]) - (y[q] - y[p]) * (x[r] - x[p]);
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

/* How both answers come out, and what is said of the first that is not right. ORDER and
 * SEEN stand for right answers. Some have handed in the reference's code, too. */
static const struct {
    const char *name, *file, *word, *other, *sentence;
    bool code;
} sheets[] = {
    {"right", "---- 2.3\norder: ORDER\nseen:\tSEEN\n", "pass", "pass", "right", true},
    {"windows", "notes\r\n---- 2.3\r\norder: ORDER\r\nseen: SEEN\r\n", "pass", "pass",
     "right", false},
    {"wrong", "---- 2.3\norder: SEEN\nseen: SEEN\n", "fail", "pass", "points of wrong",
     false},
    {"half", "---- 2.3\norder:\nseen: SEEN\n", "todo", "pass", "filled in", false},
    {"elsewhere", "---- 3.5\norder: ORDER\n---- 2.3\nseen: SEEN\n", "malformed", "pass",
     "no line `order:`", false},
    {"twice", "---- 2.3\norder: ORDER\nseen: SEEN\norder: ORDER\n", "malformed", "pass",
     "twice", false},
    {"letters", "---- 2.3\norder: x\nseen: SEEN\n", "malformed", "pass", "0 to 6",
     false},
    {"run_together", "---- 2.3\norder: 0123456\nseen: SEEN\n", "malformed", "pass",
     "0 to 6", false},
    {"control", "---- 2.3\norder: ORDER\nseen: SEEN\n\033[32m", "malformed",
     "malformed", "line 4", true},
    {"latin", "---- 2.3\norder: ORDER\nseen: SEEN\n\xE9\n", "malformed", "malformed",
     "line 4", false},
    {"copied", NULL, "fail", "fail", "points of copied", false},
    {"an na", "---- 2.3\norder: 0\nseen: 0\n", "fail", "fail", "Nobody of this name",
     false},
    {"nothing", NULL, "refused", "refused", "not handed in", true},
};
enum { SHEETS = sizeof sheets / sizeof sheets[0], QUESTIONS_AT = 9 };

static bool
write_sheet(const char *name, const char *text)
{
    char path[100], order[15] = "", seen[15] = "";
    snprintf(path, sizeof path, "own/%s/answers.txt", name);
    FILE *file = fopen(in_scratch(path).text, "wb");
    if (file == NULL ||
        (strchr(name, ' ') == NULL && !answer_by_hand(name, order, seen)))
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
        written =
            written &&
            shell("mkdir \"$d/own/%s\" && cd $d/own/\"%s\" && %s", sheets[i].name,
                  sheets[i].name,
                  sheets[i].code ? "cp -R ../../class/good/. ." : ":") == 0 &&
            (sheets[i].file == NULL || write_sheet(sheets[i].name, sheets[i].file));
    return written && shell("cp $d/own/right/answers.txt $d/own/copied") == 0;
}

/* Grades the class once for all that follows. */
static int
prepare(void)
{
    if (!write_submission("good", "") || !write_sheets())
        return -1;
    return shell(
        "$build/grade --prepare -a 2.3 --answers -o $d/section >$d/out 2>&1 && "
        "echo absent >$d/roster && "
        "$build/grade --base $d/section -j 2 --roster $d/roster "
        "--format text,gradescope,classroom50,junit,tap --csv $d/own.csv "
        "-o $d/own_graded $d/own >$d/out 2>$d/err");
}

/* --supply: 2.3-c is right, and rests on a 2.3-b that is wrong. For root this must work
 * in a folder that nobody else may look into: in the jail he is nobody. (A program with
 * the address sanitizer cannot start there: then splice is another, without.) */
static void
one_mistake_is_not_punished_twice(void)
{
    const char *wrong = "if (last != NONE) return q;";
    CLAIM("grade.supply", write_submission("wrong_b", wrong), "no submission");
    int status =
        shell("mkdir -m 700 $d/closed && mkdir $d/closed/build && "
              "cp -R chapters docs $d/closed && "
              "cp $build/grade $build/jail $build/splice $d/closed/build && "
              "if nm $build/splice 2>$d/err | grep -q __asan_init; then "
              "  cd tools/handout && ${CC-cc} -O1 -w -D_POSIX_C_SOURCE=200809L "
              "  -I../.. basics.c exercises.c rewrite.c scan.c splice.c "
              "  -o $d/closed/build/splice; fi && "
              "cd $d/closed && build/grade --base $d/section --supply "
              "--format text -o $d/supplied $d/class/wrong_b >$d/out 2>&1 && "
              "grep -q '^  0/4  2.3-b chain  *fail ' $d/out && "
              "grep -q '^  6/6  2.3-c triangulation  *pass .*others* exercises' "
              "$d/out");
    CLAIM("grade.supply", status == 0, "status %d: %s", status,
          read_scratch("out").text);
    status = shell("cd $d && $build/grade --base $d/section --supply $d/class/wrong_b "
                   ">$d/out 2>&1");
    CLAIM("grade.supply", status == 1 && has("out", "run it in its root"),
          "where there is no project: status %d: %s", status, read_scratch("out").text);
    status =
        shell("cd $d/closed && chmod -x build/splice && build/grade --base $d/section "
              "--supply $d/class/wrong_b >$d/out 2>&1");
    CLAIM("grade.supply", status != 0 && has("out", "splice ended with status"),
          "a splice that does not run: status %d: %s", status,
          read_scratch("out").text);
}

/* The questions are 6 of 30 points, the exercises twice their 12. */
static void
questions_of_their_own_are_a_fifth(void)
{
    for (int i = 0; i < SHEETS; i++) {
        const char *name = sheets[i].name, *word = sheets[i].word,
                   *other = sheets[i].other;
        int right = (strcmp(word, "pass") == 0) + (strcmp(other, "pass") == 0);
        char row[200], path[100];
        snprintf(path, sizeof path, "own_graded/%s/results.json", name);
        const json *tests = json_member(read_json(path), "tests"), *test[2];
        for (size_t k = 0; k < 2; k++)
            test[k] = item_of(tests, QUESTIONS_AT + k);
        CLAIM("grade.answers",
              item_of(tests, QUESTIONS_AT + 2) == NULL &&
                  strcmp(result_of(test[0]), word) == 0 &&
                  strcmp(result_of(test[1]), other) == 0,
              "%s: %s", name, whole(path));
        CLAIM("grade.answers",
              strstr(text_of(json_member(test[0], "output")), sheets[i].sentence) !=
                  NULL,
              "%s: %s", name, whole(path));
        snprintf(row, sizeof row, "\n\"%s\",%d,30,graded,", name,
                 24 * sheets[i].code + 3 * right);
        CLAIM("grade.answers", strstr(whole("own.csv"), row) != NULL, "%s: %s", row,
              whole("own.csv"));
        snprintf(path, sizeof path, "own_graded/%s/result.tap", name);
        CLAIM("grade.answers",
              strstr(whole(path), " - 2.3 order\n") != NULL &&
                  strstr(whole(path),
                         right == 2 ? "\nok 11 - 2.3 seen" : " - 2.3 seen") != NULL,
              "%s", whole(path));
    }
    CLAIM("grade.answers", strstr(whole("own.csv"), ",2.3 order,2.3 seen\n") != NULL &&
          strstr(whole("own.csv"), "\n\"absent\",0,30,missing,") != NULL, "%s",
          whole("own.csv"));
    CLAIM("grade.answers",
          strstr(whole("own_graded/half/junit.xml"),
                 "<testcase classname=\"2.3\" "
                 "name=\"order\">\n      <failure type=\"todo\"") != NULL &&
              strstr(whole("own_graded/right/result.json"),
                     "\"score\": 30,\n  \"max-score\": 30,") != NULL &&
              strstr(whole("own_graded/half/result.txt"), "  0/3  2.3 order ") != NULL,
          "%s", whole("own_graded/right/result.json"));
    CLAIM("grade.answers", shell("! LC_ALL=C grep -rlq \"$(printf '[\\033\\351]')\" "
                                 "$d/own_graded") == 0,
          "a control character is in the results");
    CLAIM("grade.answers",
          shell("$build/grade --pack gradescope -a 2.3 --answers -o $d/no.zip "
                ">$d/out 2>&1") == 1 &&
              has("out", "which it must not have"),
          "%s", read_scratch("out").text);
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "questions of one's own, and exercises that rest on others");
    graded_or_end(prepare());
    test_run("questions of their own are a fifth", questions_of_their_own_are_a_fifth);
    test_run("one mistake is not punished twice", one_mistake_is_not_punished_twice);
    int result = test_end((test_minima){.trials = 2});
    shell_end();
    return result;
}
