/* weave.c - keeps what the pages say about the sources true.
 *
 *     weave           writes the quoted code into the pages again
 *     weave --check   changes nothing and fails where a page would change
 *     weave --list    the same, and prints a line for each quote: PAGE FILE FIRST LAST
 *
 * Run it in the root of the project. The pages are README.md, docs/, and the
 * README.md of each chapter. A page quotes code by its address:
 *
 *     <!-- code: chapters/2.3_line_sweep/sweep.c attach "Line 5" -->
 *     ```c
 *     (filled in from the source)
 *     ```
 *
 * The name is a function, a struct, an enum or a macro that begins at column 0 of
 * the file; the label, if any, is a comment inside it; without a name the whole
 * file is quoted. No mark is needed in the source, and a block of C without an
 * address is refused: what a student reads is what the compiler reads.
 *
 * --check also follows the references of the pages: each link, each picture, and
 * each `path` or `path name` between backquotes must lead somewhere, except in rows
 * of tables that say `planned`.
 *
 * Exit status: 0 all is true; 1 something is not, and standard error says where, what
 * and what to do; 2 the program cannot run.
 */
#include "tools/weave/address.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

typedef enum mode { REFRESH, CHECK, LIST, USAGE } mode;

/* ---- Quotes. ---- */

/* Writes the lines without the indentation of the first one. */
static void
write_lines(FILE *out, const text *from, range r)
{
    size_t margin = r.first < r.end ? indentation(from->line[r.first]) : 0;
    for (size_t i = r.first; i < r.end; i++) {
        size_t own = indentation(from->line[i]);
        fprintf(out, "%s\n", from->line[i] + (own < margin ? own : margin));
    }
}

/* Reads <!-- code: PATH [NAME ["LABEL"]] -->. */
static bool
parse_address(const char *line, address *a)
{
    *a = (address){.path = ""};
    int fields = sscanf(line, "<!-- code: %255s %127s \"%127[^\"]\"", a->path, a->name,
                        a->label);
    if (strcmp(a->name, "-->") == 0)
        a->name[0] = '\0';
    return fields >= 2 && ends_with(line, " -->");
}

/* Writes the quote whose address is line i of the page; when it cannot be found, the
 * old one. Returns the line of the page after it. */
static size_t
weave_quote(const char *path, const text *page, size_t i, mode what, FILE *out)
{
    address a;
    size_t close = i + 2;
    while (close < page->lines && strcmp(page->line[close], "```") != 0)
        close++;
    if (close >= page->lines || strcmp(page->line[i + 1], "```c") != 0) {
        complain(path, i, "put a line ```c and a line ``` after this one");
        return i + 1;
    }
    text source = {0};
    range quote = {0, 0};
    bool found = false;
    if (!parse_address(page->line[i], &a))
        complain(path, i, "write <!-- code: FILE NAME \"LABEL\" -->");
    else if (!text_read(&source, a.path))
        complain(path, i, "there is no file %s; correct the path", a.path);
    else
        found = address_find(&source, &a, path, i, &quote);

    fputs("```c\n", out);
    if (found)
        write_lines(out, &source, quote);
    else
        write_lines(out, page, (range){i + 2, close});
    fputs("```\n", out);
    if (found && what == LIST)
        printf("%s %s %zu %zu\n", path, a.path, quote.first + 1, quote.end);
    text_free(&source);
    return close + 1;
}

/* ---- References. ---- */

static bool
exists(const char *path)
{
    struct stat unused;
    return stat(path, &unused) == 0;
}

/* A span between backquotes: when it begins with a folder of the project, it must
 * be a file, or a file and a name in it. Patterns such as lib/ *.c are let pass. */
static void
check_span(const char *page, size_t line, const char *span, size_t length)
{
    static const char *const top[] = {"chapters/", "lib/", "tests/", "tools/", "docs/"};
    address a = {.path = ""};
    char copy[sizeof a.path + sizeof a.name];
    bool ours = false;
    for (size_t k = 0; k < sizeof top / sizeof *top; k++)
        ours |= begins_with(span, top[k]);
    if (!ours || length >= sizeof copy)
        return;
    memcpy(copy, span, length);
    copy[length] = '\0';
    if (strpbrk(copy, "*<") || strstr(copy, "NAME"))
        return;
    sscanf(copy, "%255s %127[A-Za-z0-9_]", a.path, a.name);
    text source;
    range unused;
    if (!exists(a.path))
        complain(page, line, "there is no %s; correct the path here", a.path);
    else if (a.name[0] != '\0' && text_read(&source, a.path)) {
        address_find(&source, &a, page, line, &unused);
        text_free(&source);
    }
}

/* The target of a link or picture, relative to the folder of the page. */
static void
check_link(const char *page, size_t line, const char *target, size_t length)
{
    char path[1024];
    const char *slash = strrchr(page, '/');
    int folder = slash ? (int)(slash - page + 1) : 0;
    if (memchr(target, ':', length) || length == 0 || length > 500)
        return;
    snprintf(path, sizeof path, "%.*s%.*s", folder, page, (int)length, target);
    if (!exists(path))
        complain(page, line, "there is no %s; correct the link", path);
}

/* Follows every reference in a line of prose. */
static void
check_references(const char *page, size_t i, const char *line)
{
    if (line[0] == '|' && strstr(line, "planned |"))
        return;
    for (const char *at = strchr(line, '`'); at; at = strchr(at, '`')) {
        size_t length = strcspn(++at, "`");
        check_span(page, i, at, length);
        at += length + (at[length] == '`');
    }
    for (const char *at = strstr(line, "]("); at; at = strstr(at, "]("))
        at += 2, check_link(page, i, at, strcspn(at, ")# "));
    for (const char *at = strstr(line, "src=\""); at; at = strstr(at, "src=\""))
        at += 5, check_link(page, i, at, strcspn(at, "\""));
}

/* ---- Pages. ---- */

/* The file gets its new lines in one step: a reader sees the old ones or the new. */
static void
replace_file(const char *path, const text *t)
{
    char beside[1024];
    snprintf(beside, sizeof beside, "%s.new", path);
    FILE *file = fopen(beside, "w");
    if (file == NULL)
        give_up(beside);
    for (size_t i = 0; i < t->lines; i++)
        fprintf(file, "%s\n", t->line[i]);
    bool failed = ferror(file) != 0;
    failed |= fclose(file) != 0;
    if (failed || rename(beside, path) != 0) {
        remove(beside);
        give_up(path);
    }
    printf("refreshed %s\n", path);
}

/* The first line in which the two differ, or the number of lines of both. */
static size_t
first_difference(const text *a, const text *b)
{
    size_t i = 0;
    while (i < a->lines && i < b->lines && strcmp(a->line[i], b->line[i]) == 0)
        i++;
    return i;
}

static void
weave_page(const char *path, mode what)
{
    text page, woven = {0};
    size_t size;
    FILE *out = open_memstream(&woven.bytes, &size);
    if (out == NULL || !text_read(&page, path))
        give_up(path);

    bool fenced = false; /* in a block that is no quote */
    for (size_t i = 0; i < page.lines;) {
        const char *line = page.line[i];
        fprintf(out, "%s\n", line);
        fenced ^= begins_with(line, "```");
        if (fenced && strcmp(line, "```c") == 0)
            complain(path, i,
                     "put the address of this code above it: <!-- code: ... -->");
        if (!fenced && what == CHECK)
            check_references(path, i, line);
        if (!fenced && begins_with(line, "<!-- code:"))
            i = weave_quote(path, &page, i, what, out);
        else
            i++;
    }
    if (fclose(out) != 0)
        give_up(path);

    text_split(&woven, size);
    size_t same = first_difference(&page, &woven);
    bool differs = same < page.lines || same < woven.lines;
    if (differs && what == REFRESH)
        replace_file(path, &woven);
    if (differs && what != REFRESH)
        complain(path, same, "the source says something else; run make weave");
    text_free(&page);
    text_free(&woven);
}

int
main(int argc, char **argv)
{
    mode what = argc == 1                                      ? REFRESH
                : argc == 2 && strcmp(argv[1], "--check") == 0 ? CHECK
                : argc == 2 && strcmp(argv[1], "--list") == 0  ? LIST
                                                               : USAGE;
    glob_t pages;
    if (what == USAGE || glob("README.md", 0, NULL, &pages) != 0) {
        fputs("usage, in the root of the project: weave [--check | --list]\n", stderr);
        return 2;
    }
    glob("chapters/README.md", GLOB_APPEND, NULL, &pages);
    glob("chapters/*/README.md", GLOB_APPEND, NULL, &pages);
    glob("docs/*.md", GLOB_APPEND, NULL, &pages);
    for (size_t i = 0; i < pages.gl_pathc; i++)
        weave_page(pages.gl_pathv[i], what);
    globfree(&pages);
    return complaints() > 0;
}
