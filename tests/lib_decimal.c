/* lib/decimal: a double that is written reads back as the same, and what is read is
 * the double nearest to the decimal, whatever the locale.
 *
 * Hypotheses: what is written is finite. Reference: the C library's strtod.
 */
#include "lib/decimal.h"
#include "tests/harness/harness.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool
same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

static double
random_double(void)
{
    for (;;) {
        uint64_t bits = random_bits(test_random_source());
        double x;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x))
            return x;
    }
}

static void
check_double(double x)
{
    char text[DECIMAL_ROOM];
    double back = 0;
    int length = decimal_write(text, x);
    decimal_result result = decimal_read(text, (size_t)length, &back);
    CLAIM("decimal.round_trip", result == DECIMAL_NUMBER && same_bits(back, x),
          "%a is written as %s, which reads as %a", x, text, back);
    CLAIM("decimal.nearest", same_bits(back, strtod(text, NULL)),
          "%s reads as %a, not as %a", text, back, strtod(text, NULL));

    char shorter[64];
    snprintf(shorter, sizeof shorter, "%.15g", x);
    bool whole = x == floor(x) && fabs(x) < 0x1p53;
    if (!whole && strtod(shorter, NULL) == x)
        CLAIM("decimal.shortest", strlen(text) <= strlen(shorter),
              "%a is written as %s, and %s would do", x, text, shorter);
}

static void
doubles_survive(void)
{
    const double special[] = {0.0, -0.0, 0x1p-1074, 0x1.fffffffffffffp-1023,
                              0x1p-1022, 0x1.fffffffffffffp+1023, 0x1p53,
                              0x1p53 + 2, 1e15, 1e16, 1e22, 1e23, 0.1, 1.0 / 3, -1,
                              9007199254740993.0, 5e-324, 123456789012345680.0};
    for (size_t i = 0; i < sizeof special / sizeof special[0]; i++) {
        check_double(special[i]);
        check_double(-special[i]);
    }
    for (int i = 0; i < 100000; i++)
        check_double(random_double());
}

/* A number as a person or another program might write it, with up to 900 digits. */
static void
write_some_number(char *text)
{
    random_source *source = test_random_source();
    uint32_t longest = random_below(source, 10) == 0 ? 900 : 24;
    uint32_t before = random_below(source, longest), point = 0;
    uint32_t after = random_below(source, longest) + (before == 0);
    if (random_below(source, 2) == 0)
        *text++ = "+-"[random_below(source, 2)];
    for (uint32_t i = 0; i < before + after; i++) {
        if (i == before && ++point == 1)
            *text++ = '.';
        *text++ = random_below(source, 3) == 0
                      ? '0' : (char)('0' + random_below(source, 10));
    }
    *text = '\0';
    if (random_below(source, 2) == 0)
        sprintf(text, "%c%d", "eE"[random_below(source, 2)],
                (int)random_below(source, 700) - 350);
}

static void
check_reading(const char *text)
{
    double ours = 0, theirs = strtod(text, NULL);
    decimal_result result = decimal_read(text, strlen(text), &ours);
    if (isinf(theirs))
        CLAIM("decimal.overflow", result == DECIMAL_TOO_LARGE, "%s is read", text);
    else
        CLAIM("decimal.nearest", result == DECIMAL_NUMBER && same_bits(ours, theirs),
              "%s reads as %a, not as %a", text, ours, theirs);
}

/* The digits of text, a whole number, times `by`. */
static void
multiply(char *text, int by)
{
    size_t length = strlen(text);
    int carry = 0;
    for (size_t i = length; i-- > 0;) {
        int product = (text[i] - '0') * by + carry;
        text[i] = (char)('0' + product % 10);
        carry = product / 10;
    }
    if (carry > 0) {
        memmove(text + 1, text, length + 1);
        text[0] = (char)('0' + carry);
    }
}

/* odd * 2^k in full: for k < 0 it is odd * 5^-k / 10^-k. */
static void
write_binary(char *text, uint64_t odd, int k)
{
    sprintf(text, "%llu", (unsigned long long)odd);
    for (int i = 0; i < abs(k); i++)
        multiply(text, k < 0 ? 5 : 2);
    sprintf(text + strlen(text), "e%d", k < 0 ? k : 0);
}

/* The places halfway between two doubles, and just above them, are the hard ones:
 * 54 bits, and all of their digits count, and a digit far behind them too. */
static void
decimals_are_rounded_once(void)
{
    char text[2000];
    for (int i = 0; i < 100000; i++) {
        write_some_number(text);
        check_reading(text);
    }
    /* Where the exact short cuts end: at 2^53 and at 10^22. */
    for (uint64_t whole = (UINT64_C(1) << 53) - 8; whole >> 3 <= UINT64_C(1) << 50;
         whole++)
        for (int e = -25; e <= 25; e++) {
            sprintf(text, "%llue%d", (unsigned long long)whole, e);
            check_reading(text);
        }
    for (int i = 0; i < 500; i++) {
        uint64_t odd = random_bits(test_random_source()) >> 11 | 1;
        odd |= UINT64_C(1) << 53;
        int k = (int)random_below(test_random_source(), 1990) - 1073 - 53;
        write_binary(text, odd, k);
        check_reading(text);
        size_t digits = strspn(text, "0123456789");
        sprintf(text + digits, "%0500de%d", 1, (k < 0 ? k : 0) - 500);
        check_reading(text);
        if (k < -1073)
            continue;
        /* Two doubles with an even and an odd last bit: the tie went to even. */
        double above = 0, tie = 0;
        decimal_read(text, strlen(text), &above);
        write_binary(text, odd, k);
        decimal_read(text, strlen(text), &tie);
        bool up = (odd >> 1 & 1) != 0;
        CLAIM("decimal.nearest", up ? tie == above : tie < above,
              "the tie %.40s... is rounded to %a, what is above it to %a",
              text, tie, above);
    }
}

static void
no_decimals(void)
{
    const char *const text[] = {
        "", "+", "-", ".", "+.", "e5", ".e5", "1e", "1e+", "1e-", "1e5.", "1.2.3",
        "--1", "+-1", "1 ", " 1", "1,5", "nan", "inf", "-inf", "infinity", "0x1",
        "1f", "1e5x", "1_000", "\xd9\xa1"};
    for (size_t i = 0; i < sizeof text / sizeof text[0]; i++) {
        double value;
        decimal_result result = decimal_read(text[i], strlen(text[i]), &value);
        CLAIM("decimal.no_number", result == DECIMAL_NO_NUMBER,
              "\"%s\" is read as a number", text[i]);
    }
}

static void
check_integer(uint64_t value)
{
    char ours[DECIMAL_ROOM], theirs[DECIMAL_ROOM];
    int length = decimal_write_integer(ours, value);
    sprintf(theirs, "%llu", (unsigned long long)value);
    CLAIM("decimal.integer", strcmp(ours, theirs) == 0 &&
          length == (int)strlen(theirs), "%s is written as %.*s", theirs, length, ours);
}

/* All short ones, those around each power of ten, and some of each length. */
static void
integers_are_written_in_full(void)
{
    for (uint64_t value = 0; value < 11000; value++)
        check_integer(value);
    uint64_t power = 1;
    for (int digits = 1; digits <= 20; digits++, power *= 10) {
        check_integer(power - 1);
        check_integer(power);
        check_integer(power + 1);
    }
    check_integer(UINT64_MAX);
    for (int i = 0; i < 10000; i++)
        check_integer(random_bits(test_random_source()) >> i % 64);
}

static const char *program_path; /* argv[0]: beside it is room for files */

/* Sets the locale, if it is there and has a decimal comma. */
static bool
set_locale(const char *name)
{
    char text[8];
    if (setlocale(LC_ALL, name) != NULL) {
        snprintf(text, sizeof text, "%.1f", 1.5);
        if (strcmp(text, "1,5") == 0)
            return true;
    }
    setlocale(LC_ALL, "C");
    return false;
}

/* A locale with a decimal comma: made for the occasion where localedef (of the C
 * library) can make one, as machines need not have any installed; else one of
 * theirs. */
static bool
set_comma_locale(const char *folder)
{
    char command[1000];
    snprintf(command, sizeof command,
             "cd %s && printf 'LC_NUMERIC\\ndecimal_point \",\"\\nthousands_sep "
             "\"\"\\ngrouping -1\\nEND LC_NUMERIC\\n' > comma.src && "
             "localedef -c --no-archive -i comma.src ./comma >/dev/null 2>&1",
             folder);
    int made = system(command); /* warns of the categories left out: status 1 */
    setenv("LOCPATH", folder, 1);
    bool set = made != -1 && set_locale("comma");
    unsetenv("LOCPATH");
    set = set || set_locale("de_DE.UTF-8") || set_locale("fr_FR.UTF-8");
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command) == 0 && set;
}

static void
locale_does_not_matter(void)
{
    char folder[400], text[DECIMAL_ROOM];
    snprintf(folder, sizeof folder, "%s.XXXXXX", program_path);
    if (mkdtemp(folder) == NULL || !set_comma_locale(folder))
        puts("# no locale here has a comma: only C is tried");
    double value = 0;
    for (int i = 0; i < 1000; i++) {
        double x = random_double();
        int length = decimal_write(text, x);
        CLAIM("decimal.locale", strchr(text, ',') == NULL, "%s is written", text);
        decimal_result result = decimal_read(text, (size_t)length, &value);
        CLAIM("decimal.locale", result == DECIMAL_NUMBER && same_bits(value, x),
              "%a is written as %s, which reads as %a", x, text, value);
    }
    CLAIM("decimal.locale", decimal_read("1,5", 3, &value) == DECIMAL_NO_NUMBER,
          "1,5 is read as %g", value);
    setlocale(LC_ALL, "C");
}

int
main(int argc, char **argv)
{
    program_path = argv[0];
    test_begin(argc, argv, "lib/decimal: doubles survive being written and read");
    test_run("doubles survive", doubles_survive);
    test_run("decimals are rounded once", decimals_are_rounded_once);
    test_run("integers are written in full", integers_are_written_in_full);
    test_run("what is no decimal", no_decimals);
    test_run("the locale does not matter", locale_does_not_matter);
    return test_end((test_minima){.trials = 5});
}
