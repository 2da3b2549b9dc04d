/* unpack.c - what gzip has compressed, or a program that makes zip archives.
 *
 * gzip runs in the jail, and so does whatever a damaged archive may make of it. What it
 * writes is a file, which the jail does not let grow: a bomb ends early.
 */
#include "tools/grade/grade.h"

#include "tools/handout/basics.h"

#include <string.h>

char *
unpack(const grading *g, const char *scratch, const char *bytes, size_t size,
       size_t most, size_t *unpacked_size, const char **trouble)
{
    const char *packed = format("%s/packed", scratch),
               *work = format("%s/unpacked", scratch);
    char *said;
    remove_folder(work);
    make_folder(work);
    write_file(format("%s/a.gz", packed), bytes, size);
    command_line c = jail_compile(g, (const char *[]){packed, NULL}, work);
    command_add_words(&c, "sh -c");
    command_add(&c, "exec gzip -dc \"$0\" >\"$1\"");
    command_add(&c, format("%s/a.gz", packed));
    command_add(&c, format("%s/a", work));
    int status = run(scratch, c.word, 60, 500, &said, NULL);
    char *unpacked = read_below(work, "a", most, unpacked_size, trouble);
    if (status != 0)
        *trouble = "it is damaged, or unpacks into far too much";
    else if (unpacked == NULL && *trouble == NULL)
        *trouble = "gzip has written nothing";
    return *trouble == NULL ? unpacked : NULL;
}

/* Both formats have the same compressed bytes in the middle; gzip has ten before them,
 * and behind them the checksum and the size. */
char *
unpack_deflated(const grading *g, const char *scratch, const packed_file *f,
                size_t most, size_t *unpacked_size, const char **trouble)
{
    static const char before[10] = {0x1F, (char)0x8B, 8};
    char *bytes = take(sizeof before + f->size + 8),
         *at = bytes + sizeof before + f->size;
    memcpy(bytes, before, sizeof before);
    memcpy(bytes + sizeof before, f->bytes, f->size);
    for (unsigned i = 0; i < 4; i++) {
        at[i] = (char)(unsigned char)(f->checksum >> 8 * i & 0xFF);
        at[4 + i] = (char)(unsigned char)(f->whole >> 8 * i & 0xFF);
    }
    return unpack(g, scratch, bytes, sizeof before + f->size + 8, most, unpacked_size,
                  trouble);
}
