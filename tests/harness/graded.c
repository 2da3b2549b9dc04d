/* graded.c - tests that hand something in and read what the grader writes. */
#include "tests/harness/graded.h"

#include "tests/harness/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

const char *
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

const json *
read_json(const char *name)
{
    const char *text = whole(name), *wrong;
    size_t length = strlen(text), at;
    char *copy = kept(malloc(length + 1));
    return copy == NULL
        ? NULL : kept(json_read(memcpy(copy, text, length + 1), length, &wrong, &at));
}

const json *
item_of(const json *array, size_t k)
{
    return array != NULL && array->kind == JSON_ARRAY && k < array->count
               ? &array->item[k]
               : NULL;
}

const char *
text_of(const json *value)
{
    return value != NULL && value->kind == JSON_STRING ? value->text : "(no text)";
}

int
number_of(const json *value)
{
    bool number = value != NULL && value->kind == JSON_NUMBER;
    return number && value->number == (int)value->number ? (int)value->number : -1;
}

bool
write_submission(const char *name, const char *line)
{
    static char text[1 << 17];
    FILE *file = fopen(SWEEP, "rb");
    size_t size = file != NULL ? fread(text, 1, sizeof text - 1, file) : 0;
    text[size] = '\0';
    if (file == NULL || fclose(file) != 0 ||
        shell("mkdir -p $d/class/%s/%s", name, SWEEP) != 0 ||
        shell("rmdir $d/class/%s/%s", name, SWEEP) != 0)
        return false;
    const char *place = strstr(text, "hull_chain q = {last, last};");
    char path[300];
    snprintf(path, sizeof path, "class/%s/%s", name, SWEEP);
    file = fopen(in_scratch(path).text, "wb");
    if (place == NULL || file == NULL)
        return false;
    fprintf(file,
            "#define _GNU_SOURCE\n#include <assert.h>\n#include <signal.h>\n"
            "#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>\n"
            "%.*s\n    hull_chain q = {last, last};\n    %s\n%s",
            (int)(place - text), text, line,
            place + strlen("hull_chain q = {last, last};"));
    return fclose(file) == 0;
}

const char *
results_of(const char *name)
{
    char path[200];
    snprintf(path, sizeof path, "graded/%s/results.json", name);
    return whole(path);
}

const json *
test_of(const char *name, size_t k)
{
    char path[200];
    snprintf(path, sizeof path, "graded/%s/results.json", name);
    return item_of(json_member(read_json(path), "tests"), k);
}

const char *
result_of(const json *test)
{
    return text_of(json_member(json_member(test, "extra_data"), "result"));
}

const char *
word_of(const char *name, size_t k)
{
    return result_of(test_of(name, k));
}

int
score_of(const char *name, size_t k)
{
    return number_of(json_member(test_of(name, k), "score"));
}

void
graded_or_end(int status)
{
    bool linked = shell("echo 'int main(void){return 0;}' >$d/a.c && "
                        "${CC-cc} -static $d/a.c -o $d/a 2>$d/static") == 0;
    if (linked && status == 0)
        return;
    if (linked)
        printf("not ok 1 - the class is graded: status %d: %s%s\n1..1\n", status,
               whole("out"), whole("err"));
    else
        printf("ok 1 - # SKIP programs cannot be linked statically\n1..1\n");
    shell_end();
    exit(linked);
}
