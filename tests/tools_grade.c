/* The grader gives each property of a submission its points or not, and says why;
 * whatever a submission does, and in whatever form it comes, it is graded, and nobody
 * else's result changes.
 *
 * Hypotheses: Linux, and a compiler that links statically; otherwise it is said, and
 * not asked about. The checkers have tests of their own: what is graded here is
 * exercise 2.3-b, with the reference's code, and with lines added to it.
 * tests/tools_grade_formats.c looks at the files that others read,
 * tests/tools_grade_answers.c at questions of a student's own.
 */
#include "tests/harness/graded.h"
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <string.h>

/* ---- The submissions. ---- */

/* A line that is added to the reference's function, and how the property comes out. */
static const struct {
    const char *name, *line, *word, *sentence;
} ends[] = {
    {"crash", "*(volatile char *)(size_t)(q.first + 64) = 1;", "crash", "crashed"},
    {"assert", "assert(q.first != q.end);", "assert", "assertion"},
    {"overflow", "volatile int most = 2147483647; most += 1;", "undefined",
     "undefined"},
    {"late", "raise(SIGXCPU);", "timeout", "in time"},
    {"exit", "exit(0);", "noanswer", "ended without an answer"},
    {"good", "fputs(\"no harm\\n\", stderr);", "pass", ""},
    {"garbage", "write(4, \"*** all tests passed ***\", 24);", "malformed",
     "no answer and no"},
    {"fork", "fork();", "forbidden", "stopped"},
    {"open", "fopen(\"/etc/passwd\", \"r\");", "forbidden", "stopped"},
    {"kill", "kill(getppid(), SIGKILL);", "forbidden", "stopped"},
    {"colours",
     "fputs(\"\\033[2J\\033]0;PASSED\\007<b>&\\x9b\\r\\n\", stderr); abort();",
     "assert", "assertion"},
    {"does_not_end", "/* ", "uncompiled", "does not compile"},
    {"colour_of_error", "\n#error \\033[32m</pre><script>PASSED</script>\n",
     "uncompiled", "does not compile"},
    {"secret", "\n#include \"/etc/hostname\"\n", "uncompiled", "does not compile"},
};
enum { ENDS = sizeof ends / sizeof ends[0] };

/* Those that are not a folder with a file: links, archives, files without folders. */
static bool
write_odd_submissions(void)
{
    return shell(
        "zip=$PWD/tests/grading/make_zip.sh f=%s; cd $d/class && "
        "mkdir -p untouched link/$f linked_folder archive empty flat && "
        "rmdir link/$f && cp -R ../base/chapters untouched && "
        "ln -s /etc/passwd link/$f && "
        "ln -s ../good/chapters linked_folder/chapters && "
        "(cd good && tar -cf ../archive/submission.tar $f && "
        "tar -czf ../packed.tar.gz $f) && "
        "cp good/$f flat/sweep.c && echo 'int x;' >flat/helper.h && "
        "touch \"flat/$(printf 'a\\033[31mb\\342\\200\\256\\r\\007c').h\" && "
        "mkdir -p no_function/$f && rmdir no_function/$f && "
        "sed 's/^hull_edges_seeing/another_name/' good/$f >no_function/$f && "
        "(cd link && tar -cf ../link_in_archive.tar $f) && "
        "head -c 3000 archive/submission.tar >damaged.tar && "
        "echo hello >hello.tar && "
        "cp -R good nested && (cd nested && mkdir a && mv chapters a && "
        "mkdir -p b/b/chapters && echo 'wrong' >b/b/sweep.c && "
        "tar -czf ../nested.tgz .) && rm -r nested && "
        "mkdir zipped && sh $zip zipped/week2.zip 0100644 week2/$f good/$f "
        "0100644 __MACOSX/week2/._sweep.c good/$f 0100644 week2/more.c good/$f && "
        "sh $zip backslashes.zip 0100644 "
        "chapters\\\\2.3_line_sweep\\\\sweep.c good/$f && "
        "touch empty/README.txt", SWEEP) == 0;
}

/* Grades the class once for all that follows. */
static int
prepare(void)
{
    if (shell("$build/handout 2.3-b --no-proof -o $d/handout >$d/out 2>&1 && "
              "$build/grade --prepare --base $d/handout -o $d/base >$d/out 2>&1") != 0)
        return -1;
    for (int i = 0; i < ENDS; i++)
        if (!write_submission(ends[i].name, ends[i].line))
            return -1;
    if (!write_odd_submissions())
        return -1;
    return shell(
        "echo 'a secret' >$d/seed && printf 'good,Gus\\nabsent,Ann\\n' >$d/roster && "
        "$build/grade --base $d/base --seed-file $d/seed -j 2 "
        "--format text,gradescope,classroom50,junit,tap --csv $d/class.csv "
        "--roster $d/roster -o $d/graded $d/class >$d/said 2>$d/err");
}

/* ---- What must hold. ---- */

/* A crash, a time-out, an assert, undefined behaviour, ... each has its own
 * sentence. */
static void
each_end_has_its_sentence(void)
{
    static const char *const files[] = {"result.txt", "result.json", "junit.xml",
                                        "result.tap"};
    for (int i = 0; i < ENDS; i++)
        for (size_t k = 0; k < 2; k++) {
            const char *output =
                text_of(json_member(test_of(ends[i].name, k), "output"));
            CLAIM("grade.sentences",
                  strcmp(word_of(ends[i].name, k), ends[i].word) == 0,
                  "%s, test %zu: %s", ends[i].name, k, word_of(ends[i].name, k));
            CLAIM("grade.sentences", strstr(output, ends[i].sentence) != NULL, "%s: %s",
                  ends[i].name, output);
        }
    for (int i = 0; i < ENDS; i++)
        for (int f = 0; f < 4; f++) {
            char path[100];
            snprintf(path, sizeof path, "graded/%s/%s", ends[i].name, files[f]);
            CLAIM("grade.everywhere",
                  strcmp(ends[i].word, "pass") == 0 ||
                      strstr(whole(path), ends[i].sentence) != NULL,
                  "%s: %s", path, whole(path));
        }
    CLAIM("grade.everywhere",
          strstr(whole("graded/crash/result.txt"), "\n  2.3-b sees: crashes\n") !=
                  NULL &&
              strstr(whole("graded/late/result.tap"),
                     "\n# 2.3-b sees: does not answer in time\n") != NULL,
          "%s", whole("graded/crash/result.txt"));
    CLAIM("grade.sentences", strcmp(word_of("no_function", 0), "uncompiled") == 0 &&
          strstr(results_of("no_function"), "cannot be linked") != NULL &&
          strstr(results_of("no_function"), "undefined reference") != NULL,
          "without its function: %s", results_of("no_function"));
    for (size_t k = 0; k < 2; k++)
        CLAIM("grade.todo", strcmp(word_of("untouched", k), "todo") == 0 &&
              score_of("untouched", k) == 0, "%s", word_of("untouched", k));
}

/* A row for each, in the order of the names; those who handed in nothing, too. */
static void
the_class_is_one_table(void)
{
    const char *text = whole("class.csv");
    CLAIM("grade.csv",
          strncmp(text, "submission,score,total,state,2.3-b sees,2.3-b chain\n", 51) ==
              0,
          "%s", text);
    CLAIM("grade.csv",
          shell("tail -n +2 $d/class.csv | cut -d, -f1 | LC_ALL=C sort -c") == 0,
          "the rows are not in order: %s", text);
    CLAIM("grade.csv", strstr(text, "\n\"good\",3,3,graded,1,2\n") != NULL &&
          strstr(text, "\n\"absent\",0,3,missing,0,0\n") != NULL &&
          strstr(text, "\n\"empty\",0,3,refused,0,0\n") != NULL &&
          strstr(text, "\n\"fork\",0,3,graded,0,0\n") != NULL, "%s", text);
    CLAIM("grade.csv", shell("test $(wc -l <$d/class.csv) -eq %d", ENDS + 16) == 0,
          "%d rows are expected: %s", ENDS + 15, text);
    CLAIM("grade.text", strstr(whole("said"), "good: 3 of 3 points\n") != NULL, "%s",
          whole("said"));
}

static void
submissions_come_in_every_form(void)
{
    static const char *const whole_ones[] = {"archive", "packed", "flat",
                                             "nested",  "zipped", "backslashes"};
    static const char *const refused[] = {"link",    "linked_folder", "link_in_archive",
                                          "damaged", "hello",         "empty"};
    for (int i = 0; i < 6; i++)
        CLAIM("grade.forms", score_of(whole_ones[i], 1) == 2, "%s: %s", whole_ones[i],
              results_of(whole_ones[i]));
    for (int i = 0; i < 6; i++)
        CLAIM("grade.refuses",
              strcmp(word_of(refused[i], 0), "refused") == 0 &&
                  score_of(refused[i], 1) == 0,
              "%s: %s", refused[i], results_of(refused[i]));
    CLAIM("grade.refuses", strstr(results_of("link"), "is a link") != NULL &&
          strstr(results_of("link_in_archive"), "is a link") != NULL &&
          strstr(results_of("linked_folder"), "is a link") != NULL, "links: %s",
          results_of("link"));
    CLAIM("grade.unlisted", strstr(results_of("flat"), "helper.h") != NULL,
          "%s", results_of("flat"));
    CLAIM("grade.unlisted", strstr(results_of("zipped"), ", week2/more.c.") != NULL,
          "%s", results_of("zipped"));
    CLAIM("grade.unlisted",
          strstr(results_of("nested"), "not used: b/b/sweep.c.") != NULL, "%s",
          results_of("nested"));
    CLAIM("grade.refuses", shell("! grep -rq 'root:' $d/graded") == 0,
          "a link is followed");
}

static void
nothing_controls_a_terminal(void)
{
    CLAIM("grade.clean",
          shell("! LC_ALL=C grep -rlq \"$(printf '[\\001-\\010\\013-\\037\\177"
                "\\200-\\377]')\" $d/graded $d/said $d/class.csv") == 0,
          "a control character is in the results");
    CLAIM("grade.clean", strstr(results_of("colour_of_error"), "<script") == NULL,
          "a tag is in the JSON");
    CLAIM("grade.clean",
          strstr(whole("graded/secret/result.txt"), "Permission denied") != NULL, "%s",
          whole("graded/secret/result.txt"));
}

static void
the_same_submission_gives_the_same_bytes(void)
{
    int status =
        shell("$build/grade --base $d/base --seed-file $d/seed "
              "--format text,gradescope,classroom50,junit,tap -o $d/again "
              "$d/class/crash $d/class/good $d/class/colour_of_error >$d/out && "
              "for s in crash good colour_of_error; do "
              "diff -r $d/graded/$s $d/again/$s >$d/out || exit 9; done");
    CLAIM("grade.same", status == 0, "status %d: %s", status, read_scratch("out").text);
    CLAIM("grade.same", shell("test -s $d/again/crash/feedback/2.3-b/sees.svg") == 0,
          "no picture");
}

static void
a_conversation_shows_functions_and_a_bug(void)
{
    int status =
        shell("$build/grade --viva anna --base $d/base $d/class/good >$d/anna && "
              "$build/grade --viva anna --base $d/base $d/class/good >$d/anna2 && "
              "$build/grade --viva bert --base $d/base $d/class/good >$d/bert && "
              "cmp $d/anna $d/anna2 && sed 1d $d/anna >$d/a && sed 1d $d/bert >$d/b "
              "&& ! cmp -s $d/a $d/b");
    CLAIM("grade.viva", status == 0, "status %d", status);
    CLAIM("grade.viva", strstr(whole("anna"), "\nhull_edges_seeing(") != NULL &&
          strstr(whole("anna"), "Which statement fails, and why?") != NULL &&
          strstr(whole("anna"), "no harm") != NULL, "%s", whole("anna"));
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv,
               "the grader: every submission gets its points, and nothing else");
    graded_or_end(prepare());
    test_run("each end has its sentence", each_end_has_its_sentence);
    test_run("the class is one table", the_class_is_one_table);
    test_run("submissions come in every form", submissions_come_in_every_form);
    test_run("nothing controls a terminal", nothing_controls_a_terminal);
    test_run("the same submission gives the same bytes",
             the_same_submission_gives_the_same_bytes);
    test_run("a conversation shows functions and a bug",
             a_conversation_shows_functions_and_a_bug);
    int result = test_end((test_minima){.trials = 6});
    shell_end();
    return result;
}
