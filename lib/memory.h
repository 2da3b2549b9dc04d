/* memory.h - allocation of arrays, with sizes that are checked.
 *
 * Needs: nothing.
 *
 * In the counted build (build/counted/) a test can make the k-th allocation
 * fail, for every k, to see that nothing leaks and the output is empty.
 */
#ifndef LIB_MEMORY_H
#define LIB_MEMORY_H

#include <stddef.h>

/* An uninitialised array of `count` items of `size` bytes.
 * NULL when count * size overflows or memory is out; never NULL for count 0. */
void *memory_array(size_t count, size_t size);

/* The same array with room for `count` items; on NULL the old one still stands. */
void *memory_resize(void *array, size_t count, size_t size);

/* Frees an array of the two functions above, or nothing when it is NULL. */
void memory_free(void *array);

#ifdef TRI_COUNTED
/* The k-th allocation from now on fails (1 is the next; 0 switches this off). */
void memory_fail_at(unsigned long k);
#endif

#endif
