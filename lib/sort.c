/* sort.c - radix sort, the least significant byte first. */
#include "lib/sort.h"

#include <stdbool.h>
#include <string.h>

/* Sorts by one byte of the key; false when that byte is the same in all keys, and
 * then nothing is moved. */
static bool
sort_by_byte(const sort_item *from, sort_item *to, size_t n, int shift)
{
    size_t place[257] = {0}; /* byte -> where its first item goes, after the sum */
    for (size_t i = 0; i < n; i++)
        place[(from[i].key >> shift & 255) + 1]++;
    if (place[(from[0].key >> shift & 255) + 1] == n)
        return false;
    for (int byte = 0; byte < 256; byte++)
        place[byte + 1] += place[byte];
    for (size_t i = 0; i < n; i++)
        to[place[from[i].key >> shift & 255]++] = from[i];
    return true;
}

void
sort_by_key(sort_item *item, sort_item *scratch, size_t n)
{
    sort_item *from = item, *to = scratch;
    for (int shift = 0; shift < 64 && n > 0; shift += 8) {
        if (sort_by_byte(from, to, n, shift)) {
            sort_item *sorted = to;
            to = from;
            from = sorted;
        }
    }
    if (from != item)
        memcpy(item, from, n * sizeof *item);
}

uint64_t
sort_key_of(double x)
{
    const uint64_t sign = (uint64_t)1 << 63;
    double positive_zero = x + 0.0; /* -0 becomes +0 */
    uint64_t bits;
    memcpy(&bits, &positive_zero, sizeof bits);
    /* Positive doubles are ordered like their bits, negative ones the other way. */
    return bits & sign ? ~bits : bits | sign;
}
