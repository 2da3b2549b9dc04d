/* address.h - where a name stands in a source.
 *
 * A name is a function, a struct, an enum or a macro that begins at column 0:
 *
 *   function       from its return type to the first } at column 0
 *   prototype      in a header only: with its contract, the comment just above
 *   struct, enum   from its first line to the first } at column 0
 *   macro          to its last continued line
 *
 * A label is a comment `// Line 5 ...` or `// Step 5 ...` inside it, at the end of a
 * line or on its own. It reaches to the next label that is not indented further, or to
 * the end of its block.
 */
#ifndef TOOLS_WEAVE_ADDRESS_H
#define TOOLS_WEAVE_ADDRESS_H

#include "tools/weave/text.h"

typedef struct address {
    char path[256];
    char name[128];  /* empty: the whole file */
    char label[128]; /* empty: all of what is named */
} address;

/* Finds the lines at the address in the text of its file. Otherwise complains about
 * the given line of the page, where the address was read, and returns false. */
bool address_find(const text *source, const address *a, const char *page, size_t line,
                  range *out);

#endif
