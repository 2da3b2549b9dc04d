/* What `make install` puts into a folder is all that a program in C or C++ needs, and
 * `make uninstall` removes it.
 *
 * Hypotheses: a C compiler and make, as for the project. Where there is no compiler for
 * C++, C++ is not asked about; where there is no pkg-config, the flags that it would
 * give are written out.
 */
#include "tests/harness/harness.h"
#include "tests/harness/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A program in C++ that does what tools/example.c does. */
static const char in_cplusplus[] =
    "#include \"chapters/triangulations.h\"\n"
    "#include <cstdio>\n"
    "#include <vector>\n"
    "int main()\n"
    "{\n"
    "    std::vector<point2> points{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}};\n"
    "    tri_options options = tri_options_default();\n"
    "    mesh m;\n"
    "    triangle_list t;\n"
    "    if (orient2d(points[0], points[1], points[2]) != 1 ||\n"
    "        lawson_triangulate(points.data(), 5, &options, &m) != TRI_OK ||\n"
    "        mesh_triangles(&m, &t) != TRI_OK)\n"
    "        return 1;\n"
    "    for (uint32_t i = 0; i < t.count; i++)\n"
    "        std::printf(\"%u %u %u\\n\", t.corner[i][0], t.corner[i][1],\n"
    "                    t.corner[i][2]);\n"
    "    triangle_list_free(&t);\n"
    "    mesh_free(&m);\n"
    "}\n";

#define PREFIX "/opt/tri"
#define INSTALLED "$d/stage" PREFIX

/* Runs a make of this project, quietly. */
static void
run_make(const char *target)
{
    int status = shell("${MAKE-make} BUILD=\"$build\" DESTDIR=$d/stage PREFIX=" PREFIX
                       " %s >$d/out 2>$d/err", target);
    CLAIM("install.make", status == 0, "make %s: exit status %d: %s", target, status,
          read_scratch("err").text);
}

/* Compiles source with the flags for installed programs and runs it, in a folder far
 * from the project; its triangles are a Delaunay triangulation of the five points. */
static void
compile_and_run(const char *compiler, const char *source)
{
    int status = shell(
        "cd $d && if command -v pkg-config >/dev/null 2>&1; then "
        "  flags=$(PKG_CONFIG_PATH=" INSTALLED "/lib/pkgconfig pkg-config "
        "    --define-variable=prefix=" INSTALLED " --cflags --libs triangulations); "
        "else "
        "  flags=\"-I" INSTALLED "/include/triangulations -L" INSTALLED "/lib "
        "    -ltri -lm -pthread\"; "
        "fi && %s -Wall -Wextra -Wpedantic -Wshadow -Werror ${CFLAGS-} %s $flags "
        "-o program 2>err", compiler, source);
    CLAIM("install.compiles", status == 0, "%s: %s", source, read_scratch("err").text);
    status = shell("cd $d && ./program >triangles && "
                   "printf '0 0\\n4 0\\n4 3\\n0 3\\n1 1\\n' >five.xy && "
                   "awk '{ print NR, $0 } END { print NR, 3 >\"head\" }' triangles "
                   "  >tail && cat head tail >five.ele && "
                   INSTALLED "/bin/tri check --delaunay five.xy five.ele >out");
    CLAIM("install.runs", status == 0 && has("head", "4 3\n"), "%s prints: %s%s",
          source, read_scratch("triangles").text, read_scratch("out").text);
}

static void
programs_in_c_find_everything(void)
{
    run_make("install");
    CLAIM("install.places", shell("find $d/stage -type f | grep -v '^'" INSTALLED "/ "
                                  ">$d/out") == 1, "outside of the prefix: %s",
          read_scratch("out").text);
    CLAIM("install.places", shell("grep -q stage " INSTALLED "/lib/pkgconfig/*") == 1,
          "the folder for packing has got into the file for pkg-config");
    shell("cp tools/example.c $d/example.c");
    compile_and_run("${CC-cc} -std=c11", "example.c");
    int status = shell(INSTALLED "/bin/tri --version >$d/out && "
                       "grep -q \"^Version: $(cut -d ' ' -f 2 $d/out)\\$\" "
                       INSTALLED "/lib/pkgconfig/triangulations.pc");
    CLAIM("install.version", status == 0, "it is not that of %s",
          read_scratch("out").text);
}

/* Every header can be the first and only one. */
static void
headers_stand_alone(void)
{
    run_make("install");
    int status = shell(
        "cd " INSTALLED "/include/triangulations && "
        "for h in $(find . -name '*.h'); do "
        "  echo \"#include \\\"$h\\\"\" >$d/one.c && echo 'int x;' >>$d/one.c && "
        "  ${CC-cc} -std=c11 -Wall -Wextra -Wpedantic -Werror -I. -c $d/one.c "
        "    -o $d/one.o 2>$d/err || { echo $h >$d/out; exit 9; }; "
        "  echo $h >>$d/headers; "
        "done; test $(wc -l <$d/headers) -ge 20");
    CLAIM("install.headers", status == 0, "%s%s", status == 9 ? read_scratch("out").text
          : "headers are missing", read_scratch("err").text);
}

static void
programs_in_cplusplus_find_everything(void)
{
    run_make("install");
    FILE *file = fopen(in_scratch("plus.cc").text, "w");
    CLAIM("install.compiles", file != NULL && fputs(in_cplusplus, file) >= 0 &&
          fclose(file) == 0, "plus.cc cannot be written");
    compile_and_run("$cplusplus -std=c++17", "plus.cc");
}

static void
nothing_is_left_after_uninstall(void)
{
    run_make("install");
    CLAIM("install.uninstall", shell("test -x " INSTALLED "/bin/tri") == 0, "no tri");
    run_make("uninstall");
    CLAIM("install.uninstall", shell("test -z \"$(find $d/stage -type f)\"") == 0,
          "files are left");
}

int
main(int argc, char **argv)
{
    shell_begin(argv);
    test_begin(argc, argv, "what make install installs is complete");
    test_run("programs in C find everything", programs_in_c_find_everything);
    test_run("headers stand alone", headers_stand_alone);
    /* The compiler for C++ that belongs to the one for C: sanitizers must match. */
    const char *cc = getenv("CC");
    bool clang = cc != NULL && strstr(cc, "clang") != NULL;
    setenv("cplusplus", clang ? "clang++" : "g++", 1);
    if (shell("command -v $cplusplus >/dev/null") == 0)
        test_run("programs in C++ find everything",
                 programs_in_cplusplus_find_everything);
    else
        puts("# skipped: there is no compiler for C++");
    test_run("nothing is left after uninstall", nothing_is_left_after_uninstall);
    int status = test_end((test_minima){.trials = 3});
    shell_end();
    return status;
}
