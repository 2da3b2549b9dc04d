/* clean.c - texts of strangers, made fit to be printed. */
#include "tools/grade/clean.h"

#include "tools/handout/basics.h"

#include <stdint.h>
#include <string.h>

/* How many bytes the control sequence has that begins with ESC at s[0]. */
static size_t
sequence_length(const unsigned char *s, size_t left)
{
    size_t i = 2;
    if (left < 2)
        return left;
    if (s[1] == '[') { /* parameters, then one letter */
        while (i < left && s[i] >= 0x20 && s[i] < 0x40)
            i++;
        return i < left ? i + 1 : left;
    }
    if (s[1] == ']' || s[1] == 'P' || s[1] == '_' || s[1] == '^' || s[1] == 'X') {
        while (i < left && s[i] != 7 && s[i] != 27) /* a text, up to BEL or ESC \ */
            i++;
        if (i == left || s[i] == 7)
            return i < left ? i + 1 : left;
        return i + 1 < left ? i + 2 : left;
    }
    return 2;
}

/* The character at s[0] and its number of bytes; 0 bytes: it is no UTF-8. */
static size_t
decode(const unsigned char *s, size_t left, uint32_t *character)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t length = s[0] < 0x80   ? 1
                    : s[0] < 0xC2 ? 0
                    : s[0] < 0xE0 ? 2
                    : s[0] < 0xF0 ? 3
                    : s[0] < 0xF5 ? 4
                                  : 0;
    if (length == 0 || length > left)
        return 0;
    *character = length == 1 ? s[0] : s[0] & (0x7Fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((s[i] & 0xC0) != 0x80)
            return 0;
        *character = *character << 6 | (s[i] & 0x3Fu);
    }
    if (*character < least[length] || *character > 0x10FFFF)
        return 0;
    return length;
}

/* Surrogates and the last two of a plane are no characters, in XML least of all. */
static bool
is_character(uint32_t c)
{
    return !(c >= 0xD800 && c <= 0xDFFF) && (c & 0xFFFE) != 0xFFFE;
}

/* Control characters; those without width; those that turn the direction. */
static bool
is_unseen(uint32_t c)
{
    return (c < 0x20 && c != '\n' && c != '\t') || (c >= 0x7F && c < 0xA0) ||
           c == 0xAD || (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
           (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
           (c >= 0xE0000 && c <= 0xE007F);
}

char *
clean(const char *bytes, size_t size, size_t most)
{
    const unsigned char *s = (const unsigned char *)bytes;
    char *text = take(2 * most + 32);
    size_t length = 0;
    for (size_t i = 0; i < size;) {
        uint32_t c = 0;
        size_t n = decode(s + i, size - i, &c);
        if (length >= most)
            return strcpy(text + length, "\n[...]") - length;
        if (s[i] == 27) {
            i += sequence_length(s + i, size - i);
            continue;
        }
        if (n == 0 || !is_character(c)) {
            text[length++] = '?';
            i += n > 0 ? n : 1;
            continue;
        }
        if (!is_unseen(c)) {
            memcpy(text + length, bytes + i, n);
            length += n;
        }
        i += n;
    }
    return text;
}

/* A character beyond ASCII, by its number, or by two of them: so the file is the same
 * in every encoding. Returns how many bytes it has. */
static size_t
print_escaped(FILE *file, const char *at)
{
    uint32_t c = '?';
    size_t length = decode((const unsigned char *)at, strlen(at), &c);
    if (c >= 0x10000)
        fprintf(file, "\\u%04x\\u%04x", (unsigned)(0xD800 + ((c - 0x10000) >> 10)),
                (unsigned)(0xDC00 + (c & 0x3FF)));
    else
        fprintf(file, "\\u%04x", (unsigned)c);
    return length > 0 ? length : 1;
}

void
print_json(FILE *file, const char *text)
{
    putc('"', file);
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if (*c == '\n')
            fputs("\\n", file);
        else if ((unsigned char)*c < 0x20 || *c == '<' || *c == '>' || *c == '&')
            fprintf(file, "\\u%04x", (unsigned)(unsigned char)*c);
        else if ((unsigned char)*c < 0x80)
            putc(*c, file);
        else
            c += print_escaped(file, c) - 1;
    putc('"', file);
}

void
print_xml(FILE *file, const char *text)
{
    for (const char *c = text; *c != '\0'; c++)
        switch (*c) {
        case '&': fputs("&amp;", file); break;
        case '<': fputs("&lt;", file); break;
        case '>': fputs("&gt;", file); break;
        case '"': fputs("&quot;", file); break;
        case '\n': fputs("&#10;", file); break;
        case '\t': fputs("&#9;", file); break;
        default: putc(*c, file);
        }
}

void
print_csv(FILE *file, const char *text)
{
    putc('"', file);
    if (*text != '\0' && strchr("=+-@\t", *text) != NULL)
        putc('\'', file);
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"')
            putc('"', file);
        putc(*c == '\n' ? ' ' : *c, file);
    }
    putc('"', file);
}
