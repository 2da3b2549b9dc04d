/* Charts: a table of numbers is read as it stands, or refused; and what is drawn are
 * its points, on axes that show ratios.
 */
#include "lib/memory.h"
#include "lib/svg_chart.h"
#include "tests/harness/harness.h"

#include <math.h>
#include <string.h>

/* A file to read, with this text. */
static FILE *
file_of(const char *text)
{
    FILE *file = tmpfile();
    CLAIM("chart.read", file != NULL && fputs(text, file) >= 0, "no file");
    rewind(file);
    return file;
}

static tri_status
read_text(const char *text, const char *column, bool divide, chart *c)
{
    FILE *file = file_of(text);
    tri_status status = chart_read(file, column, divide, c);
    fclose(file);
    return status;
}

static const char table[] = "of,n,who,a,b\n"
                            "flat,16,one,32,5\n"
                            "flat,16,two,64,\n"
                            "steep,64,one,6400,0\r\n"
                            "steep,64,two,oops,7\n";

static void
a_table_is_read_as_it_stands(void)
{
    chart c;
    CLAIM("chart.read", read_text(table, "a", true, &c) == TRI_OK && c.count == 3,
          "%u points", c.count);
    CLAIM("chart.read", strcmp(c.point[0].panel, "flat") == 0 &&
          strcmp(c.point[1].curve, "two") == 0 && c.point[2].x == 64,
          "not the names and numbers of the table");
    CLAIM("chart.read", c.point[0].y == 2 && c.point[1].y == 4 && c.point[2].y == 100,
          "%g %g %g", c.point[0].y, c.point[1].y, c.point[2].y);
    chart_free(&c);
    CLAIM("chart.read", read_text(table, "b", false, &c) == TRI_OK && c.count == 2 &&
          c.point[0].y == 5 && c.point[1].y == 7, "%u points", c.count);
    chart_free(&c);
}

static void
other_tables_are_refused(void)
{
    chart c;
    CLAIM("chart.read", read_text(table, "c", true, &c) == TRI_BAD_FILE &&
          c.point == NULL, "there is no column c");
    CLAIM("chart.read", read_text("", "a", true, &c) == TRI_BAD_FILE, "an empty file");
    CLAIM("chart.read",
          read_text("of,n,who,a\nwith a name of twenty,1,x,1\n", "a", true, &c) ==
                  TRI_BAD_FILE &&
              c.point == NULL,
          "a name that does not fit was accepted");
    tri_status status = TRI_OUT_OF_MEMORY;
    for (unsigned long k = 1; status != TRI_OK; k++) {
        FILE *file = file_of(table);
        memory_fail_at(k);
        status = chart_read(file, "a", true, &c);
        memory_fail_at(0);
        fclose(file);
        CLAIM("chart.read", status == TRI_OK ||
              (status == TRI_OUT_OF_MEMORY && c.point == NULL), "allocation %lu", k);
    }
    chart_free(&c);
}

/* The points of a law 50 x^k are drawn along a straight line, at equal distances for
 * equal ratios: each is in the middle between those before and after it. */
static void
a_power_law_is_a_straight_line(const point2 *drawn, uint32_t n)
{
    (void)drawn;
    enum { MOST = 12 };
    double k = -1 + 2 * random_unit(test_random_source());
    uint32_t count = 3 + n % (MOST - 2), dots = 0;
    chart_point law[MOST];
    for (uint32_t i = 0; i < count; i++) {
        double x = ldexp(1, (int)i + 10);
        law[i] = (chart_point){"power", "law", SVG_PLAIN, x, 50 * pow(x, k)};
    }
    FILE *file = tmpfile();
    CLAIM("chart.axes", file != NULL, "no file");
    svg_charts(file, &(chart){law, count}, "Title", "Description.", "y");
    rewind(file);
    char line[400];
    point2 at[MOST + 1];
    while (fgets(line, sizeof line, file) != NULL && dots <= count)
        dots += sscanf(line, "<path class=\"dots plain\" d=\"M%lf %lf", &at[dots].x,
                       &at[dots].y) == 2;
    fclose(file);
    CLAIM("chart.axes", dots == count, "%u dots for %u points", dots, count);
    for (uint32_t i = 1; i + 1 < count; i++) {
        double x = at[i - 1].x + at[i + 1].x - 2 * at[i].x,
               y = at[i - 1].y + at[i + 1].y - 2 * at[i].y;
        CLAIM("chart.axes", fabs(x) < 0.05 && fabs(y) < 0.05 && at[i].x > at[i - 1].x,
              "dot %u is off by %.2f and %.2f", i, x, y);
    }
}

int
main(int argc, char **argv)
{
    test_begin(argc, argv, "charts show their tables");
    test_run("a table", a_table_is_read_as_it_stands);
    test_run("no table", other_tables_are_refused);
    test_random("a power law", a_power_law_is_a_straight_line, 100, 20);
    return test_end((test_minima){.trials = 102, .largest_n = 10});
}
