/* lib/verdict and lib/status: answers that people can read.
 *
 * Hypotheses: none.
 */
#include "lib/status.h"
#include "lib/verdict.h"

#include "tests/harness/harness.h"

#include <string.h>

static void
sentences_and_witnesses_are_kept(void)
{
    CLAIM("verdict_holds", verdict_holds().holds, "it does not");
    CLAIM("verdict_holds", verdict_holds().witnesses == 0, "with witnesses");
    verdict v = verdict_refuted("triangle %d of %d", 3, 7);
    CLAIM("verdict_refuted", !v.holds && v.witnesses == 0,
          "it holds, or has witnesses");
    CLAIM("verdict_refuted", strcmp(v.because, "triangle 3 of 7") == 0, "%s",
          v.because);
    for (int i = 0; i < 6; i++) {
        v = verdict_with(v, (vertex_id)(10 + i));
        int expected = i < 4 ? i + 1 : 4; /* a fifth is dropped */
        CLAIM("verdict_with", v.witnesses == expected, "%d witnesses", v.witnesses);
    }
    for (int i = 0; i < 4; i++)
        CLAIM("verdict_with", v.witness[i] == (vertex_id)(10 + i), "witness %d", i);
}

/* Sentences of every length up to and beyond the room there is. */
static void
a_long_sentence_is_cut(void)
{
    char text[400];
    for (size_t length = 0; length < sizeof text; length++) {
        memset(text, 'x', length);
        text[length] = '\0';
        verdict v = verdict_refuted("%s", text);
        size_t room = sizeof v.because - 1, kept = strlen(v.because);
        CLAIM("verdict_refuted", kept == (length < room ? length : room),
              "%zu characters of %zu", kept, length);
    }
}

static void
each_status_has_its_own_sentence(void)
{
    for (int s = TRI_OK; s <= TRI_CANNOT_WRITE; s++) {
        const char *text = tri_status_text((tri_status)s);
        CLAIM("tri_status_text", strlen(text) > 5 && text[strlen(text) - 1] != '.',
              "status %d: \"%s\"", s, text);
        for (int other = TRI_OK; other < s; other++)
            CLAIM("tri_status_text",
                  strcmp(text, tri_status_text((tri_status)other)) != 0,
                  "%d and %d say the same", s, other);
    }
    CLAIM("tri_status_text", tri_status_text((tri_status)99) != NULL, "99 has none");
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "lib/verdict and lib/status: sentences for people");
    test_run("sentences and witnesses are kept", sentences_and_witnesses_are_kept);
    test_run("a long sentence is cut", a_long_sentence_is_cut);
    test_run("each status has its own sentence", each_status_has_its_own_sentence);
    return test_end((test_minima){.trials = 3});
}
