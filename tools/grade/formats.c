/* formats.c - a result as files that other systems read.
 *
 *   gradescope   results.json, named as Gradescope's autograder specification does
 *   classroom50  result.json, schema classroom50/result/v1
 *   junit        junit.xml, which most systems for continuous integration show
 *   tap          result.tap, the Test Anything Protocol
 *   text         result.txt, for people
 *
 * The same submission gives the same bytes: no times, no names of folders.
 */
#include "tools/grade/grade.h"

#include "lib/output.h"
#include "tools/grade/clean.h"
#include "tools/handout/basics.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char fault_text[] =
    "The grader itself has failed. This is not the fault of the submission, and no "
    "score has been given.";

/* "2.3-b sees" */
static const char *
name_of(const graded_property *p)
{
    return format("%s %s", p->of->exercise, p->name);
}

/* ---- Gradescope. ---- */

static void
json_field(FILE *file, const char *before, const char *key, const char *value)
{
    fprintf(file, "%s\"%s\": ", before, key);
    print_json(file, value);
}

static void
gradescope_test(FILE *file, const graded_property *p, const mark *m, size_t number)
{
    fprintf(file, "    {\n      \"name\": ");
    print_json(file, format("%s: %s", name_of(p), p->of->title));
    fprintf(file, ",\n      \"number\": \"%zu\",\n", number);
    fprintf(file, "      \"score\": %d,\n", mark_earned(m) ? p->points : 0);
    /* What may exceed the total is a bonus: its own maximum is 0. */
    fprintf(file, "      \"max_score\": %d,\n", p->of->bonus ? 0 : p->points);
    fprintf(file, "      \"status\": \"%s\",\n", mark_earned(m) ? "passed" : "failed");
    json_field(file, "      ", "output", mark_earned(m) ? m->sentence : m->text);
    fprintf(file, ",\n      \"output_format\": \"text\",\n");
    fprintf(file, "      \"visibility\": \"visible\",\n      \"tags\": [");
    print_json(file, p->of->exercise);
    json_field(file, "],\n      \"extra_data\": {", "property", p->name);
    json_field(file, ", ", "result", m->word);
    fprintf(file, "}\n    }");
}

/* With a fault there is neither a score nor a test: Gradescope says that the autograder
 * has failed, and a person looks. */
static void
write_gradescope(FILE *file, const grading *g, const result *r)
{
    const assignment *a = &g->asked;
    json_field(file, "{\n  ", "output", r->fault != NULL ? fault_text : r->notes);
    fprintf(file,
            ",\n  \"output_format\": \"text\",\n  \"visibility\": \"visible\",\n");
    json_field(file, "  \"extra_data\": {", "assignment", a->name);
    if (r->fault != NULL)
        json_field(file, ", ", "infra_error", r->fault);
    fprintf(file, "}");
    for (size_t p = 0; r->fault == NULL && p < a->properties; p++) {
        fprintf(file, p == 0 ? ",\n  \"tests\": [\n" : ",\n");
        gradescope_test(file, &a->property[p], &r->mark[p], p + 1);
    }
    fprintf(file, r->fault == NULL ? "\n  ]\n}\n" : "\n}\n");
}

/* ---- Classroom 50. ---- */

/* What the runner tells by its environment, and checks. */
static const char *
told(const char *name, const char *otherwise)
{
    const char *value = getenv(name);
    return value != NULL && *value != '\0' ? clean(value, strlen(value), 500)
                                           : otherwise;
}

/* The instant of the submission, which its tag says: submit/2026-06-01T14-32-05Z-...
 * becomes 2026-06-01T14:32:05Z. NULL if it is another tag. */
static const char *
instant_of(const char *tag)
{
    static const char form[] = "dddd-dd-ddTdd-dd-ddZ";
    const char *slash = strchr(tag, '/'), *text = slash != NULL ? slash + 1 : tag;
    for (size_t i = 0; i < sizeof form - 1; i++) /* a shorter text differs at its end */
        if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i])
            return NULL;
    char *instant = part_of(text, sizeof form - 1);
    instant[13] = instant[16] = ':';
    return instant;
}

static void
write_classroom50(FILE *file, const grading *g, const result *r)
{
    const assignment *a = &g->asked;
    int most = 0;
    json_field(file, "{\n  ", "schema", "classroom50/result/v1");
    json_field(file, ",\n  ", "classroom", told("CLASSROOM", "none"));
    json_field(file, ",\n  ", "assignment", told("ASSIGNMENT", a->name));
    json_field(file, ",\n  ", "submission", told("SUBMISSION_TAG", r->name));
    json_field(file, ",\n  ", "commit", told("COMMIT_URL", "none"));
    json_field(file, ",\n  ", "release", told("RELEASE_URL", "none"));
    json_field(file, ",\n  ", "review", told("REVIEW_URL", told("COMMIT_URL", "none")));
    if (instant_of(told("SUBMISSION_TAG", "")) != NULL)
        json_field(file, ",\n  ", "datetime", instant_of(told("SUBMISSION_TAG", "")));
    for (size_t p = 0; p < a->properties; p++)
        most += a->property[p].points;
    fprintf(file, ",\n  \"score\": %d,\n  \"max-score\": %d,\n  \"tests\": [\n",
            result_score(a, r), most);
    for (size_t p = 0; p < a->properties; p++) {
        const mark *m = &r->mark[p];
        json_field(file, "    {", "test-name", name_of(&a->property[p]));
        fprintf(file, ", \"passed\": %s, \"score\": %d, \"max-score\": %d, ",
                mark_earned(m) ? "true" : "false",
                mark_earned(m) ? a->property[p].points : 0, a->property[p].points);
        json_field(file, "", "result", m->word);
        json_field(file, ", ", "output", mark_earned(m) ? m->sentence : m->text);
        fprintf(file, p + 1 < a->properties ? "},\n" : "}\n");
    }
    fprintf(file, "  ]\n}\n");
}

/* ---- JUnit. ---- */

static void
xml_attribute(FILE *file, const char *name, const char *value)
{
    fprintf(file, " %s=\"", name);
    print_xml(file, value);
    putc('"', file);
}

static void
write_junit(FILE *file, const grading *g, const result *r)
{
    const assignment *a = &g->asked;
    size_t failures = 0;
    for (size_t p = 0; p < a->properties; p++)
        failures += !mark_earned(&r->mark[p]);
    fprintf(file,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite");
    xml_attribute(file, "name", format("%s %s", a->name, r->name));
    fprintf(file, " tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"0\">\n",
            a->properties, r->fault != NULL ? 0 : failures,
            r->fault != NULL ? a->properties : 0);
    for (size_t p = 0; p < a->properties; p++) {
        const mark *m = &r->mark[p];
        fprintf(file, "    <testcase");
        xml_attribute(file, "classname", a->property[p].of->exercise);
        xml_attribute(file, "name", a->property[p].name);
        const char *tag = r->fault != NULL ? "error" : "failure";
        if (r->fault == NULL && mark_earned(m)) {
            fprintf(file, "/>\n");
            continue;
        }
        fprintf(file, ">\n      <%s", tag);
        xml_attribute(file, "type", r->fault != NULL ? "infra_error" : m->word);
        xml_attribute(file, "message", r->fault != NULL ? fault_text : m->sentence);
        fprintf(file, ">");
        print_xml(file, r->fault != NULL ? r->fault : m->text);
        fprintf(file, "</%s>\n    </testcase>\n", tag);
    }
    fprintf(file, "  </testsuite>\n</testsuites>\n");
}

/* ---- TAP, and text. ---- */

/* Each line of the text, behind a prefix. */
static void
print_lines(FILE *file, const char *prefix, const char *text)
{
    while (*text != '\0') {
        size_t length = strcspn(text, "\n");
        fprintf(file, "%s%.*s\n", prefix, (int)length, text);
        text += length + (text[length] == '\n');
    }
}

static void
write_tap(FILE *file, const grading *g, const result *r)
{
    const assignment *a = &g->asked;
    fprintf(file, "TAP version 13\n1..%zu\n", a->properties);
    if (r->fault != NULL) {
        fprintf(file, "Bail out! %s\n", fault_text);
        return;
    }
    for (size_t p = 0; p < a->properties; p++) {
        const mark *m = &r->mark[p];
        fprintf(file, "%s %zu - %s\n", mark_earned(m) ? "ok" : "not ok", p + 1,
                name_of(&a->property[p]));
        if (!mark_earned(m))
            print_lines(file, "# ", m->text);
    }
}

static void
write_text(FILE *file, const grading *g, const result *r)
{
    const assignment *a = &g->asked;
    if (r->fault != NULL) {
        fprintf(file, "%s: %s\n  %s\n", r->name, fault_text, r->fault);
        return;
    }
    fprintf(file, "%s: %d of %d points\n", r->name, result_score(a, r), a->total);
    print_lines(file, "  ", r->notes);
    for (size_t p = 0; p < a->properties; p++) {
        const mark *m = &r->mark[p];
        fprintf(file, "  %d/%d%s  %-22s %-10s %s\n",
                mark_earned(m) ? a->property[p].points : 0, a->property[p].points,
                a->property[p].of->bonus ? " (bonus)" : "", name_of(&a->property[p]),
                m->word, m->sentence);
    }
    const char *last = "";
    for (size_t p = 0; p < a->properties; p++) {
        const mark *m = &r->mark[p];
        bool more = strcmp(m->text, m->sentence) != 0 && strcmp(m->text, last) != 0;
        if (mark_earned(m) || !more)
            continue;
        putc('\n', file);
        print_lines(file, "  ", last = m->text);
        if (m->picture != NULL)
            fprintf(file, "    picture: %s\n", m->picture);
    }
}

static const struct {
    const char *name, *file;
    void (*write)(FILE *file, const grading *g, const result *r);
} formats[] = {
    {"gradescope", "results.json", write_gradescope},
    {"classroom50", "result.json", write_classroom50},
    {"junit", "junit.xml", write_junit},
    {"tap", "result.tap", write_tap},
    {"text", "result.txt", write_text},
};
enum { FORMATS = sizeof formats / sizeof formats[0] };

const char *
formats_check(const char *list)
{
    const char *word;
    while ((word = next_word(&list)) != NULL) {
        bool known = false;
        for (size_t i = 0; i < FORMATS; i++)
            known |= strcmp(word, formats[i].name) == 0;
        if (!known)
            return word;
    }
    return NULL;
}

void
formats_write(const grading *g, const result *r, const char *folder)
{
    make_folder(folder);
    for (size_t i = 0; i < FORMATS; i++) {
        output o;
        const char *path = format("%s/%s", folder, formats[i].file);
        if (!has_word(g->formats, formats[i].name, strlen(formats[i].name)))
            continue;
        if (output_begin(&o, path) != TRI_OK)
            give_up(path);
        formats[i].write(o.file, g, r);
        if (output_commit(&o) != TRI_OK)
            give_up(path);
    }
}
